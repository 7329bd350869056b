"""Recordings of live peers: written off the loop, read back, played, exported and audited."""

from cotouch.recording._audit import audit
from cotouch.recording._audited import Audit, UserLedger
from cotouch.recording._body import RecordedBody
from cotouch.recording._columns import ADVANCED, EXCHANGE, GUARDS, HOW_SAID, SAID
from cotouch.recording._dataset import recordings_dataset, save_dataset
from cotouch.recording._disk import NewFile
from cotouch.recording._figures import audit_figure, save_audit_figures
from cotouch.recording._findings import AuditFinding
from cotouch.recording._header import RecordHeader
from cotouch.recording._links import LinkLedger
from cotouch.recording._play import Replayed, replay
from cotouch.recording._reader import read_recording
from cotouch.recording._recorder import Recorded, Recorder, both_clocks
from cotouch.recording._recording import RecordedEvent, Recording, Setup

__all__ = [
    "ADVANCED",
    "EXCHANGE",
    "GUARDS",
    "HOW_SAID",
    "SAID",
    "Audit",
    "AuditFinding",
    "LinkLedger",
    "NewFile",
    "RecordHeader",
    "Recorded",
    "RecordedBody",
    "RecordedEvent",
    "Recorder",
    "Recording",
    "Replayed",
    "Setup",
    "UserLedger",
    "audit",
    "audit_figure",
    "both_clocks",
    "read_recording",
    "recordings_dataset",
    "replay",
    "save_audit_figures",
    "save_dataset",
]
