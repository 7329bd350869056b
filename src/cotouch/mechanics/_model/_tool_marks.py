"""Which tools that are bodies are in a copy, and what they did to the rest of it."""

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body import cut_skin, drawn_tools
from cotouch.mechanics._model._model import Model


def unsettled(model: Model, user: int) -> Float:
    """The memory of a user's copy before it is settled: which tools are not in it, (memory,).

    Args:
        model: of the body.
        user: whose copy it is, from 0.
    """
    memory = np.zeros(model.memory)
    bodies = None if model.force is None or model.force.world is None else model.force.world.bodies
    if bodies is not None and bodies.away >= 0:
        tools = [one.tool for one in model.body.parts]
        away = [tool is not None and tool.owner != user for tool in tools]
        memory[bodies.away : bodies.away + len(away)] = away
    return memory


def tool_marks(model: Model, corner: Int) -> Int:
    """Where in a copy's memory it is whether the body of each triangle and node is not in it; negative: it always is.

    Args:
        model: of a body with tools.
        corner: vertices of each drawn triangle, (F, 3).

    Returns:
        Of triangles, then of nodes, (F + n,).
    """
    body = model.body
    assert model.force is not None
    assert model.force.world is not None
    assert model.force.world.bodies is not None
    mark = model.force.world.bodies.away + np.arange(len(body.parts))
    triangles, nodes = np.full(corner.shape[0], -1), np.full(body.nodes, -1)
    drawn = drawn_tools(body, cut_skin(body) if body.cut_count else None)
    for number, one in enumerate(body.parts):
        if one.tool is not None:
            first, last, _ = drawn.pop(0)
            triangles[(corner[:, 0] >= first) & (corner[:, 0] < last)] = mark[number]
            nodes[one.first : one.last] = mark[number]
    return np.concatenate([triangles, nodes]).astype(np.int32)


def push_of(model: Model, scale: float) -> Float | None:
    """What tools that are bodies did to the others in the step, (rows, width) [N]; None without them.

    Args:
        model: of the body.
        scale: share of forces that a copy has.
    """
    bodies = None if model.force is None or model.force.world is None else model.force.world.bodies
    return scale * bodies.push if bodies is not None and bodies.push.size else None
