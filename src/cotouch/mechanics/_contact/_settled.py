"""When looks at a contact may end: what forces still change by is little, beside the motion that closes a material."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, load, part, splat, total
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import State
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._model._tools import Tools

# The change of forces at which looks end: where they solve the whole body; of one with a material, that hardly moves;
# and at most.
_SETTLED, _EXACT, _COARSE = 1e-6, 1e-9, 3e-5
# Of the energy of a body that moves, what forces may still leave to its closure.
_LITTLE = 5e-5


@part
def changed(touch: ContactWork, t: int) -> float:
    """By which share a tool is pulled otherwise than by the guess before.

    Args:
        touch: `pull` and `before`.
        t: which tool.
    """
    change = size = 0.0
    for a in range(3):
        change += (touch.pull[t, a] - touch.before[t, a]) ** 2
        size += touch.pull[t, a] ** 2
    return math.sqrt(change / size) if size > 0.0 else 0.0 if change == 0.0 else math.inf


@part
def settled(
    op: Operator,
    force: BodyForce | None,
    state: State,
    guess: Float,
    touch: ContactWork,
    tools: Tools,
    T: float,
    change: float,
    near: bool,
    lanes: tuple[int, ...],
) -> float:
    """The change of forces at which looks may end.

    What contacts do beside what they were said to is work that the end velocity must make up for; what rests has none.

    Args:
        op: the body's matrices.
        force: what resists inside the body; None: it is linear.
        state: of the copy.
        guess: rate of the rows where the look was, (rows, width) [m/s].
        touch: what is near, and scratch.
        tools: the proxies.
        T: length of the step [s].
        change: of forces since the look before, as a share; infinite: this is the first.
        near: whether matrices couple the rows, which are no modes, and none is solved for at once.
        lanes: fixes the width of a row.
    """
    if not near:
        return _SETTLED
    if force is None:
        return _COARSE
    if force.parts is not None or not change < math.inf:
        return _EXACT
    missed = 0.0
    for t in range(tools.mode.shape[0]):
        power = 0.0
        for a in range(3):
            power += (touch.pull[t, a] - touch.before[t, a]) * touch.mean[t, a]
        missed += T * abs(power)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        beside = load(touch.push, i, lanes) - load(touch.said, i, lanes)
        missed += T * abs(total(beside * load(guess, i, lanes)))
    little = _LITTLE * op.copy_scale * _about(op, state.velocity, lanes)
    if not missed > 0.0:
        return _COARSE
    return min(max(change * little / missed, _EXACT), _COARSE)


@part
def _about(op: Operator, velocity: Float, lanes: tuple[int, ...]) -> float:
    """Kinetic energy about the centre of mass, of the whole body [J]."""
    momentum, moving, mass = splat(0.0, lanes), splat(0.0, lanes), 0.0
    for i in range(op.mass.shape[0]):
        m, v = at(op.mass, i), load(velocity, i, lanes)
        momentum, moving, mass = momentum + m * v, moving + m * (v * v), mass + m
    return 0.5 * (total(moving) - total(momentum * momentum) / mass)
