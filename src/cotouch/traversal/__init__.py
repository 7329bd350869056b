"""How datagrams find their way: candidates, probes and relays, behind NATs and after a change of address."""

from cotouch.traversal._addresses import Addresses, Place
from cotouch.traversal._candidates import (
    MOST_CANDIDATES,
    Candidate,
    CandidateKind,
    local_candidates,
    read_offer,
    write_offer,
)
from cotouch.traversal._interfaces import interface_hosts
from cotouch.traversal._path_prober import PathProber, PathState
from cotouch.traversal._paths import ByRelay, PathChanged
from cotouch.traversal._probe import PROBE, PairKeys, member_key, pair_keys
from cotouch.traversal._reflexive import Lookup, Mirror
from cotouch.traversal._routed import RoutedTransport

__all__ = [
    "MOST_CANDIDATES",
    "PROBE",
    "Addresses",
    "ByRelay",
    "Candidate",
    "CandidateKind",
    "Lookup",
    "Mirror",
    "PairKeys",
    "PathChanged",
    "PathProber",
    "PathState",
    "Place",
    "RoutedTransport",
    "interface_hosts",
    "local_candidates",
    "member_key",
    "pair_keys",
    "read_offer",
    "write_offer",
]
