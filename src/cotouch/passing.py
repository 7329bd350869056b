"""How tables of many arrays come to kernels: by address.

Numba hands a NamedTuple over field by field. A body with its world has nearly a thousand, every call of one kernel by
another repeated them all, and nine of ten instructions of the closed step did nothing else: compiling took most of its
time for them. A table that is made in Python and only read in kernels is written into memory once, where Python calls
the kernel, and handed on as one address.
"""

from collections.abc import Iterator
from importlib import import_module
from typing import Any, TypeVar, final

from numba.core import types
from numba.core.datamodel.models import PrimitiveModel
from numba.extending import NativeValue, typeof_impl

# LLVM's types and numba's decorators have no types of their own.
ir: Any = import_module("llvmlite.ir")
cgutils: Any = import_module("numba.core.cgutils")
registry: Any = import_module("numba.core.datamodel.registry")
imputils: Any = import_module("numba.core.imputils")
boxing: Any = import_module("numba.core.pythonapi")

T = TypeVar("T", bound=type)

_WORD = 8  # bytes that every number of a table takes
_BYTES = ir.IntType(8).as_pointer()


@final
class ByAddress(types.NamedTuple):
    """Numba's type of such a table: its fields are those of the NamedTuple, its value is where they are."""

    def __init__(self, fields: Any, table: type) -> None:
        """Of fields of these types.

        Args:
            fields: numba's types of the fields, in their order.
            table: the class.
        """
        super().__init__(fields, table)
        self.name = f"*{self.name}"


def by_address(table: T) -> T:
    """Hands tables of this class over by their addresses. Kernels read their fields and make none of them.

    Args:
        table: a NamedTuple.
    """

    @typeof_impl.register(table)
    def _(value: Any, context: Any) -> ByAddress | None:
        fields = [typeof_impl(field, context) for field in value]
        return None if None in fields else ByAddress(fields, table)

    return table


@registry.register_default(ByAddress)
@final
class _Address(PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _BYTES)


def _numbers(kind: Any, path: tuple[int, ...] = ()) -> Iterator[tuple[Any, tuple[int, ...]]]:
    """The numbers and addresses that LLVM's value of a type is made of, and the way to each."""
    parts = kind.elements if isinstance(kind, ir.LiteralStructType) else ()
    if isinstance(kind, ir.ArrayType):
        parts = (kind.element,) * kind.count
    for index, part in enumerate(parts):
        yield from _numbers(part, (*path, index))
    if not isinstance(kind, ir.Aggregate):
        yield kind, path


def _places(context: Any, kind: ByAddress) -> list[int]:
    """Where each field begins, in words, and where the last one ends."""
    ends = [0]
    for field in list[Any](kind):
        ends.append(ends[-1] + sum(1 for _ in _numbers(context.get_value_type(field))))
    return ends


def _place(builder: Any, memory: Any, word: int, kind: Any) -> Any:
    at = builder.gep(memory, [ir.Constant(ir.IntType(64), _WORD * word)], inbounds=True)
    return builder.bitcast(at, kind.as_pointer())


@imputils.lower_getattr_generic(ByAddress)
def _field(context: Any, builder: Any, kind: Any, memory: Any, name: str) -> Any:
    index: int = kind.fields.index(name)
    fields, places = list[Any](kind), _places(context, kind)
    field: Any = context.get_value_type(fields[index])
    word = places[index]
    value = ir.Constant(field, ir.Undefined)
    for offset, (number, path) in enumerate(_numbers(field)):
        read = builder.load(_place(builder, memory, word + offset, number))
        # Nobody writes there, so it need be read only once, whatever is written elsewhere meanwhile.
        read.set_metadata("invariant.load", builder.module.add_metadata([]))
        value = builder.insert_value(value, read, path) if path else read
    return imputils.impl_ret_borrowed(context, builder, fields[index], value)


@boxing.unbox(ByAddress)
def _write(kind: Any, table: Any, c: Any) -> NativeValue:
    found = c.unbox(types.NamedTuple(kind.types, kind.instance_class), table)
    memory = cgutils.alloca_once(c.builder, ir.IntType(64), size=max(1, _places(c.context, kind)[-1]))
    memory = c.builder.bitcast(memory, _BYTES)
    word = 0
    for index, field in enumerate(kind.types):
        value = c.builder.extract_value(found.value, index)
        for number, path in _numbers(c.context.get_value_type(field)):
            one = c.builder.extract_value(value, path) if path else value
            c.builder.store(one, _place(c.builder, memory, word, number))
            word += 1
    # LLVM must not see that this is where it was written: what is told never to change has changed until now.
    same = ir.InlineAsm(ir.FunctionType(_BYTES, [_BYTES]), "", "=r,0,~{memory}", side_effect=True)
    return NativeValue(c.builder.call(same, [memory]), is_error=found.is_error, cleanup=found.cleanup)


@boxing.box(ByAddress)
def _read(kind: Any, memory: Any, c: Any) -> Any:
    fields = [_field(c.context, c.builder, kind, memory, name) for name in kind.fields]
    twin = types.NamedTuple(kind.types, kind.instance_class)
    return c.box(twin, c.context.make_tuple(c.builder, twin, fields))
