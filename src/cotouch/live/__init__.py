"""One real peer: its samples over real networks. Sessions, control and pacing are not here yet."""

from cotouch.live._address import Address
from cotouch.live._ages import LinkAges, Window
from cotouch.live._agreement import Agreement, Progress
from cotouch.live._assembly import Assembly
from cotouch.live._candidates import (
    MOST_CANDIDATES,
    Candidate,
    Offer,
    Origin,
    local_candidates,
    read_offer,
    write_offer,
)
from cotouch.live._codec import AGED, ECHO, RENEW, Chunk, Codec, Heading, Written
from cotouch.live._interfaces import interface_hosts
from cotouch.live._keys import DirectionKeys, Entropy, Identity, LinkKeys
from cotouch.live._layout import HEAD_BYTES, Coding, Layout
from cotouch.live._limit import Bucket, SourceLimit
from cotouch.live._memory import MemoryNetwork, MemoryTransport
from cotouch.live._path import Path, PathLaw
from cotouch.live._plane import SampleLink, SamplePlane
from cotouch.live._probe import PROBE, PairKeys, member_key, pair_keys
from cotouch.live._puncher import Probe, Puncher, Way
from cotouch.live._rate import SendRate, Trend
from cotouch.live._reflexive import Lookup, Mirror
from cotouch.live._refusal import Refusal
from cotouch.live._replay import ReplayWindow
from cotouch.live._routed import RoutedTransport
from cotouch.live._seal import MOST_SEALED, OVERHEAD, RENEW_AFTER, Opened, SealedLink, connection_of
from cotouch.live._transport import MOST_BYTES, Arrival, Ground, Traffic, Transport
from cotouch.live._udp import UdpTransport
from cotouch.live._ways import ByRelay, WayChanged

__all__ = [
    "AGED",
    "ECHO",
    "HEAD_BYTES",
    "MOST_BYTES",
    "MOST_CANDIDATES",
    "MOST_SEALED",
    "OVERHEAD",
    "PROBE",
    "RENEW",
    "RENEW_AFTER",
    "Address",
    "Agreement",
    "Arrival",
    "Assembly",
    "Bucket",
    "ByRelay",
    "Candidate",
    "Chunk",
    "Codec",
    "Coding",
    "DirectionKeys",
    "Entropy",
    "Ground",
    "Heading",
    "Identity",
    "Layout",
    "LinkAges",
    "LinkKeys",
    "Lookup",
    "MemoryNetwork",
    "MemoryTransport",
    "Mirror",
    "Offer",
    "Opened",
    "Origin",
    "PairKeys",
    "Path",
    "PathLaw",
    "Probe",
    "Progress",
    "Puncher",
    "Refusal",
    "ReplayWindow",
    "RoutedTransport",
    "SampleLink",
    "SamplePlane",
    "SealedLink",
    "SendRate",
    "SourceLimit",
    "Traffic",
    "Transport",
    "Trend",
    "UdpTransport",
    "Way",
    "WayChanged",
    "Window",
    "Written",
    "connection_of",
    "interface_hosts",
    "local_candidates",
    "member_key",
    "pair_keys",
    "read_offer",
    "write_offer",
]
