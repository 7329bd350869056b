"""Static shapes: how deep a point is in them, one file for each shape."""

from collections.abc import Sequence

import numpy as np

from cotouch.arrays import Float
from cotouch.kernels import inner
from cotouch.mechanics._shapes import _box as box
from cotouch.mechanics._shapes import _plane as plane
from cotouch.mechanics._shapes import _plate as plate
from cotouch.mechanics._shapes._box import Box
from cotouch.mechanics._shapes._plane import Plane, Vector3
from cotouch.mechanics._shapes._plate import Plate
from cotouch.mechanics._shapes._solid import Solid

Shape = Plane | Box | Plate | Solid
# The registry: a shape's place here is its number in kernels. A *shape* is a NamedTuple with `packed` (the numbers that
# its kernel reads, at most `NUMBERS`) and `thickness`, and one compiled function, `depth`, which `depth` below calls.
SHAPES: tuple[type, ...] = (Plane, Box, Plate)
NUMBERS = 19
# How many numbers each field of a shape has.
_WIDTHS = {Plane: (3, 3), Box: (3, 3, 3), Plate: (3, 4, 3, 3)}
_PLANE, _PLATE = 0, 2


@inner
def depth(kind: int, numbers: Float, s: int, x: float, y: float, z: float) -> tuple[float, float, float, float, int]:
    """How deep a point is in a shape.

    Args:
        kind: of the shape, its place in `SHAPES`.
        numbers: of all shapes, (shapes, NUMBERS).
        s: which of them.
        x: of the point [m].
        y: likewise.
        z: likewise.

    Returns:
        Depth, less than 0 outside [m]; the unit normal out of the shape where that is shortest; and which flat face
        that is, -1 where it is none: on one face depth is a linear function.
    """
    if kind == _PLANE:
        return plane.depth(numbers, s, x, y, z)
    if kind == _PLATE:
        return plate.depth(numbers, s, x, y, z)
    return box.depth(numbers, s, x, y, z)


@inner
def passes(
    kind: int, numbers: Float, s: int, x: float, y: float, z: float, mx: float, my: float, mz: float,
    before: float, face: int, after: float, other: int,
) -> bool:  # fmt: skip
    """Whether a point that moves by m comes out of a shape, or is pushed out, on the side opposite to where it came in.

    Args:
        kind: as for `depth`, like all up to z.
        numbers: likewise.
        s: likewise.
        x: where the point starts [m].
        y: likewise.
        z: likewise.
        mx: how far it moves [m].
        my: likewise.
        mz: likewise.
        before: its depth at the start [m].
        face: the nearest there.
        after: its depth at the end [m].
        other: the nearest face there.
    """
    if kind == _PLANE:
        return False
    if before <= 0.0 and -before > abs(mx) + abs(my) + abs(mz):
        return False
    if kind == _PLATE and plate.through(numbers, s, x, y, z, mx, my, mz):
        return False
    enters, leaves = box.crosses(numbers, s, x, y, z, mx, my, mz)
    if enters == -2:
        return False
    enters = face if before > 0.0 else enters
    leaves = other if after > 0.0 else leaves
    return enters >= 0 and leaves >= 0 and enters // 2 == leaves // 2 and enters != leaves


def shape_table(shape: Shape) -> dict[str, object]:
    """A shape as the page knows it: its kind, and its numbers by name."""
    if isinstance(shape, Solid):
        numbers = {"vertices": shape.vertices, "triangles": shape.triangles}
    else:
        numbers = shape._asdict()
    told = {name: np.asarray(value).ravel().tolist() for name, value in numbers.items()}
    return {"kind": type(shape).__name__.lower(), **told}


def packed(shape: Plane | Box | Plate, origin: Vector3) -> tuple[int, list[float]]:
    """The number of a shape, and what kernels read of it.

    Args:
        shape: whose kernel reads it.
        origin: of the body, from which places are counted [m].

    Raises:
        BodyError: the shape has no extent.
    """
    return SHAPES.index(type(shape)), shape.packed(origin)


def shape_of(kind: int, numbers: Sequence[float]) -> Plane | Box | Plate:
    """A shape of the numbers of its fields, one after the other; what follows them is left out.

    Args:
        kind: its place in `SHAPES`.
        numbers: of its fields.
    """
    made, start = SHAPES[kind], 0
    fields: list[tuple[float, ...]] = []
    for width in _WIDTHS[made]:
        fields.append(tuple(float(number) for number in numbers[start : start + width]))
        start += width
    return made(*fields)
