"""What bodies do to each other where their skins meet, and what each of them has of a step, as the kernels want it."""

from dataclasses import dataclass
from typing import NamedTuple, final

from cotouch.arrays import Float, Int
from cotouch.mechanics._meeting._checks import check_pressing
from cotouch.passing import by_address


@final
@dataclass(frozen=True, kw_only=True)
class Between:
    """A foundation of springs between any two bodies that meet: `½ κ depth²` for each unit of skin.

    Of two of one size the depth of the one's skin in the other counts half, and so does that of the other's in the one.
    Of others the smaller one's counts more: what it stands on has no rim beside it whose walls it would climb.

    Attributes:
        stiffness: κ, > 0 [N/m³].
        loss: λ: pressure grows by 1 + λ times the speed of approach, >= 0 [s/m].
        friction: Coulomb's coefficient of what does not slip, >= 0.
        kinetic: of what slips, 0 to `friction`; None: the same.
        own: whether a body that yields meets itself as well. Places whose way to each other within the body is shorter
            than three of its edges do not.
    """

    stiffness: float = 1e7
    loss: float = 0.0
    friction: float = 0.0
    kinetic: float | None = None
    own: bool = False

    def __post_init__(self) -> None:
        check_pressing(self.stiffness, self.loss, self.friction, self.kinetic, " between bodies")


@by_address
class Met(NamedTuple):
    """What contact did to each of several bodies; those that stand still follow the others.

    Attributes:
        worked: what obstacles and others did on it, (bodies,) [J].
        flow: how much energy went to and fro there, (bodies,) [J].
        passed: whether it passed an obstacle, or another body, (bodies,).
        group: the first of those that touch each other, of which it is one, (bodies,).
    """

    worked: Float
    flow: Float
    passed: Int
    group: Int


@by_address
class Parts(NamedTuple):
    """Each body's share in the balance of a step.

    Attributes:
        part: body of each row, (rows,).
        memory: where each body's memory begins, (bodies + 1,); its first number is the energy of its law.
        energy: energy [J] and dissipated power [W] of each body's law in the step, (bodies, 2).
        met: what contact did to each body in the step; see `Met`.
        held: whether each is touched by a tool, or by a body that is, (bodies,).
        sums: scratch, (bodies, SUMS).
    """

    part: Int
    memory: Int
    energy: Float
    met: Met
    held: Int
    sums: Float


@by_address
class Meeting(NamedTuple):
    """Bodies that meet: their skins as points and triangles, and a tree of boxes around the triangles of each.

    Points of a body follow one another, like its vertices, triangles and boxes; the first box holds all others.
    Solids that stand still come last, as bodies whose vertices no row carries.

    Attributes:
        moves: how many bodies move.
        stiffness: κ of the points of the first body in the second, (bodies, bodies) [N/m³].
        loss: λ likewise [s/m].
        friction: likewise, coefficient of what does not slip.
        kinetic: and of what does.
        part: body of each point, (P,).
        tool: whether each body is a tool, in the copy of its user alone, (bodies,).
        away: where in a copy's memory it is which of them are not in it; negative: there are no tools.
        points: first point of each body, (bodies + 1,).
        vertices: first vertex of each, (bodies + 1,).
        boxes: first box of each, (bodies + 1,).
        corner: vertices of each triangle, (F, 3).
        pointer: CSR row pointer of the vertices, (V + 1,).
        row: rows that carry each vertex, (entries,).
        share: how much of each, (entries,).
        rest: places of the vertices, less the body's origin, (V, 4) [m].
        hidden: scratch: 1 where a triangle is not there, of the copy at hand, (F,), or (0,) of what cannot be cut.
        child: the two children of each box; of a leaf, `-1 - first` and how many triangles of `leaf`, (B, 2).
        leaf: triangles, ordered so that those of a leaf follow each other, (F,).
        leaves: first triangle of each body, (bodies + 1,).
        body: body of each row, (rows,).
        part_of: one over the number of its body's rows, (rows,).
        whole: scratch: how far each body moves as a whole, and the square of how far a row does beside that,
            (bodies, 4).
        lever: how far a vertex may move for each metre of the rows: the largest sum of |shares|.
        as_one: how far for each metre that all rows of its body move together: the largest |sum of shares|.
        slack: how far rows may move at least before what is near is looked for anew [m].
        within: how deep a body's skin may come into itself, (bodies,); 0: it does not meet itself [m].
        skips: first of each point in `skip`, (P + 1,).
        skip: triangles of its own body that a point does not meet, in order.
        low: scratch: corners of the boxes where the step begins, (B, 4) [m].
        high: scratch, likewise.
        least: scratch: corners of the box around each body where the step would end, and whether that was worked out,
            (bodies, 4) [m].
        most: scratch, likewise.
        place: scratch: vertices where the step begins, (V, 4) [m].
        later: scratch: and where it would end.
        touched: scratch: bodies that are near another, (bodies,).
        stack: scratch of the search, (B,).
        entries: scratch: whether `point` is of this step, and how many there are, (2,).
        bound: scratch: how far rows may move before `point` must be looked for anew, and how far they do, (2,) [m].
        looked: scratch: where they were when it was, (rows, 3) [m].
        point: scratch: points that may meet another body in the step, one entry for each body, in their order, (E,).
        other: scratch: which one, (E,).
        first: scratch: first triangle of each in `near`, and one past the last, (E, 2); less than 0: all.
        near: scratch: triangles that a point may come to, (N,).
        began: scratch: of each entry where the step begins: depth, negative infinity while it is asleep; normal out of
            the other body, shares of the corners of the nearest triangle, height above its plane, (E + 1, 8).
        face: scratch: that triangle, and whether the nearest point lies within it; then where it ends, (E + 1, 4).
        ended: scratch: as `began`, where the step would end.
        deepest: scratch: depth of the deepest point of either body in the other where the step begins,
            (bodies, bodies) [m].
        coefficient: scratch: how much of each row moves a point past its triangle, (rows,).
        moved: scratch: rows for which that is not 0, of those that are solved for at once, (rows,).
        met: result.
        push: result: what tools do to the rows of the others, for the whole body, (rows, 4); (0, 4) without tools [N].
    """

    moves: int
    stiffness: Float
    loss: Float
    friction: Float
    kinetic: Float
    part: Int
    tool: Int
    away: int
    points: Int
    vertices: Int
    boxes: Int
    corner: Int
    pointer: Int
    row: Int
    share: Float
    rest: Float
    hidden: Int
    child: Int
    leaf: Int
    leaves: Int
    body: Int
    part_of: Float
    whole: Float
    lever: float
    as_one: float
    slack: float
    within: Float
    skips: Int
    skip: Int
    low: Float
    high: Float
    least: Float
    most: Float
    place: Float
    later: Float
    touched: Int
    stack: Int
    entries: Int
    bound: Float
    looked: Float
    point: Int
    other: Int
    first: Int
    near: Int
    began: Float
    face: Int
    ended: Float
    deepest: Float
    coefficient: Float
    moved: Int
    met: Met
    push: Float
