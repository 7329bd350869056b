# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""The law of several bodies: each follows its own, in its own rest frame.

Laws of one kind lie side by side in one set of arrays, and a kernel takes the piece of one body out of them, so machine
code is the same for any number of bodies. What it remembers of a copy are the memories of all, one after the other.
"""
# An overload's parameters only name those of its stub; an array indexed by an element of another is a number to numba.
# ruff: noqa: ARG001
# pyright: reportMissingParameterType=false, reportAttributeAccessIssue=false, reportUnusedFunction=false
# pyright: reportArgumentType=false, reportReturnType=false

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numba.core import types
from numba.extending import overload

from cotouch.arrays import Float, Int
from cotouch.kernels import at, outlined, part, put
from cotouch.mechanics._materials._force import LAWS, LEANS, STARTS, evaluate, lean, resist
from cotouch.mechanics._materials._memory import forget, fresh_memory, take_back
from cotouch.passing import by_address

# Numbers at the head of a memory.
_HEAD = 4


@by_address
class Pack(NamedTuple):
    """The laws of one kind.

    Attributes:
        law: their arrays, end to end.
        split: where each array begins of each law, (laws + 1, fields).
        number: fields that are numbers, (laws, fields).
    """

    law: Any
    split: Int
    number: Float


@by_address
class Together(NamedTuple):
    """The laws of several bodies.

    Attributes:
        packs: a `Pack` for each kind of law that there is.
        kind: which of them each body's is in, (bodies,).
        slot: and where, (bodies,).
        first: first node of each body, (bodies + 1,).
        row: row of the kernels of each node, (nodes,).
        rigid: which of the rows that are solved for at once each row is, (rows,); negative: none of them.
        turn: rotation of each body's rest shape, (bodies, 9).
        memory: where each body's memory begins, (bodies + 1,).
        energy: result: energy [J] and dissipated power [W] of each body, (bodies, 2).
        place: scratch: of one body in its own frame, (nodes, 4), like the three that follow.
        ahead: scratch.
        rate: scratch.
        out: scratch.
        tangent: scratch: how the force of one body grows with its rate, (3 nodes, 3 nodes), or (0, 0).
    """

    packs: tuple[Pack, ...]
    kind: Int
    slot: Int
    first: Int
    row: Int
    rigid: Int
    turn: Float
    memory: Int
    energy: Float
    place: Float
    ahead: Float
    rate: Float
    out: Float
    tangent: Float


def together_of(
    laws: Sequence[Any], memories: Sequence[int], rows: Sequence[Int], turns: Sequence[Float], rigid: Int
) -> Together:
    """The law of several bodies.

    Args:
        laws: of each, in its own frame and with its own nodes as rows.
        memories: how many numbers each remembers.
        rows: row of the kernels of each node of each body.
        turns: rotation of each rest shape, (3, 3).
        rigid: see `Together`.
    """
    kinds: list[type] = sorted({type(law) for law in laws}, key=_name)
    of_kind = [[law for law in laws if type(law) is kind] for kind in kinds]
    most = max(own.size for own in rows)
    wide = 3 * max((own.size for own in rows if rigid[own[0]] >= 0), default=0)
    return Together(
        packs=tuple(_pack(same) for same in of_kind),
        kind=np.array([kinds.index(type(law)) for law in laws], dtype=np.int32),
        slot=np.array([sum(type(o) is type(law) for o in laws[:b]) for b, law in enumerate(laws)], dtype=np.int32),
        first=np.cumsum([0, *(own.size for own in rows)]).astype(np.int32),
        row=np.concatenate(rows).astype(np.int32),
        rigid=rigid,
        turn=np.ascontiguousarray([turn.ravel() for turn in turns]),
        memory=np.cumsum([_HEAD, *memories]).astype(np.int32),
        energy=np.zeros((len(laws), 2)),
        tangent=np.zeros((wide, wide)),
        **{name: np.zeros((most, 4)) for name in ("place", "ahead", "rate", "out")},
    )


def _name(kind: type) -> str:
    return kind.__name__


def _pack(laws: list[Any]) -> Pack:
    fields = laws[0]._fields
    split = np.zeros((len(laws) + 1, len(fields)), dtype=np.int32)
    number = np.zeros((len(laws), len(fields)))
    joined: list[Any] = []
    for j, name in enumerate(fields):
        values = [getattr(law, name) for law in laws]
        if isinstance(values[0], np.ndarray):
            split[1:, j] = np.cumsum([value.shape[0] for value in values])
            joined.append(np.ascontiguousarray(np.concatenate(values)))
        else:
            number[:, j] = values
            joined.append(values[0])
    return Pack(type(laws[0])(*joined), split, number)


def fresh_together(law: Together, more: int) -> Float:
    """A memory of several bodies in which nothing has turned, and so many more numbers, which are 0.

    Args:
        law: of the bodies.
        more: numbers behind it.
    """
    own = [fresh_memory(int(size)) for size in np.diff(law.memory)]
    return np.concatenate([np.zeros(_HEAD), *own, np.zeros(more)])


@outlined
def _forget_all(law: Together, memory: Float, behind: int) -> None:
    for place in range(at(law.memory, law.kind.shape[0])):
        put(memory, place, 0.0)
    for b in range(law.kind.shape[0]):
        forget(memory[at(law.memory, b) : at(law.memory, b + 1)], 0)


@outlined
def _undo_all(law: Together, memory: Float, behind: int) -> None:
    for b in range(law.kind.shape[0]):
        take_back(memory[at(law.memory, b) : at(law.memory, b + 1)], 0)


def _piece(pack: Any, k: Any) -> Any:
    """One law of a pack. Kernels only."""
    raise NotImplementedError


@overload(_piece)
def _piece_of(pack, k):
    law = pack.types[pack.fields.index("law")]
    given: list[str] = []
    for j, (name, kind) in enumerate(zip(law.fields, law.types, strict=True)):
        if isinstance(kind, types.Array):
            given.append(f"pack.law.{name}[at(pack.split, (k, {j})) : at(pack.split, (k + 1, {j}))]")
        else:
            number = f"at(pack.number, (k, {j}))"
            given.append(f"int({number})" if isinstance(kind, types.Integer) else number)
    return _made(f"def made(pack, k):\n    return Law({', '.join(given)})\n", Law=law.instance_class)


def _resist_kind(
    packs: Any, kind: Any, k: Any, memory: Any, x: Any, ahead: Any, rate: Any, out: Any, lanes: Any
) -> Any:
    """`resist` of law k of one of the packs. Kernels only."""
    raise NotImplementedError


@overload(_resist_kind)
def _resist_of(packs, kind, k, memory, x, ahead, rate, out, lanes):
    said = ["def made(packs, kind, k, memory, x, ahead, rate, out, lanes):"]
    for j in range(len(packs)):
        said += [f"    if kind == {j}:", f"        resist(piece(packs[{j}], k), memory, x, ahead, rate, out, lanes)"]
    return _made("\n".join(said), resist=resist, piece=_piece)


def _evaluate_kind(
    packs: Any, kind: Any, k: Any, memory: Any, x: Any, ahead: Any, rate: Any, sweeps: Any, lanes: Any
) -> Any:
    """`evaluate` of law k of one of the packs. Kernels only."""
    raise NotImplementedError


@overload(_evaluate_kind)
def _evaluate_of(packs, kind, k, memory, x, ahead, rate, sweeps, lanes):
    said = ["def made(packs, kind, k, memory, x, ahead, rate, sweeps, lanes):"]
    for j in range(len(packs)):
        call = f"evaluate(piece(packs[{j}], k), memory, x, ahead, rate, sweeps, lanes)"
        said += [f"    if kind == {j}:", f"        return {call}"]
    return _made("\n".join([*said, "    return 0.0, 0.0"]), evaluate=evaluate, piece=_piece)


def _lean_kind(
    packs: Any, kind: Any, k: Any, memory: Any, x: Any, ahead: Any, rate: Any, T: Any, out: Any, lanes: Any
) -> Any:
    """`lean` of law k of one of the packs. Kernels only."""
    raise NotImplementedError


@overload(_lean_kind)
def _lean_of(packs, kind, k, memory, x, ahead, rate, T, out, lanes):
    said = ["def made(packs, kind, k, memory, x, ahead, rate, T, out, lanes):"]
    for j in range(len(packs)):
        said += [f"    if kind == {j}:", f"        lean(piece(packs[{j}], k), memory, x, ahead, rate, T, out, lanes)"]
    return _made("\n".join(said), lean=lean, piece=_piece)


def _made(text: str, **names: Any) -> Any:
    """A function of this text, which numba compiles into its caller."""
    space: dict[str, Any] = {"at": at, **names}
    exec(text, space)  # noqa: S102  the text is made above, of field names of our own types
    return space["made"]


@part
def _into(law: Together, b: int, field: Float, out: Float) -> None:
    """A field of one body in its own frame."""
    begins, r = at(law.first, b), 9 * b
    for n in range(at(law.first, b + 1) - begins):
        i = 4 * at(law.row, begins + n)
        x, y, z = at(field, i), at(field, i + 1), at(field, i + 2)
        for a in range(3):
            value = at(law.turn, r + a) * x + at(law.turn, r + 3 + a) * y + at(law.turn, r + 6 + a) * z
            put(out, 4 * n + a, value)


@outlined
def resist_together(
    law: Together, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds the mean forces of all bodies between two places and their damping; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `Together`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    for b in range(law.kind.shape[0]):
        begins, r = at(law.first, b), 9 * b
        count = at(law.first, b + 1) - begins
        _into(law, b, x, law.place)
        _into(law, b, ahead, law.ahead)
        _into(law, b, rate, law.rate)
        for n in range(4 * count):
            put(law.out, n, 0.0)
        _resist_kind(
            law.packs,
            at(law.kind, b),
            at(law.slot, b),
            memory[at(law.memory, b) :],
            law.place[:count],
            law.ahead[:count],
            law.rate[:count],
            law.out[:count],
            lanes,
        )
        for n in range(count):
            i, j = 4 * at(law.row, begins + n), 4 * n
            fx, fy, fz = at(law.out, j), at(law.out, j + 1), at(law.out, j + 2)
            for a in range(3):
                k = r + 3 * a
                value = at(law.turn, k) * fx + at(law.turn, k + 1) * fy + at(law.turn, k + 2) * fz
                put(out, i + a, at(out, i + a) + value)


@outlined
def evaluate_together(
    law: Together, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Energy of all bodies at the end of a step, and the power of their dampers in it; of each goes to `energy`.

    Args:
        law: see `Together`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: of the search for the nearest rotations, >= 1.
        lanes: fixes the width of a row.
    """
    energy, power = 0.0, 0.0
    for b in range(law.kind.shape[0]):
        count = at(law.first, b + 1) - at(law.first, b)
        _into(law, b, x, law.place)
        _into(law, b, ahead, law.ahead)
        _into(law, b, rate, law.rate)
        own, lost = _evaluate_kind(
            law.packs,
            at(law.kind, b),
            at(law.slot, b),
            memory[at(law.memory, b) :],
            law.place[:count],
            law.ahead[:count],
            law.rate[:count],
            sweeps,
            lanes,
        )
        put(law.energy, (b, 0), own)
        put(law.energy, (b, 1), lost)
        energy, power = energy + own, power + lost
    return energy, power


