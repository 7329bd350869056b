"""Files are looked at before they are opened: nothing waits for ever, and nothing without end is read."""

import os
from pathlib import Path

import pytest

from cotouch.body import body_from_surface, body_from_tetrahedra
from cotouch.errors import NetworkError, RecordingError, ScenarioError, SessionError
from cotouch.files import MOST_TEXT, read_bytes, read_text, toml
from cotouch.members import SessionFile
from cotouch.network import Network
from cotouch.recording import read_recording
from cotouch.scenario import Scenario

READERS = (
    (Scenario.read, "scenario"),
    (Network.read, "network"),
    (SessionFile.read, "session"),
    (read_recording, "recording"),
    (lambda path: body_from_surface(path, unit="m"), "mesh"),
    (lambda path: body_from_tetrahedra(path, unit="m"), "mesh"),
)
SUFFIXES = ("toml", "toml", "toml", "mcap", "stl", "vtk")


@pytest.mark.parametrize(("reader", "suffix"), list(zip(READERS, SUFFIXES, strict=True)))
def test_what_is_no_ordinary_file_is_a_sentence(tmp_path: Path, reader, suffix: str) -> None:
    read, what = reader
    path = tmp_path / f"a.{suffix}"
    for make, kind in (
        (lambda: os.mkfifo(path), "a pipe"),
        (lambda: path.symlink_to("/dev/zero"), "a device"),
        (path.mkdir, "a folder"),
    ):
        make()
        with pytest.raises(ValueError, match=f"the {what} .*a.{suffix} cannot be read: it is {kind}; name an ordinary"):
            read(path)
        path.rmdir() if path.is_dir() and not path.is_symlink() else path.unlink()


def test_a_session_looks_at_its_mesh(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.stl")
    (tmp_path / "s.toml").write_text('body = {kind = "file", file = "a.stl", unit = "m"}\nsession = {users = 2}\n')
    with pytest.raises(SessionError, match=r"the file .*a.stl cannot be read: it is a pipe"):
        SessionFile.read(tmp_path / "s.toml")


def test_too_large_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    with path.open("wb") as file:
        file.truncate(1 << 40)
    with pytest.raises(ScenarioError, match="it has more than 16 MB"):
        Scenario.read(path)
    with pytest.raises(NetworkError, match="it has more than 16 MB"):
        Network.read(path)
    with pytest.raises(RecordingError, match="it has more than 16384 MB"):
        read_recording(path)
    os.truncate(path, MOST_TEXT)
    assert len(read_text(path, "file", ScenarioError)) == MOST_TEXT


def test_a_file_that_grows_without_end_while_it_is_read(tmp_path: Path) -> None:
    """What the kernel says of its size is no promise: /proc says 0."""
    with pytest.raises(ScenarioError, match="it has more than 0 MB"):
        read_bytes(Path("/proc/self/maps"), "file", ScenarioError, 100)


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("a = " + "[" * 100_000, "too deep"),
        ("a = " + "9" * 10_000, "Exceeds the limit"),
        ("a = 2000-13-01", "newline"),
        ("a = ", "Invalid value"),
    ],
)
def test_hostile_toml(text: str, word: str) -> None:
    with pytest.raises(ScenarioError, match=f"it is not TOML.*{word}"):
        toml(text, "it", ScenarioError)
