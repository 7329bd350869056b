"""What a mesh file says that it holds, summed up before any of it is loaded."""
# Every format is handed the size, and not each needs it.
# ruff: noqa: ARG001

import json
import re
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any, BinaryIO, Final, NamedTuple

from cotouch.errors import BodyError
from cotouch.meshfile._legacy import vtk_kind

_CHUNK: Final = 1 << 20
_OVERLAP: Final = 256
# Points for each element that may be: a quadratic tetrahedron has ten.
_POINTS_EACH: Final = 10
_VTK_KINDS: Final = (b"UNSTRUCTURED_GRID", b"POLYDATA")


class Promise(NamedTuple):
    """What is said; None where a file does not say it.

    Attributes:
        elements: how many.
        points: how many.
    """

    elements: int | None = None
    points: int | None = None


def check(path: Path, what: str, option: str, most: int) -> Promise:
    """Refuses a file that says it holds more than `most` elements, or more than its bytes can.

    Args:
        path: of the file.
        what: elements are called in messages.
        option: that raises the limit, for messages.
        most: elements that are taken.

    Returns:
        What it says.

    Raises:
        BodyError: it does.
    """
    said, size = promised(path), path.stat().st_size
    if said.elements is not None and said.elements > most:
        raise too_many(said.elements, what, option, most)
    if said.points is not None and said.points > _POINTS_EACH * most:
        raise BodyError(f"has {said.points} points, more than {most} {what} need; make it coarser, or raise {option}")
    # In XML a number may take less than a byte: packed, or said by a few words.
    numbers = 3 * (said.points or 0) + (said.elements or 0)
    packed = path.suffix.lower() == ".vtu" or (path.suffix.lower() == ".vtk" and vtk_kind(path) == "XML")
    if not packed and numbers > size:
        raise BodyError(
            f"cannot be read as {path.suffix[1:].upper()}: it claims {said.points or 0} points and "
            f"{said.elements or 0} {what}, but has only {size} bytes"
        )
    return said


def too_many(count: int, what: str, option: str, most: int) -> BodyError:
    """The refusal of a mesh that is too large.

    Args:
        count: how many there are.
        what: elements are called in messages.
        option: that raises the limit, for messages.
        most: how many are taken.
    """
    return BodyError(f"has {count} {what} but the limit is {most}; make it coarser, or raise {option}")


def promised(path: Path) -> Promise:
    """What a file says that it holds; what it says wrongly is left to the library to complain of.

    Raises:
        BodyError: it is of a kind that has no elements of its own.
    """
    try:
        with path.open("rb") as file:
            return _COUNTERS[path.suffix.lower()](file, path.stat().st_size)
    except BodyError:
        raise
    except (ValueError, LookupError, TypeError, AttributeError, OverflowError, RecursionError):
        return Promise()


def _stl(file: BinaryIO, size: int) -> Promise:
    head = file.read(84)
    if len(head) == 84:
        count = int.from_bytes(head[80:84], "little")
        if size == 84 + 50 * count:
            return Promise(count)
    file.seek(0)
    return Promise(_occurrences(file, re.compile(rb"\bendfacet\b")))


def _ply(file: BinaryIO, size: int) -> Promise:
    head = file.read(_CHUNK)
    return Promise(_sum(head, rb"element\s+face\s+(\d+)"), _sum(head, rb"element\s+vertex\s+(\d+)"))


def _off(file: BinaryIO, size: int) -> Promise:
    lines = (line.split(b"#")[0].split() for line in file.read(4096).splitlines())
    words = [word for line in lines for word in line if word.upper() not in {b"OFF", b"COFF", b"NOFF"}]
    return Promise(int(words[1]), int(words[0]))


def _obj(file: BinaryIO, size: int) -> Promise:
    return Promise(_occurrences(file, re.compile(rb"(?:^|\n)[ \t]*f[ \t]")))


