"""Rigid boxes, cylinders and balls: inertia by closed forms, and a skin to meet the world with."""

from collections.abc import Sequence
from typing import Final, TypeAlias

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Long
from cotouch.body._body import Body
from cotouch.body._checks import FARTHEST, one_number
from cotouch.body._origin import Origin
from cotouch.body._rigid import RATE, VISCOSITY, rigid_body
from cotouch.errors import BodyError

Surface: TypeAlias = tuple[Float, Long]

# More cells along a side make a skin that no step gets around in a millisecond.
_MOST_CELLS: Final = 200
# Sides of a cylinder at least: the corners of so many are as far out as it, what they stand for a thousandth less.
_ROUND = 24
_NOWHERE = (0.0, 0.0, 0.0)
# A body may be so many of its own sizes away before its shape is lost in rounding.
OFF: Final = 1e6
# What is turned further is a mistake [rad].
_TURNS: Final = 100.0


def rigid_box(
    size: Sequence[float],
    *,
    mass: float | None = None,
    density: float = 1000.0,
    centre: Sequence[float] = _NOWHERE,
    turn: Sequence[float] = _NOWHERE,
    resolution: int = 4,
    rate: float = RATE,
    viscosity: float = VISCOSITY,
) -> Body:
    """A rigid box.

    Args:
        size: lengths of its sides, each > 0 [m].
        mass: [kg]; None: density times volume.
        density: [kg/m³], > 0.
        centre: of it [m].
        turn: how it is turned about its centre: along the axis of turning, as long as the angle [rad].
        resolution: cells of its skin along the longest side.
        rate: see `rigid_body` [rad/s].
        viscosity: see `rigid_body` [s].

    Raises:
        BodyError: a value is out of its range.

    Examples:
        >>> rigid_box([0.1, 0.1, 0.1]).skin.vertices.shape
        (98, 3)
    """
    a, b, c = _lengths("size", size, 3)
    cells = np.maximum(np.rint(_cells(resolution) * np.array([a, b, c]) / max(a, b, c)), 1).astype(int)
    vertices, triangles = box_surface(cells)
    vertices = (vertices / cells - 0.5) * (a, b, c)
    spread = np.diag([a * a, b * b, c * c]) / 12.0
    return _made("box", vertices, triangles, a * b * c, spread, mass, density, centre, turn, rate, viscosity)


def rigid_cylinder(
    radius: float,
    length: float,
    *,
    mass: float | None = None,
    density: float = 1000.0,
    centre: Sequence[float] = _NOWHERE,
    turn: Sequence[float] = _NOWHERE,
    resolution: int = 8,
    rate: float = RATE,
    viscosity: float = VISCOSITY,
) -> Body:
    """A rigid cylinder, along z before it is turned.

    Args:
        radius: > 0 [m].
        length: > 0 [m].
        mass: [kg]; None: density times volume.
        density: [kg/m³], > 0.
        centre: of it [m].
        turn: see `rigid_box` [rad].
        resolution: cells of its skin along its length or, if that is longer, its diameter.
        rate: see `rigid_body` [rad/s].
        viscosity: see `rigid_body` [s].

    Raises:
        BodyError: a value is out of its range.
    """
    r, h = *_lengths("radius", [radius], 1), *_lengths("length", [length], 1)
    spacing = max(2.0 * r, h) / _cells(resolution)
    around = max(_ROUND, 4 * round(0.5 * np.pi * r / spacing))
    vertices, triangles = _cylinder_surface(around, max(1, round(h / spacing)), max(1, round(r / spacing)))
    vertices = vertices * (r, r, 0.5 * h)
    spread = np.diag([0.25 * r * r, 0.25 * r * r, h * h / 12.0])
    return _made(
        "cylinder", vertices, triangles, np.pi * r * r * h, spread, mass, density, centre, turn, rate, viscosity
    )


def rigid_sphere(
    radius: float,
    *,
    mass: float | None = None,
    density: float = 1000.0,
    centre: Sequence[float] = _NOWHERE,
    resolution: int = 8,
    rate: float = RATE,
    viscosity: float = VISCOSITY,
) -> Body:
    """A rigid ball.

    Args:
        radius: > 0 [m].
        mass: [kg]; None: density times volume.
        density: [kg/m³], > 0.
        centre: of it [m].
        resolution: cells of its skin along its diameter, about.
        rate: see `rigid_body` [rad/s].
        viscosity: see `rigid_body` [s].

    Raises:
        BodyError: a value is out of its range.
    """
    (r,) = _lengths("radius", [radius], 1)
    vertices, triangles = _sphere_surface(_cells(resolution))
    volume, spread = 4.0 / 3.0 * np.pi * r**3, 0.2 * r * r * np.eye(3)
    return _made("sphere", r * vertices, triangles, volume, spread, mass, density, centre, _NOWHERE, rate, viscosity)


