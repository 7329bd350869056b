"""Stiffness at rest and material of bodies from meshes, for each model that a builder knows."""

from typing import Final, Literal, TypeAlias, get_args

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float, Long
from cotouch.body import _elasticity as elasticity
from cotouch.body._cells import Cells
from cotouch.body._checks import at_least_zero, one_number
from cotouch.body._material import GROUP, Frame, Material, is_solid_law, least_poisson, linear_material, solid_laws
from cotouch.errors import BodyError
from cotouch.installed import installed_names

# What follows K and B as they are, in a frame; and with what turns by itself.
LinearModel: TypeAlias = Literal["springs", "elastic"]
SurfaceModel: TypeAlias = Literal["springs", "elastic", "cells", "spring-network", "rigid"]
# Those that take springs' stiffness.
_OF_SPRINGS: Final = ("springs", "cells", "spring-network")
# Above this Poisson's ratio linear elements lock: they turn out much too stiff.
_LOCKS: Final = 0.45
# Of tetrahedra, besides the laws of their own.
_SOLID_MODELS: Final = ("springs", "elastic", "spring-network", "rigid")
# Springs along edges and across faces of cubes have this share of E h [N/m]; see `network_of_cells`.
_NETWORK: Final = 0.4


def solid_models() -> tuple[str, ...]:
    """Names of models of a mesh of tetrahedra, with those that installed packages bring."""
    return tuple(dict.fromkeys([*_SOLID_MODELS[:-1], *solid_laws(), *installed_names(GROUP), *_SOLID_MODELS[-1:]]))


def is_solid_model(name: str) -> bool:
    """Whether a mesh of tetrahedra can have a model; one of an installed package is loaded.

    Args:
        name: of the model.
    """
    return name in _SOLID_MODELS or is_solid_law(name)


def of_cells(
    cells: Cells,
    corners: Long,
    nodes: int,
    *,
    model: SurfaceModel,
    young: float,
    poisson: float,
    stiffness: float | None,
    viscosity: float,
    frame: Frame,
) -> tuple[sp.csr_array, Material | None]:
    """K and material of a lattice inside a surface; see `body_from_surface`.

    Args:
        cells: of the lattice.
        corners: (C, 8) nodes of each cube, in the order of `CORNERS`.
        nodes: how many.
        model: name of the material.
        young: Young's modulus [Pa].
        poisson: Poisson's ratio.
        stiffness: of one spring [N/m]; None: as the modulus says.
        viscosity: of the damping that goes with stiffness [s].
        frame: "fixed" or "floating".
    """
    if model == "elastic":
        inner = elasticity.elastic_cells(
            nodes, corners, cells.fill, spacing=cells.spacing, young=young, poisson=poisson
        )
        return inner, linear_material(frame)
    fraction = _NETWORK if model == "spring-network" else 1.0
    spring = fraction * young * cells.spacing if stiffness is None else stiffness
    if model == "spring-network":
        edges, strength = elasticity.network_of_cells(corners, cells.fill, stiffness=spring)
        material = Material(model=model, elements=edges, stiffness=strength, viscosity=viscosity)
        return elasticity.laplacian_of(nodes, edges, strength), material
    inner = elasticity.springs_of_cells(nodes, corners, cells.fill, stiffness=spring)
    if model == "cells":
        own = spring * cells.fill
        return inner, Material(model=model, elements=corners, stiffness=own, viscosity=viscosity)
    return inner, linear_material(frame)


