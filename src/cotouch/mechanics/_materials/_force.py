# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""What a body force is: energy, mean force and damping of a body that turns or bends far, one file for each law."""
# An overload's parameters only name those of its stub, and it returns a function whose names are the same.
# ruff: noqa: ARG001, ARG005, PLW0108
# pyright: reportMissingParameterType=false, reportAttributeAccessIssue=false, reportUnusedFunction=false

from collections.abc import Callable
from copy import deepcopy
from typing import Any, NamedTuple

from numba.core import types
from numba.extending import overload

from cotouch.arrays import Float, Long
from cotouch.mechanics._materials import _cells as cells
from cotouch.mechanics._materials import _frame as frame
from cotouch.mechanics._materials import _rigid as rigid
from cotouch.mechanics._materials import _springs as springs
from cotouch.mechanics._materials import _tetrahedra as tetrahedra
from cotouch.mechanics._materials._call import (
    begin_one,
    call_evaluate,
    call_lean,
    call_resist,
    called,
    make_ready,
    no_lean,
    undo_one,
)
from cotouch.mechanics._meeting._bodies import Parts
from cotouch.mechanics._meeting._world import World
from cotouch.passing import by_address


class BodyForce(NamedTuple):
    """The forces inside a body, and its weight.

    A *law* is a NamedTuple of numbers and arrays that all copies share, and two compiled functions. Positions are
    displacements from rest, (rows, 4). What a law remembers of a copy (rotations) is in the copy's `memory`. A step
    calls these functions by address, so that its machine code is the same for all laws.

    * `resist(law, memory, x, ahead, rate, out, lanes)` adds to `out` the mean force between two places,
      `F̄ · (ahead - x) = U(ahead) - U(x)` exactly or to third order, and the damping `B* rate`. With `ahead = x` and no
      rate that is the gradient of U.
    * `evaluate(law, memory, x, ahead, rate, sweeps, lanes)` returns U(ahead), whatever rotations it finds in so many
      sweeps and keeps, and the power `rateᵀ B* rate >= 0`.

    The direction of a step comes from the stiffness of the `Operator`, a constant that bounds the law's Hessian. A
    body of few rows takes the law's own tangent, which one more function, in `LEANS`, adds to `out`:
    `lean(law, memory, x, ahead, rate, T, out, lanes)`.

    Attributes:
        law: where kernels find the law and its functions; see `following`.
        places: of the rows at rest, about their middle, (rows, 4) [m].
        gravity: acceleration of each row, (rows, 4) [m/s²]; a tool among the bodies has none.
        directions: how often a step looks where its force leads before it moves, >= 1.
        grain: energy that the rounding of places alone makes, of the whole body [J].
        rounding: of places as far from the middle as the body at rest reaches [m].
        world: what the body's skin meets; None: nothing.
        parts: each body's share in the balance, of several; None: there is one.
        behind: where in a copy's memory begins what is not the law's: of the world, and which elements were cut; 0:
            nothing.
        cut: where in it the number of elements is that were cut; negative: none can be.
        table: the law, one of `LAWS`; kernels know it by `law` only.
    """

    law: Long
    places: Float
    gravity: Float
    directions: int
    grain: float
    rounding: float
    world: World | None = None
    behind: int = 0
    cut: int = -1
    parts: Parts | None = None
    table: Any = None

    def following(self, table: Any) -> "BodyForce":
        """The same with another law.

        Args:
            table: one of `LAWS`.
        """
        return self._replace(law=called(table), table=table)

    def __deepcopy__(self, memory: dict[int, Any]) -> "BodyForce":
        made = self._make(deepcopy(tuple(self), memory))
        return made.following(made.table)

    def __reduce__(self) -> tuple[Callable[..., "BodyForce"], tuple[Any, ...]]:
        return _again, tuple(self)


def _again(*fields: Any) -> BodyForce:
    made = BodyForce._make(fields)
    return made.following(made.table)