def _made(
    name: str,
    vertices: Float,
    triangles: Long,
    volume: float,
    spread: Float,
    mass: float | None,
    density: float,
    centre: Sequence[float],
    turn: Sequence[float],
    rate: float,
    viscosity: float,
) -> Body:
    for label, value, unit in (("density", density, "kg/m³"), ("mass", mass, "kg")):
        if value is not None and not (np.isfinite(one_number(label, value)) and value > 0.0):
            raise BodyError(f"{label} is {value}; it must be more than 0 {unit}")
    size = float(np.ptp(vertices, axis=0).max())
    middle = np.array(three("centre", centre, OFF * size, f" of at most {OFF * size:.3g} m, a million times its size"))
    turned = turning(turn)
    edges = vertices[triangles] - np.roll(vertices[triangles], 1, axis=1)
    places = vertices @ turned.T + middle
    return rigid_body(
        places,
        triangles,
        mass=density * volume if mass is None else mass,
        centre=middle,
        spread=turned @ spread @ turned.T,
        rate=rate,
        viscosity=viscosity,
        origin=Origin(
            source=name,
            kind="shape",
            model="rigid",
            unit="m",
            elements=triangles.shape[0],
            volume=volume,
            size=np.ptp(places, axis=0),
            spacing=float(np.linalg.norm(edges, axis=2).mean()),
        ),
    )


def turning(turn: Sequence[float], name: str = "turn") -> Float:
    """The rotation about an axis by its length, (3, 3) [Rodrigues].

    Args:
        turn: along the axis, as long as the angle [rad].
        name: of it, for the message.

    Raises:
        BodyError: it is not three numbers, or more than some turns.
    """
    from scipy.spatial.transform import Rotation

    vector = three(name, turn, _TURNS, f" of at most {_TURNS:g} rad")
    return Rotation.from_rotvec(vector).as_matrix()


def _cells(resolution: int) -> int:
    if not (float(resolution).is_integer() and 1 <= resolution <= _MOST_CELLS):
        raise BodyError(f"resolution is {resolution}; it must be a whole number from 1 to {_MOST_CELLS}")
    return int(resolution)


def three(name: str, values: Sequence[float], most: float = np.inf, why: str = "") -> list[float]:
    """Three numbers, each finite and not beyond a bound.

    Args:
        name: of them, for the message.
        values: anything of that many.
        most: the bound.
        why: what the message says of the bound.

    Raises:
        BodyError: they are not.
    """
    if len(values) != 3 or not np.isfinite(values).all() or max(map(abs, values)) > most:
        raise BodyError(f"{name} is {list(values)}; it must be three finite numbers{why}")
    return [float(value) for value in values]


def _lengths(name: str, values: Sequence[float], count: int) -> list[float]:
    good = len(values) == count and all(np.isfinite(one_number(name, v)) and 0.0 < v <= FARTHEST for v in values)
    if not good:
        shown = list(values) if count > 1 else values[0]
        what = "three lengths" if count == 3 else "a length"
        raise BodyError(f"{name} is {shown}; it must be {what} above 0 and up to {FARTHEST:g} m")
    return [float(value) for value in values]


def box_surface(cells: npt.ArrayLike) -> Surface:
    """The faces of a box of so many cells along its sides, each a square of two triangles; cells are 1 long.

    A side without cells has one face.

    Args:
        cells: along x, y, z, (3,).
    """
    extents = np.asarray(cells, dtype=np.int64) + 1
    index = np.arange(int(np.prod(extents))).reshape(extents)
    triangles: list[Long] = []
    for axis in range(3):
        for side in (0, -1) if extents[axis] > 1 else (-1,):
            face = np.take(index, side, axis=axis)
            a, b, c, d = face[:-1, :-1], face[1:, :-1], face[1:, 1:], face[:-1, 1:]
            # The two other axes in order make a right-handed frame with x and z, a left-handed one with y.
            outward = (side == -1) != (axis == 1)
            for one, two, three in ((a, b, c), (a, c, d)):
                corners = (one, two, three) if outward else (one, three, two)
                triangles.append(np.stack([corner.ravel() for corner in corners], axis=1))
    used, local = np.unique(np.concatenate(triangles), return_inverse=True)
    return np.stack(np.unravel_index(used, extents), axis=1).astype(np.float64), local.reshape(-1, 3).astype(np.int64)


def _cylinder_surface(around: int, along: int, rings: int) -> Surface:
    """A cylinder of radius 1 from z = -1 to 1."""
    angle = 2.0 * np.pi * np.arange(around) / around
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    radii = [ring / rings for ring in range(1, rings)]
    # Rings from the middle of the bottom, up the wall, to the middle of the top.
    levels = [*((r, -1.0) for r in radii), *((1.0, 2.0 * k / along - 1.0) for k in range(along + 1))]
    levels += [(r, 1.0) for r in reversed(radii)]
    vertices = [np.column_stack([r * circle, np.full(around, z)]) for r, z in levels]
    vertices += [np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]])]
    here = np.arange(around)
    there = np.roll(here, -1)
    triangles: list[Long] = []
    for level in range(len(levels) - 1):
        low, high = level * around, (level + 1) * around
        triangles.append(np.stack([low + here, low + there, high + there], axis=1))
        triangles.append(np.stack([low + here, high + there, high + here], axis=1))
    bottom, top = len(levels) * around, len(levels) * around + 1
    last = (len(levels) - 1) * around
    triangles.append(np.stack([there, here, np.full(around, bottom)], axis=1))
    triangles.append(np.stack([last + here, last + there, np.full(around, top)], axis=1))
    return np.concatenate(vertices), np.concatenate(triangles)


def _sphere_surface(cells: int) -> Surface:
    """A ball of radius 1: the faces of a cube of so many cells, drawn out to it, with angles between them alike."""
    vertices, triangles = box_surface([cells] * 3)
    places = np.tan(0.25 * np.pi * (2.0 * vertices / cells - 1.0))
    return places / np.linalg.norm(places, axis=1, keepdims=True), triangles
