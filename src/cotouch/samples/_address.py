"""Where a socket is, in numbers, and which of these a datagram may be sent to."""

import ipaddress
from functools import lru_cache
from typing import NamedTuple

from cotouch.errors import SessionError


class Address(NamedTuple):
    """Where a neighbour is, in numbers: names are resolved elsewhere, where there is time for it."""

    host: str
    port: int


Numeric = ipaddress.IPv4Address | ipaddress.IPv6Address


@lru_cache(1024)
def numeric(host: str) -> Numeric:
    """The host as a number.

    Raises:
        SessionError: it is a name, or nothing at all.
    """
    try:
        return ipaddress.ip_address(host)
    except ValueError:
        raise SessionError(f"host {host!r} is not a numeric address, such as 127.0.0.1 or ::1") from None


def plain_address(source: object) -> Address | None:
    """A datagram's source in a comparable form: IPv4 within IPv6 becomes IPv4. None: it is not an address."""
    match source:
        case (str(host), int(port)) if isinstance(source, tuple):
            pass
        case _:
            return None
    try:
        number = ipaddress.ip_address(host)
    except ValueError:
        return None
    if number.version == 6 and number.ipv4_mapped is not None:
        number = number.ipv4_mapped
    return Address(str(number), port)


def flaw(address: Address) -> str | None:
    """Why nothing must be sent to an address, whoever asks for it; None: it may be a member's address.

    Args:
        address: in plain form.
    """
    number = ipaddress.ip_address(address.host)
    if not 0 < address.port < 1 << 16:
        return "port"
    if number.is_multicast:
        return "multicast"
    if number.is_unspecified:
        return "unspecified"
    if number.version == 6 and number.is_link_local:
        return "link-local"  # it takes the name of an interface, which means nothing elsewhere
    if number.version == 4 and (int(number) >> 28 == 15 or int(number) >> 24 == 0):
        return "reserved"  # 240.0.0.0/4 with the broadcast address, and 0.0.0.0/8
    return None


def origin(host: str) -> str:
    """The part of an address that its owner cannot change at will: an IPv4 address, or a 64-bit network."""
    return host if ":" not in host else ":".join(host.split(":")[:4])
