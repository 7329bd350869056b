"""Scenarios: the tables of a TOML file, and what is made of them."""

from cotouch.scenario._bodies_table import colours_of
from cotouch.scenario._body_tables import FileTable
from cotouch.scenario._channel import Channel
from cotouch.scenario._drawn_texture import DrawnTexture
from cotouch.scenario._files import tables_with_file
from cotouch.scenario._law_choice import makes_tree, options_of_springs, with_law_of_session
from cotouch.scenario._led_tools import leading_of
from cotouch.scenario._messages import refusing
from cotouch.scenario._penetration import resolve_penetration
from cotouch.scenario._per_user import per_user
from cotouch.scenario._ports import ports_of
from cotouch.scenario._rigid_tool_table import RigidToolTable
from cotouch.scenario._rigid_tools import RigidTool, rows_of, with_tools
from cotouch.scenario._scenario import Scenario
from cotouch.scenario._surface_tables import TextureTable
from cotouch.scenario._tables import (
    HandTable,
    Mode,
    NonNegative,
    Positive,
    Probability,
    Table,
)
from cotouch.scenario._tool_tables import DEFAULT_RATE, SimulatedDeviceTable, ToolHand, ToolTable
from cotouch.scenario._tools import touching_of
from cotouch.scenario._traces import Trace
from cotouch.scenario._world_table import WorldTable

__all__ = [
    "DEFAULT_RATE",
    "Channel",
    "DrawnTexture",
    "FileTable",
    "HandTable",
    "Mode",
    "NonNegative",
    "Positive",
    "Probability",
    "RigidTool",
    "RigidToolTable",
    "Scenario",
    "SimulatedDeviceTable",
    "Table",
    "TextureTable",
    "ToolHand",
    "ToolTable",
    "Trace",
    "WorldTable",
    "colours_of",
    "leading_of",
    "makes_tree",
    "options_of_springs",
    "per_user",
    "ports_of",
    "refusing",
    "resolve_penetration",
    "rows_of",
    "tables_with_file",
    "touching_of",
    "with_law_of_session",
    "with_tools",
]
