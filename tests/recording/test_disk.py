"""Whatever the disk does, and wherever: what was written before can be read, and what became of it is said."""

import errno
import os
import shutil
import subprocess
import sys
import threading
from io import FileIO
from pathlib import Path

import pytest
from mcap.writer import MCAP0_MAGIC
from tests.recording.inside import RawFile, make
from tests.recording.test_recorder import header, report, state

from cotouch.errors import RecordingError
from cotouch.recording import NewFile, Recorded, Recorder, audit, read_recording, recordings_dataset

STEPS, BATCH = 30, 5


class FailingFile:
    """A file that takes so many bytes and then no more; at most a few at a time, as a disk may."""

    def __init__(self, path: Path, room: int, number: int, *, piece: int = 1 << 30, comes_back: bool = False) -> None:
        self.raw: RawFile = make(path)
        self.room, self.number, self.piece, self.comes_back = room, number, piece, comes_back
        self.failed = 0

    def write(self, data: memoryview, /) -> int | None:
        if not self.room and not (self.comes_back and self.failed):
            self.failed += 1
            raise OSError(self.number, os.strerror(self.number))
        taken = self.raw.write(data[: max(1, min(self.room, self.piece))])
        self.room -= min(self.room, taken or 0)
        return taken

    def truncate(self, size: int, /) -> int:
        return self.raw.truncate(size)

    def fileno(self) -> int:
        return self.raw.fileno()

    def close(self) -> None:
        self.raw.close()


class Waits:
    """Keeps the thread that writes until everything is there, so that every file has the same chunks."""

    def __init__(self) -> None:
        self.go = threading.Event()

    def __str__(self) -> str:
        assert self.go.wait(60.0)
        return "all is there"


def recorded(file: NewFile) -> Recorded:
    recorder, waits = Recorder(file, header(), batch=BATCH, buffers=64), Waits()
    recorder.event("ready", 10.0, when=waits)
    recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0], ports=[0])
    for k in range(STEPS):
        recorder.step(report(k, value=float(k)), end=10.0 + 0.01 * (k + 1), T=0.01, state=state())
    waits.go.set()
    return recorder.close()


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = tmp_path_factory.mktemp("whole") / "a.mcap"
    assert recorded(NewFile(path)) == Recorded(steps=STEPS, dropped_steps=0, dropped_events=0, failure=None)
    assert read_recording(path).broken is None
    return path.read_bytes()


def ends(tmp_path: Path, room: int, number: int = errno.ENOSPC, **options: object) -> tuple[Path, Recorded | None]:
    """A recording on a disk with so much room; None: it was refused."""
    path = tmp_path / f"{room}.mcap"
    try:
        return path, recorded(NewFile(path, lambda at: FailingFile(at, room, number, **options)))  # type: ignore[arg-type]
    except RecordingError as error:
        said = str(error)
    assert said == f"the recording {path} cannot be written: {os.strerror(number)}"
    assert not path.exists()  # nothing could be read of it
    return path, None


