"""A closed surface from a file, for what is no body."""

from pathlib import Path

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body._assembly import MeshSource, name_of
from cotouch.body._reading import Unit, as_mesh, metres
from cotouch.body._repair import repaired
from cotouch.errors import BodyError
from cotouch.meshfile import Mesh, read_surface


def closed_surface(
    source: MeshSource, *, unit: Unit | None = None, most_triangles: int = 20_000
) -> tuple[Float, Int, tuple[str, ...]]:
    """The closed surface of a mesh, turned outwards: vertices (V, 3) [m], triangles (F, 3), and what was repaired.

    Args:
        source: an STL, OBJ, PLY, OFF or GLB file, or (points (P, 3), triangles (F, 3)).
        unit: of the source: "m", "mm", "cm" or "in". Only GLB says it itself (metres).
        most_triangles: refuse more than this.

    Raises:
        BodyError: the source is no closed surface and cannot be made one, or has too many triangles.
    """
    name = name_of(source)
    scale = metres(unit, name)
    if isinstance(source, str | Path):
        mesh = read_surface(Path(name), most_triangles)
    else:
        mesh = as_mesh(source, 3, "triangles")
    if mesh.elements.shape[0] > most_triangles:
        raise BodyError(
            f"{name} has {mesh.elements.shape[0]} triangles but the limit is {most_triangles}; make it coarser, or "
            "raise most_triangles"
        )
    made = repaired(Mesh(points=mesh.points * scale, elements=mesh.elements, notes=mesh.notes), name)
    return made.vertices, made.triangles.astype(np.int32), tuple(made.notes)
