"""One of several bodies that were put together: what it is by itself, and where it is among the others."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, final

from cotouch.arrays import Float
from cotouch.body._skin import Skin

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
