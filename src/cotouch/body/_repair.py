"""Making a triangle soup one closed surface that is turned outwards, and saying what was done."""

from dataclasses import dataclass, replace
from typing import Final, final

import numpy as np
import scipy.sparse as sp
from scipy.sparse.csgraph import breadth_first_order, connected_components

from cotouch.arrays import Bool, Float, Long
from cotouch.body._reading import check_indices
from cotouch.errors import BodyError
from cotouch.meshfile import Mesh

# Points this near to each other, beside the size of the whole, are one: single precision in files keeps 1e-7.
_SAME: Final = 1e-6
# Filling holes may add this share to the surface; beyond, it is a sheet rather than a body with holes.
_HOLES: Final = 0.25
# A closed shell of less than this share of the largest one's volume is debris.
_DEBRIS: Final = 1e-3
# A solid fills at least this share of its bounding box's diagonal cubed.
_EMPTY: Final = 1e-9
# Shells are tested for lying inside each other one by one.
_MOST_SHELLS: Final = 200


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Shells:
    """Closed surfaces, turned outwards, cavities inwards.

    Attributes:
        vertices: (V, 3).
        triangles: (F, 3).
        shell: which shell each triangle is of, (F,).
        volumes: signed, of each shell; negative for cavities.
        notes: what was repaired.
    """

    vertices: Float
    triangles: Long
    shell: Long
    volumes: Float
    notes: tuple[str, ...]

    @property
    def volume(self) -> float:
        """As if shells did not overlap; `cotouch.body._lines.doubled` says what is then too much."""
        return float(self.volumes.sum())

    def only(self, shells: Long) -> "Shells":
        """Some of the shells."""
        kept = np.isin(self.shell, shells)
        vertices, triangles = _compact(self.vertices, self.triangles[kept])
        return Shells(
            vertices=vertices,
            triangles=triangles,
            shell=np.searchsorted(np.sort(shells), self.shell[kept]),
            volumes=self.volumes[np.sort(shells)],
            notes=self.notes,
        )


def repaired(mesh: Mesh, source: str) -> Shells:
    """Merges points, drops degenerate triangles and debris, turns faces round, and fills holes.

    Args:
        mesh: points and elements.
        source: what messages call the file.

    Raises:
        BodyError: the surface has one side only, is open beyond repair, encloses nothing, or is no surface at all.
    """
    check_indices(mesh, source, "triangles")
    notes = list(mesh.notes)
    vertices, triangles = _compact(mesh.points, mesh.elements)
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    if size == 0.0:
        raise BodyError(f"all points of {source} are the same; it must be a surface around a volume")
    vertices, triangles = _merged(vertices, triangles, size)
    triangles = _without_degenerate(triangles, notes)
    area = 0.5 * float(np.linalg.norm(_crosses(vertices, triangles), axis=1).sum())
    if area <= _EMPTY * size**2:
        raise BodyError(f"no triangle of {source} has an area; it must be a surface around a volume")
    turned, shell = _turned(triangles, source)
    original = triangles.shape[0]
    triangles = np.where(turned[:, None], triangles[:, ::-1], triangles)
    vertices, caps, cap_shell, holes = _caps(vertices, triangles, shell)
    if holes:
        added = 0.5 * float(np.linalg.norm(_crosses(vertices, caps), axis=1).sum())
        if added > _HOLES * area:
            raise BodyError(
                f"{source} is open: closing it would add {100 * added / area:.0f} % to its surface; it must enclose a "
                "volume, so close it first"
            )
        triangles, shell = np.concatenate([triangles, caps]), np.concatenate([shell, cap_shell])
        notes.append(f"{_many(holes, 'hole')} filled, {100 * added / area:.2g} % of the surface.")
    volumes = _volumes(vertices, triangles, shell)
    if np.abs(volumes).max() <= _EMPTY * size**3:
        raise BodyError(f"{source} encloses no volume; it must be a surface around one")
    # The biggest shell is outside of something. What it was, inside or outside, the others were alike.
    sign = np.where(volumes[np.argmax(np.abs(volumes))] < 0.0, -1.0, 1.0) * np.ones(volumes.size)
    small = np.abs(volumes) < _DEBRIS * np.abs(volumes).max()
    inner = np.flatnonzero((sign * volumes < 0.0) & ~small)
    for k in inner if inner.size < _MOST_SHELLS else inner[:0]:
        if not _inside(vertices, triangles, shell, sign * volumes, int(k)):
            sign[k] = -sign[k]  # a part that is inside out, rather than a cavity
    back = (sign < 0.0)[shell]
    triangles = np.where(back[:, None], triangles[:, ::-1], triangles)
    changed = int(np.count_nonzero(turned ^ back[:original]))
    if changed == original:
        notes.append("The surface was inside out and has been flipped.")
    elif changed:
        notes.append(f"{_many(changed, 'triangle')} of {original} flipped, so that all face outwards.")
    made = Shells(vertices=vertices, triangles=triangles, shell=shell, volumes=sign * volumes, notes=())
    if small.any():
        notes.append(f"{_many(int(small.sum()), 'speck')} left out, each below 0.1 % of the largest part.")
        made = made.only(np.flatnonzero(~small))
    cavities = int(np.count_nonzero(made.volumes < 0.0))
    if cavities:
        notes.append("1 cavity kept hollow." if cavities == 1 else f"{cavities} cavities kept hollow.")
    return replace(made, notes=tuple(notes))


