"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.haptics._ends import _End as End
from cotouch.haptics._guardian import ServoWatch
from cotouch.haptics._mailboxes import OrderReader, OrderWriter, ReportReader, ReportWriter, Watched
from cotouch.haptics._quaternions import way_back
from cotouch.haptics._safety import STOOD
from cotouch.haptics._servo import _hung_up as hung_up
from cotouch.haptics._simulated import with_wrist
from cotouch.haptics._warning_log import USUAL, WarningLog

__all__ = [
    "STOOD",
    "USUAL",
    "End",
    "OrderReader",
    "OrderWriter",
    "ReportReader",
    "ReportWriter",
    "ServoWatch",
    "WarningLog",
    "Watched",
    "hung_up",
    "way_back",
    "with_wrist",
]
