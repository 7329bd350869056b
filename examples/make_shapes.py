"""Makes the example shapes by code, the same every time: `python examples/make_shapes.py [FOLDER]`.

liver.stl, kidney.stl and gear.stl are surfaces in millimetres; beam.vtu is a beam of tetrahedra in metres whose node
set "clamp" is one end.
"""

import sys
from collections.abc import Callable
from itertools import permutations
from pathlib import Path

import numpy as np
import numpy.typing as npt

Float = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Field = Callable[[Float], Float]


def liver(detail: int = 44) -> tuple[Float, Ints]:
    """A big right lobe, a thin left one, and a hollow below where a gall bladder would lie [mm]."""

    def field(p: Float) -> Float:
        right = _ellipsoid(p, (-38.0, 0.0, 0.0), (66.0, 52.0, 46.0))
        left = _ellipsoid(p, (48.0, 10.0, 14.0), (70.0, 36.0, 22.0))
        tail = _ellipsoid(p, (-62.0, -8.0, -34.0), (34.0, 34.0, 40.0))
        hollow = _ellipsoid(p, (8.0, -26.0, -34.0), (42.0, 40.0, 30.0))
        return -_blend(-_blend(_blend(right, left, 16.0), tail, 14.0), hollow, 10.0)

    return _surface(field, low=(-112.0, -62.0, -82.0), high=(126.0, 62.0, 58.0), cells=detail)


def kidney(detail: int = 32) -> tuple[Float, Ints]:
    """A bean: an ellipsoid with a dent at its middle [mm]."""

    def field(p: Float) -> Float:
        bent = p.copy()
        bent[..., 0] += 8.0 - 0.008 * p[..., 2] ** 2
        dent = _ellipsoid(p, (26.0, 0.0, 0.0), (16.0, 12.0, 17.0))
        return -_blend(-_ellipsoid(bent, (0.0, 0.0, 0.0), (26.0, 19.0, 54.0)), dent, 6.0)

    return _surface(field, low=(-40.0, -24.0, -60.0), high=(48.0, 24.0, 60.0), cells=detail)


def gear(teeth: int = 14, steps: int = 12) -> tuple[Float, Ints]:
    """A spur gear with a bore: two profiles with as many points, a ring between them, and walls [mm]."""
    count = teeth * steps
    angle = 2.0 * np.pi * np.arange(count) / count
    tooth = np.clip(1.9 * np.sin(teeth * angle), -1.0, 1.0)  # flanks between flats
    circles = [
        (34.0 + 4.5 * tooth, -6.0),
        (34.0 + 4.5 * tooth, 6.0),
        (11.0 + 0.0 * tooth, 6.0),
        (11.0 + 0.0 * tooth, -6.0),
    ]
    points = np.concatenate(
        [np.stack([r * np.cos(angle), r * np.sin(angle), np.full(count, z)], axis=1) for r, z in circles]
    )
    faces: list[list[int]] = []
    for ring in range(4):
        here, there = ring * count, (ring + 1) % 4 * count
        for i in range(count):
            j = (i + 1) % count
            faces += [[here + i, here + j, there + j], [here + i, there + j, there + i]]
    return points, np.array(faces)


def beam(
    cells: tuple[int, int, int] = (16, 4, 4), size: tuple[float, float, float] = (0.2, 0.04, 0.04)
) -> tuple[Float, Ints]:
    """A beam along x, each of its boxes cut into six tetrahedra [m]."""
    shape = np.array(cells) + 1
    places = np.array(list(np.ndindex(*shape)))
    points = places * (np.array(size) / np.array(cells))
    corner = np.array(list(np.ndindex(*cells)))
    elements = []
    for order in permutations(range(3)):  # the path from the lowest corner of a box to the highest
        path = np.zeros((4, 3), dtype=np.int64)
        for step, axis in enumerate(order, start=1):
            path[step] = path[step - 1] + np.eye(3, dtype=np.int64)[axis]
        if np.linalg.det(path[1:]) < 0:
            path[[1, 2]] = path[[2, 1]]
        elements.append(np.ravel_multi_index(tuple(np.moveaxis(corner[:, None] + path[None], -1, 0)), tuple(shape)))
    return points, np.concatenate(elements)


