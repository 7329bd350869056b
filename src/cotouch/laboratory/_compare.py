"""Link laws compared: tuned alike, run on the same networks and tasks, judged by the same measures."""

import json
from collections.abc import Mapping
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np

from cotouch.errors import CotouchError, ScenarioError
from cotouch.interrupt import check, interruptible
from cotouch.laboratory._cell_tables import MapCell, Mapped, ScoreCell, Scored, TuneCell, TunedSettings
from cotouch.laboratory._cells import Progress, Store, cells, contents_of, source_of
from cotouch.laboratory._ideal import ideal
from cotouch.laboratory._impedance import impedance
from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.laboratory._score import MEASURES, dangerous, measures_of, message_size, promises, said_of
from cotouch.laboratory._study import HandKind, LawTable, NetworkTable, Study
from cotouch.laboratory._tasks import Task
from cotouch.laboratory._tune import tune
from cotouch.laws import law_named
from cotouch.simulation import Prepared, prepare, run_batch, with_hands

if TYPE_CHECKING:
    import xarray as xr

# A stiffer hand is asked in so many draws; felt impedance at these tones [Hz]; a law's time in so many runs [s].
_STIFF_DRAWS, _TONES, _REPEATS, _TIMED = 5, (0.3, 0.6, 1.2), 7, 10.0
FELT = {
    "drag": ("N s/m", "drag felt by a hand that moves the object freely"),
    "mass": ("kg", "mass that it feels"),
    "stiffness": ("N/m", "stiffness felt by it while the others hold"),
}
_MOST_CELLS = 100_000


class _Named(TypedDict):
    """How cells are computed, as `cells` takes it."""

    jobs: int
    dask: str | None
    store: Store | None
    progress: Progress | None


@interruptible
def compare(
    study: Study,
    *,
    store: Path | None = None,
    jobs: int = -1,
    dask: str | None = None,
    progress: Progress | None = None,
) -> "xr.Dataset":
    """Tunes the laws of a study, runs them, and gathers what came of it.

    Args:
        study: what is compared.
        store: folder of results, one file for each cell; those that are there are not computed again.
        jobs: how many cells at once; -1: one per core.
        dask: address of a Dask scheduler whose workers compute instead.
        progress: told after each cell.

    Returns:
        The measures over law, tuning, network, users, hand, task and draw; settings, what is felt, danger and costs
        over fewer. NaN where nothing was asked, infinite where the motion left floating point.

    Raises:
        ScenarioError: there are more than 100,000 cells, or nothing of the study can be run.
        OutputError: results cannot be kept.
    """
    from cotouch.version import __version__

    kept = None if store is None else Store(store, source_of(score))
    named: _Named = {"jobs": jobs, "dask": dask, "store": kept, "progress": progress}
    tunings = study.settings
    count = len(study.laws) * len(study.networks) * len(study.users) * len(tunings)
    if count > _MOST_CELLS:
        raise ScenarioError(f"the study has {count} cells; at most {_MOST_CELLS} fit")
    held = {network.name: contents_of(study.files([network])) for network in study.networks}
    found = _tuned(study, held, named)
    jobs_of: dict[str, ScoreCell] = {}
    asked: dict[tuple[str, str, str, int], str] = {}
    for law in study.laws:
        for network in study.networks:
            settings = found[law.label, network.tuned_on or network.name]["settings"]
            for tuning in tunings:
                if (setting := settings.get(tuning)) is None:
                    continue
                for users in study.users:
                    cell: ScoreCell = {
                        "study": _part(study, law, network, users),
                        "setting": setting,
                        "code": _code(law),
                        "files": held[network.name],
                    }
                    key = json.dumps(cell, sort_keys=True)
                    jobs_of[key] = cell
                    asked[law.label, tuning, network.name, users] = key
    scored = dict(zip(jobs_of, cells("score", score, list(jobs_of.values()), **named), strict=True))
    problems = sorted({result["problem"] for result in [*scored.values(), *found.values()]} - {""})
    if not any(result["runs"] for result in scored.values()):
        raise ScenarioError(problems[0] if problems else "the study has no run that is stable")
    maps = _mapped(study, found, named)
    results = {place: scored[key] for place, key in asked.items()}
    return _gathered(study, tunings, results, found, maps).assign_attrs(
        problems=json.dumps(problems), study=study.model_dump_json(), version=__version__
    )


