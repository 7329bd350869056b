"""What of a mesh is used: the part that was chosen, without what is broken in it."""

from typing import Final

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components

from cotouch.arrays import Array, Float, Long
from cotouch.body._cells import CORNERS, Cells, carriers, cells_of
from cotouch.body._cut_skin import FACES
from cotouch.body._repair import Shells
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

# A piece with less than this share of the volume is debris.
_DEBRIS: Final = 0.01
# A tetrahedron of less than this share of its longest edge cubed is flat (a regular one has 0.118).
_FLAT: Final = 1e-8
# Of volumes, beside the largest, by which parts are ordered.
_DIGITS: Final = 9


def grid_nodes(cells: Cells) -> tuple[Long, Float]:
    """Nodes of the eight corners of each cell, (E, 8), and the places of the nodes."""
    grid = cells.shape + 1
    keys = np.ravel_multi_index(tuple(np.moveaxis(cells.places[:, None] + CORNERS[None], -1, 0)), tuple(grid))
    used, corners = np.unique(keys, return_inverse=True)
    places = np.stack(np.unravel_index(used, tuple(grid)), axis=1)
    return corners.reshape(keys.shape).astype(np.int64), cells.origin + cells.spacing * places


def one_part(shells: Shells, resolution: int, part: int | None, name: str) -> tuple[Shells, Cells, list[str]]:
    """The shells that hang together, and their cells.

    Args:
        shells: closed surfaces.
        resolution: cells along the longest side.
        part: which one to take, from 1; None: there must be one only.
        name: what messages call it.

    Raises:
        BodyError: there are several parts and none was chosen, or not so many.
    """
    cells = cells_of(shells.vertices, shells.triangles, resolution)
    corners, rest = grid_nodes(cells)
    label = _together(corners, rest.shape[0])
    rows, _ = carriers(shells.vertices, shells.triangles, cells)
    first = shells.triangles[np.unique(shells.shell, return_index=True)[1], 0]
    of_shell = label[corners[rows[first], 0]]
    fractions = np.bincount(of_shell, weights=shells.volumes)
    if part is None and fractions.size == 1:
        return shells, cells, []
    ranked = _by_size(fractions)
    chosen = _choice(fractions[ranked] / fractions.sum(), part, name)
    if fractions.size == 1:
        return shells, cells, []
    kept = shells.only(np.flatnonzero(of_shell == ranked[chosen]))
    return kept, cells_of(kept.vertices, kept.triangles, resolution), [_left(fractions.size, chosen, part)]


def _by_size(fractions: Array) -> Long:
    """Largest first; what differs by no more than round-off keeps its order, so that all machines number alike."""
    return np.argsort(-(fractions / fractions.max()).round(_DIGITS), kind="stable")


def _choice(fractions: Float, part: int | None, name: str) -> int:
    """Which of the parts, ordered by size, to take."""
    if part is not None:
        if not 1 <= part <= fractions.size:
            raise BodyError(f"part is {part}; {name} has parts 1 to {fractions.size}")
        return part - 1
    if fractions[1:].sum() > _DEBRIS:
        shown = ", ".join(f"{100 * fraction:.3g} %" for fraction in fractions[:5]) + (
            ", ..." if fractions.size > 5 else ""
        )
        raise BodyError(
            f"{name} has {fractions.size} separate parts ({shown} of its volume) that are not connected; choose one "
            "with part, or join them"
        )
    return 0


def _left(parts: int, chosen: int, part: int | None) -> str:
    if part is None:
        return f"{parts - 1} loose part{'s' * (parts > 2)} left out, below 1 % of the volume."
    return f"Part {chosen + 1} of {parts} used."


def _together(elements: Long, nodes: int) -> Long:
    """Which connected piece each node is of."""
    rows = np.repeat(elements[:, 0], elements.shape[1] - 1)
    graph = sp.csr_array((np.ones(rows.size), (rows, elements[:, 1:].ravel())), shape=(nodes, nodes))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


