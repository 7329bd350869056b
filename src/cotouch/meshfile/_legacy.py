"""Formats, and corners of formats, that the libraries do not read: Gmsh 1, and surfaces in VTK's legacy files."""

import re
from pathlib import Path
from typing import BinaryIO, Final

import numpy as np

from cotouch.arrays import Long
from cotouch.meshfile._mesh import Float, Mesh

_HEAD: Final = 4096
_VTK_TYPES: Final = {
    "char": "i1",
    "unsigned_char": "u1",
    "short": ">i2",
    "unsigned_short": ">u2",
    "int": ">i4",
    "unsigned_int": ">u4",
    "long": ">i8",
    "unsigned_long": ">u8",
    "vtktypeint64": ">i8",
    "float": ">f4",
    "double": ">f8",
}
# Corners of Gmsh's elements of types 1 to 4: line, triangle, quadrangle, tetrahedron.
_TETRAHEDRON: Final = 4


def vtk_kind(path: Path) -> str:
    """What a `.vtk` file holds: "XML", a dataset of a legacy file such as "POLYDATA", or ""."""
    with path.open("rb") as file:
        head = file.read(_HEAD)
    if head.lstrip().startswith((b"<?xml", b"<VTKFile")):
        return "XML"
    found = re.search(rb"(?:^|\n)DATASET\s+(\w+)", head, re.IGNORECASE)
    return "" if found is None else found[1].decode().upper()


def is_gmsh_1(path: Path) -> bool:
    """Whether a `.msh` file is of version 1, which begins with its nodes."""
    with path.open("rb") as file:
        return file.read(_HEAD).lstrip().startswith(b"$NOD")


def gmsh_1(path: Path) -> Mesh:
    """Tetrahedra of a Gmsh file of version 1, with its physical groups as sets.

    Raises:
        ValueError: it is not as the format asks for.
    """
    text = path.read_bytes()
    nodes = _section(text, b"NOD", b"ENDNOD")
    if (len(nodes) - 1) % 4 or len(nodes) != 1 + 4 * int(nodes[0]):
        raise ValueError(f"it claims {int(nodes[0])} nodes but has only {(len(nodes) - 1) // 4}")
    table = np.array(nodes[1:], dtype=np.float64).reshape(-1, 4)
    numbers = table[:, 0].astype(np.int64)
    order = np.argsort(numbers)
    words = np.array(_section(text, b"ELM", b"ENDELM"), dtype=np.int64)
    elements: list[Long] = []
    groups: dict[int, list[Long]] = {}
    at = 1
    for _ in range(int(words[0])):
        if at + 5 > words.size or words[at + 4] < 1 or at + 5 + words[at + 4] > words.size:
            raise ValueError(f"it claims {int(words[0])} elements but ends earlier")
        corners = words[at + 5 : at + 5 + words[at + 4]]
        if words[at + 1] == _TETRAHEDRON:
            elements.append(corners)
        groups.setdefault(int(words[at + 2]), []).append(corners)
        at += 5 + int(words[at + 4])
    places = {
        f"ref {group}": np.unique(_places(numbers, order, np.concatenate(members)))
        for group, members in groups.items()
        if group > 0
    }
    tetrahedra = _places(numbers, order, np.array(elements, dtype=np.int64).reshape(-1, _TETRAHEDRON))
    return Mesh(points=table[:, 1:].copy(), elements=tetrahedra, sets=places)


def _section(text: bytes, begin: bytes, end: bytes) -> list[bytes]:
    found = re.search(rb"\$" + begin + rb"\s(.*?)\$" + end, text, re.DOTALL)
    words = [] if found is None else found[1].split()
    if not words:
        raise ValueError(f"it has no complete section ${begin.decode()}")
    return words


def _places(numbers: Long, order: Long, wanted: Long) -> Long:
    """Where in the table the nodes of these numbers are."""
    at = np.searchsorted(numbers, wanted, sorter=order)
    places = order[np.minimum(at, order.size - 1)]
    if (numbers[places] != wanted).any():
        raise ValueError("an element refers to a node that does not exist")
    return places


