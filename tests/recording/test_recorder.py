"""What goes in comes out, whatever the links, the body and the disk do."""

import json
import resource
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from tests.recording.driven import Driven
from tests.recording.inside import make

from cotouch.body import lattice, point
from cotouch.errors import RecordingError
from cotouch.mechanics import State, model
from cotouch.peer import LinkState, Sample, StepReport
from cotouch.recording import NewFile, RecordedBody, Recorder, RecordHeader, both_clocks, read_recording


def header(**fields: Any) -> RecordHeader:
    made: dict[str, Any] = {"user": 0, "monotonic": 10.0, "unix": 1e9, "body": RecordedBody.of(model(point(mass=1.0)))}
    return RecordHeader(**{**made, **fields})


def report(k: int, links: int = 1, value: float = 0.0) -> StepReport:
    return StepReport(
        sample=Sample(sender=0, index=k, stamp=0.0, position=np.full((1, 1), value)),
        force=np.full((1, 1), 2.0 * value),
        supplied=value + 0.5,
        body_loss=1.0,
        local_loss=2.0,
        extra_loss=3.0,
        link_work=np.arange(links) + value,
        kinetic=4.0,
        elastic=5.0,
        drive_work=6.0,
        touch_work=7.0,
        touch_loss=8.0,
        proxy=9.0,
        touch_stored=10.0,
        speed=0.0,
        residual=11.0,
        age=np.full(links, 0.01),
        iterations=12,
        closure=0.0,
        closure_factor=0.0,
        closing=None,
        jammed=None,
        shortened=0.0,
        world_loss=0.0,
        world_stored=0.0,
        world_force=(0.0, 0.0, 0.0),
        cut=0.0,
        cut_elements=(),
        rescaled=0.0,
        advanced=0.0,
        guards=(),
    )


def state(value: float = 0.0) -> State:
    return State(np.full((1, 1), value), np.full((1, 1), -value), np.zeros((1, 1)), np.zeros((1, 1)), np.zeros(0))


@pytest.mark.parametrize("body", ["point", "lattice", "full", "truncated"])
def test_a_session_comes_back_as_it_was(tmp_path: Path, body: str) -> None:
    shared = {
        "point": point(mass=1.0, stiffness=4.0, damping=0.5),
        "lattice": lattice((3, 2, 2), ground="all", ground_stiffness=5.0),
        "full": lattice((2, 2, 2)).as_full(),
        "truncated": lattice((3, 2, 2)).truncated(modes=8, contacts=[0]),
    }[body]
    driven = Driven(tmp_path, body=shared, seconds=0.6, clocks=(1234.5, 77.0), with_used=True)
    for user, path in enumerate(driven.run()):
        read = read_recording(path)
        reports = driven.reports[user]
        assert read.broken is None
        assert read.closed
        assert read.missing == 0
        assert read.steps == len(reports)
        assert read.neighbours == (1 - user,)
        for name in ("supplied", "body_loss", "local_loss", "kinetic", "elastic", "residual", "iterations"):
            assert read.columns[name].tolist() == [getattr(entry, name) for entry in reports]
        axes = read.header.body.axes
        for name in ("link_work", "age"):
            assert np.array_equal(read.columns[name], [getattr(entry, name) for entry in reports])
        assert np.array_equal(read.columns["force"], np.array([entry.force for entry in reports])[..., :axes])
        assert np.array_equal(read.states["position"], np.array([x for x, _ in driven.states[user]])[..., :axes])
        assert np.array_equal(read.states["velocity"], np.array([v for _, v in driven.states[user]])[..., :axes])
        samples = np.array([entry.sample.position for entry in reports])[..., :axes]
        assert np.array_equal(read.states["middle"], samples)
        stamps = np.array([entry.sample.stamp for entry in reports])
        assert np.allclose(read.columns["time"] - 0.5 * read.columns["period"], stamps, rtol=0, atol=1e-9)
        back = np.array([driven.model.to_nodes(x) for x, _ in driven.states[user]])
        assert np.allclose(read.header.body.nodes(read.states["position"]), back, rtol=0, atol=1e-15)


