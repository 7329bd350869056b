"""Who takes part in a session, who decides, and each member's copy of the object. Nothing here reads a clock."""

from cotouch.members._admission import Admission, addresses_of
from cotouch.members._coordinator import ABSENT_AFTER, Coordinator, Planner
from cotouch.members._device_table import coupling_of_slot, device_tools
from cotouch.members._emulate import path_laws
from cotouch.members._felt import LawFelt, law_felt, margin_of
from cotouch.members._file import MOST_USERS, SessionFile
from cotouch.members._hand import Hand, NoHand, ScriptedHand, Slot, SlotHand, grips_of, handles_of, no_ports
from cotouch.members._host import Host
from cotouch.members._links import delays_of, present_links
from cotouch.members._live_law import LiveLaw
from cotouch.members._member import Member
from cotouch.members._messages import (
    MOST_NOTICE,
    AddressProof,
    Decided,
    Decision,
    Entry,
    Former,
    Join,
    LinkStatus,
    NameOwner,
    Refused,
    Roster,
    Status,
    read_message,
    write_message,
)
from cotouch.members._pace import Pace, pace_numbers
from cotouch.members._part import Participation, ParticipationOutcome
from cotouch.members._paths import Paths
from cotouch.members._replica import Replica
from cotouch.members._session_recorder import SessionRecorder
from cotouch.members._shared_model import SharedModel
from cotouch.members._step_recorder import StepRecorder
from cotouch.members._succession import genuine
from cotouch.members._totals import TOTALS_ALARM
from cotouch.members._watch import MemberState, SessionEvent, SessionWatch

__all__ = [
    "ABSENT_AFTER",
    "MOST_NOTICE",
    "MOST_USERS",
    "TOTALS_ALARM",
    "AddressProof",
    "Admission",
    "Coordinator",
    "Decided",
    "Decision",
    "Entry",
    "Former",
    "Hand",
    "Host",
    "Join",
    "LawFelt",
    "LinkStatus",
    "LiveLaw",
    "Member",
    "MemberState",
    "NameOwner",
    "NoHand",
    "Pace",
    "Participation",
    "ParticipationOutcome",
    "Paths",
    "Planner",
    "Refused",
    "Replica",
    "Roster",
    "ScriptedHand",
    "SessionEvent",
    "SessionFile",
    "SessionRecorder",
    "SessionWatch",
    "SharedModel",
    "Slot",
    "SlotHand",
    "Status",
    "StepRecorder",
    "addresses_of",
    "coupling_of_slot",
    "delays_of",
    "device_tools",
    "genuine",
    "grips_of",
    "handles_of",
    "law_felt",
    "margin_of",
    "no_ports",
    "pace_numbers",
    "path_laws",
    "present_links",
    "read_message",
    "write_message",
]
