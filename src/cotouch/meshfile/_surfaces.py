"""Triangles of a file, by trimesh where it knows the format."""

import io
import re
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np

from cotouch.arrays import Long
from cotouch.errors import BodyError
from cotouch.meshfile._legacy import polydata, strip
from cotouch.meshfile._mesh import Float, Mesh
from cotouch.meshfile._promises import check, too_many

# Formats that say how many faces they have; a polygon becomes more triangles, never fewer.
_COUNTED: Final = (".ply", ".off")
_HEAD: Final = 1024
_TEXT: Final = re.compile(rb"[\t\n\r -\xff]*")


def load() -> None:
    """Loads the library."""
    import trimesh  # noqa: F401  # pyright: ignore[reportUnusedImport]


def read(path: Path, most: int) -> Mesh:
    """All triangles, as they are.

    Args:
        path: of the file.
        most: elements that are taken.

    Raises:
        BodyError: it is not a mesh, or has more than `most` triangles.
        Exception: whatever the library raises.
    """
    said = check(path, "triangles", "most_triangles", most)
    points, triangles = (_vtk if path.suffix.lower() == ".vtk" else _by_library)(path)
    if triangles.shape[0] == 0:
        if points.shape[0] == 0:
            raise ValueError("it contains no mesh")
        raise BodyError(f"has {points.shape[0]} points but no triangles; it must be a surface mesh")
    if triangles.shape[0] > most:
        raise too_many(triangles.shape[0], "triangles", "most_triangles", most)
    if path.suffix.lower() in _COUNTED and triangles.shape[0] < (said.elements or 0):
        raise ValueError(f"it ends after {triangles.shape[0]} of {said.elements} faces")
    return Mesh(points=points, elements=triangles)


def _vtk(path: Path) -> tuple[Float, Long]:
    mesh = polydata(path)
    return mesh.points, mesh.elements


def _by_library(path: Path) -> tuple[Float, Long]:
    import trimesh

    kind = path.suffix.lower()[1:]
    with path.open("rb") as file:
        mesh = trimesh.load_scene(_stl(file) if kind == "stl" else file, file_type=kind, process=False).to_mesh()
        points = np.array(mesh.vertices, dtype=np.float64).reshape(-1, 3)
        triangles = np.array(mesh.faces, dtype=np.int64).reshape(-1, 3)
        if kind == "ply" and triangles.shape[0] == 0:
            file.seek(0)
            return _strips(file)
    return points, triangles


def _stl(file: BinaryIO) -> BinaryIO:
    """The file as the library understands it: words such as "end solid" joined, nothing behind packed triangles.

    Raises:
        ValueError: it ends too early.
    """
    head = file.read(_HEAD)
    file.seek(0)
    if not (head.lstrip().lower().startswith(b"solid") and _TEXT.fullmatch(head)):
        count, held = int.from_bytes(head[80:84], "little"), max(file.seek(0, 2) - 84, 0) // 50
        file.seek(0)
        if held < count:
            raise ValueError(f"it claims {count} triangles but has bytes for only {held}")
        return io.BytesIO(file.read(84 + 50 * count))
    text = re.sub(rb"(?i)\bend[ \t]+(solid|facet|loop)\b", rb"end\1", file.read())
    if re.search(rb"(?i)\bendsolid\b", text[-_HEAD:]) is None:
        raise ValueError("it ends before its solid is complete")
    return io.BytesIO(text)


def _strips(file: BinaryIO) -> tuple[Float, Long]:
    """Triangles of the strips of a PLY file; -1 ends a strip."""
    from trimesh.exchange.ply import load_ply

    found = load_ply(file)
    points = np.array(found["vertices"], dtype=np.float64).reshape(-1, 3)
    element = found["metadata"]["_ply_raw"].get("tristrips", {})
    if "data" not in element:
        return points, np.zeros((0, 3), dtype=np.int64)
    rows = element["data"][next(iter(element["properties"]))]
    rows = rows["f1"] if rows.dtype.names else rows  # packed, a list has its length before it
    flat = np.concatenate([np.append(np.asarray(row, dtype=np.int64), -1) for row in rows])
    parts = [strip(part[part >= 0]) for part in np.split(flat, np.flatnonzero(flat < 0))]
    triangles = np.concatenate(parts)
    if triangles.size and triangles.max() >= len(points):
        raise ValueError("a strip refers to a point that does not exist")
    return points, triangles
