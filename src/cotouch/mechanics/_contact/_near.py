"""Corrects a body's motion where tools touch: what contacts do anew changes little beyond the rows near them.

Conjugate gradients from zero spread by one neighbour in an iteration, so only rows within a few neighbours of what is
touched are ever looked at. A contact resists along its own direction, so a touched row has a matrix of its axes: with a
number that resists on all of them, looks would tend half as fast.
"""
# pyright: reportArgumentType=false, reportReturnType=false, reportOperatorIssue=false

import math

from cotouch.arrays import Float
from cotouch.kernels import at, load, part, put, splat, store, total, upper
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._operator import Operator, row_sum
from cotouch.mechanics._linear._state import Workspace

# Between which shares all corrections of a step leave of what the first should correct, of a body with a material and
# of a linear one, and the iterations of each at most: what one leaves, no other finds.
_FINE, _ROUGH, _LINEAR, _MOST = 1e-3, 3e-2, 1e-1, 16
_TINY, _MOST_GAIN = 1e-290, 3.0


@part
def forget_rows(touch: ContactWork, lanes: tuple[int, ...]) -> None:
    """Begins with rows that nothing touches.

    Args:
        touch: rows that are touched; none are afterwards.
        lanes: fixes the width of a row.
    """
    empty_rows(touch, lanes)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        touch.mark[i] = 0
        store(touch.said, i, splat(0.0, lanes), lanes)
        store(touch.missed, i, splat(0.0, lanes), lanes)
    touch.many[0], touch.goal[0] = 0, -1.0


@part
def empty_rows(touch: ContactWork, lanes: tuple[int, ...]) -> None:
    """Takes contacts and grasps off the rows that they touched, before they are looked at again.

    Args:
        touch: rows that are touched; nothing acts on them afterwards.
        lanes: fixes the width of a row.
    """
    zero = splat(0.0, lanes)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        store(touch.push, i, zero, lanes)
        touch.hold[i] = 0.0
        for a in range(3):
            store(touch.stiff, 3 * c + a, zero, lanes)


@part
def touched(touch: ContactWork, i: int) -> int:
    """Place of a row among those that are touched.

    Args:
        touch: rows that are touched; the row becomes one of them.
        i: which row.
    """
    if touch.mark[i] == 0:
        touch.reach[touch.many[0]] = i
        touch.many[0] += 1
        touch.mark[i] = touch.many[0]
    return touch.mark[i] - 1


@part
def say(touch: ContactWork, mean: Float, rhs: Float, lanes: tuple[int, ...]) -> None:
    """Notes what contacts would do at the rate that was found, if they were linear, what comes of that, and its bound.

    Four rows at a time, because each sum waits for the one before.

    Args:
        touch: `said`, `given` and `quick` are written.
        mean: rate that was found, (rows, width) [m/s].
        rhs: right-hand side of the body's system without contacts, likewise [N].
        lanes: fixes the width of a row.
    """
    done = a = b = c = d = p = q = r = s = splat(0.0, lanes)
    for place in range(touch.many[0]):
        i = touch.reach[place]
        rate = load(mean, i, lanes)
        said = load(touch.push, i, lanes) - touch.hold[i] * rate
        store(touch.said, i, said, lanes)
        done = done + said * rate
    rows = mean.shape[0]
    for i in range(0, rows - 3, 4):
        u, v = load(mean, i, lanes), load(mean, i + 1, lanes)
        w, x = load(mean, i + 2, lanes), load(mean, i + 3, lanes)
        a, b = a + u * load(rhs, i, lanes), b + v * load(rhs, i + 1, lanes)
        c, d = c + w * load(rhs, i + 2, lanes), d + x * load(rhs, i + 3, lanes)
        p, q, r, s = upper(p, u * u), upper(q, v * v), upper(r, w * w), upper(s, x * x)
    for i in range(rows - rows % 4, rows):
        u = load(mean, i, lanes)
        a, p = a + u * load(rhs, i, lanes), upper(p, u * u)
    touch.given[0], touch.given[1] = total((a + b) + (c + d)), total(done)
    touch.quick[0] = math.sqrt(total(upper(upper(p, q), upper(r, s))))


@part
def tell(touch: ContactWork, modal: bool, lanes: tuple[int, ...]) -> None:
    """Leaves in `push` what contacts and grasps did on the rows, for the balance and for who asks after the step.

    Args:
        touch: `push` is written.
        modal: whether the body's rows are modes.
        lanes: fixes the width of a row.
    """
    for i in range(touch.found.shape[0] if modal else 0):
        store(touch.push, i, load(touch.found, i, lanes), lanes)
    for c in range(touch.many[0]):
        i = touch.reach[c]
        store(touch.push, i, load(touch.said, i, lanes), lanes)


@part
def _gain(touch: ContactWork, square: float, kept: float) -> float:
    """How much of a correction is made, by how much of what it missed the last one left [Barzilai & Borwein 1988].

    What resists at a corner stands for a matrix of a triangle's corners, of which it is the row sums, so a correction
    by itself comes out too small.

    Args:
        touch: `goal` holds how much of the last was made, and what that missed; both are brought up to date.
        square: what is missed now, in the norm of the inverse diagonal.
        kept: product of that with what was missed before.
    """
    gain, before = 1.0, touch.goal[2]
    if touch.goal[0] >= 0.0 and before > kept:
        gain = min(max(touch.goal[1] * before / (before - kept), 1.0), _MOST_GAIN)
    touch.goal[1], touch.goal[2] = gain, square
    return gain


