"""Reading mesh files: counted before they are loaded, and whatever a reader does wrong is one sentence."""

import contextlib
import io
import re
import warnings
from collections.abc import Callable, Generator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO, Final, Literal, TypeAlias, cast, final

import numpy as np
import numpy.typing as npt

from cotouch.errors import BodyError

Float = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Unit: TypeAlias = Literal["m", "mm", "cm", "in"]

UNITS: Final[dict[str, float]] = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254}
SURFACES: Final = (".stl", ".obj", ".ply", ".off", ".glb")
VOLUMES: Final = (".vtk", ".vtu", ".msh", ".mesh")
# glTF 2.0 fixes the metre (Khronos, section 3.4); no other of these formats says what a number means.
_METRES: Final = (".glb",)
_CHUNK: Final = 1 << 20
_OVERLAP: Final = 256
# No format stores an element, with its share of the points, in less; a bigger file is refused unread.
_LEAST_BYTES: Final = 600


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Mesh:
    """What a file holds, in its own unit.

    Attributes:
        points: (P, 3).
        elements: triangles (F, 3) or tetrahedra (E, 4), indices of points.
        sets: indices of points of every named set.
        notes: what was left out or changed.
    """

    points: Float
    elements: Ints
    sets: Mapping[str, Ints] = field(default_factory=dict[str, Ints])
    notes: tuple[str, ...] = ()


def metres(unit: str | None, source: str) -> float:
    """What one unit of the source is in metres.

    Raises:
        BodyError: it is not said, or not known.
    """
    if unit is None:
        if Path(source).suffix.lower() in _METRES:
            return 1.0
        raise BodyError(f'the unit of {source} is not given and no mesh says it; give unit "m", "mm", "cm" or "in"')
    if unit not in UNITS:
        raise BodyError(f'the unit of {source} is "{unit}"; it must be "m", "mm", "cm" or "in"')
    if Path(source).suffix.lower() in _METRES and unit != "m":
        raise BodyError(f'the unit of {source} is "{unit}", but glTF is in metres by its standard; leave unit out')
    return UNITS[unit]


def read_surface(path: Path, most: int) -> Mesh:
    """Triangles of an STL, OBJ, PLY, OFF or GLB file.

    Raises:
        BodyError: it is missing, of another kind, not a mesh, or has more than `most` triangles.
    """
    _there(path, SURFACES, "a surface mesh", most)
    counted = _count(path)
    if counted is not None and counted > most:
        raise _too_many(path, counted, "triangles", "most_triangles", most)
    import trimesh

    with _reader(path), path.open("rb") as file:
        scene: Any = trimesh.load_scene(file, file_type=path.suffix.lower()[1:], process=False)
        mesh: Any = scene.to_mesh()
        points = np.array(mesh.vertices, dtype=np.float64).reshape(-1, 3)
        triangles = np.array(mesh.faces, dtype=np.int64).reshape(-1, 3)
    if triangles.shape[0] == 0:
        if points.shape[0] == 0:
            raise BodyError(f"{path} cannot be read as {path.suffix[1:].upper()}: there is no mesh in it")
        raise BodyError(f"{path} has {points.shape[0]} points but no triangles; it must be a surface mesh")
    if triangles.shape[0] > most:
        raise _too_many(path, triangles.shape[0], "triangles", "most_triangles", most)
    return Mesh(points=points, elements=triangles)


def read_tetrahedra(path: Path, most: int) -> Mesh:
    """Tetrahedra and named sets of a VTK, VTU, Gmsh or MEDIT file.

    Raises:
        BodyError: it is missing, of another kind, not a mesh, has no tetrahedra, or more than `most` elements.
    """
    _there(path, VOLUMES, "a tetrahedral mesh", most)
    counted = _count(path)
    if counted is not None and counted > most:
        raise _too_many(path, counted, "elements", "most_elements", most)
    import meshio

    with _reader(path):
        read: Any = meshio.read(path, file_format={".msh": "gmsh", ".mesh": "medit"}.get(path.suffix.lower()))
        points = np.array(read.points, dtype=np.float64)
        blocks = [(str(block.type), np.array(block.data, dtype=np.int64)) for block in read.cells]
        corners = {"tetra": 4, "tetra10": 10}
        for kind, data in blocks:
            if kind in corners and (data.ndim != 2 or data.shape[1] != corners[kind]):
                raise ValueError(f"its {kind} cells have no {corners[kind]} corners each")
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"its points are {' x '.join(map(str, points.shape))}, not P x 3")
        sets = _sets(read, blocks, points.shape[0])
    notes: list[str] = []
    solid = [data[:, :4] for kind, data in blocks if kind in {"tetra", "tetra10"}]
    others = {kind: sum(len(data) for k, data in blocks if k == kind) for kind, _ in blocks}
    if not solid:
        held = ", ".join(f"{count} {kind}" for kind, count in others.items()) or "no cells"
        raise BodyError(f"{path} has no tetrahedra but {held}; make a tetrahedral mesh of it")
    volumes = {kind for kind in others if kind.startswith(("hexahedron", "wedge", "pyramid"))}
    if volumes:
        held = ", ".join(f"{others[kind]} {kind}" for kind in sorted(volumes))
        raise BodyError(f"{path} has {held} beside its tetrahedra; every solid cell must be a tetrahedron")
    if any(kind == "tetra10" for kind, _ in blocks):
        notes.append("Quadratic tetrahedra are used by their corners only.")
    elements = np.concatenate(solid)
    if elements.shape[0] > most:
        raise _too_many(path, elements.shape[0], "tetrahedra", "most_elements", most)
    return Mesh(points=points, elements=elements, sets=sets, notes=tuple(notes))


