"""What an end of `paid` knows of the neighbour's hand and of this copy's past, and what it tells the neighbour."""

from math import sqrt

from cotouch.arrays import Float
from cotouch.kernels import FOUR, load, size, splat, store, total, upper
from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    A2,
    ALL_B,
    ALL_EPOCH,
    ALL_GRASPED,
    ALL_HANDS,
    ALL_K,
    ALL_P,
    ALL_Q,
    ALL_W,
    AS_ONE,
    ASKED,
    BACK,
    BRAKE,
    COUNT,
    DAMPEST,
    DEGREE,
    DONE,
    EACH,
    EPOCH,
    FORCES,
    GIVEN,
    GRASPED,
    GUESS,
    GUESSES,
    HAND,
    KEPT,
    LOG,
    LOGGED,
    LONGEST,
    M_AS_ONE,
    M_B,
    M_EPOCH,
    M_GIVEN,
    M_HANDS,
    M_K,
    M_P,
    M_Q,
    M_SINCE,
    M_T,
    M_V,
    M_W,
    M_WAY,
    NEWEST,
    OWN_B,
    PART_B,
    PART_EPOCH,
    PART_GRASPED,
    PART_HANDS,
    PART_K,
    PART_P,
    PART_Q,
    PART_W,
    PAST,
    RELAY,
    ROUNDS,
    SINCE,
    STIFFEST,
    SUM,
    SUM2,
    TELLS,
    TIME,
    TIMES,
    TOLD,
    TOLD_EPOCH,
    WAY,
    WISH,
    A,
    K,
    W,
)
from cotouch.laws._paid_rows import ONE

# Of any force that is told on [N].
_MOST = 1e5
# Of ∫w; beyond, a new epoch begins, or small errors of an age would count for much [Ns].
_MOST_P = 100.0
# What is older than this is told on in part, by the root: where all move together, guesses of guesses go wrong [s].
_SOON = 0.1


@helper
def past(end: End, when: float) -> tuple[int, int, float, float]:
    """Where a time lies in what is kept of this copy: rows before and after it, share between them, and its length.

    Since the newest, both rows are its, and the share is the whole length.

    Args:
        end: of the link.
        when: the time [s].
    """
    numbers = end.shared_scalars
    count = int(numbers[COUNT])
    after, late = -1, numbers[NEWEST]
    if when >= late:
        return after, after, 1.0, when - late
    for back in range(1, min(count, KEPT) + 1):
        slot = (count - back) % KEPT
        time = numbers[TIMES + slot]
        if time <= when:
            gap = late - time
            return slot, after, (when - time) / gap if gap > 0.0 else 0.0, gap
        after, late = slot, time
    return after, after, 0.0, 0.0


@helper
def credible(end: End, told: Float) -> bool:
    """Whether hands are what hands can be, so that what a liar makes up is not told on.

    Args:
        end: of the link.
        told: numbers of the neighbour's message.
    """
    most = 0.0
    for i in range(end.position.shape[0]):
        most = max(most, abs(end.memory[PART_W, i]))
    hands = told[M_HANDS]
    stiff = 0.0 <= told[M_K] <= STIFFEST * hands and 0.0 <= told[M_B] <= DAMPEST * hands
    return stiff and 0.0 <= hands <= end.copies and most <= _MOST


