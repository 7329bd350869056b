"""Looks combined: each begins where the last ones, together, leave nothing to do along what they changed.

By a constant matrix every look leaves the same shares of the error before, most of it along the few directions in which
that is least like the forces within the body. What looks changed of v̂, and of what it misses, tells how much more of it
was needed: they are the steps of conjugate gradients with that matrix as preconditioner. A mean of directions that
have the momentum of the forces has it, too.
"""

from cotouch.arrays import Float
from cotouch.kernels import load, part, splat, store, total
from cotouch.mechanics._linear._state import State, Workspace

# How far looks are taken beyond what they changed: back by half where the forces are twice the matrix, which is the
# most that they are, and five times as far at most.
_BACK, _FAR = -0.5, 4.0
# The first look that is kept, from 0: the one before finds what the matrix knows well, and no contact that begins.
_FIRST = 1
# Below this share of its size, what is apart from the change before is rounding.
_ALIKE = 1e-9
# The change before is forgotten where forces have bent: where it leaves more of itself to do than this beyond what the
# last change undid of it, or where that was more than all of it this often.
_BENT, _UNDONE = 0.5, 2.0
# Fields in `sought`: where the last look began, and what was missing there; what it changed, apart from the change
# before, and what that did to what is missing.
_BASE, _MISSES, _GOES, _DID = range(4)


@part
def combine_looks(state: State, T: float, number: int, work: Workspace, lanes: tuple[int, ...]) -> float:
    """Takes v̂ to where the next look begins.

    Args:
        state: of the copy.
        T: length of the step [s].
        number: of looks that were taken.
        work: `mean` is v̂, to which they led, and `rhs` what it misses; both are changed, and `ahead` with them.
        lanes: fixes the width.

    Returns:
        Power that is missing where they led: with it the step would not be balanced.
    """
    if number < _FIRST:
        return 0.0
    rows, sought, zero = work.mean.shape[0], work.sought, splat(0.0, lanes)
    base, misses, goes, did = _BASE * rows, _MISSES * rows, _GOES * rows, _DID * rows
    power = zero
    if number == _FIRST:
        for i in range(rows):
            rate, missing = load(work.mean, i, lanes), load(work.rhs, i, lanes)
            power = power + rate * missing
            store(sought, base + i, rate, lanes)
            store(sought, misses + i, missing, lanes)
        return total(power)
    size, beside, across, last_size, left, last_left = zero, zero, zero, zero, zero, zero
    for i in range(rows):
        rate, missing = load(work.mean, i, lanes), load(work.rhs, i, lanes)
        way, came = rate - load(sought, base + i, lanes), load(sought, misses + i, lanes) - missing
        power = power + rate * missing
        size, left = size + way * came, left + way * missing
        if number > _FIRST + 1:
            last_way, last_came = load(sought, goes + i, lanes), load(sought, did + i, lanes)
            beside, across = beside + last_way * came, across + way * last_came
            last_size, last_left = last_size + last_way * last_came, last_left + last_way * missing
    alike, again, share = 0.0, 0.0, 0.0
    if total(last_size) > 0.0:
        alike, again = total(beside) / total(last_size), total(last_left) / total(last_size)
        if not (abs(again + alike) <= _BENT and abs(alike) <= _UNDONE):
            alike, again = 0.0, 0.0
    apart = total(size) - alike * (total(across) + total(beside) - alike * total(last_size))
    if apart > _ALIKE * abs(total(size)):
        share = min(max((total(left) - alike * total(last_left)) / apart, _BACK), _FAR)
    for i in range(rows):
        rate, missing = load(work.mean, i, lanes), load(work.rhs, i, lanes)
        way, came = rate - load(sought, base + i, lanes), load(sought, misses + i, lanes) - missing
        if number > _FIRST + 1:
            last_way, last_came = load(sought, goes + i, lanes), load(sought, did + i, lanes)
            way, came = way - alike * last_way, came - alike * last_came
            rate, missing = rate + again * last_way, missing - again * last_came
        rate, missing = rate + share * way, missing - share * came
        store(sought, goes + i, way, lanes)
        store(sought, did + i, came, lanes)
        store(sought, base + i, rate, lanes)
        store(sought, misses + i, missing, lanes)
        store(work.mean, i, rate, lanes)
        store(work.rhs, i, missing, lanes)
        store(work.ahead, i, load(state.position, i, lanes) + T * rate, lanes)
    return total(power)


@part
def dot_rows(first: Float, second: Float, lanes: tuple[int, ...]) -> float:
    """`Σ firstᵀ second` over all rows.

    Args:
        first: (rows, width).
        second: likewise.
        lanes: fixes the width of a row.
    """
    result = splat(0.0, lanes)
    for i in range(first.shape[0]):
        result = result + load(first, i, lanes) * load(second, i, lanes)
    return total(result)
