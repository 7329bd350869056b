"""How tables of many arrays come to kernels: by address.

Numba hands a NamedTuple over field by field. A body with its world has nearly a thousand, every call of one kernel by
another repeated them all, and nine of ten instructions of the closed step did nothing else: compiling took most of its
time for them. A table that is made in Python and only read in kernels is written into memory once, where Python calls
the kernel, and handed on as one address.
"""
# numba hands over all that it knows, whether a function needs it or not.
# ruff: noqa: ARG001, ARG002

import operator
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from functools import cache
from importlib import import_module
from typing import Any, Generic, TypeVar, cast, final

import numpy as np
from numba.core import types
from numba.core.datamodel.models import PrimitiveModel
from numba.extending import NativeValue, typeof_impl

from cotouch.arrays import Long

# LLVM's types and numba's decorators have no types of their own.
ir: Any = import_module("llvmlite.ir")
cgutils: Any = import_module("numba.core.cgutils")
registry: Any = import_module("numba.core.datamodel.registry")
imputils: Any = import_module("numba.core.imputils")
boxing: Any = import_module("numba.core.pythonapi")
templates: Any = import_module("numba.core.typing.templates")

T = TypeVar("T", bound=type)
Table = TypeVar("Table", bound=tuple[object, ...])

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

    @property
    def key(self) -> Any:
        """By which numba compares types: the name says all that the fields' types would, which it would hash again."""
        return self.instance_class, self.name


def by_address(table: T, *, unseen: str | None = None, told: Callable[[Any], None] | None = None) -> T:
    """Hands tables of this class over by their addresses. Kernels read their fields and make none of them.

    Args:
        table: a NamedTuple.
        unseen: a field that kernels do not see, nor are they compiled anew for another type of it.
        told: is called with numba's type of that field before a kernel is run with such a table.
    """
    hidden = None if unseen is None else _names(table).index(unseen)

    @typeof_impl.register(table)
    def _(value: Any, context: Any) -> ByAddress | None:
        fields = [typeof_impl(field, context) for field in value]
        if None in fields:
            return None
        if hidden is not None:
            if told is not None:
                told(fields[hidden])
            fields[hidden] = types.none
        return ByAddress(fields, table)

    _tables.add(table)
    return table


# The classes that are handed over so.
_tables: set[type] = set()


def _names(table: Any) -> tuple[str, ...]:
    return table._fields


@final
class Each(Generic[Table]):
    """Tables of one class, such as one for each copy: a kernel takes the one that it needs and packs nothing again."""

    def __init__(self, tables: Sequence[Table]) -> None:
        """Of at least one table, all of the same types.

        Args:
            tables: of a class that is handed over by address, of arrays and numbers.
        """
        self.tables = tuple(tables)
        self._memory = [np.array([word for field in table for word in _words(field)]) for table in tables]
        self._places = np.array([memory.ctypes.data for memory in self._memory])
        self.place: int = self._places.ctypes.data

    def __getitem__(self, index: int) -> Table:
        return self.tables[index]

    def __len__(self) -> int:
        return len(self.tables)

    def __deepcopy__(self, memory: dict[int, object]) -> "Each[Table]":
        return Each(deepcopy(self.tables, memory))


def written(table: tuple[object, ...], first: int = 0) -> Long:
    """A table in memory as kernels find it there, and behind it the tables that it refers to.

    What this refers to by address must be kept as long as it is used: the table's arrays, and this array itself.

    Args:
        table: a NamedTuple of arrays, numbers, such tables and tuples of them.
        first: a word before all of them.
    """
    words, found = [first], list[tuple[int, tuple[object, ...]]]()
    starts: list[tuple[int, int]] = []
    _lay(tuple(table), words, found)
    while found:
        place, inner = found.pop()
        starts.append((place, len(words)))
        _lay(tuple(inner), words, found)
    memory = np.array(words, dtype=np.int64)
    for place, start in starts:
        memory[place] = memory.ctypes.data + _WORD * start
    return memory


def _lay(value: object, words: list[int], found: list[tuple[int, tuple[object, ...]]]) -> None:
    """Adds what a field is in memory, and to `found` where the address of which table belongs."""
    if type(value) in _tables:
        found.append((len(words), cast("tuple[object, ...]", value)))
        words.append(0)
    elif isinstance(value, tuple):
        for part in cast("tuple[object, ...]", value):
            _lay(part, words, found)
    else:
        words.extend([0] if value is None else _words(value))


def _words(value: Any) -> list[int]:
    """What LLVM's value of an array or a number is in memory, where nobody counts references."""
    array: Any = value
    if isinstance(value, np.ndarray):
        return [0, 0, array.size, array.itemsize, array.ctypes.data, *array.shape, *array.strides]
    return [np.float64(value).view(np.int64).item() if isinstance(value, float) else int(value)]


@final
class EachByAddress(types.Type):
    """Numba's type of `Each`: where the addresses of the tables are."""

    def __init__(self, table: ByAddress) -> None:
        """Of tables of one type.

        Args:
            table: the type of each.
        """
        super().__init__(f"each({table.name})")
        self.table = table


@typeof_impl.register(Each)
def _(value: Any, context: Any) -> EachByAddress | None:
    first, *others = (typeof_impl(table, context) for table in value.tables)
    return EachByAddress(first) if all(other == first for other in others) else None


@templates.infer_global(operator.getitem)
@final
class _Taken(templates.AbstractTemplate):
    def generic(self, args: Any, kws: Any) -> Any:
        if isinstance(args[0], EachByAddress) and isinstance(args[1], types.Integer):
            return templates.signature(args[0].table, args[0], types.intp)
        return None


