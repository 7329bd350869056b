"""What a step with tools consists of, so that two processes can share its compilation.

The first call of `touch_step` compiles it and all that it calls, one after the other, for the better part of a minute.
What stands here are its large parts, those that it comes to last first: another process compiles them meanwhile into
the cache on disk, where the first one finds them (`cotouch.compiled`).
"""

from typing import Any

from cotouch.arrays import Float
from cotouch.mechanics._columns import solve_columns
from cotouch.mechanics._elements import elements
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._put_back import put_back
from cotouch.mechanics._settle import settle_tools
from cotouch.mechanics._small import reduce_step
from cotouch.mechanics._state import Links, Ports, State, Workspace
from cotouch.mechanics._step import assemble, book_energies, move, solve_step
from cotouch.mechanics._surface import Surface
from cotouch.mechanics._tools import Tools, TouchWork


def touch_parts(
    op: Operator,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    damping: Float,
    work: Workspace,
    touch: TouchWork,
    lanes: tuple[int, ...],
) -> list[tuple[Any, tuple[Any, ...]]]:
    """Parts of `touch_step`, each with arguments such as it calls them with.

    Args:
        op: as for `touch_step`, like all that follow.
        state: of the copy.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the body's skin.
        tools: the proxies.
        damping: local or extra.
        work: scratch.
        touch: scratch.
        lanes: fixes the width of a row.
    """
    columns, small, mean, T = touch.columns, touch.small, work.mean, 1e-3
    entries = op.entries[0] if op.entries.shape[0] > 0 else work.values
    return [
        (
            put_back,
            (
                *(op, columns, small, touch.modal_ports, T, tools.account, 0, 1, 1, 1, 1),
                *(entries, 1.0, work.diagonal, work.rhs, mean, True, lanes),
            ),
        ),
        (reduce_step, (columns, small, T, 1, 1, 1, mean)),
        (solve_columns, (op, entries, 1.0, work.diagonal, columns, 1, T, 1)),
        (solve_step, (op, ports, work, T, 1, lanes)),
        (elements, (surface, tools, touch.found, columns, small, 1, lanes)),
        (settle_tools, (surface, touch.fit, tools, small.mean, T, state.position, mean, damping)),
        (move, (op, state, links, T, 1, work, damping, lanes)),
        (book_energies, (op, state, damping, damping, T, work, damping, lanes)),
        (assemble, (op, state, links, ports, damping, damping, T, work, lanes)),
    ]
