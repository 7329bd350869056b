"""Several bodies in a recording: each as one of its own, where it is, and what they do to each other."""

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body, Part, joined

if TYPE_CHECKING:  # reading a recording needs no kernels
    from cotouch.mechanics import Between

_TURN, _SHIFT, _REST, _BETWEEN = "part_turn", "part_shift", "rest", "between"
# A recording has no more bodies, and a rotation is off by no more.
_MOST, _ROUNDING = 1000, 1e-9


def parts_arrays(body: Body, between: "Between | None", own: Callable[[Body], dict[str, Any]]) -> dict[str, Any]:
    """Several bodies by name.

    Args:
        body: of several.
        between: what they do to each other; None: there is one.
        own: gives all of one body by name.
    """
    found: dict[str, Any] = {
        _TURN: np.array([part.turn for part in body.parts]),
        _SHIFT: np.array([part.shift for part in body.parts]),
    }
    if between is not None:
        kinetic = between.friction if between.kinetic is None else between.kinetic
        found[_BETWEEN] = np.array([between.stiffness, between.loss, between.friction, kinetic, between.own])
    for number, part in enumerate(body.parts):
        one = part.body if part.body.material is not None else part.body.with_gravity((0.0, 0.0, 0.0))
        found |= {f"part{number}_{name}": values for name, values in own(one).items()}
        found[f"part{number}_{_REST}"] = part.body.rest
    return found


def parts_of_arrays(
    arrays: Mapping[str, Any], one: Callable[[dict[str, Any], Float], Body]
) -> "tuple[Body, Between | None]":
    """The inverse of `parts_arrays`.

    Args:
        arrays: by name; nothing of them is believed.
        one: makes one body of its arrays and its shape at rest.

    Raises:
        ValueError: they are of no bodies.
        BodyError: of wrong ones.
    """
    from cotouch.mechanics import Between

    turns, shifts = (np.asarray(arrays[name], dtype=np.float64) for name in (_TURN, _SHIFT))
    count = turns.shape[0]
    if turns.shape != (count, 3, 3) or shifts.shape != (count, 3) or not 1 <= count <= _MOST:
        raise ValueError(f"parts are placed by arrays of {turns.shape} and {shifts.shape}")
    if not (np.abs(turns @ turns.transpose(0, 2, 1) - np.eye(3)) <= _ROUNDING).all() or not np.isfinite(shifts).all():
        raise ValueError("a part is turned by what is no rotation")
    parts: list[Part] = []
    first = 0
    for number, (turn, shift) in enumerate(zip(turns, shifts, strict=True)):
        prefix = f"part{number}_"
        own = {name.removeprefix(prefix): values for name, values in arrays.items() if name.startswith(prefix)}
        body = one(own, np.asarray(own.pop(_REST), dtype=np.float64))
        if body.dimension != 3 or body.skin is None or body.parts:
            raise ValueError(f"part {number + 1} is no solid with a skin")
        parts.append(Part(name=str(number + 1), body=body, first=first, turn=turn, shift=shift))
        first += body.nodes
    if _BETWEEN not in arrays:
        return joined(parts), None
    stiffness, loss, friction, kinetic, own = map(float, np.asarray(arrays[_BETWEEN], dtype=np.float64).ravel())
    between = Between(stiffness=stiffness, loss=loss, friction=friction, kinetic=kinetic, own=own != 0.0)
    return joined(parts), between
