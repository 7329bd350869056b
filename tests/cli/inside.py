"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.cli import _page as page_module
from cotouch.cli._console import Console
from cotouch.cli._progress import ProgressLine
from cotouch.cli._session import stop_signals
from cotouch.cli._simulate import _tools as tools_table
from cotouch.cli._table import view

__all__ = ["Console", "ProgressLine", "page_module", "stop_signals", "tools_table", "view"]
