"""A mesh on its way from the reader's process: a line of JSON that says what follows, then plain numbers."""

import json
from typing import Any, BinaryIO, Final

import numpy as np

from cotouch.arrays import Array
from cotouch.meshfile._mesh import Mesh

_MOST_HEAD: Final = 4 << 20
_MOST_WORDS: Final = 400


def send(out: BinaryIO, mesh: Mesh | str) -> None:
    """Writes a mesh, or why there is none.

    Args:
        out: where it goes.
        mesh: the mesh, or the sentence that says why there is none.
    """
    if isinstance(mesh, str):
        out.write(json.dumps({"refused": mesh[:_MOST_WORDS]}).encode() + b"\n")
        return
    members = list(mesh.sets.values())
    head = {
        "points": mesh.points.shape[0],
        "elements": list(mesh.elements.shape),
        "sets": [[name, int(chosen.size)] for name, chosen in mesh.sets.items()],
        "notes": mesh.notes,
    }
    out.write(json.dumps(head).encode() + b"\n")
    arrays = ((mesh.points, "<f8"), (mesh.elements, "<i8"), *((chosen, "<i8") for chosen in members))
    out.writelines(np.ascontiguousarray(array, dtype=kind).tobytes() for array, kind in arrays)


def receive(stream: BinaryIO, width: int, most: int) -> Mesh | str:
    """Reads what `send` wrote, believing none of it.

    Args:
        stream: to its end.
        width: corners of an element.
        most: bytes that a mesh may have in all.

    Raises:
        ValueError: it is cut off, too large, or none.
    """
    line = stream.readline(_MOST_HEAD)
    try:
        head: Any = json.loads(line)
        if "refused" in head:
            return " ".join(str(head["refused"])[:_MOST_WORDS].split())
        points, (count, corners) = int(head["points"]), map(int, head["elements"])
        sets = [(str(name), int(size)) for name, size in head["sets"]]
        notes = tuple(map(str, head["notes"]))
    except (ValueError, KeyError, TypeError, OverflowError, RecursionError) as error:
        raise ValueError("it is no answer") from error
    sizes = [points, count, *(size for _, size in sets)]
    if corners != width or min(sizes) < 0 or 8 * (3 * points + width * count + sum(sizes[2:])) > most:
        raise ValueError("it is no answer")
    places = _array(stream, (points, 3), "<f8")
    elements = _array(stream, (count, width), "<i8")
    named = {name: _array(stream, (size,), "<i8") for name, size in sets}
    if any(chosen.size and not 0 <= int(chosen.min()) <= int(chosen.max()) < points for chosen in named.values()):
        raise ValueError("it is no answer")
    return Mesh(points=places, elements=elements, sets=named, notes=notes)


def _array(stream: Any, shape: tuple[int, ...], kind: str) -> Array:
    array = np.empty(shape, dtype=kind)
    if array.size and stream.readinto(array.data.cast("B")) != array.nbytes:
        raise ValueError("it is no answer")
    return array
