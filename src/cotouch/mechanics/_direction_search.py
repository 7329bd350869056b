"""A direction for a step that a few looks did not find: a search that never goes farther from it.

By a constant matrix looks go astray where the body is stiffer than that, as one is that is drawn far out or turned
inside out. A root of what v̂ misses exists for any step: where the mean force is a discrete gradient it closes the
balance exactly. So looks go on from rest, by a matrix that is stiffened where one led farther away [Levenberg, Quart.
Appl. Math. 2, 1944], and each is begun with the last changes so combined that they miss least [nonlinear GCR: Washio &
Oosterlee, ETNA 6, 1997].
"""

import math

from cotouch.arrays import Float
from cotouch.mechanics._balance_groups import OPEN
from cotouch.mechanics._direction import ask, correct, level, predict
from cotouch.mechanics._force import BodyForce
from cotouch.mechanics._kernel import inner, part
from cotouch.mechanics._meeting import Parts
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._state import CHANGES, Links, Ports, State, Workspace
from cotouch.mechanics._vector import at, load, put, splat, store, total

# Looks that a search takes at most, and before it asks for the first time whether its direction closes the step.
LOOKS, FIRST_LOOKS = 40, 3
# A matrix becomes so much stiffer where a look led farther away, and less so where not.
_STIFFER, _SOFTER, _STIFFEST = 4.0, 0.5, 1e12
# Who misses less than this share of the motion has found all that there is.
_FOUND = 1e-4
# Places of numbers of a search: how much the best misses, how stiff the matrix is, how many changes are remembered.
_LEAST, _STIFF, _KEPT = range(3)


@part
def begin_search(parts: Parts | None, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Starts from rest, of several bodies those whose groups are not closed."""
    for i in range(work.mean.shape[0]):
        if _is_open(parts, i):
            store(work.mean, i, splat(0.0, lanes), lanes)
    put(work.search, _LEAST, math.inf)
    put(work.search, _STIFF, 1.0)
    put(work.search, _KEPT, 0.0)


@part
def search(
    op: Operator,
    force: BodyForce,
    state: State,
    links: Links,
    ports: Ports,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    looks: int,
    work: Workspace,
    ledger: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> bool:
    """Takes a few more looks.

    Returns:
        Whether there is nothing more to find.
    """
    rows, numbers, found = op.mass.shape[0], work.search, False
    for _ in range(looks):
        predict(op, force, state, T, False, work, lanes)
        ask(op, force, state, links, ports, local_damping, extra_damping, T, work, lanes)
        if not at(numbers, _LEAST) < math.inf:
            for i in range(rows):
                store(work.sought, 2 * rows + i, splat(1.0 / at(work.diagonal, i), lanes), lanes)
        missed, goes = splat(0.0, lanes), splat(0.0, lanes)
        for i in range(rows):
            if not _is_open(force.parts, i):
                store(work.rhs, i, splat(0.0, lanes), lanes)
                continue
            left, rate, weight = load(work.rhs, i, lanes), load(work.mean, i, lanes), _weight(work, rows, i, lanes)
            missed, goes = missed + weight * (left * left), goes + rate * rate / weight
        misses = total(missed)
        if misses < at(numbers, _LEAST):
            if at(numbers, _LEAST) < math.inf:
                _remember(work, lanes)
            _copy(work.mean, 0, work.sought, 0, rows, lanes)
            _copy(work.rhs, 0, work.sought, rows, rows, lanes)
            put(numbers, _LEAST, misses)
            put(numbers, _STIFF, max(_SOFTER * at(numbers, _STIFF), 1.0))
            found = misses <= _FOUND * _FOUND * total(goes)
        elif at(numbers, _LEAST) < math.inf:
            best_again(force.parts, work, lanes)
            _copy(work.sought, rows, work.rhs, 0, rows, lanes)
            put(numbers, _STIFF, _STIFFER * at(numbers, _STIFF))
            put(numbers, _KEPT, 0.0)
        else:
            return True
        if found or at(numbers, _STIFF) > _STIFFEST:
            found = True
            break
        _combine(force.parts, work, lanes)
        correct(op, force, state, ports, T, at(numbers, _STIFF) - 1.0, work, ledger, tolerance, cap, lanes)
    level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, False, work, lanes)
    return found


@part
def best_again(parts: Parts | None, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes the best direction that was found."""
    for i in range(work.mean.shape[0] if at(work.search, _LEAST) < math.inf else 0):
        if _is_open(parts, i):
            store(work.mean, i, load(work.sought, i, lanes), lanes)


@inner
def _is_open(parts: Parts | None, i: int) -> bool:
    """Whether a row is one of those that are sought."""
    return parts is None or at(parts.sums, (at(parts.part, i), OPEN)) != 0.0


@inner
def _weight(work: Workspace, rows: int, i: int, lanes: tuple[int, ...]) -> float:
    return load(work.sought, 2 * rows + i, lanes)


@inner
def _copy(source: Float, first: int, target: Float, start: int, rows: int, lanes: tuple[int, ...]) -> None:
    for i in range(rows):
        store(target, start + i, load(source, first + i, lanes), lanes)


@part
def _along(work: Workspace, one: Float, first: int, change: int, lanes: tuple[int, ...]) -> float:
    """How much of a change there is in what is missed, of rows of `one` from `first` on."""
    rows = work.mean.shape[0]
    base = (4 + 2 * change) * rows
    with_it, own = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rows):
        did, weight = load(work.sought, base + i, lanes), _weight(work, rows, i, lanes)
        with_it = with_it + weight * (load(one, first + i, lanes) * did)
        own = own + weight * (did * did)
    return total(with_it) / total(own) if total(own) > 0.0 else 0.0


@part
def _remember(work: Workspace, lanes: tuple[int, ...]) -> None:
    """Keeps what the last look changed, and what came of that, apart from what others that are kept did."""
    rows, kept = work.mean.shape[0], int(at(work.search, _KEPT))
    slot = kept % CHANGES
    base = (3 + 2 * slot) * rows
    for i in range(rows):
        goes = load(work.mean, i, lanes) - load(work.sought, i, lanes)
        store(work.sought, base + i, goes, lanes)
        store(work.sought, base + rows + i, load(work.sought, rows + i, lanes) - load(work.rhs, i, lanes), lanes)
    for other in range(min(kept, CHANGES)):
        if other != slot:
            share, beside = _along(work, work.sought, base + rows, other, lanes), (3 + 2 * other) * rows
            for i in range(2 * rows):
                left = load(work.sought, base + i, lanes) - share * load(work.sought, beside + i, lanes)
                store(work.sought, base + i, left, lanes)
    put(work.search, _KEPT, float(kept + 1))


@part
def _combine(parts: Parts | None, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Goes by changes that are kept as far as least is missed, if what came of them adds up."""
    rows = work.mean.shape[0]
    for change in range(min(int(at(work.search, _KEPT)), CHANGES)):
        share, base = _along(work, work.rhs, 0, change, lanes), (3 + 2 * change) * rows
        for i in range(rows):
            if _is_open(parts, i):
                goes, did = load(work.sought, base + i, lanes), load(work.sought, base + rows + i, lanes)
                store(work.mean, i, load(work.mean, i, lanes) + share * goes, lanes)
                store(work.rhs, i, load(work.rhs, i, lanes) - share * did, lanes)
