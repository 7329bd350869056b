"""Beams that bend far: where the kernels' own energy is least, and what the elastica says of the same."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp
from scipy.integrate import solve_bvp
from scipy.sparse.linalg import spsolve
from tests.mechanics.materials import Alone, boxes, energy_at, force_between

from cotouch.body import body_from_tetrahedra

Float = npt.NDArray[np.float64]
YOUNG, THICK = 1e5, 0.01
# scipy has no types for it
# pyright: reportUnknownVariableType=false, reportUnknownMemberType=false, reportUnknownArgumentType=false
# Sweeps that find rotations from those of a place nearby.
_SWEEPS = 12


@dataclass(frozen=True)
class Elastica:
    """A line that bends and neither stretches nor shears, clamped at one end, with a dead load across the other.

    `EI θ'' = -P cos θ`, θ = 0 at the clamp and θ' = 0 at the tip [Love 1944, section 262].
    """

    along: Float
    angle: Float
    place: Float  # (points, 2), along and across

    @property
    def tip(self) -> Float:
        return self.place[-1]


def elastica(load: float, length: float) -> Elastica:
    """By collocation.

    Args:
        load: P L² / EI.
        length: [m].
    """
    s = np.linspace(0.0, 1.0, 401)

    def slope(s: Float, y: Float) -> Float:
        return np.stack([y[1], -load * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])])

    def ends(a: Float, b: Float) -> Float:
        return np.array([a[0], b[1], a[2], a[3]])

    guess = np.stack([load * (s - 0.5 * s * s), load * (1.0 - s), s, 0.5 * load * s * s])
    found = solve_bvp(slope, ends, s, guess / (1.0 + 0.4 * load), tol=1e-8, max_nodes=20_000)
    assert found.success
    y = found.sol(s)
    return Elastica(length * s, y[0], length * y[2:].T)


def bent_beam(model: str, fine: int, *, slender: int, load: float, wide: int = 1) -> tuple[Float, int]:
    """How far the middle of the tip's face comes, along and across [m], and how many nodes the beam has.

    Newton's method on the energy of the kernels, with differences of their gradient as its tangent; it begins at the
    elastica. Poisson's ratio is 0, so a beam has the elastica's EI, however wide.

    Args:
        model: of the tetrahedra.
        fine: cubes over the thickness.
        slender: length over thickness.
        load: P L² / EI.
        wide: cubes over the width, each as wide as the beam is thick.
    """
    shape = (slender * fine + 1, wide + 1, fine + 1)
    points, corners = boxes(shape, THICK / fine)
    points[:, 1] *= fine
    length, width = slender * THICK, wide * THICK
    body = body_from_tetrahedra((points, corners), unit="m", model=model, young=YOUNG, poisson=0.0)
    copy = Alone(body)
    rest = body.rest
    curve = elastica(load, length)
    angle = np.interp(rest[:, 0], curve.along, curve.angle)
    middle = np.stack([np.interp(rest[:, 0], curve.along, curve.place[:, a]) for a in range(2)], axis=1)
    above = rest[:, 2] - 0.5 * THICK
    x = np.zeros_like(rest)
    x[:, 0] = middle[:, 0] - above * np.sin(angle) - rest[:, 0]
    x[:, 2] = middle[:, 1] + above * np.cos(angle) - above
    inertia = width * THICK**3 / 12.0
    tip = np.isclose(rest[:, 0], length)
    # As a shear that is uniform over the face: each node has its share of the area.
    share = np.ones(body.nodes)
    for axis, size in ((1, width), (2, THICK)):
        share *= np.where(np.isclose(rest[:, axis], 0.0) | np.isclose(rest[:, axis], size), 0.5, 1.0)
    push = np.zeros_like(rest)
    push[tip, 2] = load * YOUNG * inertia / length**2 * share[tip] / share[tip].sum()
    free = np.repeat(rest[:, 0] > 0.0, 3)

    def gradient(x: Float) -> Float:
        rows, still = copy.rows(x), np.zeros((copy.model.operator_rows, 4))
        memory, lanes = copy.state.memory, copy.model.lanes
        energy_at(copy.force, memory, rows, rows, still, _SWEEPS, lanes)
        out = np.zeros_like(still)
        force_between(copy.force, memory, rows, rows, still, out, lanes)
        return copy.model.to_nodes(out) - push

    index = np.stack(np.unravel_index(np.arange(body.nodes), shape), axis=1)
    order = np.lexsort(np.rint(rest / (THICK / fine))[:, ::-1].T)
    colour = np.empty(body.nodes, dtype=np.int64)
    colour[order] = (index % 3) @ np.array([9, 3, 1])
    assert body.material is not None
    elements = body.material.elements
    pairs = np.unique(np.stack([np.repeat(elements, 4, axis=1), np.tile(elements, 4)], axis=-1).reshape(-1, 2), axis=0)
    row, column = pairs.T
    step, left = 1e-6 * THICK, np.inf
    for _ in range(30):
        here = gradient(x)
        left = float(np.abs(here.ravel()[free]).max())
        if left <= 1e-7 * float(push.max()):
            break
        blocks = np.zeros((row.size, 3, 3))
        for c in range(27):
            for axis in range(3):
                moved = np.zeros_like(x)
                moved[colour == c, axis] = step
                slope = (gradient(x + moved) - gradient(x - moved)) / (2.0 * step)
                mine = colour[column] == c
                blocks[mine, :, axis] = slope[row[mine]]
        i = (3 * row[:, None, None] + np.arange(3)[:, None]) + np.zeros((1, 1, 3), dtype=np.int64)
        j = (3 * column[:, None, None] + np.arange(3)) + np.zeros((1, 3, 1), dtype=np.int64)
        tangent = sp.csc_array((blocks.ravel(), (i.ravel(), j.ravel())), shape=(x.size, x.size))
        way = np.zeros(x.size)
        way[free] = -spsolve(tangent[free][:, free], here.ravel()[free])
        way = way.reshape(x.shape)
        x = x + min(1.0, 0.2 * length / float(np.abs(way).max())) * way
    else:
        raise AssertionError(f"Newton's method left {left:.1e} N")
    moved = (x[tip] * share[tip, None]).sum(axis=0) / share[tip].sum()
    return np.array([length + moved[0], moved[2]]), body.nodes
