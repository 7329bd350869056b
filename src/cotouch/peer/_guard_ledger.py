"""What an end of a link says of itself: its changes of state, and where its energy went."""

from typing import NamedTuple


class GuardEvent(NamedTuple):
    """A change of an end's state.

    Attributes:
        time: end of the step that was the first in the new state, on this end's clock [s].
        state: the new one.
        reason: in a few words.
    """

    time: float
    state: int
    reason: str


class GuardLedger(NamedTuple):
    """The energy of one guarded end: what it has, and where it went since the beginning [J].

    `tank = initial_energy + credited + taken - given - paid - lost`, and the work that the link did on the copy is
    `injected` less what the spring holds after the step.

    Attributes:
        state: in the last step.
        epoch: how often this end was guarded, modulo 255.
        potential: U, what the spring held as the last step began, with the set position of that step.
        tank: E; negative: a debt.
        credited: damping that went to the tank.
        taken: what the other end and the copy's other links gave.
        given: to them.
        paid: what the tank paid for moving the set position, for going guarded and for rounding.
        lost: what the tank could not hold, or might have belonged to the coupled link.
        injected: what moving the set position, by the tank or by the coupled neighbour, put into the spring.
        sent: of what was given, that to the other end.
        received: of what was taken, that of the other end.
    """

    state: int
    epoch: int
    potential: float
    tank: float
    credited: float
    taken: float
    given: float
    paid: float
    lost: float
    injected: float
    sent: float
    received: float
