"""One user's replica, sans-IO."""

from cotouch.peer._codec import MOST_HOLD, Codec, Decoder, Encoder
from cotouch.peer._cuts import CutSet
from cotouch.peer._guard import LinkGuard
from cotouch.peer._guard_ledger import GuardEvent, GuardLedger
from cotouch.peer._law_link import CopyMemory, LawLink
from cotouch.peer._links import NO_HEADER, ConstantLink, FreshestLink, Link, LinkHeader, LinkState, Message, Sample
from cotouch.peer._peer import Peer
from cotouch.peer._report import StepReport

__all__ = [
    "MOST_HOLD",
    "NO_HEADER",
    "Codec",
    "ConstantLink",
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
]
