"""One of several bodies that were put together: what it is by itself, and where it is among the others."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NotRequired, TypedDict, final

import numpy as np

from cotouch.arrays import Float
from cotouch.body._material import cuttable_models
from cotouch.body._skin import Skin
from cotouch.body._strains import shares_of
from cotouch.errors import BodyError

if TYPE_CHECKING:
    from cotouch.body._body import Body
    from cotouch.body._cut_skin import CutSkin


@final
@dataclass(frozen=True, kw_only=True)
class ToolBody:
    """That a body is a tool: it is in the copy of its user alone, without links and weight.

    A copy takes one of N parts of everything, so the mass of a tool's body must be N times what it is.

    Attributes:
        owner: whose it is, from 0.
        copies: N, >= 1.
        grips: where a hand holds it at rest, (G, 3) [m].
    """

    owner: int
    copies: int
    grips: tuple[tuple[float, ...], ...] = ()


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
        tool: whose tool it is; None: it is shared.
    """

    name: str
    body: "Body"
    first: int
    turn: Float
    shift: Float
    tool: ToolBody | None = None

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

    def carrying(self, skin: Skin) -> Skin:
        """A skin of this body where it is among the others, hanging on its nodes there.

        Args:
            skin: of the body by itself.
        """
        return Skin(
            vertices=skin.vertices @ self.turn.T + self.shift,
            triangles=skin.triangles,
            nodes=skin.nodes + self.first,
            weights=skin.weights,
        )


def never_meet(one: Part, other: Part) -> bool:
    """Whether two bodies are tools of two users, which no copy holds both.

    Args:
        one: of the bodies.
        other: likewise.
    """
    return one.tool is not None and other.tool is not None and one.tool.owner != other.tool.owner


def _shared(parts: tuple[Part, ...]) -> list[Part]:
    return [part for part in parts if part.tool is None]


def held_vertices(parts: tuple[Part, ...], skin: Skin | None) -> Float:
    """Vertices of a body's skin that hands can hold, all but those of tools, (V, 3) [m].

    Args:
        parts: of the body; none of one that was not put together.
        skin: of all.
    """
    if not parts:
        return np.zeros((0, 3)) if skin is None else skin.vertices
    return np.concatenate([part.skin().vertices @ part.turn.T + part.shift for part in _shared(parts)])


def held_shares(parts: tuple[Part, ...], held: Float, nodes: int) -> Float:
    """How much of each node a place on one of several rigid bodies follows, (H, nodes).

    Args:
        parts: the bodies.
        held: nodes, `held_vertices`, and more places, which are of the body whose vertex is nearest [m].
        nodes: of all, with those of tools.
    """
    parts, vertices = tuple(_shared(parts)), held_vertices(parts, None)
    of_vertex = np.repeat(np.arange(len(parts)), [part.skin().vertices.shape[0] for part in parts])
    of_node = np.repeat(np.arange(len(parts)), [part.body.nodes for part in parts])
    more = held[of_node.size + of_vertex.size :]
    nearest = [int(np.argmin(np.linalg.norm(vertices - place, axis=1))) for place in more]
    owner = np.concatenate([of_node, of_vertex, of_vertex[nearest]])
    result = np.zeros((held.shape[0], nodes))
    for number, part in enumerate(parts):
        own = owner == number
        result[own, part.first : part.last] = shares_of(part.rest(), held[own])
    return result


def grip_shares(parts: tuple[Part, ...], nodes: int) -> Float:
    """How much of each node what holds tools follows, (G + H, nodes).

    First the G points of all, those of one tool after the other; then of each tool its handle, which is their middle,
    and the way from there to each. A force at such a way is one at its point and the opposite at the handle: it only
    turns.

    Args:
        parts: the bodies.
        nodes: of all.
    """
    points: list[Float] = [np.zeros((0, nodes))]
    ways: list[Float] = []
    for part in parts:
        if part.tool is not None and part.tool.grips:
            own = np.zeros((len(part.tool.grips), nodes))
            own[:, part.first : part.last] = shares_of(part.rest(), np.array(part.tool.grips))
            handle = own.mean(axis=0)
            points.append(own)
            ways += [handle[None], own - handle]
    return np.concatenate([*points, *ways])


