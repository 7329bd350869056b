"""What is best: all hands on one copy, without any delay."""

import json
from collections import OrderedDict
from dataclasses import dataclass
from hashlib import sha256
from threading import Lock
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.laboratory._study import Study
from cotouch.laboratory._tasks import Hands
from cotouch.network import Network
from cotouch.scenario import Scenario
from cotouch.simulation import Outcome, Prepared, hand_forces, prepare, run_batch

# Ideals that are kept, because every law is compared with the same ones [bytes].
_ROOM = 256 * 2**20


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Ideal:
    """All hands on one copy, without delay.

    Attributes:
        place: of the nodes, (steps + 1, n, d) [m].
        force: of each hand, (hands, steps, d) [N].
        size: of the forces, root mean square over hands and time [N].
    """

    place: Float
    force: Float
    size: float


_known: OrderedDict[str, Ideal] = OrderedDict()
_lock = Lock()


def ideal(study: Study, hands: Hands) -> Ideal:
    """What one copy without delay does; not for writing, because the same hands get the same arrays.

    Args:
        study: of the run.
        hands: of the task.
    """
    body = study.build_body()
    key = json.dumps([digest(body), study.period, study.duration, hands])
    with _lock:
        if key in _known:
            _known.move_to_end(key)
            return _known[key]
    found = _run(study, body, hands)
    with _lock:
        _known[key] = found
        while sum(kept.place.nbytes + kept.force.nbytes for kept in _known.values()) > _ROOM:
            _known.popitem(last=False)
    return found


def _run(study: Study, body: Body, hands: Hands) -> Ideal:
    alone = Scenario.make(
        network=Network(users=["all"], spring=[[0.0]], delay=[[0.0]]),
        body=body,
        steps={"duration": study.duration, "period": study.period},
        synchronisation={"law": "spring"},  # of no link
        hands=[hand | {"user": 1} for hand in hands],
    )
    prepared = prepare(alone)
    outcome = run_batch(prepared)
    force = forces(prepared, outcome)
    return Ideal(place=places(outcome)[0].copy(), force=force, size=max(float(np.sqrt((force**2).mean())), 1e-9))


def digest(body: Body) -> str:
    """Tells a body from another one: of its mass, damping and stiffness."""
    found = sha256()
    for matrix in (body.mass, body.damping, body.stiffness):
        for part in (matrix.data, matrix.indices, matrix.indptr):
            found.update(np.ascontiguousarray(part).tobytes())
    return found.hexdigest()


def places(outcome: Outcome) -> Float:
    """Of all users at common steps, (users, steps + 1, n, width) [m]."""
    steps = int(outcome.taken.min())
    return outcome.record.position[:, : steps + 1]


def forces(prepared: Prepared, outcome: Outcome) -> Float:
    """Of each hand, (hands, steps, axes) [N].

    Args:
        prepared: what was run.
        outcome: with all steps recorded; steps that not every user took are left out.
    """
    steps = int(outcome.taken.min())
    force = outcome.record.force
    return hand_forces(prepared, force, force.shape[2])[:, 1 : steps + 1].copy()