@outlined
def lean_together(
    law: Together, memory: Float, x: Float, ahead: Float, rate: Float, T: float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Adds how the forces of bodies of few rows grow with the rate; see `cotouch.mechanics.BodyForce`.

    Args:
        law: see `Together`.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        T: length of the step [s].
        out: added to, as of `lean`.
        lanes: fixes the width of a row.
    """
    for b in range(law.kind.shape[0]):
        begins, r, wide = at(law.first, b), 9 * b, law.tangent.shape[0]
        if at(law.rigid, at(law.row, begins)) < 0:
            continue
        count = at(law.first, b + 1) - begins
        _into(law, b, x, law.place)
        _into(law, b, ahead, law.ahead)
        _into(law, b, rate, law.rate)
        for n in range(wide * wide):
            put(law.tangent, n, 0.0)
        _lean_kind(
            law.packs,
            at(law.kind, b),
            at(law.slot, b),
            memory[at(law.memory, b) :],
            law.place[:count],
            law.ahead[:count],
            law.rate[:count],
            T,
            law.tangent,
            lanes,
        )
        for n in range(count):
            for o in range(count):
                i = 3 * at(law.rigid, at(law.row, begins + n))
                j = 3 * at(law.rigid, at(law.row, begins + o))
                for a in range(3):
                    for c in range(3):
                        value = 0.0
                        for p in range(3):
                            for q in range(3):
                                own = at(law.tangent, (3 * n + p, 3 * o + q))
                                value += at(law.turn, r + 3 * a + p) * own * at(law.turn, r + 3 * c + q)
                        put(out, (i + a, j + c), at(out, (i + a, j + c)) + value)


LAWS[Together] = (resist_together, evaluate_together)
LEANS[Together] = lean_together
STARTS[Together] = (_forget_all, _undo_all)
