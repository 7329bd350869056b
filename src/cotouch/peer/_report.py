"""What one step of a peer did."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, final

from cotouch.arrays import Float
from cotouch.mechanics import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    CUT,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SHORTENED,
    SUPPLIED,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    WORLD_FORCE,
    WORLD_LOSS,
    WORLD_STORED,
)
from cotouch.peer._guard_ledger import GuardLedger
from cotouch.peer._links import Sample


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class StepReport:
    """What one step did.

    Attributes:
        sample: what the neighbours should be told.
        force: mean force of the step at every port, (ports, width) [N].
        supplied: work done at the ports [J].
        body_loss: dissipated by the body's own dampers, and at planes and boxes [J].
        local_loss: by the damping B_i of the synchronisation [J].
        extra_loss: by the extra damping B_e [J].
        link_work: work that each link did on the copy, in the order of `Peer.neighbours` [J].
        kinetic: energy after the step [J].
        elastic: energy after the step, of strain, weight and planes and boxes [J].
        drive_work: work done on the proxies by what pulls them [J].
        touch_work: work done on the body by contacts and grasps [J].
        touch_loss: dissipated in contacts and grasps [J].
        proxy: kinetic energy of the proxies after the step [J].
        touch_stored: energy in contacts and grasps after the step [J].
        speed: ‖v̂‖² in the identity weight [m²/s²].
        residual: what the ledger of this step does not explain [J]; round-off, or something is broken.
        age: of each link's sample at the end of the step, by the clocks as they are [s].
        iterations: of the solver.
        closure: work on the velocity that closed the step's balance, in no other column; 0 of a linear body [J].
        closure_factor: |β - 1|, by how much that changed the velocity; above CLOSURE_ALARM forces and energy disagree.
        closing: of several bodies, of each the factor β on its velocity, and the velocity about which that acted,
            (bodies, 4) [1, m/s]; None of one.
        jammed: about which velocity bodies, then tools, lost half of their motion at the end, as a tool was jammed,
            (bodies + tools, 3) [m/s], NaN of those that did not; mostly None.
        shortened: which share of the step was given up, because its energy could not be balanced; mostly 0.
        world_loss: of body_loss: lost in friction and damping at planes and boxes [J].
        world_stored: of elastic: held by them after the step [J].
        world_force: their mean force on the copy, (3,) [N].
        cut: what the elements held that were taken away after the step; KINETIC and ELASTIC are after that [J].
        cut_elements: which they are, indices.
        rescaled: what kinetic and elastic energy changed by since the step before, as the number of copies did [J].
        advanced: what the links' tanks got of the newcomer's allowance after the step [J].
        guards: ledger of each link's guard, in the order of `Peer.neighbours`; None for a link without.
    """

    sample: Sample
    force: Float
    supplied: float
    body_loss: float
    local_loss: float
    extra_loss: float
    link_work: Float
    kinetic: float
    elastic: float
    drive_work: float
    touch_work: float
    touch_loss: float
    proxy: float
    touch_stored: float
    speed: float
    residual: float
    age: Float
    iterations: int
    closure: float
    closure_factor: float
    closing: Float | None
    jammed: Float | None
    shortened: float
    world_loss: float
    world_stored: float
    world_force: tuple[float, ...]
    cut: float
    cut_elements: tuple[int, ...]
    rescaled: float
    advanced: float
    guards: tuple[GuardLedger | None, ...]


def books_of(did: Sequence[float], touch: Sequence[float]) -> dict[str, Any]:
    """What kernels booked in a step, by the names of a report.

    Args:
        did: the copy's ledger.
        touch: that of its tools.
    """
    return {
        "supplied": did[SUPPLIED],
        "body_loss": did[BODY_LOSS],
        "local_loss": did[LOCAL_LOSS],
        "extra_loss": did[EXTRA_LOSS],
        "kinetic": did[KINETIC],
        "elastic": did[ELASTIC],
        "iterations": int(did[ITERATIONS]),
        "closure": did[CLOSURE],
        "closure_factor": did[BETA],
        "shortened": did[SHORTENED],
        "world_loss": did[WORLD_LOSS],
        "world_stored": did[WORLD_STORED],
        "world_force": tuple(did[WORLD_FORCE : WORLD_FORCE + 3]),
        "cut": did[CUT],
        "drive_work": touch[DRIVE],
        "touch_work": touch[TOUCHED],
        "touch_loss": touch[TOUCH_LOSS],
        "proxy": touch[PROXY],
        "touch_stored": touch[TOUCH_STORED],
    }
