"""`paid`: hands' forces are exchanged and predicted as boldly as one likes; an account makes it passive.

With share 1/N of the body, a copy that felt all hands would move as the whole body does, so copy i wishes the force
`(1/N) Σ_j (F_j - f_i)`, F_j what hand j would do here and now: a spring and damper that its own end identifies, to a
place whose integrals travel. In a tree a copy tells each neighbour of the hands that its other links bring, too:
springs, dampers and what is left of forces add up. Samples of the copies draw what is left of their differences
together, compared with where this copy was at the same time, so common motion has no drag.

The wish is paid from an account H. For every v̂, `T v̂ᵀ(wish + b*v - b*v̂) ≤ T‖wish + b*v‖²/(4b*) = H` by choice of b*:
whatever body, hand or contact do, H stays above zero, and all copies together make no more than their seeds. A weak
wave line, passive by itself, lies beside it, or copies whose accounts are dry could stay apart for ever.
"""

from math import inf, sqrt

from cotouch.laws._end import End, Float, copy
from cotouch.laws._helper import helper
from cotouch.laws._law import FORCE, Facts, Law, Parameter, register
from cotouch.laws._paid_hand import (
    ACCOUNT,
    ALL_B,
    ALL_EPOCH,
    ALL_HANDS,
    ALL_K,
    ALL_P,
    ALL_Q,
    ALL_W,
    AS_ONE,
    BRAKE,
    COUNT,
    DAMPEST,
    EPOCH,
    KEPT,
    LEVEL,
    OWN_B,
    PAST,
    STIFFEST,
    TIME,
    TIMES,
    TOLD,
    WAY,
    WISH,
    X_BEFORE,
    K,
    P,
    Q,
    V,
    W,
    X,
    book_copy,
)

# Fields of an end, and numbers.
_IN, _OUT, _WAVE, _A, _AA, _WISHED, _W_BEFORE, _SLOPE, _PART_W, _STRETCH = range(10)
_E_IN, _E_OUT, _AGE, _CREDITED, _GIVEN, _KNOWN, _HORIZON, _STAMP, _SPAN = range(9)
_PART_K, _PART_B, _PART_EPOCH, _PART_HANDS = range(9, 13)
_EVENLY = 13  # and one for each other axis
# A message.
_M_WAVE, _M_W, _M_P, _M_Q, _M_V, _M_WAY = range(6)
_M_E, _M_K, _M_B, _M_EPOCH, _M_GIVEN, _M_T, _M_HANDS, _M_AS_ONE = range(8)
_SEED, _FLOOR, _BETA, _GK, _GD, _LINE, _MASS, _AHEAD, _FORCE_LIMIT, _RELAY = range(10)
# So long is seen how a hand's force changes [s].
_SMOOTH = 0.03
# Of any force, and of its integrals, that is told on [N, Ns, Ns²].
_MOST = 1e5


@helper
def _past(end: End, when: float) -> tuple[int, int, float, float]:
    """Where a time lies in what is kept of this copy: rows before and after it, share between them, and its length."""
    numbers = end.shared_scalars
    count = int(numbers[COUNT])
    after, late = -1, numbers[TIME] - 0.5 * end.T
    for back in range(1, min(count, KEPT) + 1):
        slot = (count - back) % KEPT
        time = numbers[TIMES + slot]
        if time <= when:
            gap = late - time
            return slot, after, (when - time) / gap if gap > 0.0 else 0.0, gap
        after, late = slot, time
    return after, after, 0.0, 0.0


@helper
def _then(end: End, before: int, after: int, share: float, gap: float, i: int) -> tuple[float, float]:
    """x̂ and v̂ of this copy at such a time; row -1 is the newest.

    By Hermite's cubic: a straight line cuts the tops of what swings, and so a copy that swings would be told to go on.
    """
    own = end.shared
    x, v = (own[X, i], own[V, i]) if before < 0 else (own[PAST + before, i], own[PAST + KEPT + before, i])
    if before == after:
        return x, v
    y, u = (own[X, i], own[V, i]) if after < 0 else (own[PAST + after, i], own[PAST + KEPT + after, i])
    if gap <= 0.0:
        return x, v
    left = 1.0 - share
    bend, fall = share * left, 3.0 * share * share
    x_then = x + (y - x) * share * share * (3.0 - 2.0 * share) + gap * bend * (left * v - share * u)
    v_then = 6.0 * bend * (y - x) / gap + (1.0 - 4.0 * share + fall) * v + (fall - 2.0 * share) * u
    return x_then, v_then


