"""One test that waits in real time goes on at a time, in whatever process; a killed one holds nobody up."""

import multiprocessing
import select
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from tests.conftest import IMPORTS
from tests.turns import turn

OTHER = """
import sys
from tests.turns import turn
sys.stdout.reconfigure(line_buffering=False, write_through=True)
print("wanted")
with turn(1):
    print("mine")
    sys.stdin.read()
"""


@pytest.fixture
def other(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """A process that has its turn until its input ends."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    monkeypatch.setenv("PYTHONPATH", IMPORTS)
    started = []

    def start() -> subprocess.Popen[bytes]:
        started.append(
            subprocess.Popen([sys.executable, "-c", OTHER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        )
        return started[-1]

    yield start
    for process in started:
        process.kill()
        process.communicate()


def test_one_after_the_other(other):
    with turn(1):
        waiting = other()
        assert waiting.stdout.readline() == b"wanted\n"
        assert not select.select([waiting.stdout], [], [], 0.3)[0]
    assert waiting.stdout.readline() == b"mine\n"


def test_whoever_is_killed_gives_its_turn_away(other):
    one = other()
    assert [one.stdout.readline() for _ in range(2)] == [b"wanted\n", b"mine\n"]
    one.kill()
    with turn(1):
        pass


def test_a_fork_that_lives_on_holds_nobody_up(other):
    with turn(1):
        left = multiprocessing.get_context("fork").Process(target=signal.pause)
        left.start()
    try:
        one = other()
        assert one.stdout.readline() == b"wanted\n"
        assert select.select([one.stdout], [], [], 20.0)[0]
        assert one.stdout.readline() == b"mine\n"
    finally:
        left.kill()
        left.join()


def test_two_have_turns_where_there_are_two(other):
    one = other()
    assert [one.stdout.readline() for _ in range(2)] == [b"wanted\n", b"mine\n"]
    with turn(2):
        pass
