"""What live peers did, on disk: recorded off the loop, read back, played, exported, audited."""

from cotouch.recording._audit import Audit, UserBooks, audit
from cotouch.recording._body import RecordedBody
from cotouch.recording._columns import EXCHANGE, GUARDS, LinkPhase
from cotouch.recording._dataset import recordings_dataset, save_dataset
from cotouch.recording._figures import audit_figure, save_audit_figures
from cotouch.recording._findings import Finding
from cotouch.recording._header import RecordHeader
from cotouch.recording._links import LinkBooks
from cotouch.recording._play import Played, play
from cotouch.recording._reader import read_recording
from cotouch.recording._recorder import Recorded, Recorder, both_clocks
from cotouch.recording._recording import Event, Recording, Setup

__all__ = [
    "EXCHANGE",
    "GUARDS",
    "Audit",
    "Event",
    "Finding",
    "LinkBooks",
    "LinkPhase",
    "Played",
    "RecordHeader",
    "Recorded",
    "RecordedBody",
    "Recorder",
    "Recording",
    "Setup",
    "UserBooks",
    "audit",
    "audit_figure",
    "both_clocks",
    "play",
    "read_recording",
    "recordings_dataset",
    "save_audit_figures",
    "save_dataset",
]
