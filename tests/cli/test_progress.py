"""What is said while nothing else can be shown: within two seconds, and without cutting what stays to be read."""

import subprocess
import sys
import time

import pytest
from tests.cli.inside import ProgressLine

# What takes seconds to load ends the command here, so that all that was said before it is what one sees meanwhile.
LIGHT = """
import os, sys, threading, time
class Heavy:
    def find_spec(self, name, path=None, target=None):
        if name == "numpy":
            time.sleep(1.5)
            for thread in threading.enumerate():
                if thread.name == "cotouch progress":
                    thread._target.__self__.end()
            sys.stderr.flush()
            os._exit(7)
sys.meta_path.insert(0, Heavy())
sys.argv = ["cotouch", "demo", *sys.argv[1:]]
from cotouch.__main__ import run
run()
"""


class Terminal:
    """A standard error that says that it is one."""

    def __init__(self) -> None:
        self.text = ""

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> None:
        self.text += text

    def flush(self) -> None:
        pass


@pytest.mark.parametrize(
    ("options", "said"),
    [((), "cotouch: starting (1 s)\n"), (("--no-page",), "cotouch: starting (1 s)\n"), (("--json", "--page"), "")],
    ids=["page", "no page", "json"],
)
def test_a_demo_says_something_before_it_loads_what_takes_seconds(options: tuple[str, ...], said: str) -> None:
    done = subprocess.run(
        [sys.executable, "-c", LIGHT, *options, "--port", "0"],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (7, "", said)


def test_what_stays_to_be_read_stands_above_the_line_that_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with ProgressLine(quiet=False) as progress:
        progress.say("starting")
        while not terminal.text:
            time.sleep(0.01)
        progress.tell("the page is here")
    assert "\r\x1b[Kcotouch: the page is here\n" in terminal.text
    assert "\rcotouch: starting (0 s)\x1b[K" in terminal.text
    assert terminal.text.endswith("\r\x1b[K")


def test_who_wants_quiet_is_told_only_what_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with ProgressLine(quiet=True) as progress:
        progress.say("starting")
        progress.tell("the page is here")
    assert terminal.text == "cotouch: the page is here\n"


def test_what_is_over_at_once_has_said_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    with ProgressLine(quiet=False) as progress:
        progress.say("starting")
    assert capsys.readouterr() == ("", "")
