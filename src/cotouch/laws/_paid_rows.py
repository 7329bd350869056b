"""What `paid` does to whole fields: four numbers at a time, and what rests passed over.

A hand acts on few nodes. Of all others the message and what is kept of it are 0, and finding that is all they cost.
Each is called for all whole fours, and for what is left over number by number.
"""

from typing import NamedTuple

from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    A2,
    ALIVE,
    ASKED,
    HAND,
    KEPT,
    M_P,
    M_Q,
    M_V,
    M_W,
    M_WAVE,
    PART_P,
    PART_Q,
    PART_W,
    PAST,
    SLOPE,
    STRETCH,
    SUM2_THERE,
    SUM_THERE,
    TOLD,
    V_BEFORE,
    W_LAST,
    WAVE,
    WAVE_IN,
    WAVE_OUT,
    WISH,
    WISHED,
    X_BEFORE,
    A,
    V,
    X,
)
from cotouch.mechanics import FOUR, load, size, splat, store, total, where

# Lanes of a number that is alone.
ONE = (0,)
# No force, nor integral of it, that anything could tell from none [N, Ns, Ns²].
_NOTHING = 1e-15


class Then(NamedTuple):
    """How x̂ and v̂ of this copy at a time follow from those kept before (x, v) and after it (y, u).

    By Hermite's cubic: a straight line cuts the tops of what swings, and so a copy that swings would be told to go on.
    `x + to_y (y - x) + by_v v + by_u u`, and `v_y (y - x) + v_v v + v_u u`.

    Attributes:
        x: row of the copy's fields where x is.
        v: likewise.
        y: likewise.
        u: likewise.
        to_y: for x̂.
        by_v: likewise [s].
        by_u: likewise [s].
        v_y: for v̂ [1/s].
        v_v: likewise.
        v_u: likewise.
    """

    x: int
    v: int
    y: int
    u: int
    to_y: float
    by_v: float
    by_u: float
    v_y: float
    v_v: float
    v_u: float


