"""One scenario with options varied: every combination is run and judged."""

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, TypedDict

import numpy as np

from cotouch.errors import CotouchError, ScenarioError
from cotouch.interrupt import interruptible
from cotouch.laboratory._cells import Progress, Store, cells, contents_of, source_of
from cotouch.laboratory._ideal import digest
from cotouch.laws import law_named
from cotouch.scenario import Scenario
from cotouch.simulation import discrepancy, judge, simulate

if TYPE_CHECKING:
    import xarray as xr

# Of each run: name, unit, meaning.
SWEPT = {
    "made": ("J", "most energy that the links had made"),
    "law_initial_energy": ("J", "most energy that the law says they may make"),
    "extracted": ("J", "most energy that users got out beyond what there was"),
    "rms": ("m", "distance of a user's copy from the mean of all, root mean square"),
    "largest": ("m", "likewise, at most"),
    "force": ("N", "root mean square of the users' forces"),
    "damping": ("N s/m", "largest local damping of a user, for the identity weight"),
    "finished": ("1", "1 if the motion stayed within floating point"),
}
_MOST_RUNS = 100_000
# Tables whose options name a law or files.
_NAMING = {"synchronisation", "body", "channel"}


class _Cell(TypedDict):
    """A run, and all that its figures follow from: digests of the body, its law's code and the files that it reads."""

    scenario: str
    body: str
    options: dict[str, object]
    code: str
    files: list[str]


class _Ran(TypedDict):
    figures: dict[str, float]
    problem: str


def values_of(text: str) -> list[float | str]:
    """Reads `a:b:n` (n numbers from a to b), `a:b:n:log`, or a list with commas; what is no number stays text.

    Raises:
        ScenarioError: it is neither.
    """
    parts = text.split(":")
    if len(parts) == 1:
        return [_number(part.strip()) for part in text.split(",")]
    log = len(parts) == 4 and parts[3] == "log"
    try:
        low, high, count = float(parts[0]), float(parts[1]), int(parts[2])
    except (ValueError, IndexError):
        low, high, count = np.nan, np.nan, 0
    fits = np.isfinite([low, high]).all() and 1 <= count <= _MOST_RUNS and (not log or min(low, high) > 0.0)
    if not fits or len(parts) > 3 + log:
        raise ScenarioError(
            f'"{text}" is not a range; write low:high:count, low:high:count:log with both above 0, or values with '
            f"commas"
        )
    return (np.geomspace if log else np.linspace)(low, high, count).tolist()


def _number(text: str) -> float | str:
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return text


def varied(scenario: Scenario, option: str, value: object) -> Scenario:
    """The scenario with one option at another value.

    Args:
        scenario: to start from.
        option: `link.delay` or `link.spring` of all links, `hands.OPTION` of all hands, `TABLE.OPTION`, or `seed`.
        value: of it.

    Raises:
        ScenarioError: there is no such option, or it cannot have the value.
        NetworkError: likewise, of links.
    """
    table, _, name = option.partition(".")
    if option == "seed":
        return scenario.replace(seed=value)
    if table == "link" and name in {"delay", "spring"}:
        network = scenario.network
        if network.weights:
            raise ScenarioError(f"{option} cannot be varied where links have weights")
        if not isinstance(value, int | float):
            raise ScenarioError(f'{option} is "{value}"; it must be a number')
        values = network.spring.copy() if name == "spring" else network.delay.copy()
        for a, b in network.links:
            values[[a, b], [b, a]] = value
        changed = network.replace(spring=values) if name == "spring" else network.replace(delay=values)
        return scenario.replace(network=changed)
    if table == "hands" and name:
        return scenario.replace(hands=[{**hand.model_dump(exclude_unset=True), name: value} for hand in scenario.hands])
    if not name or table not in Scenario.model_fields or table in {"network", "tools"}:
        raise ScenarioError(
            f'"{option}" cannot be varied; it must be seed, link.delay, link.spring, hands.OPTION, or an option of '
            "body, steps, synchronisation, channel, initial or solver, as synchronisation.law"
        )
    return scenario.replace(**{f"{table}__{name}": value})


