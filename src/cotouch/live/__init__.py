"""One real peer: its samples and its control plane over real networks. Sessions and pacing are not here yet."""

from cotouch.live._ages import LinkAges, Window
from cotouch.live._agreement import Agreement, Progress
from cotouch.live._assembly import Assembly
from cotouch.live._certificates import Certificates, make_certificates
from cotouch.live._codec import AGED, ECHO, RENEW, Chunk, Codec, Heading, Written
from cotouch.live._control import ControlPlane, Message, Relayed
from cotouch.live._control_memory import MemoryControl, MemoryControlNetwork
from cotouch.live._control_router import ControlRouter
from cotouch.live._control_zenoh import ZenohControl, free_port
from cotouch.live._files import MOST_FILE
from cotouch.live._invitation import Endpoint, Invitation
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
from cotouch.live._sign import MOST_BODY, MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter
from cotouch.live._transport import MOST_BYTES, Arrival, Traffic, Transport
from cotouch.live._udp import Address, UdpTransport

__all__ = [
    "AGED",
    "ECHO",
    "HEAD_BYTES",
    "MOST_BODY",
    "MOST_BYTES",
    "MOST_FILE",
    "MOST_MESSAGE",
    "MOST_SEALED",
    "OVERHEAD",
    "RENEW",
    "RENEW_AFTER",
    "Address",
    "Agreement",
    "Arrival",
    "Assembly",
    "Bucket",
    "Certificates",
    "Chunk",
    "Codec",
    "Coding",
    "ControlPlane",
    "ControlRouter",
    "DirectionKeys",
    "Endpoint",
    "Entropy",
    "Heading",
    "Identity",
    "Invitation",
    "Layout",
    "LinkAges",
    "LinkKeys",
    "MemoryControl",
    "MemoryControlNetwork",
    "MemoryNetwork",
    "MemoryTransport",
    "Message",
    "MessageReader",
    "MessageRefusal",
    "MessageWriter",
    "Opened",
    "Path",
    "PathLaw",
    "Progress",
    "Refusal",
    "Relayed",
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
    "ZenohControl",
    "connection_of",
    "free_port",
    "make_certificates",
]
