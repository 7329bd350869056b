"""What contacts do within a step: a unilateral law that keeps its energy exactly, friction, and the account.

The law is the discrete gradient of `φ(η) = ½ k [η]₊²`: whatever happens within the step, the force does just the work
by which φ changes. Between steps the geometry goes its own way: normals turn, contacts come and go. What a tool has put
into its contacts is therefore kept as one *account*, and the springs of the next step start with no more than is in it.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._kernel import block, part

Int = npt.NDArray[np.int32]

SWEEPS = 200
_SETTLED = 1e-13
# Sweeps before the first guess ahead, sweeps from one to the next, and the slowest shrinking it believes.
_PATIENCE = 4
_BETWEEN = 2
_SLOWEST = 0.999


@part
def _entering(k: float, gap: float, over: float, r: float, a: float) -> float:
    """Force where a gap closes within the step, by the penetration at its end: every term is positive.

    Args:
        k: stiffness [N/m].
        gap: before the step, >= 0 [m].
        over: how far the contact would get in without any force, > 0 [m].
        r: motion that a unit of force takes away [m/N].
        a: damping over the step [1/m].
    """
    s = r * k
    apart = gap - over
    root = math.sqrt(apart * apart + 2.0 * (2.0 + s) * over * gap)
    end = 2.0 * over * gap / (apart + root) if apart > 0.0 else (root - apart) / (2.0 + s)
    if end == 0.0:
        return 0.0
    if s * a > 0.0:
        # end + s/2 (end² / (end + gap) + a end²) = over: convex in end, so Newton from above comes down to it.
        end = min(end, math.sqrt(2.0 * over / (s * a)))
        for _ in range(60):
            ratio = end / (end + gap)
            excess = end - over + 0.5 * s * end * (ratio + a * end)
            move = excess / (1.0 + 0.5 * s * (ratio * (2.0 - ratio) + 2.0 * a * end))
            end -= move
            if not move > 4e-16 * end:
                break
    return 0.5 * k * end * (end / (end + gap)) * (1.0 + a * (end + gap))


@block
def resist(k: float, e: float, free: float, r: float, a: float) -> float:
    """Force of one unilateral contact over a step.

    Solves `d = free - r f`, `f = [φ(e+d) - φ(e)]/d (1 + a d)₊` with `φ(η) = ½ k [η]₊²`. The force rises with d, so
    there is one solution. It is given by terms that do not cancel: neither where the contact hardly moves, nor where it
    is so stiff that it hardly yields.

    Args:
        k: stiffness [N/m].
        e: penetration at the start, negative for a gap [m].
        free: motion over the step without this contact [m].
        r: motion that a unit of force takes away, >= 0 [m/N].
        a: damping over the step, λ/T, >= 0 [1/m].

    Returns:
        f >= 0 [N].
    """
    if e <= 0.0:
        if e + free <= 0.0:
            return 0.0
        return _entering(k, -e, e + free, r, a)
    s = r * k
    if e + free >= 0.5 * s * e * max(1.0 - a * e, 0.0):  # still touching at the end
        if a == 0.0:
            return k * (e + 0.5 * free) / (1.0 + 0.5 * s)
        if 1.0 + a * free <= 0.0:
            return 0.0  # leaves faster than the damper lets it push
        slope, over = 1.0 + 0.5 * s + s * a * e, free - s * e
        d = 2.0 * over / (slope + math.sqrt(max(slope * slope + 2.0 * s * a * over, 0.0)))
        yielding = max(1.0 + a * d, 0.0)
        # The law is exact where little force goes a long way, the rest of the motion where much goes a short way.
        if s * (e + abs(d)) * (1.0 + a * abs(d)) > abs(free) + abs(d):
            return max(free - d, 0.0) / r
        return k * (e + 0.5 * d) * yielding
    c = 0.5 * s * e * e
    b = free + c * a
    root = math.sqrt(b * b + 4.0 * c)
    out = 2.0 * c / (b + root) if b > 0.0 else 0.5 * (root - b)  # how far it moves outwards
    if a * out >= 1.0:
        return 0.0
    if c > out * (abs(free) + out):
        return max(free + out, 0.0) / r
    return 0.5 * k * e * e / out * (1.0 - a * out)


@block
def sweep(
    count: int,
    axes: int,
    depth: Float,
    stiffness: Float,
    loss: Float,
    friction: Float,
    free: Float,
    compliance: Float,
    force: Float,
    trail: Float,
) -> int:
    """Forces of several contacts that feel each other, by Gauss-Seidel.

    Contacts that hardly move apart, as two spheres on a light body, settle by a little less in each sweep. Where the
    changes of two sweeps shrink along each other, the forces are put where that would end [Aitken's process for
    vectors, after Irons & Tuck 1969]; the sweep after it makes them forces again.

    Args:
        count: of contacts.
        axes: elements of a contact: 1 its normal, 3 also two tangents.
        depth: e of each contact, (count,).
        stiffness: (count,).
        loss: λ/T of each contact, (count,).
        friction: Coulomb's coefficient of each contact, (count,).
        free: motion of each element without any contact, (count * axes,).
        compliance: R, (elements, elements).
        force: result, (elements,); the start, too.
        trail: scratch (2, elements): forces before a sweep, their change in it.

    Returns:
        How many sweeps.
    """
    elements, since = count * axes, 0
    for number in range(SWEEPS):
        largest, change = 0.0, 0.0
        for j in range(elements):
            trail[0, j] = force[j]
        for c in range(count):
            n = c * axes
            own = free[n]
            for j in range(elements):
                if j != n:
                    own -= compliance[n, j] * force[j]
            new = resist(stiffness[c], depth[c], own, compliance[n, n], loss[c])
            change = max(change, abs(new - force[n]))
            force[n] = new
            largest = max(largest, new)
            if axes == 3 and friction[c] > 0.0:
                first, second = free[n + 1], free[n + 2]
                for j in range(elements):
                    first -= compliance[n + 1, j] * force[j]
                    second -= compliance[n + 2, j] * force[j]
                beside = max(abs(compliance[n + 1, n + 2]), abs(compliance[n + 2, n + 1]))
                stiffest = max(compliance[n + 1, n + 1], compliance[n + 2, n + 2]) + beside
                p, q = force[n + 1] + first / stiffest, force[n + 2] + second / stiffest
                size, most = math.sqrt(p * p + q * q), friction[c] * new
                if size > most:
                    p, q = p * most / size, q * most / size
                change = max(change, abs(p - force[n + 1]), abs(q - force[n + 2]))
                force[n + 1], force[n + 2] = p, q
        if change <= _SETTLED * largest or elements == 1:
            return number + 1
        along = square = 0.0
        for j in range(elements):
            moved = force[j] - trail[0, j]
            along += moved * trail[1, j]
            square += trail[1, j] * trail[1, j]
            trail[1, j] = moved
        since += 1
        if number + 1 >= _PATIENCE and since >= _BETWEEN and number + 1 < SWEEPS and along > 0.0:
            shrinks = min(along / square, _SLOWEST)
            for j in range(elements):
                force[j] += shrinks / (1.0 - shrinks) * trail[1, j]
            since = 0
    return SWEEPS