def _tuned(study: Study, held: Mapping[str, list[str]], named: _Named) -> dict[tuple[str, str], TunedSettings]:
    """What tuning found for each law, on each network that somebody is tuned on, whose files hold `held`."""
    places = list(dict.fromkeys(network.tuned_on or network.name for network in study.networks))
    pairs = [(law, study.network(place)) for law in study.laws for place in places]
    if not study.tunes:
        nothing: TunedSettings = {"settings": {"published": {}}, "cost": {}, "tried": 0, "problem": ""}
        return {(law.label, network.name): nothing for law, network in pairs}
    items: list[TuneCell] = [
        {
            "study": _part(study, law, network, study.tuning.users, tuning=True),
            "code": _code(law),
            "files": held[network.name],
        }
        for law, network in pairs
    ]
    results = cells("tune", tune, items, **named)
    return {(law.label, network.name): result for (law, network), result in zip(pairs, results, strict=True)}


def _mapped(study: Study, found: Mapping[tuple[str, str], TunedSettings], named: _Named) -> dict[str, list[Mapped]]:
    """Danger and cost over delay and stiffness, a cell for each law and stiffness, with the first network's setting."""
    if study.map is None:
        return {}
    first = study.networks[0].tuned_on or study.networks[0].name
    items: list[MapCell] = []
    held = contents_of(study.files([]))
    for law in study.laws:
        settings = found[law.label, first]["settings"]
        setting = settings.get("tuned") or settings.get("published") or {}
        for stiffness in study.map.stiffness:
            part = _part(study, law, NetworkTable(name="map", delay=0.0), 2)
            part["hands"] = [{**part["hands"][0], "stiffness": stiffness}]
            delay = list(study.map.delay)
            items.append({"study": part, "setting": setting, "delay": delay, "code": _code(law), "files": held})
    results = cells("map", danger, items, **named)
    rows = len(study.map.stiffness)
    return {law.label: results[k * rows : (k + 1) * rows] for k, law in enumerate(study.laws)}


def _part(study: Study, law: LawTable, network: NetworkTable, users: int, *, tuning: bool = False) -> dict[str, Any]:
    """All of a study that a cell follows from, and nothing else, so that a change elsewhere costs nothing."""
    whole = study.model_dump(mode="json", exclude={"title", "ours", "map"})
    whole |= {
        "laws": [law.model_dump(mode="json", exclude=None if law.replica else {"replica"})],
        "networks": [network.model_dump(mode="json", exclude={"tuned_on"})],
        "users": [users],
    }
    if tuning:
        whole["draws"] = 2
    else:
        whole["tuning"] = {"search": 0, "local": 0}
    return whole


def _code(law: LawTable) -> str:
    """Of a law's file."""
    own = source_of(law_named(law.kind).before)
    return own if law.replica is None else own + source_of(REPLICAS[law.replica].move)


def score(cell: ScoreCell) -> Scored:
    """Every task, hand and draw of one law with one setting, one network and one number of users.

    Args:
        cell: `study`, and the `setting`.

    Returns:
        `runs`, of each measure [hand][task][draw]; `felt`; `dangerous`, for each hand; `loose`, whether
        copies that nobody holds drive each other apart; `problem`, why there is nothing.
    """
    study, setting = Study.make(**cell["study"]), cell["setting"]
    law, network, users = study.laws[0], study.networks[0], study.users[0]
    hands = _hands(study)
    counts = [study.draws if kind < len(study.hands) else min(study.draws, _STIFF_DRAWS) for kind in range(len(hands))]
    runs: dict[str, list[list[list[float]]]] = {name: [[[] for _ in study.tasks] for _ in hands] for name in MEASURES}
    try:
        for draw in range(max(counts)):
            prepared = drawn(study, draw, setting)
            for kind, hand in enumerate(hands):
                for number, task in enumerate(study.tasks if draw < counts[kind] else []):
                    one = _one(study, prepared, hand, task, draw)
                    for name, values in runs.items():
                        values[kind][number].append(one[name])
        risky = [dangerous(study, law, network, users, hand, setting) for hand in hands]
        loose = dangerous(study, law, network, users, hands[0], setting, let_go=True)
        felt = _felt(study, setting, loose=loose) if study.felt and law.replica is None else {}
    except CotouchError as error:
        return {
            "runs": {},
            "felt": {},
            "dangerous": [],
            "loose": False,
            "problem": f"{law.label}, {network.name}: {error}",
        }
    return {"runs": runs, "felt": felt, "dangerous": risky, "loose": loose, "problem": ""}


