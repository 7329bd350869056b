"""What all members must agree on: invitations, signed messages, presence and files, over Zenoh."""

from cotouch.control._certificates import TlsCertificates, make_certificates
from cotouch.control._control import ControlPlane, Relayed, SignedMessage
from cotouch.control._control_router import ControlRouter
from cotouch.control._control_zenoh import ZenohControl
from cotouch.control._invitation import Endpoint, Invitation
from cotouch.control._listening import free_port, towards
from cotouch.control._presence import Presence
from cotouch.control._sign import MOST_BODY, MOST_MESSAGE, MessageReader, MessageRefusal, MessageWriter

__all__ = [
    "MOST_BODY",
    "MOST_MESSAGE",
    "ControlPlane",
    "ControlRouter",
    "Endpoint",
    "Invitation",
    "MessageReader",
    "MessageRefusal",
    "MessageWriter",
    "Presence",
    "Relayed",
    "SignedMessage",
    "TlsCertificates",
    "ZenohControl",
    "free_port",
    "make_certificates",
    "towards",
]
