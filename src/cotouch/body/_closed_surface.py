"""A closed surface from a file."""

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.body._assembly import MeshSource, name_of
from cotouch.body._reading import Unit, mesh_of, metres
from cotouch.body._repair import Shells, repaired
from cotouch.meshfile import Mesh


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
    made = closed_shells(source, name_of(source), unit, most_triangles)
    return made.vertices, made.triangles.astype(np.int32), tuple(made.notes)


def closed_shells(source: MeshSource, name: str, unit: Unit | None, most_triangles: int) -> Shells:
    """The closed surface of a mesh, shell by shell [m].

    Args:
        source: as of `closed_surface`.
        name: what messages call it.
        unit: of the source.
        most_triangles: refuse more than this.

    Raises:
        BodyError: the source is no closed surface and cannot be made one, or has too many triangles.
    """
    scale = metres(unit, name)
    mesh = mesh_of(source, name, "triangles", most_triangles)
    return repaired(Mesh(points=mesh.points * scale, elements=mesh.elements, notes=mesh.notes), name)