def _sets(read: Any, blocks: list[tuple[str, Ints]], points: int) -> dict[str, Ints]:
    """Points of every set that the file names: node sets, cell sets, physical groups, marks on points."""
    found: dict[str, Ints] = {}
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
    tags = read.cell_data.get("gmsh:physical")
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
        for mark in np.unique(np.concatenate([np.asarray(block) for block in marks])):
            corners = [data[np.asarray(block) == mark].ravel() for (_, data), block in zip(blocks, marks, strict=True)]
            found[f"ref {int(mark)}"] = np.unique(np.concatenate(corners))
    for name, values in read.point_data.items():
        column = np.asarray(values)
        if column.shape == (points,) and column.dtype.kind in "biu" and name not in found:
            found[str(name)] = np.flatnonzero(column).astype(np.int64)
    return found


def _there(path: Path, suffixes: tuple[str, ...], what: str, most: int) -> None:
    if path.suffix.lower() not in suffixes:
        known = ", ".join(suffixes)
        raise BodyError(f'{path} ends in "{path.suffix}"; {what} must be one of {known}')
    try:
        size = path.stat().st_size
        with path.open("rb"):
            pass
    except OSError as error:
        raise BodyError(f"the mesh {path} cannot be read: {error.strerror}") from error
    if size == 0:
        raise BodyError(f"the mesh {path} is empty")
    if size > most * _LEAST_BYTES + _CHUNK:
        raise BodyError(
            f"{path} has {size / 1e6:.0f} MB, more than a mesh of {most} elements needs; make it coarser, or raise "
            "the limit on elements"
        )


def _too_many(path: Path, count: int, what: str, option: str, most: int) -> BodyError:
    return BodyError(f"{path} has {count} {what} but the limit is {most}; make it coarser, or raise {option}")


@contextlib.contextmanager
def _reader(path: Path) -> Generator[None]:
    """Keeps a reader quiet and alive: whatever it raises, prints or exits with becomes one sentence."""
    said = io.StringIO()
    try:
        with (
            contextlib.redirect_stdout(said),
            contextlib.redirect_stderr(said),
            warnings.catch_warnings(),
            np.errstate(all="ignore"),
        ):
            warnings.simplefilter("ignore")
            yield
    except (SystemExit, MemoryError, Exception) as error:
        reason = " ".join(str(error).split())
        if isinstance(error, SystemExit) or not reason:
            reason = next((line.strip() for line in said.getvalue().splitlines() if line.strip()), type(error).__name__)
        raise BodyError(f"{path} cannot be read as {path.suffix[1:].upper()}: {reason[:160]}") from error


# Counting without loading.


def _count(path: Path) -> int | None:
    """How many elements a file says it holds, found without loading it; None where it does not say."""
    with contextlib.suppress(ValueError, IndexError), path.open("rb") as file:
        return _COUNTERS[path.suffix.lower()](file, path.stat().st_size)
    return None


def _stl(file: BinaryIO, size: int) -> int | None:
    head = file.read(84)
    if len(head) == 84:
        count = int.from_bytes(head[80:84], "little")
        if size == 84 + 50 * count:
            return count
    file.seek(0)
    return _occurrences(file, re.compile(rb"\bendfacet\b"))


def _ply(file: BinaryIO, size: int) -> int | None:
    del size
    return _number(file.read(_CHUNK), rb"element\s+face\s+(\d+)")


