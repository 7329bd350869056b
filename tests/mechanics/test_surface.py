"""Boxes hold their triangles however the body moves, and vertices are where the body carries them."""

import numpy as np
import pytest
from tests.mechanics.inside import Fit, box_distance, fit_of, place_vertex, refit

from cotouch.body import Body, Placed, lattice, rigid_box, together
from cotouch.errors import BodyError
from cotouch.mechanics import Basis, Surface, model, surface_of

Array = np.ndarray


def block() -> Body:
    return lattice((4, 3, 3), mass=0.3, stiffness=400.0, spacing=0.02, ground="z-", ground_stiffness=2000.0)


KINDS: list[tuple[str, Body, Basis]] = [
    ("node", block(), "nodal"),
    ("full", block().as_full(), "nodal"),
    ("modal", block(), "modal"),
    ("full modal", block().as_full(), "modal"),
    ("truncated", block().truncated(modes=6, contacts=[0, 5]), "auto"),
]


def members(surface: Surface, box: int) -> list[int]:
    """Triangles of a box."""
    left, right = (int(c) for c in surface.child[box])
    if left >= 0:
        return members(surface, left) + members(surface, right)
    return [int(t) for t in surface.leaf[-1 - left : -1 - left + right]]


def moved(body: Body, rng: np.random.Generator, *, size: float) -> Array:
    """A stretch, a turn and a shift, and noise."""
    change = np.eye(3) + size * rng.normal(size=(3, 3))
    return body.rest @ change.T - body.rest + size * rng.normal(size=3) + 0.1 * size * rng.normal(size=body.rest.shape)


@pytest.mark.parametrize(("body", "basis"), [k[1:] for k in KINDS], ids=[k[0] for k in KINDS])
@pytest.mark.parametrize("size", [0.0, 1e-3, 0.3])
def test_boxes_hold_their_triangles(body: Body, basis: Basis, size: float):
    rng = np.random.default_rng(5)
    carrier = model(body, basis=basis)
    surface = surface_of(carrier)
    fit: Fit = fit_of(surface, carrier)
    modal = surface.shape.shape[0] > 0
    assert sorted(members(surface, 0)) == list(range(surface.corner.shape[0]))
    for _ in range(5):
        position = carrier.to_rows(moved(body, rng, size=size))
        refit(surface, fit, position, carrier.lanes)
        for v in range(surface.rest.shape[0]):
            place_vertex(surface, fit, v, position, carrier.lanes)
        assert body.skin is not None
        places = body.skin.vertices + body.skin.carried(carrier.to_nodes(position))
        assert fit.place[:, :3] == pytest.approx(places, abs=1e-13)
        for box in range(surface.child.shape[0]):
            inside = box_distance(surface, fit, box, *places.mean(axis=0), position, carrier.lanes)
            corners = places[surface.corner[members(surface, box)]].reshape(-1, 3)
            low, high = fit.low[box, :3], fit.high[box, :3]
            assert np.all(low <= corners.min(axis=0) + 1e-13)
            assert np.all(high >= corners.max(axis=0) - 1e-13)
            if not modal:
                assert low == pytest.approx(corners.min(axis=0), abs=1e-13)
                assert high == pytest.approx(corners.max(axis=0), abs=1e-13)
            gap = np.maximum(np.maximum(low - places.mean(axis=0), places.mean(axis=0) - high), 0.0)
            assert inside == pytest.approx(gap @ gap, abs=1e-16)


def test_boxes_hold_what_went_little_since_they_were_fitted() -> None:
    """They stay as they are, and no point of what they hold is nearer than they say."""
    body, rng = block(), np.random.default_rng(2)
    carrier = model(body, basis="nodal")
    surface = surface_of(carrier)
    fit: Fit = fit_of(surface, carrier)
    field = moved(body, rng, size=0.1)
    refit(surface, fit, carrier.to_rows(field), carrier.lanes)
    low = fit.low.copy()
    for _ in range(20):
        field = field + 3e-5 * rng.normal(size=field.shape)
        position = carrier.to_rows(field)
        refit(surface, fit, position, carrier.lanes)
        for v in range(surface.rest.shape[0]):
            place_vertex(surface, fit, v, position, carrier.lanes)
        assert body.skin is not None
        assert fit.place[:, :3] == pytest.approx(body.skin.vertices + body.skin.carried(field), abs=1e-13)
        assert np.array_equal(fit.low, low)
        point = rng.uniform(-0.1, 0.2, 3)
        for box in range(surface.child.shape[0]):
            corners = fit.place[surface.corner[members(surface, box)], :3].reshape(-1, 3)
            gap = np.maximum(np.maximum(corners.min(axis=0) - point, point - corners.max(axis=0)), 0.0)
            assert box_distance(surface, fit, box, *point, position, carrier.lanes) <= gap @ gap
    refit(surface, fit, carrier.to_rows(field + 0.01), carrier.lanes)
    assert fit.slack[0] == 0.0
    assert np.all(fit.low[:, :3] > low[:, :3] + 0.005)


def test_needs_three_axes():
    with pytest.raises(BodyError, match="2 axes"):
        surface_of(model(lattice((3, 3))))


def test_a_skin_of_rigid_parts_among_soft_ones_is_no_faster_than_its_bound() -> None:
    bar = Placed(body=rigid_box([0.3, 0.02, 0.02], mass=1.0), name="bar")
    body = together([bar, Placed(body=lattice((3, 3, 3), mass=0.1, stiffness=400.0), name="block", at=(0.0, 0.0, 9.0))])
    assert body.skin is not None
    weights = body.skin.interpolation(body.nodes).toarray()
    worst = int(np.abs(weights).sum(axis=1).argmax())
    skin = body.skin.carried(np.outer(np.sign(weights[worst]), [1.0, 0.0, 0.0]))  # no node is faster than 1 m/s
    fastest = float(np.linalg.norm(skin, axis=1).max())
    assert 1.5 < fastest <= surface_of(model(body)).swing * (1.0 + 1e-12)
