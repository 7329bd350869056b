"""Several bodies in a recording: each as one of its own, where it is, and what they do to each other."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.body import Body, Part, ToolBody, joined
from cotouch.mechanics import Between, Solid

_TURN, _SHIFT, _REST, _BETWEEN = "part_turn", "part_shift", "rest", "between"
# Of tools: whose each is, from 1, in how many copies it is one, and where it is held; all 0 of what is shared.
_TOOL, _GRIPS = "part_tool", "grips"
# A recording has no more bodies, and a rotation is off by no more.
_MOST, _ROUNDING = 1000, 1e-9


def parts_arrays(body: Body, between: Between | None, own: Callable[[Body], dict[str, Array]]) -> dict[str, Array]:
    """Several bodies by name.

    Args:
        body: of several.
        between: what they do to each other; None: there is one.
        own: gives all of one body by name.
    """
    found: dict[str, Array] = {
        _TURN: np.array([part.turn for part in body.parts]),
        _SHIFT: np.array([part.shift for part in body.parts]),
    }
    if between is not None:
        kinetic = between.friction if between.kinetic is None else between.kinetic
        found[_BETWEEN] = np.array([between.stiffness, between.loss, between.friction, kinetic, between.own])
    if body.tools:
        owners = [(0, 0) if part.tool is None else (part.tool.owner + 1, part.tool.copies) for part in body.parts]
        found[_TOOL] = np.array(owners)
    for number, part in enumerate(body.parts):
        if part.tool is not None:
            found[f"part{number}_{_GRIPS}"] = np.array(part.tool.grips).reshape(-1, 3)
        one = part.body if part.body.material is not None else part.body.with_gravity((0.0, 0.0, 0.0))
        found |= {f"part{number}_{name}": values for name, values in own(one).items()}
        found[f"part{number}_{_REST}"] = part.body.rest
    return found


def parts_of_arrays(
    arrays: Mapping[str, Array], one: Callable[[dict[str, Array], Float], Body]
) -> tuple[Body, Between | None]:
    """The inverse of `parts_arrays`.

    Args:
        arrays: by name; nothing of them is believed.
        one: makes one body of its arrays and its shape at rest.

    Raises:
        ValueError: they are of no bodies.
        BodyError: of wrong ones.
    """
    turns, shifts = (np.asarray(arrays[name], dtype=np.float64) for name in (_TURN, _SHIFT))
    count = turns.shape[0]
    if turns.shape != (count, 3, 3) or shifts.shape != (count, 3) or not 1 <= count <= _MOST:
        raise ValueError(f"the placements of parts have shapes {turns.shape} and {shifts.shape}")
    if not (np.abs(turns @ turns.transpose(0, 2, 1) - np.eye(3)) <= _ROUNDING).all() or not np.isfinite(shifts).all():
        raise ValueError("the orientation of a part is not a rotation")
    parts: list[Part] = []
    first = 0
    owners = np.asarray(arrays.get(_TOOL, np.zeros((count, 2), dtype=int)), dtype=np.int64)
    if owners.shape != (count, 2) or owners.min() < 0 or np.any((owners[:, 0] == 0) != (owners[:, 1] == 0)):
        raise ValueError(f"the owners of tools have shape {owners.shape}")
    if np.any(np.diff(owners[:, 0] > 0, append=True) < 0):
        raise ValueError("a tool precedes a shared part")
    for number, (turn, shift) in enumerate(zip(turns, shifts, strict=True)):
        prefix = f"part{number}_"
        own = {name.removeprefix(prefix): values for name, values in arrays.items() if name.startswith(prefix)}
        grips = np.asarray(own.pop(_GRIPS, np.zeros((0, 3))), dtype=np.float64).reshape(-1, 3)
        body = one(own, np.asarray(own.pop(_REST), dtype=np.float64))
        if body.dimension != 3 or body.skin is None or body.parts:
            raise ValueError(f"part {number + 1} is not a solid with a skin")
        if not np.isfinite(grips).all():
            raise ValueError(f"part {number + 1} is held at a place that does not exist")
        owner, copies = owners[number].tolist()
        held = tuple(map(tuple, grips.tolist()))
        tool = ToolBody(owner=owner - 1, copies=copies, grips=held) if owner else None
        parts.append(Part(name=str(number + 1), body=body, first=first, turn=turn, shift=shift, tool=tool))
        first += body.nodes
    if _BETWEEN not in arrays:
        return joined(parts), None
    stiffness, loss, friction, kinetic, own = map(float, np.asarray(arrays[_BETWEEN], dtype=np.float64).ravel())
    between = Between(stiffness=stiffness, loss=loss, friction=friction, kinetic=kinetic, own=own != 0.0)
    return joined(parts), between


NAMES = ("vertices", "triangles", "ends")


def solid_arrays(solids: Sequence[Solid]) -> dict[str, Array]:
    """Some solids by name: vertices and triangles of all, and where those of each end, (solids, 2); none: nothing.

    Args:
        solids: one after the other.
    """
    if not solids:
        return {}
    sizes = [(solid.vertices.shape[0], solid.triangles.shape[0]) for solid in solids]
    places = np.concatenate([solid.vertices for solid in solids])
    corners = np.concatenate([solid.triangles for solid in solids])
    return dict(zip(NAMES, (places, corners, np.cumsum(sizes, axis=0)), strict=True))


def solids_of_arrays(arrays: Mapping[str, Array]) -> list[Solid]:
    """The inverse of `solid_arrays`.

    Args:
        arrays: by name; nothing of them is believed.

    Raises:
        BodyError: one is no closed surface.
        ValueError: they are of no solids.
    """
    if "ends" not in arrays:
        return []
    places, corners, ends = (np.asarray(arrays[name]) for name in NAMES)
    begins = np.concatenate([[[0, 0]], ends[:-1]])
    if ends.ndim != 2 or ends.shape[1] != 2 or (ends < begins).any() or begins.size > 2 * _MOST_SOLIDS:
        raise ValueError(f"solids end at {ends.tolist()[:3]}")
    return [Solid(places[v:w], corners[f:g]) for (v, f), (w, g) in zip(begins, ends, strict=True)]


# A recording has no more solids.
_MOST_SOLIDS = 100
