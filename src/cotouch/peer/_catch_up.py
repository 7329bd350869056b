"""For how long a guarded end has caught up, and the least that its tank held in that time."""

from math import inf
from typing import final


@final
class CatchUp:
    """Of one end.

    Attributes:
        time: for how long ȳ = y with an age within the budget [s].
    """

    __slots__ = ("_older", "_recent", "_stretch", "time")

    def __init__(self) -> None:
        """Begins to catch up."""
        self.begin()

    def begin(self) -> None:
        """Begins anew."""
        self.time = self._stretch = 0.0  # the second: how long the recent of two stretches of time is
        self._recent = self._older = inf  # least tank, of these two

    @property
    def least(self) -> float:
        """Of the tank, over the time in which the other end may have coupled [J]."""
        return min(self._recent, self._older)

    def note(self, tank: float, total: float, T: float, *, guarded: bool) -> None:
        """Notes the tank of a step.

        Until the sample that says GUARDED was sent, the other end had not coupled; so long ago as both budgets it was.

        Args:
            tank: E [J].
            total: both budgets [s].
            T: length of the step [s].
            guarded: whether the other end's sample says so.
        """
        if guarded and self._stretch >= total:
            self._older, self._recent, self._stretch = self._recent, inf, 0.0
        self._stretch += T
        self._recent = min(self._recent, tank)

    def give(self, energy: float) -> None:
        """So much less was in the tank, for the other end has it [J]."""
        self._recent -= energy
        self._older -= energy
