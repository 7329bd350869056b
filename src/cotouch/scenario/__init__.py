"""Scenarios: the tables of a TOML file, and the hands and tools that are made from them."""

from cotouch.scenario._bodies_table import colours_of
from cotouch.scenario._body_tables import FileTable
from cotouch.scenario._channel import Channel
from cotouch.scenario._drawn_texture import DrawnTexture
from cotouch.scenario._files import tables_with_file
from cotouch.scenario._hands import Hands, grip, ports_of
from cotouch.scenario._law_choice import makes_tree, options_of_springs, with_law_of_session
from cotouch.scenario._leading import (
    Leading,
    begin_lead,
    begin_lead_alone,
    end_lead,
    end_lead_alone,
    leading_of,
)
from cotouch.scenario._messages import sentence
from cotouch.scenario._penetration import resolve_penetration
from cotouch.scenario._per_user import per_user
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
from cotouch.scenario._touching import (
    ToolRecord,
    Touching,
    after_step,
    after_step_alone,
    before_step,
    before_step_alone,
    keep_tools,
    proxy_energy,
    tool_record,
    tools_of,
)
from cotouch.scenario._traces import Trace
from cotouch.scenario._world_table import WorldTable

__all__ = [
    "DEFAULT_RATE",
    "Channel",
    "DrawnTexture",
    "FileTable",
    "HandTable",
    "Hands",
    "Leading",
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
    "ToolRecord",
    "ToolTable",
    "Touching",
    "Trace",
    "WorldTable",
    "after_step",
    "after_step_alone",
    "before_step",
    "before_step_alone",
    "begin_lead",
    "begin_lead_alone",
    "colours_of",
    "end_lead",
    "end_lead_alone",
    "grip",
    "keep_tools",
    "leading_of",
    "makes_tree",
    "options_of_springs",
    "per_user",
    "ports_of",
    "proxy_energy",
    "resolve_penetration",
    "rows_of",
    "sentence",
    "tables_with_file",
    "tool_record",
    "tools_of",
    "touching_of",
    "with_law_of_session",
    "with_tools",
]
