"""Machine vectors inside kernels: one lane is a float, four are a vector."""

from typing import Any

import numba
import numpy as np
import pytest

from cotouch.kernels import WIDTHS, at, four, kernel, load, put, root, size, splat, store, total, transposed, where

LANES = [(0,) * width for width in WIDTHS]


@kernel
def _combine(a: Any, b: Any, scalar: float, out: Any, lanes: Any) -> float:
    result = 0.0
    for i in range(a.shape[0]):
        x, y = load(a, i, lanes), load(b, i, lanes)
        store(out, i, scalar * x + y * scalar - (scalar - x) * (y - scalar) + (scalar + y), lanes)
        result += total(x * y)
    return result


@kernel
def _shuffle(a: Any, out: Any, lanes: Any) -> None:
    columns = transposed(load(a, 0, lanes), load(a, 1, lanes), load(a, 2, lanes), load(a, 3, lanes))
    for k in range(4):
        store(out, k, columns[k], lanes)
    store(out, 4, where(load(a, 0, lanes), root(size(load(a, 1, lanes))), -1.0), lanes)
    store(out, 5, four(at(a, 3), at(a, 2), where(at(a, 1), 1.0, 2.0), root(at(a, 0))), lanes)


@kernel
def _fill(out: Any, row: int, value: float, lanes: Any) -> None:
    store(out, row, splat(value, lanes), lanes)


@kernel
def _element(array: Any, index: Any) -> float:
    return at(array, index)


@kernel
def _set(array: Any, index: Any, value: Any) -> None:
    put(array, index, value)


@pytest.mark.parametrize("lanes", LANES, ids=len)
def test_arithmetic_is_that_of_numpy(lanes: tuple[int, ...]):
    rng = np.random.default_rng(0)
    a, b = rng.normal(size=(2, 5, len(lanes)))
    out = np.full_like(a, np.nan)
    result = _combine(a, b, 1.7, out, lanes)
    assert np.allclose(out, 1.7 * a + b * 1.7 - (1.7 - a) * (b - 1.7) + (1.7 + b), rtol=1e-13, atol=1e-14)
    assert result == pytest.approx(np.sum(a * b), rel=1e-13)


def test_lanes_are_shuffled_and_chosen():
    a, out = np.random.default_rng(1).normal(size=(4, 4)), np.zeros((6, 4))
    a[0] = [4.0, -1.0, 0.0, 2.0]
    _shuffle(a, out, (0,) * 4)
    assert np.array_equal(out[:4], a.T)
    assert np.array_equal(out[4], np.where(a[0] > 0.0, np.sqrt(np.abs(a[1])), -1.0))
    assert np.array_equal(out[5], [2.0, 0.0, 2.0, 2.0])


@pytest.mark.parametrize("lanes", LANES, ids=len)
def test_store_writes_one_row(lanes: tuple[int, ...]):
    out = np.zeros((5, len(lanes)))
    _fill(out, 3, 2.5, lanes)
    expected = np.zeros((5, len(lanes)))
    expected[3] = 2.5
    assert np.array_equal(out, expected)


def test_unaligned_rows_can_be_read_and_written():
    """Arrays of a batch start anywhere: a vector need not lie on a multiple of its size."""
    whole = np.zeros(4 * 6 + 1)
    out = whole[1:].reshape(6, 4)
    _fill(out, 2, 1.5, (0,) * 4)
    assert np.array_equal(out[2], np.full(4, 1.5))
    assert np.count_nonzero(whole) == 4


@pytest.mark.parametrize("dtype", [np.float64, np.int32, np.int64])
def test_at_reads_an_element(dtype: Any):
    assert [_element(np.array([3, -7, 5], dtype=dtype), i) for i in range(3)] == [3, -7, 5]


@pytest.mark.parametrize("dtype", [np.float64, np.int32, np.int64, np.bool_])
@pytest.mark.parametrize("shape", [(6,), (3, 2), (2, 3, 4)])
def test_elements_are_those_of_numpy(shape: tuple[int, ...], dtype: Any):
    array = np.arange(np.prod(shape)).reshape(shape) % 5
    array = (array > 2) if dtype is np.bool_ else (array - 2).astype(dtype)
    target = np.zeros_like(array)
    for flat, index in enumerate(np.ndindex(shape)):
        assert _element(array, index) == array[index]
        assert _element(array, flat) == array[index]
        _set(target, index if flat % 2 else flat, array[index])
    assert np.array_equal(target, array)


def test_an_index_needs_every_dimension():
    with pytest.raises(numba.TypingError, match="has 3 dimensions, not 2"):
        _element(np.zeros((2, 2, 2)), (0, 1))


def test_strided_fields_are_refused_when_compiling():
    with pytest.raises(numba.TypingError, match="kernels read C-contiguous arrays only"):
        _fill(np.zeros((6, 4))[::2], 0, 1.0, (0,) * 4)
