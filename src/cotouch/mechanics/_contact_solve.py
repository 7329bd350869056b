"""Solves a body for what contacts and grasps were found to do on its rows."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.mechanics._contact_near import say
from cotouch.mechanics._contact_work import ContactWork
from cotouch.mechanics._direction import FEW
from cotouch.mechanics._direction_missing import lack, miss
from cotouch.mechanics._kernel import part
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._solve import solve_step
from cotouch.mechanics._state import ITERATIONS, Ports, Workspace
from cotouch.mechanics._vector import load, store

_COARSE = 0.01  # of what the last look missed the next may leave so much, where it solves the whole body


@part
def solve_touched(
    op: Operator,
    ports: Ports,
    touch: ContactWork,
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
) -> None:
    """Solves the body with what contacts were found to do, or corrects the rate that was found by a coarse solve.

    Diagonal and right-hand side are without contacts again afterwards.
    """
    mean, rhs, push, own, asked = work.mean, work.rhs, touch.push, touch.own, touch.asked
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