@helper
def take_over(end: End, begun: float) -> bool:
    """Sets A and A2 to what another's hand did to this copy since its epoch began, as that epoch's w and its integral.

    So what was done by the hand as it was before is taken back, and what is missing of the new one is made up. False:
    the past is not kept for so long.

    Args:
        end: of the link.
        begun: when that epoch began [s].
    """
    own, numbers, memory, told = end.shared, end.shared_scalars, end.memory, end.received_scalars
    count, now = int(numbers[COUNT]), numbers[TIME]
    k, damping = (0.0, 0.0) if told[M_AS_ONE] > 0.0 else (told[M_K], told[M_B])
    newest = (count - 1) // EACH
    start = newest
    while start >= 0 and count - start * EACH < KEPT and numbers[TIMES + start * EACH % KEPT] > begun:
        start -= 1
    if count == 0 or (start >= 0 and count - start * EACH >= KEPT):
        return False
    start = max(start, 0)
    for i in range(end.position.shape[0]):
        before = done = place = 0.0
        x_first = done_first = 0.0
        x_last = done_last = all_x = a_last = aa = 0.0
        begin = max(begun, numbers[TIMES + start * EACH % KEPT])
        last = begin
        for nth in range(start, newest + 2):
            if nth > newest:
                time, place, done = now, end.position[i], memory[DONE, i]
            else:
                slot = nth * EACH % KEPT
                time, place, done = numbers[TIMES + slot], own[PAST + slot, i], memory[LOG + nth % LOGGED, i]
            if time <= begin:
                before, x_last, done_last = time, place, done
                x_first, done_first = place, done
                continue
            if last == begin:
                share = (begin - before) / (time - before)
                x_first = x_last = x_last + share * (place - x_last)
                done_first = done_last + share * (done - done_last)
            gap = time - last
            all_x += 0.5 * gap * (x_last + place)
            a = done - done_first + k * all_x + damping * (place - x_first)
            aa += 0.5 * gap * (a_last + a)
            last, x_last, a_last = time, place, a
        memory[A, i], memory[A2, i] = a_last, aa
    return True


@helper
def bring(end: End) -> None:
    """Adds the hands that this link brings to those of all links."""
    own, numbers, memory, kept = end.shared, end.shared_scalars, end.memory, end.scalars
    for i in range(end.position.shape[0]):
        own[ALL_W, i] += memory[PART_W, i]
        own[ALL_P, i] += memory[PART_P, i]
        own[ALL_Q, i] += memory[PART_Q, i]
    numbers[ALL_GRASPED] += kept[PART_GRASPED]
    for name in range(4):
        numbers[ALL_K + name] += kept[PART_K + name]


@helper
def _greatest(end: End, first: int, last: int, lanes: tuple[int, ...]) -> float:
    sums, most = end.memory[SUM], splat(0.0, lanes)
    for r in range(first, last):
        most = upper(size(load(sums, r, lanes)), most)
    return total(most)


@helper
def _tell_sums(
    end: End, renewed: bool, span: float, share: float, mine: float, first: int, last: int, lanes: tuple[int, ...]
) -> float:
    T, own, memory, sent, mean = end.T, end.shared, end.memory, end.sent, end.mean
    w_own, ways, first_sum, second_sum = own[W], own[WAY], memory[SUM], memory[SUM2]
    all_w, all_p, all_q = own[ALL_W], own[ALL_P], own[ALL_Q]
    part_w, part_p, part_q = memory[PART_W], memory[PART_P], memory[PART_Q]
    w_sent, p_sent, q_sent, v_sent, way_sent = sent[M_W], sent[M_P], sent[M_Q], sent[M_V], sent[M_WAY]
    p_more, q_more, told = splat(0.0, lanes), splat(0.0, lanes), splat(0.0, lanes)
    for r in range(first, last):
        acts, p, q = load(w_own, r, lanes), load(first_sum, r, lanes), load(second_sum, r, lanes)
        w = acts
        if share > 0.0:
            w = w + share * (load(all_w, r, lanes) - mine * load(part_w, r, lanes))
            p_more = share * (load(all_p, r, lanes) - mine * load(part_p, r, lanes))
            q_more = share * (load(all_q, r, lanes) - mine * load(part_q, r, lanes))
        if renewed:
            p, q = span * w, (0.5 * span * span) * w
            if span == 0.0:
                p_more, q_more = splat(0.0, lanes), splat(0.0, lanes)
        if span != 0.0:
            acts = splat(0.0, lanes)
        q = q + T * p + (0.5 * T * T) * acts + q_more
        p = p + T * acts + p_more
        store(first_sum, r, p, lanes)
        store(second_sum, r, q, lanes)
        store(w_sent, r, w, lanes)
        store(p_sent, r, p, lanes)
        store(q_sent, r, q, lanes)
        store(v_sent, r, load(mean, r, lanes), lanes)
        store(way_sent, r, load(ways, r, lanes), lanes)
        told = told + size(w) + size(p) + size(q)
    return total(told)


