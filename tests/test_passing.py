"""Tables come to kernels by their addresses, and kernels read in them what Python wrote."""
# numba has no types
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import re
import sys
from copy import deepcopy
from typing import Any, NamedTuple

import numba
import numpy as np
import pytest
from numba.core.errors import TypingError

from cotouch.arrays import Float
from cotouch.compiled import intrinsic, subroutine
from cotouch.passing import ByAddress, Each, by_address, written


class Pair(NamedTuple):
    """A table that comes by its value, inside another."""

    places: Float
    weight: float


@by_address
class Inner(NamedTuple):
    """A table inside a table."""

    factors: Float
    offset: int


@by_address
class Outer(NamedTuple):
    """Has a field of each kind that tables of this package have."""

    matrix: Float
    inner: Inner
    pairs: tuple[Pair, Pair]
    flag: bool
    scale: float
    nothing: Any = None


def outer(seed: int = 1, **changed: Any) -> Outer:
    rng = np.random.default_rng(seed)
    pairs = (Pair(rng.random(3), 2.0), Pair(rng.random(3), -3.0))
    made = Outer(rng.random((3, 2)), Inner(rng.random(3), 5), pairs, flag=True, scale=0.5)
    return made._replace(**changed)


def plain(table: Outer, out: Float) -> int:
    """What is read, in Python."""
    for i in range(out.shape[0]):
        out[i] += table.matrix[i, 1] * table.inner.factors[i] + table.scale + table.inner.offset
        for pair in table.pairs:
            out[i] += pair.weight * pair.places[i]
    if table.nothing is None and table.flag:
        out[0] += 100.0
    return table.inner.offset


reader: Any = numba.njit(_nrt=False)(plain)


@numba.njit(_nrt=False)
def through(table: Any, out: Float) -> Any:
    return reader(table, out)


@numba.njit(_nrt=False)
def written_between(table: Any) -> Any:
    before = table.inner.factors[0]
    table.inner.factors[0] = before + 1.0
    return table.inner.factors[0] - before


@numba.njit
def handed_back(table: Any) -> Any:
    return table


@numba.njit
def inner_of(table: Any) -> Any:
    return table.inner


@pytest.mark.parametrize(
    "changed", [{}, {"flag": False}, {"nothing": 1.0}, {"matrix": np.zeros((5, 4))[::2, ::2][:, :2]}]
)
def test_every_field_is_read_as_it_was_written(changed: dict[str, Any]):
    table = outer(**changed)
    expected, found = np.zeros(3), np.zeros(3)
    plain(table, expected)
    assert through(table, found) == 5
    np.testing.assert_allclose(found, expected, rtol=1e-15)


def test_another_table_of_the_same_type_is_read_anew():
    for seed in range(5):
        expected, found = np.zeros(3), np.zeros(3)
        plain(outer(seed), expected)
        through(outer(seed), found)
        np.testing.assert_allclose(found, expected, rtol=1e-15)
    assert len(through.signatures) <= 4


def test_what_kernels_write_into_arrays_is_seen():
    table = outer()
    before = float(table.inner.factors[0])
    assert written_between(table) == pytest.approx(1.0)
    assert table.inner.factors[0] == before + 1.0


def test_it_comes_back_as_the_class_that_it_was():
    table = outer()
    back = handed_back(table)
    assert type(back) is Outer
    assert type(back.inner) is Inner
    np.testing.assert_array_equal(back.matrix, table.matrix)
    assert back.flag is True
    assert back.nothing is None
    assert inner_of(table).offset == 5


def test_a_kernel_takes_an_address_and_not_every_field():
    through(outer(), np.zeros(3))
    made: Any = next(iter(through.overloads.values()))._asdict()
    function = made["library"].get_function(made["fndesc"].llvm_func_name)
    # The table is one; the rest are where the result and an error go, and what numba has of an array.
    assert len(list(function.arguments)) == 1 + 2 + 7


def test_the_name_tells_it_from_a_table_by_value():
    assert str(numba.typeof(outer())).startswith("*Outer(")
    assert str(numba.typeof(Pair(np.zeros(3), 1.0))).startswith("Pair(")


def test_a_field_that_numba_does_not_know_is_refused():
    with pytest.raises(TypingError, match=r"annot determine Numba type of .*Outer"):
        through(outer(scale=object()), np.zeros(3))


def test_a_subroutine_keeps_it_on_disk_and_finds_it_again():
    kept: Any = subroutine(plain)
    kept.compile((numba.typeof(outer()), numba.typeof(np.zeros(3))))
    assert kept.signatures


@numba.njit(_nrt=False)
def taken(each: Any, i: int, out: Float) -> Any:
    inner = each[i]
    for k in range(inner.factors.shape[0]):
        out[k] = inner.factors[k] * inner.offset
        inner.factors[k] = -1.0
    return each[0].offset


@by_address
class Holder(NamedTuple):
    """Has tables of several."""

    each: Any
    one: int


@numba.njit(_nrt=False)
def held(holder: Holder, i: int) -> Any:
    return holder.each[i].offset + holder.one


