"""How a step calls a law of which it knows no more than where it is.

Otherwise the whole step, with contact and several bodies, would be compiled anew for each law, though all of it but the
law's own few functions is the same.
"""
# Every function takes the interface's arguments, and not each needs all of them.
# ruff: noqa: ARG001

from importlib import import_module
from typing import Any

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.compiled import intrinsic
from cotouch.kernels import outlined
from cotouch.mechanics._materials._memory import forget, take_back
from cotouch.passing import ByAddress, written

# LLVM's types and numba's decorators have no types of their own.
numba: Any = import_module("numba")
ir: Any = import_module("llvmlite.ir")
cgutils: Any = import_module("numba.core.cgutils")

types: Any = numba.core.types
# Places of a law's functions.
_RESIST, _EVALUATE, _LEAN, _BEGIN, _UNDO = range(5)
_NUMBERS, _ROWS = types.Array(types.float64, 1, "C"), types.Array(types.float64, 2, "C")
_LANES = types.UniTuple(types.int64, 4)
# What each takes after the law.
_TAKES = (
    (_NUMBERS, _ROWS, _ROWS, _ROWS, _ROWS, _LANES),
    (_NUMBERS, _ROWS, _ROWS, _ROWS, types.int64, _LANES),
    (_NUMBERS, _ROWS, _ROWS, _ROWS, types.float64, _ROWS, _LANES),
    (_NUMBERS, types.int64),
    (_NUMBERS, types.int64),
)
_GIVES = (types.none, types.UniTuple(types.float64, 2), types.none, types.none, types.none)
# Of each type of a law, where its functions are.
_functions: dict[Any, Long] = {}


def called(law: Any) -> Long:
    """Where kernels find a law and its functions; the law must be kept as long.

    Args:
        law: a NamedTuple of arrays, numbers and such tables.
    """
    return written(law, first=_places(numba.typeof(law)).ctypes.data)


def _places(kind: Any) -> Long:
    return _functions.setdefault(kind, np.zeros(len(_TAKES), dtype=np.int64))


def make_ready(kind: Any, *functions: Any) -> None:
    """Compiles the functions of a law of some type, or finds them compiled, for `called` laws.

    Args:
        kind: numba's type of the law.
        functions: `resist`, `evaluate`, `lean`, and what forgets its rotations and takes them back.
    """
    places = _places(kind)
    if places.all():
        return
    law = ByAddress(kind.types, kind.instance_class)
    for place, function in enumerate(functions):
        known = function not in {no_lean, begin_one, undo_one}
        places[place] = _address(function, (law if known else types.voidptr, *_TAKES[place]))


def _address(function: Any, takes: tuple[Any, ...]) -> int:
    function.compile(takes)
    made = function.overloads[takes]._asdict()
    address: int = made["library"].get_pointer_to_function(made["fndesc"].llvm_func_name)
    if not address:
        raise TypeError(f"{function.__name__} has no machine code of its own: compile it as `outlined`")
    return address


@outlined
def no_lean(
    law: Any, memory: Float, x: Float, ahead: Float, rate: Float, T: float, out: Float, lanes: tuple[int, ...]
) -> None:
    """Of a law that gives no tangent.

    Args:
        law: without one.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        T: length of the step [s].
        out: stays as it is.
        lanes: fixes the width of a row.
    """


@outlined
def begin_one(law: Any, memory: Float, behind: int) -> None:
    """Sets the rotations of one body to none.

    Args:
        law: of one body.
        memory: of the copy, (numbers,).
        behind: as of `forget`.
    """
    forget(memory, behind)


@outlined
def undo_one(law: Any, memory: Float, behind: int) -> None:
    """Takes the rotations of one body back to those with which the last evaluation began.

    Args:
        law: of one body.
        memory: of the copy, (numbers,).
        behind: as of `take_back`.
    """
    take_back(memory, behind)


def _calls(place: int, law: Any, *given: Any) -> Any:
    """Signature and code of an intrinsic that calls one of a law's functions."""
    takes, gives = _TAKES[place], _GIVES[place]
    for kind, wanted in zip(given, takes, strict=True):
        if isinstance(wanted, types.Array) and not (
            isinstance(kind, types.Array) and (kind.dtype, kind.ndim, kind.layout) == (wanted.dtype, wanted.ndim, "C")
        ):
            raise TypeError(f"a law takes {wanted}, not {kind}")

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        words = context.make_array(signature.args[0])(context, builder, arguments[0]).data
        all_takes = [types.voidptr, *takes]
        kind = context.call_conv.get_function_type(gives, all_takes)
        places = builder.inttoptr(builder.load(words), ir.IntType(64).as_pointer())
        address = builder.load(builder.gep(places, [ir.Constant(ir.IntType(64), place)], inbounds=True))
        function = builder.inttoptr(address, kind.as_pointer())
        table = builder.bitcast(
            builder.gep(words, [ir.Constant(ir.IntType(64), 1)], inbounds=True), context.get_value_type(types.voidptr)
        )
        status, result = context.call_conv.call_function(builder, function, gives, all_takes, [table, *arguments[1:]])
        with cgutils.if_unlikely(builder, status.is_error):
            context.call_conv.return_status_propagate(builder, status)
        return context.get_dummy_value() if gives == types.none else result

    wants = [kind if isinstance(kind, types.Array) else wanted for kind, wanted in zip(given, takes, strict=True)]
    return gives(law, *wants), generate


@intrinsic
def call_resist(typingctx: Any, law: Any, memory: Any, x: Any, ahead: Any, rate: Any, out: Any, lanes: Any) -> Any:
    """`resist` of a law by its address.

    Args:
        typingctx: numba's own.
        law: compiled, with its address.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    return _calls(_RESIST, law, memory, x, ahead, rate, out, lanes)


@intrinsic
def call_evaluate(typingctx: Any, law: Any, memory: Any, x: Any, ahead: Any, rate: Any, sweeps: Any, lanes: Any) -> Any:
    """`evaluate` of a law by its address.

    Args:
        typingctx: numba's own.
        law: compiled, with its address.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        sweeps: of the search for the nearest rotations, >= 1.
        lanes: fixes the width of a row.
    """
    return _calls(_EVALUATE, law, memory, x, ahead, rate, sweeps, lanes)


@intrinsic
def call_lean(
    typingctx: Any, law: Any, memory: Any, x: Any, ahead: Any, rate: Any, T: Any, out: Any, lanes: Any
) -> Any:
    """`lean` of a law by its address.

    Args:
        typingctx: numba's own.
        law: compiled, with its address.
        memory: of the copy, (numbers,).
        x: displacements of the rows before the step, (rows, 4) [m].
        ahead: after it, likewise.
        rate: mean velocity, likewise [m/s].
        T: length of the step [s].
        out: added to.
        lanes: fixes the width of a row.
    """
    return _calls(_LEAN, law, memory, x, ahead, rate, T, out, lanes)


@intrinsic
def call_begin(typingctx: Any, law: Any, memory: Any, behind: Any) -> Any:
    """What sets all rotations of a law to none, by its address.

    Args:
        typingctx: numba's own.
        law: compiled, with its address.
        memory: of the copy, (numbers,).
        behind: as of `forget`.
    """
    return _calls(_BEGIN, law, memory, behind)


@intrinsic
def call_undo(typingctx: Any, law: Any, memory: Any, behind: Any) -> Any:
    """What takes them back, by its address.

    Args:
        typingctx: numba's own.
        law: compiled, with its address.
        memory: of the copy, (numbers,).
        behind: as of `take_back`.
    """
    return _calls(_UNDO, law, memory, behind)