def _before(end: End) -> None:
    T, x, v, own, numbers = end.T, end.position, end.velocity, end.shared, end.shared_scalars
    kept, got, told, p = end.scalars, end.received, end.received_scalars, end.parameters
    size, heard = x.shape[0], end.sample_index >= 0
    if end.first:
        if end.step == 0:
            copy(own[X], x)
            copy(own[X_BEFORE], x)
        for i in range(size):
            own[WISH, i] = own[ALL_W, i] = own[ALL_P, i] = own[ALL_Q, i] = 0.0
        numbers[LEVEL] = 0.0
        for name in range(ALL_K, ALL_HANDS + 1):
            numbers[name] = 0.0
    if end.step == 0:
        numbers[ACCOUNT] += p[_SEED]
    numbers[LEVEL] += p[_SEED]
    # The wave line.
    root, span = sqrt(2.0 * p[_LINE]), max(0.02, T)
    if end.step == 0:
        for i in range(size):
            end.memory[_IN, i] = end.memory[_OUT, i] = 0.5 * root * x[i]
    power = 0.0
    for i in range(size):
        wave = (got[_M_WAVE, i] - end.memory[_IN, i]) / span if heard else 0.0
        end.memory[_WAVE, i] = wave
        power += 0.5 * end.weight[i] * wave * wave
    most = max(told[_M_E] - kept[_E_IN], 0.0)
    fraction = sqrt(most / (power * T)) if power * T > most else 1.0
    push = root * sqrt(2.0 * power)
    if fraction * push > p[_FORCE_LIMIT]:
        fraction = p[_FORCE_LIMIT] / push
    left = max(p[_FORCE_LIMIT] - fraction * push, 0.0)
    kept[_E_IN] += fraction * fraction * power * T
    for i in range(size):
        end.memory[_WAVE, i] *= fraction
        end.memory[_IN, i] += end.memory[_WAVE, i] * T
        end.push[i] = root * end.memory[_WAVE, i]
    end.gains[0], end.gains[1] = 0.0, p[_LINE]
    # What the neighbour's hand would do here, and where the neighbour is.
    numbers[ACCOUNT] += max(told[_M_GIVEN] - kept[_CREDITED], 0.0)
    kept[_CREDITED] = max(kept[_CREDITED], told[_M_GIVEN])
    kept[_PART_HANDS] = 0.0
    if heard:
        kept[_AGE] += (end.age - kept[_AGE]) * (min(T / 0.3, 1.0) if kept[_AGE] > 0.0 else 1.0)
        mean = max(kept[_AGE], p[_FLOOR], 2.0 * T)
        stale = 3.0 * mean + 0.05
        trust = min(max((1.6 - end.age / stale) / 0.6, 0.0), 1.0)
        theirs = max(told[_M_T], 0.0)  # length of the neighbour's steps, unless it lies
        ahead = max(end.age - 0.25 * kept[_AGE] - 0.5 * theirs, 0.0)
        lag = max(0.005, 0.5 * mean)
        fresh = kept[_KNOWN] != told[_M_EPOCH]
        kept[_KNOWN] = told[_M_EPOCH]
        when = numbers[TIME] + T - end.age
        before, after, between, gap = _past(end, when)
        # A is of this time after the start of the step. Where that changes, A must, or T and age would seem forces.
        horizon = T - 0.25 * kept[_AGE]
        shift = 0.0 if fresh else horizon - kept[_HORIZON]
        kept[_HORIZON] = horizon
        gain, square = p[_MASS] / end.copies, 0.0
        # How fast the hand's force changes, so that it is not held where it was.
        if fresh:
            kept[_STAMP], kept[_SPAN] = when, 0.0
        passed = when - kept[_STAMP]
        if fresh or passed > 0.25 * theirs:
            kept[_STAMP] = when
            kept[_SPAN] += passed
            share = min(passed / min(kept[_SPAN], _SMOOTH), 1.0) if passed > 0.0 else 0.0
            for i in range(size):
                if fresh:
                    end.memory[_SLOPE, i] = 0.0
                else:
                    rate = (got[_M_W, i] - end.memory[_W_BEFORE, i]) / passed
                    end.memory[_SLOPE, i] += share * (rate - end.memory[_SLOPE, i])
                end.memory[_W_BEFORE, i] = got[_M_W, i]
        # What touches goes on as it did, and pulls this copy to where its own is, over what it acts on.
        as_one, width = told[_M_AS_ONE] > 0.0, end.width
        # Its force is late: what swings would be pushed on by it. So it is taken to change as its spring says of what
        # this copy did since, less what is done evenly: that is the aim's, and a spring against it would be a drag.
        since = numbers[TIME] + 0.5 * T - when
        for axis in range(width if as_one else 0):
            stretch = moved = faster = 0.0
            for i in range(axis, size, width):
                way = got[_M_WAY, i]
                x_then, v_then = _then(end, before, after, between, gap, i)
                stretch += way * (told[_M_K] * (end.sample[i] - x_then) + told[_M_B] * (got[_M_V, i] - v_then))
                moved += way * (x[i] + 0.5 * T * own[V, i] - x_then)
                faster += way * (own[V, i] - v_then)
            if since > 0.0:
                part = 1.0 if fresh else min(T / _SMOOTH, 1.0)
                kept[_EVENLY + axis] += part * (moved / since - kept[_EVENLY + axis])
                stretch -= told[_M_K] * (moved - since * kept[_EVENLY + axis]) + told[_M_B] * faster
            for i in range(axis, size, width):
                end.memory[_STRETCH, i] = got[_M_WAY, i] * stretch
        for i in range(size):
            then, slope = got[_M_W, i], p[_AHEAD] * end.memory[_SLOPE, i]
            w = then + ahead * slope
            first = got[_M_P, i] + ahead * (then + 0.5 * ahead * slope)
            second = got[_M_Q, i] + ahead * (got[_M_P, i] + 0.5 * ahead * (then + ahead * slope / 3.0))
            if fresh:
                end.memory[_A, i], end.memory[_AA, i] = first, second
            a = end.memory[_A, i] + shift * w
            aa = end.memory[_AA, i] + shift * end.memory[_A, i] + 0.5 * shift * shift * w
            tracked = w + 2.0 / lag * (first - a) + (second - aa) / (lag * lag)
            end.memory[_AA, i] = aa + T * a + 0.5 * T * T * tracked
            end.memory[_A, i] = a + T * tracked
            holds = got[_M_W, i] != 0.0 or got[_M_P, i] != 0.0
            hand = tracked
            if as_one:
                hand += end.memory[_STRETCH, i]
            elif holds:
                hand -= told[_M_K] * x[i] + told[_M_B] * v[i]
            end.memory[_PART_W, i] = tracked
            wish = (hand - told[_M_HANDS] * own[TOLD, i]) / end.copies / end.weight[i]
            x_then, v_then = _then(end, before, after, between, gap, i)
            away, slip = end.sample[i] - x_then, got[_M_V, i] - v_then
            wish += gain * (p[_GK] * away / (mean * mean) + p[_GD] * slip / mean)
            wish *= trust
            end.memory[_WISHED, i] = wish
            square += end.weight[i] * wish * wish
        force = sqrt(square)
        capped = left / force if force > left else 1.0
        for i in range(size):
            own[WISH, i] += capped * end.memory[_WISHED, i]
        if p[_RELAY] > 0.0 and trust > 0.0 and _credible(end, told):
            kept[_PART_K], kept[_PART_B], kept[_PART_HANDS] = told[_M_K], told[_M_B], told[_M_HANDS]
            kept[_PART_EPOCH] = told[_M_EPOCH] + 1.0
            _bring(end)
    if not end.last:
        return
    # The payment, on the last of the copy's links.
    along = wished = speed = 0.0
    for i in range(size):
        along += end.weight[i] * own[WISH, i] * v[i]
        wished += end.weight[i] * own[WISH, i] * own[WISH, i]
        speed += end.weight[i] * v[i] * v[i]
    H = max(numbers[ACCOUNT], 0.0)
    fraction = 1.0
    price = T * (along + sqrt(wished * speed))
    if price > 2.0 * H:
        fraction = 2.0 * H / price
    along, wished = fraction * along, fraction * fraction * wished
    root = sqrt(max((2.0 * H - T * along) ** 2 - T * T * wished * speed, 0.0))
    room = 2.0 * H - T * along + root
    b = T * wished / room if room > 0.0 and wished > 0.0 else 0.0
    if b > 1e4:
        fraction = b = 0.0
    for i in range(size):
        own[WISH, i] = fraction * own[WISH, i] + b * v[i]
        end.push[i] += own[WISH, i]
    floor = 0.5 * numbers[LEVEL]
    b += p[_BETA] * max(1.0 - H / floor, 0.0) if floor > 0.0 else p[_BETA]
    numbers[BRAKE] = b
    end.gains[1] += b