def parts() -> tuple[Float, Each[Inner]]:
    """Three tables in the memory of one array, of different lengths; one has nothing."""
    whole = np.arange(1.0, 8.0)
    return whole, Each([Inner(whole[:3], 2), Inner(whole[3:3], 3), Inner(whole[3:], 10)])


def test_a_kernel_takes_one_of_several_and_writes_into_the_memory_of_all():
    whole, each = parts()
    out = np.zeros(4)
    assert taken(each, 2, out) == 2
    assert out.tolist() == [40.0, 50.0, 60.0, 70.0]
    assert whole.tolist() == [1.0, 2.0, 3.0, -1.0, -1.0, -1.0, -1.0]
    taken(each, 1, out)
    taken(each, 0, out)
    assert out.tolist() == [2.0, 4.0, 6.0, 70.0]
    assert (len(each), each[2].offset) == (3, 10)


def test_several_may_be_a_field_of_a_table():
    _, each = parts()
    assert [held(Holder(each, 100), i) for i in range(3)] == [102, 103, 110]


def test_a_copy_of_several_has_a_memory_of_its_own():
    whole, each = parts()
    copied = deepcopy(each)
    taken(copied, 0, np.zeros(4))
    assert whole[0] == 1.0
    assert copied[0].factors[0] == -1.0


@pytest.mark.parametrize("changed", [{}, {"flag": False}, {"nothing": 1.0}])
def test_what_is_written_is_what_kernels_find(changed: dict[str, Any]):
    table = outer(**changed)
    kind = numba.typeof(table)
    assert isinstance(kind, ByAddress)

    @intrinsic
    def after_the_first(typingctx: Any, words: Any) -> Any:
        def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
            data = context.make_array(signature.args[0])(context, builder, arguments[0]).data
            table = builder.gep(data, [context.get_constant(numba.types.intp, 1)])
            return builder.bitcast(table, context.get_value_type(signature.return_type))

        return kind(words), generate

    @numba.njit(_nrt=False)
    def read(words: Any, out: Float) -> Any:
        return reader(after_the_first(words), out)

    expected, found = np.zeros(3), np.zeros(3)
    words = written(table, first=17)
    assert words[0] == 17
    assert read(words, found) == plain(table, expected)
    np.testing.assert_allclose(found, expected, rtol=1e-15)


def test_numbers_come_as_they_are():
    @by_address
    class Numbers(NamedTuple):
        whole: int
        real: float
        truth: bool
        few: Any

    @numba.njit(_nrt=False)
    def read(each: Any, out: Float) -> Any:
        one = each[1]
        out[0], out[1], out[2], out[3] = one.whole, one.real, one.few[1], one.few[0]
        return one.truth

    out = np.zeros(4)
    each = Each([Numbers(0, 0.0, False, np.zeros(2, np.int32)), Numbers(-7, -0.1, True, np.array([3, -4], np.int32))])
    assert read(each, out)
    assert out.tolist() == [-7.0, -0.1, -4.0, 3.0]


def test_tables_of_several_types_are_refused():
    with pytest.raises(TypingError, match=r"annot determine Numba type of .*Each"):
        taken(Each([Inner(np.zeros(2), 1), Inner(np.zeros((2, 2)), 1)]), 0, np.zeros(2))


@numba.njit
def counted(table: Outer) -> float:
    """A routine for which numba counts references: it makes an array, and takes a part of one of the table's."""
    part = table.matrix[1:]
    return (part + np.ones(part.shape)).sum() + table.inner.factors[0]


def test_no_reference_is_kept_by_who_counts_them():
    table = outer()
    before = [sys.getrefcount(array) for array in (table.matrix, table.inner.factors, table.pairs[0].places)]
    for _ in range(20):
        assert counted(table) == pytest.approx(table.matrix[1:].sum() + 4.0 + table.inner.factors[0])
    assert [sys.getrefcount(array) for array in (table.matrix, table.inner.factors, table.pairs[0].places)] == before


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"matrix": "no array"}, "can't unbox array"),
        ({"matrix": np.zeros((3, 2), np.float32)}, "can't unbox array"),
        ({"scale": "no number"}, "bad argument type"),
        ({"inner": Inner(np.zeros(3), 2**70)}, "too (big|large)"),
    ],
)
def test_what_cannot_be_read_is_told_and_the_kernel_does_not_run(wrong: dict[str, Any], says: str):
    """Numba finds the types first; this enters the machine code with a table of others."""
    out = np.zeros(3)
    through(outer(), np.zeros(3))
    entry: Any = through.overloads[(numba.typeof(outer()), numba.typeof(out))].entry_point
    with pytest.raises((TypeError, ValueError, OverflowError), match=says):
        entry(outer(**wrong), out)
    np.testing.assert_array_equal(out, 0.0)


def test_what_reads_an_array_is_made_once_for_each_type():
    through(outer(), np.zeros(3))
    made: Any = next(iter(through.overloads.values()))._asdict()
    text = made["library"].get_llvm_str()
    assert len(re.findall(r"define internal .*read array\(float64, 1d, C\)", text)) == 1
    assert len(re.findall(r"call .*read array\(float64, 1d, C\)", text)) == 3