def _off(file: BinaryIO, size: int) -> int | None:
    del size
    lines = (line.split(b"#")[0].split() for line in file.read(4096).splitlines())
    words = [word for line in lines for word in line if word.upper() not in {b"OFF", b"COFF", b"NOFF"}]
    return int(words[1])


def _obj(file: BinaryIO, size: int) -> int | None:
    del size
    return _occurrences(file, re.compile(rb"(?:^|\n)[ \t]*f[ \t]"))


def _glb(file: BinaryIO, size: int) -> int | None:
    import json

    head = file.read(20)
    if head[:4] != b"glTF":
        return None
    length = int.from_bytes(head[12:16], "little")
    if length > size:
        return None
    tree = json.loads(file.read(length))
    total = 0
    for mesh in tree.get("meshes", []):
        for primitive in mesh.get("primitives", []):
            index = primitive.get("indices", primitive.get("attributes", {}).get("POSITION"))
            total += int(tree["accessors"][index]["count"]) // 3
    return total


def _vtk(file: BinaryIO, size: int) -> int | None:
    del size
    return _first(file, rb"\nCELL_TYPES\s+(\d+)")


def _vtu(file: BinaryIO, size: int) -> int | None:
    del size
    return _number(file.read(_CHUNK), rb"NumberOfCells\s*=\s*[\"'](\d+)")


def _msh(file: BinaryIO, size: int) -> int | None:
    del size
    # Version 2: the count alone; version 4: blocks, elements, lowest and highest tag.
    old = _first(file, rb"\$Elements\s*\n\s*(\d+)\s*\n")
    if old is not None:
        return old
    file.seek(0)
    new = _first(file, rb"\$Elements\s*\n\s*\d+[ \t]+(\d+)[ \t]+\d+[ \t]+\d+")
    if new is not None:
        return new
    file.seek(0)
    for piece, _ in _chunks(file):
        binary = re.search(rb"\$Elements\n.{8}(.{8}).{16}", piece, re.DOTALL)
        if binary:
            return int.from_bytes(binary.group(1), "little")
    return None


def _mesh(file: BinaryIO, size: int) -> int | None:
    del size
    return _first(file, rb"\bTetrahedra\s+(\d+)")


_COUNTERS: Final[dict[str, Callable[[BinaryIO, int], int | None]]] = {
    ".stl": _stl,
    ".ply": _ply,
    ".off": _off,
    ".obj": _obj,
    ".glb": _glb,
    ".vtk": _vtk,
    ".vtu": _vtu,
    ".msh": _msh,
    ".mesh": _mesh,
}


def _number(text: bytes, pattern: bytes) -> int | None:
    found = re.search(pattern, text)
    return int(found.group(1)) if found else None


def _chunks(file: BinaryIO) -> Generator[tuple[bytes, int]]:
    """The file in pieces that overlap, so that nothing is cut in two; and how much of each was in the last."""
    last = b""
    while piece := file.read(_CHUNK):
        yield last + piece, len(last)
        last = (last + piece)[-_OVERLAP:]


def _first(file: BinaryIO, pattern: bytes) -> int | None:
    for piece, _ in _chunks(file):
        found = _number(piece, pattern)
        if found is not None:
            return found
    return None


def _occurrences(file: BinaryIO, pattern: re.Pattern[bytes]) -> int | None:
    count = 0
    for piece, seen in _chunks(file):
        count += sum(1 for match in pattern.finditer(piece) if match.end() > seen)
    return count or None


def as_mesh(source: object, width: int, what: str) -> Mesh:
    """Points and elements that were given as arrays.

    Raises:
        BodyError: they are not.
    """
    try:
        points, elements = cast("tuple[Any, Any]", source)
        places = np.array(points, dtype=np.float64)
        given = np.asarray(elements)
        corners = np.array(given, dtype=np.int64)
    except (TypeError, ValueError, OverflowError) as error:
        raise BodyError(f"the source is neither a file nor (points, {what}) ({error}); give one of them") from error
    if places.ndim != 2 or places.shape[1] != 3:
        raise BodyError(f"the points are {' x '.join(map(str, places.shape))}; they must be P x 3")
    if corners.ndim != 2 or corners.shape[1] != width or corners.shape[0] == 0 or not np.array_equal(corners, given):
        extents = " x ".join(map(str, given.shape))
        raise BodyError(f"the {what} are {extents}; they must be at least one row of {width} whole numbers")
    return Mesh(points=places, elements=corners)


def check_indices(mesh: Mesh, source: str, what: str) -> None:
    """Refuses elements that name points which are not there, and points in use that are not finite.

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
