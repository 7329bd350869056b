"""From tables of rigid tools to the devices that lead them."""

from collections.abc import Sequence

import numpy as np

from cotouch.arrays import Float
from cotouch.interaction import Leading
from cotouch.mechanics import Model
from cotouch.scenario._rigid_tool_table import RigidToolTable
from cotouch.scenario._rigid_tools import RigidTool
from cotouch.scenario._tools import touching_of


def leading_of(
    tables: Sequence[RigidToolTable], tools: Sequence[RigidTool], ready: Model, lengths: Float
) -> tuple[Leading | None, list[int]]:
    """What devices lead, and which of its rows each rigid tool has; None without devices.

    Args:
        tables: of the rigid tools.
        tools: likewise, with ports for devices.
        ready: the body with them, for the kernels.
        lengths: of the body's steps, (users, steps); 0: none [s].

    Raises:
        ScenarioError: a device is wrong, or does not fit its hand.
    """
    if all(table.device is None for table in tables):
        return None, []
    users, body = lengths.shape[0], ready.body
    still = np.zeros((users, body.nodes, body.dimension))
    touching, place = touching_of([table.led() for table in tables], users, body, ready, lengths, start=still)
    assert touching is not None
    port, handle = np.full(len(tools), -1, dtype=np.int32), np.zeros((len(tools), 4))
    for row, tool in zip(place, tools, strict=True):
        handle[row, :3] = tool.handle
        if touching.couplings.device[row] >= 0:
            port[row] = tool.ports[0]
    return Leading(touching=touching, port=port, handle=handle), place
