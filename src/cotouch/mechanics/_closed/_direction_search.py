"""A direction for a step that a few looks did not find: a search that never goes farther from it.

By a constant matrix looks go astray where the body is stiffer than that, as one is that is drawn far out or turned
inside out. A root of what v̂ misses exists for any step: where the mean force is a discrete gradient it closes the
balance exactly. So looks go on from rest, by a matrix that is stiffened where one led farther away [Levenberg, Quart.
Appl. Math. 2, 1944], and each is begun with the last changes so combined that they miss least [nonlinear GCR: Washio &
Oosterlee, ETNA 6, 1997].
"""

import math
from typing import NamedTuple

from cotouch.arrays import Float
from cotouch.kernels import FOUR, at, inner, load, part, put, splat, store, total
from cotouch.mechanics._closed._balance_groups import OPEN
from cotouch.mechanics._closed._direction import ask, correct, level, predict
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import CHANGES, Links, Ports, State, Workspace
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._meeting._bodies import Parts

# Looks that a search takes at most, and before it asks for the first time whether its direction closes the step.
LOOKS, FIRST_LOOKS = 40, 3
# A matrix becomes so much stiffer where a look led farther away, and less so where not.
_STIFFER, _SOFTER, _STIFFEST = 4.0, 0.5, 1e12
# Who misses less than this share of the motion has found all that there is.
_ENOUGH = 1e-4
# Places of numbers of a search: how much the best misses, how stiff the matrix is, how many changes are remembered.
_LEAST, _STIFF, _KEPT = range(3)
# What comes of a look: it is the best so far, or all that there is to find; or the best is taken again, for good where
# nothing is better.
BEST, FOUND, WORSE, HOPELESS = range(4)


class Sought(NamedTuple):
    """Tools that are sought together with the bodies that they touch; there may be none.

    Attributes:
        firm: what resists how each goes by itself, (tools,) [Ns/m].
        rate: how each would go, (tools, 4) [m/s].
        missed: what that misses of the forces on it, (tools, 4) [N].
        kept: of the best: `rate` and `missed`; and of each change that is remembered what it was, and what came of it,
            (tools * (2 + 2 CHANGES), 4).
    """

    firm: Float
    rate: Float
    missed: Float
    kept: Float


@part
def begin_search(parts: Parts | None, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Starts from rest, of several bodies those whose groups are not closed.

    Args:
        parts: the bodies; None: there is one.
        work: `mean` becomes 0, and `search` is written.
        lanes: fixes the width of a row.
    """
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

    Args:
        op: the body's matrices.
        force: what resists inside the body.
        state: of the copy.
        links: the neighbours' samples.
        ports: what holds the copy.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step [s].
        looks: how many at most, >= 0.
        work: `mean`, `sought` and `search` are changed.
        ledger: ITERATIONS is added to.
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.

    Returns:
        Whether there is nothing more to find.
    """
    none, found = Sought(work.diagonal[:0], work.mean[:0], work.mean[:0], work.mean[:0]), False
    for _ in range(looks):
        predict(op, force, state, T, False, work, lanes)
        ask(op, force, state, links, ports, local_damping, extra_damping, T, work, lanes)
        came = judge_look(force.parts, none, _ENOUGH, work, lanes)
        found = came in (FOUND, HOPELESS)
        if found and not at(work.search, _LEAST) < math.inf:
            return True
        if found:
            break
        combine_kept(force.parts, none, work, lanes)
        correct(op, force, state, ports, T, stiffer(work), work, ledger, tolerance, cap, lanes)
    level(op, force, force.parts, state, links, ports, local_damping, extra_damping, T, False, work, lanes)
    return found


@part
def judge_look(parts: Parts | None, tools: Sought, enough: float, work: Workspace, lanes: tuple[int, ...]) -> int:
    """Keeps what a look found if it misses less than any before, and else takes the best again.

    Args:
        parts: the bodies; those that are not sought miss nothing.
        tools: that are sought with them.
        enough: who misses less than this share of the motion has found all that there is.
        work: `mean` is where the look was, and `rhs` what it misses.
        lanes: fixes the width.

    Returns:
        What comes of it.
    """
    rows, numbers, count = work.mean.shape[0], work.search, tools.firm.shape[0]
    first = not at(numbers, _LEAST) < math.inf
    for i in range(rows if first else 0):
        store(work.sought, 2 * rows + i, splat(1.0 / at(work.diagonal, i), lanes), lanes)
    missed, goes = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rows):
        if not _is_open(parts, i):
            store(work.rhs, i, splat(0.0, lanes), lanes)
            continue
        left, rate, weight = load(work.rhs, i, lanes), load(work.mean, i, lanes), _weight(work, rows, i, lanes)
        missed, goes = missed + weight * (left * left), goes + rate * rate / weight
    misses, size = total(missed), total(goes)
    for t in range(count):
        left, rate, firm = load(tools.missed, t, FOUR), load(tools.rate, t, FOUR), at(tools.firm, t)
        misses, size = misses + total(left * left) / firm, size + firm * total(rate * rate)
    if misses < at(numbers, _LEAST):
        if not first:
            _remember(tools, work, lanes)
        _copy(work.mean, 0, work.sought, 0, rows, lanes)
        _copy(work.rhs, 0, work.sought, rows, rows, lanes)
        _copy(tools.rate, 0, tools.kept, 0, count, FOUR)
        _copy(tools.missed, 0, tools.kept, count, count, FOUR)
        put(numbers, _LEAST, misses)
        put(numbers, _STIFF, max(_SOFTER * at(numbers, _STIFF), 1.0))
        return FOUND if misses <= enough * enough * size else BEST
    if first:
        return HOPELESS
    best_again(parts, work, lanes)
    _copy(work.sought, rows, work.rhs, 0, rows, lanes)
    _copy(tools.kept, 0, tools.rate, 0, count, FOUR)
    _copy(tools.kept, count, tools.missed, 0, count, FOUR)
    put(numbers, _STIFF, _STIFFER * at(numbers, _STIFF))
    put(numbers, _KEPT, 0.0)
    return HOPELESS if at(numbers, _STIFF) > _STIFFEST else WORSE


