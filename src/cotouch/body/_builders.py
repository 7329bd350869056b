"""Bodies from a few numbers: a point, a chain, a lattice."""

from collections.abc import Sequence
from math import prod
from typing import Final, Literal, TypeAlias, get_args

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Long
from cotouch.body._body import Body
from cotouch.body._checks import at_least_zero, one_number
from cotouch.body._elasticity import cubes_of, laplacian_of, springs_of_cells
from cotouch.body._ground import NodeNumbers, indices_of
from cotouch.body._material import Frame, Material, linear_material
from cotouch.body._shapes import box_surface
from cotouch.body._skin import Skin
from cotouch.errors import BodyError

# Which nodes the ground holds: a list of node indices, all, or the faces of the box ("x-" has the smallest x).
Ground: TypeAlias = Sequence[int] | NodeNumbers | Literal["none", "all", "x-", "x+", "y-", "y+", "z-", "z+"]

GridModel: TypeAlias = Literal["springs", "cells", "spring-network"]

# A step of a node costs about 0.2 µs, so that more is far from any haptic rate.
MOST_NODES: Final = 100_000
_REACH = {6: 1, 18: 2, 26: 3}  # how many coordinates two neighbours may differ in


def point(
    *,
    mass: float = 1.0,
    damping: float = 0.0,
    stiffness: float = 0.0,
    rest: float | Sequence[float] = 0.0,
) -> Body:
    """One node, held to the ground by a damper and a spring.

    Args:
        mass: [kg], > 0.
        damping: to the ground [Ns/m], >= 0.
        stiffness: to the ground [N/m], >= 0.
        rest: where the spring is relaxed, a number or 1 to 3 coordinates [m].

    Raises:
        BodyError: a value is not finite or out of its range.
    """
    one_number("mass", mass)
    at_least_zero(damping=damping, stiffness=stiffness)
    return Body(
        mass=[[mass]],
        rest=[np.atleast_1d(rest)],
        damping_ext=[[damping]],
        stiffness_ext=[[stiffness]],
    )


def chain(
    nodes: int,
    *,
    mass: float = 1.0,
    stiffness: float = 100.0,
    damping: float = 0.0,
    spacing: float = 0.01,
    dimension: int = 1,
    ground: Ground = "none",
    ground_stiffness: float = 0.0,
    ground_damping: float = 0.0,
    model: GridModel = "springs",
    frame: Frame = "fixed",
    most_nodes: int = MOST_NODES,
) -> Body:
    """Nodes along x, each joined to the next.

    Args:
        nodes: how many, >= 1.
        mass: of the whole body, shared equally [kg].
        stiffness: of each spring between neighbours [N/m].
        damping: of each damper between neighbours [Ns/m].
        spacing: between neighbours at rest [m].
        dimension: number of axes, 1 to 3.
        ground: which nodes are held: indices, "none", "all", or a face such as "x-".
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        model: "springs", or "spring-network": a rope; see `lattice`.
        frame: see `lattice`.
        most_nodes: see `lattice`.

    Raises:
        BodyError: a value is out of its range.
    """
    if dimension not in {1, 2, 3}:
        raise BodyError(f"dimension is {dimension}; it must be 1, 2 or 3")
    return lattice(
        (nodes, 1, 1)[:dimension],
        mass=mass,
        stiffness=stiffness,
        damping=damping,
        spacing=spacing,
        ground=ground,
        ground_stiffness=ground_stiffness,
        ground_damping=ground_damping,
        model=model,
        frame=frame,
        most_nodes=most_nodes,
    )


def lattice(
    shape: Sequence[int],
    *,
    neighbours: Literal[6, 18, 26] = 6,
    mass: float = 1.0,
    stiffness: float = 100.0,
    damping: float = 0.0,
    spacing: float = 0.01,
    ground: Ground = "none",
    ground_stiffness: float = 0.0,
    ground_damping: float = 0.0,
    model: GridModel = "springs",
    frame: Frame = "fixed",
    most_nodes: int = MOST_NODES,
) -> Body:
    """A box of nodes on a regular grid, each joined to its 6, 18 or 26 neighbours (fewer axes: the same rule).

    Node (a, b, c) has index `(a * shape[1] + b) * shape[2] + c`; the grid starts at the origin.

    Args:
        shape: number of nodes along each of 1 to 3 axes.
        neighbours: 6 (along the axes), 18 (and across faces) or 26 (and across the cube).
        mass: of the whole body, shared equally [kg].
        stiffness: of each spring [N/m]; the force is along the displacement, so weights stay scalar per node.
        damping: of each damper [Ns/m].
        spacing: of the grid [m].
        ground: which nodes are held: indices, "none", "all", or a face such as "z-".
        ground_stiffness: of each held node [N/m].
        ground_damping: of each held node [Ns/m].
        model: "springs": linear, and turning the body costs energy. "cells": cubes that turn, for bodies that bend far;
            6 neighbours, and each cube gives a quarter of `stiffness` to its edges. "spring-network": springs that turn
            with their ends; 18 or 26 neighbours, or nothing resists shear.
        frame: "floating": the linear body turns as a whole without a force.
        most_nodes: refuse more than this.

    Raises:
        BodyError: a value is out of its range.
    """
    extents = tuple(int(extent) if float(extent).is_integer() else 0 for extent in shape)
    if not 1 <= len(extents) <= 3 or min(extents) < 1:
        raise BodyError(f"the lattice's shape is {tuple(shape)}; it must be 1 to 3 whole numbers of at least 1")
    if prod(extents) > most_nodes:
        made = f"{' x '.join(map(str, extents))} make" if len(extents) > 1 else "that is"
        raise BodyError(
            f"{made} {prod(extents)} nodes, but the limit is {most_nodes}; make it coarser, or raise most_nodes"
        )
    if neighbours not in _REACH:
        raise BodyError(f"neighbours is {neighbours}; it must be 6, 18 or 26")
    one_number("mass", mass)
    if not (np.isfinite(one_number("spacing", spacing)) and spacing > 0.0):
        raise BodyError(f"spacing is {spacing}; it must be more than 0 m")
    at_least_zero(
        stiffness=stiffness, damping=damping, ground_stiffness=ground_stiffness, ground_damping=ground_damping
    )
    count = prod(extents)
    grid = np.stack(np.meshgrid(*[np.arange(extent) for extent in extents], indexing="ij"), axis=-1)
    places = grid.reshape(count, len(extents))
    laplacian = _laplacian(places, extents, _REACH[neighbours])
    held = np.zeros(count)
    held[_held(ground, places, extents)] = 1.0
    rest = places * spacing
    material, springs = _grid_material(
        extents, neighbours, laplacian * stiffness, stiffness=stiffness, damping=damping, wish=(model, frame)
    )
    return Body(
        mass=sp.diags_array(np.full(count, mass / count)),
        rest=rest,
        damping_int=laplacian * damping,
        damping_ext=sp.diags_array(held * ground_damping),
        stiffness_int=springs,
        stiffness_ext=sp.diags_array(held * ground_stiffness),
        skin=_box_skin(places, extents, spacing) if len(extents) == 3 and sorted(extents)[1] > 1 else None,
        material=material,
    )