@part
def correct_near(
    op: Operator, work: Workspace, touch: ContactWork, leaves: float, weighs: bool, cap: int, lanes: tuple[int, ...]
) -> int:
    """Corrects `work.mean` by what contacts do beside what they were said to.

    Args:
        op: the body.
        work: `scale`, `values` and `inverse` as its last solve left them.
        touch: what the last look gathered; `said` gets what contacts do at the new rate, if they are linear.
        leaves: which share of what it should correct it may leave, as far as that can be had.
        weighs: whether to bring `given` up to date.
        cap: on iterations.
        lanes: fixes the width.

    Returns:
        Iterations.
    """
    one = op.entries.shape[0] == 1
    values, scale = op.entries[0] if one else work.values, work.scale[0] if one else 1.0
    zero, axes = splat(0.0, lanes), 3 if len(lanes) > 1 else 1
    reach, own, mark, stiff = touch.reach, work.diagonal, touch.mark, touch.stiff
    direction, inverse, answer, residual, image = touch.along, touch.inverse, touch.found, work.residual, work.image
    count = touch.many[0]
    energy, kept = zero, zero
    for c in range(count):
        i = reach[c]
        for a in range(axes):
            inverse[c, a] = 1.0 / (own[i] + stiff[3 * c + a, a])
        r = load(touch.push, i, lanes) - load(touch.said, i, lanes)
        z = load(inverse, c, lanes) * r
        kept = kept + load(touch.missed, i, lanes) * z
        energy = energy + r * z
        store(touch.missed, i, r, lanes)
        store(residual, i, r, lanes)
        store(direction, i, z, lanes)
        store(answer, i, zero, lanes)
    square = total(energy)
    gain = _gain(touch, square, total(kept))
    if touch.goal[0] < 0.0:  # later ones have less to do
        leaves = min(max(leaves, _FINE), _LINEAR if weighs else _ROUGH)
        touch.goal[0] = max(leaves * leaves * square, _TINY)
    target = touch.goal[0]
    ring, size, iterations, turn = 0, count, 0, 0.0
    while not square <= target and iterations < min(cap, _MOST):
        last = size
        for place in range(size if iterations > 0 else 0):
            i = at(reach, place)
            store(direction, i, load(image, i, lanes) + turn * load(direction, i, lanes), lanes)
        for place in range(ring, last):
            row = at(reach, place)
            for e in range(at(op.pointer, row), at(op.pointer, row + 1)):
                i = at(op.column, e)
                if at(mark, i) == 0:
                    put(mark, i, -1)
                    put(reach, size, i)
                    size += 1
                    store(residual, i, zero, lanes)
                    store(answer, i, zero, lanes)
        ring = last
        curvature = zero
        for place in range(size):
            i = at(reach, place)
            p = load(direction, i, lanes)
            result = at(own, i) * p + scale * row_sum(op, values, i, direction, lanes)
            if place < count:
                for a in range(axes):
                    result = result + direction[i, a] * load(stiff, 3 * place + a, lanes)
            store(image, i, result, lanes)
            curvature = curvature + p * result
        length = square / total(curvature)
        energy = zero
        for place in range(size):
            i = at(reach, place)
            r = load(residual, i, lanes) - length * load(image, i, lanes)
            z = load(inverse, place, lanes) * r if place < count else at(work.inverse, i) * r
            energy = energy + r * z
            store(residual, i, r, lanes)
            store(image, i, z, lanes)
            store(answer, i, load(answer, i, lanes) + length * load(direction, i, lanes), lanes)
        new = total(energy)
        turn, square = new / square, new
        iterations += 1
    # Of a change Δ: `v̂ᵀ b` changes by `Δᵀ b`, and `v̂ᵀ A v̂` by `(A Δ)ᵀ (2 v̂ + Δ)`, where A Δ is what conjugate gradients
    # took off the residual: both on the rows alone that it reached.
    most, given, taken = zero, zero, zero
    for place in range(size):
        i = at(reach, place)
        more, rate, off = gain * load(answer, i, lanes), load(work.mean, i, lanes), zero - load(residual, i, lanes)
        store(work.mean, i, rate + more, lanes)
        store(direction, i, zero, lanes)
        most = upper(most, more * more)
        if place < count:
            missed = load(touch.missed, i, lanes)
            held = zero
            for a in range(axes):
                held = held + answer[i, a] * load(stiff, 3 * place + a, lanes)
            store(touch.said, i, load(touch.said, i, lanes) + gain * (missed - held), lanes)
            off = off + missed - held
        else:
            put(mark, i, 0)
        given = given + more * load(work.rhs, i, lanes)
        taken = taken + off * (2.0 * rate + more)
    if weighs:
        touch.given[0] += total(given)
        touch.given[1] += gain * total(taken) - total(given)
    touch.quick[0] += math.sqrt(total(most) if axes == 3 else 3.0 * total(most))
    return iterations
