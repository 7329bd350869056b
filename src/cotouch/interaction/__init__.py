"""What hands and tools do to a replica in a step, and what that does to the devices that drive them."""

from cotouch.interaction._hands import Hands, grip
from cotouch.interaction._leading import Leading, begin_lead, begin_lead_alone, end_lead, end_lead_alone
from cotouch.interaction._touching import (
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

__all__ = [
    "Hands",
    "Leading",
    "ToolRecord",
    "Touching",
    "after_step",
    "after_step_alone",
    "before_step",
    "before_step_alone",
    "begin_lead",
    "begin_lead_alone",
    "end_lead",
    "end_lead_alone",
    "grip",
    "keep_tools",
    "proxy_energy",
    "tool_record",
    "tools_of",
]
