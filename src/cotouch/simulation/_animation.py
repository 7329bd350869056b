"""An animation of a run in three dimensions: one HTML file that shows every user's copy, tools and forces."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import Final, final

import numpy as np
import numpy.typing as npt

from cotouch import drawing
from cotouch.arrays import Int, Single, extents
from cotouch.body import DrawnPart, Skin
from cotouch.errors import BodyError, InputError, NetworkError
from cotouch.files import check_writable, write
from cotouch.mechanics import Shape, Solid, shape_table
from cotouch.scenario import DrawnTexture
from cotouch.simulation._animation_checks import (
    Float,
    corners_of,
    field_of,
    indices_of,
    keep_frozen,
    numbers_of,
    padded,
    pairs_of,
    track_of,
)
from cotouch.simulation._pack import Packer

HTML: Final = (".html", ".htm")


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class ToolTracks:
    """Spheres, styluses and blades with which users touch the object.

    Args:
        owner: index of each tool's user, (P,), from 0.
        centre: (F, P, 3) [m].
        radius: (P,) [m], > 0; or one for all.
        force: felt by the owner, (F, P, 3) [N].
        axis: of blades, from the centre to the other end of the edge, (P, 3); 0 of others; or none [m].
        tip: of styluses, from the centre to that of the round tip, (P, 3); 0 of others; or none [m].

    Raises:
        InputError: an array has the wrong shape or a number that is not finite.
    """

    owner: Int
    centre: Float
    radius: Float
    force: Float
    axis: Float
    tip: Float

    def __init__(
        self,
        *,
        owner: npt.ArrayLike,
        centre: npt.ArrayLike,
        radius: npt.ArrayLike,
        force: npt.ArrayLike,
        axis: npt.ArrayLike | None = None,
        tip: npt.ArrayLike | None = None,
    ) -> None:
        who = indices_of("tool owners", owner, 1, InputError)
        size = numbers_of("tool radii", radius, InputError)
        size = np.full(who.shape, size) if size.ndim == 0 else size
        if size.shape != who.shape:
            raise InputError(f"tool radii are {extents(size.shape)}; there are {who.size} tools")
        if size.size and size.min() <= 0.0:
            raise InputError(f"the radius of tool {int(size.argmin()) + 1} is {size.min():g} m; it must be positive")
        keep_frozen(self, owner=who, centre=track_of("tool centres", centre, who.size), radius=size)
        keep_frozen(self, force=track_of("tool forces", force, who.size))
        keep_frozen(self, axis=_ends("tool axes", axis, who.size), tip=_ends("tool tips", tip, who.size))


def _ends(name: str, given: npt.ArrayLike | None, tools: int) -> Float:
    """Where the other ends of tools are, (tools, 3) [m]."""
    ends = np.zeros((tools, 3)) if given is None else numbers_of(name, given, InputError)
    if ends.shape != (tools, 3):
        raise InputError(f"{name} are {extents(ends.shape)}; there are {tools} tools, with 3 numbers each")
    return ends


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class PortTracks:
    """Hands that hold the object at a point, without a tool.

    Args:
        owner: index of each grip's user, (G,), from 0.
        place: (F, G, 3) [m].
        force: of the hand on the object, (F, G, 3) [N]; the hand feels the opposite.

    Raises:
        InputError: an array has the wrong shape or a number that is not finite.
    """

    owner: Int
    place: Float
    force: Float

    def __init__(self, *, owner: npt.ArrayLike, place: npt.ArrayLike, force: npt.ArrayLike) -> None:
        who = indices_of("grip owners", owner, 1, InputError)
        keep_frozen(self, owner=who, place=track_of("grip places", place, who.size))
        keep_frozen(self, force=track_of("grip forces", force, who.size))


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class UserSeries:
    """A number of every user over time, for the chart and the table.

    Args:
        name: what it is, short: "Discrepancy".
        unit: of the values, without prefix: "m".
        values: (F, U); NaN where it is not known.

    Raises:
        InputError: the name is empty, or the values are not rows of numbers.
    """

    name: str
    unit: str
    values: Float

    def __init__(self, *, name: str, unit: str, values: npt.ArrayLike) -> None:
        if not name.strip():
            raise InputError("a series has no name; give it one, because it is the title of its chart")
        numbers = numbers_of(f"values of {name}", values, InputError, finite=False)
        if numbers.ndim != 2:
            raise InputError(f"values of {name} are {extents(numbers.shape)}; they must be frames x users")
        keep_frozen(self, name=name, unit=unit, values=numbers)


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Animation:
    """What a run looked like, frame by frame, ready to be written as one HTML file.

    The object is drawn as a surface of triangles or, if it has none, as nodes joined by edges. Its vertices come either
    as places of every user's own copy or as displacements of the nodes of a body with a skin. Two of three coordinates,
    or one, are enough for a flat or a straight object, here and in tools and grips.

    Args:
        title: shown above the animation.
        users: names, at least one.
        time: of the frames, (F,) [s], increasing. The page draws straight between frames; 60 per second are enough.
        vertices: every user's copy, (F, U, V, 3) [m]; or give `skin` and `displacement`.
        triangles: indices of vertices, (t, 3); or none.
        edges: indices of vertices, (e, 2), in place of triangles. With neither, vertices are drawn as points.
        skin: the surface that a body carries, with the triangles.
        displacement: of the body's nodes, x - x_d, (F, U, n, 3) [m].
        rest: vertices at rest, (V, 3) [m], from which displacement is measured; those of the first user in the first
            frame if not given.
        tools: spheres that touch the object.
        ports: hands that hold it.
        links: pairs of user indices that are joined.
        series: further numbers of every user over time: discrepancy, age, energy residual.
        shapes: what stands still around the object.
        parts: several bodies, in the order of their vertices; see `cotouch.body.drawn_parts`.
        spans: when each triangle of each copy is there, from and until, (U, t, 2) [s]; by default always.
        texture: on the skin of what is shared; by default it is smooth.

    Raises:
        BodyError: vertices, triangles, edges or the skin do not fit together.
        NetworkError: there are no users, or a link names none.
        InputError: anything else does not fit together, or is not finite.

    Examples:
        >>> wave = 0.01 * np.sin(np.arange(30) / 5)[:, None, None, None] * [0.0, 0.0, 1.0]
        >>> shown = Animation(
        ...     title="A triangle",
        ...     users=["Ann", "Ben"],
        ...     time=np.arange(30) / 60,
        ...     vertices=np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0]]) + wave * np.ones((1, 2, 1, 1)),
        ...     triangles=[[0, 1, 2]],
        ... )
        >>> shown.vertices.shape
        (30, 2, 3, 3)
    """

    title: str
    users: tuple[str, ...]
    time: Float
    vertices: Single
    triangles: Int
    edges: Int
    rest: Single
    tools: ToolTracks
    ports: PortTracks
    links: tuple[tuple[int, int], ...]
    series: tuple[UserSeries, ...]
    shapes: tuple[Shape, ...]
    parts: tuple[DrawnPart, ...]
    spans: Single
    texture: DrawnTexture | None

    def __init__(
        self,
        *,
        title: str,
        users: Sequence[str],
        time: npt.ArrayLike,
        vertices: npt.ArrayLike | None = None,
        triangles: npt.ArrayLike | None = None,
        edges: npt.ArrayLike | None = None,
        skin: Skin | None = None,
        displacement: npt.ArrayLike | None = None,
        rest: npt.ArrayLike | None = None,
        tools: ToolTracks | None = None,
        ports: PortTracks | None = None,
        links: Sequence[tuple[int, int]] = (),
        series: Sequence[UserSeries] = (),
        shapes: Sequence[Shape] = (),
        parts: Sequence[DrawnPart] = (),
        spans: npt.ArrayLike | None = None,
        texture: DrawnTexture | None = None,
    ) -> None:
        names = tuple(users)
        if not names:
            raise NetworkError("an animation needs users; name at least one")
        when = numbers_of("frame times", time, InputError)
        if when.ndim != 1 or when.size == 0:
            raise InputError(f"frame times are {extents(when.shape)}; they must be a row of at least one")
        late = np.flatnonzero(np.diff(when) <= 0.0)
        if late.size:
            raise InputError(
                f"frame {late[0] + 2} is at {when[late[0] + 1]:g} s and the one before at {when[late[0]]:g} s; the "
                "times of frames must increase"
            )
        if (skin is None) != (displacement is None) or (skin is None) == (vertices is None):
            raise BodyError("the object must be given exactly once, as vertices or as skin and displacement")
        if skin is not None:
            if not (triangles is None and edges is None and rest is None):
                raise BodyError("triangles, edges and rest come from the skin; if a skin is given, leave them out")
            field = field_of("displacement of nodes", displacement, when.size, len(names))
            skin.check(field.shape[2])
            places = _carried(skin, field)
            triangles, rest = skin.triangles, skin.vertices
        else:
            places = field_of("vertices", vertices, when.size, len(names))
        count = places.shape[2]
        if triangles is not None and edges is not None:
            raise BodyError("both triangles and edges are given; give only one of them")
        faces = corners_of("triangle", triangles, 3, count)
        lines = corners_of("edge", edges, 2, count)
        if rest is None:
            start = places[0, 0].copy()
        else:
            start = padded(numbers_of("vertices at rest", rest, BodyError)).astype(np.float32)
        if start.shape != (count, 3):
            raise BodyError(f"vertices at rest are {extents(start.shape)}; there are {count} vertices")
        nothing = np.zeros((when.size, 0, 3))
        spheres = tools or ToolTracks(owner=[], centre=nothing, radius=[], force=nothing)
        hands = ports or PortTracks(owner=[], place=nothing, force=nothing)
        for name, owner, tracks in (
            ("tool", spheres.owner, (spheres.centre, spheres.force)),
            ("grip", hands.owner, (hands.place, hands.force)),
        ):
            if owner.size and (owner.min() < 0 or owner.max() >= len(names)):
                wrong = int(owner.min() if owner.min() < 0 else owner.max())
                raise InputError(f"a {name} belongs to user index {wrong}; this animation has 0 to {len(names) - 1}")
            for track in tracks:
                if track.shape[0] != when.size:
                    raise InputError(f"{name}s have {track.shape[0]} frames; this animation has {when.size}")
        for entry in series:
            if entry.values.shape != (when.size, len(names)):
                raise InputError(
                    f"values of {entry.name} are {extents(entry.values.shape)}; they must be {when.size} frames x "
                    f"{len(names)} users"
                )
        keep_frozen(
            self, title=title, users=names, time=when, vertices=places, triangles=faces, edges=lines, rest=start
        )
        keep_frozen(self, tools=spheres, ports=hands, links=pairs_of(links, len(names)), series=tuple(series))
        known = numbers_of("spans", [] if spans is None else spans, InputError, finite=False, kind=np.float32)
        if spans is not None and known.shape != (len(names), faces.shape[0], 2):
            raise InputError(
                f"spans are {extents(known.shape)}; they must be {len(names)} users x {faces.shape[0]} triangles x 2"
            )
        for shape in shapes:
            if not isinstance(shape, Solid):
                shape.packed((0.0, 0.0, 0.0))  # says what is wrong with it
        keep_frozen(self, shapes=tuple(shapes), parts=tuple(parts), spans=known, texture=texture)

    def write(self, path: str | Path) -> Path:
        """Writes the page: one file that needs nothing else, whole or not at all.

        Vertices are kept to 1/65535 of the object's extent, tools and forces to single precision. Five users with 5,000
        vertices each and 300 frames of smooth motion come to about 10 MB (90 MB before packing), with 1,000 vertices to
        2 MB. The same animation gives the same bytes.

        Args:
            path: of the file, ending in ".html" or ".htm" if it is an ordinary one.

        Returns:
            The path.

        Raises:
            OutputError: the file cannot be written, or its name does not end in ".html" or ".htm".
        """
        target = Path(path)
        check_writable(target, HTML)
        write(target, self.page().encode("utf-8"), "animation")
        return target

    def page(self) -> str:
        """The page as text."""
        packer = Packer()
        low, step = packer.add_quantised("vertices", self.vertices)
        for name, values, kind in (
            ("time", self.time, "f8"),
            ("rest", self.rest, "f4"),
            ("triangles", self.triangles, "u4"),
            ("edges", self.edges, "u4"),
            ("spans", self.spans, "f4"),
            ("tool_centre", self.tools.centre, "f4"),
            ("tool_force", self.tools.force, "f4"),
            ("grip_place", self.ports.place, "f4"),
            ("grip_force", self.ports.force, "f4"),
        ):
            packer.add(name, values, kind)
        touched = self.tools.owner.size or self.ports.owner.size
        forces = (UserSeries(name="Force", unit="N", values=self.felt()),) if touched else ()
        series = (*forces, *self.series)
        for number, entry in enumerate(series):
            packer.add(f"series_{number}", entry.values, "f4")
        displacement, difference = self._peaks()
        header = {
            "title": self.title,
            "users": self.users,
            "low": low.tolist(),
            "step": step.tolist(),
            "arrays": packer.entries,
            "tools": {
                "owner": self.tools.owner.tolist(),
                "radius": self.tools.radius.tolist(),
                "axis": self.tools.axis.tolist(),
                "tip": self.tools.tip.tolist(),
            },
            "ports": {"owner": self.ports.owner.tolist()},
            "links": self.links,
            "series": [{"name": entry.name, "unit": entry.unit} for entry in series],
            "peaks": {"displacement": displacement, "difference": difference},
            "parts": self.parts,
            "obstacles": [shape_table(shape) for shape in self.shapes],
            "texture": None if self.texture is None else self.texture.table(),
        }
        viewer = files("cotouch.simulation").joinpath("_viewer")
        read = {name: viewer.joinpath(name).read_text(encoding="utf-8") for name in ("index.html", "style.css")}
        colors = {f"user_{number}": color for number, color in enumerate(drawing.USERS, start=1)}
        colors |= {"ink": drawing.INK, "muted": drawing.MUTED, "grid": drawing.GRID, "shade": drawing.SHADE}
        return Template(read["index.html"]).substitute(
            title=escape(self.title),
            style=Template(read["style.css"]).substitute(surface=drawing.SURFACE, alarm=drawing.ALARM_COLOUR, **colors),
            header=json.dumps(header, ensure_ascii=False).replace("<", "\\u003c"),
            data=packer.text(),
            script=viewer.joinpath("animation.js").read_text(encoding="utf-8"),
        )

    def felt(self) -> Float:
        """Size of the force that every user feels, from all tools and grips together, (F, U) [N]."""
        total = np.zeros((self.time.size, len(self.users), 3))
        for track, owner in enumerate(self.tools.owner):
            total[:, owner] += self.tools.force[:, track]
        for track, owner in enumerate(self.ports.owner):
            total[:, owner] -= self.ports.force[:, track]
        return np.linalg.norm(total, axis=-1)

    def _peaks(self) -> tuple[float, float]:
        """Largest displacement from rest, and largest distance of a copy's vertex from the mean of the copies [m]."""
        displacement = difference = 0.0
        for frame in self.vertices:  # not all at once: a big animation has few copies of itself in memory
            displacement = max(displacement, float(np.square(frame - self.rest).sum(axis=-1).max(initial=0.0)))
            gap = frame - frame.mean(axis=0)
            difference = max(difference, float(np.square(gap).sum(axis=-1).max(initial=0.0)))
        return displacement**0.5, difference**0.5


def _carried(skin: Skin, field: Single) -> Single:
    """Places of the skin's vertices in all frames, one user at a time."""
    frames, users, nodes, _ = field.shape
    weights = skin.interpolation(nodes)
    places = np.empty((frames, users, skin.vertices.shape[0], 3), dtype=np.float32)
    for user in range(users):
        columns = field[:, user].transpose(1, 0, 2).reshape(nodes, -1)
        moved = np.asarray(weights @ columns).reshape(-1, frames, 3).transpose(1, 0, 2)
        places[:, user] = moved + skin.vertices
    return places
