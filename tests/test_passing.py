"""Tables come to kernels by their addresses, and kernels read in them what Python wrote."""
# numba has no types
# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from typing import Any, NamedTuple

import numba
import numpy as np
import pytest
from numba.core.errors import TypingError

from cotouch.arrays import Float
from cotouch.compiled import subroutine
from cotouch.passing import by_address


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
