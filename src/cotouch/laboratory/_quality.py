"""How near a signal is to the one that was wanted: PSNR, HPW-PSNR and ETVO, which haptic codecs are measured by.

Reconstructed, not from the papers or the text of IEEE 1918.1.1; docs/codec.md says from what, and what is assumed.
"""

import numpy as np

from cotouch.arrays import Float
from cotouch.compiled import routine
from cotouch.device import NOTICED

# Copies may be so far ahead of the wanted motion, and so far behind [s]; looked at so often [s].
_AHEAD, _BEHIND, _EVERY = 0.05, 0.4, 0.005
# A change of the offset costs as much as an error of one unit in so many steps; the least offset that fits is meant.
_CHANGE, _LEAST = 10.0, 1e-4


def psnr(wanted: Float, found: Float) -> float:
    """Peak signal-to-noise ratio, `10 log₁₀(peak² / mean square error)`; infinite of what is exact [dB].

    Args:
        wanted: (..., steps, axes).
        found: likewise.
    """
    return _ratio(wanted, ((found - wanted) ** 2).sum(axis=-1))


def hpw_psnr(wanted: Float, found: Float, *, noticed: float = NOTICED["force"]) -> float:
    """PSNR in which errors that nobody notices don't count: those below a share of the wanted value [dB].

    Args:
        wanted: (..., steps, axes).
        found: likewise.
        noticed: the just noticeable difference as a share of the value (Weber), >= 0.
    """
    error = ((found - wanted) ** 2).sum(axis=-1)
    return _ratio(wanted, np.where(error <= noticed**2 * (wanted**2).sum(axis=-1), 0.0, error))


def etvo(wanted: Float, found: Float, period: float, *, unit: float = NOTICED["place"]) -> tuple[float, float]:
    """Effective time- and value-offset: how late a signal is, and how far off if that is taken out.

    Time is warped so that the squares of what is left are least: each step's offset is the one before it or one step of
    5 ms more or less, which costs as much as an error of one unit in ten steps.

    Args:
        wanted: (steps, axes).
        found: likewise.
        period: between steps [s].
        unit: error that is worth a change of the offset, > 0.

    Returns:
        Offset in time, the mean over the way that the wanted signal takes, > 0 where the other is late [s]; offset in
        value, root mean square.
    """
    stride = max(round(_EVERY / period), 1)
    a, b = np.ascontiguousarray(wanted[::stride]), np.ascontiguousarray(found[::stride])
    ahead, behind = (max(round(span / (stride * period)), 1) for span in (_AHEAD, _BEHIND))
    offset, error = _warp(a, b, ahead, behind, _CHANGE * unit**2)
    moved = np.sqrt((np.diff(a, axis=0, prepend=a[:1]) ** 2).sum(axis=1))
    late = float(offset @ moved / moved.sum()) * stride * period if moved.any() else 0.0
    return late, float(np.sqrt(error.mean()))


def _ratio(wanted: Float, error: Float) -> float:
    peak, mean = float((wanted**2).sum(axis=-1).max(initial=0.0)), float(error.mean())
    if mean == 0.0:
        return float("inf")
    return 10.0 * float(np.log10(peak / mean)) if peak > 0.0 else float("-inf")


@routine
def _warp(wanted: Float, found: Float, ahead: int, behind: int, change: float) -> tuple[Float, Float]:
    """Offset of every step, and its squared error, by dynamic programming."""
    steps, axes, lags = wanted.shape[0], wanted.shape[1], ahead + behind + 1
    came = np.zeros((steps, lags), dtype=np.int8)
    square = np.zeros((steps, lags))
    cost, before = np.zeros(lags), np.zeros(lags)
    for k in range(steps):
        before[:] = cost
        for lag in range(lags):
            at = min(max(k - (lag - ahead), 0), steps - 1)
            error = 0.0
            for axis in range(axes):
                error += (found[k, axis] - wanted[at, axis]) ** 2
            square[k, lag] = error
            best, way = before[lag], 0
            if k > 0:
                for turn in (-1, 1):
                    if 0 <= lag + turn < lags and before[lag + turn] + change < best:
                        best, way = before[lag + turn] + change, turn
            came[k, lag] = way
            # Where all offsets fit alike, as at rest, the least is meant.
            cost[lag] = best + error + _LEAST * change * abs(lag - ahead)
    offset, left = np.zeros(steps), np.zeros(steps)
    lag = int(np.argmin(cost))
    for k in range(steps - 1, -1, -1):
        offset[k], left[k] = lag - ahead, square[k, lag]
        lag += came[k, lag]
    return offset, left
