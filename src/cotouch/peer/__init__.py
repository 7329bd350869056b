"""One user's replica, without sockets or clocks."""

from cotouch.peer._codec import Decoder, Encoder
from cotouch.peer._content import FULL, MOST_HOLD, ROUNDED, Codec, Content, ContentForm
from cotouch.peer._cuts import CutSet, without_debris
from cotouch.peer._guard import LinkGuard
from cotouch.peer._guard_ledger import GuardEvent, GuardLedger
from cotouch.peer._law_link import CopyMemory, LawLink
from cotouch.peer._links import (
    MOST_AHEAD,
    NO_HEADER,
    ConstantLink,
    FreshestLink,
    Link,
    LinkHeader,
    LinkState,
    Message,
    Sample,
)
from cotouch.peer._peer import Peer
from cotouch.peer._report import StepReport

__all__ = [
    "FULL",
    "MOST_AHEAD",
    "MOST_HOLD",
    "NO_HEADER",
    "ROUNDED",
    "Codec",
    "ConstantLink",
    "Content",
    "ContentForm",
    "CopyMemory",
    "CutSet",
    "Decoder",
    "Encoder",
    "FreshestLink",
    "GuardEvent",
    "GuardLedger",
    "LawLink",
    "Link",
    "LinkGuard",
    "LinkHeader",
    "LinkState",
    "Message",
    "Peer",
    "Sample",
    "StepReport",
    "without_debris",
]
