"""What who watches a session sees of it, and may ask for: the page's side, through latest-value channels."""

from cotouch.observers._child import ChildCall
from cotouch.observers._command_client import CommandClient
from cotouch.observers._jobs import Jobs
from cotouch.observers._lowered import LoweredDamping
from cotouch.observers._mailboxes import HandCommand, MailboxFolder, mailbox_folder, size_of
from cotouch.observers._moment import LastMoment
from cotouch.observers._recording import RecordingClient
from cotouch.observers._session_api import (
    HAND_MODES,
    CopyView,
    Emulated,
    HandMode,
    HandView,
    Overview,
    Pointer,
    RecordingState,
    Scene,
    SessionApi,
)
from cotouch.observers._telemetry import TelemetryPublisher

__all__ = [
    "HAND_MODES",
    "ChildCall",
    "CommandClient",
    "CopyView",
    "Emulated",
    "HandCommand",
    "HandMode",
    "HandView",
    "Jobs",
    "LastMoment",
    "LoweredDamping",
    "MailboxFolder",
    "Overview",
    "Pointer",
    "RecordingClient",
    "RecordingState",
    "Scene",
    "SessionApi",
    "TelemetryPublisher",
    "mailbox_folder",
    "size_of",
]
