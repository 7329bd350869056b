"""The watch on the machine: late is late, unless the machine stood still for as long."""

from pathlib import Path

import pytest
from tests.stalls import Stalled, Stalls, stolen


@pytest.fixture
def watch(tmp_path: Path) -> Stalls:
    """One that has seen 30 ms lost from 10.02 to 10.06 s."""
    (tmp_path / "stalls").write_text("5.0 6.0 0.9\n10.02 10.06 0.03\n")
    return Stalls(tmp_path, watching=False)


def test_in_time_is_in_time(watch: Stalls):
    watch.within(10.0, 0.099)


@pytest.mark.parametrize("gone", [0.101, 0.129, 0.131])
def test_what_the_machine_lost_is_no_failure_but_no_success(watch: Stalls, gone: float):
    with pytest.raises(Stalled, match="stood still for 30 ms"):
        watch.within(10.0, gone)


@pytest.mark.parametrize(("began", "gone"), [(10.0, 0.132), (10.0, float("inf")), (10.07, 0.101), (10.04, 0.12)])
def test_what_is_later_than_that_is_a_failure(watch: Stalls, began: float, gone: float):
    with pytest.raises(AssertionError, match="only after") as caught:
        watch.within(began, gone)
    assert not isinstance(caught.value, Stalled)


def test_a_processor_that_was_kept_from_the_machine_is_seen():
    told = "cpu  9 0 0 9 0 0 0 700 0 0\ncpu0 5 0 0 5 0 0 0 300 0 0\ncpu1 4 0 0 4 0 0 0 400 0 0\nintr 1 2\nctxt 5\n"
    assert stolen(told) == [3.0, 4.0]


def test_how_long_at_a_stretch(watch: Stalls):
    assert watch.stood(10.0, 0.03)
    assert not watch.stood(10.0, 0.031)
    assert not watch.stood(10.07, 0.001)
