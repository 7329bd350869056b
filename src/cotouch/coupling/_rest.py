"""A place that is known in steps, taken at rest as what it hardly is: still.

A spring to a place known in steps of Δ has no equilibrium between two of them. Without dry friction the place then
flickers between two steps for ever, and the force by some kΔ [Diolaiti et al. 2006]. Holding the place still
(hysteresis) ends that and brings worse: a spring that lags gives more than it took, and a weak hand swings.

`place_at_rest` holds nothing. Where a place has stayed within two neighbouring steps for a while, it begins at the mean
of that while, and from there goes on with a fraction of the measured motion, so that a step moves the force little and
there is an equilibrium. Motion beyond some steps ends it, and what the place is off by then fades: nothing jumps.

What a law believes of energy does not hang on this. It books `force · Δq` by what was measured, not by the place that
made the force, and its spring's energy is that of the stretch that it really used. `modulation_bound` holds for any.
"""

from math import exp

from cotouch.arrays import Float
from cotouch.kernels import at, kernel, put

REST_FIELDS = 8
"""Numbers that `place_at_rest` keeps for each coordinate."""
_LOW, _HIGH, _SUM, _AGE, _ANCHOR, _BASE, _OFFSET, _RESTS = range(REST_FIELDS)
# At rest is what stays within so many steps for so long [s], until it is so many steps away.
_WITHIN, _FOR, _BEYOND = 1.5, 0.5, 12.0
# How fast the place comes back to what is measured [s].
_FADE = 0.15
# A step moves the force at rest by no more [N].
_FELT = 0.004

REST_DRIFT = 300.0
"""So many steps a second, over 10 ms or more, a place at rest may move faster than what is measured: what it is off by
fades, and a quick motion is followed at once."""


def rest_fraction(stiffness: float, step: float) -> float:
    """With which fraction of the measured motion a place goes on at rest, in (0, 1]; 1: with all of it, as ever.

    Args:
        stiffness: of what pulls at the place, k >= 0 [N/m].
        step: by which the place is known, >= 0; 0: exactly [m].
    """
    return 1.0 if stiffness * step <= _FELT else _FELT / (stiffness * step)


@kernel
def place_at_rest(memory: Float, row: int, measured: float, step: float, fraction: float, T: float) -> float:
    """The place that a law takes for the measured one; they differ by some steps, and only at rest and soon after.

    Args:
        memory: of all coordinates, (coordinates, REST_FIELDS); zeros at first, changed in place.
        row: which coordinate.
        measured: as the encoder has it [m or rad].
        step: of the encoder, > 0 where the fraction is below 1 [m or rad].
        fraction: see `rest_fraction`.
        T: since the last time, >= 0 [s].
    """
    if fraction >= 1.0:
        return measured
    offset = at(memory, (row, _OFFSET)) * exp(-T / _FADE)
    place = measured + offset
    if at(memory, (row, _RESTS)) == 0.0:
        low, high = min(at(memory, (row, _LOW)), measured), max(at(memory, (row, _HIGH)), measured)
        age, summed = at(memory, (row, _AGE)) + T, at(memory, (row, _SUM)) + T * measured
        if not high - low <= _WITHIN * step:
            low, high, age, summed = measured, measured, 0.0, 0.0
        if age >= _FOR:
            put(memory, (row, _RESTS), 1.0)
            put(memory, (row, _ANCHOR), measured)
            put(memory, (row, _BASE), summed / age)
            offset = place - summed / age
        put(memory, (row, _LOW), low)
        put(memory, (row, _HIGH), high)
        put(memory, (row, _AGE), age)
        put(memory, (row, _SUM), summed)
    else:
        away = measured - at(memory, (row, _ANCHOR))
        place = at(memory, (row, _BASE)) + offset + fraction * away
        if not abs(away) <= _BEYOND * step:
            # A quick motion may be far beyond by now; it is followed at once.
            offset = min(max(place - measured, -_BEYOND * step), _BEYOND * step)
            place = measured + offset
            put(memory, (row, _RESTS), 0.0)
            put(memory, (row, _LOW), measured)
            put(memory, (row, _HIGH), measured)
            put(memory, (row, _AGE), 0.0)
            put(memory, (row, _SUM), 0.0)
    put(memory, (row, _OFFSET), offset)
    return place
