"""States by index: whole ones only, each step its own, whatever the order they came in."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import datagrams, heading, layout, state_of

from cotouch.errors import SessionError
from cotouch.peer import LinkHeader, LinkState, Sample
from cotouch.samples import IndexedAssembly, Refusal, SampleCodec

SHAPE = layout(130, 3)  # three chunks
CODEC = SampleCodec(SHAPE)


def chunk(step: int, at: int, **changes: object):
    out = CODEC.read(datagrams(CODEC, state_of(SHAPE, step), heading(step, **changes))[at], epoch=3, sender=1)
    assert not isinstance(out, Refusal)
    return out


def assembly(delay: int = 2) -> IndexedAssembly:
    return IndexedAssembly(SHAPE, sender=1, initial=np.zeros((130, 4)), delay=delay, stamp=-0.5)


def remembered(held: IndexedAssembly, steps: range) -> int:
    """Of how many of these steps the first chunk is known already; newest first, for asking may push out the oldest."""
    return sum(held.take(chunk(step, 0)) is Refusal.STALE for step in reversed(steps))


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 2)), max_size=60), st.integers(1, 4))
def test_each_step_uses_its_index_or_the_newest_whole_one_before(arrivals: list[tuple[int, int]], delay: int):
    held, have, k = assembly(delay), {step: set() for step in range(10)}, 0
    whole: set[int] = set()
    for step, at in arrivals:
        held.take(chunk(step, at))
        if step > max((w for w in whole if w <= k - 1 - delay), default=-1):
            have[step].add(at)
        whole = {step for step, parts in have.items() if len(parts) == 3}
        assert held.ready(k) == (k < delay or max(whole, default=-1) >= k - delay)
        if held.ready(k) and k < 10:
            expected = max((w for w in whole if w <= k - delay), default=-1)
            chosen = held.choose(k)
            assert chosen.index == expected
            if expected >= 0:
                assert np.array_equal(chosen.position, state_of(SHAPE, expected))
                assert chosen.stamp == 0.001 * expected
            k += 1


def test_a_lost_chunk_costs_its_index_and_no_more():
    held = assembly(1)
    for step in range(4):
        for at in range(3):
            if (step, at) != (1, 1):
                assert held.take(chunk(step, at)) is None
    assert [held.choose(k).index for k in range(5)] == [-1, 0, 0, 2, 3]
    assert held.oldest == 0.003
    assert held.complete
    assert held.take(chunk(1, 1)) is Refusal.STALE


def test_a_self_paced_peer_waits_for_its_index_but_not_for_a_lost_one():
    held = assembly(1)
    assert held.ready(0)
    assert not held.ready(1)
    for at in range(2):
        held.take(chunk(0, at))
    assert not held.ready(1)  # a part is not enough
    for at in range(3):
        held.take(chunk(1, at))
    assert held.ready(1)
    assert held.choose(1).index == -1
    held.take(chunk(0, 2))  # late after all, and still newer than what is in use
    assert held.choose(1).index == 0


def test_memory_is_bounded_whatever_is_sent():
    held = assembly(2)
    assert held.take(chunk(5_000_000, 0)) is None
    for step in range(1000):
        held.take(chunk(step, 0))
    assert 1 + remembered(held, range(1000)) == 66
    for at in range(3):
        held.take(chunk(2000, at))
    assert held.take(chunk(2067, 0)) is Refusal.INDEX
    for step in range(2001, 2400):
        for at in range(3):
            held.take(chunk(step, at))
    assert remembered(held, range(2000, 2400)) == 66


def test_whoever_began_earlier_or_later_costs_no_memory():
    """A neighbour may say any index first; this end counts from there."""
    held = assembly(2)
    for at in range(3):
        held.take(chunk(3, at))
    held.shift = held.newest - 1_000_000
    for step in range(4, 2000):
        for at in range(3):
            held.take(chunk(step, at))
    assert remembered(held, range(3, 2000)) <= 66
    assert held.choose(1_001_990).index == 3 + 1990 - 2
    ahead = assembly(2)
    for at in range(3):
        ahead.take(chunk(5000, at))
    ahead.shift = ahead.newest
    assert [ahead.choose(k).index for k in range(4)] == [-1, -1, 5000, 5000]
    assert [ahead.ready(k) for k in range(4)] == [True, True, True, False]


def test_words_and_duplicates():
    held = assembly(1)
    for at, header in enumerate(
        [LinkHeader(LinkState.READY, 4, 2), LinkHeader(LinkState.READY, 4, 2), LinkHeader(LinkState.GUARDED, 4, 2)]
    ):
        assert held.take(chunk(0, at, header=header)) is None
    assert held.take(chunk(0, 0)) is Refusal.STALE
    assert held.choose(1).header == LinkHeader(LinkState.GUARDED, 4, 2)
    whole = Sample(
        sender=1, index=1, stamp=0.001, position=np.ones((130, 4)), header=LinkHeader(LinkState.COUPLED, 4, 2)
    )
    assert held.offer(whole)
    assert not held.offer(whole)
    assert held.choose(2) is whole


def test_a_delay_below_one_step_cannot_be():
    with pytest.raises(SessionError, match="delay is 0"):
        assembly(0)


def test_a_neighbour_that_counts_faster_is_followed_where_it_is():
    """Clocks differ a little, and whoever stood still is behind: what is due has then long been given up."""
    held = assembly(2)
    for step in range(200):
        for at in range(3):
            held.take(chunk(step, at))
    assert held.choose(10).index == 198
    for k in range(11, 20):
        for at in range(3):
            held.take(chunk(189 + k, at))
        assert held.ready(k)
        assert held.choose(k).index == 188 + k
