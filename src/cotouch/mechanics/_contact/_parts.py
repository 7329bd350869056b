"""What a step with tools consists of, so that two processes can share its compilation.

The first call of `contact_step` compiles it and all that it calls, one after the other, for the better part of a
minute. What stands here are its large parts, those that it comes to last first: another process compiles them meanwhile
into the cache on disk, where the first one finds them (`cotouch.compiled`).
"""

from typing import Any

from cotouch.arrays import Float
from cotouch.mechanics._contact._balance import balanced
from cotouch.mechanics._contact._grasp import take
from cotouch.mechanics._contact._press import press_tool
from cotouch.mechanics._contact._skin import look_around
from cotouch.mechanics._contact._snap import draw_tool
from cotouch.mechanics._contact._sweep import first_crossing
from cotouch.mechanics._contact._work import Contact
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._solve import solve_step
from cotouch.mechanics._linear._state import Links, Ports, State, Workspace
from cotouch.mechanics._linear._step import assemble, move
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import Tools


def contact_parts(
    by: Contact,
    op: Operator,
    force: BodyForce | None,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    damping: Float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> list[tuple[Any, tuple[Any, ...]]]:
    """Parts of `contact_step`, each with arguments such as it calls them with.

    Args:
        by: as for `contact_step`, like all that follow.
        op: the body's matrices.
        force: what resists inside the body beside them.
        state: of the copy.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the body's skin.
        tools: the proxies.
        damping: local or extra.
        work: scratch.
        lanes: fixes the width of a row.
    """
    law, touch, T = by.law, by.work, 1e-3
    return [
        (press_tool, (law, surface, touch, tools, 0, T, T, True)),
        (draw_tool, (surface, touch, tools, 0, T, T)),
        (first_crossing, (surface, touch, tools, 0, T)),
        (solve_step, (op, ports, work, T, 0, 1, lanes)),
        (
            balanced,
            (
                *(law, op, force, state, links, ports, surface, tools, damping, damping, T, 1, work, touch),
                *(damping, damping, damping, T, T, True, T, 1, lanes),
            ),
        ),
        (take, (surface, touch.fit, tools, 0, state.position, state.memory, op.debris, lanes)),
        (look_around, (surface, touch, tools, 0, T, state.position, lanes)),
        (move, (op, state, links, T, 1, work, damping, lanes)),
        (assemble, (op, state, links, ports, damping, damping, T, work, lanes)),
    ]
