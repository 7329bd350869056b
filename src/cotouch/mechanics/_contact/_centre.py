"""A step in which a tool is held back goes less far about the common centre of the tool and what it touches.

What tool and skin do to each other adds up to nothing, so whatever becomes of such a step, only what acts from outside
changes their momentum: drives, ports, links, obstacles and weight (`_level`). Shortened about rest, a ball that is
thrown would lose all of it.
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, inner, load, part, splat, store, total
from cotouch.kernels.matrix3 import solved
from cotouch.mechanics._closed._balance import FIXED, MOTION
from cotouch.mechanics._closed._balance_groups import TIED
from cotouch.mechanics._closed._balance_length import find_outside, keep_groups, stretch
from cotouch.mechanics._closed._balance_parts import hold_face, hold_groups
from cotouch.mechanics._closed._direction import predict
from cotouch.mechanics._closed._direction_combined import dot_rows
from cotouch.mechanics._closed._direction_missing import lack_ports, miss
from cotouch.mechanics._contact._over import stretch_tool
from cotouch.mechanics._contact._skin import fastest, read_rates
from cotouch.mechanics._contact._sweep import first_crossing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import MASS, Operator, mixed, multiply, pull, row_product
from cotouch.mechanics._linear._state import KINETIC, Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import assemble
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import GRASP, PROXY, TOUCH_LOSS, TOUCHED, TOUCHING, Tools

# Looks at most, where what obstacles do depends on where the centre goes; and its change, of itself, that ends them.
_LOOKS, _SETTLED = 20, 1e-12
# What a jammed tool keeps of its motion, and the way that it goes less than which it is.
_KEPT, JAMMED = 0.5, 0.5
# Springs that would move a body by less than this share of what inertia does hold nothing.
_LOOSE = 1e-9


@part
def go_about(
    op: Operator,
    force: BodyForce | None,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    factor: float,
    rest: bool,
    work: Workspace,
    touch: ContactWork,
    lanes: tuple[int, ...],
) -> float:
    """Goes a part of the way about the common centre of tools and what they touch, whose momentum is that from outside.

    Args:
        op: the body's matrices.
        force: what resists inside the body beside them; None: nothing.
        state: of the copy.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the skin.
        tools: the proxies.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        factor: of the way that `work.mean` and `touch.mean` hold; they get what comes of it.
        rest: whether nothing is to go anywhere, not even with the centre, as the last that balances in any case.
        work: scratch; of a linear body its system is there.
        touch: likewise; gets the rates of the skin.
        lanes: fixes the width of a row.

    Returns:
        `v̂ᵀ (A v̂ - b)` of a linear body, what tools do on it [W].
    """
    if force is None:
        stretch(None, work.mean, factor, lanes)
    else:
        stretch(force.parts, work.mean, factor, lanes)
    for t in range(tools.mode.shape[0]):
        if _joins(tools, touch, t) or rest:
            stretch_tool(touch, t, factor)
    did = 0.0
    if rest:
        did = 0.0
    elif force is None:
        miss(op, work.diagonal, work.rhs, work, touch.asked, lanes)
        lack_ports(ports, work, touch.asked)
        _level(op, ports, tools, touch, None, 0, work, lanes)
        miss(op, work.diagonal, work.rhs, work, touch.asked, lanes)
        lack_ports(ports, work, touch.asked)
        did = -dot_rows(work.mean, touch.asked, lanes)
    else:
        for number in range(_looks(force.world)):
            predict(op, force, state, T, True, work, lanes)
            keep_groups(force.parts)
            hold_groups(force.parts)
            assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
            miss(op, work.diagonal, work.rhs, work, touch.asked, lanes)
            lack_ports(ports, work, touch.asked)
            if _level(op, ports, tools, touch, force.parts, number, work, lanes):
                break
    touch.quick[0] = fastest(surface, work.mean, lanes)
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == TOUCHING:
            read_rates(surface, touch, t, work.mean, lanes)
    return did


@part
def is_free(
    op: Operator,
    force: BodyForce | None,
    links: Links,
    ports: Ports,
    tools: Tools,
    touch: ContactWork,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> bool:
    """Whether nothing but weight acts from outside on tools and what they may touch: then momentum is kept for sure.

    Args:
        op: see `go_about`, like all others.
        force: likewise.
        links: likewise.
        ports: likewise.
        tools: likewise.
        touch: likewise.
        T: likewise.
        work: likewise; `weighed` is told as by `find_outside`.
        lanes: likewise.
    """
    free, whole = links.slot.shape[0] == 0, touch.whole
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] in (TOUCHING, GRASP):
            free = free and tools.drive_stiffness[t] == 0.0 and tools.drive_damping[t] == 0.0
    for p in range(ports.row.shape[0]):
        free = free and ports.stiffness[p] == 0.0 and ports.damping[p] == 0.0
    if not free:
        return False
    for a in range(3):
        holds, mass = splat(0.0, lanes), splat(0.0, lanes)
        for i in range(work.mean.shape[0]):
            own = load(whole[a], i, lanes)
            held = (0.5 * T) * pull(op, i, whole[a], lanes) + op.drag[i] * own
            holds, mass = holds + own * held, mass + own * (op.mass[i] * own)
        free = free and total(holds) <= _LOOSE * total(mass) / T and total(mass) > 0.0
    if force is None or not free:
        return free
    work.weighed[FIXED] = 0.0
    find_outside(op, force.world, force.parts, ports, T, work, lanes)
    return work.weighed[FIXED] == 0.0 and not _any_tied(force.parts)


@part
def _any_tied(parts: Parts | None) -> bool:
    """Whether something outside holds a body that tools touch, or of its group."""
    if parts is None:
        return False
    for b in range(parts.held.shape[0]):  # noqa: SIM110 (kernels have no generators)
        if at(parts.held, b) != 0 and at(parts.sums, (b, TIED)) != 0.0:
            return True
    return False


@part
def join_crossed(surface: Surface, tools: Tools, touch: ContactWork, force: BodyForce | None, T: float) -> bool:
    """Has tools that pass the skin by the present motion, and what they pass, go about one centre; whether any does.

    Args:
        surface: the skin.
        tools: the proxies.
        touch: what is near; `caught` marks the tools that pass.
        force: what resists inside the body; None: it is linear.
        T: length of the step [s].
    """
    found = False
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == TOUCHING and tools.inside[t] == 0 and first_crossing(surface, touch, tools, t, T) <= 1.0:
            found = True
            touch.caught[t, 0] = 1.0
            if force is not None:
                hold_face(surface, force.parts, int(touch.caught[t, 1]))
    if force is not None and found:
        hold_groups(force.parts)
    return found


@part
def lose_motion(
    op: Operator,
    state: State,
    tools: Tools,
    parts: Parts | None,
    touch: ContactWork,
    ledger: Float,
    touch_ledger: Float,
    lanes: tuple[int, ...],
) -> None:
    """Takes half of the motion of tools and what they touch about their common centre; it is booked as lost.

    A tool that is jammed goes nowhere, so no force changes how fast anything is: by velocities that are only turned
    back it would be so for good.

    Args:
        op: the body's matrices.
        state: of the copy, after the step; its velocity is changed in place.
        tools: the proxies, likewise.
        parts: the bodies; None: there is one.
        touch: scratch.
        ledger: KINETIC is changed.
        touch_ledger: TOUCHED, PROXY and TOUCH_LOSS are changed.
        lanes: fixes the width of a row.
    """
    whole, spot, velocity = touch.whole, touch.spot, state.velocity
    before = multiply(op, MASS, op.mass, velocity, touch.asked, lanes)
    for a in range(3):
        spot[0, a] = op.copy_scale * _of_touched(parts, whole[a], touch.asked, lanes)
    own = 0.0
    for a in range(3):
        multiply(op, MASS, op.mass, whole[a], touch.asked, lanes)
        spot[1, a] = op.copy_scale * _of_touched(parts, whole[a], touch.asked, lanes)
    for t in range(tools.mode.shape[0]):
        if touch.caught[t, 4] != 0.0:
            own += tools.mass[t]
            for a in range(3):
                spot[0, a] += tools.mass[t] * tools.rate[t, a]
    for a in range(3):
        spot[0, a] = spot[0, a] / (spot[1, a] + own) if spot[1, a] > 0.0 else 0.0
    for i in range(velocity.shape[0]):
        if _touched(parts, i):
            centre = splat(0.0, lanes)
            for a in range(3):
                centre = centre + spot[0, a] * load(whole[a], i, lanes)
            store(velocity, i, centre + _KEPT * (load(velocity, i, lanes) - centre), lanes)
    lost = 0.5 * (before - multiply(op, MASS, op.mass, velocity, touch.asked, lanes))
    for i in range(velocity.shape[0] if mixed(op, MASS) else 0):
        store(state.momentum, i, load(touch.asked, i, lanes), lanes)
    if state.memory.shape[0] > 0:
        state.memory[MOTION] -= lost
    ledger[KINETIC] -= op.copy_scale * lost
    touch_ledger[TOUCHED] -= op.copy_scale * lost
    touch_ledger[TOUCH_LOSS] += op.copy_scale * lost
    for t in range(tools.mode.shape[0]):
        for a in range(3 if touch.caught[t, 4] != 0.0 else 0):
            rate = spot[0, a] + _KEPT * (tools.rate[t, a] - spot[0, a])
            lost = 0.5 * tools.mass[t] * (tools.rate[t, a] * tools.rate[t, a] - rate * rate)
            tools.rate[t, a] = rate
            touch_ledger[PROXY] -= lost
            touch_ledger[TOUCH_LOSS] += lost


@inner
def _looks(world: World | None) -> int:
    return 1 if world is None else _LOOKS


@inner
def _joins(tools: Tools, touch: ContactWork, t: int) -> bool:
    """Whether a tool and the body do anything to each other, or did at another length of this step."""
    feels = touch.caught[t, 0] != 0.0 or touch.total[t] > 0.0 or touch.well[t] != 0.0 or touch.stored[t] != 0.0
    if tools.mode[t] == GRASP or (tools.mode[t] == TOUCHING and tools.inside[t] == 0 and feels):
        touch.caught[t, 4] = 1.0
    return touch.caught[t, 4] != 0.0


@inner
def _touched(parts: Parts | None, i: int) -> bool:
    """Whether a row is of a body that tools touch, or of one that such a body touches."""
    return True if parts is None else at(parts.held, at(parts.part, i)) != 0


@part
def _of_touched(parts: Parts | None, first: Float, second: Float, lanes: tuple[int, ...]) -> float:
    """`Σ firstᵀ second` over rows of what tools touch."""
    result = splat(0.0, lanes)
    for i in range(first.shape[0]):
        if _touched(parts, i):
            result = result + load(first, i, lanes) * load(second, i, lanes)
    return total(result)


@part
def _level(
    op: Operator,
    ports: Ports,
    tools: Tools,
    touch: ContactWork,
    parts: Parts | None,
    number: int,
    work: Workspace,
    lanes: tuple[int, ...],
) -> bool:
    """Moves tools and what they touch as a whole as their momentum asks; returns whether that changes little.

    Obstacles resist more than the system of a step says, as the look before tells: rows 0 and 1 of `spot` keep what it
    changed, and what momentum lacked.
    """
    whole, spot = touch.whole, touch.spot
    firm = (
        _resists(op, ports, touch, parts, 0, 0, work, lanes),
        _resists(op, ports, touch, parts, 1, 1, work, lanes),
        _resists(op, ports, touch, parts, 2, 2, work, lanes),
    )
    for a in range(3):
        spot[2, a] = _of_touched(parts, whole[a], touch.asked, lanes)
    own = 0.0
    for t in range(tools.mode.shape[0]):
        if touch.caught[t, 4] != 0.0:
            own += touch.inertia[t]
            for a in range(3):
                spot[2, a] += touch.drive[t, a] - touch.inertia[t] * touch.mean[t, a]
    for a in range(3):  # who cannot go as a whole along an axis stays there, and so do tools
        if not firm[a] > 0.0:
            spot[2, a] = 0.0
    xy = _resists(op, ports, touch, parts, 0, 1, work, lanes)
    xz = _resists(op, ports, touch, parts, 0, 2, work, lanes)
    yz = _resists(op, ports, touch, parts, 1, 2, work, lanes)
    x, y, z = solved(
        (firm[0] + own, xy, xz, xy, firm[1] + own, yz, xz, yz, firm[2] + own), (spot[2, 0], spot[2, 1], spot[2, 2])
    )
    spot[3, 0], spot[3, 1], spot[3, 2], spot[3, 3] = x, y, z, 0.0
    along, square = 0.0, 0.0
    for a in range(3 if number > 0 else 0):
        did = spot[1, a] - spot[2, a]
        along += did * spot[0, a]
        square += did * did
    if along > 0.0 and square > 0.0:
        share = min(along / square, 1.0 / (firm[0] + own))
        for a in range(3):
            spot[3, a] = share * spot[2, a]
    change, size = 0.0, 0.0
    for i in range(work.mean.shape[0]):
        if _touched(parts, i):
            more = splat(0.0, lanes)
            for a in range(3):
                more = more + spot[3, a] * load(whole[a], i, lanes)
            rate = load(work.mean, i, lanes) + more
            store(work.mean, i, rate, lanes)
            change, size = change + total(more * more), size + total(rate * rate)
    for t in range(tools.mode.shape[0]):
        for a in range(3 if touch.caught[t, 4] != 0.0 else 0):
            touch.mean[t, a] += spot[3, a]
            touch.skin[t, a] += spot[3, a]
    for a in range(3):
        spot[0, a], spot[1, a] = spot[3, a], spot[2, a]
    return not change > _SETTLED * _SETTLED * size


@part
def _resists(
    op: Operator,
    ports: Ports,
    touch: ContactWork,
    parts: Parts | None,
    a: int,
    b: int,
    work: Workspace,
    lanes: tuple[int, ...],
) -> float:
    """How what tools touch resists along one axis that it goes along another as a whole [Ns/m]."""
    one, two, resists = touch.whole[a], touch.whole[b], splat(0.0, lanes)
    for i in range(work.mean.shape[0]):
        if _touched(parts, i):
            own = work.diagonal[i] * load(two, i, lanes)
            for family in range(op.entries.shape[0]):
                own = own + work.scale[family] * row_product(op, family, i, two, lanes)
            resists = resists + load(one, i, lanes) * own
    result = total(resists)
    for p in range(ports.shape.shape[0]):
        for c in range(one.shape[1]):
            goes, takes = 0.0, 0.0
            for i in range(one.shape[0]):
                if _touched(parts, i):
                    goes += at(ports.shape, (p, i)) * two[i, c]
                    takes += at(ports.shape, (p, i)) * one[i, c]
            result += work.port_gain[p] * goes * takes
    return result
