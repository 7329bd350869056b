"""Frames against a decoder of their own and against the skin's own interpolation."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.web.fake_session_api import made_body
from tests.web.inside import FrameEncoder, beside_nodes, nodes_of_points
from tests.web.reader import read_frame

from cotouch.body import Placed, ToolBody, chain, rigid_box, together
from cotouch.observers import CopyView, HandView

SOFT = made_body("3d")


def view(slot: int, displacement: np.ndarray, **entries: object) -> CopyView:
    return CopyView(
        **({"slot": slot, "time": 9.0, "step": 1, "displacement": displacement, "direct": True, "hands": ()} | entries)
    )


def shown(encoder: FrameEncoder, views: list[CopyView], slots: set[int] | None = None) -> dict:
    by_slot = {v.slot: v for v in views}
    encoder.update(by_slot, set(by_slot))
    frame = encoder.frame(slots or set(by_slot), number=7, time=10.0, start=4.0, echo=3, waited=0.0015)
    return read_frame(frame)


def moved(rng: np.random.Generator, size: float) -> np.ndarray:
    return (size * rng.standard_normal((SOFT.nodes, 3))).astype(np.float32)


@given(st.integers(0, 2**32 - 1), st.floats(1e-9, 10.0))
def test_points_are_where_the_skin_is(seed: int, size: float):
    rng = np.random.default_rng(seed)
    views = [view(slot, moved(rng, size)) for slot in (0, 2, 3)]
    picture = shown(FrameEncoder(SOFT), views)
    assert sorted(picture.copies) == [0, 2, 3]
    for one in views:
        want = SOFT.skin.carried(one.displacement)
        error = np.abs(picture.copies[one.slot].displacement - want).max()
        assert error <= 0.5 * picture.scale + 1e-6 * size
        assert picture.scale < 1e-3 * size  # and the range is used


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_a_body_without_skin_shows_its_nodes(dimension: int):
    body = chain(5, dimension=dimension)
    field = np.arange(5 * dimension, dtype=np.float32).reshape(5, dimension) / 100.0
    picture = shown(FrameEncoder(body), [view(1, field)])
    assert picture.points == 5
    want = np.zeros((5, 3))
    want[:, :dimension] = field
    np.testing.assert_allclose(picture.copies[1].displacement, want, atol=picture.scale)


def test_what_stands_in_front():
    hand = HandView(
        mode="grab",
        node=12,
        target=np.array([0.1, 0.2, 0.3], np.float32),
        place=np.array([0.4, 0.5, 0.6], np.float32),
        force=np.array([7.0, 8.0, 9.0], np.float32),
        radius=0.25,
    )
    still = np.zeros((SOFT.nodes, 3), np.float32)
    ledger = {"energy": 1.5, "supplied": 2.5, "lost": 3.5, "linked": 4.5}
    picture = shown(
        FrameEncoder(SOFT),
        [view(4, still, hands=(hand, hand), **ledger), view(1, still, direct=False, time=9.75)],
    )
    assert (picture.number, picture.time, picture.points) == (7, 6.0, SOFT.skin.vertices.shape[0])
    assert (picture.echo, picture.waited_us) == (3, 1500)
    held, other = picture.copies[4], picture.copies[1]
    assert (held.mode, held.direct, held.has_hand, held.hands, held.node) == ("grab", True, True, 2, 12)
    np.testing.assert_allclose([*held.target, *held.place, *held.force], [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 7, 8, 9])
    assert (held.age, held.radius, held.ledger) == (1.0, 0.25, (1.5, 2.5, 3.5, 4.5))
    assert (other.mode, other.direct, other.has_hand, other.hands, other.node) == ("free", False, False, 0, -1)
    assert other.age == 0.25


def test_nothing_is_worked_out_twice():
    rng = np.random.default_rng(1)
    encoder = FrameEncoder(SOFT)
    one, two = view(0, moved(rng, 0.01)), view(1, moved(rng, 0.01))
    first = shown(encoder, [one, two])
    again = shown(encoder, [one, two])
    assert encoder.passes == 1
    np.testing.assert_array_equal(first.copies[0].displacement, again.copies[0].displacement)
    newer = view(1, 0.9 * two.displacement)
    third = shown(encoder, [one, newer])
    assert encoder.passes == 2
    np.testing.assert_array_equal(first.copies[0].displacement, third.copies[0].displacement)
    assert (
        np.abs(third.copies[1].displacement - SOFT.skin.carried(newer.displacement)).max() <= 0.5 * third.scale + 1e-7
    )


def test_a_copy_that_goes_far_changes_the_scale_of_all():
    rng = np.random.default_rng(2)
    encoder = FrameEncoder(SOFT)
    calm = view(0, moved(rng, 0.001))
    fine = shown(encoder, [calm, view(1, moved(rng, 0.001))])
    coarse = shown(encoder, [calm, view(1, moved(rng, 1.0))])
    assert coarse.scale > 100.0 * fine.scale
    error = np.abs(coarse.copies[0].displacement - SOFT.skin.carried(calm.displacement)).max()
    assert error <= 0.5 * coarse.scale + 1e-9
    fine_again = shown(encoder, [calm, view(1, moved(rng, 0.001))])
    assert fine_again.scale == fine.scale


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e30])
def test_a_copy_that_broke_does_not_break_the_frame(bad: float):
    field = np.zeros((SOFT.nodes, 3), np.float32)
    field[3] = bad
    picture = shown(FrameEncoder(SOFT), [view(0, field), view(1, np.zeros_like(field))])
    assert np.isfinite(picture.copies[0].displacement).all()
    assert not picture.copies[1].displacement.any()


def test_who_asked_for_one_copy_gets_one():
    rng = np.random.default_rng(3)
    encoder = FrameEncoder(SOFT)
    views = [view(slot, moved(rng, 0.01)) for slot in range(3)]
    assert sorted(shown(encoder, views, {2}).copies) == [2]
    encoder.update({v.slot: v for v in views}, {1})
    assert sorted(read_frame(encoder.frame({0, 1, 2}, number=1, time=0.0, start=0.0)).copies) == [1]


def test_a_tool_is_seen_in_its_users_copy_alone_and_held_in_none():
    die, bar = rigid_box([0.02, 0.02, 0.02], mass=0.1), rigid_box([0.04, 0.01, 0.01], mass=0.1)
    tool = Placed(body=bar, name="bar", at=(0.0, 0.0, 0.05), tool=ToolBody(owner=1, copies=2))
    body = together([Placed(body=die, name="die"), tool])
    assert body.skin is not None
    first, still = die.skin.vertices.shape[0], np.zeros((8, 3), np.float32)
    picture = shown(FrameEncoder(body), [view(slot, still) for slot in (0, 1)])
    places = [body.skin.vertices + picture.copies[slot].displacement for slot in (0, 1)]
    assert np.ptp(places[0][first:], axis=0) == pytest.approx(0.0, abs=2 * picture.scale)
    assert places[1] == pytest.approx(body.skin.vertices)
    assert places[0][:first] == pytest.approx(places[1][:first])
    nodes = nodes_of_points(body)
    assert (nodes[first:] == body.holds).all()
    assert nodes[:first] == pytest.approx(np.arange(4, 4 + first))
    assert beside_nodes(body)[:first] == pytest.approx(0.0)
