"""What brings a newcomer to where the others are: energy that its links get once, as they need it."""

from typing import final

from cotouch.peer._joined import JoinedLinks
from cotouch.peer._links import LinkState

# So long an allowance lasts at least: a hand that comes into a session is not torn along [s].
APPROACH = 2.0
# Links with a law get of it only where copies are farther apart when they first hear of each other [m].
_APART = 1e-3


@final
class Allowance:
    """Of one copy.

    Attributes:
        left: of it [J].
    """

    def __init__(self, energy: float) -> None:
        """Takes how much there is, >= 0 [J]."""
        self.left = energy
        self._rate = energy / APPROACH
        self._spent_for = 0.0  # so long links with a law have had of it [s]

    def spend(self, links: JoinedLinks, T: float) -> float:
        """Lets links have what they lack, until all of them are coupled; how much they got [J].

        Args:
            links: of the copy.
            T: length of the step [s].
        """
        starved = [guard for guard, _ in links.guarded if guard.starved]
        most, before = min(self.left, self._rate * T), self.left
        if links.laws:
            memory, self._spent_for = links.laws[0].memory, self._spent_for + T
            energy = min(memory.lacking, most)
            # Those who begin together have nowhere to come to: their hands would get what nobody put in.
            if energy > 0.0 and any(link.apart > _APART for link in links.laws):
                memory.help(energy)
                self.left -= energy
        for guard in starved:
            energy = min(guard.lacking, most / len(starved))
            guard.help(energy)
            self.left -= energy
        spent = before - self.left
        together = links.guarded and all(guard.state == LinkState.COUPLED for guard, _ in links.guarded)
        if together or self._spent_for > 2.0 * APPROACH:  # a law has no state that says that it has arrived
            self.left = 0.0
        return spent
