"""What is known of the ways to neighbours, and how it is told."""

from collections.abc import Hashable
from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.samples import Address
from cotouch.traversal._path_prober import PathProber, PathState


class ByRelay(NamedTuple):
    """Source of a datagram that arrived over the control plane.

    Attributes:
        member: public key of the member it says it is from.
    """

    member: bytes


class PathChanged(NamedTuple):
    """A neighbour is reached by another path.

    Attributes:
        neighbour: index of the user.
        time: [s].
        path_state: from now on.
        address: where it answers, if `DIRECT`.
    """

    neighbour: int
    time: float
    path_state: PathState
    address: Address | None


@final
@dataclass(eq=False)
class Known:
    """What is held of a neighbour that was introduced.

    Attributes:
        member: its public key.
        nonce: this end's part of the pair's keys.
        prober: finds the way.
        label: of its probes, once there are keys.
        theirs: its part of the keys.
        path_state: as last noted.
        address: where it is sent to, if `DIRECT`.
        tell: when candidates are to be said again [s].
        announced: when they last were [s].
        sent: when it was last sent a sample [s].
        received: last source, as the socket gave it and in plain form.
    """

    member: bytes
    nonce: bytes
    prober: PathProber
    label: int | None = None
    theirs: bytes = b""
    path_state: PathState = PathState.TRYING
    address: Address | None = None
    tell: float = -float("inf")
    announced: float = -float("inf")
    sent: float = -float("inf")
    received: tuple[Hashable, Address] | None = None
