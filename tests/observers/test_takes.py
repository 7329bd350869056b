"""A member's side of an ordered recording, without a disk: when it begins, when it ends, what it tells."""

import threading
from typing import Any

import numpy as np
import pytest

from cotouch.observers._takes import Takes


class FakeSessionRecorder:
    """Counts; fails when it is told to."""

    def __init__(self) -> None:
        self.steps = self.recorded = 0
        self.failure: str | None = None
        self.trouble: str | None = None
        self.closed = False

    def setup(self, copy: object, now: float) -> None:
        pass

    def close(self) -> None:
        self.closed, self.recorded, self.trouble = True, self.steps, self.failure


class FakeCopy:
    """One that moves."""

    peer = object()


class Booth:
    """Orders, and what comes of them."""

    def __init__(self) -> None:
        self.fields: dict[str, np.ndarray[Any, Any]] = {
            "recording": np.zeros((), "i8"), "recorded": np.zeros((), "i8"),
            "recorded_steps": np.zeros((), "i8"), "recorded_trouble": np.zeros((), "S200"),
        }  # fmt: skip
        self.shown = 0
        self.recordings: list[FakeSessionRecorder] = []
        self.takes = Takes(self.fields, self.show, self.make)  # type: ignore[arg-type]

    def show(self) -> None:
        self.shown += 1

    def make(self, number: int) -> FakeSessionRecorder:
        self.recordings.append(FakeSessionRecorder())
        return self.recordings[-1]

    def follow(self, number: int, now: float, *, on: bool) -> None:
        """Twice, as whoever calls it now and then: what the first ended is over by the second."""
        for _ in range(2):
            self.takes.follow(number, FakeCopy(), now, on=on)  # type: ignore[arg-type]
            for thread in threading.enumerate():
                if thread.name == "cotouch end of recording":
                    thread.join()

    def commanded(self) -> tuple[int, int, str]:
        trouble = self.fields["recorded_trouble"].item().decode()
        return self.fields["recorded"].item(), self.fields["recorded_steps"].item(), trouble


@pytest.fixture
def booth() -> Booth:
    made = Booth()
    made.follow(0, 0.0, on=False)
    return made


def test_it_lasts_until_there_is_a_step(booth: Booth) -> None:
    booth.follow(1, 1.0, on=False)  # ordered and ended since the last look
    booth.follow(1, 1.5, on=False)
    assert booth.takes.session_recorder is not None
    assert booth.fields["recorded"] == 0
    booth.recordings[0].steps = 1
    booth.follow(1, 1.6, on=False)
    assert booth.commanded() == (1, 1, "")
    assert booth.recordings[0].closed
    booth.follow(1, 1.7, on=False)
    assert len(booth.recordings) == 1


def test_but_not_for_ever(booth: Booth) -> None:
    booth.follow(1, 1.0, on=True)
    booth.follow(1, 9.0, on=True)
    booth.follow(1, 10.0, on=False)
    booth.follow(1, 11.9, on=False)
    assert booth.fields["recorded"] == 0
    booth.follow(1, 12.1, on=False)
    assert booth.commanded() == (1, 0, "has no steps: the copy took none in that time")


def test_a_failure_ends_it_and_is_shown_without_a_step(booth: Booth) -> None:
    booth.follow(1, 1.0, on=True)
    booth.recordings[0].steps, booth.recordings[0].failure = 5, "ends after 5 of 9 steps: x"
    before = booth.shown
    booth.follow(1, 1.1, on=True)
    assert booth.commanded() == (1, 5, "ends after 5 of 9 steps: x")
    assert booth.shown > before
    booth.follow(1, 1.2, on=True)  # and it is not begun anew
    assert len(booth.recordings) == 1
    booth.follow(2, 2.0, on=True)
    assert len(booth.recordings) == 2


def test_a_newer_order_ends_the_one_before(booth: Booth) -> None:
    booth.follow(1, 1.0, on=True)
    booth.recordings[0].steps = 3
    booth.follow(2, 1.1, on=True)
    assert booth.commanded()[:2] == (1, 3)
    booth.follow(2, 1.2, on=True)
    assert booth.fields["recording"] == 2


def test_words_that_are_too_long_are_cut(booth: Booth) -> None:
    booth.follow(1, 1.0, on=True)
    booth.recordings[0].steps, booth.recordings[0].failure = 1, "é" * 300
    booth.follow(1, 1.1, on=True)
    assert len(booth.fields["recorded_trouble"].item()) <= 200
