"""What is known of the ways to neighbours, and how it is told."""

from collections.abc import Hashable
from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.live._address import Address
from cotouch.live._puncher import Puncher, Way


class ByRelay(NamedTuple):
    """Source of a datagram that came by the control plane.

    Attributes:
        member: public key of the member it says it is from.
    """

    member: bytes


class WayChanged(NamedTuple):
    """A neighbour is reached another way.

    Attributes:
        neighbour: index of the user.
        time: [s].
        way: from now on.
        address: where it answers, if `DIRECT`.
    """

    neighbour: int
    time: float
    way: Way
    address: Address | None


@final
@dataclass(eq=False)
class Known:
    """What is held of a neighbour that was introduced.

    Attributes:
        member: its public key.
        word: this end's part of the pair's keys.
        puncher: finds the way.
        label: of its probes, once there are keys.
        theirs: its part of the keys.
        way: as last noted.
        address: where it is sent to, if `DIRECT`.
        tell: when candidates are to be said again [s].
        told: when they last were [s].
        sent: when it was last sent a sample [s].
        heard: last source, as the socket gave it and in plain form.
    """

    member: bytes
    word: bytes
    puncher: Puncher
    label: int | None = None
    theirs: bytes = b""
    way: Way = Way.TRYING
    address: Address | None = None
    tell: float = -float("inf")
    told: float = -float("inf")
    sent: float = -float("inf")
    heard: tuple[Hashable, Address] | None = None