def drawn_tools(body: "Body", faces: "CutSkin | None" = None) -> list[tuple[int, int, int]]:
    """First and one past the last of the drawn vertices of each tool, and whose it is.

    Args:
        body: of one or several.
        faces: the skin by which it is drawn, if not by its own.
    """
    if not body.parts:
        return []
    each = [part.skin().vertices.shape[0] for part in body.parts] if faces is None else np.diff(faces.vertices).tolist()
    last = np.cumsum(each).tolist()
    return [
        (end - count, end, part.tool.owner)
        for part, count, end in zip(body.parts, each, last, strict=True)
        if part.tool is not None
    ]


class DrawnTool(TypedDict):
    """Whose a tool that can be held is, which of this user's, from 0, and where it is held at rest [m]."""

    slot: int
    number: int
    handle: list[float]


class DrawnPart(TypedDict):
    """A body among several: its name, how many vertices it is drawn with, and its colour as "#rrggbb"."""

    name: str
    vertices: int
    colour: str | None
    bare: NotRequired[bool]
    tool: NotRequired[DrawnTool]


def drawn_parts(body: "Body", colours: Sequence[str | None] = (), faces: "CutSkin | None" = None) -> list[DrawnPart]:
    """What a page tells several bodies apart by: `name`, `vertices` of its skin, and `colour`; of one body nothing.

    A tool is `bare`, without the texture that others may have. One that can be held has a `tool`, too: its `slot`,
    which of that user's such tools it is (`number`, from 0), and where its `handle` is at rest.

    Args:
        body: of one or several.
        colours: of the bodies, as "#rrggbb"; None or too few: the page's own.
        faces: the skin by which it is drawn, if not by its own.
    """
    if len(body.parts) < 2 and not any(colours):
        return []
    given = [*colours, *[None] * len(body.parts)]
    each = [part.skin().vertices.shape[0] for part in body.parts] if faces is None else np.diff(faces.vertices)
    found: list[DrawnPart] = []
    numbers: dict[int, int] = {}
    for part, count, colour in zip(body.parts, each, given, strict=False):
        found.append({"name": part.name, "vertices": int(count), "colour": colour})
        if part.tool is not None:
            found[-1]["bare"] = True
        if part.tool is not None and part.tool.grips:
            slot = part.tool.owner
            numbers[slot] = number = numbers.get(slot, -1) + 1
            handle = np.mean(part.tool.grips, axis=0).tolist()
            found[-1]["tool"] = {"slot": slot, "number": number, "handle": handle}
    return found


def cuttable_parts(parts: tuple[Part, ...], **limits: float) -> tuple[Part, ...]:
    """Bodies of which those can be cut whose skin closes again around what is cut away.

    Args:
        parts: the bodies.
        **limits: as of `Body.with_cutting`.

    Raises:
        BodyError: there is none, or a limit is out of its range.
    """
    closes = [part.body.material is not None and part.body.material.closes for part in parts]
    if not any(closes):
        raise BodyError(
            "cutting takes away elements, but none of the bodies is of cubes or tetrahedra; give one of them one of "
            f"the models {cuttable_models()}"
        )
    return tuple(
        replace(part, body=part.body.with_cutting(**limits)) if can else part
        for part, can in zip(parts, closes, strict=True)
    )


def pulls_of(body: "Body") -> Float:
    """How much of a link each node feels: 1, and of nodes that were doubled along faces together as much, (n,).

    Args:
        body: of one or several.
    """
    if body.parts:
        return np.concatenate([pulls_of(part.body) for part in body.parts])
    part = None if body.material is None else body.material.part
    return part if part is not None and part.size else np.ones(body.nodes)
