"""host, join, measure and demo as users run them: processes that meet on 127.0.0.1."""

import json
import os
import re
import secrets
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Generator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from tests.cli.forked import Forked
from tests.keeper import marked

from cotouch.cli import main
from cotouch.control import Endpoint, Invitation, free_port
from cotouch.errors import CotouchError
from cotouch.peer import LinkState
from cotouch.recording import read_recording
from cotouch.samples import Identity

# What any wait is bounded by; alone on a machine what is waited for takes seconds [s].
PATIENCE = 300.0
COMMAND = [sys.executable, "-c", "from cotouch.cli import main; main()"]
TWO = """
title = "Two"
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.03], [0.01, 0]]
[steps]
rate = 100
[session]
emulate = true
[[hands]]
user = 1
path = [[0, 0], [1, 0.05]]
"""


class Running:
    """Processes of one test, all ended with it; output goes to files, so that nobody waits for a reader."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._all: list[subprocess.Popen[bytes] | Forked] = []

    def fork(self, name: str, *arguments: str | Path, said: str = "") -> Forked:
        """The same as `start`, without the seconds that loading takes."""
        files = [self._folder / f"{name}.{kind}" for kind in ("in", "out", "err")]
        for path, text in zip(files, (said, "", ""), strict=True):
            path.write_text(text)
        self._all.append(made := Forked([*map(str, arguments)], files))
        return made

    def start(self, name: str, *arguments: str | Path, said: str = "") -> subprocess.Popen[bytes]:
        out, err = (self._folder / f"{name}.{kind}" for kind in ("out", "err"))
        with out.open("wb") as a, err.open("wb") as b:
            process = subprocess.Popen([*COMMAND, *map(str, arguments)], stdin=subprocess.PIPE, stdout=a, stderr=b)
        self._all.append(process)
        assert process.stdin is not None
        process.stdin.write(said.encode())
        process.stdin.close()
        return process

    def out(self, name: str) -> str:
        return (self._folder / f"{name}.out").read_text()

    def err(self, name: str) -> str:
        return (self._folder / f"{name}.err").read_text()

    def until(self, done: Callable[[], object], what: str, seconds: float = PATIENCE) -> None:
        end = time.monotonic() + seconds
        while not done():
            assert time.monotonic() < end, f"{what}: not within {seconds} s; {self.complaints()}"
            time.sleep(0.05)

    def complaints(self) -> str:
        return "; ".join(f"{path.stem} says {path.read_text()!r}" for path in sorted(self._folder.glob("*.err")))

    def close(self) -> None:
        for process in self._all:
            if process.poll() is None:
                process.kill()
                process.wait()


@pytest.fixture
def running(tmp_path: Path) -> Generator[Running]:
    made = Running(tmp_path)
    yield made
    made.close()


def coupled(path: Path) -> bool:
    """Whether all of a member's links were coupled in some step that it recorded, so far."""
    try:
        phases = read_recording(path).columns["link_state"]
    except (CotouchError, OSError):  # not begun
        return False
    return phases.shape[1] > 0 and bool((phases == LinkState.COUPLED).all(axis=1).any())


def interrupted(process: "subprocess.Popen[bytes] | Forked") -> int:
    os.kill(process.pid, signal.SIGINT)
    return process.wait(PATIENCE)