def drawn(study: Study, draw: int, setting: Mapping[str, float]) -> Prepared:
    """All that the runs of a draw have in common, whatever hands do.

    Args:
        study: whose first law, network and number of users are taken.
        draw: number of the draw, from 0.
        setting: of the parameters that the study sweeps, by name.
    """
    law, network, users = study.laws[0], study.networks[0], study.users[0]
    return prepare(study.scenario(law, network, users, [], seed=study.channel_seed(network, draw), setting=setting))


def _one(study: Study, prepared: Prepared, hand: HandKind, task: str, draw: int) -> dict[str, float]:
    check()
    hands = study.task(task, study.users[0], hand, draw)
    return measures_of(study.laws[0], with_hands(prepared, hands), ideal(study, hands))


def _hands(study: Study) -> list[HandKind]:
    """The study's, and the first made stiffer."""
    first = study.hands[0]
    return [*study.hands, HandKind(stiffness=study.stiffer * first.stiffness, damping=first.damping)]


def _felt(study: Study, setting: Mapping[str, float], *, loose: bool) -> dict[str, float]:
    law, network, users, hand = study.laws[0], study.networks[0], study.users[0], study.hands[0]
    holding: Task = [{"user": i + 1, "stiffness": hand.stiffness, "damping": hand.damping} for i in range(users)]
    seed = study.channel_seed(network, 0)
    scenario = study.scenario(law, network, users, study.placed(holding, users), seed=seed, setting=setting)
    held = impedance(scenario, 1, others="holding", frequencies=_TONES, jobs=1)
    free = None if loose else impedance(scenario, 1, frequencies=_TONES, jobs=1)
    return {
        "drag": float("nan") if free is None else float(free.attrs["measured_drag"]),
        "mass": float("nan") if free is None else float(free.attrs["measured_mass"]),
        "stiffness": float(held.attrs["measured_stiffness"]),
    }


def danger(cell: MapCell) -> Mapped:
    """Whether a law is dangerous at each delay with one kind of hand, its cost there, and what moves on at rest.

    Args:
        cell: `study`, `setting`, and the delays.
    """
    study, setting = Study.make(**cell["study"]), cell["setting"]
    found: list[tuple[bool, float, float]] = []
    for delay in cell["delay"]:
        network = NetworkTable(name="map", delay=delay)
        here = study.model_copy(update={"networks": [network]})
        try:
            risky = dangerous(here, here.laws[0], network, 2, here.hands[0], setting)
            prepared = drawn(here, 0, setting)
            cost = float(np.mean([_one(here, prepared, here.hands[0], task, 0)["cost"] for task in here.tasks]))
            found.append((risky, cost, _one(here, prepared, here.hands[0], "hold", 0)["restless"]))
        except CotouchError:
            found.append((True, float("inf"), float("inf")))
    return {
        "dangerous": [risky for risky, _, _ in found],
        "cost": [cost for _, cost, _ in found],
        "restless": [restless for _, _, restless in found],
    }