def _grid_material(
    extents: tuple[int, ...],
    neighbours: int,
    springs: sp.csr_array,
    *,
    stiffness: float,
    damping: float,
    wish: tuple[str, str],
) -> tuple[Material | None, sp.csr_array]:
    """The material of a grid, and its K at rest."""
    model, frame = wish
    if model not in get_args(GridModel):
        raise BodyError(f'model is "{model}"; a grid has one of {", ".join(get_args(GridModel))}')
    if model == "springs":
        return linear_material(frame), springs
    if frame != "fixed":
        raise BodyError(f'frame is "{frame}", but model "{model}" turns by itself; leave frame out')
    if stiffness == 0.0:
        raise BodyError(f'stiffness is 0; model "{model}" needs more than 0 N/m')
    if model == "cells":
        if len(extents) != 3 or min(extents) < 2 or neighbours != 6:
            raise BodyError(
                f'shape is {extents} with {neighbours} neighbours; model "cells" needs at least 2 nodes along each of '
                "3 axes, and 6 neighbours"
            )
        cubes = cubes_of(extents)
        full = np.ones(cubes.shape[0])
        return (
            Material(model="cells", elements=cubes, stiffness=full * stiffness, viscosity=damping / stiffness),
            springs_of_cells(int(np.prod(extents)), cubes, full, stiffness=stiffness),
        )
    wide = sum(extent > 1 for extent in extents)
    if wide > 1 and neighbours == 6:
        raise BodyError('neighbours is 6; model "spring-network" needs 18 or 26, or nothing resists shear')
    upper = sp.coo_array(sp.triu(springs, k=1))
    return (
        Material(
            model="spring-network",
            elements=np.stack([upper.row, upper.col], axis=1).astype(np.int64),
            stiffness=-upper.data,
            viscosity=damping / stiffness,
        ),
        springs,
    )


def _box_skin(places: Long, extents: tuple[int, ...], spacing: float) -> Skin:
    """The faces of a box of nodes, two triangles to a square; of a sheet, which is felt from both sides, one layer."""
    vertices, triangles = box_surface(np.array(extents) - 1)
    index = np.asarray(np.ravel_multi_index(tuple(vertices.astype(np.int64).T), extents))
    return Skin(
        vertices=places[index] * spacing,
        triangles=triangles,
        nodes=index[:, None],
        weights=np.ones((index.size, 1)),
    )


def _laplacian(places: Long, extents: tuple[int, ...], reach: int) -> sp.csr_array:
    """Unit-weight Laplacian of the grid; neighbours differ by at most 1 on each axis and on at most `reach` axes."""
    pairs = [np.zeros((0, 2), np.int64)]
    for offset in np.ndindex(*(3,) * len(extents)):
        move = np.array(offset) - 1
        first = next((step for step in move if step), 0)
        if first <= 0 or np.count_nonzero(move) > reach:  # each pair once: the first change is upwards
            continue
        target = places + move
        inside = np.flatnonzero(np.all((target >= 0) & (target < extents), axis=1))
        pairs.append(np.stack([inside, np.ravel_multi_index(tuple(target[inside].T), extents)], axis=1))
    edges = np.concatenate(pairs)
    return laplacian_of(places.shape[0], edges, np.ones(len(edges)))


def _held(ground: Ground, places: Long, extents: tuple[int, ...]) -> npt.NDArray[np.intp]:
    count = places.shape[0]
    if isinstance(ground, str):
        if ground in {"none", "all"}:
            return np.arange(count if ground == "all" else 0)
        axis = "xyz".find(ground[:1])
        if len(ground) == 2 and 0 <= axis < len(extents) and ground[1] in "-+":
            return np.flatnonzero(places[:, axis] == (0 if ground[1] == "-" else extents[axis] - 1))
        faces = ", ".join(f'"{name}-", "{name}+"' for name in "xyz"[: len(extents)])
        raise BodyError(f'ground is "{ground}"; it must be node indices, "none", "all" or a face: {faces}')
    return indices_of(ground, count)
