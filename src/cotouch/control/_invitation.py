"""The one line that lets somebody take part: where the session is, whose it is, and the secret of the invited."""

import base64
import hashlib
import ipaddress
import re
import struct
from dataclasses import dataclass, field
from typing import NamedTuple, final

from cryptography.hazmat.primitives.hashes import SHA256
from cryptography.hazmat.primitives.kdf.hkdf import HKDF

from cotouch.errors import SessionError
from cotouch.samples import Entropy

_SCHEME = "cotouch:"
_VERSION = 1
_SECRET_BYTES = 16  # 128 bits
_HEAD = struct.Struct(">BH")  # version, length of all
_CHECK_BYTES = 4  # finds slips of the hand, not attackers: who can change an invitation can write another
_MOST_NAME = 64
_MOST_ENDPOINTS = 16
_NAME, _FOUR, _SIX = 0, 4, 6
_HOST_NAME = re.compile(
    r"(?=.{1,253}\Z)[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?(?:\.[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?)*"
)


class Endpoint(NamedTuple):
    """Where a control plane listens.

    Attributes:
        host: address in numbers, IPv4 or IPv6, or a name to be looked up.
        port: of TCP, from 1 to 65535.
    """

    host: str
    port: int

    def __str__(self) -> str:
        return f"[{self.host}]:{self.port}" if ":" in self.host else f"{self.host}:{self.port}"

    @classmethod
    def parse(cls, text: str) -> "Endpoint":
        """Reads `host:port`, or `[host]:port` for IPv6.

        Raises:
            SessionError: the text is no endpoint.
        """
        host, colon, port = text.strip().rpartition(":")
        if host.startswith("[") and host.endswith("]"):
            host = host[1:-1]
        elif ":" in host:
            host = ""
        if not colon or not host or not port.isascii() or not port.isdigit() or len(port) > 5:
            raise SessionError(f"{text!r} is not an endpoint; it must be a host and a port, as in 192.0.2.7:7447")
        return checked(cls(host, int(port)))


def checked(endpoint: Endpoint) -> Endpoint:
    """The endpoint, in the one way to write it.

    Raises:
        SessionError: its host or port cannot be.
    """
    host, port = endpoint
    numeric = _numeric(host)
    if numeric is None and (not _HOST_NAME.fullmatch(host) or host.replace(".", "").isdigit()):
        raise SessionError(f"host {host!r} is neither a numeric address nor a name, such as 192.0.2.7 or example.org")
    if not 1 <= port <= 65535:
        raise SessionError(f"port {port} of {host} is not a number from 1 to 65535")
    return Endpoint(host if numeric is None else str(numeric), port)