def test_a_session_from_invitation_to_audit(running: Running, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    host_of = ("host", tmp_path / "two.toml", "--key-file", tmp_path / "keys", "--law", "paid")
    host = running.fork("host", *host_of)
    running.until(lambda: running.out("host").endswith("\n"), "the invitation")
    line = running.out("host").strip()
    assert Invitation.decode(line).session == "Two"
    assert "cotouch join -" in running.err("host")
    running.until(
        lambda: "cotouch: ready, link law paid; nobody has joined yet\n" in running.err("host"), "the host is ready"
    )
    assert (tmp_path / "keys").stat().st_mode & 0o077 == 0

    ann_of = ("join", "-", "--name", "Ann", "--headless", "--record", tmp_path / "a.mcap")
    ann = running.fork("Ann", *ann_of, said=f"{line}\n")
    ben = running.fork("Ben", "join", line, "--name", "Ben", "--record", tmp_path / "b.mcap", "--json")
    recorded = [tmp_path / "a.mcap", tmp_path / "b.mcap"]
    running.until(lambda: all(map(coupled, recorded)), "both are coupled")
    measure_of = ("measure", "-", "--duration", "2", "--out", tmp_path / "n.toml", "--json")
    measuring = running.fork("measure", *measure_of, said=line)
    taken = running.fork("taken", "join", line, "--name", "Ann", "--json")

    assert measuring.wait(PATIENCE) == 0, running.err("measure")
    found = json.loads(running.out("measure"))
    assert found["users"] == ["Ann", "Ben"]
    assert found["not_measured"] == []
    assert found["emulated"]
    delay = found["delay_s"][0][1]
    assert delay == found["delay_s"][1][0]
    assert 0.02 <= delay < 0.5  # half of 0.03 and 0.01 s, which are emulated, and what this machine adds
    written = tomllib.loads((tmp_path / "n.toml").read_text())["network"]
    assert written["links"] == [[1, 2]]
    assert written["spring"] == [[0, 50], [50, 0]]
    assert abs(written["delay"][0][1] - delay) < 1e-6

    assert taken.wait(PATIENCE) == 2
    assert running.err("taken") == (
        'cotouch: the host does not admit Ann: the name "Ann" is taken by somebody else in this session; choose '
        "another with --name, or ask the host to release it\n"
    )
    assert running.out("taken") == ""
    assert interrupted(ben) == 0
    result = json.loads(running.out("Ben"))
    assert (result["name"], result["user"], result["ended"]) == ("Ben", 2, "stopped")
    assert result["recorded_steps"] == result["status"]["steps"] > 100
    assert len(result["status"]["links"]) == 1
    assert running.err("Ben") == ""
    assert interrupted(ann) == 0
    assert running.out("Ann").startswith("Ann took ")
    told = [line.removeprefix("cotouch: ") for line in running.err("Ann").splitlines()]
    assert told[0] == "joining ..."
    assert "ready: Ann is user 1 of 2, link law paid" in told
    assert "were recorded" in running.out("Ann")
    assert [path.stat().st_mode & 0o777 for path in recorded] == [0o600, 0o600]
    assert interrupted(host) == 0

    again = running.fork("again", *host_of, "--json")
    running.until(lambda: running.out("again").endswith("}\n"), "the invitation again")
    assert json.loads(running.out("again"))["invitation"] == line
    assert interrupted(again) == 0
    audited = running.fork("audit", "audit", tmp_path / "a.mcap", tmp_path / "b.mcap", "--json")
    code = audited.wait(PATIENCE)
    report = json.loads(running.out("audit"))
    assert report["holds"], report["findings"]
    assert code == 0, running.err("audit")
    assert report["law"]["name"] == "paid"
    assert report["law"]["on_the_way_j"] > 0.0


def test_nobody_is_invited_to_a_body_that_is_wrong(running: Running, tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(b"no mesh")
    (tmp_path / "two.toml").write_text(TWO.replace("[session]", '[body]\nfile = "a.stl"\nunit = "m"\n[session]'))
    host = running.fork("host", "host", tmp_path / "two.toml")
    assert host.wait(PATIENCE) == 2
    assert running.out("host") == ""
    assert "a.stl cannot be read as STL" in running.err("host")


def test_who_was_killed_comes_back_as_itself_and_so_does_the_host(running: Running, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    host_of = ("host", tmp_path / "two.toml", "--key-file", tmp_path / "keys", "--json")
    host = running.fork("host", *host_of)
    running.until(lambda: running.out("host").endswith("}\n"), "the invitation")
    line = json.loads(running.out("host"))["invitation"]
    ann = running.fork("Ann", "join", "-", "--name", "Ann", "--json", "--record", tmp_path / "a.mcap", said=line)
    ben = running.fork("Ben", "join", "-", "--name", "Ben", "--record", tmp_path / "b.mcap", said=line)

    def kept() -> list[str]:
        decided = json.loads((tmp_path / "keys").read_text())["decided"]
        return [] if decided is None else sorted(entry["name"] for entry in decided["roster"]["members"])

    running.until(lambda: kept() == ["Ann", "Ben"], "the host keeps its roster")
    for process in (ben, host):
        process.kill()
        process.wait()
    again = running.fork("again", *host_of)
    running.until(lambda: running.out("again").endswith("}\n"), "the invitation again")
    back_of = ("join", "-", "--name", "Ben", "--json", "--record", tmp_path / "c.mcap")
    back = running.fork("back", *back_of, said=line)
    running.until(lambda: coupled(tmp_path / "c.mcap"), "Ben is back")
    assert interrupted(back) == 0, running.err("back")
    result = json.loads(running.out("back"))
    assert (result["user"], result["ended"]) == (2, "stopped")
    assert interrupted(ann) == 0
    assert json.loads(running.out("Ann"))["user"] == 1
    assert interrupted(again) == 0


def test_who_is_there_when_the_host_ends_the_session_ends_too(running: Running, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text(TWO)
    host = running.fork("host", "host", tmp_path / "two.toml", "--json")
    running.until(lambda: running.out("host").endswith("}\n"), "the invitation")
    line = json.loads(running.out("host"))["invitation"]
    ann = running.fork("Ann", "join", "-", "--device", "none", "--headless", said=line)
    ben = running.fork("Ben", "join", line, "--name", "Ben", "--duration", "1", "--headless", said=line)
    assert ben.wait(PATIENCE) == 0
    assert running.out("Ben").startswith("Ben took ")
    watched = running.fork("watch", "measure", "-", "--duration", "2", said=line)
    assert watched.wait(PATIENCE) == 2  # one alone has no way to anybody
    assert "at least two members" in running.err("watch")
    assert interrupted(host) == 0
    assert ann.wait(PATIENCE) == 0
    assert running.out("Ann").startswith("the host ended the session; ")
    late = running.fork("late", "join", "-", "--json", said=line)
    assert late.wait(PATIENCE) == 2
    assert "the session has ended, or its host is not running" in running.err("late")


@pytest.mark.parametrize(
    "options",
    [("--users", "3", "--impair", "loss=0.05", "--impair", "jitter=0.005"), ("--users", "2", "--body", "block")],
)
def test_demo(running: Running, options: tuple[str, ...]) -> None:
    done = running.start("demo", "demo", "--duration", "3", "--json", *options)
    done.wait(PATIENCE)
    shown: dict[str, Any] = json.loads(running.out("demo"))
    assert len(shown["members"]) == int(options[1])
    assert shown["residual"] < 1e-9
    assert done.returncode == bool(shown["complaints"])
    assert not [said for said in shown["complaints"] if "coupled" not in said]  # a busy machine guards its links
    explained = shown["supplied_j"] + shown["delays_added_j"] - shown["damped_j"] - shown["in_copies_j"]
    # The rest is from sharing the object among more, as they come.
    shared = sum(one["status"][name] for one in shown["members"].values() for name in ("initial", "rescaled"))
    assert abs(explained + shared) < 1e-9 * shown["damped_j"]


def invitation(host: str = "127.0.0.1") -> str:
    identity = Identity.make(os.urandom)
    at = Endpoint(host, free_port(host))
    return Invitation.make(
        session="Nobody", digest=bytes(32), host=identity.public, endpoints=(at,), entropy=os.urandom
    ).encode()


def said(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], *arguments: str | Path) -> str:
    """What the command says on standard error, which must be one sentence, and ends with 2.

    Where a busy machine takes seconds to load it, lines before say so.
    """
    monkeypatch.setattr(sys, "argv", ["cotouch", *map(str, arguments)])
    with pytest.raises(SystemExit) as caught:
        main()
    out, err = capsys.readouterr()
    assert caught.value.code == 2
    assert out == ""
    lines = [line for line in err.splitlines() if not re.fullmatch(r"cotouch: starting \(\d+ s\)", line)]
    assert len(lines) == 1
    assert lines[0].startswith("cotouch: ")
    return lines[0]


def test_a_demo_that_is_killed_leaves_neither_members_nor_boards(
    running: Running, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its members see it at once and leave in order, so that recordings are whole."""
    mark = secrets.token_hex(8)
    monkeypatch.setenv("COTOUCH_KILLED", mark)
    demo = running.start(
        "demo", "demo", "--no-page", "--users", "2", "--duration", "600", "--record", tmp_path / "kept"
    )
    files = [tmp_path / "kept" / f"{name}.mcap" for name in ("Ann", "Ben")]
    running.until(lambda: all(file.exists() and file.stat().st_size > 10_000 for file in files), "recordings")
    words = list[list[str]]()
    for pid in marked(mark):
        with suppress(OSError):  # one that only helped, and is gone
            words.append(Path(f"/proc/{pid}/cmdline").read_text().split("\0"))
    mailboxes = {Path(line[line.index("--mailboxes") + 1]) for line in words if "--mailboxes" in line}
    assert len(mailboxes) == 1
    demo.kill()
    running.until(lambda: not marked(mark), "members gone")
    assert not mailboxes.pop().exists()
    assert [read_recording(file).broken for file in files] == [None, None]


@pytest.mark.parametrize(
    ("arguments", "part"),
    [
        (("join", "hello"), "invitation"),
        (("join", "{cut}"), "invitation"),
        (("join", "{changed}"), "invitation"),
        (("measure", "cotouch:"), "invitation"),
        (("join", "{whole}", "--device", "glove"), '--device is "glove"; it must be one of scripted'),
        (("join", "{whole}", "--name", "A\x9b2J"), "it must be 1 to 32 letters in one line"),
        (("join", "{whole}", "--name", "A\u202ennA"), "it must be 1 to 32 letters in one line"),
        (("join", "{whole}", "--name", "\u200b"), "it must be 1 to 32 letters in one line"),
        (("join", "{whole}", "--name", 33 * "A"), "it must be 1 to 32 letters in one line"),
        (("join", "{whole}", "--record", "{missing}/a.mcap"), "does not exist"),
        (("measure", "{whole}", "--out", "{missing}/n.toml"), "does not exist"),
        (("host", "{missing}.toml"), "cannot be read"),
        (("host", "{file}", "--listen", "my.machine"), "my.machine"),
        (("host", "{file}", "--listen", "0.0.0.0"), "0.0.0.0 stands for all addresses of this machine"),
        (("host", "{file}", "--listen", "::"), "give the one at which others reach it"),
        (("host", "{file}", "--key-file", "{file}"), "does not hold the keys"),
        (
            ("host", "{file}", "--law", "once"),
            '--law is "once"; a live session needs "spring", or a law that is passive',
        ),
        (("host", "{file}", "--law", "nought"), 'law is "nought"; it must be one of'),
        (("demo", "--users", "0"), "--users is 0; it must be from 1 to 32"),
        (("demo", "--users", "33"), "--users is 33"),
        (("demo", "--duration", "inf"), "--duration is inf; it must be a finite number of seconds"),
        (("demo", "--body", "ball"), '--body is "ball"; it must be one of point, block'),
        (("demo", "--impair", "loss=2"), '--impair is "loss=2"'),
        (("demo", "--impair", "noise=0.1"), '--impair is "noise=0.1"'),
    ],
)
def test_what_is_wrong_is_one_sentence(
    arguments: tuple[str, ...],
    part: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    whole = invitation()
    other = "A" if whole[40] != "A" else "B"
    file = tmp_path / "two.toml"
    file.write_text(TWO)
    given = {
        "whole": whole, "cut": whole[:-9], "changed": whole[:40] + other + whole[41:],
        "file": str(file), "missing": str(tmp_path / "no"),
    }  # fmt: skip
    assert part in said(monkeypatch, capsys, *(argument.format(**given) for argument in arguments))


@pytest.mark.parametrize("command", ["join", "measure"])
def test_nobody_answers(command: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("cotouch.session._join._PATIENCE", 1.0)
    options = ["--json"] if command == "join" else []
    assert "no member of the session answered within 1 s" in said(monkeypatch, capsys, command, invitation(), *options)
