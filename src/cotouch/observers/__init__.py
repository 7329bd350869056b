"""What observers of a session, such as the page, can see of it and request, through latest-value channels."""

from cotouch.observers._child import ChildCall
from cotouch.observers._command_client import CommandClient, RecordingOutcome
from cotouch.observers._commands import (
    COMMANDS,
    FARTHEST,
    HAND_MODES,
    MOST_TURN,
    ChooseLinks,
    Command,
    Cut,
    Doable,
    Expel,
    HandMode,
    Impair,
    Kill,
    MoveHand,
    Revive,
    SetDamping,
    SetRecording,
    read_command,
)
from cotouch.observers._jobs import Jobs
from cotouch.observers._lowered import LoweredDamping
from cotouch.observers._mailboxes import HandCommand, MailboxFolder, mailbox_folder, size_of, view_fields
from cotouch.observers._moment import LastMoment
from cotouch.observers._recording import RecordingClient
from cotouch.observers._session_api import (
    CopyView,
    Emulated,
    HandView,
    Overview,
    Pointer,
    RecordingState,
    Scene,
    SessionApi,
)
from cotouch.observers._telemetry import TelemetryPublisher

__all__ = [
    "COMMANDS",
    "FARTHEST",
    "HAND_MODES",
    "MOST_TURN",
    "ChildCall",
    "ChooseLinks",
    "Command",
    "CommandClient",
    "CopyView",
    "Cut",
    "Doable",
    "Emulated",
    "Expel",
    "HandCommand",
    "HandMode",
    "HandView",
    "Impair",
    "Jobs",
    "Kill",
    "LastMoment",
    "LoweredDamping",
    "MailboxFolder",
    "MoveHand",
    "Overview",
    "Pointer",
    "RecordingClient",
    "RecordingOutcome",
    "RecordingState",
    "Revive",
    "Scene",
    "SessionApi",
    "SetDamping",
    "SetRecording",
    "TelemetryPublisher",
    "mailbox_folder",
    "read_command",
    "size_of",
    "view_fields",
]
