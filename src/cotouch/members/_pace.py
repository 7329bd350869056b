"""How well a member keeps its rate, for its status twice a second and for its end."""

import math
from typing import final

from cotouch.pacing import PaceStatistics


@final
class Pace:
    """Counts the pace between two statuses; `PaceStatistics` sorts the counts, which takes longer than a step may.

    Attributes:
        period: wanted length of a step [s].
    """

    def __init__(self, period: float) -> None:
        """Begins to count.

        Args:
            period: wanted length of a step [s].
        """
        self.restart(period)

    def restart(self, period: float | None = None) -> None:
        """Begins to count anew.

        Args:
            period: another wanted length of a step; None: as before [s].
        """
        self.period = self.period if period is None else period
        self._missed = 0
        self._stood = 0.0
        self._clear()

    def stepped(self, T: float, stood: float, busy: float) -> None:
        """Counts a step.

        Args:
            T: its length [s].
            stood: how much longer it really was [s].
            busy: what its work took [s].
        """
        self._steps += 1
        self._time += T + stood
        self._busy += busy
        self._longest = max(self._longest, T + stood)
        self._missed += max(0, round((T + stood) / self.period) - 1)
        self._stood += stood

    def since(self) -> dict[str, float]:
        """What happened since the last call, in the words of a `Status`."""
        time = self._time
        numbers = {
            "rate": self._steps / time if time > 0.0 else 0.0,
            "longest_period": self._longest,
            "missed": self._missed,
            "stood": self._stood,
            "busy": self._busy / time if time > 0.0 else 0.0,
        }
        self._clear()
        return numbers

    def _clear(self) -> None:
        self._steps = 0
        self._time = self._busy = self._longest = 0.0


def pace_numbers(statistics: PaceStatistics) -> dict[str, float]:
    """The statistics of a whole run, without unknown ones [s]."""
    return {name: value for name, value in vars(statistics).items() if not math.isnan(value)}
