"""Whether something that is looked at again and again grows: its slope, and how sure that is.

Memory does not scatter around a line: it stands still, jumps, and stays where it jumped to. A line fitted through such
steps looks far surer than it is. So the slope is the mean rise from one look to the next: rises of a walk are
independent of each other where its values are not, and vary as the time between them [Student's t for their mean]. If
values do scatter around a line instead, neighbouring rises make up for each other and the interval is wider than it
need be.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.stats import t as student

Float = npt.NDArray[np.float64]
CONFIDENCE = 0.95


class Trend(NamedTuple):
    """A slope and its interval.

    Attributes:
        slope: mean rise a second.
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
        times: rising, not necessarily evenly; what comes and goes should do so between two of them [s].
        values: at these.

    Raises:
        ValueError: there are fewer than four looks.
    """
    if times.size < 4:
        raise ValueError(f"{times.size} looks show no slope; it takes 4")
    spans, rises = np.diff(times), np.diff(values)
    slope = float(rises.sum() / spans.sum())
    walk = float((((rises - slope * spans) ** 2) / spans).sum()) / (rises.size - 1)  # of a second
    sure = float(student.ppf(0.5 + 0.5 * CONFIDENCE, rises.size - 1))
    return Trend(slope, sure * float(np.sqrt(walk / spans.sum())))