def test_the_head_says_who_and_what(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    said = header(user=3, name="Eve", key="ab12", session="s", configuration={"a": [1, {"b": None}]}, body_hash="ff")
    with Recorder(path, said) as recorder:
        recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
        recorder.step(report(0), end=10.1, T=0.1, state=state())
    read = read_recording(path).header
    assert (read.user, read.name, read.key, read.session, read.body_hash) == (3, "Eve", "ab12", "s", "ff")
    assert read.configuration == {"a": [1, {"b": None}]}
    assert (read.monotonic, read.unix) == (10.0, 1e9)
    assert read.version.startswith("cotouch ")


def test_columns_of_ones_own_and_links_that_change(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    columns = {"tank": ("J", "energy in the tank of each link")}
    with Recorder(path, header(columns=columns), batch=4) as recorder:
        recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
        for k in range(6):
            recorder.step(report(k), end=10 + k, T=1.0, state=state(), extra={"tank": [k / 2], "rate": k})
        recorder.setup(16.0, copies=3, neighbours=[2, 1], strength=[6.0, 5.0])
        recorder.event("joined", 16.0, who="Cyd")
        for k in range(6, 9):
            link_state = [LinkState.GUARDED, LinkState.COUPLED]
            recorder.step(
                report(k, 2),
                end=10 + k,
                T=1.0,
                state=state(),
                used=[k, -1],
                link_state=link_state,
                extra={"tank": [1, k]},
            )
    read = read_recording(path)
    assert read.neighbours == (1, 2)
    assert read.steps == 9
    assert np.array_equal(read.columns["link_work"][:6, 0], np.zeros(6))
    assert np.all(np.isnan(read.columns["link_work"][:6, 1]))
    assert read.columns["link_work"][6:].tolist() == [[1.0, 0.0]] * 3  # by user, not by the order of links
    assert read.columns["link_state"][6:].tolist() == [[2, 0]] * 3
    assert read.columns["used"][6:].tolist() == [[-1, k] for k in range(6, 9)]
    assert read.columns["rate"][:6].tolist() == list(range(6))
    assert np.all(np.isnan(read.columns["rate"][6:]))
    assert read.columns["tank"].shape == (9, 2)
    assert [event.kind for event in read.events] == ["setup", "setup", "joined", "closed"]
    assert [(setup.first, setup.copies) for setup in read.setups] == [(0, 2), (6, 3)]
    assert [(setup.neighbours, rows.start, rows.stop) for setup, rows in read.setup_rows()] == [
        ((1,), 0, 6),
        ((2, 1), 6, 9),
    ]
    assert read.header.columns == columns


def test_states_of_a_large_body_are_kept_less_often(tmp_path: Path) -> None:
    body = lattice((6, 6, 6))
    driven = Driven(tmp_path, body=body, periods=(0.004, 0.004), seconds=0.1, hands={})
    read = read_recording(driven.run()[0])
    assert body.nodes * 3 > 256
    assert read.columns["index"][read.states["state_row"]].tolist() == list(range(0, 25, 3))
    assert read.steps == 25
    x = [driven.states[0][k][0][:, :3] for k in range(0, 25, 3)]
    assert np.array_equal(read.states["position"], x)


class SlowFile:
    """On a disk that takes bytes only while it may."""

    def __init__(self, path: Path) -> None:
        self.raw = make(path)
        self.go = threading.Event()
        self.go.set()

    def write(self, data: memoryview) -> int | None:
        assert self.go.wait(60.0)
        return self.raw.write(data)

    def truncate(self, size: int) -> int:
        return self.raw.truncate(size)

    def fileno(self) -> int:
        return self.raw.fileno()

    def close(self) -> None:
        self.raw.close()


def test_a_disk_that_cannot_follow_costs_whole_batches_and_says_so(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    slow = SlowFile(path)
    recorder = Recorder(NewFile(path, lambda _: slow), header(), batch=10, interval=1e9, buffers=3)
    slow.go.clear()
    recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
    for k in range(100):
        recorder.step(report(k, value=float(k)), end=10 + k, T=1.0, state=state())
    slow.go.set()
    done = recorder.close()
    read = read_recording(path)
    assert done.failure is None
    assert done.steps + done.dropped_steps == 100
    assert done.steps == read.steps < 100
    assert read.missing == done.dropped_steps
    gaps = [event for event in read.events if event.kind == "gap"]
    assert sum(event.fields["steps"] for event in gaps) == done.dropped_steps
    index = read.columns["index"]
    for event in gaps:
        assert event.fields["last"] - event.first + 1 == event.fields["steps"]
        assert not np.any((index >= event.first) & (index <= event.fields["last"]))
    assert np.array_equal(read.columns["force"][:, 0, 0], 2.0 * index)  # what is there is not mixed up


def test_a_loop_on_a_virtual_clock_may_wait_for_the_disk_and_lacks_nothing(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    slow = SlowFile(path)
    recorder = Recorder(NewFile(path, lambda _: slow), header(), batch=10, interval=1e9, buffers=3, waits=True)
    slow.go.clear()
    recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
    threading.Timer(0.2, slow.go.set).start()
    for k in range(100):
        recorder.step(report(k, value=float(k)), end=10 + k, T=1.0, state=state())
    done = recorder.close()
    read = read_recording(path)
    assert (done.steps, done.dropped_steps, read.steps, read.missing) == (100, 0, 100, 0)
    assert not [event for event in read.events if event.kind == "gap"]


def test_a_full_disk_ends_the_recording_and_not_the_loop(tmp_path: Path) -> None:
    """The limit on the size of files stands for the disk."""
    program = f"""
import resource, signal, sys
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from pathlib import Path
from tests.recording.test_recorder import header, report, state
from cotouch.recording import Recorder, read_recording
resource.setrlimit(resource.RLIMIT_FSIZE, (20000, resource.RLIM_INFINITY))
path = Path({str(tmp_path / "full.mcap")!r})
recorder = Recorder(path, header(), batch=64, buffers=64)
recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
for k in range(4000):
    recorder.step(report(k, value=k ** 0.5), end=10 + k, T=1.0, state=state())
done = recorder.close()
read = read_recording(path)
print(done.failure is not None and "large" in done.failure, 0 < done.steps <= read.steps + 64, done.dropped_steps > 0)
print(read.broken is not None, read.columns["index"].tolist() == list(range(read.steps)))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, check=False)
    assert done.stdout.split() == ["True"] * 5, done.stderr
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] != 20000


def test_a_recording_is_never_written_over(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    path.write_text("precious")
    with pytest.raises(RecordingError, match="exists; recordings are never overwritten"):
        Recorder(path, header())
    assert path.read_text() == "precious"
    with pytest.raises(RecordingError, match="cannot be written"):
        Recorder(tmp_path / "no" / "a.mcap", header())


def test_closing_twice_and_recording_nothing(tmp_path: Path) -> None:
    before = set(threading.enumerate())
    recorder = Recorder(tmp_path / "a.mcap", header())
    (writing,) = set(threading.enumerate()) - before
    assert recorder.close() == recorder.close()
    assert not writing.is_alive()
    with pytest.raises(RecordingError, match="ends before its first batch"):
        read_recording(tmp_path / "a.mcap")


def test_other_readers_of_mcap_find_their_way(tmp_path: Path) -> None:
    path = Driven(tmp_path, seconds=0.6).run()[0]
    with path.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        summary = reader.get_summary()
        assert summary is not None
        topics = {channel.topic: channel for channel in summary.channels.values()}
        assert set(topics) == {"/steps", "/events", "/ledger"}
        schema = summary.schemas[topics["/events"].schema_id]
        assert schema.encoding == "jsonschema"
        assert json.loads(schema.data)["required"] == ["kind", "time", "first"]
        columns = json.loads(summary.schemas[topics["/steps"].schema_id].data)["columns"]
        assert columns["period"]["unit"] == "s"
        ledger = [json.loads(message.data) for _, channel, message in reader.iter_messages(topics=["/ledger"])]
        assert ledger[0]["first"] == 0
        assert [book["first"] for book in ledger[1:]] == [book["last"] + 1 for book in ledger[:-1]]
        read = read_recording(path)
        assert sum(book["links"][0]["work"] for book in ledger) == pytest.approx(float(read.columns["link_work"].sum()))
        assert {entry.name for entry in reader.iter_attachments()} == {"configuration.json", "body.npz"}
        times = [message.log_time for _, _, message in reader.iter_messages(topics=["/steps"])]
        assert times[-1] == round((read.columns["time"][-1] + read.header.offset) * 1e9)


def test_both_clocks_are_read_at_one_instant() -> None:
    import time

    before = time.time() - time.monotonic()
    monotonic, unix = both_clocks()
    assert unix - monotonic == pytest.approx(before, abs=0.5)
