"""Whom a copy tells what it does."""

from typing import TYPE_CHECKING, Protocol

from cotouch.peer import StepReport

if TYPE_CHECKING:
    from cotouch.members._replica import Replica


class StepRecorder(Protocol):
    """Records what a copy does."""

    @property
    def begun(self) -> bool:
        """Whether it keeps anything yet."""
        ...

    @property
    def failure(self) -> str | None:
        """Why it keeps nothing any more, in a few words; None as long as it does."""
        ...

    def setup(self, copy: "Replica", now: float) -> None:
        """Links, damping or the number of copies changed.

        Args:
            copy: the replica.
            now: time [s].
        """
        ...

    def step(self, copy: "Replica", report: StepReport, now: float, T: float) -> None:
        """A step was taken.

        Args:
            copy: the replica.
            report: of the step.
            now: time [s].
            T: length of the step [s].
        """
        ...

    def event(self, kind: str, time: float, **fields: object) -> None:
        """Something happened.

        Args:
            kind: of message or event.
            time: when [s].
            fields: what else is to be known of it.
        """
        ...
