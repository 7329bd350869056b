"""A recording's hand, played again."""

from pathlib import Path

import numpy as np
import pytest
from tests.drivers.inside import RecordedHand
from tests.drivers.moved import Moved

from cotouch.errors import DeviceError


def test_it_goes_where_the_hand_went(moved: Moved):
    now = 3.0
    device = RecordedHand(moved.path, tool=2, clock=lambda: now)
    device.open()
    for row in (0, 17, len(moved.time) - 2):
        now = 3.0 + moved.time[row]
        reading = device.exchange(np.ones(3))
        np.testing.assert_allclose(reading.position + device.middle, moved.place[row], atol=1e-9)
        slope = (moved.place[row + 1] - moved.place[row]) / (moved.time[row + 1] - moved.time[row])
        np.testing.assert_allclose(reading.velocity, slope, atol=1e-6)
    assert device.spec.actuated == 0
    assert np.isnan(reading.force).all()


@pytest.mark.parametrize("repeat", [False, True])
def test_it_rests_at_the_end_or_goes_back(moved: Moved, repeat: bool):
    now = 0.0
    device = RecordedHand(moved.path, tool=2, repeat=repeat, clock=lambda: now)
    device.open()
    now = device.length + 0.1
    reading = device.exchange(np.zeros(3))
    row = np.searchsorted(moved.time, device.length - 0.1) if repeat else -1
    np.testing.assert_allclose(reading.position + device.middle, moved.place[row], atol=1e-3)
    assert bool(reading.velocity.any()) == repeat


def test_the_origin_is_the_middle_of_where_it_went(moved: Moved):
    device = moved.device()
    device.open()
    np.testing.assert_allclose(device.middle, 0.5 * (moved.place.min(axis=0) + moved.place.max(axis=0)))
    reach = np.linalg.norm(moved.place - device.middle, axis=1).max()
    assert device.spec.workspace == pytest.approx(reach)


def test_recordings_that_have_no_such_hand(moved: Moved, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    with pytest.raises(DeviceError, match=r"tool is 3; .* has 2 tools"):
        RecordedHand(moved.path, tool=3).open()
    with pytest.raises(DeviceError, match="fewer than two positions of tool 1"):
        RecordedHand(moved.path, tool=1).open()
    monkeypatch.undo()
    with pytest.raises(DeviceError, match="has 0 tools whose places it keeps"):
        RecordedHand(moved.path).open()
    with pytest.raises(DeviceError, match="cannot be read"):
        RecordedHand(tmp_path / "none.mcap").open()
