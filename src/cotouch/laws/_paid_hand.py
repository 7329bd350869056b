"""What an end of `paid` keeps of its copy: the account, the hand as it was identified, and where the copy was."""

from math import sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import helper

# Fields of a copy, and numbers; the past of x̂ and v̂ follows the fields, its times the numbers.
W, WISH, FELT, X, V, X_BEFORE, V_BEFORE, X_RATE, V_RATE, F_RATE, ALL_W, ALL_P, ALL_Q, ASKED, TOUCH, TOLD, WAY = range(
    17
)
PAST, KEPT, EVERY = 17, 128, 0.004
ACCOUNT, TIME, K, LEVEL, EPOCH, XX, XV, VV, XF, VF = range(10)
HELD, COUNT, BRAKE, OWN_B, NEW_K, NEW_B, STEADY = range(10, 17)
ALL_K, ALL_B, ALL_EPOCH, ALL_HANDS = range(17, 21)  # of the hands that all links bring
AS_ONE, GRASPED, ALL_GRASPED, LONGEST, BACK, DEGREE = range(21, 27)
TIMES = 27

# What a hand may be [N/m, Ns/m].
STIFFEST, DAMPEST = 5000.0, 100.0
# A hand is looked at over so long, without what its force and place do evenly over that time, for its own aim moves. It
# must seem the same for so long to be believed, at first and later [s].
_LOOK, _FIRST, _HOLD = 0.02, 0.005, 0.02
# What touches is evened out over so long [s].
_EVEN = 0.005


@helper
def _other(old_k: float, old_b: float, k: float, damping: float) -> bool:
    return abs(k - old_k) > 0.1 * (k + old_k) + 1.0 or abs(damping - old_b) > 0.2 * damping + 1.0


@helper
def _learn(end: End, i: int, dx: float, dv: float, df: float) -> None:
    """Takes up how a force changed with place and speed, less what all of them do evenly."""
    T, own, numbers = end.T, end.shared, end.shared_scalars
    part = min(T / _LOOK, 1.0)
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
def book_copy(end: End) -> None:
    """Once in a step: pays for it, looks at the own hand, and keeps the past."""
    T, own, numbers = end.T, end.shared, end.shared_scalars
    size, cost, b = end.mean.shape[0], 0.0, numbers[BRAKE]
    numbers[TIME] += T
    now = numbers[TIME] - 0.5 * T
    count = int(numbers[COUNT])
    if count == 0 or now - numbers[TIMES + (count - 1) % KEPT] >= max(EVERY, 1.5 * numbers[LONGEST] / KEPT):
        slot = count % KEPT
        numbers[TIMES + slot] = now
        for i in range(size):
            own[PAST + slot, i] = end.position[i] - 0.5 * T * end.mean[i]
            own[PAST + KEPT + slot, i] = end.mean[i]
        numbers[COUNT] += 1.0
    forget = 1.0 - T / _LOOK
    for name in range(XX, VF + 1):
        numbers[name] *= max(forget, 0.0)
    smooth = min(T / _EVEN, 1.0)
    held = touched = strong = 0.0
    for i in range(size):
        own[TOUCH, i] += smooth * (end.touch[i] - own[TOUCH, i])
        touched = max(touched, abs(end.touch[i]), abs(own[TOUCH, i]))
        strong += (end.hand[i] + own[TOUCH, i]) ** 2
    if touched < 1e-6:
        for i in range(size):
            own[TOUCH, i] = 0.0
        touched = 0.0
    as_one = touched > 0.0
    kind = 1.0 if as_one else 0.0
    width = end.width
    for row in range(0, size, width):
        here = 0.0
        for i in range(row, row + width):
            here += (end.hand[i] + own[TOUCH, i]) ** 2
        # Of modes the force itself, for they say where and which way.
        here = sqrt(here) if width > 1 else end.hand[row] + own[TOUCH, row]
        for i in range(row, row + width):
            own[WAY, i] = here / sqrt(strong) if as_one and strong > 0.0 else 0.0
            own[TOLD, i] = end.hand[i] + own[TOUCH, i]
    if as_one:
        for axis in range(width):
            dx = dv = df = 0.0
            for i in range(axis, size, width):
                dx += own[WAY, i] * (own[X, i] - own[X_BEFORE, i])
                dv += own[WAY, i] * (own[V, i] - own[V_BEFORE, i])
                df += own[WAY, i] * (end.hand[i] + end.touch[i] - own[FELT, i])
            _learn(end, axis, dx, dv, df)
    for i in range(size):
        v = end.mean[i]
        middle = end.position[i] - 0.5 * T * v
        force = end.hand[i] + end.touch[i]
        cost += end.weight[i] * v * (own[WISH, i] - b * v)
        if force != 0.0:
            held += 1.0
            # The force is of the step before; so must be what it is compared with, or a hand seems to change with T.
            dx, dv = own[X, i] - own[X_BEFORE, i], own[V, i] - own[V_BEFORE, i]
            df = force - own[FELT, i]
            if not as_one:
                _learn(end, i, dx, dv, df)
        own[X_BEFORE, i], own[V_BEFORE, i] = own[X, i], own[V, i]
        own[X, i], own[V, i], own[FELT, i] = middle, v, force
    if as_one:
        held = min(held, 1.0)
    numbers[ACCOUNT] -= T * cost
    changed = held != numbers[HELD] or kind != numbers[AS_ONE]
    if changed:
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
    for i in range(size):
        w = own[TOLD, i]
        if w != 0.0 and not as_one:
            w += numbers[K] * own[X_BEFORE, i] + numbers[OWN_B] * own[V_BEFORE, i]
        own[W, i] = w
