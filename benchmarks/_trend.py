"""Whether something that is looked at again and again grows: its slope, and how sure that is.

Memory that jumps and stays where it jumped to is a walk. A line fitted through it looks far surer than it is: its slope
is the mean rise from one look to the next, and rises are independent of each other where values are not. Memory that
comes back to a line, as that of a process whose connections come and go, is not: there a fitted line is sure much
sooner, as far as neighbouring values do not hang together.

So values are taken for a walk unless a Dickey-Fuller test with a trend says that they come back to their line, which it
says of one walk in a hundred [critical values of MacKinnon 1991]. Then a line is fitted with errors that carry on from
look to look [Prais & Winsten 1954], the share that they do at the upper end of its 95 % interval.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.stats import t as student

Float = npt.NDArray[np.float64]
CONFIDENCE = 0.95
# Of 1 %, for so many rises n: the sum of these over n^0, n^1, n^2.
_CRITICAL = (-3.9638, -8.353, -47.44)
_UPPER = 1.645


class Trend(NamedTuple):
    """A slope and its interval.

    Attributes:
        slope: rise a second.
        error: half the width of its 95 % interval.
    """

    slope: float
    error: float

    @property
    def rises(self) -> bool:
        """Whether no slope of zero or less is in the interval."""
        return self.slope - self.error > 0.0

    @property
    def most(self) -> float:
        """Upper end of the interval."""
        return self.slope + self.error


def trend(times: Float, values: Float) -> Trend:
    """How values rise.

    Args:
        times: rising, roughly evenly; what comes and goes should do so between two of them [s].
        values: at these.

    Raises:
        ValueError: there are fewer than four looks.
    """
    if times.size < 4:
        raise ValueError(f"{times.size} looks show no slope; it takes 4")
    return _line(times, values) if _comes_back(values) else _walk(times, values)


def _walk(times: Float, values: Float) -> Trend:
    """Rises vary as the time between them [Student's t for their mean]."""
    spans, rises = np.diff(times), np.diff(values)
    slope = float(rises.sum() / spans.sum())
    walk = float((((rises - slope * spans) ** 2) / spans).sum()) / (rises.size - 1)  # of a second
    return Trend(slope, _sure(rises.size - 1) * float(np.sqrt(walk / spans.sum())))


def _comes_back(values: Float) -> bool:
    """Whether values below their line rise and those above it fall, for certain."""
    n = values.size - 1
    if n < 8 or np.ptp(values) == 0.0:
        return False
    known = np.stack([np.ones(n), np.arange(n) - 0.5 * n, values[:-1] - values.mean()], axis=1)
    fit, error = _fitted(known, np.diff(values))
    return fit[2] < sum(c / n**k for k, c in enumerate(_CRITICAL)) * error[2]


def _line(times: Float, values: Float) -> Trend:
    """A line with errors of which a share carries on to the next look."""
    n = values.size
    known = np.stack([np.ones(n), times - times.mean()], axis=1)
    off = values - known @ _fitted(known, values)[0]
    fraction = float(off[1:] @ off[:-1] / (off[:-1] @ off[:-1]))
    fraction = max(0.0, fraction + (2.0 + 4.0 * fraction) / n)  # a fitted line hides some of it
    fraction = min(fraction + _UPPER * float(np.sqrt(max(0.0, 1.0 - fraction**2) / n)), 0.99)
    first = float(np.sqrt(1.0 - fraction**2))

    def whitened(data: Float) -> Float:
        return np.concatenate([first * data[:1], data[1:] - fraction * data[:-1]])

    fit, error = _fitted(whitened(known), whitened(values))
    return Trend(float(fit[1]), _sure(n - 2) * float(error[1]))


def _fitted(known: Float, values: Float) -> tuple[Float, Float]:
    """Least squares: coefficients and their standard errors."""
    inverse = np.linalg.inv(known.T @ known)
    fit = inverse @ (known.T @ values)
    off = values - known @ fit
    return fit, np.sqrt(np.diag(inverse) * float(off @ off) / (values.size - fit.size))


def _sure(freedom: int) -> float:
    return float(student.ppf(0.5 + 0.5 * CONFIDENCE, freedom))
