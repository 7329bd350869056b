"""What a run costs: how far copies and forces are from those of one copy that all hold without any delay."""

from collections.abc import Mapping

import numpy as np

from cotouch.laboratory._ideal import Ideal, forces, places
from cotouch.laboratory._quality import etvo, hpw_psnr, psnr
from cotouch.laboratory._replicas._kinds import REPLICAS
from cotouch.laboratory._replicas._replica import Moved, replicate
from cotouch.laboratory._study import HandKind, LawTable, NetworkTable, Study
from cotouch.laboratory._tasks import Task
from cotouch.laboratory._trials import energy_of
from cotouch.laws import law_named
from cotouch.simulation import TICK_STORED, Prepared, prepare, run_prepared, with_hands

# Errors of place count in units of this [m].
PLACE = 0.01
# How long a push is watched to die away [s], how hard it is [m/s], and from which mean speed on it matters [m/s].
_WATCH, _PUSH, _MOVES = 6.0, 0.1, 2e-3
# It must have lost this share of its speed from the second quarter to the last.
_CALMS = 0.9

# Of each run: name, unit, meaning.
MEASURES = {
    "cost": ("1", "position error in units of 10 mm, plus force error as a fraction of the ideal force"),
    "place": ("m", "distance of a copy from the ideal, root mean square"),
    "force": ("1", "difference of the hands' forces from the ideal ones, as a fraction of those"),
    "apart": ("m", "distance of a copy from the mean of all, root mean square"),
    "restless": ("m/s", "speed of a copy against the ideal in the last fifth of the run, root mean square"),
    "rough": ("N", "largest jump of a hand's force from one step to the next"),
    "made": ("J", "most energy that the links had made beyond what the law declares"),
    "extracted": ("J", "most energy that users got out beyond what there was"),
    "corrected": ("J", "energy of the states that a replica overwrote"),
    "psnr": ("dB", "PSNR of the hands' forces against the ideal ones"),
    "hpw_psnr": ("dB", "HPW-PSNR of them, in which errors that nobody notices do not count"),
    "late": ("s", "ETVO: how late the mean of all copies is, compared with the ideal one"),
    "off": ("m", "ETVO: how far off it is apart from that, root mean square"),
    "packets": ("1/s", "samples that a user sends in full to a neighbour"),
    "bandwidth": ("B/s", "bytes that a user sends to a neighbour, without headers"),
}
# Of a run that left floating point they say nothing; of any other measure that is infinitely bad.
_UNKNOWN = ("psnr", "hpw_psnr", "late", "off", "packets", "bandwidth")


def moved(law: LawTable, prepared: Prepared) -> Moved:
    """What a law, or the replicas that are none, does in a run.

    Args:
        law: of a study.
        prepared: the run, with its hands.
    """
    if law.replica is not None:
        return replicate(REPLICAS[law.replica], prepared)
    outcome = run_prepared(prepared)
    steps, finite = int(outcome.taken.min()), outcome.events == prepared.schedule.order.size
    energy = energy_of(prepared, outcome)
    return Moved(
        place=places(outcome),
        velocity=outcome.record.velocity[:, : steps + 1],
        force=forces(prepared, outcome),
        made=energy.beyond if energy.beyond > 1e-9 * energy.play else 0.0,
        extracted=max(0.0, -float(outcome.record.lowest[0] + outcome.record.ticks[TICK_STORED, 0])),
        corrected=0.0,
        finite=bool(finite and np.isfinite(outcome.position).all()),
        said=None
        if outcome.traffic is None
        else (float(outcome.traffic.contents.mean()), float(outcome.traffic.size.mean())),
    )


