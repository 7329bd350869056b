"""The processes of a live session: opening, joining, measuring, playing on a real clock, the demonstration."""

from cotouch.session._demo import DemoOutcome, all_move, play
from cotouch.session._demo_session import demo_session
from cotouch.session._demo_session_api import DemoSessionApi
from cotouch.session._held import device_choices
from cotouch.session._join import fetch_session, join
from cotouch.session._keep import identity_folder
from cotouch.session._measure import MeasuredNetwork, measure, measured_network
from cotouch.session._member_session_api import MemberSessionApi, member_session_api
from cotouch.session._open import OpenHost, open_host, watching
from cotouch.session._planner import LinkPlanner
from cotouch.session._process import MemberProcess

__all__ = [
    "DemoOutcome",
    "DemoSessionApi",
    "LinkPlanner",
    "MeasuredNetwork",
    "MemberProcess",
    "MemberSessionApi",
    "OpenHost",
    "all_move",
    "demo_session",
    "device_choices",
    "fetch_session",
    "identity_folder",
    "join",
    "measure",
    "measured_network",
    "member_session_api",
    "open_host",
    "play",
    "watching",
]
