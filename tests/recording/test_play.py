"""A recording in real time, on a clock that is made up."""

from pathlib import Path

import numpy as np
import pytest
from tests.recording.driven import Driven

from cotouch.errors import RecordingError
from cotouch.recording import Recording, read_recording, replay


class Clock:
    def __init__(self) -> None:
        self.now = 100.0

    def time(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        assert seconds > 0.0
        self.now += seconds


@pytest.fixture
def recording(tmp_path: Path) -> Recording:
    return read_recording(Driven(tmp_path, clocks=(50.0, 0.0), seconds=0.4).run()[0])


@pytest.mark.parametrize("speed", [1.0, 4.0, 0.5])
def test_every_step_comes_when_it_is_due(recording: Recording, speed: float) -> None:
    clock = Clock()
    for k, step in enumerate(replay(recording, speed=speed, clock=clock.time, sleep=clock.sleep)):
        assert step.row == k
        assert step.time == pytest.approx(0.004 * (k + 1))
        assert clock.now - 100.0 == pytest.approx(0.004 * k / speed)
        assert np.array_equal(step.force, recording.columns["force"][k])
        assert step.place[0, 0] == recording.states["position"][k, 0, 0]
    assert step.row == 99


def test_a_part_of_it(recording: Recording) -> None:
    clock = Clock()
    steps = list(replay(recording, start=0.1, stop=0.2, clock=clock.time, sleep=clock.sleep))
    assert steps[0].time == pytest.approx(0.1)
    assert steps[-1].time == pytest.approx(0.2)
    assert clock.now - 100.0 == pytest.approx(0.1)


def test_who_is_late_catches_up(recording: Recording) -> None:
    clock = Clock()
    for step in replay(recording, clock=clock.time, sleep=clock.sleep):
        if step.row == 10:
            clock.now += 0.1
    assert clock.now - 100.0 == pytest.approx(0.004 * 99)


def test_what_makes_no_sense_is_refused(recording: Recording) -> None:
    with pytest.raises(RecordingError, match="speed is 0"):
        next(replay(recording, speed=0.0))
    with pytest.raises(RecordingError, match=r"has nothing after 5 s; it is 0.4 s long"):
        next(replay(recording, start=5.0))
