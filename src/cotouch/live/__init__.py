"""One real peer: its samples, its control plane and its pace over real networks."""

from cotouch.live._address import Address
from cotouch.live._addresses import Addresses, Place
from cotouch.live._ages import AgeWindow, LinkAges
from cotouch.live._agreement import Agreement, Progress
from cotouch.live._assembly import Assembly
from cotouch.live._budget import MOST_AGE, BudgetAgreement
from cotouch.live._candidates import (
    MOST_CANDIDATES,
    Candidate,
    CandidateKind,
    Offer,
    local_candidates,
    read_offer,
    write_offer,
)
from cotouch.live._certificates import TlsCertificates, make_certificates
from cotouch.live._codec import AGED, ECHO, RENEW, Chunk, Codec, Heading, Written
from cotouch.live._control import ControlPlane, Message, Relayed
from cotouch.live._control_memory import MemoryControl, MemoryControlNetwork
from cotouch.live._control_router import ControlRouter
from cotouch.live._control_zenoh import ZenohControl
from cotouch.live._emulated_path import EmulatedPath, PathLaw
from cotouch.live._files import MOST_FILE
from cotouch.live._impaired import ImpairedTransport
from cotouch.live._indexed import IndexedAssembly
from cotouch.live._interfaces import interface_hosts
from cotouch.live._invitation import Endpoint, Invitation
from cotouch.live._keys import DirectionKeys, Entropy, Identity, LinkKeys
from cotouch.live._layout import HEAD_BYTES, Encoding, Layout
from cotouch.live._limit import Bucket, SourceLimit
from cotouch.live._listening import free_port, towards
from cotouch.live._memory import MemoryNetwork, MemoryTransport
from cotouch.live._path_prober import PathProber, PathState, Probe
from cotouch.live._paths import ByRelay, PathChanged
from cotouch.live._plane import SampleLink, SamplePlane
from cotouch.live._presence import Presence
from cotouch.live._probe import PROBE, PairKeys, member_key, pair_keys
from cotouch.live._rate import LOWEST_RATE, SendRate, Trend
from cotouch.live._reflexive import Lookup, Mirror
from cotouch.live._refusal import Refusal
from cotouch.live._replay import ReplayWindow
from cotouch.live._routed import RoutedTransport
from cotouch.live._seal import MOST_SEALED, OVERHEAD, RENEW_AFTER, RENEW_EVERY, Opened, SealedLink, connection_of
from cotouch.live._sign import MOST_BODY, MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter
from cotouch.live._transport import MOST_BYTES, Arrival, Ground, Traffic, Transport
from cotouch.live._udp import UdpTransport
from cotouch.pacing import Pacer, PaceStatistics, ProcessState, Turn, few_arenas, prepare_process

__all__ = [
    "AGED",
    "ECHO",
    "HEAD_BYTES",
    "LOWEST_RATE",
    "MOST_AGE",
    "MOST_BODY",
    "MOST_BYTES",
    "MOST_CANDIDATES",
    "MOST_FILE",
    "MOST_MESSAGE",
    "MOST_SEALED",
    "OVERHEAD",
    "PROBE",
    "RENEW",
    "RENEW_AFTER",
    "RENEW_EVERY",
    "Address",
    "Addresses",
    "AgeWindow",
    "Agreement",
    "Arrival",
    "Assembly",
    "Bucket",
    "BudgetAgreement",
    "ByRelay",
    "Candidate",
    "CandidateKind",
    "Chunk",
    "Codec",
    "ControlPlane",
    "ControlRouter",
    "DirectionKeys",
    "EmulatedPath",
    "Encoding",
    "Endpoint",
    "Entropy",
    "Ground",
    "Heading",
    "Identity",
    "ImpairedTransport",
    "IndexedAssembly",
    "Invitation",
    "Layout",
    "LinkAges",
    "LinkKeys",
    "Lookup",
    "MemoryControl",
    "MemoryControlNetwork",
    "MemoryNetwork",
    "MemoryTransport",
    "Message",
    "MessageReader",
    "MessageRefusal",
    "MessageWriter",
    "Mirror",
    "Offer",
    "Opened",
    "PaceStatistics",
    "Pacer",
    "PairKeys",
    "PathChanged",
    "PathLaw",
    "PathProber",
    "PathState",
    "Place",
    "Presence",
    "Probe",
    "ProcessState",
    "Progress",
    "Refusal",
    "Relayed",
    "ReplayWindow",
    "RoutedTransport",
    "SampleLink",
    "SamplePlane",
    "SealedLink",
    "SendRate",
    "SourceLimit",
    "TlsCertificates",
    "Traffic",
    "Transport",
    "Trend",
    "Turn",
    "UdpTransport",
    "Written",
    "ZenohControl",
    "connection_of",
    "few_arenas",
    "free_port",
    "interface_hosts",
    "local_candidates",
    "make_certificates",
    "member_key",
    "pair_keys",
    "prepare_process",
    "read_offer",
    "towards",
    "write_offer",
]
