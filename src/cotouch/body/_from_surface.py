"""A lattice inside a surface that it carries as a skin."""

from typing import Final, get_args

import numpy as np

from cotouch.body._assembly import MeshSource, name_of, put_together
from cotouch.body._body import Body
from cotouch.body._builders import MOST_NODES
from cotouch.body._cells import carriers
from cotouch.body._closed_surface import closed_shells
from cotouch.body._ground import Held
from cotouch.body._inertia import inertia_excess
from cotouch.body._lines import doubled
from cotouch.body._material import Frame
from cotouch.body._mesh_material import SurfaceModel, check_material, frame_of_model, of_cells, warned
from cotouch.body._origin import Origin
from cotouch.body._pieces import grid_nodes, one_part
from cotouch.body._reading import Unit
from cotouch.body._rigid import moments_of, rigid_solid
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

# Counted in the file before it is loaded; what a surface has beyond is finer than any lattice inside it can follow.
MOST_TRIANGLES: Final = 1_000_000
# Moments of inertia that are nearer than this are as good as the rest.
_INERTIA = 0.03


def body_from_surface(
    source: MeshSource,
    *,
    unit: Unit | None = None,
    resolution: int = 12,
    model: SurfaceModel = "springs",
    young: float = 1e4,
    poisson: float = 0.3,
    stiffness: float | None = None,
    density: float = 1000.0,
    mass: float | None = None,
    rayleigh_mass: float = 0.0,
    rayleigh_stiffness: float = 0.0,
    ground: Held = "none",
    ground_stiffness: float = 0.0,
    ground_damping: float = 0.0,
    frame: Frame | None = None,
    part: int | None = None,
    most_triangles: int = MOST_TRIANGLES,
    most_nodes: int = MOST_NODES,
) -> Body:
    """A lattice inside a closed surface; the surface becomes a skin that the lattice carries.

    The lattice is all cells of a regular grid that the surface fills or touches, with a node at every corner. A cell
    weighs, and is as stiff as, the share of it that is solid, so that the whole has the solid's mass and about its
    stiffness.

    Args:
        source: an STL, OBJ, PLY, OFF or GLB file, or (points (P, 3), triangles (F, 3)).
        unit: of the source: "m", "mm", "cm" or "in". Only GLB says it itself (metres).
        resolution: cells along the longest side, >= 1.
        model: "springs": scalar springs along the edges of the cells, of E h each [N/m], cheap to step. They store
            `½ E ∫ |∇u|²`: a stretched bar has E A / L exactly, Poisson's ratio is 0, the shear modulus is E, and
            turning the body costs energy. "elastic": linear elasticity on the cells, right for small bends and turns,
            at three times the rows. "cells": the springs' cubes, each with a rotation of its own, for bodies that turn
            and bend far. "spring-network": springs along edges and across faces of the cells that turn with their ends;
            isotropic, with a Poisson's ratio of ¼. "rigid": no lattice; see `rigid_body`.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 and below 0.5; "elastic" only.
        stiffness: of each spring of a full cell's inside, instead of E h ("spring-network": 0.4 E h) [N/m]; not of
            "elastic".
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `NodesNearPlane`, a `NodesInBox` [m], or
            node indices.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        frame: of a linear body ("springs", "elastic"): "floating" (the default) turns as a whole without a force;
            "fixed" keeps K as it is: cheaper, with modes, and a turned body shrinks.
        part: which of several separate parts to take, from 1, the biggest first.
        most_triangles: refuse more than this.
        most_nodes: refuse more than this.

    Returns:
        A body with `skin` and `origin`; `origin.notes` says what was repaired.

    Raises:
        BodyError: the source is no closed surface and cannot be made one, or a value is out of its range.

    Examples:
        >>> corners = [[x, y, z] for x in (0, 40) for y in (0, 10) for z in (0, 10)]
        >>> faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        ...          [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
        >>> bar = body_from_surface((corners, faces), unit="mm", resolution=4)
        >>> bar.nodes, round(float(bar.mass.sum()), 9)
        (20, 0.004)
    """
    name = name_of(source)
    if not (float(resolution).is_integer() and resolution >= 1):
        raise BodyError(f"resolution is {resolution}; it must be a whole number of at least 1")
    check_material(
        model,
        get_args(SurfaceModel),
        young=young,
        poisson=poisson,
        stiffness=stiffness,
        density=density,
        mass=mass,
        rayleigh_mass=rayleigh_mass,
        rayleigh_stiffness=rayleigh_stiffness,
        frame=frame,
    )
    frame = frame_of_model(model, frame)
    shells = closed_shells(source, name, unit, most_triangles)
    shells, cells, notes = one_part(shells, int(resolution), part, name)
    if model == "rigid":
        solid = moments_of(shells.vertices, shells.triangles)
        notes = [*shells.notes, *notes]
        return rigid_solid(
            shells.vertices, shells.triangles, solid, density, mass, name, "surface", unit, ground, notes
        )
    corners, rest = grid_nodes(cells)
    if rest.shape[0] > most_nodes:
        raise BodyError(
            f"resolution {resolution} makes {rest.shape[0]} nodes of {name}, but the limit is {most_nodes}; lower it, "
            "or raise most_nodes"
        )
    twice = doubled(shells.vertices, shells.triangles)
    volume = shells.volume - twice
    if twice != 0.0:
        notes = [*notes, f"Its surface overlaps itself in {100.0 * twice / volume:.2g} % of the volume, counted once."]
    fractions = np.bincount(corners.ravel(), weights=np.repeat(cells.fill, 8), minlength=rest.shape[0])
    total = density * volume if mass is None else mass
    springs, material = of_cells(
        cells,
        corners,
        rest.shape[0],
        model=model,
        young=young,
        poisson=poisson,
        stiffness=stiffness,
        viscosity=rayleigh_stiffness,
        frame=frame,
    )
    heavy = 0.0
    if twice == 0.0:  # its integrals over the surface count what overlaps twice
        heavy = inertia_excess(shells.vertices, shells.triangles, rest, fractions.astype(float))
    if heavy > _INERTIA:
        notes = [
            *notes,
            f"Its moments of inertia are up to {100.0 * heavy:.0f} % above the solid's, because its mass is at the "
            "corners of cells; a higher resolution brings them closer.",
        ]
    rows, weights = carriers(shells.vertices, shells.triangles, cells)
    skin = Skin(vertices=shells.vertices, triangles=shells.triangles, nodes=corners[rows], weights=weights)
    return put_together(
        rest=rest,
        masses=total * fractions / fractions.sum(),
        springs=springs,
        dampers=springs * rayleigh_stiffness,
        alpha=rayleigh_mass,
        beta=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        slack=0.5 * cells.spacing,
        sets={},
        skin=skin,
        origin=Origin(
            source=name,
            kind="surface",
            model=model,
            unit=unit or "m",
            elements=cells.fill.size,
            volume=volume,
            size=np.ptp(shells.vertices, axis=0),
            spacing=cells.spacing,
        ),
        notes=[*shells.notes, *notes, *warned(model, poisson)],
        material=material,
    )
