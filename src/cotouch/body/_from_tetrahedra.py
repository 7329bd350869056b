"""A solid of tetrahedra, whose boundary is its skin."""

from collections.abc import Mapping, Sequence
from typing import Final

import numpy as np

from cotouch.arrays import Long
from cotouch.body import _elasticity as elasticity
from cotouch.body._assembly import MeshSource, name_of, put_together
from cotouch.body._body import Body
from cotouch.body._builders import MOST_NODES
from cotouch.body._ground import Held
from cotouch.body._lines import doubled
from cotouch.body._material import Frame
from cotouch.body._mesh_material import (
    check_material,
    frame_of_model,
    is_solid_model,
    of_tetrahedra,
    solid_models,
    warned,
)
from cotouch.body._mesh_parts import Parts, of_parts
from cotouch.body._origin import Origin
from cotouch.body._pieces import boundary_of, hinged, one_piece, volumes_of, without_broken
from cotouch.body._reading import Unit, check_indices, mesh_of, metres
from cotouch.body._rigid import moments_of_tetrahedra, rigid_solid
from cotouch.errors import BodyError

# Counted in the file before it is loaded.
MOST_ELEMENTS: Final = 500_000
# Of the volume of tetrahedra: more that the skin encloses twice is no rounding; and as much may be folded within, as
# where a mesher left a few slivers inside out.
_OVERLAP: Final = 1e-3
_FOLDED: Final = 1e-2


def body_from_tetrahedra(
    source: MeshSource,
    *,
    unit: Unit | None = None,
    model: str = "elastic",
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
    sets: Mapping[str, Sequence[int]] | None = None,
    parts: Parts | None = None,
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
            edges that turn with their ends. "rigid": see `rigid_body`.
        young: Young's modulus E [Pa], > 0.
        poisson: Poisson's ratio, above -1 (with "neo-hookean" above 0) and below 0.5; not of springs.
        stiffness: of the spring along every edge, instead of what E gives [N/m]; of springs only.
        density: [kg/m³], > 0.
        mass: of the whole body, instead of density times volume [kg].
        rayleigh_mass: α of the damping α M + β K [1/s], >= 0.
        rayleigh_stiffness: β [s], >= 0.
        ground: which nodes are held: "none", "all", a face such as "z-", a `NodesNearPlane`, a `NodesInBox` [m], a
            `NodeSet` of the file, or indices among the nodes of the body.
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        frame: of a linear body ("springs", "elastic"): "floating" (the default) turns as a whole without a force;
            "fixed" keeps K as it is: cheaper, with modes, and a turned body shrinks.
        part: which of several separate parts to take, from 1, the biggest first.
        sets: more named sets, as indices of the source's points.
        parts: by the name of a set (a physical group), what is in it: young [Pa], poisson, rayleigh_stiffness [s]; the
            rest is as said above. A tetrahedron is in it if all its corners are. Not with "rigid" or `stiffness`.
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
    name = name_of(source)
    is_solid_model(model)
    check_material(
        model,
        solid_models(),
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
    scale = metres(unit, name)
    mesh = mesh_of(source, name, "tetrahedra", most_elements)
    check_indices(mesh, name, "tetrahedra")
    notes = list(mesh.notes)
    elements = without_broken(mesh.points, mesh.elements, name, notes)
    elements = one_piece(mesh.points, elements, part, name, notes)
    loose = hinged(elements)
    if loose > 1:
        notes.append(
            f"{loose} groups of tetrahedra touch only at points or edges, as at hinges, where they can turn against "
            "each other without any force."
        )
    used, flat = np.unique(elements, return_inverse=True)
    elements = flat.reshape(elements.shape).astype(np.int64)
    unused = mesh.points.shape[0] - used.size
    if unused:
        notes.append(f"{unused} point{'s' * (unused != 1)} in no tetrahedron left out.")
    rest = mesh.points[used] * scale
    if rest.shape[0] > most_nodes:
        raise BodyError(
            f"{name} has {rest.shape[0]} nodes but the limit is {most_nodes}; make it coarser, or raise most_nodes"
        )
    volumes = volumes_of(rest, elements)
    volume = float(volumes.sum())
    skin = boundary_of(rest, elements)
    twice = doubled(skin.vertices, skin.triangles.astype(np.int64))
    # Of what is folded within, more is counted than the skin encloses.
    folded = volume - float(np.linalg.det(skin.vertices[skin.triangles]).sum()) / 6.0
    if twice > _OVERLAP * volume or folded > _FOLDED * volume:
        twice = max(twice, folded)
        raise BodyError(
            f"tetrahedra of {name} overlap in {100.0 * twice / volume:.2g} % of their volume; every place must be in "
            "one of them, so mesh the union of the parts"
        )
    if parts and (model in {"rigid", "spring-network"} or stiffness is not None):
        raise BodyError(f'parts are given, but model "{model}" has no Young\'s modulus for each part; leave one out')
    if model == "rigid":
        solid, corners = moments_of_tetrahedra(rest, elements), skin.triangles
        return rigid_solid(skin.vertices, corners, solid, density, mass, name, "tetrahedra", unit, ground, notes)
    fractions = np.bincount(elements.ravel(), weights=np.repeat(volumes, 4), minlength=rest.shape[0])
    total = density * volume if mass is None else mass
    place = np.full(mesh.points.shape[0], -1, dtype=np.int64)
    place[used] = np.arange(used.size)
    given = {**mesh.sets, **{key: np.asarray(members, dtype=np.int64) for key, members in (sets or {}).items()}}
    named: dict[str, Long] = {key: place[members][place[members] >= 0] for key, members in given.items()}
    whole = {"young": young, "poisson": poisson, "rayleigh_stiffness": rayleigh_stiffness}
    own = of_parts(parts or {}, elements, named, whole, name, model)
    springs, material = of_tetrahedra(
        rest,
        elements,
        model=model,
        young=own["young"],
        poisson=own["poisson"],
        stiffness=stiffness,
        viscosity=own["rayleigh_stiffness"],
        frame=frame,
    )
    dampers = springs * rayleigh_stiffness
    weighed = own["young"] * own["rayleigh_stiffness"]
    if parts and np.any(weighed):  # K with β E in place of E
        least = np.finfo(np.float64).tiny  # a modulus must be above 0
        dampers, _ = of_tetrahedra(
            rest,
            elements,
            model="springs" if model == "springs" else "elastic",
            young=np.maximum(weighed, least),
            poisson=own["poisson"],
            stiffness=None,
            viscosity=0.0,
            frame=frame,
        )
    edges = rest[elasticity.edges_of(elements)]
    return put_together(
        rest=rest,
        masses=total * fractions / fractions.sum(),
        springs=springs,
        dampers=dampers,
        alpha=rayleigh_mass,
        beta=rayleigh_stiffness,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        slack=0.0,
        sets=named,
        skin=skin,
        origin=Origin(
            source=name,
            kind="tetrahedra",
            model=model,
            unit=unit or "m",
            elements=volumes.size,
            volume=volume,
            size=np.ptp(rest, axis=0),
            spacing=float(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1).mean()),
        ),
        notes=[*notes, *warned(model, poisson)],
        material=material,
    )
