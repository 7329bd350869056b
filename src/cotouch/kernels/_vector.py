"""Rows of 1 or 4 numbers as machine vectors inside kernels.

A field over the nodes is an array (rows, width), C-contiguous, with width 1 or 4 (two and three axes are padded by
zero columns). Kernels read and write one row at a time as a vector; numba alone does not vectorise across the few
columns of a row and is three to four times slower. The width must be known when a kernel is compiled, so it travels as
the length of a tuple, `lanes`. With one lane a "vector" is an ordinary float.

`at` and `put` read and write an element without numba's wrap-around of negative indices. It costs a branch in sparse
products, and a third of the time of a batch of points.
"""

# pyright: basic
# numba hands over all that it knows, whether a function needs it or not.
# ruff: noqa: ARG001

import operator
from typing import Any

from llvmlite import ir
from numba.core import types
from numba.core.cgutils import get_or_insert_function, unpack_tuple
from numba.core.errors import TypingError
from numba.extending import models, overload, register_model

from cotouch.compiled import intrinsic

WIDTHS = (1, 4)
# A row of four numbers, whatever the width of the body's own fields: places and normals.
FOUR = (0, 0, 0, 0)
_FLAGS = ("contract",)
# Where numba's value of an array holds the address of its elements, and its shape.
_DATA, _SHAPE = 4, 5


class Vec(types.Type):
    """A machine vector of `width` doubles."""

    def __init__(self, width: int) -> None:
        self.width = width
        super().__init__(name=f"Vec({width})")


@register_model(Vec)
class _VecModel(models.PrimitiveModel):
    def __init__(self, dmm: Any, fe_type: Vec) -> None:
        super().__init__(dmm, fe_type, ir.VectorType(ir.DoubleType(), fe_type.width))


def _type(lanes: Any) -> Any:
    return types.float64 if lanes.count == 1 else Vec(lanes.count)


def _contiguous(array: Any) -> None:
    if array.layout != "C":
        raise TypingError(f"kernels read C-contiguous arrays only, not {array}")


def _writable(array: Any) -> None:
    if not array.mutable:
        raise TypingError("Cannot modify readonly array")


def _row(builder: Any, array: Any, row: Any, width: int) -> Any:
    pointer = builder.gep(builder.extract_value(array, _DATA), [builder.mul(row, ir.Constant(row.type, width))])
    return pointer if width == 1 else builder.bitcast(pointer, ir.VectorType(ir.DoubleType(), width).as_pointer())


def _broadcast(builder: Any, value: Any, width: int) -> Any:
    vector = ir.VectorType(ir.DoubleType(), width)
    index = ir.IntType(32)
    first = builder.insert_element(ir.Constant(vector, ir.Undefined), value, ir.Constant(index, 0))
    return builder.shuffle_vector(
        first, ir.Constant(vector, ir.Undefined), ir.Constant(ir.VectorType(index, width), [0] * width)
    )


@intrinsic
def load(typingctx: Any, field: Any, row: Any, lanes: Any) -> Any:
    """`field[row, :]` as a vector.

    Args:
        typingctx: numba's own.
        field: (rows, width), C-contiguous.
        row: of it, in range.
        lanes: fixes the width of a row.
    """
    _contiguous(field)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = _row(builder, args[0], args[1], lanes.count)
        return builder.load(pointer, align=8)

    return _type(lanes)(field, types.intp, lanes), generate


@intrinsic
def store(typingctx: Any, field: Any, row: Any, value: Any, lanes: Any) -> Any:
    """`field[row, :] = value`.

    Args:
        typingctx: numba's own.
        field: (rows, width), C-contiguous.
        row: of it, in range.
        value: a vector.
        lanes: fixes the width of a row.
    """
    _contiguous(field)
    _writable(field)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = _row(builder, args[0], args[1], lanes.count)
        builder.store(args[2], pointer, align=8)
        return context.get_dummy_value()

    return types.void(field, types.intp, _type(lanes), lanes), generate


