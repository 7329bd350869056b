"""What a ball does on a skin that stands still; for tests and figures."""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import Any

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.kernels import FOUR, block, splat
from cotouch.mechanics._contact._patch import FOUND, overlap_one, press_triangle
from cotouch.mechanics._contact._snap import draw_triangle
from cotouch.mechanics._model._relief import Relief, bare, press_relief


def press_skin(
    law: Any,
    place: Float,
    corner: Int,
    middle: Float,
    *,
    stiffness: float,
    radius: float,
    area: Float | None = None,
    relief: Relief | None = None,
    snap: tuple[float, float] = (0.0, 0.0),
) -> tuple[float, Float]:
    """What a ball does on a skin that stands still.

    Args:
        law: of the contact, one of `CONTACT_LAWS`.
        place: of the vertices, (V, 3) [m].
        corner: vertices of each triangle, (F, 3).
        middle: of the ball, (3,) [m].
        stiffness: of the tool [N/m].
        radius: of the ball [m].
        area: of each triangle at rest, (F,) [m²]; by default as it is now.
        relief: on the skin; by default none.
        snap: pull-off force [N], 0 for none, and range [m].

    Returns:
        The energy [J], and the force on each vertex, (V, 3) [N].
    """
    padded, force = np.zeros((place.shape[0], 4)), np.zeros((place.shape[0], 4))
    padded[:, :3] = place
    faces = np.ascontiguousarray(corner, dtype=np.int32)
    if area is None:
        a, b, c = (padded[faces[:, q], :3] for q in range(3))
        area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    spot, met, out, drawn = np.zeros((4, 4)), np.zeros((FOUND, 4)), np.zeros((4, 4)), np.zeros((4, 4))
    spot[3, :3] = middle
    own = np.ascontiguousarray(area, dtype=np.float64)
    on, (pull_off, width) = relief or bare(), snap
    energy = _press_all(
        *(law, float(stiffness), float(radius), padded, faces, own, on),
        *(float(pull_off), float(width), spot, met, out, drawn, force),
    )
    return energy, force[:, :3]


@block
def _press_all(
    law: Any,
    stiffness: float,
    radius: float,
    place: Float,
    corner: Int,
    area: Float,
    relief: Relief,
    pull_off: float,
    width: float,
    spot: Float,
    met: Float,
    out: Float,
    drawn: Float,
    force: Float,
) -> float:
    energy = 0.0
    for f in range(corner.shape[0]):
        for q in range(3):
            for a in range(3):
                spot[q, a] = place[corner[f, q], a]
        for q in range(4):
            for a in range(4):
                out[q, a] = drawn[q, a] = 0.0
        if overlap_one(spot, splat(radius * radius, FOUR), met):
            press_triangle(law, stiffness, radius, area[f], False, True, met, 0, drawn)
            press_triangle(law, stiffness, radius, area[f], True, False, met, 0, out)
        out[3, 3] = drawn[3, 3]
        if relief.top > 0.0:
            press_relief(law, stiffness, radius, area[f], True, relief, f, spot, out)
        energy += out[3, 3]
        for q in range(3):
            for a in range(3):
                force[corner[f, q], a] += out[q, a]
        if pull_off > 0.0:
            draw_triangle(pull_off, radius, width, area[f], True, spot, met, out, drawn)
            energy += drawn[3, 3]
            for q in range(3):
                for a in range(3):
                    force[corner[f, q], a] += drawn[q, a]
    return energy
