"""Rigid bodies: four equal masses that turn, weigh and are as hard to turn as the solid.

The masses sit at `c + S s_k`, s_k alternate corners of a cube and S² the solid's `∫ ρ (r - c)(r - c)ᵀ / m`, so mass,
centre and all moments of inertia are the solid's to rounding. S is the symmetric root: unlike principal axes it is one
and the same on every machine. What keeps the four together is stiff, not infinitely so: all six ways in which they
could be strained swing at `RATE`.
"""

from dataclasses import replace
from typing import Final, Literal

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float, Long
from cotouch.body._body import Body
from cotouch.body._checks import SumOfSquares, one_number
from cotouch.body._inertia import sums_of
from cotouch.body._material import Material
from cotouch.body._origin import Origin
from cotouch.body._skin import Skin
from cotouch.body._strains import SIGNS, frame_of, shares_of, strain_law, strains_of
from cotouch.errors import BodyError

# Angular frequency of all strains [rad/s]: ω T / 2 = 1 at 1 ms. A body that spins at Ω is strained by (Ω / ω)²,
# one of half side a that is accelerated by g by about g / (a ω²): 1e-4 at 20 rad/s, and of 5 cm under its weight.
RATE: Final = 2000.0
# Time of the dampers of strain, so that it dies away within a few steps: half of critical.
VISCOSITY: Final = 5e-4
# A principal radius below this share of the largest is no solid's.
_FLAT = 1e-4


def moments_of(vertices: Float, triangles: Long) -> tuple[float, Float, Float]:
    """Volume [m³], centre [m] and `∫ (r - c)(r - c)ᵀ` of a solid, divided by its volume [m²].

    Args:
        vertices: of its closed surface, (V, 3) [m].
        triangles: seen from outside, (F, 3).
    """
    middle = vertices.mean(axis=0)
    volume, first, second = sums_of(vertices[triangles] - middle)
    return volume, middle + first / volume, second / (120.0 * volume) - np.outer(first, first) / volume**2


def moments_of_tetrahedra(rest: Float, elements: Long) -> tuple[float, Float, Float]:
    """As `moments_of`, of a solid of tetrahedra.

    Args:
        rest: (n, 3) places [m].
        elements: (E, 4) indices of places.
    """
    corners = rest[elements] - rest.mean(axis=0)
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6.0
    volume, total = float(volumes.sum()), corners.sum(axis=1)
    first = volumes @ total / (4.0 * volume)
    second = np.einsum("t,ti,tj->ij", volumes, total, total) + np.einsum("t,tci,tcj->ij", volumes, corners, corners)
    return volume, rest.mean(axis=0) + first, second / (20.0 * volume) - np.outer(first, first)


