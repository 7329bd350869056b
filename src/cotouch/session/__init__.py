"""A live session: who takes part, how they meet, and each one's copy of the object."""

from cotouch.session._admission import Admission
from cotouch.session._coordinator import ABSENT_AFTER, Coordinator, Planner
from cotouch.session._demo import DemoOutcome, all_move, play
from cotouch.session._demo_session import demo_file, demo_session
from cotouch.session._demo_session_api import DemoSessionApi
from cotouch.session._device_table import DeviceTable
from cotouch.session._felt import Felt, felt
from cotouch.session._file import DEFAULT_RATE, MOST_USERS, SessionFile, SessionTable
from cotouch.session._hand import Hand, NoHand, ScriptedHand, Slot
from cotouch.session._held import choices as device_choices
from cotouch.session._host import Host
from cotouch.session._join import fetch_session, join
from cotouch.session._keep import identity_folder
from cotouch.session._links import delays_of, present_links
from cotouch.session._measure import Measured, measure, measured
from cotouch.session._member import Member
from cotouch.session._member_session_api import MemberSessionApi, member_session_api
from cotouch.session._messages import Entry, LinkStatus, Roster, Status
from cotouch.session._neighbour import Neighbour
from cotouch.session._open import OpenHost, open_host, watching
from cotouch.session._part import HandKind, Part, PartOutcome
from cotouch.session._paths import MemoryPaths, Paths, RoutedPaths
from cotouch.session._planner import LinkPlanner
from cotouch.session._process import MemberProcess
from cotouch.session._replica import Replica
from cotouch.session._session_api import (
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
from cotouch.session._shared_model import SharedModel
from cotouch.session._watch import MemberState, SessionEvent, SessionWatch

__all__ = [
    "ABSENT_AFTER",
    "DEFAULT_RATE",
    "HAND_MODES",
    "MOST_USERS",
    "Admission",
    "Coordinator",
    "CopyView",
    "DemoOutcome",
    "DemoSessionApi",
    "DeviceTable",
    "Emulated",
    "Entry",
    "Felt",
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
    "MemberSessionApi",
    "MemberState",
    "MemoryPaths",
    "Neighbour",
    "NoHand",
    "OpenHost",
    "Overview",
    "Part",
    "PartOutcome",
    "Paths",
    "Planner",
    "Pointer",
    "RecordingState",
    "Replica",
    "Roster",
    "RoutedPaths",
    "Scene",
    "ScriptedHand",
    "SessionApi",
    "SessionEvent",
    "SessionFile",
    "SessionTable",
    "SessionWatch",
    "SharedModel",
    "Slot",
    "Status",
    "all_move",
    "delays_of",
    "demo_file",
    "demo_session",
    "device_choices",
    "felt",
    "fetch_session",
    "identity_folder",
    "join",
    "measure",
    "measured",
    "member_session_api",
    "open_host",
    "play",
    "present_links",
    "watching",
]
