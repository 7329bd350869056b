"""Angles of four vectors at once: to rounding, in every direction."""

import numpy as np
import numpy.typing as npt

from cotouch.kernels import angles, kernel, load, store

Float = npt.NDArray[np.float64]


@kernel
def _all(x: Float, y: Float, out: Float, lanes: tuple[int, ...]) -> None:
    for i in range(x.shape[0]):
        store(out, i, angles(load(x, i, lanes), load(y, i, lanes)), lanes)


def test_they_are_those_of_a_library() -> None:
    turn, long = np.linspace(-np.pi, np.pi, 4001)[:-1], 10.0 ** np.linspace(-9, 9, 4000)
    x, y = (long * np.cos(turn)).reshape(-1, 4), (long * np.sin(turn)).reshape(-1, 4)
    out = np.zeros_like(x)
    _all(x, y, out, (0,) * 4)
    assert np.max(np.abs(out - np.arctan2(y, x))) <= 9e-16
    small = (np.abs(out) < 0.1) & (y != 0.0)
    np.testing.assert_allclose(out[small], np.arctan2(y, x)[small], rtol=5e-16)


def test_what_lies_on_an_axis_and_what_has_no_direction() -> None:
    x, y = np.array([[1.0, 0.0, -1.0, 0.0], [0.0, 2.0, 3.0, -3.0]]), np.array([[0.0, 1.0, 0.0, -1.0], [0.0, 2, -3, 3]])
    out = np.zeros_like(x)
    _all(x, y, out, (0,) * 4)
    assert np.allclose(out, np.arctan2(y, x), rtol=2e-16, atol=0.0)
