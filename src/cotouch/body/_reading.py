"""What a mesh's numbers mean, and whether they are a mesh."""

from pathlib import Path
from typing import Final, Literal, TypeAlias, cast

import numpy as np
import numpy.typing as npt

from cotouch.arrays import extents
from cotouch.errors import BodyError
from cotouch.meshfile import Mesh, read_surface, read_tetrahedra

Unit: TypeAlias = Literal["m", "mm", "cm", "in"]

UNITS: Final[dict[str, float]] = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
# glTF 2.0 fixes the metre (Khronos, section 3.4); no other of these formats says what a number means.
_METRES: Final = (".glb",)
# What reads elements of a kind, how many corners they have, and what their limit is called.
_READERS: Final = {
    "triangles": (read_surface, 3, "most_triangles"),
    "tetrahedra": (read_tetrahedra, 4, "most_elements"),
}


def metres(unit: str | None, source: str) -> float:
    """What one unit of the source is in metres.

    Args:
        unit: "m", "mm", "cm" or "in"; None: not said.
        source: what messages call the file.

    Raises:
        BodyError: it is not said, or not known.
    """
    if unit is None:
        if Path(source).suffix.lower() in _METRES:
            return 1.0
        raise BodyError(
            f'the unit of {source} is not given, and the mesh does not state it; give unit "m", "mm", "cm" or "in"'
        )
    if unit not in UNITS:
        raise BodyError(f'the unit of {source} is "{unit}"; it must be "m", "mm", "cm" or "in"')
    if Path(source).suffix.lower() in _METRES and unit != "m":
        raise BodyError(f'the unit of {source} is "{unit}", but glTF files are always in metres; leave unit out')
    return UNITS[unit]


def as_mesh(source: object, width: int, what: str) -> Mesh:
    """Points and elements that were given as arrays.

    Args:
        source: what messages call the file.
        width: corners of an element.
        what: what messages call its elements.

    Raises:
        BodyError: they are not.
    """
    try:
        points, elements = cast("tuple[npt.ArrayLike, npt.ArrayLike]", source)
        places = np.array(points, dtype=np.float64)
        given = np.asarray(elements)
        corners = np.array(given, dtype=np.int64)
    except (TypeError, ValueError, OverflowError) as error:
        raise BodyError(f"the source is neither a file nor (points, {what}) ({error}); give one of them") from error
    if places.ndim != 2 or places.shape[1] != 3:
        raise BodyError(f"the points are {extents(places.shape)}; they must be P x 3")
    if corners.ndim != 2 or corners.shape[1] != width or corners.shape[0] == 0 or not np.array_equal(corners, given):
        wanted = f"at least one row of {width} whole numbers"
        raise BodyError(f"the {what} are {extents(given.shape)}; they must be {wanted}")
    return Mesh(points=places, elements=corners)


def mesh_of(source: object, name: str, what: Literal["triangles", "tetrahedra"], most: int) -> Mesh:
    """Points and elements of a file, or as they were given.

    Args:
        source: a file, or points and elements.
        name: what messages call it.
        what: the elements.
        most: refuse more of them.

    Raises:
        BodyError: it is no such mesh, or has too many elements.
    """
    read, width, limit = _READERS[what]
    mesh = read(Path(name), most) if isinstance(source, str | Path) else as_mesh(source, width, what)
    if mesh.elements.shape[0] > most:
        raise BodyError(
            f"{name} has {mesh.elements.shape[0]} {what} but the limit is {most}; make it coarser, or raise {limit}"
        )
    return mesh


def check_indices(mesh: Mesh, source: str, what: str) -> None:
    """Refuses elements that name points which are not there, and points in use that are not finite.

    Args:
        mesh: points and elements.
        source: what messages call the file.
        what: what messages call its elements.

    Raises:
        BodyError: one is.
    """
    used = mesh.elements
    if used.min() < 0 or used.max() >= mesh.points.shape[0]:
        wrong = int(used.min() if used.min() < 0 else used.max())
        raise BodyError(f"{what} of {source} name point {wrong}; it has points 0 to {mesh.points.shape[0] - 1}")
    bad = np.flatnonzero(~np.isfinite(mesh.points).all(axis=1))
    bad = bad[np.isin(bad, used)]
    if bad.size:
        place = mesh.points[bad[0]].tolist()
        raise BodyError(f"point {bad[0]} of {source} is {place}; every coordinate must be a finite number")
