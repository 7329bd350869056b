"""Damping that somebody lowers to see what becomes of it, for as long as they look: it comes back by itself."""

import time
from collections.abc import Callable, Sequence
from typing import final

from cotouch.observers._command_client import CommandClient

# Lowered damping holds so long after it was last asked for [s].
LEASE = 2.0


@final
class LoweredDamping:
    """The lowered damping of all members of one session.

    Attributes:
        fraction: of what passivity needs; 1: nothing is lowered.
    """

    def __init__(self, commands: CommandClient, names: Sequence[str], say: Callable[[float, str], None]) -> None:
        """Begins with all of it.

        Args:
            commands: tells the members.
            names: of the users.
            say: is told when what comes about, in a sentence.
        """
        self.fraction = 1.0
        self._commands, self._names, self._say = commands, names, say
        self._loosened = set[str]()  # hands that let go meanwhile
        self._ordered = 0  # number of the order
        self._lease = 0.0  # until when less than all of it holds [s]

    def give(self, fraction: float) -> None:
        """Orders so much; hands of the file let go meanwhile: holding damps, and would hide what is to be seen."""
        self.fraction = fraction
        self._lease = time.monotonic() + LEASE
        if fraction < 1.0:
            scripted = [name for name in self._names if self._commands.mode(name) == "script"]
            self._loosened.update(scripted)
            for name in scripted:
                self._commands.hand(name, "free")
        else:
            for name in self._loosened:
                if self._commands.mode(name) == "free":
                    self._commands.hand(name, "script")
            self._loosened.clear()
        self._ordered = self._commands.damping(fraction, until=self._lease)

    def hold(self, on: bool) -> None:
        """Whoever lowered it is still there, or is not."""
        self._lease = time.monotonic() + LEASE if on else 0.0

    def turn(self, now: float) -> None:
        """Gives it back where a copy ran away, and once whoever lowered it is gone.

        Args:
            now: [s].
        """
        if self.fraction >= 1.0:
            return
        for name in self._names:
            # Others may have been caught by an earlier order a moment after the first was.
            if self._commands.number(name, "caught") == self._ordered:
                self._say(now, f"ALARM: {name}'s copy ran away; everyone's damping is restored")
                self.give(1.0)
                return
        if now <= self._lease:
            self._commands.hold_damping(self._lease)
            return
        self.give(1.0)
        self._say(now, "the page that lowered the damping is gone; damping is restored to what passivity needs")