# The registry: a law, what adds its forces, and what evaluates it.
LAWS: dict[type, tuple[Callable[..., Any], Callable[..., Any]]] = {
    springs.SpringNetwork: (springs.resist, springs.evaluate),
    cells.CorotatedCells: (cells.resist, cells.evaluate),
    frame.FramedBody: (frame.resist, frame.evaluate),
    rigid.Rigid: (rigid.resist, rigid.evaluate),
    **{solid.kind: (tetrahedra.resist, tetrahedra.evaluate) for solid in tetrahedra.SOLIDS.values()},
}
LEANS: dict[type, Callable[..., Any]] = {rigid.Rigid: rigid.lean}
# What sets the rotations of all bodies to none, and what takes them back, where they are several.
STARTS: dict[type, tuple[Callable[..., Any], Callable[..., Any]]] = {}


def _ready(kind: Any) -> None:
    """Compiles a law's functions, or finds them compiled, before a step calls them by address."""
    law = getattr(kind, "instance_class", None)
    if law not in LAWS:
        raise TypeError(f"{kind} is no law of a body: register it in LAWS")
    make_ready(kind, *LAWS[law], LEANS.get(law, no_lean), *STARTS.get(law, (begin_one, undo_one)))


by_address(BodyForce, unseen="table", told=_ready)


def resist(law: Any, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]) -> None:
    """Adds mean force and damping of any law; see `BodyForce`. Kernels only.

    Args:
        law: of a `BodyForce`, or one of `LAWS`.
        memory: what it remembers of the copy, in place.
        x: displacements from rest, (rows, 4) [m].
        ahead: where the step ends [m].
        rate: mean velocity over the step [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    raise NotImplementedError


def evaluate(
    law: Any, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy and dissipated power of any law; see `BodyForce`. Kernels only.

    Args:
        law: of a `BodyForce`, or one of `LAWS`.
        memory: what it remembers of the copy, in place.
        x: displacements from rest, (rows, 4) [m].
        ahead: where the energy is wanted [m].
        rate: mean velocity over the step [m/s].
        sweeps: in which rotations are found.
        lanes: fixes the width of a row.
    """
    raise NotImplementedError


def lean(
    law: Any, memory: Float, x: Float, ahead: Float, rate: Float, T: float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds how the force of a law grows with the rate, where it gives that; see `BodyForce`. Kernels only.

    Args:
        law: of a `BodyForce`, or one of `LAWS`.
        memory: what it remembers of the copy, in place.
        x: displacements from rest, (rows, 4) [m].
        ahead: where the step ends [m].
        rate: direction in which it is wanted [m/s].
        T: length of the step [s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    raise NotImplementedError


def _law(kind: Any) -> tuple[Any, Any]:
    return LAWS.get(kind.instance_class, (None, None)) if isinstance(kind, types.BaseNamedTuple) else (None, None)


@overload(resist)
def _resist(law, memory, x, ahead, rate, out, lanes):  # numba compares the names with the stub's
    if isinstance(law, types.Array):
        return lambda law, memory, x, ahead, rate, out, lanes: call_resist(law, memory, x, ahead, rate, out, lanes)
    found, _ = _law(law)
    if found is None:
        return None
    return lambda law, memory, x, ahead, rate, out, lanes: found(law, memory, x, ahead, rate, out, lanes)


@overload(evaluate)
def _evaluate(law, memory, x, ahead, rate, sweeps, lanes):
    if isinstance(law, types.Array):
        return lambda law, memory, x, ahead, rate, sweeps, lanes: call_evaluate(
            law, memory, x, ahead, rate, sweeps, lanes
        )
    _, found = _law(law)
    if found is None:
        return None
    return lambda law, memory, x, ahead, rate, sweeps, lanes: found(law, memory, x, ahead, rate, sweeps, lanes)


@overload(lean)
def _lean(law, memory, x, ahead, rate, T, out, lanes):
    if isinstance(law, types.Array):
        return lambda law, memory, x, ahead, rate, T, out, lanes: call_lean(law, memory, x, ahead, rate, T, out, lanes)
    if not isinstance(law, types.BaseNamedTuple):
        return None
    found = LEANS.get(law.instance_class)
    if found is None:
        return lambda law, memory, x, ahead, rate, T, out, lanes: None
    return lambda law, memory, x, ahead, rate, T, out, lanes: found(law, memory, x, ahead, rate, T, out, lanes)
