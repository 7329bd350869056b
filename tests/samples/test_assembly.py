"""The assembly against the plainest model: for every row, the newest that came."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import datagrams, heading, layout, state_of

from cotouch.peer import LinkHeader, LinkState, Sample
from cotouch.samples import Assembly, Refusal, SampleCodec

SHAPE = layout(130, 3)  # three chunks: 45, 45, 40
CODEC = SampleCodec(SHAPE)


def chunk(step: int, at: int, **changes: float):
    out = CODEC.read(datagrams(CODEC, state_of(SHAPE, step), heading(step, **changes))[at], epoch=3, sender=1)
    assert not isinstance(out, Refusal)
    return out


def assembly(initial: float = 0.0) -> Assembly:
    return Assembly(SHAPE, sender=1, initial=np.full((130, 4), initial), stamp=-0.5)


@given(st.lists(st.tuples(st.integers(0, 6), st.integers(0, 2)), max_size=40))
def test_every_row_is_the_newest_that_came(arrivals: list[tuple[int, int]]):
    """Any order, any losses, any repetitions."""
    held, newest = assembly(), {0: -1, 1: -1, 2: -1}
    for step, at in arrivals:
        reason = held.take(chunk(step, at))
        assert reason is (None if step > newest[at] else Refusal.STALE)
        newest[at] = max(newest[at], step)
    expected = np.zeros((130, 4))
    for at, step in newest.items():
        if step >= 0:
            expected[SHAPE.span(at)] = state_of(SHAPE, step)[SHAPE.span(at)]
    assert np.array_equal(held.state, expected)
    assert held.indices == list(newest.values())
    assert held.stamps == [0.001 * step if step >= 0 else -0.5 for step in newest.values()]
    assert held.oldest == min(held.stamps)
    assert held.newest == max(newest.values())
    assert held.complete == (min(newest.values()) >= 0)


@given(st.permutations([(step, at) for step in range(4) for at in range(3)]))
def test_the_order_does_not_matter(order: list[tuple[int, int]]):
    held = assembly()
    for step, at in [*order, *order]:
        held.take(chunk(step, at))
    assert np.array_equal(held.state, state_of(SHAPE, 3))
    assert held.stamps == [0.003] * 3


def test_a_lost_chunk_ages_only_its_rows():
    held = assembly()
    for step in range(5):
        for at in range(3):
            if (step, at) != (4, 1):
                held.take(chunk(step, at))
    assert held.stamps == [0.004, 0.003, 0.004]
    assert held.choose(9).stamp == 0.003


@pytest.mark.parametrize("stamp", [0.005, 0.004])
def test_a_later_step_with_an_earlier_stamp_is_refused(stamp: float):
    held = assembly()
    held.take(chunk(5, 0))
    before = held.state.copy()
    assert held.take(chunk(6, 0, stamp=stamp)) is Refusal.BACKWARDS
    assert np.array_equal(held.state, before)


def test_a_first_sample_may_have_any_stamp():
    """Clocks have offsets: what stands for the time before is on nobody's clock."""
    assert assembly().take(chunk(0, 0, stamp=-1e6)) is None


def test_padding_stays_zero():
    held = assembly()
    for at in range(3):
        held.take(chunk(2, at))
    assert not held.state[:, 3].any()


def test_reduced_coordinates_fill_all_rows():
    basis = np.linalg.qr(np.random.default_rng(0).normal(size=(130, 9)))[0]
    shape = layout(130, 3, basis=basis)
    codec, held = SampleCodec(shape), Assembly(shape, sender=1, initial=np.zeros((130, 4)))
    state = np.zeros((130, 4))
    state[:, :3] = basis @ np.random.default_rng(1).normal(size=(9, 3))
    held.take(codec.read(datagrams(codec, state, heading())[0], epoch=3, sender=1))
    assert np.allclose(held.state, state, atol=1e-14)


def test_whole_samples_may_come_another_way():
    held = assembly()
    assert held.offer(Sample(sender=1, index=3, stamp=0.003, position=state_of(SHAPE, 3)))
    assert not held.offer(Sample(sender=1, index=3, stamp=0.003, position=state_of(SHAPE, 1)))
    assert not held.offer(Sample(sender=1, index=4, stamp=0.002, position=state_of(SHAPE, 4)))
    assert held.take(chunk(2, 0)) is Refusal.STALE
    assert np.array_equal(held.state, state_of(SHAPE, 3))


def test_nothing_is_relied_on_before_all_rows_are_there():
    held = assembly()
    for at in range(2):
        held.take(chunk(3, at, header=LinkHeader(LinkState.COUPLED, 4, 2)))
        assert (held.choose(0).index, held.choose(0).stamp) == (-1, -math.inf)
        assert held.choose(0).header.state == LinkState.GUARDED
    held.take(chunk(3, 2, header=LinkHeader(LinkState.COUPLED, 4, 2)))
    assert (held.choose(0).index, held.choose(0).stamp, held.choose(0).header) == (
        3,
        0.003,
        LinkHeader(LinkState.COUPLED, 4, 2),
    )


@given(st.lists(st.tuples(st.integers(0, 2), st.integers(1, 3), st.integers(0, 3)), min_size=3, max_size=3))
def test_chunks_of_different_states_or_epochs_are_as_good_as_the_worst(headers: list[tuple[int, int, int]]):
    held = assembly()
    for at, header in enumerate(headers):
        held.take(chunk(at, at, header=LinkHeader(*header)))
    state, epoch, received, *_ = held.header
    assert (epoch, received) == headers[2][1:]  # the newest
    alike = len({header[1] for header in headers}) == 1
    assert state == (min(header[0] for header in headers) if alike else LinkState.GUARDED)
