"""What an end of `paid` makes of what it heard: the neighbour's hand here and now, and what the link wishes.

A hand acts on few nodes. Of all others the message and what is kept of it are 0, and finding that is all they cost.
"""

from typing import NamedTuple

from cotouch.kernels import FOUR, load, size, splat, store, total, where
from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    A2,
    ALIVE,
    GRIP,
    GUESS,
    HAND,
    KEPT,
    LIGHTEST,
    M_B,
    M_K,
    M_P,
    M_Q,
    M_V,
    M_W,
    PART_P,
    PART_Q,
    PART_W,
    PAST,
    SLOPE,
    STRETCH,
    SUM2_THERE,
    SUM_THERE,
    TOLD,
    W_LAST,
    WISH,
    WISHED,
    A,
    V,
    X,
)
from cotouch.laws._paid_rows import NOTHING, ONE

# A hand elsewhere resists a copy by where that was and how fast at the step's start, so a row swings up if the hand's
# spring and damper would more than stop it in a step: ½T (b + ½T k) of more than its mass. What is more than this share
# of it follows as if it were in step with the row. A share of 1/N of hand and mass is the same.
_EASY = 0.25


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
    """Between two rows of the past, or on from the newest as it went.

    Args:
        before: row before the time, as `past` says.
        after: row after it.
        share: of the way between them.
        gap: between them [s].
    """
    x, v = (X, V) if before < 0 else (PAST + before, PAST + KEPT + before)
    if before == after or gap <= 0.0:
        return Then(x, v, x, v, 0.0, share * gap, 0.0, 0.0, 1.0, 0.0)
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
        at_once: share of how both resist this copy that is felt in this step.
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
    at_once: float
    hands: float


@helper
def at_once(end: End) -> float:
    """Share of how the neighbour's hand resists this copy that it feels in this step; the rest follows.

    Args:
        end: of the link.
    """
    T, told, mass = end.T, end.received_scalars, end.parameters[LIGHTEST]
    grip = 0.5 * T * (told[M_B] + 0.5 * T * told[M_K])
    return mass / (mass + max(grip - _EASY * mass, 0.0)) if mass > 0.0 else 1.0


@helper
def _bring_hand(end: End, h: Heard, first: int, last: int, lanes: tuple[int, ...]) -> float:
    T, x, v, own_told, got = end.T, end.position, end.velocity, end.shared[TOLD], end.received
    w_there, p_there, q_there = got[M_W], got[M_P], got[M_Q]
    memory, slopes, w_last, stretch = end.memory, end.memory[SLOPE], end.memory[W_LAST], end.memory[STRETCH]
    a_row, a2_row, alive, hands, guesses = memory[A], memory[A2], memory[ALIVE], memory[HAND], memory[GUESS]
    sums, sums2, part_w, part_p, part_q = (
        memory[SUM_THERE],
        memory[SUM2_THERE],
        memory[PART_W],
        memory[PART_P],
        memory[PART_Q],
    )
    grips = memory[GRIP]
    ahead, shift, back, nothing = h.ahead, h.shift, h.back, splat(0.0, lanes)
    told = 0.0
    for r in range(first, last):
        w_now, p, q = load(w_there, r, lanes), load(p_there, r, lanes), load(q_there, r, lanes)
        mine = load(own_told, r, lanes)
        acts = total(size(w_now) + size(p) + size(q))
        told += acts
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
            # Where the copy will be in the middle of the step: at its start, k T/2 is lacking of the hand's damping.
            spring = h.k * load(x, r, lanes) + (h.damping + 0.5 * T * h.k) * load(v, r, lanes)
            if h.at_once < 1.0 and not h.fresh:
                spring = h.at_once * spring + (1.0 - h.at_once) * load(grips, r, lanes)
            store(grips, r, spring, lanes)
            hand = hand - where(size(w_now) + size(p), spring, nothing)
        # Since the last step the sums rose by this; since it is another hand, by what a held force would not do.
        if h.taken:
            more, more2 = one - back * w, two - (0.5 * back * back) * w
        elif h.fresh:
            more, more2 = nothing, nothing
        else:
            before = load(sums, r, lanes)
            more, more2 = one - before, two - load(sums2, r, lanes) - T * before
        hand = hand - h.hands * mine
        store(hands, r, hand, lanes)
        store(guesses, r, hand, lanes)
        kept = total(size(a) + size(aa) + size(slope) + size(one) + size(two))
        if acts == 0.0 and kept < NOTHING:
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
        store(alive, r, splat(0.0 if acts == 0.0 and kept < NOTHING else 1.0, lanes), lanes)
        store(slopes, r, slope, lanes)
        store(a_row, r, a, lanes)
        store(a2_row, r, aa, lanes)
        store(sums, r, one, lanes)
        store(sums2, r, two, lanes)
        store(part_w, r, w, lanes)
        store(part_p, r, more, lanes)
        store(part_q, r, more2, lanes)
    return told


