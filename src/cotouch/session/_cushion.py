"""A cushion by formula: the demonstration's body with a good grip for five, at its corners and in the middle."""

import struct
from itertools import combinations

import numpy as np

from cotouch.arrays import Float, Long

# Half its width and half its height [m].
HALF, THICK = 0.12, 0.05
# Each edge of an icosahedron in so many pieces: 10 n² + 2 vertices.
_PIECES = 14
# How square the outline is: 2 a circle, more a square.
_SQUARE = 3.5
# How far corners stick out, and how deep the middle lies, as shares.
_EARS, _DENT = 0.06, 0.35


def cushion() -> tuple[Float, Long]:
    """Vertices, (1962, 3) [m], and triangles, (3920, 3), counter-clockwise seen from outside."""
    ball, corners = _sphere(_PIECES)
    x, y, z = ball.T
    angle = np.arctan2(y, x)
    outline = (np.abs(np.cos(angle)) ** _SQUARE + np.abs(np.sin(angle)) ** _SQUARE) ** (-1.0 / _SQUARE)
    out = np.hypot(x, y)
    ears = 1.0 + _EARS * out**4 * (1.0 - np.cos(4.0 * angle)) / 2.0
    dent = 1.0 - _DENT * np.exp(-((out / 0.35) ** 2))
    points = np.stack([HALF * outline * ears * x, HALF * outline * ears * y, THICK * dent * z], axis=1)
    return points, corners


def stl(points: Float, corners: Long) -> bytes:
    """A surface as a binary STL file.

    Args:
        points: (n, 3) [m].
        corners: (m, 3) indices of points.
    """
    sides = points[corners]
    normal = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    record = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    record["normal"], record["corners"] = normal, sides
    return b"cotouch cushion".ljust(80) + struct.pack("<I", len(corners)) + record.tobytes()


def _sphere(pieces: int) -> tuple[Float, Long]:
    """A sphere of radius 1, evenly covered: an icosahedron with its faces divided and pushed out."""
    golden = 0.5 * (1.0 + np.sqrt(5.0))
    tips = np.array([p for s in (1, -1) for t in (golden, -golden) for p in ((0, s, t), (s, t, 0), (t, 0, s))], float)
    near = np.linalg.norm(tips[:, None] - tips[None], axis=-1) < 2.1
    faces = [f for f in combinations(range(12), 3) if all(near[a, b] for a, b in combinations(f, 2))]
    points: list[Float] = []
    corners: list[tuple[int, int, int]] = []
    for face in faces:
        a, b, c = tips[list(face)]
        if np.dot(np.cross(b - a, c - a), a) < 0.0:
            b, c = c, b
        at: dict[tuple[int, int], int] = {}
        for i in range(pieces + 1):
            for j in range(pieces + 1 - i):
                at[i, j] = len(points)
                points.append(a + (i * (b - a) + j * (c - a)) / pieces)
        for i in range(pieces):
            for j in range(pieces - i):
                corners.append((at[i, j], at[i + 1, j], at[i, j + 1]))
                if i + j < pieces - 1:
                    corners.append((at[i + 1, j], at[i + 1, j + 1], at[i, j + 1]))
    _, first, same = np.unique(np.round(points, 9), axis=0, return_index=True, return_inverse=True)
    whole = np.array(points)[first]
    return whole / np.linalg.norm(whole, axis=1, keepdims=True), same.ravel()[np.array(corners)]
