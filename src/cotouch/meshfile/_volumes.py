"""Tetrahedra and named sets of a file, by meshio."""

from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from cotouch.arrays import Long, extents
from cotouch.errors import BodyError
from cotouch.meshfile._legacy import gmsh_1, is_gmsh_1, vtk_kind
from cotouch.meshfile._mesh import Mesh
from cotouch.meshfile._promises import check, too_many

if TYPE_CHECKING:
    import meshio

# Of marks that number cells; a file with more has them for something else.
_MOST_MARKS: Final = 1000


def load() -> None:
    """Loads the library."""
    import meshio  # noqa: F401  # pyright: ignore[reportUnusedImport]


def read(path: Path, most: int) -> Mesh:
    """All tetrahedra, as they are.

    Args:
        path: of the file.
        most: elements that are taken.

    Raises:
        BodyError: it has no tetrahedra, other solid cells, or more than `most` elements.
        Exception: whatever the library raises.
    """
    check(path, "elements", "most_elements", most)
    import meshio

    suffix = path.suffix.lower()
    form = {".msh": "gmsh", ".mesh": "medit"}.get(suffix)
    if suffix == ".vtk":
        form = {"XML": "vtu", "POLYDATA": ""}.get(vtk_kind(path), "vtk")
        if not form:
            raise BodyError("is a surface (POLYDATA) and has no tetrahedra; make a tetrahedral mesh of it")
    if suffix == ".msh" and is_gmsh_1(path):
        return _checked(gmsh_1(path), most)
    read = meshio.read(path, file_format=form)
    points = np.array(read.points, dtype=np.float64)
    blocks = [(str(block.type), np.array(block.data, dtype=np.int64)) for block in read.cells]
    corners = {"tetra": 4, "tetra10": 10}
    for kind, data in blocks:
        if kind in corners and (data.ndim != 2 or data.shape[1] != corners[kind]):
            raise ValueError(f"its {kind} cells do not have {corners[kind]} corners each")
    if points.ndim != 2 or points.shape[1] != 3:
        raise ValueError(
            "it has no points" if not points.size else f"its points are {extents(points.shape)}, not P x 3"
        )
    notes: list[str] = []
    sets = _sets(read, blocks, points.shape[0], notes)
    solid = [data[:, :4] for kind, data in blocks if kind in corners]
    others = {kind: sum(len(data) for k, data in blocks if k == kind) for kind, _ in blocks}
    if not sum(map(len, solid)):
        held = ", ".join(f"{count} {kind}" for kind, count in others.items()) or "no cells"
        raise BodyError(f"has no tetrahedra but {held}; make a tetrahedral mesh of it")
    volumes = {kind for kind in others if kind.startswith(("hexahedron", "wedge", "pyramid"))}
    if volumes:
        held = ", ".join(f"{others[kind]} {kind}" for kind in sorted(volumes))
        raise BodyError(f"has {held} besides its tetrahedra; every solid cell must be a tetrahedron")
    if any(kind == "tetra10" for kind, _ in blocks):
        notes.append("Quadratic tetrahedra are used by their corners only.")
    return _checked(Mesh(points=points, elements=np.concatenate(solid), sets=sets, notes=tuple(notes)), most)


def _checked(mesh: Mesh, most: int) -> Mesh:
    if mesh.elements.shape[0] == 0:
        raise BodyError("has no tetrahedra; make a tetrahedral mesh of it")
    if mesh.elements.shape[0] > most:
        raise too_many(mesh.elements.shape[0], "tetrahedra", "most_elements", most)
    return mesh


def _sets(read: "meshio.Mesh", blocks: list[tuple[str, Long]], points: int, notes: list[str]) -> dict[str, Long]:
    """Points of every set that the file names: node sets, cell sets, physical groups, marks on points."""
    found: dict[str, Long] = {}
    for name, members in read.point_sets.items():
        found[str(name)] = np.unique(np.asarray(members, dtype=np.int64))
    for name, members in read.cell_sets.items():
        if str(name).startswith("gmsh:"):  # how its entities bound each other
            continue
        corners = [
            data[np.asarray(chosen, dtype=np.int64)].ravel()
            for (_, data), chosen in zip(blocks, members, strict=False)
            if chosen is not None and len(chosen)
        ]
        if corners:
            found[str(name)] = np.unique(np.concatenate(corners))
    tags = read.cell_data.get("gmsh:physical", [])
    names = {(int(tag), int(size)): str(name) for name, (tag, size) in read.field_data.items()} if tags else {}
    sizes = {"vertex": 0, "line": 1, "triangle": 2, "triangle6": 2, "tetra": 3, "tetra10": 3}
    for (tag, size), name in names.items():
        corners = [
            data[np.asarray(marks) == tag].ravel()
            for (kind, data), marks in zip(blocks, tags, strict=True)
            if sizes.get(kind) == size
        ]
        if corners and name not in found:
            found[name] = np.unique(np.concatenate(corners))
    marks = read.cell_data.get("medit:ref")
    if marks:
        different = np.unique(np.concatenate([np.asarray(block) for block in marks]))
        if different.size > _MOST_MARKS:
            notes.append(f"{different.size} different marks on cells are no sets; sets need at most {_MOST_MARKS}.")
            different = different[:0]
        for mark in different:
            corners = [data[np.asarray(block) == mark].ravel() for (_, data), block in zip(blocks, marks, strict=True)]
            found[f"ref {int(mark)}"] = np.unique(np.concatenate(corners))
    for name, values in read.point_data.items():
        column = np.asarray(values)
        if column.shape == (points,) and column.dtype.kind in "biu" and name not in found:
            found[str(name)] = np.flatnonzero(column).astype(np.int64)
    return {name: chosen[(chosen >= 0) & (chosen < points)] for name, chosen in found.items()}