@helper
def bring_hand(end: End, h: Heard) -> bool:
    """What the neighbour's hand would do here and now, from the integrals of its force.

    Args:
        end: of the link.
        h: what is done with it.

    Returns:
        Whether there is any.
    """
    n = end.position.shape[0]
    return _bring_hand(end, h, 0, n // 4, FOUR) + _bring_hand(end, h, n // 4 * 4, n, ONE) > 0.0


@helper
def _wish(
    end: End,
    then: Then,
    pull: float,
    damp: float,
    trust: float,
    part: float,
    behind: float,
    first: int,
    last: int,
    lanes: tuple[int, ...],
) -> float:
    weight, hands, wished = end.weight, end.memory[HAND], end.memory[WISHED]
    sample, v_there = end.sample, end.received[M_V]
    xs, vs, ys, us = end.shared[then.x], end.shared[then.v], end.shared[then.y], end.shared[then.u]
    each, square = part / end.copies, splat(0.0, lanes)
    for r in range(first, last):
        x, v, u = load(xs, r, lanes), load(vs, r, lanes), load(us, r, lanes)
        way = load(ys, r, lanes) - x
        x_then = x + then.to_y * way + then.by_v * v + then.by_u * u
        v_then = then.v_y * way + then.v_v * v + then.v_u * u
        v_now = load(v_there, r, lanes)
        wish = pull * (load(sample, r, lanes) - behind * v_now - x_then) + damp * (v_now - v_then)
        hand, w = load(hands, r, lanes), load(weight, r, lanes)
        if total(size(hand)) != 0.0:
            wish = wish + where(w, each * hand / w, splat(0.0, lanes))  # links do not know of tools
        wish = trust * wish
        store(wished, r, wish, lanes)
        square = square + w * wish * wish
    return total(square)


@helper
def wish(end: End, then: Then, pull: float, damp: float, trust: float, part: float, behind: float) -> float:
    """What the link wishes: its share of the hand's force, and what draws the copies together; gives its ‖·‖²_W [N²].

    Args:
        end: of the link.
        then: where this copy was when the neighbour's sample was.
        pull: N for a metre that the copies are apart.
        damp: N for a metre a second.
        trust: from 0 to 1, less for a sample that is too old.
        part: from 0 to 1, of the hand's force, less where guesses of it were wrong.
        behind: by how much this copy is to come behind the neighbour's [s].
    """
    n = end.position.shape[0]
    fours = _wish(end, then, pull, damp, trust, part, behind, 0, n // 4, FOUR)
    return fours + _wish(end, then, pull, damp, trust, part, behind, n // 4 * 4, n, ONE)


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
        trust: times part, as `wish` has them.
    """
    n = end.position.shape[0]
    _add_wish(end, capped, trust, 0, n // 4, FOUR)
    _add_wish(end, capped, trust, n // 4 * 4, n, ONE)