def _compact(vertices: Float, triangles: Long) -> tuple[Float, Long]:
    """Without the points that no triangle uses."""
    used, places = np.unique(triangles, return_inverse=True)
    return vertices[used], places.reshape(triangles.shape)


def _merged(vertices: Float, triangles: Long, size: float) -> tuple[Float, Long]:
    """One point where several are in the same place (STL gives every triangle its own)."""
    from scipy.spatial import cKDTree

    # Those that share a small cell first: what is left has few neighbours each, however crowded the file is.
    cells = np.floor((vertices - vertices.min(axis=0)) / (0.5 * _SAME * size)).astype(np.int64)
    _, kept, places = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    distinct = vertices[kept]
    pairs = np.asarray(cKDTree(distinct).query_pairs(_SAME * size, output_type="ndarray"))
    count = distinct.shape[0]
    graph = sp.csr_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    _, group = connected_components(graph, directed=False)
    _, first, back = np.unique(group, return_index=True, return_inverse=True)
    return distinct[first], back[places.ravel()][triangles]


def _without_degenerate(triangles: Long, notes: list[str]) -> Long:
    a, b, c = triangles.T
    good = (a != b) & (b != c) & (c != a)
    if not good.all():
        notes.append(f"{_many(int((~good).sum()), 'degenerate triangle')} left out.")
    triangles = triangles[good]
    _, first = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True)
    if first.size < triangles.shape[0]:
        notes.append(f"{_many(triangles.shape[0] - first.size, 'triangle')} that repeated another left out.")
        triangles = triangles[np.sort(first)]
    return triangles


def _crosses(vertices: Float, triangles: Long) -> Float:
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def _volumes(vertices: Float, triangles: Long, shell: Long) -> Float:
    """Signed volume of each shell, by the divergence theorem."""
    centred = vertices - vertices.mean(axis=0)
    a, b, c = (centred[triangles[:, k]] for k in range(3))
    signed = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
    return np.bincount(shell, weights=signed).astype(np.float64)


