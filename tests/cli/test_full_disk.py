"""`demo --record` onto a disk that is full, and what is said of it at once and at the end."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from tests.cli.commands import here
from tests.cli.shown import shown
from tests.cli.test_session_commands import invitation
from tests.session.world import World

from cotouch.members import ParticipationOutcome
from cotouch.recording import read_recording

TWO = """
[session]
users = 2
[body]
mass = 0.4
[steps]
rate = 250
"""


@pytest.mark.skipif(os.geteuid() != 0 or not shutil.which("unshare"), reason="mounting needs root and unshare")
def test_a_demonstration_on_a_full_disk(tmp_path: Path) -> None:
    """On 96 KiB in memory, in a namespace of its own; what is there is copied out of it."""
    disk, kept = tmp_path / "disk", tmp_path / "kept"
    disk.mkdir()
    script = (
        f'mount -t tmpfs -o size=96k none {disk} && "$0" -m cotouch demo --users 2 --body point --duration 4 --json '
        f"--record {disk}/rec > {tmp_path}/out 2> {tmp_path}/err; code=$?; cp -rp {disk}/rec {kept}; exit $code"
    )
    done = subprocess.run(["unshare", "--mount", "sh", "-c", script, sys.executable], timeout=300, check=False)
    assert done.returncode == 1, (tmp_path / "err").read_text()
    shown = json.loads((tmp_path / "out").read_text())
    files = sorted(kept.glob("*.mcap"))
    assert [path.stat().st_mode & 0o777 for path in files] == [0o600] * len(files)
    assert files
    for name, member in shown["members"].items():
        trouble = member["recording_trouble"]
        assert f"the recording of {name} {trouble}" in shown["complaints"]
        assert trouble.endswith(": No space left on device")
        assert member["status"]["recording"] == "failed"
        assert member["status"]["recording_failure"] == "No space left on device"
        if member["recorded_steps"]:
            read = read_recording(kept / f"{name}.mcap")
            assert read.steps == member["recorded_steps"] < member["status"]["steps"]
            assert read.cut is not None
            replayed = here("replay", str(kept / f"{name}.mcap"), "--speed", "1000")
            assert f"cut off after step {read.steps - 1:,}" in replayed.stderr


def test_the_table_shows_whose_recording_stopped(tmp_path: Path) -> None:
    world = World(TWO, tick=1e-3, folder=tmp_path)
    for name in world.session.scenario.network.users:
        world.join(name)
    world.until(world.all_coupled, 12.0)
    one = world.people[0]
    world.run(1.0)
    assert "NOT RECORDED" not in shown(world)
    world.recordings[0].unlink()
    world.until(lambda: one.member.status(world.now).recording == "failed", 60.0)
    world.run(1.5)
    said = f"NOT RECORDED: {one.name}'s recording stopped: the file was removed while it was written"
    assert said in shown(world)
    world.run(30.0)  # not only for a moment
    assert said in shown(world)


def test_what_a_member_says_at_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    trouble, path = "ends after 3 of 9 steps: x", tmp_path / "a.mcap"
    taken = ParticipationOutcome(name="Ann", slot=0, status=None, why="time", pace={}, recorded=3, trouble=trouble)
    monkeypatch.setattr("cotouch.session.join", lambda *_, **__: taken)
    options = ("join", invitation(), "--headless", "--record", path)
    said, numbers = here(*options), here(*options, "--json")
    assert json.loads(numbers.stdout)["recording_trouble"] == trouble
    assert said.stdout == "Ann did not get to take part\n"
    for done in (said, numbers):
        assert (done.returncode, done.stderr) == (1, f"cotouch: the recording {path} {trouble}\n")


@pytest.mark.parametrize("made", ["folder", "file", "pipe", "nowhere"])
def test_a_recording_that_cannot_be_is_refused_before_anything_else(tmp_path: Path, made: str) -> None:
    """No host is asked, and nothing compiled: the invitation leads to nobody."""
    path = tmp_path / "a.mcap"
    if made == "folder":
        path.mkdir()
    elif made == "file":
        path.write_text("precious")
    elif made == "pipe":
        os.mkfifo(path)
    else:
        path = tmp_path / "no" / "a.mcap"
    done = here("join", invitation(), "--headless", "--record", str(path))
    assert done.returncode == 2
    assert done.stderr.startswith("cotouch: ")
    assert done.stderr.count("\n") == 1
    assert str(path) in done.stderr
    assert "no member of the session answered" not in done.stderr
