"""A live session: who takes part, how they meet, and each one's copy of the object."""

from cotouch.session._coordinator import ABSENT_AFTER, Coordinator, Planner, acting
from cotouch.session._copy import Copy
from cotouch.session._demo import Shown, demo_file, demo_session, play
from cotouch.session._demo_stage import DemoStage
from cotouch.session._device_table import DeviceTable
from cotouch.session._file import DEFAULT_RATE, MOST_USERS, SessionFile, SessionTable
from cotouch.session._hand import Hand, NoHand, ScriptedHand, Seat
from cotouch.session._held import choices as device_choices
from cotouch.session._host import Host
from cotouch.session._join import fetch_session, join
from cotouch.session._links import delays_of, present_links
from cotouch.session._measure import Measured, measure, measured
from cotouch.session._member import Member
from cotouch.session._member_stage import MemberStage, member_stage
from cotouch.session._messages import Entry, LinkStatus, Roster, Status
from cotouch.session._neighbour import Neighbour
from cotouch.session._open import OpenHost, open_host, watching
from cotouch.session._part import HandKind, Part, Taken
from cotouch.session._planner import LinkPlanner
from cotouch.session._process import MemberProcess
from cotouch.session._replica import Replica
from cotouch.session._stage import (
    HAND_MODES,
    CopyView,
    Emulated,
    HandMode,
    HandView,
    Overview,
    Pointer,
    Scene,
    Stage,
)
from cotouch.session._watch import Event, Seen, Watch
from cotouch.session._ways import MemoryWays, RoutedWays, Ways

__all__ = [
    "ABSENT_AFTER",
    "DEFAULT_RATE",
    "HAND_MODES",
    "MOST_USERS",
    "Coordinator",
    "Copy",
    "CopyView",
    "DemoStage",
    "DeviceTable",
    "Emulated",
    "Entry",
    "Event",
    "Hand",
    "HandKind",
    "HandMode",
    "HandView",
    "Host",
    "LinkPlanner",
    "LinkStatus",
    "Measured",
    "Member",
    "MemberProcess",
    "MemberStage",
    "MemoryWays",
    "Neighbour",
    "NoHand",
    "OpenHost",
    "Overview",
    "Part",
    "Planner",
    "Pointer",
    "Replica",
    "Roster",
    "RoutedWays",
    "Scene",
    "ScriptedHand",
    "Seat",
    "Seen",
    "SessionFile",
    "SessionTable",
    "Shown",
    "Stage",
    "Status",
    "Taken",
    "Watch",
    "Ways",
    "acting",
    "delays_of",
    "demo_file",
    "demo_session",
    "device_choices",
    "fetch_session",
    "join",
    "measure",
    "measured",
    "member_stage",
    "open_host",
    "play",
    "present_links",
    "watching",
]
