"""Bodies from meshes: a lattice inside a surface that it carries as a skin, or a solid of tetrahedra."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final, TypeAlias, get_args

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.body import _elasticity as elasticity
from cotouch.body._body import Body
from cotouch.body._builders import MOST_NODES
from cotouch.body._cells import carriers
from cotouch.body._checks import SumOfSquares
from cotouch.body._ground import Held, free_motions, held_nodes, rounded_face
from cotouch.body._inertia import inertia_excess
from cotouch.body._lines import doubled
from cotouch.body._material import Frame, Material
from cotouch.body._mesh_material import SolidModel, SurfaceModel, check_material, of_cells, of_tetrahedra, warned
from cotouch.body._origin import Origin
from cotouch.body._pieces import Float, boundary_of, grid_nodes, hinged, one_part, one_piece, volumes_of, without_broken
from cotouch.body._reading import Unit, as_mesh, check_indices, metres
from cotouch.body._repair import repaired
from cotouch.body._skin import Skin
from cotouch.errors import BodyError
from cotouch.meshfile import Mesh, read_surface, read_tetrahedra

MeshSource: TypeAlias = str | Path | tuple[npt.ArrayLike, npt.ArrayLike]

# Counted in the file before it is loaded; what a surface has beyond is finer than any lattice inside it can follow.
MOST_TRIANGLES: Final = 1_000_000
MOST_ELEMENTS: Final = 500_000
# Moments of inertia that are nearer than this are as good as the rest.
_INERTIA = 0.03
# Of the volume of tetrahedra; more is no rounding.
_OVERLAP: Final = 1e-3


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
    frame: Frame = "fixed",
    gravity: Sequence[float] | None = None,
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
            isotropic, with a Poisson's ratio of ¼.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 and below 0.5; "elastic" only.
        stiffness: of each spring of a full cell's inside, instead of E h ("spring-network": 0.4 E h) [N/m]; not of
            "elastic".
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `Plane`, a `Box` [m], or node indices.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        frame: "floating": a linear body ("springs", "elastic") turns as a whole without a force.
        gravity: acceleration, a number for each of three axes [m/s²]. None: no weight.
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
    name = _name(source)
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
    scale = metres(unit, name)
    mesh = (
        read_surface(Path(name), most_triangles) if isinstance(source, str | Path) else as_mesh(source, 3, "triangles")
    )
    if mesh.elements.shape[0] > most_triangles:
        raise BodyError(
            f"{name} has {mesh.elements.shape[0]} triangles but the limit is {most_triangles}; make it coarser, or "
            "raise most_triangles"
        )
    shells = repaired(Mesh(points=mesh.points * scale, elements=mesh.elements, notes=mesh.notes), name)
    shells, cells, notes = one_part(shells, int(resolution), part, name)
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
        gravity=gravity,
    )
    heavy = 0.0
    if twice == 0.0:  # its integrals over the surface count what overlaps twice
        heavy = inertia_excess(shells.vertices, shells.triangles, rest, fractions.astype(float))
    if heavy > _INERTIA:
        notes = [
            *notes,
            f"Its moments of inertia are up to {100.0 * heavy:.0f} % above the solid's, as its mass sits at corners "
            "of cells; a higher resolution is nearer.",
        ]
    rows, weights = carriers(shells.vertices, shells.triangles, cells)
    skin = Skin(vertices=shells.vertices, triangles=shells.triangles, nodes=corners[rows], weights=weights)
    return _body(
        rest=rest,
        masses=total * fractions / fractions.sum(),
        springs=springs,
        alpha=rayleigh_mass,
        beta=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        slack=0.5 * cells.spacing,
        sets={},
        skin=skin,
        origin={
            "source": name,
            "kind": "surface",
            "model": model,
            "unit": unit or "m",
            "elements": cells.fill.size,
            "volume": volume,
            "size": np.ptp(shells.vertices, axis=0),
            "spacing": cells.spacing,
        },
        notes=[*shells.notes, *notes, *warned(model, poisson)],
        material=material,
    )


def body_from_tetrahedra(
    source: MeshSource,
    *,
    unit: Unit | None = None,
    model: SolidModel = "elastic",
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
    frame: Frame = "fixed",
    gravity: Sequence[float] | None = None,
    part: int | None = None,
    sets: Mapping[str, Sequence[int]] | None = None,
    most_elements: int = MOST_ELEMENTS,
    most_nodes: int = MOST_NODES,
) -> Body:
    """A solid of linear tetrahedra; its boundary is the skin.

    Args:
        source: a VTK, VTU, Gmsh (.msh) or MEDIT (.mesh) file, or (points (P, 3), tetrahedra (E, 4)).
        unit: of the source: "m", "mm", "cm" or "in"; these formats do not say it.
        model: "elastic": linear elasticity (P1, lumped mass). "springs": scalar springs along the edges that store
            `½ E ∫ |∇u|²`; see `body_from_surface` for what that means. For bodies that turn and bend far: "corotated",
            "st-venant-kirchhoff", "neo-hookean" (see `Material`), or "spring-network": springs of `stiffness` along the
            edges that turn with their ends.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 (with "neo-hookean" above 0) and below 0.5; not of springs.
        stiffness: of the spring along every edge, instead of what E gives [N/m]; of springs only.
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `Plane`, a `Box` [m], a `NodeSet` of the
            file, or indices among the nodes of the body.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        frame: "floating": a linear body ("springs", "elastic") turns as a whole without a force.
        gravity: acceleration, a number for each of three axes [m/s²]. None: no weight.
        part: which of several separate parts to take, from 1, the biggest first.
        sets: more named sets, as indices of the source's points.
        most_elements: refuse more than this.
        most_nodes: refuse more than this.

    Returns:
        A body with `skin` and `origin`; `origin.notes` says what was repaired.

    Raises:
        BodyError: the source is no mesh of tetrahedra, or a value is out of its range.

    Examples:
        >>> corners = [[0, 0, 0], [6, 0, 0], [0, 1, 0], [0, 0, 1]]
        >>> body = body_from_tetrahedra((corners, [[0, 1, 2, 3]]), unit="m", density=1000.0)
        >>> body.form, round(float(body.mass.sum()) / 3)
        ('full', 1000)
    """
    name = _name(source)
    check_material(
        model,
        get_args(SolidModel),
        young=young,
        poisson=poisson,
        stiffness=stiffness,
        density=density,
        mass=mass,
        rayleigh_mass=rayleigh_mass,
        rayleigh_stiffness=rayleigh_stiffness,
        frame=frame,
    )
    scale = metres(unit, name)
    if isinstance(source, str | Path):
        mesh = read_tetrahedra(Path(name), most_elements)
    else:
        mesh = as_mesh(source, 4, "tetrahedra")
    if mesh.elements.shape[0] > most_elements:
        raise BodyError(
            f"{name} has {mesh.elements.shape[0]} tetrahedra but the limit is {most_elements}; make it coarser, or "
            "raise most_elements"
        )
    check_indices(mesh, name, "tetrahedra")
    notes = list(mesh.notes)
    elements = without_broken(mesh.points, mesh.elements, name, notes)
    elements = one_piece(mesh.points, elements, part, name, notes)
    loose = hinged(elements)
    if loose > 1:
        notes.append(
            f"{loose} groups of tetrahedra touch only at points or edges, as at hinges: there they may turn against "
            "each other without a force."
        )
    used, flat = np.unique(elements, return_inverse=True)
    elements = flat.reshape(elements.shape).astype(np.int64)
    unused = mesh.points.shape[0] - used.size
    if unused:
        notes.append(f"{unused} point{'s' * (unused != 1)} of no tetrahedron left out.")
    rest = mesh.points[used] * scale
    if rest.shape[0] > most_nodes:
        raise BodyError(
            f"{name} has {rest.shape[0]} nodes but the limit is {most_nodes}; make it coarser, or raise most_nodes"
        )
    volumes = volumes_of(rest, elements)
    volume = float(volumes.sum())
    skin = boundary_of(rest, elements)
    twice = doubled(skin.vertices, skin.triangles.astype(np.int64))
    if twice > _OVERLAP * volume:
        raise BodyError(
            f"tetrahedra of {name} overlap in {100.0 * twice / volume:.2g} % of their volume; every place must be in "
            "one of them, so mesh the union of the parts"
        )
    fractions = np.bincount(elements.ravel(), weights=np.repeat(volumes, 4), minlength=rest.shape[0])
    total = density * volume if mass is None else mass
    springs, material = of_tetrahedra(
        rest,
        elements,
        model=model,
        young=young,
        poisson=poisson,
        stiffness=stiffness,
        viscosity=rayleigh_stiffness,
        frame=frame,
        gravity=gravity,
    )
    place = np.full(mesh.points.shape[0], -1, dtype=np.int64)
    place[used] = np.arange(used.size)
    given = {**mesh.sets, **{key: np.asarray(members, dtype=np.int64) for key, members in (sets or {}).items()}}
    named: dict[str, Any] = {key: place[members][place[members] >= 0] for key, members in given.items()}
    edges = rest[elasticity.edges_of(elements)]
    return _body(
        rest=rest,
        masses=total * fractions / fractions.sum(),
        springs=springs,
        alpha=rayleigh_mass,
        beta=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        slack=0.0,
        sets=named,
        skin=skin,
        origin={
            "source": name,
            "kind": "tetrahedra",
            "model": model,
            "unit": unit or "m",
            "elements": volumes.size,
            "volume": volume,
            "size": np.ptp(rest, axis=0),
            "spacing": float(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).mean()),
        },
        notes=[*notes, *warned(model, poisson)],
        material=material,
    )


def _body(
    *,
    rest: Float,
    masses: Float,
    springs: sp.csr_array,
    alpha: float,
    beta: float,
    ground: Held,
    ground_stiffness: float,
    ground_damping: float,
    slack: float,
    sets: Mapping[str, Any],
    skin: Skin,
    origin: dict[str, Any],
    notes: list[str],
    material: Material | None,
) -> Body:
    """Puts the parts together; what holds it are springs to the ground, so that they are diagonal."""
    for label, value in (("ground_stiffness", ground_stiffness), ("ground_damping", ground_damping)):
        if not (np.isfinite(value) and value >= 0.0):
            raise BodyError(f"{label} is {value}; it must be a finite number of at least 0")
    held = held_nodes(ground, rest, slack=slack, spacing=float(origin["spacing"]), sets=sets)
    rounded = rounded_face(ground, rest, held)
    if rounded is not None:
        notes.append(rounded)
    if held.size and ground_stiffness == 0.0 and ground_damping == 0.0:
        raise BodyError(f"the ground holds {held.size} nodes with ground_stiffness 0; give it in N/m for each node")
    turning = springs.shape[0] == 3 * rest.shape[0] or (material is not None and material.model != "linear")
    free = free_motions(rest, held if ground_stiffness > 0.0 else held[:0], turning=turning)
    if free == (6 if turning else 3):
        notes.append("Held by nothing: pushed, it flies off. Give ground and ground_stiffness to hold it.")
    elif free:
        notes.append(f"The ground leaves {free} rigid motion{'s' * (free != 1)} free.")
    grip = np.zeros(rest.shape[0])
    grip[held] = 1.0
    return Body(
        mass=sp.diags_array(masses),
        rest=rest,
        damping_int=SumOfSquares(springs * beta) if beta > 0.0 else None,
        damping_ext=sp.diags_array(alpha * masses + grip * (ground_damping + beta * ground_stiffness)),
        stiffness_int=SumOfSquares(springs),
        stiffness_ext=sp.diags_array(grip * ground_stiffness),
        skin=skin,
        origin=Origin(held=held, free=free, notes=tuple(notes), **origin),
        material=material,
    )


def _name(source: object) -> str:
    return str(source) if isinstance(source, str | Path) else "arrays"
