# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownParameterType=false
# numba has no types
"""What a link law sees of one end of a link, and how its two functions become machine code.

Copy i with share σ of the body moves by `σ [M a + B v̂ + K(x̂ - x_d)] = f_i + Σ_j F_ij - B_i v̂`. A law says F_ij::

    F_ij = W [ k (y - x̂) + c - b v̂ ]          k, b ≥ 0; k, b, y, c chosen before the step
    A   += (b + ½ T k) W ;   rhs += W [ k (y - x) + c ]

so that the link's work on the copy, `T v̂ᵀ F_ij`, is exact whatever a law chooses. The step books it; laws book
nothing.
"""

from collections.abc import Callable
from ctypes import PYFUNCTYPE, c_void_p
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple, final

import numba
import numpy as np
from llvmlite import ir
from numba.core import cgutils, types
from numba.core.types.function_type import CompileResultWAP
from numba.core.typing.templates import AttributeTemplate, infer_getattr
from numba.extending import lower_getattr_generic, models, register_model
from numba.np.arrayobj import populate_array

from cotouch.arrays import Float
from cotouch.compiled import intrinsic, stamped


class End(NamedTuple):
    """One end of a link in one step: this copy i, and what it knows of its neighbour j.

    A field is flat, (size,): all rows of the model and all axes one after the other; entries that only pad are zero.
    What a law declares comes in its order. Before the first sample has arrived, what was received is zero.

    Attributes:
        T: length of the step [s].
        age: of the sample, from the middle of the neighbour's step to the end of this one [s].
        sample_index: number of the neighbour's step that the sample is of; -1: none has arrived.
        new: whether the sample was not used before.
        step: how many steps this end has taken.
        side: 0 at the user with the lower number, 1 at the other.
        first: whether this is the first of the copy's links; they are asked in order.
        last: whether it is the last.
        copies: N.
        width: numbers of a row in a field: its axes, in three dimensions one more that is 0, or 1 of bodies by modes.
        spring: K of the link [N/m for the identity weight].
        parameters: of the law.
        weight: diagonal of W, (size,).
        position: x; before the step where the copy is, after it where it came to, (size,) [m].
        velocity: v, likewise [m/s].
        mean: v̂ of the step, (size,), only after it [m/s].
        sample: x̃, the neighbour's x̂, (size,) [m].
        hand: force of the hands on this copy in the step before, (size,), where the law asks for it [N].
        touch: likewise of what touches it by a contact law, tools and devices [N].
        received: fields of the neighbour's message, (fields, size).
        received_scalars: (scalars,).
        memory: fields that this end keeps, (fields, size).
        scalars: numbers that this end keeps, (scalars,).
        shared: fields that all ends of the copy share, (fields, size).
        shared_scalars: (scalars,).
        target: result, before the step: y, (size,) [m].
        push: result, before the step: c, (size,) [N for the identity weight].
        gains: result, before the step: k and b, (2,) [N/m, Ns/m].
        sent: result, after the step: fields of the message to the neighbour, (fields, size).
        sent_scalars: (scalars,).
    """

    T: float
    age: float
    sample_index: int
    new: bool
    step: int
    side: int
    first: bool
    last: bool
    copies: int
    width: int
    spring: float
    parameters: Float
    weight: Float
    position: Float
    velocity: Float
    mean: Float
    sample: Float
    hand: Float
    touch: Float
    received: Float
    received_scalars: Float
    memory: Float
    scalars: Float
    shared: Float
    shared_scalars: Float
    target: Float
    push: Float
    gains: Float
    sent: Float
    sent_scalars: Float


@final
class Handed(types.Type):
    """An end as machine code gets it: an address, from which a law reads only what it asks for.

    Handed over by value, its thirty arrays and numbers took three times as long as what most laws do.
    """

    def __init__(self) -> None:
        super().__init__(name="End")  # as a law calls it, for messages of the compiler


register_model(Handed)(models.OpaqueModel)

_HANDED = Handed()
_SIGNATURE: Any = types.void(_HANDED)
_TABLES = {"received", "memory", "shared", "sent"}
# The only arrays that a law may write; others are the engine's own, and writing them would be motion without any work.
_OWN = {"memory", "scalars", "shared", "shared_scalars", "target", "push", "gains", "sent", "sent_scalars"}
_SCALARS: dict[Any, Any] = {float: types.float64, int: types.intp, bool: types.boolean}
_KINDS = {
    name: _SCALARS.get(kind, types.Array(types.float64, 1 + (name in _TABLES), "C", readonly=name not in _OWN))
    for name, kind in End.__annotations__.items()
}
# Where each begins, in words of 8 bytes: a number is one, an array its address and its sizes.
_SIZES = [1 + (kind.ndim if isinstance(kind, types.Array) else 0) for kind in _KINDS.values()]
_PLACES = dict(zip(_KINDS, np.cumsum([0, *_SIZES[:-1]]).tolist(), strict=True))
END_WORDS = sum(_SIZES)
# And as what: axes of an array, 0 of a number, less of what is counted or is so or not.
_WRITTEN = {
    name: (_PLACES[name], kind.ndim if isinstance(kind, types.Array) else -(kind is not types.float64))
    for name, kind in _KINDS.items()
}


@infer_getattr
@final
class _Attributes(AttributeTemplate):
    key = Handed

    def generic_resolve(self, _value: Any, attr: str) -> Any:
        """Type of a field; None: there is none."""
        return _KINDS.get(attr)


