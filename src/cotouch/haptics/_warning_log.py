"""What whoever holds a device is told: why force was removed, that it is back, and not the same all the time."""

from collections.abc import Callable
from math import inf
from typing import final

from cotouch.haptics._safety import FOR_GOOD, LATCHED, NO_CAUSE, Cause, spoken

# Causes that come and go in ordinary use and need no words.
USUAL = Cause.SATURATED | Cause.SLEW | Cause.RAMP | Cause.QUIET
# The same words again only after this [s]; that motors are held at what they can do for long comes and goes twice a
# second for whoever goes on pushing, and is said once in a while.
_AGAIN, _SELDOM = 1.0, 30.0


def priority_refused(why: str) -> str:
    """What a refusal of real-time priority means for a person who holds a device."""
    return (
        f"real-time priority was refused ({why}): on a busy machine the force will come and go; permit it "
        "with ulimit -r 30 or in /etc/security/limits.d, as docs/safety.md says"
    )


@final
class WarningLog:
    """Sentences for one person about one device."""

    def __init__(self, clock: Callable[[], float]) -> None:
        """Has said nothing.

        Args:
            clock: monotonic [s].
        """
        self._clock = clock
        self._said: dict[str, float] = {}
        self._waiting: list[str] = []
        self._causes, self._announced = NO_CAUSE, False
        self._felt = False  # whether there ever was force

    def say(self, text: str, again: float = _AGAIN) -> bool:
        """Says it; False if the same was said less than `again` ago [s].

        Args:
            text: the sentence.
            again: after which the same is said again [s].
        """
        now = self._clock()
        if now - self._said.get(text, -inf) < again:
            return False
        self._said[text] = now
        self._waiting.append(text)
        return True

    def force(self, causes: Cause) -> None:
        """Says why there is less force now, and that it is back where that was said.

        Before there ever was force only what stays is said.

        Args:
            causes: of the newest report.
        """
        self._felt = self._felt or not causes & ~USUAL
        now = causes & ~USUAL if self._felt or causes & (FOR_GOOD | LATCHED) else NO_CAUSE
        if now == self._causes:
            return
        self._causes = now
        if now:
            again = _SELDOM if now == Cause.HOT else _AGAIN
            self._announced = self.say(f"force is off or less: {spoken(now)}", again) or self._announced
        elif self._announced:
            self._announced = False
            self.say("force is back", 0.0)

    def fresh(self) -> list[str]:
        """What was said since the last call."""
        fresh, self._waiting = self._waiting, []
        return fresh