@helper
def between(before: int, after: int, share: float, gap: float) -> Then:
    """Between two rows of the past.

    Args:
        before: row before the time, as `past` says.
        after: row after it.
        share: of the way between them.
        gap: between them [s].
    """
    x, v = (X, V) if before < 0 else (PAST + before, PAST + KEPT + before)
    if before == after or gap <= 0.0:
        return Then(x, v, x, v, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    y, u = (X, V) if after < 0 else (PAST + after, PAST + KEPT + after)
    left, fall = 1.0 - share, 3.0 * share * share
    bend, steep = share * left, fall - 2.0 * share
    to_y = share * share * (3.0 - 2.0 * share)
    by_v, by_u = gap * bend * left, -gap * bend * share
    return Then(x, v, y, u, to_y, by_v, by_u, 6.0 * bend / gap, 1.0 - 4.0 * share + fall, steep)


@helper
def place_then(end: End, then: Then, i: int) -> tuple[float, float]:
    """x̂ and v̂ of this copy at that time.

    Args:
        end: of the link.
        then: how they follow.
        i: coordinate.
    """
    own = end.shared
    x, v, u = own[then.x, i], own[then.v, i], own[then.u, i]
    way = own[then.y, i] - x
    x_then = x + then.to_y * way + then.by_v * v + then.by_u * u
    return x_then, then.v_y * way + then.v_v * v + then.v_u * u


@helper
def _receive_wave(end: End, share: float, first: int, last: int, lanes: tuple[int, ...]) -> float:
    there, before, wave, weight = end.received[M_WAVE], end.memory[WAVE_IN], end.memory[WAVE], end.weight
    power = splat(0.0, lanes)
    for r in range(first, last):
        rate = share * (load(there, r, lanes) - load(before, r, lanes))
        store(wave, r, rate, lanes)
        power = power + load(weight, r, lanes) * rate * rate
    return 0.5 * total(power)


@helper
def receive_wave(end: End, share: float) -> float:
    """Takes up what has come by the wave line, and gives its power [W].

    Args:
        end: of the link.
        share: of it in a second [1/s].
    """
    n = end.position.shape[0]
    return _receive_wave(end, share, 0, n // 4, FOUR) + _receive_wave(end, share, n // 4 * 4, n, ONE)


@helper
def _push_wave(end: End, fraction: float, root: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    T, before, wave, push = end.T, end.memory[WAVE_IN], end.memory[WAVE], end.push
    for r in range(first, last):
        rate = fraction * load(wave, r, lanes)
        store(wave, r, rate, lanes)
        store(before, r, load(before, r, lanes) + T * rate, lanes)
        store(push, r, root * rate, lanes)


@helper
def push_wave(end: End, fraction: float, root: float) -> None:
    """Pushes with what has come by the wave line.

    Args:
        end: of the link.
        fraction: of it that may.
        root: √(2b) of the line.
    """
    n = end.position.shape[0]
    _push_wave(end, fraction, root, 0, n // 4, FOUR)
    _push_wave(end, fraction, root, n // 4 * 4, n, ONE)


@helper
def _return_wave(end: End, root: float, first: int, last: int, lanes: tuple[int, ...]) -> float:
    T, wave, out, weight, mean = end.T, end.memory[WAVE], end.memory[WAVE_OUT], end.weight, end.mean
    sent, power = end.sent[M_WAVE], splat(0.0, lanes)
    for r in range(first, last):
        back = root * load(mean, r, lanes) - load(wave, r, lanes)
        gone = load(out, r, lanes) + T * back
        store(out, r, gone, lanes)
        store(sent, r, gone, lanes)
        power = power + load(weight, r, lanes) * back * back
    return 0.5 * total(power)


@helper
def return_wave(end: End, root: float) -> float:
    """Sends back what the copy left of it, and gives its power [W].

    Args:
        end: of the link.
        root: √(2b) of the line.
    """
    n = end.mean.shape[0]
    return _return_wave(end, root, 0, n // 4, FOUR) + _return_wave(end, root, n // 4 * 4, n, ONE)


class Heard(NamedTuple):
    """What is done with the neighbour's hand in a step; the same for all nodes.

    Attributes:
        fresh: whether it is another hand than in the step before.
        taken: whether what the one before did was taken over.
        as_one: whether what touches acts as one.
        follows: whether it is seen anew how its force changes.
        every: of a change of force, 1 over how long it took [1/s].
        part: of a change that is believed.
        ahead: how far the hand is predicted [s].
        expected: share of its change that is expected to go on.
        shift: of the horizon since the last step [s].
        lag: over which A follows [s].
        back: since when the neighbour's hand is made up, where it is [s].
        k: of the hand [N/m].
        damping: likewise [Ns/m].
        hands: how many.
    """

    fresh: bool
    taken: bool
    as_one: bool
    follows: bool
    every: float
    part: float
    ahead: float
    expected: float
    shift: float
    lag: float
    back: float
    k: float
    damping: float
    hands: float


@helper
def _bring_hand(end: End, h: Heard, first: int, last: int, lanes: tuple[int, ...]) -> None:
    T, x, v, own_told, got = end.T, end.position, end.velocity, end.shared[TOLD], end.received
    w_there, p_there, q_there = got[M_W], got[M_P], got[M_Q]
    memory, slopes, w_last, stretch = end.memory, end.memory[SLOPE], end.memory[W_LAST], end.memory[STRETCH]
    a_row, a2_row, alive, hands = memory[A], memory[A2], memory[ALIVE], memory[HAND]
    sums, sums2, part_w, part_p, part_q = (
        memory[SUM_THERE],
        memory[SUM2_THERE],
        memory[PART_W],
        memory[PART_P],
        memory[PART_Q],
    )
    ahead, shift, back, nothing = h.ahead, h.shift, h.back, splat(0.0, lanes)
    for r in range(first, last):
        w_now, p, q = load(w_there, r, lanes), load(p_there, r, lanes), load(q_there, r, lanes)
        mine = load(own_told, r, lanes)
        acts = total(size(w_now) + size(p) + size(q))
        rests = acts + total(size(mine) + load(alive, r, lanes)) == 0.0
        pulled = load(stretch, r, lanes) if h.as_one else nothing
        if rests and not h.taken and total(size(pulled)) == 0.0:
            continue
        slope = load(slopes, r, lanes)
        if h.follows:
            slope = nothing if h.fresh else slope + h.part * (h.every * (w_now - load(w_last, r, lanes)) - slope)
            store(w_last, r, w_now, lanes)
        bend = h.expected * slope
        w = w_now + ahead * bend
        one = p + ahead * (w_now + (0.5 * ahead) * bend)
        two = q + ahead * (p + (0.5 * ahead) * (w_now + (ahead / 3.0) * bend))
        a, aa = (one, two) if h.fresh and not h.taken else (load(a_row, r, lanes), load(a2_row, r, lanes))
        aa = aa + shift * a + (0.5 * shift * shift) * w
        a = a + shift * w
        tracked = w + (2.0 / h.lag) * (one - a) + (1.0 / (h.lag * h.lag)) * (two - aa)
        aa = aa + T * a + (0.5 * T * T) * tracked
        a = a + T * tracked
        hand = tracked
        if h.as_one:
            hand = hand + pulled
        else:
            spring = h.k * load(x, r, lanes) + h.damping * load(v, r, lanes)
            hand = hand - where(size(w_now) + size(p), spring, nothing)
        # Since the last step the sums rose by this; since it is another hand, by what a held force would not do.
        if h.taken:
            more, more2 = one - back * w, two - (0.5 * back * back) * w
        elif h.fresh:
            more, more2 = nothing, nothing
        else:
            before = load(sums, r, lanes)
            more, more2 = one - before, two - load(sums2, r, lanes) - T * before
        store(hands, r, hand - h.hands * mine, lanes)
        kept = total(size(a) + size(aa) + size(slope) + size(one) + size(two))
        if acts == 0.0 and kept < _NOTHING:
            # What has died away is as if it had never been; so it costs nothing, and no number gets too small.
            a, aa, slope, one, two, w, more, more2 = (
                nothing,
                nothing,
                nothing,
                nothing,
                nothing,
                nothing,
                nothing,
                nothing,
            )
        store(alive, r, splat(0.0 if acts == 0.0 and kept < _NOTHING else 1.0, lanes), lanes)
        store(slopes, r, slope, lanes)
        store(a_row, r, a, lanes)
        store(a2_row, r, aa, lanes)
        store(sums, r, one, lanes)
        store(sums2, r, two, lanes)
        store(part_w, r, w, lanes)
        store(part_p, r, more, lanes)
        store(part_q, r, more2, lanes)


@helper
def bring_hand(end: End, h: Heard) -> None:
    """What the neighbour's hand would do here and now, from the integrals of its force.

    Args:
        end: of the link.
        h: what is done with it.
    """
    n = end.position.shape[0]
    _bring_hand(end, h, 0, n // 4, FOUR)
    _bring_hand(end, h, n // 4 * 4, n, ONE)


@helper
def _wish(
    end: End, then: Then, pull: float, damp: float, trust: float, first: int, last: int, lanes: tuple[int, ...]
) -> float:
    weight, hands, wished = end.weight, end.memory[HAND], end.memory[WISHED]
    sample, v_there = end.sample, end.received[M_V]
    xs, vs, ys, us = end.shared[then.x], end.shared[then.v], end.shared[then.y], end.shared[then.u]
    each, square = 1.0 / end.copies, splat(0.0, lanes)
    for r in range(first, last):
        x, v, u = load(xs, r, lanes), load(vs, r, lanes), load(us, r, lanes)
        way = load(ys, r, lanes) - x
        x_then = x + then.to_y * way + then.by_v * v + then.by_u * u
        v_then = then.v_y * way + then.v_v * v + then.v_u * u
        wish = pull * (load(sample, r, lanes) - x_then) + damp * (load(v_there, r, lanes) - v_then)
        hand, w = load(hands, r, lanes), load(weight, r, lanes)
        if total(size(hand)) != 0.0:
            wish = wish + where(w, each * hand / w, splat(0.0, lanes))  # links do not know of tools
        wish = trust * wish
        store(wished, r, wish, lanes)
        square = square + w * wish * wish
    return total(square)


@helper
def wish(end: End, then: Then, pull: float, damp: float, trust: float) -> float:
    """What the link wishes: its share of the hand's force, and what draws the copies together; gives its ‖·‖²_W [N²].

    Args:
        end: of the link.
        then: where this copy was when the neighbour's sample was.
        pull: N for a metre that the copies are apart.
        damp: N for a metre a second.
        trust: from 0 to 1, less for a sample that is too old.
    """
    n = end.position.shape[0]
    fours = _wish(end, then, pull, damp, trust, 0, n // 4, FOUR)
    return fours + _wish(end, then, pull, damp, trust, n // 4 * 4, n, ONE)


@helper
def _add_wish(end: End, capped: float, trust: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    wished, hands, wishes = end.memory[WISHED], end.memory[HAND], end.shared[WISH]
    for r in range(first, last):
        store(wishes, r, load(wishes, r, lanes) + capped * load(wished, r, lanes), lanes)
        hand = load(hands, r, lanes)
        if total(size(hand)) != 0.0:
            store(hands, r, (capped * trust) * hand, lanes)


@helper
def add_wish(end: End, capped: float, trust: float) -> None:
    """Adds what the link wishes to what all links of the copy wish.

    Args:
        end: of the link.
        capped: share of it that a limit of the force leaves.
        trust: as `wish` has it.
    """
    n = end.position.shape[0]
    _add_wish(end, capped, trust, 0, n // 4, FOUR)
    _add_wish(end, capped, trust, n // 4 * 4, n, ONE)


@helper
def _price(end: End, first: int, last: int, lanes: tuple[int, ...]) -> tuple[float, float, float]:
    weight, wishes, velocity = end.weight, end.shared[WISH], end.velocity
    along, wished, speed = splat(0.0, lanes), splat(0.0, lanes), splat(0.0, lanes)
    for r in range(first, last):
        weighed, v = load(weight, r, lanes), load(velocity, r, lanes)
        force = load(wishes, r, lanes)
        along = along + weighed * force * v
        wished = wished + weighed * force * force
        speed = speed + weighed * v * v
    return total(along), total(wished), total(speed)


@helper
def price(end: End) -> tuple[float, float, float]:
    """`⟨wish, v⟩_W`, `‖wish‖²_W` and `‖v‖²_W` [W, N², m²/s²]."""
    n = end.position.shape[0]
    a, b, c = _price(end, 0, n // 4, FOUR)
    d, e, f = _price(end, n // 4 * 4, n, ONE)
    return a + d, b + e, c + f


@helper
def _pay(end: End, fraction: float, b: float, first: int, last: int, lanes: tuple[int, ...]) -> None:
    asked, wishes, velocity, push = end.shared[ASKED], end.shared[WISH], end.velocity, end.push
    for r in range(first, last):
        wish = load(wishes, r, lanes)
        store(asked, r, wish, lanes)
        wish = fraction * wish + b * load(velocity, r, lanes)
        store(wishes, r, wish, lanes)
        store(push, r, load(push, r, lanes) + wish, lanes)


@helper
def pay(end: End, fraction: float, b: float) -> None:
    """Pushes with what of the wish is paid for.

    Args:
        end: the last of the copy's.
        fraction: of the wish.
        b: of the damper beside it [Ns/m].
    """
    n = end.position.shape[0]
    _pay(end, fraction, b, 0, n // 4, FOUR)
    _pay(end, fraction, b, n // 4 * 4, n, ONE)


@helper
def _go_on(end: End, first: int, last: int, lanes: tuple[int, ...]) -> tuple[float, float]:
    own, position, mean, weight = end.shared, end.position, end.mean, end.weight
    x, v, x_before, v_before, wishes = own[X], own[V], own[X_BEFORE], own[V_BEFORE], own[WISH]
    done, speed, half = splat(0.0, lanes), splat(0.0, lanes), 0.5 * end.T
    for r in range(first, last):
        now, weighed = load(mean, r, lanes), load(weight, r, lanes)
        store(x_before, r, load(x, r, lanes), lanes)
        store(v_before, r, load(v, r, lanes), lanes)
        store(x, r, load(position, r, lanes) - half * now, lanes)
        store(v, r, now, lanes)
        done = done + weighed * now * load(wishes, r, lanes)
        speed = speed + weighed * now * now
    return total(done), total(speed)


@helper
def go_on(end: End) -> tuple[float, float]:
    """The newest of the past gets older by a step; gives `⟨wish, v̂⟩_W` and `‖v̂‖²_W` of the step [W, m²/s²]."""
    n = end.mean.shape[0]
    a, b = _go_on(end, 0, n // 4, FOUR)
    c, d = _go_on(end, n // 4 * 4, n, ONE)
    return a + c, b + d


@helper
def _keep(end: End, slot: int, first: int, last: int, lanes: tuple[int, ...]) -> None:
    x, v, position, mean = end.shared[PAST + slot], end.shared[PAST + KEPT + slot], end.position, end.mean
    half = 0.5 * end.T
    for r in range(first, last):
        now = load(mean, r, lanes)
        store(x, r, load(position, r, lanes) - half * now, lanes)
        store(v, r, now, lanes)


@helper
def keep(end: End, slot: int) -> None:
    """Keeps where the copy was in the middle of the step.

    Args:
        end: of the copy.
        slot: row of the past.
    """
    n = end.mean.shape[0]
    _keep(end, slot, 0, n // 4, FOUR)
    _keep(end, slot, n // 4 * 4, n, ONE)