@final
@dataclass(frozen=True, kw_only=True)
class Invitation:
    """What only the invited know: hand it over as carefully as a key.

    Attributes:
        session: name for people, 1 to 64 characters.
        host: public key of the host; what it signs about the session is true.
        digest: SHA-256 of the session's description; only that is fetched.
        secret: 16 bytes that only the invited know; certificates are derived from it.
        endpoints: where the host listens.
        routers: where the session's routers listen; if there are any, everybody meets there.
    """

    session: str
    host: bytes
    digest: bytes
    secret: bytes = field(repr=False)
    endpoints: tuple[Endpoint, ...]
    routers: tuple[Endpoint, ...] = ()

    def __post_init__(self) -> None:
        if not 1 <= len(self.session) <= _MOST_NAME or not self.session.isprintable():
            raise SessionError(
                f"the session's name is {self.session!r}; it must be 1 to {_MOST_NAME} printable characters"
            )
        if len(self.host) != 32:
            raise SessionError(f"the host's public key has {len(self.host)} bytes; it must have 32")
        if len(self.digest) != 32:
            raise SessionError(f"the hash of the session's description has {len(self.digest)} bytes; it must have 32")
        if len(self.secret) != _SECRET_BYTES:
            raise SessionError(
                f"the secret of an invitation has {len(self.secret)} bytes; it must have {_SECRET_BYTES}"
            )
        for name in ("endpoints", "routers"):
            given = getattr(self, name)
            if len(given) > _MOST_ENDPOINTS:
                raise SessionError(f"an invitation has {len(given)} {name}; it may have at most {_MOST_ENDPOINTS}")
            object.__setattr__(self, name, tuple(checked(endpoint) for endpoint in given))
        if not self.endpoints and not self.routers:
            raise SessionError("an invitation names no endpoint; it needs one, of the host or of a router")

    @classmethod
    def make(
        cls,
        *,
        session: str,
        host: bytes,
        digest: bytes,
        endpoints: tuple[Endpoint, ...],
        routers: tuple[Endpoint, ...] = (),
        entropy: Entropy,
    ) -> "Invitation":
        """A new one, with a secret of its own.

        Args:
            session: name for people.
            host: public key of the host.
            digest: SHA-256 of the session's description.
            endpoints: where the host listens.
            routers: where the session's routers listen.
            entropy: gives so many bytes that nobody can guess, such as `os.urandom`.

        Raises:
            SessionError: one of them cannot be.
        """
        secret = entropy(_SECRET_BYTES)
        return cls(session=session, host=host, digest=digest, secret=secret, endpoints=endpoints, routers=routers)

    @property
    def id(self) -> bytes:
        """32 bytes that name the session: the same for all invited, whatever endpoints they were told."""
        return self.derive(b"session", 32)

    def derive(self, purpose: bytes, size: int) -> bytes:
        """Bytes that only the invited can make [HKDF-SHA256, RFC 5869].

        Args:
            purpose: what they are for; each has its own.
            size: how many, at most 8160.
        """
        about = hashlib.sha256(self.session.encode()).digest()
        return HKDF(
            SHA256(), size, salt=self.host + self.digest + about, info=b"cotouch invitation 1 " + purpose
        ).derive(self.secret)

    def encode(self) -> str:
        """One line to be pasted."""
        name = self.session.encode()
        body = (
            self.secret
            + self.host
            + self.digest
            + bytes([len(name)])
            + name
            + _packed(self.endpoints)
            + _packed(self.routers)
        )
        body = _HEAD.pack(_VERSION, _HEAD.size + len(body) + _CHECK_BYTES) + body
        return _SCHEME + base64.urlsafe_b64encode(body + _check(body)).decode().rstrip("=")

    @classmethod
    def decode(cls, text: str) -> "Invitation":
        """Reads what `encode` wrote; spaces and line breaks that mail put in are ignored.

        Raises:
            SessionError: it is no invitation, cut off, mistyped or of another version.
        """
        line = "".join(text.split())
        if line[: len(_SCHEME)].lower() != _SCHEME:
            raise SessionError(f"{text[:24]!r} is not an invitation; invitations begin with {_SCHEME!r}")
        line = line[len(_SCHEME) :]
        strange = re.search(r"[^A-Za-z0-9_-]", line)
        if strange:
            raise SessionError(
                f"the invitation contains {strange[0]!r}, which is not allowed; copy the whole line again"
            )
        # The last character may be missing as well as any other; what it stood for is then missing too.
        whole = base64.urlsafe_b64decode(line[: len(line) - (len(line) % 4 == 1)] + "=" * (-len(line) % 4))
        if whole[:1] and whole[0] != _VERSION:
            raise SessionError(f"the invitation has version {whole[0]}, but this cotouch reads version {_VERSION}")
        length = _HEAD.unpack_from(whole)[1] if len(whole) >= _HEAD.size else _HEAD.size + 1
        if len(whole) < length:
            raise SessionError(f"the invitation is cut off: {len(whole)} bytes of {length}; copy the whole line")
        body, check = whole[: length - _CHECK_BYTES], whole[length - _CHECK_BYTES : length]
        if len(whole) != length or len(body) < _HEAD.size or check != _check(body):
            raise SessionError("the invitation has a mistake in it (its checksum is wrong); copy the whole line again")
        try:
            return _read(body)
        except (IndexError, UnicodeDecodeError, struct.error) as error:
            raise SessionError("the invitation was not made by cotouch; ask the host for another") from error


def _read(body: bytes) -> Invitation:
    at = _HEAD.size
    secret, at = body[at : at + _SECRET_BYTES], at + _SECRET_BYTES
    host, at = body[at : at + 32], at + 32
    digest, at = body[at : at + 32], at + 32
    name, at = body[at + 1 : at + 1 + body[at]], at + 1 + body[at]
    endpoints, at = _unpacked(body, at)
    routers, at = _unpacked(body, at)
    if at != len(body):
        raise IndexError(at)
    return Invitation(
        session=name.decode(), host=host, digest=digest, secret=secret, endpoints=endpoints, routers=routers
    )


def _packed(endpoints: tuple[Endpoint, ...]) -> bytes:
    out = bytearray([len(endpoints)])
    for host, port in endpoints:
        numeric = _numeric(host)
        if numeric is None:
            out += bytes([_NAME, len(host)]) + host.encode()
        else:
            out += bytes([numeric.version]) + numeric.packed
        out += struct.pack(">H", port)
    return bytes(out)


def _unpacked(body: bytes, at: int) -> tuple[tuple[Endpoint, ...], int]:
    out, count, at = list[Endpoint](), body[at], at + 1
    for _ in range(count):
        kind, at = body[at], at + 1
        size = {_FOUR: 4, _SIX: 16}.get(kind)
        if size is None:
            size, at = body[at] if kind == _NAME else len(body), at + 1
        raw, at = body[at : at + size], at + size
        if len(raw) != size:
            raise IndexError(at)
        host = raw.decode("ascii") if kind == _NAME else str(ipaddress.ip_address(raw))
        out.append(Endpoint(host, struct.unpack_from(">H", body, at)[0]))
        at += 2
    return tuple(out), at


def _numeric(host: str) -> ipaddress.IPv4Address | ipaddress.IPv6Address | None:
    try:
        return ipaddress.ip_address(host)
    except ValueError:
        return None


def _check(body: bytes) -> bytes:
    return hashlib.sha256(b"cotouch invitation" + body).digest()[:_CHECK_BYTES]