def _turned(triangles: Long, source: str) -> tuple[Bool, Long]:
    """Which triangles to turn so that neighbours agree, and which shell each is of.

    Raises:
        BodyError: no choice makes all neighbours agree, as on a Möbius band.
    """
    count = int(triangles.shape[0])
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    owner = np.repeat(np.arange(count), 3)
    key = np.minimum(starts, ends) * (int(triangles.max()) + 1) + np.maximum(starts, ends)
    order = np.argsort(key, kind="stable")
    _, first, times = np.unique(key[order], return_index=True, return_counts=True)
    pairs = first[times == 2]  # three or more at an edge belong to several sheets; they say nothing here
    one, two = order[pairs], order[pairs + 1]
    f, g = owner[one], owner[two]
    opposed = (starts[one] == starts[two]).astype(np.int64)
    whole = sp.csr_array((np.ones(f.size), (f, g)), shape=(count, count))
    _, shell = connected_components(whole, directed=False)
    # A spanning tree from one triangle of each shell; a node that is no triangle joins them.
    _, roots = np.unique(shell, return_index=True)
    rows = np.concatenate([f, np.full(roots.size, count)])
    columns = np.concatenate([g, roots])
    tree = sp.csr_array((np.ones(rows.size), (rows, columns)), shape=(count + 1, count + 1))
    visit, parent = breadth_first_order(tree, count, directed=False)
    marks = sp.csr_array((np.concatenate([opposed, opposed]) + 1.0, (np.r_[f, g], np.r_[g, f])), shape=(count, count))
    child = visit[1:]
    above = parent[child]
    step = np.zeros(child.size, dtype=np.int64)
    joined = above < count
    if joined.any():  # two triangles share one edge at most, since none repeats another
        step[joined] = np.asarray(marks[child[joined], above[joined]]).ravel() > 1.5
    parity = [0] * (count + 1)
    for node, up, flip in zip(child.tolist(), above.tolist(), step.tolist(), strict=True):
        parity[node] = parity[up] ^ flip
    turned = np.array(parity[:count], dtype=np.int64)
    wrong = int(np.count_nonzero((turned[f] ^ turned[g]) != opposed))
    if wrong:
        raise BodyError(
            f"{source} has only one side, like a Möbius band ({_many(wrong, 'edge')} cannot be made to agree); it must "
            "have an inside and an outside"
        )
    return turned.astype(np.bool_), shell.astype(np.int64)


def _caps(vertices: Float, triangles: Long, shell: Long) -> tuple[Float, Long, Long, int]:
    """Triangles that close every shell: cones over its boundary, each from the middle of its hole.

    The boundary of a chain of triangles is a cycle, whatever its form, so a cone over it closes the chain exactly.
    """
    base = int(triangles.max()) + 1
    starts, ends = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    of = np.repeat(shell, 3)
    net_key, places = np.unique((of * base + low) * base + high, return_inverse=True)
    net = np.bincount(places.ravel(), weights=np.where(starts < ends, 1.0, -1.0))
    open_ = np.flatnonzero(np.abs(net) > 0.5)
    if open_.size == 0:
        return vertices, np.zeros((0, 3), np.int64), np.zeros(0, np.int64), 0
    times = np.abs(net[open_]).astype(np.int64)
    key, forward = np.repeat(net_key[open_], times), np.repeat(net[open_] > 0.0, times)
    a, b, owner = (key // base) % base, key % base, key // base**2
    a, b = np.where(forward, a, b), np.where(forward, b, a)
    # A hole is what hangs together of one shell's boundary.
    corners, numbers = np.unique(np.concatenate([owner * base + a, owner * base + b]), return_inverse=True)
    one, two = numbers.ravel()[: a.size], numbers.ravel()[a.size :]
    graph = sp.csr_array((np.ones(a.size), (one, two)), shape=(corners.size, corners.size))
    holes, label = connected_components(graph, directed=False)
    hole = label[one]
    sizes = np.bincount(hole)
    middle = np.stack([np.bincount(hole, weights=vertices[a, axis]) / sizes for axis in range(3)], axis=1)
    caps = np.stack([b, a, vertices.shape[0] + hole], axis=1)
    return np.concatenate([vertices, middle]), caps, owner, int(holes)


def _inside(vertices: Float, triangles: Long, shell: Long, volumes: Float, which: int) -> bool:
    """Whether a shell lies inside the solid of the positive shells, by the winding number of one of its corners."""
    point = vertices[triangles[np.argmax(shell == which)][0]]
    others = triangles[(volumes > 0.0)[shell] & (shell != which)]
    return abs(winding(vertices[others] - point)) > 0.5


def winding(corners: Float) -> float:
    """How often triangles go around the origin: 1 inside a closed surface, 0 outside [van Oosterom & Strackee 1983].

    Args:
        corners: of the triangles, (F, 3, 3).
    """
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    la, lb, lc = (np.linalg.norm(side, axis=1) for side in (a, b, c))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    rest = la * lb * lc + np.einsum("ij,ij->i", a, b) * lc
    rest += np.einsum("ij,ij->i", b, c) * la + np.einsum("ij,ij->i", c, a) * lb
    return float(np.arctan2(volume, rest).sum() / (2.0 * np.pi))


def _many(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"