@imputils.lower_builtin(operator.getitem, EachByAddress, types.Integer)
def _taken(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    tables, index = arguments
    places = builder.bitcast(tables, _BYTES.as_pointer())
    return _unchanging(builder, builder.load(builder.gep(places, [index], inbounds=True)))


def _unchanging(builder: Any, read: Any) -> Any:
    """A value that was loaded from where nobody writes: it need be read only once, whatever is written meanwhile."""
    read.set_metadata("invariant.load", builder.module.add_metadata([]))
    return read


@boxing.unbox(EachByAddress)
def _where(kind: Any, each: Any, c: Any) -> NativeValue:
    held = c.pyapi.object_getattr_string(each, "place")
    place = c.pyapi.long_as_longlong(held)
    c.pyapi.decref(held)
    return NativeValue(c.builder.inttoptr(place, _BYTES), is_error=c.pyapi.c_api_error())


@registry.register_default(EachByAddress)
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


@cache
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
    at = builder.gep(memory, [ir.Constant(ir.IntType(64), _WORD * places[index])], inbounds=True)
    value = builder.call(_loader(builder.module, context.get_value_type(fields[index])), [at])
    return imputils.impl_ret_borrowed(context, builder, fields[index], value)


def _loader(module: Any, kind: Any) -> Any:
    """The function that loads a field of LLVM's type, number by number.

    LLVM makes it a part of whoever calls it. Written out by numba for each access it was a third of all that numba
    writes, and LLVM reads.
    """
    name = f"load {kind}"
    if name in module.globals:
        return module.globals[name]
    loader = ir.Function(module, ir.FunctionType(kind, [_BYTES]), name)
    loader.linkage = "linkonce_odr"
    loader.attributes.add("alwaysinline")
    builder, value = ir.IRBuilder(loader.append_basic_block("entry")), ir.Constant(kind, ir.Undefined)
    for offset, (number, path) in enumerate(_numbers(kind)):
        read = _unchanging(builder, builder.load(_place(builder, loader.args[0], offset, number)))
        value = builder.insert_value(value, read, path) if path else read
    builder.ret(value)
    return loader


@boxing.unbox(ByAddress)
def _write(kind: Any, table: Any, c: Any) -> NativeValue:
    memory = _written(kind, table, c)
    # Whatever could not be read has said so to Python.
    return NativeValue(memory, is_error=cgutils.is_not_null(c.builder, c.pyapi.err_occurred()))


def _written(kind: ByAddress, table: Any, c: Any) -> Any:
    """Where a table of Python is from now on, in the memory of the function that asks."""
    memory = cgutils.alloca_once(c.builder, ir.IntType(64), size=max(1, _places(c.context, kind)[-1]))
    memory = c.builder.bitcast(memory, _BYTES)
    word = 0
    for place, field in enumerate(list[Any](kind)):
        word = _fill(field, c.pyapi.tuple_getitem(table, place), c, memory, word)
    # LLVM must not see that this is where it was written: what is told never to change has changed until now.
    same = ir.InlineAsm(ir.FunctionType(_BYTES, [_BYTES]), "", "=r,0,~{memory}", side_effect=True)
    return c.builder.call(same, [memory])


def _fill(kind: Any, given: Any, c: Any, memory: Any, word: int) -> int:
    """Writes one field.

    Args:
        kind: its type, which numba found by looking at what is given: a tuple is as long as it says.
        given: the field, in Python.
        c: numba's context of the function.
        memory: of the table.
        word: where the field begins.

    Returns:
        Where the next one does.
    """
    value = c.context.get_value_type(kind)
    if isinstance(kind, ByAddress):
        c.builder.store(_written(kind, given, c), _place(c.builder, memory, word, value))
    elif isinstance(kind, types.BaseTuple):
        parts: Any = kind
        for place, inner in enumerate(list[Any](parts)):
            word = _fill(inner, c.pyapi.tuple_getitem(given, place), c, memory, word)
        return word
    else:
        c.builder.call(_reader(kind, c), [given, _place(c.builder, memory, word, value)])
    return word + sum(1 for _ in _numbers(value))


def _reader(kind: Any, c: Any) -> Any:
    """The function that reads a value of a type into memory, or leaves an error with Python.

    Tables have hundreds of arrays of a few types. Numba would write out for each how it is read and what happens where
    that fails, and LLVM spent a third of its time on it.
    """
    module, name = c.builder.module, f"read {kind}"
    if name in module.globals:
        return module.globals[name]
    value = c.context.get_value_type(kind).as_pointer()
    reader = ir.Function(module, ir.FunctionType(c.pyapi.pyobj, [c.pyapi.pyobj, value]), name)
    reader.linkage = "internal"
    reader.attributes.add("noinline")
    builder = ir.IRBuilder(reader.append_basic_block("entry"))
    # Python holds what it hands over as long as it waits: no reference need be counted here.
    inner: Any = c.context.subtarget(enable_nrt=False).get_python_api(builder)
    read = inner.to_native_value(kind, reader.args[0])
    assert read.cleanup is None, kind
    builder.store(read.value, reader.args[1])
    builder.ret(inner.get_null_object())  # as numba's code does where it cannot go on
    return reader


@boxing.box(ByAddress)
def _read(kind: Any, memory: Any, c: Any) -> Any:
    fields = [_field(c.context, c.builder, kind, memory, name) for name in kind.fields]
    twin = types.NamedTuple(kind.types, kind.instance_class)
    return c.box(twin, c.context.make_tuple(c.builder, twin, fields))
