"""Functions of machine vectors as Python runs them: the same numbers, and the same that they cannot do."""

from math import exp

import numpy as np
import pytest

from cotouch.kernels import FourNumbers, as_written, inner, kernel, lower, root, size, upper, where


@inner
def _mixed(x: float, y: float) -> float:
    return root(size(x)) + where(x, lower(x, y), upper(x, y)) * y


@kernel
def _compiled(x: float, y: float) -> float:
    return _mixed(x, y)


@inner
def _of_one(x: float) -> float:
    return exp(x)


@pytest.mark.parametrize(("x", "y"), [(2.0, 3.0), (3.0, 2.0), (-2.0, 1.0), (-2.0, -3.0), (0.0, -1.0)])
def test_what_runs_as_it_is_written_gives_what_machine_code_gives(x: float, y: float) -> None:
    plain = as_written(_mixed)
    assert plain(x, y) == _compiled(x, y)
    four: object = plain(FourNumbers(x), y)  # pyright: ignore[reportArgumentType]
    assert isinstance(four, FourNumbers)
    assert four.value == _compiled(x, y)


def test_a_function_of_one_number_is_told_what_there_is_of_four() -> None:
    assert as_written(_of_one)(1.0) == np.exp(1.0)
    with pytest.raises(
        TypeError, match=r"a function of one number is asked for four at once; cotouch.kernels has root"
    ):
        as_written(_of_one)(FourNumbers(1.0))  # pyright: ignore[reportArgumentType]
