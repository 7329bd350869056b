"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.control._gatekeeper import Gatekeeper
from cotouch.control._gatekeeper import _context as tls_context
from cotouch.control._gatekeeper import _main as keep_gate
from cotouch.control._introducer import Introducer, answering
from cotouch.control._invitation import _check as check_of
from cotouch.control._line import Line
from cotouch.control._listening import is_ours
from cotouch.control._pairs import PairTags
from cotouch.control._presence import WINDOW
from cotouch.control._sockets import sockets, tend_links
from cotouch.control._zenoh import open_session
from cotouch.control._zenoh_keys import SessionKeys, sender_of, start_of

__all__ = [
    "WINDOW",
    "Gatekeeper",
    "Introducer",
    "Line",
    "PairTags",
    "SessionKeys",
    "answering",
    "check_of",
    "is_ours",
    "keep_gate",
    "open_session",
    "sender_of",
    "sockets",
    "start_of",
    "tend_links",
    "tls_context",
]