def _glb(file: BinaryIO, size: int) -> Promise:
    head = file.read(20)
    if head[:4] != b"glTF":
        return Promise()
    length = int.from_bytes(head[12:16], "little")
    if length > size:
        return Promise()
    tree: Any = json.loads(file.read(length))
    uses: dict[int, int] = {}
    for node in tree.get("nodes", []):  # each puts a copy of its mesh somewhere
        if "mesh" in node:
            uses[node["mesh"]] = uses.get(node["mesh"], 0) + 1
    elements = points = 0
    for number, mesh in enumerate(tree.get("meshes", [])):
        for primitive in mesh.get("primitives", []):
            place = primitive.get("attributes", {}).get("POSITION")
            corners = 0 if place is None else int(tree["accessors"][place]["count"])
            indices = int(tree["accessors"][primitive["indices"]]["count"]) if "indices" in primitive else corners
            elements += max(uses.get(number, 0), 1) * (indices // 3)
            points += corners
    return Promise(elements, points)


def _vtk(file: BinaryIO, size: int) -> Promise:
    if file.read(_OVERLAP).lstrip().startswith(b"<"):
        file.seek(0)
        return _vtu(file, size)
    file.seek(0)
    cells, points = 0, 0
    for piece, seen in _chunks(file):
        kind = re.search(rb"(?:^|\n)DATASET\s+(\w+)", piece, re.IGNORECASE)
        if kind is not None and kind[1].upper() not in _VTK_KINDS:
            kind_name = kind[1].decode()[:40]
            raise BodyError(
                f"is a {kind_name}, which has neither tetrahedra nor triangles of its own; it must be an "
                "UNSTRUCTURED_GRID or POLYDATA"
            )
        cells += _sum(piece, rb"\n(?:CELL_TYPES|POLYGONS|TRIANGLE_STRIPS)\s+(\d+)\s", seen) or 0
        points += _sum(piece, rb"\nPOINTS\s+(\d+)\s", seen) or 0
    return Promise(cells or None, points or None)


def _said(elements: bytes, points: bytes) -> Callable[[BinaryIO, int], Promise]:
    """Counts of a format that says them behind these words, as often as it likes."""

    def sums(file: BinaryIO, size: int) -> Promise:
        found = [(_sum(piece, elements, seen), _sum(piece, points, seen)) for piece, seen in _chunks(file)]
        return Promise(*(sum(each or 0 for each in said) or None for said in zip(*found, strict=True)))

    return sums


_vtu = _said(
    rb"NumberOfCells\s*=\s*[\"']\s*(\d+)\s*[\"']",
    rb"NumberOfPoints\s*=\s*[\"']\s*(\d+)\s*[\"']",
)


def _msh(file: BinaryIO, size: int) -> Promise:
    """Version 2 says the count alone; version 4 blocks, count, lowest and highest tag, as text or as numbers."""
    found: dict[bytes, int] = {}
    for piece, _ in _chunks(file):
        for section in (b"Elements", b"Nodes"):
            start = rb"\$" + section + rb"[ \t\r]*\n[ \t]*"
            for pattern in (rb"(\d+)[ \t\r]*\n", rb"\d+[ \t]+(\d+)[ \t]+\d+[ \t]+\d+"):
                said = re.search(start + pattern, piece)
                if said is not None and section not in found:
                    found[section] = int(said[1])
            packed = re.search(rb"\$" + section + rb"\n.{8}(.{8}).{16}", piece, re.DOTALL)
            if packed is not None and section not in found:
                found[section] = int.from_bytes(packed[1], "little")
        for section, word in ((b"Elements", rb"\$ELM"), (b"Nodes", rb"\$NOD")):  # version 1
            said = re.search(word + rb"\s+(\d+)\s", piece)
            if said is not None and section not in found:
                found[section] = int(said[1])
    return Promise(found.get(b"Elements"), found.get(b"Nodes"))


_COUNTERS: Final[dict[str, Callable[[BinaryIO, int], Promise]]] = {
    ".stl": _stl,
    ".ply": _ply,
    ".off": _off,
    ".obj": _obj,
    ".glb": _glb,
    ".vtk": _vtk,
    ".vtu": _vtu,
    ".msh": _msh,
    ".mesh": _said(rb"\bTetrahedra\s+(\d+)\s", rb"\bVertices\s+(\d+)\s"),
}


def _sum(text: bytes, pattern: bytes, seen: int = 0) -> int | None:
    """Of the numbers behind a word; those that end within the first `seen` bytes were counted before."""
    found = [int(match[1]) for match in re.finditer(pattern, text) if match.end() > seen]
    return sum(found) if found else None


def _chunks(file: BinaryIO) -> Generator[tuple[bytes, int]]:
    """The file in pieces that overlap, so that nothing is cut in two; and how much of each was in the last."""
    last = b""
    while piece := file.read(_CHUNK):
        yield last + piece, len(last)
        last = (last + piece)[-_OVERLAP:]


def _occurrences(file: BinaryIO, pattern: re.Pattern[bytes]) -> int | None:
    count = 0
    for piece, seen in _chunks(file):
        count += sum(1 for match in pattern.finditer(piece) if match.end() > seen)
    return count or None