@interruptible
def sweep(
    scenario: Scenario,
    vary: Mapping[str, Sequence[object]],
    *,
    store: Path | None = None,
    jobs: int = -1,
    dask: str | None = None,
    progress: Progress | None = None,
) -> "xr.Dataset":
    """Runs a scenario at every combination of options.

    Args:
        scenario: what stays the same.
        vary: for each option, as `varied` names them, its values.
        store: folder of results, one file for each run; those that are there are not computed again.
        jobs: how many runs are done at once; -1: one per core.
        dask: address of a Dask scheduler whose workers compute instead.
        progress: told after each run.

    Returns:
        A dimension for each option, and for each of `SWEPT` a variable; NaN, and the reason in `problem`, where a
        scenario cannot be. Where nothing of the synchronisation is varied, all have the law of `scenario`.

    Raises:
        ScenarioError: nothing is varied, there are more than 100,000 runs, or none of them can be.
        OutputError: results cannot be kept.
    """
    import xarray as xr

    count = int(np.prod([len(values) for values in vary.values()], dtype=float)) if vary else 0
    if not 1 <= count <= _MOST_RUNS:
        raise ScenarioError(f"there are {count} combinations to run; there must be 1 to {_MOST_RUNS}")
    if not any(option.startswith("synchronisation.") for option in vary):
        scenario = scenario.replace(synchronisation__law=scenario.synchronisation.law or scenario.law[0])
    whole, body = scenario.as_json(), digest(scenario.build_body())
    items: list[_Cell] = []
    for values in product(*vary.values()):
        options = dict(zip(vary, values, strict=True))
        code, files = _made_of(scenario, options)
        items.append({"scenario": whole, "body": body, "options": options, "code": code, "files": files})
    kept = None if store is None else Store(store, source_of(_run))
    done = cells("run", partial(_run, scenario), items, jobs=jobs, dask=dask, store=kept, progress=progress)
    results = [(found["figures"], found["problem"]) for found in done]
    if all(problem for _, problem in results):
        raise ScenarioError(results[0][1])
    shape, dims = tuple(len(values) for values in vary.values()), tuple(vary)
    data: dict[str, object] = {
        name: (
            dims,
            np.reshape([figures.get(name, np.nan) for figures, _ in results], shape),
            {"units": unit, "long_name": meaning},
        )
        for name, (unit, meaning) in SWEPT.items()
    }
    data["problem"] = (dims, np.reshape(np.array([problem for _, problem in results], dtype=np.str_), shape))
    coordinates = {
        name: np.array(values if all(isinstance(v, int | float) for v in values) else [str(v) for v in values])
        for name, values in vary.items()
    }
    return xr.Dataset(data, coords=coordinates, attrs={"scenario": whole})


def _made_of(scenario: Scenario, options: Mapping[str, object]) -> tuple[str, list[str]]:
    """The file of a run's law, and what those that it reads hold; nothing where the run cannot be."""
    try:
        for option, value in options.items():
            if option.partition(".")[0] in _NAMING:
                scenario = varied(scenario, option, value)
        law = law_named(scenario.law[0])
    except CotouchError:
        return "", []
    return source_of(law.before), contents_of(scenario.files())


def _run(scenario: Scenario, cell: _Cell) -> _Ran:
    """The figures of one run, or the problem for which there are none."""
    try:
        for option, value in cell["options"].items():
            scenario = varied(scenario, option, value)
        run = simulate(scenario)
    except CotouchError as error:
        return {"figures": {}, "problem": str(error)}
    apart, judged = discrepancy(run), judge(run)
    force = np.asarray(run["force"].values, dtype=np.float64)
    figures = {
        "made": judged["made_j"],
        "law_initial_energy": judged["initial_energy_j"],
        "extracted": judged["extracted_j"],
        "rms": apart["rms"],
        "largest": apart["max"],
        "force": float(np.sqrt(np.nanmean((force**2).sum(axis=-1)))),  # pyright: ignore[reportUnknownArgumentType]
        "damping": float(run["local_damping"].values[:, 0].max()),
        "finished": float(run.attrs["finished"]),
    }
    return {"figures": {name: float(value) for name, value in figures.items()}, "problem": ""}
