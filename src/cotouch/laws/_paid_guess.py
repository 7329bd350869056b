"""How right an end of `paid` was about the neighbour's hand: what it guessed, beside what it hears of that later."""

from cotouch.laws._end import End
from cotouch.laws._helper import helper
from cotouch.laws._paid_fields import (
    CHECKED,
    COUNT,
    EACH,
    EVEN_GUESS,
    EVEN_TRUTH,
    FORCES,
    GUESSED,
    GUESSES,
    HELD,
    KEPT,
    LOGGED,
    M_AS_ONE,
    M_B,
    M_HANDS,
    M_K,
    M_P,
    M_SINCE,
    M_W,
    PAST,
    RIGHT,
    SETTLED,
    TIME,
    TIMES,
    W_LAST,
)

# Guesses are looked at over so long; what both do faster than this moves nothing [s].
_LOOKED_AT, _EVEN = 1.0, 0.15
# An error that is small beside the own hand's force does no harm: that force's square counts so often as guessed right.
_HARMLESS = 2.0


@helper
def check_guess(end: End, when: float, passed: float, lag: float, fresh: bool) -> None:
    """Compares the next guess that was kept with what the neighbour's hand did, once that is heard.

    Args:
        end: of the link, before what is heard is taken up.
        when: time of what is heard [s].
        passed: since the time of what was heard before it [s].
        lag: over which A follows [s].
        fresh: whether it is another hand than before.
    """
    own, numbers, memory, kept = end.shared, end.shared_scalars, end.memory, end.scalars
    told, w_now, p_now, w_last = end.received_scalars, end.received[M_W], end.received[M_P], end.memory[W_LAST]
    if kept[SETTLED] == 0.0 or (fresh and told[M_SINCE] >= 0.0):
        # What one grasps or lets go of nobody could guess, and what was missed is made up: over so long neither counts.
        kept[SETTLED] = numbers[TIME] + lag
    newest = (int(numbers[COUNT]) - 1) // EACH
    nth = max(int(kept[CHECKED]) + 1, newest - LOGGED + 2)
    slot, log = nth * EACH % KEPT, nth % LOGGED
    time = numbers[TIMES + slot]
    if nth > newest or time > when:
        return
    kept[CHECKED] = nth
    if fresh or told[M_AS_ONE] > 0.0 or time < kept[SETTLED]:
        return
    since = time - numbers[TIMES + (nth - 1) * EACH % KEPT]
    part, back = min(since / _EVEN, 1.0), min((when - time) / passed, 1.0) if passed > 0.0 else 0.0
    right = guessed = harmless = 0.0
    for i in range(end.position.shape[0]):
        guess, force = memory[GUESSES + log, i], told[M_HANDS] * own[FORCES + log, i]
        if guess != 0.0 or force != 0.0 or w_now[i] != 0.0 or memory[EVEN_TRUTH, i] != 0.0:
            truth = w_now[i] - back * (w_now[i] - w_last[i]) - force
            if w_now[i] != 0.0 or p_now[i] != 0.0:
                truth -= told[M_K] * own[PAST + slot, i] + told[M_B] * own[PAST + KEPT + slot, i]
            memory[EVEN_TRUTH, i] += part * (truth - memory[EVEN_TRUTH, i])
            memory[EVEN_GUESS, i] += part * (guess - memory[EVEN_GUESS, i])
            right += memory[EVEN_GUESS, i] * memory[EVEN_TRUTH, i]
            guessed += memory[EVEN_GUESS, i] ** 2
            harmless += _HARMLESS * force * force
    keep = max(1.0 - since / _LOOKED_AT, 0.0)
    kept[RIGHT] = keep * kept[RIGHT] + right + harmless
    kept[GUESSED] = keep * kept[GUESSED] + guessed + harmless


@helper
def believed(end: End) -> float:
    """How much of what the neighbour's hand seems to do beyond the own one is wished, from 0 to 1.

    As much as was nearest to the truth of late. All of it, where nobody holds here: there is nothing else to go by.
    """
    kept = end.scalars
    if end.shared_scalars[HELD] == 0.0 or end.received_scalars[M_AS_ONE] > 0.0 or not kept[GUESSED] > 0.0:
        return 1.0
    return min(max(kept[RIGHT] / kept[GUESSED], 0.0), 1.0)
