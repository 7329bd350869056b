import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from cotouch.peer import ConstantLink, FreshestLink, Sample

INITIAL = Sample(sender=1, index=-1, stamp=0.0, position=np.zeros((1, 1)))


def sample(index: int) -> Sample:
    return Sample(sender=1, index=index, stamp=0.01 * index, position=np.full((1, 1), float(index)))


@given(st.lists(st.integers(0, 20), max_size=40))
def test_freshest_holds_the_newest_whatever_the_order(arrivals: list[int]) -> None:
    link = FreshestLink(INITIAL)
    newest = -1
    for index in arrivals:
        assert link.offer(sample(index)) == (index > newest)
        newest = max(newest, index)
        assert link.ready(0)
        assert link.choose(99).index == newest


@given(st.permutations(range(12)), st.integers(1, 5))
def test_constant_link_is_ready_exactly_when_its_sample_is_there(order: list[int], delay: int) -> None:
    link = ConstantLink(INITIAL, delay)
    arrived: set[int] = set()
    k = 0
    for index in order:
        assert link.offer(sample(index))
        arrived.add(index)
        while k < delay or k - delay in arrived:
            assert link.ready(k)
            assert link.choose(k).index == max(k - delay, -1)
            k += 1
            if k - delay >= 12:
                return
        assert not link.ready(k)


def test_constant_link_ignores_duplicates_and_what_is_past() -> None:
    link = ConstantLink(INITIAL, 1)
    assert link.offer(sample(0))
    assert not link.offer(sample(0))
    assert link.offer(sample(1))
    assert link.choose(2).index == 1
    assert not link.offer(sample(0))
    assert list(link.waiting) == [1]


def test_an_empty_buffer_holds_the_newest_before() -> None:
    link = ConstantLink(INITIAL, 2)
    assert link.choose(5) is INITIAL
    link.offer(sample(1))
    assert link.choose(5).index == 1
    link.offer(sample(4))  # newer than k - N_ij = 3: not yet due
    assert link.choose(5).index == 1
    assert link.choose(6).index == 4
