"""What an end of `paid` keeps of its copy: the account, the hand as it was identified, and where the copy was."""

from math import sqrt

from cotouch.kernels import FOUR, load, size, total
from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    ACCOUNT,
    ACTING,
    AS_ONE,
    BRAKE,
    COUNT,
    DAMPEST,
    EPOCH,
    EVERY,
    F_RATE,
    FELT,
    GRASPED,
    GRASPED_AT,
    HELD,
    KEPT,
    LONGEST,
    NEW_B,
    NEW_K,
    NEWEST,
    OWN_B,
    STEADY,
    STIFFEST,
    TIME,
    TIMES,
    TOLD,
    TOUCH,
    V_BEFORE,
    V_RATE,
    VF,
    VV,
    WAY,
    X_BEFORE,
    X_RATE,
    XF,
    XV,
    XX,
    K,
    V,
    W,
    X,
)
from cotouch.laws._paid_rows import go_on, keep

# A hand is looked at over so long, without what its force and place do evenly over that time, for its own aim moves. It
# must seem the same for so long to be believed, at first and later [s].
_LOOK, _FIRST, _HOLD = 0.02, 0.005, 0.02
# It is looked at over so many steps at least: two numbers are looked for.
_STEPS = 4.0
# What touches is evened out over so long [s].
_EVEN = 0.005


@helper
def _other(old_k: float, old_b: float, k: float, damping: float) -> bool:
    return abs(k - old_k) > 0.1 * (k + old_k) + 1.0 or abs(damping - old_b) > 0.2 * damping + 1.0


@helper
def _learn(end: End, i: int, dx: float, dv: float, df: float) -> None:
    """Takes up how a force changed with place and speed, less what all of them do evenly."""
    T, own, numbers = end.T, end.shared, end.shared_scalars
    part = T / max(_LOOK, _STEPS * T)
    mx, mv, mf = own[X_RATE, i], own[V_RATE, i], own[F_RATE, i]
    own[X_RATE, i] += part * (dx / T - mx)
    own[V_RATE, i] += part * (dv / T - mv)
    own[F_RATE, i] += part * (df / T - mf)
    dx, dv, df = dx - T * mx, dv - T * mv, df - T * mf
    numbers[XX] += dx * dx
    numbers[XV] += dx * dv
    numbers[VV] += dv * dv
    numbers[XF] -= dx * df
    numbers[VF] -= dv * df


