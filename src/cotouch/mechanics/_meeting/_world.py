"""What stands still around a body: obstacles that it rests on and bumps into, as the kernels want them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.arrays import Float, Int
from cotouch.body import Body
from cotouch.errors import UnsupportedError
from cotouch.mechanics._meeting._bodies import Meeting
from cotouch.mechanics._meeting._checks import check_pressing
from cotouch.mechanics._shapes._shape import Shape, packed
from cotouch.mechanics._shapes._solid import Solid
from cotouch.passing import by_address


@final
@dataclass(frozen=True, kw_only=True)
class Obstacle:
    """Something that does not move, on a foundation of springs: `½ κ depth²` for each unit of a body's skin.

    Attributes:
        shape: where it is.
        stiffness: κ, > 0 [N/m³].
        loss: λ: pressure grows by 1 + λ times the speed of approach, >= 0 [s/m].
        friction: Coulomb's coefficient of what does not slip, >= 0.
        kinetic: of what slips, 0 to `friction`; None: the same.
    """

    shape: Shape
    stiffness: float = 1e7
    loss: float = 0.0
    friction: float = 0.0
    kinetic: float | None = None

    def __post_init__(self) -> None:
        check_pressing(self.stiffness, self.loss, self.friction, self.kinetic)
        if not isinstance(self.shape, Solid):
            packed(self.shape, (0.0, 0.0, 0.0))


def solids_of(obstacles: Sequence[Obstacle], body: Body) -> list[Obstacle]:
    """Those of some obstacles that are solids.

    Args:
        obstacles: of any shape.
        body: that is to meet them.

    Raises:
        UnsupportedError: it cannot meet solids.
    """
    found = [one for one in obstacles if isinstance(one.shape, Solid)]
    if found and not body.parts:
        raise UnsupportedError("a body that meets a solid must be one of several bodies; combine them with `together`")
    return found


@by_address
class World(NamedTuple):
    """Obstacles, and the points of a body's skin that meet them.

    Attributes:
        first: where in a copy's memory the stretches of friction begin: one row of four (the stretch [m], and how far
            it has slipped, see `pressed`) for each obstacle and point, and each point and other bodies, as the last
            step left them, then the same as this step would. Of the latter the fourth number also says in which body,
            and in how many the point is; see `mark_of`.
        pointer: CSR row pointer of the points, (P + 1,).
        row: rows of the body that carry each point, (entries,).
        share: how much of each, (entries,).
        rest: places of the points at rest, less `origin`, (P, 4) [m].
        area: of the skin that each stands for, (P,) [m²].
        reach: most that a point moves, as a multiple of the row that moves farthest.
        moves: how many of them the body carries; the others are of solids that stand still.
        kind: of each obstacle, (S,).
        numbers: of its shape, (S, NUMBERS).
        stiffness: κ, (S,) [N/m³].
        loss: λ, (S,) [s/m].
        friction: (S,).
        kinetic: (S,).
        grain: energy that the rounding of places alone makes [J].
        hold: scratch: what resists motion of the rows, (rows,) [Ns/m].
        among: which of the rows that are solved for at once each of `row` is, (entries,); negative: none of them.
        rigid: which of the rows that are solved for at once each row is, (rows,); negative: none of them.
        pairs: scratch: what resists motion between each of these and those before it, the same both ways, a matrix of
            the axes, (3 * their number squared, 4) [Ns/m].
        couple: scratch: the same between all of them, (3 of them, 3 of them) [Ns/m].
        told: scratch: force on each point by the last look, of all obstacles in the first P rows, and of other bodies
            in those after (S * P,), ((S + 1) * P, 4), or (S * P, 4) of one body [N].
        start: scratch: displacement of each point at the start of the step, and how far it is from all obstacles,
            (P, 4) [m].
        deepest: scratch: depth of the deepest point in each obstacle at the start of the step, (S,) [m].
        known: scratch: 1 where these are of the step at hand, (1,).
        tried: scratch: velocity of the rows at the last look, (rows, 4) [m/s].
        force: result: mean force of each obstacle on the whole body in the step, solids last, (obstacles, 4) [N].
        offset: where in a copy's memory begins, for each obstacle and point and each point and other bodies, how deep
            the point was where it or what it lies in came to light by a cut, which holds nothing: as the last step left
            them, then as this one would; negative: nothing can be cut [m].
        whole: which share of each point is there while nothing is cut, (P,).
        there: scratch: and now, of the copy at hand, (P,).
        pointer_of: CSR row pointer of what makes up each point of a body that can be cut, (P + 1,).
        triangle: triangles of the skin with its inner faces.
        part_of: which share of the point each makes.
        hidden: scratch: 1 where a triangle is not there, those of solids last, (F,), or (0,).
        gone: scratch: how many elements of the copy for which these were worked out were cut, (1,).
        bodies: several bodies that meet each other; None: there is one.
    """

    first: int
    pointer: Int
    row: Int
    share: Float
    rest: Float
    area: Float
    reach: float
    moves: int
    kind: Int
    numbers: Float
    stiffness: Float
    loss: Float
    friction: Float
    kinetic: Float
    grain: float
    hold: Float
    among: Int
    rigid: Int
    pairs: Float
    couple: Float
    told: Float
    start: Float
    deepest: Float
    known: Float
    tried: Float
    force: Float
    offset: int
    whole: Float
    there: Float
    pointer_of: Int
    triangle: Int
    part_of: Float
    hidden: Int
    gone: Float
    bodies: Meeting | None = None
