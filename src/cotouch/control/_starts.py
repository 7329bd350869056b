"""Who is connected, as liveliness tells: a member is as long as any of its starts is."""

from typing import final

from cotouch.control._zenoh_keys import Start

# Members that ever lived at a time, and a few restarts of each; who is invited can make up no more of them.
_MOST_STARTS = 4096


@final
class Starts:
    """What was told of members' starts. Anybody invited may tell it, so it only helps to choose a way."""

    def __init__(self) -> None:
        """Begins with nobody."""
        self._members: dict[bytes, set[str]] = {}

    @property
    def members(self) -> frozenset[bytes]:
        """Public keys of those who have a start."""
        return frozenset(self._members)

    def count(self, member: bytes) -> int:
        """How many starts of this member there are."""
        return len(self._members.get(member, ()))

    def take(self, start: Start, *, alive: bool) -> None:
        """Notes that a start of a member began or ended.

        Args:
            start: of a member.
            alive: whether it began.
        """
        names = self._members.setdefault(start.member, set())
        if not alive:
            names.discard(start.name)
        elif sum(map(len, self._members.values())) < _MOST_STARTS:
            names.add(start.name)
        if not names:
            del self._members[start.member]