@inner
def stiffer(work: Workspace) -> float:
    """By which share of them springs and dampers are stiffer now."""
    return at(work.search, _STIFF) - 1.0


@part
def best_again(parts: Parts | None, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Takes the best direction that was found.

    Args:
        parts: the bodies; None: there is one.
        work: `mean` becomes what `sought` keeps.
        lanes: fixes the width of a row.
    """
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
def _along(
    work: Workspace, one: Float, first: int, tools: Sought, two: Float, begin: int, change: int, lanes: tuple[int, ...]
) -> float:
    """How much of a change there is in what is missed, of rows of `one` from `first` on, of tools of `two`."""
    rows, count = work.mean.shape[0], tools.firm.shape[0]
    base, beside = (4 + 2 * change) * rows, (3 + 2 * change) * count
    with_it, own = splat(0.0, lanes), splat(0.0, lanes)
    for i in range(rows):
        did, weight = load(work.sought, base + i, lanes), _weight(work, rows, i, lanes)
        with_it = with_it + weight * (load(one, first + i, lanes) * did)
        own = own + weight * (did * did)
    part_of, whole = total(with_it), total(own)
    for t in range(count):
        did = load(tools.kept, beside + t, FOUR)
        part_of += total(load(two, begin + t, FOUR) * did) / at(tools.firm, t)
        whole += total(did * did) / at(tools.firm, t)
    return part_of / whole if whole > 0.0 else 0.0


@part
def _remember(tools: Sought, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Keeps what the last look changed, and what came of that, apart from what others that are kept did."""
    rows, count, kept = work.mean.shape[0], tools.firm.shape[0], int(at(work.search, _KEPT))
    slot = kept % CHANGES
    base, beside = (3 + 2 * slot) * rows, (2 + 2 * slot) * count
    for i in range(rows):
        goes = load(work.mean, i, lanes) - load(work.sought, i, lanes)
        store(work.sought, base + i, goes, lanes)
        store(work.sought, base + rows + i, load(work.sought, rows + i, lanes) - load(work.rhs, i, lanes), lanes)
    for t in range(count):
        store(tools.kept, beside + t, load(tools.rate, t, FOUR) - load(tools.kept, t, FOUR), FOUR)
        did = load(tools.kept, count + t, FOUR) - load(tools.missed, t, FOUR)
        store(tools.kept, beside + count + t, did, FOUR)
    for other in range(min(kept, CHANGES)):
        if other != slot:
            share = _along(work, work.sought, base + rows, tools, tools.kept, beside + count, other, lanes)
            for i in range(2 * rows):
                left = load(work.sought, base + i, lanes) - share * load(work.sought, (3 + 2 * other) * rows + i, lanes)
                store(work.sought, base + i, left, lanes)
            for t in range(2 * count):
                left = load(tools.kept, beside + t, FOUR) - share * load(tools.kept, (2 + 2 * other) * count + t, FOUR)
                store(tools.kept, beside + t, left, FOUR)
    put(work.search, _KEPT, float(kept + 1))


@part
def combine_kept(parts: Parts | None, tools: Sought, work: Workspace, lanes: tuple[int, ...]) -> None:
    """Goes by changes that are kept as far as least is missed, if what came of them adds up.

    Args:
        parts: the bodies; None: there is one.
        tools: that are sought with them.
        work: `mean` and `rhs` are changed.
        lanes: fixes the width of a row.
    """
    rows, count = work.mean.shape[0], tools.firm.shape[0]
    for change in range(min(int(at(work.search, _KEPT)), CHANGES)):
        share = _along(work, work.rhs, 0, tools, tools.missed, 0, change, lanes)
        base, beside = (3 + 2 * change) * rows, (2 + 2 * change) * count
        for i in range(rows):
            if _is_open(parts, i):
                goes, did = load(work.sought, base + i, lanes), load(work.sought, base + rows + i, lanes)
                store(work.mean, i, load(work.mean, i, lanes) + share * goes, lanes)
                store(work.rhs, i, load(work.rhs, i, lanes) - share * did, lanes)
        for t in range(count):
            goes, did = load(tools.kept, beside + t, FOUR), load(tools.kept, beside + count + t, FOUR)
            store(tools.rate, t, load(tools.rate, t, FOUR) + share * goes, FOUR)
            store(tools.missed, t, load(tools.missed, t, FOUR) - share * did, FOUR)
