"""Bodies from meshes: a lattice inside a surface that it carries as a skin, or a solid of tetrahedra."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final, Literal, TypeAlias

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp
from scipy.sparse.csgraph import connected_components

from cotouch.body import _elasticity as elasticity
from cotouch.body._body import Body
from cotouch.body._cells import CORNERS, Cells, carriers, cells_of
from cotouch.body._checks import SumOfSquares
from cotouch.body._ground import Held, free_motions, held_nodes
from cotouch.body._origin import Origin
from cotouch.body._reading import Mesh, Unit, as_mesh, check_indices, metres, read_surface, read_tetrahedra
from cotouch.body._repair import Shells, repaired
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

Float = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Model: TypeAlias = Literal["springs", "elastic"]
MeshSource: TypeAlias = str | Path | tuple[npt.ArrayLike, npt.ArrayLike]

# Counted in the file before it is loaded; what a surface has beyond is finer than any lattice inside it can follow.
MOST_TRIANGLES: Final = 1_000_000
MOST_ELEMENTS: Final = 500_000
# A step of a node costs about 0.2 µs, so that more is far from any haptic rate.
MOST_NODES: Final = 100_000
# A piece with less than this share of the volume is debris.
_DEBRIS: Final = 0.01
# A tetrahedron of less than this share of its longest edge cubed is flat (a regular one has 0.118).
_FLAT: Final = 1e-8
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
    shells, cells, notes = _one_part(shells, int(resolution), part, name)
    corners, rest = _grid_nodes(cells)
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
    elements = _sound(mesh.points, mesh.elements, name, notes)
    elements = _piece(mesh.points, elements, part, name, notes)
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
    volumes = _volumes(rest, elements)
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
        skin=_boundary(rest, elements),
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


# Lattices.


def _grid_nodes(cells: Cells) -> tuple[Ints, Float]:
    """Nodes of the eight corners of each cell, (E, 8), and the places of the nodes."""
    grid = cells.shape + 1
    keys = np.ravel_multi_index(tuple(np.moveaxis(cells.places[:, None] + CORNERS[None], -1, 0)), tuple(grid))
    used, corners = np.unique(keys, return_inverse=True)
    places = np.stack(np.unravel_index(used, tuple(grid)), axis=1)
    return corners.reshape(keys.shape).astype(np.int64), cells.origin + cells.spacing * places


def _one_part(shells: Shells, resolution: int, part: int | None, name: str) -> tuple[Shells, Cells, list[str]]:
    """The shells that hang together, and their cells.

    Raises:
        BodyError: there are several parts and none was chosen, or not so many.
    """
    cells = cells_of(shells.vertices, shells.triangles, resolution)
    corners, rest = _grid_nodes(cells)
    label = _together(corners, rest.shape[0])
    rows, _ = carriers(shells.vertices, shells.triangles, cells)
    first = shells.triangles[np.unique(shells.shell, return_index=True)[1], 0]
    of_shell = label[corners[rows[first], 0]]
    shares = np.bincount(of_shell, weights=shells.volumes)
    if part is None and shares.size == 1:
        return shells, cells, []
    ranked = np.argsort(-shares, kind="stable")
    chosen = _choice(shares[ranked] / shares.sum(), part, name)
    if shares.size == 1:
        return shells, cells, []
    kept = shells.only(np.flatnonzero(of_shell == ranked[chosen]))
    return kept, cells_of(kept.vertices, kept.triangles, resolution), [_left(shares.size, chosen, part)]


def _choice(shares: Float, part: int | None, name: str) -> int:
    """Which of the parts, ordered by size, to take."""
    if part is not None:
        if not 1 <= part <= shares.size:
            raise BodyError(f"part is {part}; {name} has parts 1 to {shares.size}")
        return part - 1
    if shares[1:].sum() > _DEBRIS:
        shown = ", ".join(f"{100 * share:.3g} %" for share in shares[:5]) + (", ..." if shares.size > 5 else "")
        raise BodyError(
            f"{name} has {shares.size} separate parts ({shown} of its volume) that nothing joins; choose one with "
            "part, or join them"
        )
    return 0


def _left(parts: int, chosen: int, part: int | None) -> str:
    if part is None:
        return f"{parts - 1} loose part{'s' * (parts > 2)} left out, below 1 % of the volume."
    return f"Part {chosen + 1} of {parts} taken."


def _together(elements: Ints, nodes: int) -> Ints:
    """Which connected piece each node is of."""
    rows = np.repeat(elements[:, 0], elements.shape[1] - 1)
    graph = sp.csr_array((np.ones(rows.size), (rows, elements[:, 1:].ravel())), shape=(nodes, nodes))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


# Tetrahedra.


def _volumes(points: Float, elements: Ints) -> Float:
    a, b, c, d = (points[elements[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6.0


def _sound(points: Float, elements: Ints, name: str, notes: list[str]) -> Ints:
    """Without flat and repeated elements, and all turned the right way."""
    sides = np.stack([points[elements[:, i]] - points[elements[:, j]] for i in range(4) for j in range(i)])
    longest = np.linalg.norm(sides, axis=2).max(axis=0)
    volumes = _volumes(points, elements)
    flat = np.abs(volumes) <= _FLAT * longest**3
    if flat.all():
        raise BodyError(f"no tetrahedron of {name} has a volume; it must be a mesh of a solid")
    if flat.any():
        count = int(flat.sum())
        notes.append(f"{count} degenerate tetrahedr{'a' if count != 1 else 'on'} left out.")
    inverted = (volumes < 0.0) & ~flat
    if inverted.any():
        count = int(inverted.sum())
        notes.append(f"{count} of {elements.shape[0]} tetrahedra turned round.")
    elements = np.where(inverted[:, None], elements[:, [0, 2, 1, 3]], elements)[~flat]
    _, first = np.unique(np.sort(elements, axis=1), axis=0, return_index=True)
    if first.size < elements.shape[0]:
        notes.append(f"{elements.shape[0] - first.size} tetrahedra that repeated another left out.")
        elements = elements[np.sort(first)]
    return elements


def _piece(points: Float, elements: Ints, part: int | None, name: str, notes: list[str]) -> Ints:
    """The elements that hang together.

    Raises:
        BodyError: there are several parts and none was chosen, or not so many.
    """
    label = _together(elements, points.shape[0])[elements[:, 0]]
    found, label = np.unique(label, return_inverse=True)
    shares = np.bincount(label.ravel(), weights=_volumes(points, elements))
    ranked = np.argsort(-shares, kind="stable")
    if found.size == 1 and part is None:
        return elements
    chosen = _choice(shares[ranked] / shares.sum(), part, name)
    if found.size == 1:
        return elements
    notes.append(_left(found.size, chosen, part))
    return elements[label.ravel() == ranked[chosen]]


def _boundary(rest: Float, elements: Ints) -> Skin:
    """Faces that belong to one element only, seen from outside."""
    faces = np.concatenate([elements[:, face] for face in ([0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3])])
    _, first, times = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    outer = faces[np.sort(first[times == 1])]
    used, places = np.unique(outer, return_inverse=True)
    return Skin(
        vertices=rest[used],
        triangles=places.reshape(outer.shape),
        nodes=used[:, None],
        weights=np.ones((used.size, 1)),
    )
