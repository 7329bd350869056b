"""One user's replica, sans-IO."""

from cotouch.peer._guard import GuardBooks, GuardEvent, LinkGuard
from cotouch.peer._links import COUPLED, GUARDED, READY, UNHEARD, ConstantLink, FreshestLink, Link, Sample, Word
from cotouch.peer._peer import Peer
from cotouch.peer._report import Report

__all__ = [
    "COUPLED",
    "GUARDED",
    "READY",
    "UNHEARD",
    "ConstantLink",
    "FreshestLink",
    "GuardBooks",
    "GuardEvent",
    "Link",
    "LinkGuard",
    "Peer",
    "Report",
    "Sample",
    "Word",
]
