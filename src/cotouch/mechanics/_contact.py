"""What contacts do within a step: a unilateral law that keeps its energy exactly, friction, and the account.

The law is the discrete gradient of `φ(η) = ½ k [η]₊²`: whatever happens within the step, the force does just the work
by which φ changes. Between steps the geometry goes its own way: normals turn, contacts come and go. What a tool has put
into its contacts is therefore kept as one *account*, and the springs of the next step start with no more than is in it.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._kernel import block

Float = npt.NDArray[np.float64]
Int = npt.NDArray[np.int32]

SWEEPS = 200
_SETTLED = 1e-13


@block
def _law(k: float, e: float, d: float, a: float) -> float:
    """Mean force while the penetration goes from e to e + d: `[φ(e+d) - φ(e)]/d (1 + a d)₊` [N]."""
    end = e + d
    if e > 0.0:
        force = k * (e + 0.5 * d) if end >= 0.0 else -0.5 * k * e * e / d
    else:
        force = 0.5 * k * end * end / d if end > 0.0 else 0.0
    return force * max(1.0 + a * d, 0.0)


@block
def _undamped(k: float, e: float, free: float, r: float) -> float:
    """Motion d of the contact in closed form for no damping, without cancellation (theory: contact, touch)."""
    if e > 0.0:
        d = (free - r * k * e) / (1.0 + 0.5 * r * k)
        if e + d >= 0.0:
            return d
        return 0.5 * (free - math.sqrt(free * free + 2.0 * r * k * e * e))
    a = 1.0 + 0.5 * r * k
    b = r * k * e - free  # <= -(e + free) < 0 here, because e + free > 0 and e <= 0
    c = 0.5 * r * k * e * e
    return (-b + math.sqrt(max(b * b - 4.0 * a * c, 0.0))) / (2.0 * a)


@block
def resist(k: float, e: float, free: float, r: float, a: float) -> float:
    """Force of one unilateral contact over a step.

    Solves `d = free - r f`, `f = [φ(e+d) - φ(e)]/d (1 + a d)₊`.

    Args:
        k: stiffness [N/m].
        e: penetration at the start, negative for a gap [m].
        free: motion over the step without this contact [m].
        r: motion that a unit of force takes away, > 0 [m/N].
        a: damping over the step, λ/T, >= 0 [1/m].

    Returns:
        f >= 0 [N].
    """
    if e <= 0.0 and e + free <= 0.0:
        return 0.0
    d = _undamped(k, e, free, r)
    if a > 0.0:
        # free - d - r f(d) falls as d rises: Newton from the undamped motion, kept in a shrinking bracket.
        high = free
        low = free - r * _law(k, e, free, a)
        d = min(max(d, low), high)
        for _ in range(80):
            excess = d - free + r * _law(k, e, d, a)
            if excess > 0.0:
                high = d
            else:
                low = d
            step = 1e-7 * (abs(d) + abs(e) + 1e-12)
            slope = 1.0 + r * (_law(k, e, d + step, a) - _law(k, e, d, a)) / step
            new = d - excess / slope
            if not low < new < high:
                new = 0.5 * (low + high)
            if abs(new - d) <= 1e-16 * (abs(d) + abs(e)) or new == low or new == high:
                break
            d = new
    if d == 0.0:
        return k * max(e, 0.0)
    # Where the contact moves hardly at all, free - d cancels and the law itself is exact; where r is tiny, the reverse.
    force = _law(k, e, d, a)
    return max(0.0, force)


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
) -> int:
    """Forces of several contacts that feel each other, by Gauss-Seidel.

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

    Returns:
        How many sweeps.
    """
    elements = count * axes
    for number in range(SWEEPS):
        largest, change = 0.0, 0.0
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
                p, q = 0.0, 0.0
                first, second = free[n + 1], free[n + 2]
                for j in range(elements):
                    first -= compliance[n + 1, j] * force[j]
                    second -= compliance[n + 2, j] * force[j]
                stiffest = max(compliance[n + 1, n + 1] + abs(compliance[n + 1, n + 2]),
                               compliance[n + 2, n + 2] + abs(compliance[n + 1, n + 2]))
                p, q = force[n + 1] + first / stiffest, force[n + 2] + second / stiffest
                size, most = math.sqrt(p * p + q * q), friction[c] * new
                if size > most:
                    p, q = p * most / size, q * most / size
                change = max(change, abs(p - force[n + 1]), abs(q - force[n + 2]))
                force[n + 1], force[n + 2] = p, q
        if change <= _SETTLED * largest or elements == 1:
            return number + 1
    return SWEEPS
