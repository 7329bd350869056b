"""Which nodes the ground holds, said by geometry or by name, and what is then still free."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias, final

import numpy as np

from cotouch.arrays import Float, Index
from cotouch.errors import BodyError

# Index this near to a face, beside the body's size, lie on it.
_ON = 1e-6
# A plane is held by so many nodes.
_FACE = 3
# Singular values this small beside the largest are motions that nothing holds.
_FREE = 1e-9


@final
@dataclass(frozen=True, kw_only=True)
class NodesNearPlane:
    """The nodes within `thickness` of a plane, on either side of it.

    Attributes:
        point: any point of the plane [m].
        normal: across it, of any length.
        thickness: [m]; None: half a cell of a lattice, and nothing but rounding for tetrahedra.
    """

    point: Sequence[float]
    normal: Sequence[float]
    thickness: float | None = None


@final
@dataclass(frozen=True, kw_only=True)
class NodesInBox:
    """The nodes inside a box along the axes, or on its faces.

    Attributes:
        low: its lowest corner [m].
        high: its highest corner [m].
    """

    low: Sequence[float]
    high: Sequence[float]


@final
@dataclass(frozen=True, kw_only=True)
class NodeSet:
    """The nodes of a set or physical group that the file names.

    Attributes:
        name: of the set.
    """

    name: str


@final
@dataclass(frozen=True)
class NodeNumbers:
    """Nodes by their numbers from 1, as files count them.

    Attributes:
        numbers: of the nodes.
    """

    numbers: Sequence[int]


# Which nodes the ground holds: none, all, a face of the bounding box ("x-" has the smallest x), or a place.
Held: TypeAlias = (
    Sequence[int]
    | NodeNumbers
    | Literal["none", "all", "x-", "x+", "y-", "y+", "z-", "z+"]
    | str
    | NodesNearPlane
    | NodesInBox
    | NodeSet
)


def held_nodes(ground: Held, rest: Float, *, slack: float, spacing: float, sets: Mapping[str, Index]) -> Index:
    """Indices of the nodes that `ground` means.

    Args:
        ground: see `Held`.
        rest: places of the nodes, (n, 3) [m].
        slack: default thickness of a plane [m].
        spacing: between nodes; a face that is no plane, and so holds fewer than three, is so thick [m].
        sets: nodes of every named set.

    Raises:
        BodyError: it means no node, a set or face that is not there, or is not geometry.
    """
    size = float(np.ptp(rest, axis=0).max())
    if isinstance(ground, NodesNearPlane):
        point, normal = _three("the plane's point", ground.point), _three("the plane's normal", ground.normal)
        length = float(np.linalg.norm(normal))
        if length == 0.0:
            raise BodyError("the normal of the ground's plane is 0, 0, 0; it must not be zero")
        thickness = slack if ground.thickness is None else ground.thickness
        if not (np.isfinite(thickness) and thickness >= 0.0):
            raise BodyError(f"the thickness of the ground's plane is {thickness}; it must be at least 0 m")
        distance = np.abs((rest - point) @ (normal / length))
        found = np.flatnonzero(distance <= thickness + _ON * size)
        return _some(
            found,
            f"the plane holds no node: the nearest is {distance.min():.4g} m away, thickness is {thickness:.4g} m",
        )
    if isinstance(ground, NodesInBox):
        low, high = _three("the box's low", ground.low), _three("the box's high", ground.high)
        if np.any(low > high):
            raise BodyError(f"the ground's box is from {low.tolist()} to {high.tolist()}; low must not be above high")
        found = np.flatnonzero(np.all((rest >= low - _ON * size) & (rest <= high + _ON * size), axis=1))
        reach = f"{_places(rest.min(axis=0))} to {_places(rest.max(axis=0))}"
        return _some(found, f"the ground's box holds no node; the nodes lie from {reach} m")
    if isinstance(ground, NodeSet):
        if ground.name not in sets:
            known = ", ".join(f'"{name}"' for name in sets) or "none"
            raise BodyError(f'the ground is the set "{ground.name}"; the sets of this mesh are: {known}')
        return _some(sets[ground.name], f'the set "{ground.name}" holds no node of the body')
    if isinstance(ground, str):
        if ground in {"none", "all"}:
            return np.arange(rest.shape[0] if ground == "all" else 0)
        axis = "xyz".find(ground[:1])
        if len(ground) == 2 and axis >= 0 and ground[1] in "-+":
            along = rest[:, axis] if ground[1] == "-" else -rest[:, axis]
            found = np.flatnonzero(along <= along.min() + _ON * size)
            return found if found.size >= _FACE else np.flatnonzero(along <= along.min() + spacing)
        raise BodyError(
            f'ground is "{ground}"; it must be "none", "all", a face "x-", "x+", "y-", "y+", "z-", "z+", '
            "a plane, a box, a named set, or node indices"
        )
    return np.unique(indices_of(ground, rest.shape[0]))


def indices_of(ground: Sequence[int] | NodeNumbers, count: int) -> Index:
    """Indices of nodes that are named one by one; a message counts them as whoever named them does.

    Args:
        ground: indices, or numbers from 1.
        count: nodes of the body.

    Raises:
        BodyError: one is no whole number, or not there.
    """
    first, what, named = (1, "", ground.numbers) if isinstance(ground, NodeNumbers) else (0, "index ", ground)
    for node in named:
        if node != int(node):
            raise BodyError(f"ground is {list(named)}; it must hold whole numbers, the indices of nodes")
        if not first <= node < first + count:
            raise BodyError(f"ground names node {what}{node}; this body has nodes {first} to {first + count - 1}")
    return np.asarray(list(named), dtype=np.intp) - first


def rounded_face(ground: Held, rest: Float, held: Index) -> str | None:
    """What to say where a face of the body is no plane, so that a layer of nodes is held in its place.

    Args:
        ground: as given.
        rest: places of the nodes, (n, 3) [m].
        held: the nodes that it means.
    """
    axis = "xyz".find(ground[:1]) if isinstance(ground, str) and ground not in {"none", "all"} else -1
    deep = float(np.ptp(rest[held, axis])) if axis >= 0 else 0.0
    if deep <= _ON * float(np.ptp(rest, axis=0).max()):
        return None
    return f'The face "{ground}" is not flat: the {held.size} nodes within {deep:.3g} m of it are held.'


def free_motions(rest: Float, held: Index, *, turning: bool) -> int:
    """How many rigid motions the ground leaves free: of 6, or of the 3 shifts where turning is not free by itself.

    Args:
        rest: (n, 3) places at rest [m].
        held: nodes that the ground holds.
        turning: whether turns are free by themselves.
    """
    if held.size == 0:
        return 6 if turning else 3
    if not turning:
        return 0
    arm = rest[held] - rest[held].mean(axis=0)
    size = max(float(np.ptp(rest, axis=0).max()), 1e-300)
    turns = [np.cross(np.eye(3)[axis], arm / size) for axis in range(3)]
    motions = [np.broadcast_to(np.eye(3)[axis], arm.shape) for axis in range(3)] + turns
    values = np.linalg.svd(np.stack([motion.ravel() for motion in motions]), compute_uv=False)
    return 6 - int(np.count_nonzero(values > _FREE * values.max()))


def _three(name: str, values: Sequence[float]) -> Float:
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        array = np.zeros(0)
    if array.shape != (3,) or not np.isfinite(array).all():
        raise BodyError(f"{name} is {values}; it must be three finite numbers")
    return array


def _places(point: Float) -> str:
    return "(" + ", ".join(f"{value:.4g}" for value in point) + ")"


def _some(found: Index, otherwise: str) -> Index:
    if found.size == 0:
        raise BodyError(otherwise)
    return np.asarray(found, dtype=np.intp)