def of_tetrahedra(
    rest: Float,
    elements: Long,
    *,
    model: str,
    young: float | Float,
    poisson: float | Float,
    stiffness: float | None,
    viscosity: float | Float,
    frame: Frame,
) -> tuple[sp.csr_array, Material | None]:
    """K and material of a solid of tetrahedra; see `body_from_tetrahedra`.

    Args:
        rest: (n, 3) places at rest [m].
        elements: (E, 4) indices of points.
        model: name of the material.
        young: Young's modulus [Pa].
        poisson: Poisson's ratio.
        stiffness: of one spring [N/m]; None: as the modulus says.
        viscosity: of the damping that goes with stiffness [s].
        frame: "fixed" or "floating".
    """
    nodes = rest.shape[0]
    if model == "spring-network":
        if stiffness is None:
            raise BodyError('stiffness is not given; model "spring-network" of tetrahedra needs that of an edge [N/m]')
        edges = elasticity.edges_of(elements)
        strength = np.full(edges.shape[0], stiffness)
        material = Material(model=model, elements=edges, stiffness=strength, viscosity=viscosity)
        return elasticity.laplacian_of(nodes, edges, strength), material
    if model == "springs":
        if stiffness is None:
            return elasticity.springs_of_tetrahedra(rest, elements, young=young), linear_material(frame)
        return elasticity.springs_along_edges(nodes, elements, stiffness=stiffness), linear_material(frame)
    inner = elasticity.elastic_tetrahedra(rest, elements, young=young, poisson=poisson)
    if model == "elastic":
        return inner, linear_material(frame)
    outwards = np.linalg.det(rest[elements[:, 1:]] - rest[elements[:, :1]]) > 0.0
    turned = np.where(outwards[:, None], elements, elements[:, [0, 1, 3, 2]])
    material = Material(model=model, elements=turned, young=young, poisson=poisson, viscosity=viscosity)
    return inner, material


def frame_of_model(model: str, frame: Frame | None) -> Frame:
    """The frame of a body from a mesh: what is linear turns as a whole, unless another is asked for.

    Args:
        model: name of the material.
        frame: that is asked for; None: none.
    """
    if frame is not None:
        return frame
    return "floating" if model in get_args(LinearModel) else "fixed"


def check_material(
    model: str,
    known: tuple[str, ...],
    *,
    young: float,
    poisson: float,
    stiffness: float | None,
    density: float,
    mass: float | None,
    rayleigh_mass: float,
    rayleigh_stiffness: float,
    frame: str | None,
) -> None:
    """Whether the values are in their ranges and fit each other.

    Args:
        model: name of the material.
        known: names of materials that there are.
        young: Young's modulus [Pa].
        poisson: Poisson's ratio.
        stiffness: of one spring [N/m]; None: as the modulus says.
        density: [kg/m³].
        mass: of the whole body [kg]; None: from the density.
        rayleigh_mass: share of M in the damping [1/s].
        rayleigh_stiffness: share of K in the damping [s].
        frame: "fixed" or "floating"; None: as the model has it.

    Raises:
        BodyError: one is not, or does not.
    """
    if model not in known:
        raise BodyError(f'model is "{model}"; it must be one of {", ".join(known)}')
    if frame is not None and frame not in get_args(Frame):
        raise BodyError(f'frame is "{frame}"; it must be "fixed" or "floating"')
    if frame == "floating" and model not in get_args(LinearModel):
        raise BodyError(f'frame is "{frame}", but model "{model}" turns by itself; leave frame out')
    for label, value, unit in (
        ("young", young, "Pa"),
        ("density", density, "kg/m³"),
        ("mass", mass, "kg"),
        ("stiffness", stiffness, "N/m"),
    ):
        if value is not None and not (np.isfinite(one_number(label, value)) and value > 0.0):
            raise BodyError(f"{label} is {value}; it must be more than 0 {unit}")
    if stiffness is not None and model not in _OF_SPRINGS:
        raise BodyError(f'stiffness is {stiffness}, but model is "{model}"; give young and poisson, or model "springs"')
    one_number("poisson", poisson)
    least = least_poisson(model)
    if not least < poisson < 0.5:
        only = f'with model "{model}" ' if least > -1.0 else ""
        raise BodyError(f"poisson is {poisson}; {only}it must be above {least:g} and below 0.5")
    at_least_zero(rayleigh_mass=rayleigh_mass, rayleigh_stiffness=rayleigh_stiffness)


def warned(model: str, poisson: float) -> list[str]:
    """What should be known of the material.

    Args:
        model: name of the material.
        poisson: Poisson's ratio.
    """
    if model not in _OF_SPRINGS and poisson > _LOCKS:
        return [f"Poisson's ratio {poisson:g}: this close to 0.5, linear elements are too stiff."]
    return []