def rigid_body(
    vertices: npt.ArrayLike,
    triangles: npt.ArrayLike,
    *,
    mass: float,
    centre: npt.ArrayLike,
    spread: npt.ArrayLike,
    rate: float = RATE,
    viscosity: float = VISCOSITY,
    origin: Origin | None = None,
) -> Body:
    """A rigid body with a skin.

    Args:
        vertices: of the skin, (V, 3) [m].
        triangles: of the skin, counter-clockwise seen from outside, (F, 3).
        mass: [kg], > 0.
        centre: of mass, (3,) [m].
        spread: `∫ ρ (r - c)(r - c)ᵀ / m`, (3, 3) [m²]; moments of inertia are `m (tr spread · 1 - spread)`.
        rate: how fast what is strained swings, > 0 [rad/s].
        viscosity: η of the dampers of strain, >= 0 [s].
        origin: what a builder read; see `Origin`.

    Raises:
        BodyError: a value is out of its range, or the body is flat.

    Examples:
        >>> from cotouch.body import rigid_box
        >>> die = rigid_box([0.02, 0.02, 0.02], mass=0.01)
        >>> die.nodes, round(float(die.mass.diagonal()[::3].sum()), 9)
        (4, 0.01)
    """
    for name, value, unit in (("mass", mass, "kg"), ("rate", rate, "rad/s")):
        if not (np.isfinite(one_number(name, value)) and value > 0.0):
            raise BodyError(f"{name} is {value}; it must be more than 0 {unit}")
    squares, axes = np.linalg.eigh(np.asarray(spread, dtype=np.float64))
    if not (np.isfinite(squares).all() and squares.max() > 0.0):
        raise BodyError("the solid has no extent; its surface must enclose a volume")
    radii = np.sqrt(np.maximum(squares, 0.0))
    if radii.min() < _FLAT * radii.max():
        raise BodyError(
            f"the solid is {radii.min() / radii.max():.2g} times as thick as it is long; a rigid body needs at least "
            f"{_FLAT:g}"
        )
    middle = np.asarray(centre, dtype=np.float64)
    root = (axes * radii) @ axes.T
    rest = middle + SIGNS @ (0.5 * (root + root.T))
    strength = mass * rate * rate
    material = Material(
        model="rigid",
        elements=np.arange(4, dtype=np.int64)[None, :],
        stiffness=np.array([strength]),
        viscosity=viscosity,
    )
    places = np.asarray(vertices, dtype=np.float64)
    skin = Skin(
        vertices=places,
        triangles=triangles,
        nodes=np.tile(np.arange(4), (places.shape[0], 1)),
        weights=shares_of(rest, places),
    )
    frame = frame_of(rest)
    stretch = strains_of(frame)
    springs = strength * (stretch.T @ strain_law(frame) @ stretch)
    inner = SumOfSquares(sp.csr_array(0.5 * (springs + springs.T)))
    return Body(
        mass=sp.diags_array(np.full(12, 0.25 * mass)),
        rest=rest,
        stiffness_int=inner,
        damping_int=SumOfSquares(inner.matrix * viscosity) if viscosity > 0.0 else None,
        skin=skin,
        material=material,
        origin=origin,
    )


def scaled(body: Body, *, mass: float, rate: float) -> Body:
    """A rigid body of the same shape and so many times the mass, whose strains swing so many times as fast.

    Args:
        body: rigid.
        mass: > 0.
        rate: > 0.
    """
    assert body.material is not None
    firm = mass * rate * rate
    return Body(
        mass=body.mass * mass,
        rest=body.rest,
        stiffness_int=SumOfSquares(body.stiffness_int * firm),
        damping_int=SumOfSquares(body.damping_int * firm),
        skin=body.skin,
        material=replace(body.material, stiffness=body.material.stiffness * firm),
        origin=body.origin,
    )


def rigid_solid(
    vertices: Float,
    triangles: npt.ArrayLike,
    solid: tuple[float, Float, Float],
    density: float,
    mass: float | None,
    name: str,
    kind: Literal["surface", "tetrahedra"],
    unit: str | None,
    ground: object,
    notes: list[str],
) -> Body:
    """The rigid body of a mesh.

    Args:
        vertices: of its surface, (V, 3) [m].
        triangles: likewise, (F, 3).
        solid: its volume, centre and spread; see `moments_of`.
        density: [kg/m³].
        mass: [kg]; None: density times volume.
        name: of the source.
        kind: of the source; see `Origin`.
        unit: of the source.
        ground: what holds it: nothing.
        notes: what was repaired.

    Raises:
        BodyError: the ground shall hold it.
    """
    if not (isinstance(ground, str) and ground == "none"):
        raise BodyError(
            'ground is given, but model is "rigid", which cannot be held to the ground; leave ground out, and hold it '
            "by hand"
        )
    volume, centre, spread = solid
    corners = vertices[np.asarray(triangles)]
    return rigid_body(
        vertices,
        triangles,
        mass=density * volume if mass is None else mass,
        centre=centre,
        spread=spread,
        origin=Origin(
            source=name,
            kind=kind,
            model="rigid",
            unit=unit or "m",
            elements=corners.shape[0],
            volume=volume,
            size=np.ptp(vertices, axis=0),
            spacing=float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean()),
            notes=tuple(notes),
        ),
    )
