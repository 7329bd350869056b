"""A ball pressed into an elastic solid, at rest, beside Hertz: tetrahedra in series with the law's foundation."""

from typing import NamedTuple

import numpy as np
import pytest
import scipy.sparse as sp
from scipy.sparse.linalg import splu
from tests.mechanics.materials import boxes
from tests.mechanics.pressing import areas

from cotouch.body import body_from_tetrahedra
from cotouch.mechanics import Stiffening, press_skin

Float = np.typing.NDArray[np.float64]
YOUNG, POISSON, SPACING = 1e4, 0.3, 0.01
REDUCED = YOUNG / (1.0 - POISSON**2)
_NEAR = 1e-9


class Top(NamedTuple):
    """What can move near the middle of a solid's top, of a quarter of it: mirrors stand in for the rest.

    Attributes:
        place: of its nodes at rest, (n, 3) [m].
        corner: of its triangles, (F, 3).
        free: which displacements can be other than 0, (3 n,).
        stiffness: of those, the rest of the solid condensed (m, m) [N/m].
    """

    place: Float
    corner: np.typing.NDArray[np.int32]
    free: np.typing.NDArray[np.bool_]
    stiffness: Float


def top(spacing: float, reach: float) -> Top:
    """Cubes of six tetrahedra as far as the ball reaches, and larger and larger ones until far away."""
    fine = max(int(np.ceil(1.4 * reach / spacing)), 2)
    line = np.concatenate([[0.0], np.cumsum([spacing] * fine + [spacing * 1.7**k for k in range(1, 7)])])
    points, cells = boxes((line.size,) * 3, 1.0)
    index = np.rint(points).astype(int)
    points = np.stack([line[index[:, 0]], line[index[:, 1]], -line[index[:, 2]]], axis=1)
    body = body_from_tetrahedra((points, cells), unit="m", young=YOUNG, poisson=POISSON, density=1000.0)
    place = body.rest - [*body.rest[:, :2].min(axis=0), body.rest[:, 2].max()]
    held = np.zeros(place.shape, bool)
    held[:, :2] = place[:, :2] < _NEAR
    far = (np.abs(place) > line[-1] - _NEAR).any(axis=1)
    held[far] = True
    free = np.flatnonzero(~held.ravel())
    near = np.flatnonzero((place[:, 2] > -_NEAR) & (np.hypot(*place[:, :2].T) <= 1.4 * reach + 1.01 * spacing) & ~far)
    own = ~held[near].ravel()
    unit = np.zeros((free.size, int(own.sum())))
    rows = np.searchsorted(free, (3 * near[:, None] + np.arange(3)).ravel()[own])
    unit[rows, np.arange(rows.size)] = 1.0
    whole = sp.csc_array(body.stiffness)[free][:, free]
    number = np.full(place.shape[0], -1)
    number[near] = np.arange(near.size)
    skin = body.skin
    assert skin is not None
    nodes = skin.nodes[np.arange(skin.nodes.shape[0]), np.argmax(skin.weights, axis=1)][skin.triangles]
    above = (place[nodes, 2] > -_NEAR).all(axis=1) & (number[nodes] >= 0).all(axis=1)
    return Top(
        place[near],
        number[nodes[above]].astype(np.int32),
        own,
        np.asarray(np.linalg.inv(splu(whole).solve(unit)[rows]), dtype=np.float64),
    )


def pressed(solid: Top, radius: float, depth: float, stiffness: float) -> float:
    """Force on a ball that stands `depth` below where it would touch first [N]: where energy is least, by Newton."""
    u = np.zeros(int(solid.free.sum()))

    def look(u: Float, depth: float) -> tuple[float, Float, float]:
        moved = np.zeros(solid.free.size)
        moved[solid.free] = u
        middle = np.array([0.0, 0.0, radius - depth])
        energy, force = press_skin(
            Stiffening(),
            solid.place + moved.reshape(-1, 3),
            solid.corner,
            middle,
            stiffness=stiffness,
            radius=radius,
            area=areas(solid.place, solid.corner),
        )
        return energy + 0.5 * float(u @ solid.stiffness @ u), force.ravel()[solid.free], -4.0 * float(force[:, 2].sum())

    for now in np.linspace(0.2, 1.0, 5) * depth:
        for _ in range(40):
            energy, force, _ = look(u, now)
            left = solid.stiffness @ u - force
            if np.linalg.norm(left) <= 1e-8 * np.linalg.norm(force):
                break
            tangent = solid.stiffness.copy()
            for q in range(u.size):
                tangent[:, q] -= (look(u + 1e-9 * (np.arange(u.size) == q), now)[1] - force) / 1e-9
            way, share = -np.linalg.solve(tangent, left), 1.0
            while look(u + share * way, now)[0] > energy + 1e-15 and share > 1e-3:
                share *= 0.5
            u = u + share * way
    return look(u, depth)[2]


def hertz(radius: float, depth: float) -> float:
    """`4/3 E* √R δ^1.5` [Johnson 1985, eq. 4.23]."""
    return 4.0 / 3.0 * REDUCED * np.sqrt(radius) * depth**1.5


@pytest.mark.parametrize(
    ("radius", "share"), [(2.0, 0.05), (2.0, 0.1), (2.0, 0.3), (3.0, 0.1), (4.0, 0.05), (4.0, 0.1)]
)
def test_a_ball_is_felt_as_hertz_says(radius: float, share: float) -> None:
    """From a radius of two spacings, with the stiffness that docs/scenario.md gives."""
    radius *= SPACING
    depth = share * radius
    solid = top(SPACING, np.sqrt(radius * depth))
    force = pressed(solid, radius, depth, 0.57 * REDUCED * radius**2 / SPACING)
    assert force == pytest.approx(hertz(radius, depth), rel=0.1)


def test_a_finer_mesh_alone_tends_to_hertz() -> None:
    """A foundation that hardly yields leaves what the mesh does: too stiff in proportion to its spacing."""
    radius, depth = 0.02, 0.002
    reach = np.sqrt(radius * depth)
    over = [
        pressed(top(reach / fine, reach), radius, depth, 3e4) / hertz(radius, depth) - 1.0 for fine in (0.75, 1.5, 3.0)
    ]
    assert over[0] > 1.5 * over[1] > 1.5**2 * over[2] > 0.0
    assert over[2] < 0.25
