"""Equal eigenvalues leave their shapes to round-off; members on different processors must build the same ones."""

import os
import subprocess
import sys

import numpy as np
import pytest

from cotouch.body import canonical, lattice

# A cube, whose modes come in threes and more; ten of them end amidst equals. The last one takes the sparse solver.
SHAPES = """
import numpy as np
from cotouch.body import lattice
from cotouch.mechanics import model
cube = lattice((4, 4, 4), ground="all", ground_stiffness=10.0)
shapes = [cube.truncated(modes=10, contacts=[0, 63]).truncation.shapes, model(lattice((3, 3, 3)), basis="modal").modes]
large = lattice((8, 8, 8))
shapes.append(large.truncated(modes=10, contacts=[0, 511]).truncation.shapes)
print(*(repr(float(number)) for shape in shapes for number in np.sin(np.arange(shape.shape[0])) @ shape))
"""


def test_any_mixture_of_equals_gives_the_same():
    rng = np.random.default_rng(5)
    mass = np.diag(rng.uniform(0.5, 2.0, 20))
    values = np.array([0.0, 0.0, 0.0, 1.0, 2.0, 2.0 + 1e-13, 3.0])
    shapes = np.linalg.qr(rng.standard_normal((20, 7)))[0] / np.sqrt(np.diag(mass))[:, None]
    found = canonical(values, shapes, mass, 1e-9)
    assert np.allclose(found.T @ mass @ found, np.eye(7), atol=1e-14)
    for _ in range(5):
        turn = np.zeros((7, 7))
        for begin, end in ((0, 3), (3, 4), (4, 6), (6, 7)):
            turn[begin:end, begin:end] = np.linalg.qr(rng.standard_normal((end - begin, end - begin)))[0]
        turn[3, 3] = turn[6, 6] = -1.0
        assert np.allclose(canonical(values, shapes @ turn, mass, 1e-9), found, atol=1e-13)
        spread = found.T @ mass @ shapes  # nothing goes from one eigenspace into another
        assert np.abs(spread[(turn == 0.0)]).max() < 1e-14


@pytest.mark.parametrize("processor", ["Nehalem", "Sandybridge", "Haswell"])
def test_members_on_other_processors_build_the_same_shapes(processor: str, here: np.ndarray):
    """OpenBLAS has kernels of its own for each; where there is another library, all are one."""
    assert np.allclose(built(processor), here, rtol=0.0, atol=1e-9)


@pytest.fixture(scope="module")
def here() -> np.ndarray:
    return built(None)


def built(processor: str | None) -> np.ndarray:
    more = {} if processor is None else {"OPENBLAS_CORETYPE": processor}
    done = subprocess.run(
        [sys.executable, "-c", SHAPES], env={**os.environ, **more}, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return np.array(done.stdout.split(), dtype=np.float64)


def test_modes_that_were_cut_off_amidst_equals_are_the_first_of_more():
    cube = lattice((4, 4, 4), ground="all", ground_stiffness=10.0)
    few, more = (cube.truncated(modes=modes).truncation for modes in (10, 17))
    assert few is not None
    assert more is not None
    assert np.allclose(few.shapes, more.shapes[:, :10], atol=1e-10)
