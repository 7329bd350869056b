"""A recording that was cut off or damaged: what is read is what was written, up to a whole batch."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.recording.driven import Driven

from cotouch.errors import RecordingError
from cotouch.recording import RecordedBody, Recording, read_recording


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return Driven(tmp_path_factory.mktemp("whole"), seconds=2.0, options={"interval": 0.1}).run()[0]


def assert_prefix(part: Recording, full: Recording) -> None:
    assert part.steps <= full.steps
    for name, values in part.columns.items():
        assert np.array_equal(values, full.columns[name][: part.steps])
    for name, values in part.states.items():
        assert np.array_equal(values, full.states[name][: values.shape[0]])


def test_cut_off_anywhere(whole: Path, tmp_path: Path) -> None:
    data, full = whole.read_bytes(), read_recording(whole)
    rng = np.random.default_rng(0)
    path, seen = tmp_path / "part.mcap", []
    for length in sorted(rng.integers(0, len(data), 200).tolist()):
        path.write_bytes(data[:length])
        try:
            part = read_recording(path)
        except RecordingError:
            seen.append(0)
            continue
        assert_prefix(part, full)
        assert part.broken is not None
        assert part.steps > 0
        seen.append(part.steps)
    assert seen == sorted(seen)
    assert len(set(seen)) > 10  # batch by batch
    assert seen[-1] == full.steps  # the index at the end is not needed
    assert full.broken is None


def test_every_batch_before_the_cut_is_there(whole: Path, tmp_path: Path) -> None:
    """Each batch is found as soon as the last byte of its chunk is."""
    from mcap.reader import make_reader

    with whole.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    assert summary is not None
    data, path = whole.read_bytes(), tmp_path / "part.mcap"
    steps = []
    for chunk in summary.chunk_indexes:
        end = chunk.chunk_start_offset + chunk.chunk_length
        path.write_bytes(data[:end])
        try:
            steps.append(read_recording(path).steps)
        except RecordingError:
            steps.append(0)
        path.write_bytes(data[: end - 1])
        try:
            assert read_recording(path).steps <= (steps[-2] if len(steps) > 1 else 0)
        except RecordingError:
            assert len(steps) < 3
    assert max(steps) == read_recording(whole).steps
    assert len(set(steps)) > 10


def test_damage_is_found_by_the_checksums(whole: Path, tmp_path: Path) -> None:
    data, full = whole.read_bytes(), read_recording(whole)
    rng = np.random.default_rng(1)
    path, read = tmp_path / "bad.mcap", 0
    for _ in range(200):
        bad = bytearray(data)
        at = int(rng.integers(len(bad)))
        bad[at] ^= 1 << int(rng.integers(8))
        path.write_bytes(bytes(bad))
        try:
            part = read_recording(path)
        except RecordingError:
            continue
        assert_prefix(part, full)
        read += 1
    assert read > 50


@pytest.mark.parametrize(("place", "value"), [(8, 1), (10, 99)])
def test_a_body_packed_in_an_unknown_way_is_no_recording(place: int, value: int, whole: Path) -> None:
    """A flipped bit there says that a part is encrypted, or compressed by a method that nobody knows."""
    data = bytearray(read_recording(whole).header.body.to_bytes())
    data[data.index(b"PK\x01\x02") + place] = value
    local = 6 if place == 8 else 8
    data[data.index(b"PK\x03\x04") + local] = value
    with pytest.raises(RecordingError, match="body cannot be read"):
        RecordedBody.from_bytes(bytes(data))


def test_a_process_that_is_killed_leaves_what_it_has_written(tmp_path: Path) -> None:
    path = tmp_path / "killed.mcap"
    program = f"""
import sys, time
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from pathlib import Path
from tests.recording.test_recorder import header, report, state
from cotouch.recording import Recorder
recorder = Recorder(Path({str(path)!r}), header(), batch=50, buffers=1000)
recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
for k in range(1_000_000):
    recorder.step(report(k, value=float(k)), end=10 + 0.001 * k, T=0.001, state=state())
    while recorder._written < k - 500:
        time.sleep(0.001)
    if k == 5000:
        print("on", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        try:
            assert process.stdout.readline() == "on\n"
        finally:
            os.kill(process.pid, signal.SIGKILL)
        process.wait(30.0)
    read = read_recording(path)
    assert read.broken is not None
    assert not read.closed
    assert read.steps > 4400
    assert read.steps % 50 == 0
    assert np.array_equal(read.columns["force"][:, 0, 0], 2.0 * np.arange(read.steps))


@pytest.mark.parametrize("content", [b"", b"no", b"\x89MCAP0\r\n", os.urandom(0) + b"\x89MCAP0\r\n" + bytes(1000)])
def test_what_is_no_recording_is_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "x.mcap"
    path.write_bytes(content)
    with pytest.raises(RecordingError, match="not a cotouch recording"):
        read_recording(path)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="cannot be read: No such file"):
        read_recording(tmp_path / "no.mcap")
