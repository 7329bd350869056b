"""The samples that neighbours send each other: datagrams, how they are sealed and reassembled, and their ages."""

from cotouch.samples._address import Address, flaw, numeric, origin, plain_address
from cotouch.samples._ages import AgeWindow, LinkAges
from cotouch.samples._agreement import Agreement
from cotouch.samples._assembly import Assembly
from cotouch.samples._budget import MOST_AGE, BudgetAgreement
from cotouch.samples._chunk import Chunk, Coded, Heading, Refusal, Written
from cotouch.samples._codec import SampleCodec
from cotouch.samples._coded import CodedLink
from cotouch.samples._emulated_path import EmulatedPath, PathLaw
from cotouch.samples._impaired import ImpairedTransport
from cotouch.samples._indexed import IndexedAssembly
from cotouch.samples._keys import DirectionKeys, Entropy, Identity, LinkKeys, signed_by
from cotouch.samples._layout import HEAD_BYTES, Encoding, Layout
from cotouch.samples._limit import Bucket, SourceLimit
from cotouch.samples._plane import SampleLink, SamplePlane
from cotouch.samples._rate import LOWEST_RATE, SendRate, Trend
from cotouch.samples._replay import ReplayWindow
from cotouch.samples._seal import MOST_SEALED, OVERHEAD, RENEW_EVERY, Opened, SealedLink, connection_of
from cotouch.samples._transport import MOST_BYTES, AddressedTransport, Arrival, Traffic, Transport
from cotouch.samples._udp import UdpTransport

__all__ = [
    "HEAD_BYTES",
    "LOWEST_RATE",
    "MOST_AGE",
    "MOST_BYTES",
    "MOST_SEALED",
    "OVERHEAD",
    "RENEW_EVERY",
    "Address",
    "AddressedTransport",
    "AgeWindow",
    "Agreement",
    "Arrival",
    "Assembly",
    "Bucket",
    "BudgetAgreement",
    "Chunk",
    "Coded",
    "CodedLink",
    "DirectionKeys",
    "EmulatedPath",
    "Encoding",
    "Entropy",
    "Heading",
    "Identity",
    "ImpairedTransport",
    "IndexedAssembly",
    "Layout",
    "LinkAges",
    "LinkKeys",
    "Opened",
    "PathLaw",
    "Refusal",
    "ReplayWindow",
    "SampleCodec",
    "SampleLink",
    "SamplePlane",
    "SealedLink",
    "SendRate",
    "SourceLimit",
    "Traffic",
    "Transport",
    "Trend",
    "UdpTransport",
    "Written",
    "connection_of",
    "flaw",
    "numeric",
    "origin",
    "plain_address",
    "signed_by",
]
