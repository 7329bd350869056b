"""One of several bodies that were put together: what it is by itself, and where it is among the others."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

import numpy as np

from cotouch.arrays import Float
from cotouch.body._skin import Skin
from cotouch.body._strains import shares_of

if TYPE_CHECKING:
    from cotouch.body._body import Body


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Part:
    """One of several bodies.

    Attributes:
        name: of its own.
        body: by itself, not turned.
        first: its first node among those of all.
        turn: rotation of its rest shape, (3, 3).
        shift: where the origin of its rest shape comes to, (3,) [m].
    """

    name: str
    body: "Body"
    first: int
    turn: Float
    shift: Float

    @property
    def last(self) -> int:
        """One past its last node."""
        return self.first + self.body.nodes

    def rest(self) -> Float:
        """Its shape at rest among the others, (n, 3) [m]."""
        return self.body.rest @ self.turn.T + self.shift

    def skin(self) -> Skin:
        """Its skin by itself."""
        assert self.body.skin is not None
        return self.body.skin


def held_shares(parts: tuple[Part, ...], held: Float, nodes: int) -> Float:
    """How much of each node a place on one of several rigid bodies follows, (H, nodes).

    Args:
        parts: the bodies.
        held: nodes, vertices of the skin of all, and more places, which are of the body whose vertex is nearest [m].
        nodes: of all.
    """
    skins = [part.skin().vertices @ part.turn.T + part.shift for part in parts]
    of_vertex = np.repeat(np.arange(len(parts)), [skin.shape[0] for skin in skins])
    of_node = np.repeat(np.arange(len(parts)), [part.body.nodes for part in parts])
    more, vertices = held[nodes + of_vertex.size :], np.concatenate(skins)
    nearest = [int(np.argmin(np.linalg.norm(vertices - place, axis=1))) for place in more]
    owner = np.concatenate([of_node, of_vertex, of_vertex[nearest]])
    result = np.zeros((held.shape[0], nodes))
    for number, part in enumerate(parts):
        own = owner == number
        result[own, part.first : part.last] = shares_of(part.rest(), held[own])
    return result
