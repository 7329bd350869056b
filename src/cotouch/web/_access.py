"""Who may talk to the server: the Host it is called by, the Origin of pages, the token, and how much of it."""

import hmac
import ipaddress
import secrets
from typing import Final, final
from urllib.parse import urlsplit

LOOPBACK: Final = frozenset({"localhost", "127.0.0.1", "::1"})
# Nothing is loaded from elsewhere, nothing may frame the page, and what it is called by goes to nobody.
HEADERS: Final = (
    (
        "Content-Security-Policy",
        "default-src 'self'; connect-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'",
    ),
    ("Referrer-Policy", "no-referrer"),
    ("X-Content-Type-Options", "nosniff"),
    ("X-Frame-Options", "DENY"),
    ("Cross-Origin-Opener-Policy", "same-origin"),
    ("Cross-Origin-Resource-Policy", "same-origin"),
    ("Permissions-Policy", "camera=(), microphone=(), geolocation=()"),
)


def host_of(header: str) -> str | None:
    """The name or address in a Host header, without port and brackets; None if it is none."""
    try:
        parts = urlsplit(f"//{header}")
        parts.port  # noqa: B018 - raises where it is no number
    except ValueError:
        return None
    plain = parts.username is None and not parts.path and not parts.query and not parts.fragment
    return parts.hostname if plain else None


@final
class Access:
    """What is let in.

    Attributes:
        token: with which a page may act.
    """

    def __init__(self, *, listen: str, token: str) -> None:
        """Prepares the rules.

        Args:
            listen: address that the server listens on; one for all ("0.0.0.0") admits each address of this machine by
                its own number, never a name, because a name can be made to point here.
            token: see the class.
        """
        self.token = token
        self._tickets = set[str]()
        self._listen = listen.strip("[]").lower()

    def host_allowed(self, header: str | None, arrived_at: str | None) -> bool:
        """Whether a request calls the server by an address that it has.

        Args:
            header: Host.
            arrived_at: the address of this machine that the connection came to.
        """
        name = None if header is None else host_of(header)
        if name is None:
            return False
        if name in LOOPBACK:
            return arrived_at is None or is_loopback(arrived_at)
        if name == self._listen:
            return True
        return arrived_at is not None and _same(name, arrived_at)

    @staticmethod
    def origin_allowed(origin: str | None, host: str | None, *, needed: bool) -> bool:
        """Whether a request comes from a page of this server, by the name that it was called by.

        Args:
            origin: the header; browsers send it with every WebSocket.
            host: the header.
            needed: whether it must be there.
        """
        if origin is None:
            return not needed
        return host is not None and origin.lower() == f"http://{host.lower()}"

    def token_right(self, token: str | None) -> bool:
        """Whether somebody has the token; takes as long whatever is wrong with it."""
        return token is not None and _equal(self.token, token)

    def ticket(self) -> str:
        """What is good for the token, once: for a command line, which every user of this machine can read."""
        made = secrets.token_urlsafe(24)
        self._tickets.add(made)
        return made

    def redeemed(self, ticket: str | None) -> bool:
        """Whether a ticket was good; it is not any more."""
        found = next((one for one in self._tickets if ticket is not None and _equal(one, ticket)), None)
        self._tickets.discard(found or "")
        return found is not None


def is_loopback(address: str) -> bool:
    """Whether an address, in numbers, leads nowhere but to this machine."""
    return _number(address) is not None and ipaddress.ip_address(_plain(address)).is_loopback


def _equal(right: str, given: str) -> bool:
    return hmac.compare_digest(given.encode(errors="replace"), right.encode())


def _same(one: str, other: str) -> bool:
    return _number(one) is not None and _number(one) == _number(other)


def _number(address: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(_plain(address))
    except ValueError:
        return None


def _plain(address: str) -> str:
    """IPv4 in IPv6 as IPv4, without a zone."""
    return address.partition("%")[0].removeprefix("::ffff:")