def _ellipsoid(p: Float, centre: tuple[float, ...], radii: tuple[float, ...]) -> Float:
    """Below 0 inside; about the distance in mm."""
    scaled = (p - np.array(centre)) / np.array(radii)
    return (np.linalg.norm(scaled, axis=-1) - 1.0) * min(radii)


def _blend(a: Float, b: Float, width: float) -> Float:
    """The lower of two fields, rounded where they meet."""
    fraction = np.clip(0.5 + 0.5 * (b - a) / width, 0.0, 1.0)
    return b + (a - b) * fraction - width * fraction * (1.0 - fraction)


def _surface(field: Field, *, low: tuple[float, ...], high: tuple[float, ...], cells: int) -> tuple[Float, Ints]:
    """The zero surface of a field by surface nets: a vertex in every cell it crosses, a quad for every edge."""
    origin, extent = np.array(low), np.array(high) - np.array(low)
    pitch = float(extent.max()) / cells
    shape = np.ceil(extent / pitch).astype(np.int64) + 1
    values = field(origin + pitch * np.stack(np.meshgrid(*[np.arange(n) for n in shape], indexing="ij"), axis=-1))
    inside = values < 0.0
    sums, hits = np.zeros((*(shape - 1), 3)), np.zeros(shape - 1)
    quads: list[Ints] = []
    for axis in range(3):
        one = [slice(None)] * 3
        two = [slice(None)] * 3
        one[axis], two[axis] = slice(None, -1), slice(1, None)
        start, end = inside[tuple(one)], inside[tuple(two)]
        edges = np.argwhere(start != end)
        fraction = values[tuple(one)][tuple(edges.T)] / (
            values[tuple(one)][tuple(edges.T)] - values[tuple(two)][tuple(edges.T)]
        )
        place = edges.astype(np.float64)
        place[:, axis] += fraction
        b, c = (axis + 1) % 3, (axis + 2) % 3
        around = []
        for db, dc in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
            cell = edges.copy()
            cell[:, b] += db
            cell[:, c] += dc
            np.add.at(sums, tuple(cell.T), place)
            np.add.at(hits, tuple(cell.T), 1.0)
            around.append(np.ravel_multi_index(tuple(cell.T), tuple(shape - 1)))
        quad = np.stack(around, axis=1)
        leaves = start[tuple(edges.T)]
        quads.append(np.where(leaves[:, None], quad, quad[:, ::-1]))
    corners = np.concatenate(quads)
    used, places = np.unique(corners, return_inverse=True)
    corners = places.reshape(corners.shape)
    points = origin + pitch * (sums.reshape(-1, 3)[used] / hits.ravel()[used][:, None])
    for _ in range(4):  # onto the surface itself, by Newton's method along the gradient
        slope = np.stack([(field(points + h) - field(points - h)) / 2e-3 for h in 1e-3 * np.eye(3)], axis=1)
        points -= (field(points) / np.maximum((slope**2).sum(axis=1), 1e-2))[:, None] * slope
    return points, np.concatenate([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]])


def main(folder: Path) -> None:
    """Writes all shapes."""
    import meshio
    import trimesh

    folder.mkdir(parents=True, exist_ok=True)
    for name, (points, faces) in {"liver": liver(), "kidney": kidney(), "gear": gear()}.items():
        trimesh.Trimesh(points, faces, process=False).export(folder / f"{name}.stl")
        print(f"{folder / name}.stl: {len(faces)} triangles, millimetres")
    points, elements = beam()
    clamp = (points[:, 0] == 0.0).astype(np.int32)
    meshio.Mesh(points, [("tetra", elements)], point_data={"clamp": clamp}).write(folder / "beam.vtu")
    print(f"{folder / 'beam'}.vtu: {len(elements)} tetrahedra, metres, node set clamp")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent / "shapes")
