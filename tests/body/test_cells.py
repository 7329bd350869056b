"""What a surface fills of a grid, against volumes, and weights that reproduce places."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.body.inside import LEAST_FILL, carriers, cells_of
from tests.body.shapes import box, joined, rotation, sphere, volume

from cotouch.body import CORNERS
from cotouch.errors import BodyError


@given(st.integers(1, 12), st.integers(1, 12), st.integers(1, 12), st.floats(-10.0, 10.0))
def test_a_box_on_the_grid_fills_its_cells_and_no_others(a: int, b: int, c: int, at: float):
    points, faces = box((a, b, c), (at, 0.3, -at))
    cells = cells_of(points, faces, max(a, b, c))
    assert cells.places.shape == (a * b * c, 3)
    assert np.allclose(cells.fill, 1.0, atol=1e-9)
    assert np.allclose(cells.origin, [at, 0.3, -at], atol=1e-9)


@given(st.integers(0, 200), st.integers(6, 20))
def test_the_filled_share_is_the_volume(seed: int, resolution: int):
    scale = np.random.default_rng(seed).uniform(0.5, 1.5, 3)
    points, faces = box(scale)
    points = points @ rotation(seed).T
    cells = cells_of(points, faces, resolution)
    # What is only touched counts a little, so the sum is a little high; lines are 4 to a cell, so it is not exact.
    touched = np.count_nonzero(cells.fill == LEAST_FILL) * LEAST_FILL
    found = float(cells.fill.sum()) * cells.spacing**3
    slack = touched * cells.spacing**3 + 0.05 * cells.spacing * 2 * (
        scale[0] * scale[1] + scale[1] * scale[2] + scale[2] * scale[0]
    )
    assert abs(found - volume(points, faces)) < slack


def test_cavities_are_empty_and_overlaps_count_once():
    outer, inner = box((6, 6, 6)), box((2, 2, 2), (2, 2, 2))
    hollow = cells_of(*joined(outer, (inner[0], inner[1][:, ::-1])), 6)
    assert hollow.fill.sum() == pytest.approx(6**3 - 8, abs=1e-6)
    twice = cells_of(*joined(box((4, 4, 4)), box((4, 4, 4), (2, 0, 0))), 6)
    # Skins that run inside touch cells which are full anyway.
    assert twice.fill.sum() == pytest.approx(6 * 16, abs=1e-6)


def test_a_cell_that_two_shells_fill_in_part_is_as_full_as_both_together():
    """Slabs from 0 to 0.6 and from 0.3 to 0.9 of a cell's height fill 0.9 of it, not all."""
    cells = cells_of(*joined(box((1, 1, 0.6)), box((1, 1, 0.6), (0, 0, 0.3))), 1)
    assert cells.fill == pytest.approx([0.9], abs=1e-9)


def test_a_thin_sheet_still_has_cells():
    points, faces = box((1.0, 1.0, 0.001))
    cells = cells_of(points, faces, 10)
    assert cells.places.shape[0] == 100
    assert np.all(cells.fill == LEAST_FILL)


@given(st.integers(0, 200), st.integers(1, 15))
def test_weights_reproduce_places_and_sum_to_one(seed: int, resolution: int):
    points, faces = sphere(2)
    points = (points * np.random.default_rng(seed).uniform(0.2, 1.0, 3)) @ rotation(seed).T + seed
    cells = cells_of(points, faces, resolution)
    rows, weights = carriers(points, faces, cells)
    corners = cells.origin + cells.spacing * (cells.places[rows][:, None] + CORNERS[None])
    assert np.allclose(weights.sum(axis=1), 1.0, atol=1e-12)
    assert np.allclose(np.einsum("vk,vkd->vd", weights, corners), points, rtol=0.0, atol=1e-11 * (1 + seed))
    assert weights.min() > -1e-4


def test_too_fine_is_refused_before_anything_is_allocated():
    with pytest.raises(BodyError, match="resolution 100000 makes a grid of 100000 x 100000 x 100000 cells"):
        cells_of(*box(), 100_000)
