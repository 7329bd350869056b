"""Numbers that are none, too large for any, or of tools that are not there, are no recording that holds."""

from dataclasses import replace

import numpy as np
import pytest
from tests.recording.driven import Driven
from tests.recording.inside import SCALARS, Batch, recording_of

from cotouch.errors import RecordingError
from cotouch.recording import Audit, Recording, audit, read_recording

_NO_ENERGY = {"index", "time", "period", "iterations"}


@pytest.fixture(scope="module")
def honest(tmp_path_factory: pytest.TempPathFactory) -> list[Recording]:
    return [read_recording(path) for path in Driven(tmp_path_factory.mktemp("honest"), seconds=0.4).run()]


def with_column(recordings: list[Recording], name: str, value: float, where: slice) -> Audit:
    first, *others = recordings
    known = first.columns if name in first.columns else first.states
    column = known[name].astype(np.float64)
    column[where] = value
    changed = {**known, name: column}
    with np.errstate(all="ignore"):
        if name in first.columns:
            return audit([replace(first, columns=changed), *others])
        return audit([replace(first, states=changed), *others])


def test_the_recordings_hold_as_they_are(honest: list[Recording]) -> None:
    assert audit(honest).holds


@pytest.mark.parametrize(
    "name", [*sorted(SCALARS.keys() - _NO_ENERGY), "force", "position", "velocity", "middle", "link_work"]
)
@pytest.mark.parametrize("value", [np.nan, 1e300])
def test_a_step_with_a_number_that_is_none_does_not_hold(honest: list[Recording], name: str, value: float) -> None:
    result = with_column(honest, name, value, slice(30, 31))
    if name == "link_work" and np.isnan(value):  # there is no such link in this step; its work is known all the same
        assert result.users[0].link_work == pytest.approx(audit(honest).users[0].link_work, rel=1e-9)
    else:
        assert not result.holds


@pytest.mark.parametrize("name", ["proxy", "touch_stored", "touch_work", "touch_loss", "drive_work"])
@pytest.mark.parametrize(("value", "where"), [(-1.0, slice(None)), (1e90, slice(None)), (1e-3, slice(30, 31))])
def test_without_tools_their_ledger_is_empty(honest: list[Recording], name: str, value: float, where: slice) -> None:
    """What proxies were said to hold was believed, and as much as that could be off was allowed everywhere."""
    assert not with_column(honest, name, value, where).holds


@pytest.mark.parametrize(("name", "value"), [("period", np.inf), ("period", np.nan), ("time", np.nan), ("age", np.inf)])
def test_times_that_are_none_are_no_recording(honest: list[Recording], name: str, value: float) -> None:
    first = honest[0]
    columns = {**first.columns, name: np.array(first.columns[name])}
    batch = [Batch(first.neighbours, {**columns, **first.states})]
    assert recording_of("a.mcap", first.header, batch, first.events, None).steps == first.steps
    columns[name][30] = value
    with pytest.raises(RecordingError, match=r"a length that is not positive|an age that no clocks explain"):
        recording_of("a.mcap", first.header, batch, first.events, None)