def law_time(study: Study, law: LawTable) -> float:
    """What a law takes at one end of a link and in one step, beyond what springs take [s]; NaN of replicas.

    Args:
        study: whose body it moves.
        law: of the study.
    """
    if law.replica is not None:
        return float("nan")
    network = NetworkTable(name="timed", delay=0.025)
    steps = 2 * _TIMED / study.period
    best: list[float] = []
    for entry in (law, LawTable(law="spring")):
        prepared = prepare(study.scenario(entry, network, 2, [], duration=_TIMED))
        taken = np.inf
        for _ in range(_REPEATS):
            check()
            begun = perf_counter()
            run_batch(prepared)
            taken = min(taken, perf_counter() - begun)
        best.append(taken)
    return (best[0] - best[1]) / steps


def _gathered(
    study: Study,
    tunings: list[str],
    results: Mapping[tuple[str, str, str, int], Scored],
    found: Mapping[tuple[str, str], TunedSettings],
    maps: Mapping[str, list[Mapped]],
) -> "xr.Dataset":
    import xarray as xr

    laws, nets = [law.label for law in study.laws], [network.name for network in study.networks]
    kinds = [hand.label for hand in study.hands] + [f"{_hands(study)[-1].label}, stiffer"]
    whole = (len(laws), len(tunings), len(nets), len(study.users))
    shape = (*whole, len(kinds), len(study.tasks), study.draws)
    values = {name: np.full(shape, np.nan) for name in MEASURES}
    felt = {name: np.full(whole, np.nan) for name in FELT}
    risky, untied = np.full((*whole, len(kinds)), np.nan), np.full(whole, np.nan)
    for (law, tuning, net, users), result in results.items():
        at = (laws.index(law), tunings.index(tuning), nets.index(net), study.users.index(users))
        for name, rows in result["runs"].items():
            for h, hand in enumerate(rows):
                for t, draws in enumerate(hand):
                    values[name][(*at, h, t, slice(len(draws)))] = draws
        for name, value in result["felt"].items():
            felt[name][at] = value
        untied[at] = result["loose"]
        risky[(*at, slice(len(result["dangerous"])))] = result["dangerous"]
    axes = ("law", "tuning", "network", "users")
    data: dict[str, object] = {
        name: ((*axes, "hand", "task", "draw"), values[name], {"units": unit, "long_name": meaning})
        for name, (unit, meaning) in MEASURES.items()
    }
    for name, (unit, meaning) in FELT.items():
        data[f"felt_{name}"] = (axes, felt[name], {"units": unit, "long_name": meaning})
    settings = [
        [
            [json.dumps(found[law, n.tuned_on or n.name]["settings"].get(tuning)) for n in study.networks]
            for tuning in tunings
        ]
        for law in laws
    ]
    said, body = [said_of(law) for law in study.laws], study.build_body()
    size = [message_size(law, body.nodes * body.dimension) for law in study.laws]
    data |= {
        "dangerous": ((*axes, "hand"), risky, {"long_name": "1 if a push does not die away"}),
        "loose": (axes, untied, {"long_name": "1 if copies that nobody holds drive each other apart"}),
        "setting": (axes[:3], np.array(settings, dtype=np.str_)),
        "bytes": ("law", np.array(size, dtype=np.float64), {"units": "B"}),
        "promises": ("law", np.array([float(promises(law)) for law in study.laws])),
        "sends": ("law", np.array([", ".join(sends) for sends, _ in said], dtype=np.str_)),
        "source": ("law", np.array([source for _, source in said], dtype=np.str_)),
        "time": (
            "law",
            np.array([law_time(study, law) for law in study.laws]),
            {"units": "s", "long_name": "of an end and step, beyond a spring's"},
        ),
    }
    coordinates: dict[str, object] = {
        "law": laws,
        "tuning": tunings,
        "network": nets,
        "users": study.users,
        "hand": kinds,
        "task": list(study.tasks),
        "draw": np.arange(study.draws),
    }
    if study.map is not None:
        for name in ("dangerous", "cost", "restless"):
            table = np.array([[row[name] for row in maps[law]] for law in laws], dtype=np.float64)
            data[f"map_{name}"] = (("law", "stiffness", "delay"), table)
        coordinates |= {"stiffness": study.map.stiffness, "delay": study.map.delay}
    return xr.Dataset(data, coords=coordinates)