@helper
def _note_done(end: End, log: int, first: int, last: int, lanes: tuple[int, ...]) -> None:
    """What the hand did to this copy, with this link's part of what was not done as wished; and what was guessed."""
    T, own, numbers, memory, weight, mean = end.T, end.shared, end.shared_scalars, end.memory, end.weight, end.mean
    wishes, asked, mine, hands, done = own[WISH], own[ASKED], own[TOLD], memory[HAND], memory[DONE]
    brake, part, others = numbers[BRAKE], end.copies / numbers[DEGREE], end.received_scalars[M_HANDS]
    logged, guess, guesses = memory[LOG + max(log, 0)], memory[GUESS], memory[GUESSES + max(log, 0)]
    forces = own[FORCES + max(log, 0)]
    for r in range(first, last):
        short = load(wishes, r, lanes) - brake * load(mean, r, lanes) - load(asked, r, lanes)
        hand = load(hands, r, lanes) + others * load(mine, r, lanes)
        more = T * (hand + part * short * load(weight, r, lanes))
        before = load(done, r, lanes)
        if log >= 0:
            store(logged, r, before + 0.5 * more, lanes)
            store(guesses, r, load(guess, r, lanes), lanes)
            store(forces, r, load(mine, r, lanes), lanes)
        store(guess, r, splat(0.0, lanes), lanes)
        store(done, r, before + more, lanes)
        store(hands, r, splat(0.0, lanes), lanes)


@helper
def tell(end: End) -> None:
    """Writes of the own hand what the neighbour is told and, in a tree, of those that the other links bring."""
    T, numbers, kept = end.T, end.shared_scalars, end.scalars
    n = end.mean.shape[0]
    # In a tree, what the other links bring comes to the neighbour by this one only.
    share = end.parameters[RELAY]
    if share > 0.0 and numbers[LONGEST] > _SOON:
        share *= sqrt(_SOON / numbers[LONGEST])
    mine = 1.0 if kept[PART_HANDS] > 0.0 else 0.0
    epoch = numbers[EPOCH] + numbers[ALL_EPOCH] - mine * kept[PART_EPOCH]
    renewed = epoch != kept[TOLD_EPOCH]
    kept[TOLD_EPOCH] = epoch
    if max(_greatest(end, 0, n // 4, FOUR), _greatest(end, n // 4 * 4, n, ONE)) > _MOST_P:
        renewed = True
        kept[ROUNDS] += 1.0
    span = 0.0
    if renewed:
        kept[SINCE] = -1.0
        if numbers[ALL_GRASPED] - mine * kept[PART_GRASPED] > 0.0:
            span = max(numbers[BACK] - T, 0.0)
            kept[SINCE] = span
        if numbers[GRASPED] > 0.0:
            kept[SINCE] = span = 0.0
    if kept[SINCE] >= 0.0:
        kept[SINCE] += T
    count = int(numbers[COUNT]) - 1
    logs = count % EACH == 0 and numbers[TIMES + count % KEPT] == numbers[TIME] - 0.5 * T
    kept[TELLS] = _tell_sums(end, renewed, span, share, mine, 0, n // 4, FOUR)
    kept[TELLS] += _tell_sums(end, renewed, span, share, mine, n // 4 * 4, n, ONE)
    log = count // EACH % LOGGED if logs else -1
    _note_done(end, log, 0, n // 4, FOUR)
    _note_done(end, log, n // 4 * 4, n, ONE)
    end.sent_scalars[M_K] = numbers[K] + share * (numbers[ALL_K] - mine * kept[PART_K])
    end.sent_scalars[M_B] = numbers[OWN_B] + share * (numbers[ALL_B] - mine * kept[PART_B])
    end.sent_scalars[M_EPOCH], end.sent_scalars[M_GIVEN] = epoch + kept[ROUNDS], kept[GIVEN]
    end.sent_scalars[M_HANDS] = 1.0 + share * (numbers[ALL_HANDS] - mine * kept[PART_HANDS])
    end.sent_scalars[M_T], end.sent_scalars[M_SINCE] = T, kept[SINCE]
    end.sent_scalars[M_AS_ONE] = numbers[AS_ONE]
