"""Statics against answers that know nothing of elements: the elastica, and beam theory of small deflections."""

import numpy as np
import pytest
from tests.mechanics.statics import bent_beam, elastica

SLENDER, LENGTH = 10, 0.1


def test_the_elastica_is_the_textbooks() -> None:
    """Tip of a cantilever under P L² / EI = 1, 3 and 10 [Mattiasson 1981, table 1]: across, and shortened along."""
    for load, across, shorter in ((1.0, 0.30172, 0.05643), (3.0, 0.60325, 0.25442), (10.0, 0.81061, 0.55500)):
        tip = elastica(load, 1.0).tip
        assert tip[1] == pytest.approx(across, abs=1e-5)
        assert 1.0 - tip[0] == pytest.approx(shorter, abs=1e-5)


@pytest.mark.parametrize("model", ["corotated", "st-venant-kirchhoff"])
def test_a_cantilever_bent_far_comes_to_the_elastica(model: str) -> None:
    """Linear elements lock, as the square of their size; `benchmarks.acceptance` has a fine mesh within 2 %."""
    tip = elastica(3.0, LENGTH).tip
    coarse, fine = (bent_beam(model, n, slender=SLENDER, load=3.0)[0] for n in (2, 4))
    way = np.linalg.norm(tip - [LENGTH, 0.0])
    order = np.log2(np.linalg.norm(coarse - tip) / np.linalg.norm(fine - tip))
    assert 1.7 <= order <= 2.1
    assert np.linalg.norm((4.0 * fine - coarse) / 3.0 - tip) <= 0.02 * way


def test_a_small_deflection_is_timoshenkos() -> None:
    load = 1e-3
    shear = 3.0 * (1.0 / 12.0) * 2.0 / (5.0 / 6.0) / SLENDER**2  # 3 E I / (κ G A L²), G = E / 2
    expected = load / 3.0 * (1.0 + shear) * LENGTH
    coarse, fine = (bent_beam("corotated", n, slender=SLENDER, load=load)[0][1] for n in (3, 6))
    order = np.log2((expected - coarse) / (expected - fine))
    assert 1.7 <= order <= 2.1
    assert (4.0 * fine - coarse) / 3.0 == pytest.approx(expected, rel=0.02)