@intrinsic
def splat(typingctx: Any, value: Any, lanes: Any) -> Any:
    """A vector with `value` in every lane.

    Args:
        typingctx: numba's own.
        value: a number.
        lanes: fixes the width of a row.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return args[0] if lanes.count == 1 else _broadcast(builder, args[0], lanes.count)

    return _type(lanes)(types.float64, lanes), generate


@intrinsic
def total(typingctx: Any, vector: Any) -> Any:
    """Sum of the lanes, left to right."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        if not isinstance(vector, Vec):
            return args[0]
        lanes = [builder.extract_element(args[0], ir.Constant(ir.IntType(32), k)) for k in range(vector.width)]
        result = lanes[0]
        for lane in lanes[1:]:
            result = builder.fadd(result, lane)
        return result

    return types.float64(vector), generate


def _four_of(builder: Any, values: Any) -> Any:
    vector = ir.Constant(ir.VectorType(ir.DoubleType(), 4), ir.Undefined)
    for k, value in enumerate(values):
        vector = builder.insert_element(vector, value, ir.Constant(ir.IntType(32), k))
    return vector


def _shuffled(builder: Any, one: Any, other: Any, lanes: tuple[int, ...]) -> Any:
    return builder.shuffle_vector(one, other, ir.Constant(ir.VectorType(ir.IntType(32), 4), list(lanes)))