def places(tmp_path: Path) -> list[int]:
    """Where a disk is full before, just behind, in the middle of and at the end of every write."""
    met: set[int] = set()

    class Noting(FailingFile):
        at = 0

        def write(self, data: memoryview, /) -> int | None:
            met.update((self.at, self.at + 1, self.at + len(data) // 2, self.at + len(data) - 1))
            self.at += len(data)
            return super().write(data)

    recorded(NewFile(tmp_path / "noted.mcap", lambda at: Noting(at, 1 << 30, 0)))
    return sorted(met)


def left_over(data: bytes) -> int:
    """Bytes behind the last whole record: each has a kind and a length in front."""
    at = len(MCAP0_MAGIC)
    while at + 9 <= len(data):
        end = at + 9 + int.from_bytes(data[at + 1 : at + 9], "little")
        if end > len(data):
            break
        at = end
    return len(data) - at


def test_wherever_the_disk_is_full_the_rest_is_whole_and_said(tmp_path: Path) -> None:
    seen: set[int] = set()
    kinds: set[str] = set()
    rooms = places(tmp_path)
    assert len(rooms) > 80
    for room in rooms:
        path, done = ends(tmp_path, room)
        if done is None:
            kinds.add("refused")
            continue
        assert done.failure == "No space left on device"
        assert done.steps + done.dropped_steps == STEPS
        assert done.trouble is not None
        assert path.stat().st_size <= room
        assert left_over(path.read_bytes()) == 0
        if done.steps == 0:
            kinds.add("none")
            with pytest.raises(RecordingError, match="ends before its first batch"):
                read_recording(path)
        else:
            kinds.add("cut" if done.dropped_steps else "without index")
            read = read_recording(path)
            assert read.steps == done.steps
            assert read.columns["index"].tolist() == list(range(done.steps))
            assert read.cut == (
                f"cut off after step {done.steps - 1}, {0.01 * done.steps:.2f} s from its start: "
                "it ends before its index"
            )
        seen.add(done.steps)
        path.unlink()
    assert kinds == {"refused", "none", "cut", "without index"}
    assert seen == set(range(0, STEPS + 1, BATCH))


@pytest.mark.parametrize("number", [errno.EIO, errno.EROFS, errno.EACCES, errno.EPIPE, errno.EDQUOT, errno.EFBIG])
def test_every_error_of_a_disk_is_told_in_its_own_words(tmp_path: Path, whole: bytes, number: int) -> None:
    path, done = ends(tmp_path, len(whole) // 2, number, piece=7)
    assert done is not None
    assert done.trouble == f"ends after {done.steps} of {STEPS} steps: {os.strerror(number)}"
    assert 0 < done.steps == read_recording(path).steps < STEPS
    assert ends(tmp_path, 3, number)[1] is None


def test_nothing_is_written_behind_a_gap_if_there_is_room_again(tmp_path: Path, whole: bytes) -> None:
    """Else a reader would take for whole what lacks something in its middle."""
    met = 0
    for room in range(len(whole) // 4, len(whole), len(whole) // 40):
        path, done = ends(tmp_path, room, comes_back=True)
        assert done is not None
        assert done.failure is not None
        if not done.steps:
            continue
        met += 1
        read = read_recording(path)
        assert read.broken is not None
        assert read.columns["index"].tolist() == list(range(done.steps))
    assert met > 5


class FailsAtTheEnd(FailingFile):
    """A disk that says only when the file is closed that it does not have everything."""

    def close(self) -> None:
        super().close()
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_what_is_said_only_at_the_close_is_said(tmp_path: Path) -> None:
    path = tmp_path / "a.mcap"
    done = recorded(NewFile(path, lambda at: FailsAtTheEnd(at, 1 << 30, 0)))
    assert done.trouble == f"has its {STEPS} steps, but was not finished: No space left on device"


def test_a_folder_that_vanishes_is_said_before_the_end(tmp_path: Path) -> None:
    folder = tmp_path / "gone"
    folder.mkdir()
    recorder = Recorder(folder / "a.mcap", header(), batch=1, buffers=64)
    recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
    shutil.rmtree(folder)
    for k in range(2000):  # the thread writes meanwhile
        recorder.step(report(k), end=10.0 + 0.01 * (k + 1), T=0.01, state=state())
        if recorder.failure is not None:
            break
        threading.Event().wait(0.001)
    assert recorder.failure == "the file was removed while it was written"
    assert "the file was removed" in (recorder.close().trouble or "")


def test_what_no_disk_says_ends_a_recording_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A writer that breaks down for any reason must not fall silent."""

    class Breaks(FailingFile):
        def write(self, data: memoryview, /) -> int | None:
            if self.room < (1 << 30) - 5000:
                raise MemoryError
            return super().write(data)

    done = recorded(NewFile(tmp_path / "a.mcap", lambda at: Breaks(at, 1 << 30, 0)))
    assert done.failure is not None
    assert done.failure.startswith("MemoryError")


def test_only_the_user_may_read_it(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        recorded(NewFile(tmp_path / "a.mcap"))
    finally:
        os.umask(before)
    assert (tmp_path / "a.mcap").stat().st_mode & 0o777 == 0o600


def test_a_pipe_a_link_and_a_folder_are_refused(tmp_path: Path) -> None:
    """A pipe would hang until somebody reads it; a link would be followed to a file of somebody's."""
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to(tmp_path / "elsewhere")
    for name in ("pipe", "link", "."):
        with pytest.raises(RecordingError, match=r"exists; recordings are never overwritten|cannot be written"):
            NewFile(tmp_path / name)
    assert not (tmp_path / "elsewhere").exists()


def test_what_is_cut_off_is_replayed_audited_and_exported(tmp_path: Path, whole: bytes) -> None:
    path, done = ends(tmp_path, int(0.6 * len(whole)))
    assert done is not None
    read = read_recording(path)
    where = f"cut off after step {done.steps - 1}, {0.01 * done.steps:.2f} s from its start"
    assert read.cut == f"{where}: it ends before its index"
    assert recordings_dataset([read]).sizes
    assert any(where in note for note in audit([read]).notes)


PROGRAM = """
import sys
from pathlib import Path
from tests.recording.test_recorder import header, report, state
from cotouch.recording import Recorder, read_recording
path = Path(sys.argv[1]) / "a.mcap"
recorder = Recorder(path, header(), batch=64, buffers=64)
recorder.setup(10.0, copies=2, neighbours=[1], strength=[5.0])
for k in range(6000):
    recorder.step(report(k, value=k ** 0.5), end=10 + 0.001 * k, T=0.001, state=state())
done = recorder.close()
read = read_recording(path)
print(done.trouble)
print(0 < done.steps == read.steps < 6000, read.columns["index"].tolist() == list(range(read.steps)))
print(read.cut)
"""


def test_a_real_disk_that_is_full(tmp_path: Path) -> None:
    """A disk of 64 KiB in memory, in a namespace of its own."""
    if os.geteuid() != 0 or shutil.which("unshare") is None:
        pytest.skip("mounting needs root and unshare")
    script = f'mount -t tmpfs -o size=64k none {tmp_path} && exec "$0" -c "$1" {tmp_path}'
    done = subprocess.run(
        ["unshare", "--mount", "sh", "-c", script, sys.executable, PROGRAM],
        capture_output=True, text=True, timeout=120, check=False, cwd=Path(__file__).parents[2],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(Path.cwd()), os.environ.get("PYTHONPATH", "")])},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    said, whole, cut = done.stdout.splitlines()
    assert said.startswith("ends after ")
    assert said.endswith("steps: No space left on device")
    assert whole == "True True"
    assert cut.startswith("cut off after step ")


def test_the_raw_file_is_what_is_asked_for(tmp_path: Path) -> None:
    with FileIO(tmp_path / "b", "x"):
        pass
    with pytest.raises(FileExistsError):
        make(tmp_path / "b")
