"""Meshes with known volumes and forms."""

import numpy as np

BOX = np.array(
    [
        [int(corner) for corner in face]
        for face in ["013", "032", "467", "475", "045", "051", "237", "276", "026", "064", "157", "173"]
    ]
)


def box(size=(1.0, 1.0, 1.0), at=(0.0, 0.0, 0.0)):
    """Eight corners, twelve triangles, turned outwards."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    return corners * np.array(size) + np.array(at), BOX.copy()


def joined(*meshes):
    """Several meshes as one."""
    points, triangles, first = [], [], 0
    for vertices, faces in meshes:
        points.append(vertices)
        triangles.append(faces + first)
        first += len(vertices)
    return np.concatenate(points), np.concatenate(triangles)


def sphere(rounds: int = 3):
    """An octahedron divided `rounds` times; its exact volume comes from the triangles."""
    points = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=float)
    faces = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    for _ in range(rounds):
        a, b, c = (points[faces[:, k]] for k in range(3))
        soup = np.concatenate(
            [
                np.stack(t, axis=1)
                for t in ((a, a + b, a + c), (a + b, b, b + c), (a + c, b + c, c), (a + b, b + c, c + a))
            ]
        )
        soup /= np.linalg.norm(soup, axis=2, keepdims=True)
        points, places = np.unique(soup.reshape(-1, 3).round(12), axis=0, return_inverse=True)
        faces = places.reshape(-1, 3)
    return points, faces


def volume(points, faces) -> float:
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0


def rotation(seed: int) -> np.ndarray:
    turn, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return turn * np.sign(np.linalg.det(turn))


def block(cells=(6, 2, 2), size=(0.3, 0.1, 0.1), shake: float = 0.0, seed: int = 0):
    """A block of tetrahedra; `shake` moves the nodes inside it by a share of a cell."""
    from examples.make_shapes import beam

    points, elements = beam(cells, size)
    pitch = np.array(size) / np.array(cells)
    inside = np.all((points > 1e-9) & (points < np.array(size) - 1e-9), axis=1)
    points[inside] += shake * pitch * np.random.default_rng(seed).uniform(-0.5, 0.5, size=(int(inside.sum()), 3))
    return points, elements