def volumes_of(points: Float, elements: Long) -> Float:
    """Of tetrahedra, (E,); negative of those that are turned inside out [m³].

    Args:
        points: (n, 3) [m].
        elements: (E, 4) indices of points.
    """
    a, b, c, d = (points[elements[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6.0


def without_broken(points: Float, elements: Long, name: str, notes: list[str]) -> Long:
    """Without flat and repeated elements, and all turned the right way.

    Args:
        points: (n, 3) [m].
        elements: (E, 4) indices of points.
        name: what messages call it.
        notes: what was repaired; added to.
    """
    sides = np.stack([points[elements[:, i]] - points[elements[:, j]] for i in range(4) for j in range(i)])
    longest = np.linalg.norm(sides, axis=2).max(axis=0)
    volumes = volumes_of(points, elements)
    flat = np.abs(volumes) <= _FLAT * longest**3
    if flat.all():
        raise BodyError(f"no tetrahedron of {name} has a volume; it must be a mesh of a solid")
    if flat.any():
        count = int(flat.sum())
        notes.append(f"{count} degenerate tetrahedr{'a' if count != 1 else 'on'} left out.")
    inverted = (volumes < 0.0) & ~flat
    if inverted.any():
        count = int(inverted.sum())
        notes.append(f"{count} of {elements.shape[0]} tetrahedra were inverted and have been flipped.")
    elements = np.where(inverted[:, None], elements[:, [0, 2, 1, 3]], elements)[~flat]
    _, first = np.unique(np.sort(elements, axis=1), axis=0, return_index=True)
    if first.size < elements.shape[0]:
        notes.append(f"{elements.shape[0] - first.size} tetrahedra that repeated another left out.")
        elements = elements[np.sort(first)]
    return elements


def one_piece(points: Float, elements: Long, part: int | None, name: str, notes: list[str]) -> Long:
    """The elements that hang together.

    Args:
        points: (n, 3) [m].
        elements: (E, 4) indices of points.
        part: which one to take, from 1; None: there must be one only.
        name: what messages call it.
        notes: what was repaired; added to.

    Raises:
        BodyError: there are several parts and none was chosen, or not so many.
    """
    label = _together(elements, points.shape[0])[elements[:, 0]]
    found, label = np.unique(label, return_inverse=True)
    fractions = np.bincount(label.ravel(), weights=volumes_of(points, elements))
    ranked = _by_size(fractions)
    if found.size == 1 and part is None:
        return elements
    chosen = _choice(fractions[ranked] / fractions.sum(), part, name)
    if found.size == 1:
        return elements
    notes.append(_left(found.size, chosen, part))
    return elements[label.ravel() == ranked[chosen]]


def hinged(elements: Long) -> int:
    """How many groups of elements there are that no face joins to each other."""
    count = int(elements.shape[0])
    faces = np.sort(np.concatenate([np.delete(elements, corner, axis=1) for corner in range(4)]), axis=1)
    _, face = np.unique(faces, axis=0, return_inverse=True)
    owner = np.tile(np.arange(count), 4)
    ones = np.ones(owner.size)
    joined = sp.csr_array((ones, (owner, face.ravel())), shape=(count, int(face.max()) + 1))
    return int(connected_components(joined @ joined.T, directed=False)[0])


def boundary_of(rest: Float, elements: Long) -> Skin:
    """Faces that belong to one element only, seen from outside.

    Args:
        rest: (n, 3) places at rest [m].
        elements: (E, 4) indices of points.
    """
    faces = np.concatenate([elements[:, face] for face in FACES[4]])
    _, first, times = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    outer = faces[np.sort(first[times == 1])]
    used, places = np.unique(outer, return_inverse=True)
    return Skin(
        vertices=rest[used],
        triangles=places.reshape(outer.shape),
        nodes=used[:, None],
        weights=np.ones((used.size, 1)),
    )