@helper
def _acting(end: End) -> int:
    """Lists which fours of numbers hands and tools act on, or did; of all others what is known of them is 0.

    Returns:
        How many there are.
    """
    own, touch, hand, n = end.shared, end.touch, end.hand, end.mean.shape[0]
    acting, even, told, felt, known = own[ACTING], own[TOUCH], own[TOLD], own[FELT], own[W]
    count = 0
    for r in range(n // 4):
        now = size(load(touch, r, FOUR)) + size(load(hand, r, FOUR)) + size(load(even, r, FOUR))
        before = size(load(told, r, FOUR)) + size(load(felt, r, FOUR)) + size(load(known, r, FOUR))
        if total(now + before) != 0.0:
            acting[count] = 4.0 * r
            count += 1
    if n % 4:
        acting[count] = float(n // 4 * 4)
        count += 1
    return count


@helper
def book_copy(end: End) -> None:
    """Once in a step: pays for it, looks at the own hand, and keeps the past."""
    T, own, numbers = end.T, end.shared, end.shared_scalars
    entries, touch, hand = end.mean.shape[0], end.touch, end.hand
    numbers[TIME] += T
    now = numbers[NEWEST] = numbers[TIME] - 0.5 * T
    count = int(numbers[COUNT])
    if count == 0 or now - numbers[TIMES + (count - 1) % KEPT] >= max(EVERY, 1.5 * numbers[LONGEST] / KEPT):
        slot = count % KEPT
        numbers[TIMES + slot] = now
        keep(end, slot)
        numbers[COUNT] += 1.0
    forget = 1.0 - T / max(_LOOK, _STEPS * T)
    for name in range(XX, VF + 1):
        numbers[name] *= forget
    smooth = min(T / _EVEN, 1.0)
    held = touched = strong = 0.0
    acts = _acting(end)
    for n in range(acts):
        for i in range(int(own[ACTING, n]), min(int(own[ACTING, n]) + 4, entries)):
            own[TOUCH, i] += smooth * (touch[i] - own[TOUCH, i])
            touched = max(touched, abs(touch[i]), abs(own[TOUCH, i]))
            strong += (hand[i] + own[TOUCH, i]) ** 2
    if 0.0 < touched < 1e-6:
        for i in range(entries):
            own[TOUCH, i] = 0.0
        touched = 0.0
    as_one = touched > 0.0
    kind = 1.0 if as_one else 0.0
    width = end.width
    for n in range(acts):
        first = int(own[ACTING, n])
        for row in range(first, min(first + 4, entries), width):
            here = 0.0
            for i in range(row, row + width):
                here += (hand[i] + own[TOUCH, i]) ** 2
            # Of modes the force itself, for they say where and which way.
            here = sqrt(here) if width > 1 else hand[row] + own[TOUCH, row]
            for i in range(row, row + width):
                own[WAY, i] = here / sqrt(strong) if as_one and strong > 0.0 else 0.0
                own[TOLD, i] = hand[i] + own[TOUCH, i]
    for axis in range(width if as_one else 0):
        dx = dv = df = 0.0
        for n in range(acts):
            first = int(own[ACTING, n])
            for i in range(first + axis, min(first + 4, entries), width):
                dx += own[WAY, i] * (own[X, i] - own[X_BEFORE, i])
                dv += own[WAY, i] * (own[V, i] - own[V_BEFORE, i])
                df += own[WAY, i] * (hand[i] + touch[i] - own[FELT, i])
        _learn(end, axis, dx, dv, df)
    for n in range(acts):
        for i in range(int(own[ACTING, n]), min(int(own[ACTING, n]) + 4, entries)):
            force = hand[i] + touch[i]
            if force != 0.0:
                held += 1.0
                # It is of the step before; so must be what it is compared with, or a hand seems to change with T.
                if not as_one:
                    _learn(end, i, own[X, i] - own[X_BEFORE, i], own[V, i] - own[V_BEFORE, i], force - own[FELT, i])
            own[FELT, i] = force
    done, speed = go_on(end)
    numbers[ACCOUNT] -= T * (done - numbers[BRAKE] * speed)
    if as_one:
        held = min(held, 1.0)
    changed = held != numbers[HELD] or kind != numbers[AS_ONE]
    if changed:
        # What one lets go of, or only touches, is as before.
        if held > 0.0 and not as_one:
            numbers[GRASPED_AT] = now
        for name in range(XX, VF + 1):
            numbers[name] = 0.0
        numbers[NEW_K] = numbers[NEW_B] = 0.0
    elif held > 0.0:
        xx, xv, vv = numbers[XX], numbers[XV], numbers[VV]
        det = xx * vv - xv * xv
        if det > 1e-6 * xx * vv and det > 0.0:
            k = (vv * numbers[XF] - xv * numbers[VF]) / det
            damping = (xx * numbers[VF] - xv * numbers[XF]) / det
            if not (0.0 <= k <= STIFFEST and 0.0 <= damping <= DAMPEST):
                numbers[STEADY] = 0.0
            elif _other(numbers[NEW_K], numbers[NEW_B], k, damping):
                numbers[NEW_K], numbers[NEW_B], numbers[STEADY] = k, damping, 0.0
            else:
                numbers[STEADY] += T
    # What touches is not made up: a copy that its own user presses meanwhile would be pushed against that one.
    numbers[GRASPED] = 1.0 if changed and (held == 0.0 or not as_one) else 0.0
    numbers[HELD], numbers[AS_ONE] = held, kind
    k, damping = numbers[NEW_K], numbers[NEW_B]
    jump = numbers[STEADY] >= (_FIRST if numbers[K] == 0.0 else _HOLD) and _other(
        numbers[K], numbers[OWN_B], k, damping
    )
    # The force alone is sent of what acts as one, so another spring is no other force.
    if changed or jump:
        numbers[K], numbers[OWN_B] = k, damping
    if changed or (jump and not as_one):
        numbers[EPOCH] += 1.0
    for n in range(acts):
        for i in range(int(own[ACTING, n]), min(int(own[ACTING, n]) + 4, entries)):
            w = own[TOLD, i]
            if w != 0.0 and not as_one:
                w += numbers[K] * own[X_BEFORE, i] + numbers[OWN_B] * own[V_BEFORE, i]
            own[W, i] = w
