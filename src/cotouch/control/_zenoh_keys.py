"""Under which keys members speak over Zenoh; who reads one takes anything in it, for anybody invited writes there.

    said, via, relay, pass     sender, receiver     messages and datagrams, straight and for the host to hand on
    beat                       sender, everybody    presence
    alive                      member, start, place who is connected, and where it listens

Keys that are subscribed to have their subscriber's name, so that no two members subscribe to the same: Zenoh keeps what
it knows of a member for ever if that had subscribed to a key that lives on here (5 kB for each that ever came; upstream
issue 2393).
"""

import base64
from typing import Literal, NamedTuple, final

from cotouch.control._invitation import Endpoint, Invitation, checked

Kind = Literal["said", "via", "relay", "pass", "beat"]
# In place of a member's name: everybody.
_EVERYBODY = "*"
_NOWHERE = "-"


class Start(NamedTuple):
    """One start of a member, as a key tells.

    Attributes:
        member: its public key.
        name: of this start: the end of an earlier one does not hide a later one.
        at: where it says it listens; None: nowhere, or nothing that can be read.
    """

    member: bytes
    name: str
    at: Endpoint | None


@final
class SessionKeys:
    """One member's keys in one session.

    Attributes:
        prefix: of all keys of the session.
        me: this member's name in them.
    """

    def __init__(self, invitation: Invitation, me: bytes) -> None:
        """Names the session.

        Args:
            invitation: to it.
            me: this member's public key.
        """
        self.prefix = f"cotouch/{invitation.id[:16].hex()}"
        self.me = me.hex()

    def to(self, kind: Kind, receiver: bytes | None = None) -> str:
        """Of what this member says.

        Args:
            kind: of message.
            receiver: its public key; None: everybody.
        """
        return f"{self.prefix}/{kind}/{self.me}/{_EVERYBODY if receiver is None else receiver.hex()}"

    def mine(self, kind: Kind) -> str:
        """Of all that is said to this member."""
        return f"{self.prefix}/{kind}/*/{self.me}"

    @property
    def starts(self) -> str:
        """Of all members' starts."""
        return f"{self.prefix}/alive/*/*/*"

    def start(self, name: str, at: Endpoint | None) -> str:
        """Of a start of this member.

        Args:
            name: of the start, unlike any other's.
            at: where it listens.
        """
        place = _NOWHERE if at is None else base64.urlsafe_b64encode(str(at).encode()).decode().rstrip("=")
        return f"{self.prefix}/alive/{self.me}/{name}/{place}"


def sender_of(key: str) -> bytes | None:
    """Public key of the member that is said to say this; None: no member's."""
    return _member(key.split("/")[3:4])


def start_of(key: str) -> Start | None:
    """The start that a key tells of; None: of none."""
    parts = key.split("/")
    member = _member(parts[3:4])
    return None if member is None or len(parts) != 6 else Start(member, parts[4], _endpoint(parts[5]))


def _member(parts: list[str]) -> bytes | None:
    try:
        out = bytes.fromhex(parts[0])
    except (ValueError, IndexError):
        return None
    return out if len(out) == 32 else None


def _endpoint(text: str) -> Endpoint | None:
    if text == _NOWHERE or len(text) > 400:
        return None
    try:
        return checked(Endpoint.parse(base64.urlsafe_b64decode(text + "=" * (-len(text) % 4)).decode()))
    except ValueError:  # of base64, of UTF-8, or of the endpoint
        return None
