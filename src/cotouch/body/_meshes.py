"""Bodies from meshes: a lattice inside a surface that it carries as a skin, or a solid of tetrahedra."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final, Literal, TypeAlias

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.body import _elasticity as elasticity
from cotouch.body._body import Body
from cotouch.body._cells import carriers
from cotouch.body._checks import SumOfSquares
from cotouch.body._ground import Held, free_motions, held_nodes
from cotouch.body._origin import Origin
from cotouch.body._pieces import Float, boundary_of, grid_nodes, one_part, one_piece, volumes_of, without_broken
from cotouch.body._reading import Mesh, Unit, as_mesh, check_indices, metres, read_surface, read_tetrahedra
from cotouch.body._repair import repaired
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

Model: TypeAlias = Literal["springs", "elastic"]
MeshSource: TypeAlias = str | Path | tuple[npt.ArrayLike, npt.ArrayLike]

# Counted in the file before it is loaded; what a surface has beyond is finer than any lattice inside it can follow.
MOST_TRIANGLES: Final = 1_000_000
MOST_ELEMENTS: Final = 500_000
# A step of a node costs about 0.2 µs, so that more is far from any haptic rate.
MOST_NODES: Final = 100_000
# Above this Poisson's ratio linear elements lock: they turn out much too stiff.
_LOCKS: Final = 0.45


def body_from_surface(
    source: MeshSource,
    *,
    unit: Unit | None = None,
    resolution: int = 12,
    model: Model = "springs",
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
            turning the body costs energy. "elastic": linear elasticity on the cells, right for bending and turning, at
            three times the rows.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 and below 0.5; "elastic" only.
        stiffness: of each spring of a full cell's inside, instead of E h [N/m]; "springs" only.
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `Plane`, a `Box` [m], or node indices.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
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
    _check_material(model, young, poisson, stiffness, density, mass, rayleigh_mass, rayleigh_stiffness)
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
    volume = shells.volume
    shares = np.bincount(corners.ravel(), weights=np.repeat(cells.fill, 8), minlength=rest.shape[0])
    total = density * volume if mass is None else mass
    if model == "springs":
        spring = young * cells.spacing if stiffness is None else stiffness
        springs = elasticity.springs_of_cells(rest.shape[0], corners, cells.fill, stiffness=spring)
    else:
        springs = elasticity.elastic_cells(
            rest.shape[0], corners, cells.fill, spacing=cells.spacing, young=young, poisson=poisson
        )
    rows, weights = carriers(shells.vertices, shells.triangles, cells)
    skin = Skin(vertices=shells.vertices, triangles=shells.triangles, nodes=corners[rows], weights=weights)
    return _body(
        rest=rest,
        masses=total * shares / shares.sum(),
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
        notes=[*shells.notes, *notes, *_warned(model, poisson)],
    )


def body_from_tetrahedra(
    source: MeshSource,
    *,
    unit: Unit | None = None,
    model: Model = "elastic",
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
            `½ E ∫ |∇u|²`; see `body_from_surface` for what that means.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 and below 0.5; "elastic" only.
        stiffness: of the spring along every edge, instead of what E gives [N/m]; "springs" only.
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `Plane`, a `Box` [m], a `NodeSet` of the
            file, or indices among the nodes of the body.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
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
    _check_material(model, young, poisson, stiffness, density, mass, rayleigh_mass, rayleigh_stiffness)
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
    shares = np.bincount(elements.ravel(), weights=np.repeat(volumes, 4), minlength=rest.shape[0])
    total = density * volume if mass is None else mass
    if model == "elastic":
        springs = elasticity.elastic_tetrahedra(rest, elements, young=young, poisson=poisson)
    elif stiffness is None:
        springs = elasticity.springs_of_tetrahedra(rest, elements, young=young)
    else:
        springs = elasticity.springs_along_edges(rest.shape[0], elements, stiffness=stiffness)
    place = np.full(mesh.points.shape[0], -1, dtype=np.int64)
    place[used] = np.arange(used.size)
    given = {**mesh.sets, **{key: np.asarray(members, dtype=np.int64) for key, members in (sets or {}).items()}}
    named: dict[str, Any] = {key: place[members][place[members] >= 0] for key, members in given.items()}
    edges = rest[elasticity.edges_of(elements)]
    return _body(
        rest=rest,
        masses=total * shares / shares.sum(),
        springs=springs,
        alpha=rayleigh_mass,
        beta=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        slack=0.0,
        sets=named,
        skin=boundary_of(rest, elements),
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
        notes=[*notes, *_warned(model, poisson)],
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
) -> Body:
    """Puts the parts together; what holds it are springs to the ground, so that they are diagonal."""
    for label, value in (("ground_stiffness", ground_stiffness), ("ground_damping", ground_damping)):
        if not (np.isfinite(value) and value >= 0.0):
            raise BodyError(f"{label} is {value}; it must be a finite number of at least 0")
    held = held_nodes(ground, rest, slack=slack, sets=sets)
    if held.size and ground_stiffness == 0.0 and ground_damping == 0.0:
        raise BodyError(f"the ground holds {held.size} nodes with ground_stiffness 0; give it in N/m for each node")
    turning = springs.shape[0] == 3 * rest.shape[0]
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
    )


def _name(source: object) -> str:
    return str(source) if isinstance(source, str | Path) else "arrays"


def _check_material(
    model: str,
    young: float,
    poisson: float,
    stiffness: float | None,
    density: float,
    mass: float | None,
    rayleigh_mass: float,
    rayleigh_stiffness: float,
) -> None:
    if model not in {"springs", "elastic"}:
        raise BodyError(f'model is "{model}"; it must be "springs" or "elastic"')
    for label, value, unit in (
        ("young", young, "Pa"),
        ("density", density, "kg/m³"),
        ("mass", mass, "kg"),
        ("stiffness", stiffness, "N/m"),
    ):
        if value is not None and not (np.isfinite(value) and value > 0.0):
            raise BodyError(f"{label} is {value}; it must be more than 0 {unit}")
    if stiffness is not None and model != "springs":
        raise BodyError(f'stiffness is {stiffness}, but model is "elastic"; give young and poisson, or model "springs"')
    if not -1.0 < poisson < 0.5:
        raise BodyError(f"poisson is {poisson}; it must be above -1 and below 0.5")
    for label, value in (("rayleigh_mass", rayleigh_mass), ("rayleigh_stiffness", rayleigh_stiffness)):
        if not (np.isfinite(value) and value >= 0.0):
            raise BodyError(f"{label} is {value}; it must be a finite number of at least 0")


def _warned(model: str, poisson: float) -> list[str]:
    if model == "elastic" and poisson > _LOCKS:
        return [f"Poisson's ratio {poisson:g}: so near to 0.5 linear elements are too stiff."]
    return []
