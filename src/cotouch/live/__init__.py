"""One real peer: its samples over real networks. Sessions, control and pacing are not here yet."""

from cotouch.live._ages import LinkAges, Window
from cotouch.live._agreement import Agreement, Progress
from cotouch.live._assembly import Assembly
from cotouch.live._budget import BudgetAgreement
from cotouch.live._codec import AGED, ECHO, RENEW, Chunk, Codec, Heading, Written
from cotouch.live._indexed import IndexedAssembly
from cotouch.live._keys import DirectionKeys, Entropy, Identity, LinkKeys
from cotouch.live._layout import HEAD_BYTES, Coding, Layout
from cotouch.live._limit import Bucket, SourceLimit
from cotouch.live._memory import MemoryNetwork, MemoryTransport
from cotouch.live._path import Path, PathLaw
from cotouch.live._plane import SampleLink, SamplePlane
from cotouch.live._rate import SendRate, Trend
from cotouch.live._refusal import Refusal
from cotouch.live._replay import ReplayWindow
from cotouch.live._seal import MOST_SEALED, OVERHEAD, RENEW_AFTER, Opened, SealedLink, connection_of
from cotouch.live._transport import MOST_BYTES, Arrival, Traffic, Transport
from cotouch.live._udp import Address, UdpTransport

__all__ = [
    "AGED",
    "ECHO",
    "HEAD_BYTES",
    "MOST_BYTES",
    "MOST_SEALED",
    "OVERHEAD",
    "RENEW",
    "RENEW_AFTER",
    "Address",
    "Agreement",
    "Arrival",
    "Assembly",
    "Bucket",
    "BudgetAgreement",
    "Chunk",
    "Codec",
    "Coding",
    "DirectionKeys",
    "Entropy",
    "Heading",
    "Identity",
    "IndexedAssembly",
    "Layout",
    "LinkAges",
    "LinkKeys",
    "MemoryNetwork",
    "MemoryTransport",
    "Opened",
    "Path",
    "PathLaw",
    "Progress",
    "Refusal",
    "ReplayWindow",
    "SampleLink",
    "SamplePlane",
    "SealedLink",
    "SendRate",
    "SourceLimit",
    "Traffic",
    "Transport",
    "Trend",
    "UdpTransport",
    "Window",
    "Written",
    "connection_of",
]
