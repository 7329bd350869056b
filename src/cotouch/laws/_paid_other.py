"""What an end of `paid` knows of the neighbour's hand and of this copy's past, and what it tells the neighbour."""

from cotouch.laws._end import End, Float
from cotouch.laws._helper import helper
from cotouch.laws._paid_hand import (
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
    EPOCH,
    GRASPED,
    KEPT,
    OWN_B,
    PAST,
    STIFFEST,
    TIME,
    TIMES,
    TOLD,
    WAY,
    WISH,
    K,
    V,
    W,
    X,
)

# Fields of an end, and numbers.
WAVE_IN, WAVE_OUT, WAVE, A, A2, WISHED, W_LAST, SLOPE, PART_W, STRETCH, SUM, SUM2, HAND, DONE = range(14)
SUM_THERE, SUM2_THERE, PART_P, PART_Q = range(14, 18)
E_IN, E_OUT, AGE, CREDITED, GIVEN, KNOWN, HORIZON, STAMP, SPAN = range(9)
PART_K, PART_B, PART_EPOCH, PART_HANDS, TOLD_EPOCH, SINCE, ROUNDS, PART_GRASPED = range(9, 17)
EVENLY = 17  # and one for each other axis
# What was done to the copy by a hand is kept at every so many of the times at which its past is kept.
LOG, EACH = 18, 4
LOGGED = KEPT // EACH
# A message.
M_WAVE, M_W, M_P, M_Q, M_V, M_WAY = range(6)
M_E, M_K, M_B, M_EPOCH, M_GIVEN, M_T, M_HANDS, M_AS_ONE, M_SINCE, M_AGE = range(10)
# Of the parameters.
RELAY = 9
# Of any force that is told on [N].
_MOST = 1e5
# Of ∫w; beyond, a new epoch begins, or small errors of an age would count for much [Ns].
_MOST_P = 100.0


@helper
def past(end: End, when: float) -> tuple[int, int, float, float]:
    """Where a time lies in what is kept of this copy: rows before and after it, share between them, and its length.

    Args:
        end: of the link.
        when: the time [s].
    """
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
def place_then(end: End, before: int, after: int, share: float, gap: float, i: int) -> tuple[float, float]:
    """x̂ and v̂ of this copy at such a time; row -1 is the newest.

    By Hermite's cubic: a straight line cuts the tops of what swings, and so a copy that swings would be told to go on.

    Args:
        end: of the link.
        before: row before the time, as `past` says.
        after: row after it.
        share: of the way between them.
        gap: between them [s].
        i: coordinate.
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
def tell(end: End) -> None:
    """Writes of the own hand what the neighbour is told and, in a tree, of those that the other links bring."""
    T, own, numbers, kept, relay = end.T, end.shared, end.shared_scalars, end.scalars, end.parameters[RELAY]
    size = end.mean.shape[0]
    # In a tree, what the other links bring comes to the neighbour by this one only.
    share, mine = relay, 1.0 if kept[PART_HANDS] > 0.0 else 0.0
    epoch = numbers[EPOCH] + numbers[ALL_EPOCH] - mine * kept[PART_EPOCH]
    renewed = epoch != kept[TOLD_EPOCH]
    kept[TOLD_EPOCH], most = epoch, 0.0
    for i in range(size):
        most = max(most, abs(end.memory[SUM, i]))
    if most > _MOST_P:
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
    for i in range(size):
        w = own[W, i] + share * (own[ALL_W, i] - mine * end.memory[PART_W, i])
        p_more = share * (own[ALL_P, i] - mine * end.memory[PART_P, i])
        q_more = share * (own[ALL_Q, i] - mine * end.memory[PART_Q, i])
        if renewed:
            end.memory[SUM, i], end.memory[SUM2, i] = span * w, 0.5 * span * span * w
            if span == 0.0:
                p_more = q_more = 0.0
        w_own = own[W, i] if span == 0.0 else 0.0
        end.memory[SUM2, i] += T * end.memory[SUM, i] + 0.5 * T * T * w_own + q_more
        end.memory[SUM, i] += T * w_own + p_more
        end.sent[M_W, i], end.sent[M_P, i], end.sent[M_Q, i] = w, end.memory[SUM, i], end.memory[SUM2, i]
        end.sent[M_V, i], end.sent[M_WAY, i] = end.mean[i], own[WAY, i]
        # What the hand did to this copy, and this link's part of what was not done as it was wished.
        short = own[WISH, i] - numbers[BRAKE] * end.mean[i] - own[ASKED, i]
        short *= end.copies * end.weight[i] / numbers[DEGREE]
        done = T * (end.memory[HAND, i] + end.received_scalars[M_HANDS] * own[TOLD, i] + short)
        if logs:
            end.memory[LOG + count // EACH % LOGGED, i] = end.memory[DONE, i] + 0.5 * done
        end.memory[DONE, i] += done
        end.memory[HAND, i] = 0.0
    end.sent_scalars[M_K] = numbers[K] + share * (numbers[ALL_K] - mine * kept[PART_K])
    end.sent_scalars[M_B] = numbers[OWN_B] + share * (numbers[ALL_B] - mine * kept[PART_B])
    end.sent_scalars[M_EPOCH], end.sent_scalars[M_GIVEN] = epoch + kept[ROUNDS], kept[GIVEN]
    end.sent_scalars[M_HANDS] = 1.0 + share * (numbers[ALL_HANDS] - mine * kept[PART_HANDS])
    end.sent_scalars[M_T], end.sent_scalars[M_SINCE] = T, kept[SINCE]
    end.sent_scalars[M_AS_ONE] = numbers[AS_ONE]
