"""Solves a body for what contacts and grasps were found to do on its rows."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import at, load, part, splat, store, total
from cotouch.mechanics._closed._direction import FEW
from cotouch.mechanics._closed._direction_missing import lack, miss
from cotouch.mechanics._contact._near import say
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._solve import solve_step
from cotouch.mechanics._linear._state import ITERATIONS, Ports, State, Workspace

_COARSE = 0.01  # of what the last look missed the next may leave so much, where it solves the whole body


@part
def solve_touched(
    op: Operator,
    ports: Ports,
    touch: ContactWork,
    state: State,
    work: Workspace,
    T: float,
    number: int,
    modal: bool,
    corrects: bool,
    material: bool,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> tuple[float, float]:
    """Solves the body with what contacts were found to do, or corrects the rate that was found by a coarse solve.

    Diagonal and right-hand side are without contacts again afterwards.

    Args:
        op: the body's matrices.
        ports: what holds the copy.
        touch: what contacts were found to do.
        state: of the copy.
        work: the body's system; `mean` is written.
        T: length of the step [s].
        number: of the look, from 0.
        modal: whether the body's rows are modes.
        corrects: whether the rate is corrected rather than solved for.
        material: whether the body has a material.
        ledger: ITERATIONS is added to.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.

    Returns:
        Of a correction of a body with a material, what it changed and what moves then, as `direct`; else 0.
    """
    mean, rhs, push, own, asked = work.mean, work.rhs, touch.push, touch.own, touch.asked
    change, moving = 0.0, 0.0
    if modal:  # as much of the change as its answer leaves
        share = 1.0 / (1.0 + max(touch.yields[0], touch.yields[1], touch.yields[2]))
        for i in range(mean.shape[0]):
            before = load(touch.found, i, lanes)
            if number > 0:
                store(push, i, before + share * (load(push, i, lanes) - before), lanes)
            store(touch.found, i, load(push, i, lanes), lanes)
    if modal or corrects:
        for i in range(mean.shape[0]):
            store(asked, i, load(rhs, i, lanes), lanes)
            if modal:
                store(rhs, i, load(rhs, i, lanes) + load(push, i, lanes), lanes)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        own[i] = work.diagonal[i]
        store(asked, i, load(rhs, i, lanes), lanes)
        work.diagonal[i] += touch.hold[i]
        store(rhs, i, load(rhs, i, lanes) + load(push, i, lanes), lanes)
    if not corrects:
        ledger[ITERATIONS] += solve_step(op, ports, work, tolerance, 0, cap, lanes)
    else:
        if material:  # the tension is all that is done inside
            lack(op, T, work, lanes)
        else:
            miss(op, work.diagonal, rhs, work, rhs, lanes)
        for i in range(mean.shape[0]):
            store(touch.found, i, load(mean, i, lanes), lanes)
        ledger[ITERATIONS] += solve_step(op, ports, work, max(tolerance, _COARSE), FEW, cap, lanes)
        if material:
            change, moving = _add(op, touch.found, mean, state.velocity, lanes)
        else:
            for i in range(mean.shape[0]):
                store(mean, i, load(mean, i, lanes) + load(touch.found, i, lanes), lanes)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        work.diagonal[i] = own[i]
        store(rhs, i, load(asked, i, lanes), lanes)
    if modal or corrects:
        for i in range(mean.shape[0]):
            store(rhs, i, load(asked, i, lanes), lanes)
    say(touch, mean, rhs, lanes)
    return change, moving


@part
def _add(op: Operator, found: Float, mean: Float, velocity: Float, lanes: tuple[int, ...]) -> tuple[float, float]:
    """Adds a correction to the rate; squares of it, and of the end velocity about the centre, in the norm of M."""
    change, moving, momentum, mass = splat(0.0, lanes), splat(0.0, lanes), splat(0.0, lanes), 0.0
    for i in range(mean.shape[0]):
        more, m = load(mean, i, lanes), at(op.mass, i)
        rate = load(found, i, lanes) + more
        store(mean, i, rate, lanes)
        end = 2.0 * rate - load(velocity, i, lanes)
        change, moving, momentum = change + m * (more * more), moving + m * (end * end), momentum + m * end
        mass += m
    return total(change), total(moving) - total(momentum * momentum) / mass
