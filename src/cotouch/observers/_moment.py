"""A session's last moment: what is shown when it is over."""

from dataclasses import replace
from typing import final

from cotouch.observers._session_api import Overview

# Who leaves within this time before the end leaves because of it [s].
_LAST = 3.0


@final
class LastMoment:
    """Remembers the state of a session before members began to leave because it ended."""

    def __init__(self) -> None:
        """Nothing was seen yet."""
        self._fullest: Overview | None = None

    def seen(self, overview: Overview) -> Overview:
        """What is to be shown.

        Args:
            overview: how things are; to be handed over several times a second.

        Returns:
            The same; once the session is over, how it was before the first left for that reason.
        """
        before = self._fullest
        if not overview.ended:
            if before is None or _members(overview) >= _members(before) or overview.time - before.time > _LAST:
                self._fullest = overview
            return overview
        if before is None:
            return overview
        now = {"time": overview.time, "recording": overview.recording, "events": overview.events}
        return replace(before, ended=True, **now)


def _members(overview: Overview) -> int:
    """How many take part and have said how they are."""
    return sum(1 for entry in overview.roster.members if entry.slot in overview.statuses)