@lower_getattr_generic(Handed)
def _read(context: Any, builder: Any, _kind: Any, value: Any, attr: str) -> Any:
    kind, place = _KINDS[attr], _PLACES[attr]

    def word(offset: int, wanted: Any) -> Any:
        where = builder.gep(builder.bitcast(value, wanted.as_pointer()), [ir.Constant(ir.IntType(32), place + offset)])
        found = builder.load(where)
        # Nothing writes it while the law runs, so it is read once and not in each turn of a loop.
        found.set_metadata("invariant.load", builder.module.add_metadata([]))
        return found

    if kind == types.boolean:
        return builder.icmp_signed("!=", word(0, ir.IntType(64)), ir.Constant(ir.IntType(64), 0))
    if not isinstance(kind, types.Array):
        return word(0, context.get_value_type(kind))
    array = context.make_array(kind)(context, builder)
    shape = [word(1 + axis, ir.IntType(64)) for axis in range(kind.ndim)]
    item = ir.Constant(ir.IntType(64), 8)
    strides = [item] if kind.ndim == 1 else [builder.mul(shape[1], item), item]
    populate_array(array, data=word(0, array.data.type), shape=shape, strides=strides, itemsize=item, meminfo=None)
    return array._getvalue()


@intrinsic
def hand(typingctx: Any, end: Any, words: Any) -> Any:  # noqa: ARG001
    """Writes an end as a law's machine code reads it, where `handed` finds it.

    Args:
        typingctx: of numba.
        end: of a link.
        words: memory for it, (END_WORDS,).
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        kinds = signature.args[0].types
        memory = context.make_array(signature.args[1])(context, builder, args[1]).data

        def put_word(offset: int, value: Any) -> None:
            where = builder.gep(memory, [ir.Constant(ir.IntType(32), offset)])
            builder.store(value, builder.bitcast(where, value.type.as_pointer()))

        for kind, (name, place), value in zip(
            kinds, _PLACES.items(), cgutils.unpack_tuple(builder, args[0]), strict=True
        ):
            wanted = _KINDS[name]
            if isinstance(wanted, types.Array):
                array = context.make_array(kind)(context, builder, value)
                put_word(place, array.data)
                for axis, size in enumerate(cgutils.unpack_tuple(builder, array.shape)):
                    put_word(place + 1 + axis, size)
            elif wanted == types.boolean:
                put_word(place, builder.zext(context.cast(builder, value, kind, wanted), ir.IntType(64)))
            else:
                put_word(place, context.cast(builder, value, kind, wanted))
        return context.get_dummy_value()

    return types.void(end, words), generate


@intrinsic
def handed(typingctx: Any, words: Any) -> Any:  # noqa: ARG001
    """The end that `hand` has written, for both halves of a law.

    Args:
        typingctx: numba's.
        words: that `hand` has written it to.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        memory = context.make_array(signature.args[0])(context, builder, args[0]).data
        return builder.bitcast(memory, ir.IntType(8).as_pointer())

    return _HANDED(words), generate


@final
class CompiledHalf(types.WrapperAddressProtocol):
    """A compiled half of a law. Engines call it by its address, so one engine, compiled once, serves all laws."""

    def __init__(self, function: Callable[[End], None]) -> None:
        """Compiles it, because a failure while numba asks for the address would end the process.

        Args:
            function: half of a law.
        """
        self._function = function
        compiled = _compiled(function)
        compiled.compile(_SIGNATURE)
        made: Any = CompileResultWAP(compiled.overloads[_SIGNATURE.args])
        self._address = int(made.__wrapper_address__())

    def __call__(self, end: End) -> None:
        """The function as it was written, not compiled."""
        self._function(end)

    def __wrapper_address__(self) -> int:
        return self._address

    def signature(self) -> Any:
        """Of the function, as numba writes it."""
        return _SIGNATURE

    @cached_property
    def machine_code(self) -> Callable[[int], None]:
        """What Python calls with the address of an end that was written; it keeps the interpreter to itself."""
        return PYFUNCTYPE(None, c_void_p)(self.__wrapper_address__())


def _compiled(function: Callable[[End], None]) -> Any:
    njit: Any = numba.njit
    options = {"nogil": True, "fastmath": {"contract"}, "error_model": "numpy", "_nrt": False}
    source = Path(function.__code__.co_filename)
    compiled = njit(**options)(function)
    # Without a file there is nothing beside which the machine code could be kept.
    return stamped(compiled) if source.is_file() else compiled


@final
class BoundEnd:
    """An end that lasts, in memory as a law's machine code reads it: what stays is written once and not in each step.

    Handing over the whole of an end from Python took longer than what a law does with a point.
    """

    def __init__(self, end: End) -> None:
        """Writes all of it.

        Args:
            end: of a link; its arrays of numbers are C-contiguous.
        """
        self._words = np.zeros(END_WORDS, dtype=np.int64)
        self._numbers = self._words.view(np.float64)
        self._address = int(self._words.ctypes.data)
        self._held: dict[str, Float] = {}
        self.write(**end._asdict())

    def write(self, **changed: Any) -> None:
        """Writes what changed.

        Args:
            changed: fields of an end by name; of arrays only which one it is, not what is in it.
        """
        words, numbers, held = self._words, self._numbers, self._held
        for name, value in changed.items():
            place, axes = _WRITTEN[name]
            if axes == 0:
                numbers[place] = value
            elif axes < 0:
                words[place] = value
            elif held.get(name) is not value:
                assert value.dtype == np.float64, name
                assert value.flags.c_contiguous, name
                held[name] = value
                words[place] = value.ctypes.data
                words[place + 1 : place + 1 + axes] = value.size if axes == 1 else value.shape

    def run(self, part: CompiledHalf) -> None:
        """Calls a half of a law.

        Args:
            part: of the law.
        """
        part.machine_code(self._address)


def call(part: CompiledHalf, end: End) -> None:
    """Calls a half of a law once from Python.

    Args:
        part: of a law.
        end: of a link.
    """
    BoundEnd(end).run(part)
