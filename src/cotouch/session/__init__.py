"""A live session: who takes part, how they meet, and each one's copy of the object."""

from cotouch.session._coordinator import ABSENT_AFTER, Coordinator, Planner, acting
from cotouch.session._file import DEFAULT_RATE, MOST_USERS, SessionFile, SessionTable
from cotouch.session._hand import Hand, NoHand, ScriptedHand
from cotouch.session._host import Host
from cotouch.session._links import delays_of, present_links
from cotouch.session._messages import Entry, LinkStatus, Roster, Status
from cotouch.session._planner import LinkPlanner
from cotouch.session._replica import Replica
from cotouch.session._watch import Event, Seen, Watch
from cotouch.session._ways import MemoryWays, Ways

__all__ = [
    "ABSENT_AFTER",
    "DEFAULT_RATE",
    "MOST_USERS",
    "Coordinator",
    "Entry",
    "Event",
    "Hand",
    "Host",
    "LinkPlanner",
    "LinkStatus",
    "MemoryWays",
    "NoHand",
    "Planner",
    "Replica",
    "Roster",
    "ScriptedHand",
    "Seen",
    "SessionFile",
    "SessionTable",
    "Status",
    "Watch",
    "Ways",
    "acting",
    "delays_of",
    "present_links",
]