@helper
def _credible(end: End, told: Float) -> bool:
    """Whether hands are what hands can be, so that what a liar makes up is not told on."""
    most = 0.0
    for i in range(end.position.shape[0]):
        most = max(most, abs(end.memory[_PART_W, i]), abs(end.memory[_A, i]), abs(end.memory[_AA, i]))
    hands = told[_M_HANDS]
    stiff = 0.0 <= told[_M_K] <= STIFFEST * hands and 0.0 <= told[_M_B] <= DAMPEST * hands
    return stiff and 0.0 <= hands <= end.copies and most <= _MOST


@helper
def _bring(end: End) -> None:
    """Adds the hands that this link brings to those of all links."""
    own, numbers, memory, kept = end.shared, end.shared_scalars, end.memory, end.scalars
    for i in range(end.position.shape[0]):
        own[ALL_W, i] += memory[_PART_W, i]
        own[ALL_P, i] += memory[_A, i]
        own[ALL_Q, i] += memory[_AA, i]
    for name in range(4):
        numbers[ALL_K + name] += kept[_PART_K + name]


def _after(end: End) -> None:
    T, own, numbers, kept, p = end.T, end.shared, end.shared_scalars, end.scalars, end.parameters
    size = end.mean.shape[0]
    root, power = sqrt(2.0 * p[_LINE]), 0.0
    for i in range(size):
        back = root * end.mean[i] - end.memory[_WAVE, i]
        end.memory[_OUT, i] += back * T
        power += 0.5 * end.weight[i] * back * back
        end.sent[_M_WAVE, i] = end.memory[_OUT, i]
    kept[_E_OUT] += power * T
    end.sent_scalars[_M_E] = kept[_E_OUT]
    if end.first:
        book_copy(end)
    spare = max(numbers[ACCOUNT] - numbers[LEVEL], 0.0)
    given = spare if end.last else 0.5 * spare
    numbers[ACCOUNT] -= given
    kept[_GIVEN] += given
    for i in range(size):
        end.sent[_M_W, i], end.sent[_M_P, i], end.sent[_M_Q, i] = own[W, i], own[P, i], own[Q, i]
        end.sent[_M_V, i], end.sent[_M_WAY, i] = end.mean[i], own[WAY, i]
    end.sent_scalars[_M_K], end.sent_scalars[_M_B] = numbers[K], numbers[OWN_B]
    end.sent_scalars[_M_EPOCH], end.sent_scalars[_M_GIVEN] = numbers[EPOCH], kept[_GIVEN]
    end.sent_scalars[_M_T], end.sent_scalars[_M_HANDS] = T, 1.0
    end.sent_scalars[_M_AS_ONE] = numbers[AS_ONE]
    share = p[_RELAY]
    if share > 0.0:
        # In a tree, what the other links bring comes to the neighbour by this one only.
        mine = 1.0 if kept[_PART_HANDS] > 0.0 else 0.0
        for i in range(size):
            end.sent[_M_W, i] += share * (own[ALL_W, i] - mine * end.memory[_PART_W, i])
            end.sent[_M_P, i] += share * (own[ALL_P, i] - mine * end.memory[_A, i])
            end.sent[_M_Q, i] += share * (own[ALL_Q, i] - mine * end.memory[_AA, i])
        end.sent_scalars[_M_K] += share * (numbers[ALL_K] - mine * kept[_PART_K])
        end.sent_scalars[_M_B] += share * (numbers[ALL_B] - mine * kept[_PART_B])
        end.sent_scalars[_M_EPOCH] += numbers[ALL_EPOCH] - mine * kept[_PART_EPOCH]
        end.sent_scalars[_M_HANDS] += share * (numbers[ALL_HANDS] - mine * kept[_PART_HANDS])


