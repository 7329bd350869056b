"""Where a member of the control plane listens, and where others find it."""

import ipaddress
import socket
from typing import final

from cotouch.control._invitation import Endpoint, Invitation, checked
from cotouch.errors import SessionError, TransportError

# This machine's address towards the host is looked at this often [s].
_LOOK = 0.5


@final
class Whereabouts:
    """The address by which this machine reaches the host, looked at now and then.

    Attributes:
        here: that it had when its owner went there; None: it has none, or nobody asks.
    """

    def __init__(self, invitation: Invitation | None) -> None:
        """Looks for the first time.

        Args:
            invitation: names the host; None: this is the host's machine.
        """
        self._invitation = invitation
        self._looked = 0.0
        self.here = None if invitation is None else towards(invitation)

    def look(self, now: float) -> str | None:
        """Where this machine is now, if it no longer has the address that it had; None: it has, or is nowhere.

        Args:
            now: asked more often than twice a second, the answer is None [s].
        """
        if self._invitation is None or self.here is None or now < self._looked + _LOOK:
            return None
        self._looked = now
        found = towards(self._invitation)
        return None if found == self.here or is_ours(self.here) else found


def free_port(host: str = "127.0.0.1") -> int:
    """A TCP port on which nobody listens now: an invitation must name one before the host listens.

    Args:
        host: address to listen on, in numbers.

    Raises:
        TransportError: this is no address of this machine.
    """
    try:
        with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_STREAM) as probe:
            probe.bind((host, 0))
            return int(probe.getsockname()[1])
    except OSError as error:
        raise TransportError(f"{host} is not an address of this machine; listen on one that is") from error


def listening(invitation: Invitation, listen: Endpoint | str | None, *, host: bool) -> tuple[Endpoint, ...]:
    """The endpoints to listen on.

    Args:
        invitation: to the session.
        listen: as `ZenohControl` takes it.
        host: whether this member is the host.

    Raises:
        SessionError: this is no address.
        TransportError: no port is free there, or there is no way to the host.
    """
    if isinstance(listen, Endpoint):
        return (checked(listen),)
    if listen is None and host:
        return invitation.endpoints
    address = "127.0.0.1" if listen is None else _towards(invitation) if listen == "reachable" else listen
    try:
        address = str(ipaddress.ip_address(address))
    except ValueError:
        raise SessionError(f"{address!r} is not a numeric address; listen on one, or on 'reachable'") from None
    return (checked(Endpoint(address, free_port(address))),)


def advertised(at: Endpoint, invitation: Invitation) -> Endpoint:
    """Where others find who listens there: on all addresses, the one towards the host.

    Args:
        at: endpoint in question.
        invitation: of the session.
    """
    return Endpoint(_towards(invitation), at.port) if at.host in {"0.0.0.0", "::"} else at  # noqa: S104


def towards(invitation: Invitation) -> str | None:
    """The address from which this machine now reaches the host, or None. Nothing is sent."""
    try:
        return _towards(invitation)
    except TransportError:
        return None


def is_ours(host: str) -> bool:
    """Whether this machine has this address now."""
    try:
        with socket.socket(socket.AF_INET6 if ":" in host else socket.AF_INET, socket.SOCK_DGRAM) as probe:
            probe.bind((host, 0))
    except OSError:
        return False
    return True


def _towards(invitation: Invitation) -> str:
    """The address by which this machine reaches the host; nothing is sent."""
    for host, port in invitation.endpoints:
        try:
            family, _, _, _, to = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            with socket.socket(family, socket.SOCK_DGRAM) as probe:
                probe.connect(to)
                return str(probe.getsockname()[0])
        except OSError:
            continue
    raise TransportError(f"this machine has no route to {', '.join(map(str, invitation.endpoints))}; check its network")
