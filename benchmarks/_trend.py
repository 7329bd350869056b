"""Whether something that is looked at again and again grows: its slope, and how sure that is.

Memory does not scatter around a line: it stands still, jumps, and stays where it jumped to. A line fitted through such
steps looks far surer than it is. So the time is cut into blocks, and the slope is the mean rise from where one block
begins to where the next does: rises of a walk are independent of each other where its values are not [Student's t for
their mean]. If values do scatter around a line instead, neighbouring rises make up for each other and the interval is
wider than it need be. Where a block begins is what memory comes down to there: what is taken for a moment and given
back says nothing, and what leaks is never given back.
"""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.stats import t as student

Float = npt.NDArray[np.float64]
BLOCKS = 12
CONFIDENCE = 0.95
# Where a block begins: such a quantile of so much of it.
_BEGIN, _LOW = 0.4, 0.1


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


def trend(times: Float, values: Float, *, blocks: int = BLOCKS) -> Trend:
    """How values rise.

    Args:
        times: rising [s].
        values: at these.
        blocks: how many parts of the time, >= 3; each should be longer than what comes and goes within one.

    Raises:
        ValueError: a block is empty.
    """
    edges = np.linspace(times[0], times[-1], blocks + 1)
    length = edges[1] - edges[0]
    begins = [
        values[(times >= edge) & (times <= edge + _BEGIN * length)]
        for edge in (*edges[:-1], times[-1] - _BEGIN * length)
    ]
    if not all(part.size for part in begins):
        raise ValueError(f"{times.size} values do not fill {blocks} blocks of time")
    lows = np.array([np.quantile(part, _LOW) for part in begins])
    spans = np.full(blocks, length)
    spans[-1] -= _BEGIN * length
    rises = np.diff(lows) / spans
    spread = float(rises.std(ddof=1)) / np.sqrt(rises.size)
    return Trend(float(rises.mean()), float(student.ppf(0.5 + 0.5 * CONFIDENCE, rises.size - 1)) * spread)