def _share(facts: Facts) -> float:
    return 0.02 / facts.degree  # of a copy, whatever its body: so much nobody notices


def _mass(facts: Facts) -> float:
    return facts.mass / (facts.degree + 1) / sqrt(facts.rows)


def _relays(facts: Facts) -> float:
    return float(facts.tree and facts.rows == 1)  # of a soft body, the sum of springs says not where they hold


def _line(facts: Facts) -> float:
    return 0.2 / max(facts.degree, facts.degree_back) / facts.rows  # the same at both ends, or copies rest apart


PAID = register(
    Law(
        name="paid",
        before=_before,
        after=_after,
        source="docs/laws.md",
        parameters=(
            Parameter(name="seed", meaning="what an end brings to its copy's account [J]", default=_share),
            Parameter(name="floor", meaning="least age that copies are drawn together over [s]", default=0.005),
            Parameter(name="brake", meaning="damper that fills an empty account [Ns/m]", default=10.0),
            Parameter(name="pull", meaning="g_k, how strongly copies are drawn together", default=0.04),
            Parameter(name="damp", meaning="g_d, how strongly their speeds are", default=0.35),
            Parameter(name="line", meaning="impedance of the wave line beside it [Ns/m]", default=_line),
            Parameter(name="mass", meaning="that copies are drawn together with [kg]", default=_mass),
            Parameter(name="ahead", meaning="share of a hand's change of force that is expected to go on", default=0.5),
            Parameter(name=FORCE, meaning="most that a neighbour may push with [N]", default=inf),
            Parameter(
                name="relay",
                meaning="share of hands from other links that it tells of; only in trees, else some count twice",
                default=_relays,
                most=1.0,
                tuned=False,
            ),
        ),
        sends=("U_out", "w", "P", "Q", "v", "way"),
        sends_scalars=("E_out", "k", "b", "epoch", "given", "T", "hands", "as one"),
        keeps=("U_in", "U_out", "s", "A", "A2", "wish", "w before", "slope", "part w", "stretch"),
        keeps_scalars=(
            *("E_in", "E_out", "age", "credited", "given", "epoch", "horizon", "stamp", "span"),
            *("part k", "part b", "part epoch", "part hands"),
            *(f"evenly {axis}" for axis in range(4)),
        ),
        fractions=(
            *("w", "P", "Q", "wish", "f", "x", "v", "x before", "v before"),
            *("x rate", "v rate", "f rate", "all w", "all P", "all Q", "touch", "told", "way"),
            *(f"{name}{k}" for name in ("x", "v") for k in range(KEPT)),
        ),
        shares_scalars=(
            *("account", "time", "k", "level", "epoch", "xx", "xv", "vv"),
            *("xf", "vf", "held", "count", "brake", "b", "new k", "new b", "steady"),
            *("all k", "all b", "all epoch", "all hands", "as one"),
            *(f"t{k}" for k in range(KEPT)),
        ),
        sums=("U_out", "P", "Q"),
        energies=("E_out", "given"),
        length="T",
        counts=("epoch", "hands", "as one"),
        store=("account", "level"),
        feels=True,
        seed="seed",
        dragless=True,
    )
)
