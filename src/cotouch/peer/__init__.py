"""One user's replica, sans-IO."""

from cotouch.peer._links import ConstantLink, FreshestLink, Link, Sample
from cotouch.peer._peer import Peer, Report

__all__ = ["ConstantLink", "FreshestLink", "Link", "Peer", "Report", "Sample"]