def polydata(path: Path) -> Mesh:
    """Triangles of a surface in a legacy VTK file, as text or packed; polygons become fans.

    Raises:
        ValueError: it is not as the format asks for.
    """
    with path.open("rb") as file:
        lines = [file.readline() for _ in range(3)]
        packed = lines[2].strip().upper() == b"BINARY"
        points = np.zeros((0, 3))
        triangles: list[Long] = []
        while line := file.readline():
            words = line.decode("latin-1").split()
            section = words[0].upper() if words else ""
            if section in {"POINT_DATA", "CELL_DATA"}:  # the shape is complete
                break
            if section == "POINTS":
                points = _numbers(file, packed, words[2], 3 * int(words[1])).astype(np.float64).reshape(-1, 3)
            elif section in {"VERTICES", "LINES"}:
                _lists(file, packed, words)
            elif section == "POLYGONS":
                triangles += [_fan(corners) for corners in _lists(file, packed, words)]
            elif section == "TRIANGLE_STRIPS":
                triangles += [strip(corners) for corners in _lists(file, packed, words)]
    found = np.concatenate(triangles) if triangles else np.zeros((0, 3), dtype=np.int64)
    if found.size and (found.min() < 0 or found.max() >= len(points)):
        raise ValueError("a triangle refers to a point that does not exist")
    return Mesh(points=points, elements=found)


def _lists(file: BinaryIO, packed: bool, words: list[str]) -> list[Long]:
    """Indices of each cell: as count and members in turn, or since version 5 as offsets and members."""
    count, size = int(words[1]), int(words[2])
    before = file.tell()
    head = file.readline().decode("latin-1").split()
    if not head or head[0].upper() != "OFFSETS":
        file.seek(before)
        values = _numbers(file, packed, "int", size).astype(np.int64)
        cells: list[Long] = []
        at = 0
        for _ in range(count):
            if at >= size or not 0 <= values[at] < size - at:
                raise ValueError(f"its {words[0]} end too early")
            cells.append(values[at + 1 : at + 1 + values[at]])
            at += 1 + int(values[at])
        return cells
    offsets = _numbers(file, packed, head[1], count).astype(np.int64)
    _rest_of_line(file)
    head = file.readline().decode("latin-1").split()
    members = _numbers(file, packed, head[1], size).astype(np.int64)
    if (np.diff(offsets) < 0).any() or offsets[0] != 0 or offsets[-1] != size:
        raise ValueError(f"its {words[0]} are not in order")
    return np.split(members, offsets[1:-1])


def _rest_of_line(file: BinaryIO) -> None:
    """Packed numbers are followed by a line feed, numbers as text were read with theirs."""
    before = file.tell()
    if file.read(1) != b"\n":
        file.seek(before)


def _numbers(file: BinaryIO, packed: bool, kind: str, count: int) -> Float | Long:
    form = np.dtype(_VTK_TYPES[kind.lower()])
    if packed:
        found = np.frombuffer(file.read(count * form.itemsize), dtype=form)
    else:
        found = np.array(_words(file, count), dtype=np.float64)
    if found.size != count:
        raise ValueError(f"it ends after {found.size} of {count} numbers")
    return found


def _words(file: BinaryIO, count: int) -> list[bytes]:
    """As many words as asked for, of whole lines."""
    words: list[bytes] = []
    while len(words) < count and (line := file.readline()):
        words += line.split()
    return words


def _fan(corners: Long) -> Long:
    """Triangles of a polygon, (n - 2, 3)."""
    first = np.broadcast_to(corners[:1], max(len(corners) - 2, 0))
    return np.column_stack([first, corners[1:-1], corners[2:]])


def strip(corners: Long) -> Long:
    """Triangles of a strip, (n - 2, 3): every other one is turned, so that all look to the same side."""
    found = np.column_stack([corners[:-2], corners[1:-1], corners[2:]])
    found[1::2, :2] = found[1::2, 1::-1]
    return found