def measures_of(law: LawTable, prepared: Prepared, wanted: Ideal) -> dict[str, float]:
    """The measures of a run; infinite where the motion left floating point.

    Args:
        law: of a study.
        prepared: with the hands of the ideal.
        wanted: the ideal.
    """
    run = moved(law, prepared)
    if not run.finite:
        return {name: float("nan") if name in _UNKNOWN else float("inf") for name in MEASURES}
    place, force = run.place, run.force
    steps = min(place.shape[1], wanted.place.shape[0])
    off_place = place[:, :steps] - wanted.place[:steps]
    error = np.sqrt((off_place**2).sum(axis=-1).mean())
    restless = np.sqrt((np.diff(off_place[:, -1 - steps // 5 :], axis=1) ** 2).sum(axis=-1).mean())
    gap = np.sqrt(((place - place.mean(axis=0)) ** 2).sum(axis=-1).mean()) if len(place) > 1 else 0.0
    felt, ideal_felt = force[:, : steps - 1], wanted.force[:, : steps - 1]
    wrong = np.sqrt(((felt - ideal_felt) ** 2).mean()) / wanted.size
    mean, span = place[:, :steps].mean(axis=0), prepared.scenario.steps.duration
    late, off = etvo(wanted.place[:steps].reshape(steps, -1), mean.reshape(steps, -1), span / (steps - 1))
    samples, size = _said(law, prepared) if run.said is None else run.said
    return {
        "cost": float(error / PLACE + wrong),
        "place": float(error),
        "force": float(wrong),
        "apart": float(gap),
        "restless": float(restless) * (steps - 1) / span,
        "rough": float(np.abs(np.diff(force, axis=1)).max(initial=0.0)),
        "made": run.made,
        "extracted": run.extracted,
        "corrected": run.corrected,
        "psnr": psnr(ideal_felt, felt),
        "hpw_psnr": hpw_psnr(ideal_felt, felt),
        "late": late,
        "off": off,
        "packets": samples / span,
        "bandwidth": size / span,
    }


def _said(law: LawTable, prepared: Prepared) -> tuple[float, float]:
    """Samples and bytes that a user says to a neighbour where all are said in full."""
    samples = float(prepared.schedule.count.mean())
    return samples, samples * message_size(law, prepared.body.nodes * prepared.body.dimension)


def message_size(law: LawTable, field: int) -> int:
    """Bytes of a sample and its message.

    Args:
        law: of a study.
        field: numbers in a field.
    """
    if law.replica is not None:
        return 8 * field * REPLICAS[law.replica].numbers
    kind = law_named(law.kind)
    return 8 * (field * (1 + len(kind.sends)) + len(kind.sends_scalars))


def dangerous(
    study: Study,
    law: LawTable,
    network: NetworkTable,
    users: int,
    hand: HandKind,
    setting: Mapping[str, float],
    *,
    let_go: bool = False,
) -> bool:
    """Whether a push doesn't die away, with all hands holding or with one.

    Args:
        study: of the run.
        law: of its links.
        network: that it meets.
        users: how many.
        hand: what hands are like.
        setting: of the law.
        let_go: nobody holds, and it is the motion of copies against each other that must die away.
    """
    still: Task = [{"user": i + 1, "stiffness": hand.stiffness, "damping": hand.damping} for i in range(users)]
    body = study.build_body()
    velocity = np.zeros((users, body.nodes, body.dimension))
    velocity[0, :, 0] = _PUSH
    scenario = study.scenario(
        law,
        network,
        users,
        [],
        seed=study.channel_seed(network, -1),
        setting=setting,
        duration=_WATCH,
        initial={"velocity": velocity.tolist()},
    )
    pushed = prepare(scenario)
    for holding in [[]] if let_go else [still, still[:1]]:
        prepared = with_hands(pushed, study.placed(holding, users))
        run = moved(law, prepared)
        if not run.finite:
            return True
        steps = int(prepared.schedule.count.min())
        moving = run.velocity
        if let_go:
            moving = moving - moving.mean(axis=0)
        speed = np.sqrt((moving**2).sum(axis=-1).mean(axis=2))
        second, last = (np.sqrt((speed[:, q * steps // 4 : (q + 1) * steps // 4] ** 2).mean()) for q in (1, 3))
        if not np.isfinite(last) or (last > _MOVES and last > _CALMS * second):
            return True
    return False


def promises(law: LawTable) -> bool:
    """Whether a law of a study promises to make no energy beyond its initial one."""
    return law.replica is None and law_named(law.kind).passive and law.damping is None


def said_of(law: LawTable) -> tuple[tuple[str, ...], str]:
    """What a law sends for one neighbour and step, and where it comes from.

    Args:
        law: of a study.
    """
    if law.replica is not None and law.law is None:
        return REPLICAS[law.replica].sends, REPLICAS[law.replica].source
    kind = law_named(law.kind)
    return ("x̂", *kind.sends, *kind.sends_scalars), kind.source