@intrinsic
def four(typingctx: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    """A vector of four numbers.

    Args:
        typingctx: numba's own.
        a: the first.
        b: the second.
        c: the third.
        d: the fourth.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _four_of(builder, args)

    return Vec(4)(*[types.float64] * 4), generate


@intrinsic
def lane(typingctx: Any, vector: Any, k: Any) -> Any:
    """One number of a vector; of a number, that.

    Args:
        typingctx: numba's own.
        vector: or a number.
        k: which, from 0.
    """
    del typingctx, k

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        del context, signature
        return builder.extract_element(*args) if isinstance(vector, Vec) else args[0]

    return types.float64(vector, types.intp), generate


@intrinsic
def transposed(typingctx: Any, a: Any, b: Any, c: Any, d: Any) -> Any:
    """The rows of a matrix of four by four as its columns.

    Args:
        typingctx: numba's own.
        a: the first row.
        b: the second.
        c: the third.
        d: the fourth.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        a, b, c, d = args
        even, odd = (0, 4, 2, 6), (1, 5, 3, 7)
        x, y = (_shuffled(builder, a, b, lanes) for lanes in (even, odd))
        z, w = (_shuffled(builder, c, d, lanes) for lanes in (even, odd))
        low, high = (0, 1, 4, 5), (2, 3, 6, 7)
        pairs = ((x, z, low), (y, w, low), (x, z, high), (y, w, high))
        return context.make_tuple(builder, signature.return_type, [_shuffled(builder, *pair) for pair in pairs])

    return types.UniTuple(Vec(4), 4)(*[Vec(4)] * 4), generate


@intrinsic
def where(typingctx: Any, test: Any, yes: Any, no: Any) -> Any:
    """`yes` where a number or the lane of a vector is above 0, `no` elsewhere.

    Args:
        typingctx: numba's own.
        test: a number or a vector.
        yes: likewise.
        no: likewise.
    """
    width = max((kind.width for kind in (test, yes, no) if isinstance(kind, Vec)), default=1)
    kinds = [kind if isinstance(kind, Vec) else types.float64 for kind in (test, yes, no)]

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        sides = [
            value if isinstance(kind, Vec) or width == 1 else _broadcast(builder, value, width)
            for value, kind in zip(args, signature.args, strict=True)
        ]
        zero = ir.Constant(sides[0].type, 0.0 if width == 1 else [0.0] * width)
        return builder.select(builder.fcmp_ordered(">", sides[0], zero), *sides[1:])

    return (types.float64 if width == 1 else Vec(width))(*kinds), generate


def _called(name: str, meaning: str) -> Any:
    def apply(typingctx: Any, vector: Any) -> Any:

        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            kind = args[0].type
            whole = f"{name}.v{kind.count}f64" if isinstance(vector, Vec) else f"{name}.f64"
            return builder.call(get_or_insert_function(builder.module, ir.FunctionType(kind, [kind]), whole), args)

        return vector(vector), generate

    apply.__doc__ = meaning
    return intrinsic(apply)


root = _called("llvm.sqrt", "The square root of a number, or lane by lane.")
size = _called("llvm.fabs", "A number without its sign, or lane by lane.")


def _select(order: str, meaning: str) -> Any:
    def choose(typingctx: Any, left: Any, right: Any) -> Any:

        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            return builder.select(builder.fcmp_ordered(order, *args), *args)

        return left(left, right), generate

    choose.__doc__ = meaning
    return intrinsic(choose)


lower = _select("<", "The smaller of two vectors, lane by lane.")
upper = _select(">", "The larger of two vectors, lane by lane.")


def _index(array: Any, index: Any) -> Any:
    """Type of an index: one integer, or a tuple with one for each dimension."""
    if isinstance(index, types.BaseTuple):
        if len(index) != array.ndim:
            raise TypingError(f"{array} has {array.ndim} dimensions, not {len(index)}")
        return types.UniTuple(types.intp, array.ndim)
    return types.intp


def _element(builder: Any, signature: Any, args: Any) -> Any:
    data = builder.extract_value(args[0], _DATA)
    if signature.args[1] is types.intp:
        return builder.gep(data, [args[1]])
    place, *steps = unpack_tuple(builder, args[1])
    for axis, step in enumerate(steps, 1):
        place = builder.add(builder.mul(place, builder.extract_value(args[0], (_SHAPE, axis))), step)
    return builder.gep(data, [place])


@intrinsic
def at(typingctx: Any, array: Any, index: Any) -> Any:
    """`array[index]` of a C-contiguous array; every index known to be in range and not negative.

    A single index into several dimensions counts the elements in order.

    Args:
        typingctx: numba's own.
        array: C-contiguous.
        index: one, or one for each dimension.
    """
    _contiguous(array)
    dtype = array.dtype
    integer = isinstance(dtype, types.Integer)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        value = context.unpack_value(builder, dtype, _element(builder, signature, args))
        return context.cast(builder, value, dtype, types.intp) if integer else value

    return (types.intp if integer else dtype)(array, _index(array, index)), generate


@intrinsic
def put(typingctx: Any, array: Any, index: Any, value: Any) -> Any:
    """`array[index] = value`; what `at` asks of the index holds here too.

    Args:
        typingctx: numba's own.
        array: C-contiguous.
        index: as of `at`.
        value: a number.
    """
    _contiguous(array)
    _writable(array)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        context.pack_value(builder, array.dtype, args[2], _element(builder, signature, args))
        return context.get_dummy_value()

    return types.void(array, _index(array, index), array.dtype), generate


def _arithmetic(symbol: Any, instruction: str) -> None:
    @intrinsic
    def apply(typingctx: Any, left: Any, right: Any) -> Any:
        width = left.width if isinstance(left, Vec) else right.width
        operands = [side if isinstance(side, Vec) else types.float64 for side in (left, right)]

        def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            sides = [
                value if isinstance(kind, Vec) else _broadcast(builder, value, width)
                for value, kind in zip(args, signature.args, strict=True)
            ]
            return getattr(builder, instruction)(*sides, flags=_FLAGS)

        return Vec(width)(*operands), generate

    @overload(symbol)
    def choose(left, right):  # numba compares the signature with the lambda's: no annotations
        if isinstance(left, Vec) or isinstance(right, Vec):
            return lambda left, right: apply(left, right)  # noqa: PLW0108 (an intrinsic is no implementation)
        return None


@overload(operator.pow)
def _power(base, exponent):  # numba compares the signature with the lambda's: no annotations
    """A whole power, at least 1, of a vector."""
    if not isinstance(base, Vec) or not isinstance(exponent, types.Integer):
        return None

    def multiply(base, exponent):
        result = base
        for _ in range(exponent - 1):
            result = result * base
        return result

    return multiply


for _symbol, _instruction in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _arithmetic(_symbol, _instruction)
