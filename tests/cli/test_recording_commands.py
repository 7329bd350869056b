"""replay, audit and export as a user runs them."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from tests.cli.commands import cotouch, here
from tests.recording.driven import Driven
from tests.recording.test_audit import with_tools

from cotouch.recording import read_recording


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    return Driven(tmp_path_factory.mktemp("session")).run()


def test_an_audit_that_holds(files: list[Path], tmp_path: Path) -> None:
    done = cotouch("audit", *files, "--figures", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    assert "Holds: every step's energy is explained" in " ".join(done.stdout.split())
    assert "Ann - Ben" in done.stdout
    assert (tmp_path / "out" / "audit.png").read_bytes().startswith(b"\x89PNG")


def test_an_audit_that_does_not_hold_ends_with_1(tmp_path: Path) -> None:
    done = here("audit", *Driven(tmp_path, damping=(0.0, 0.0), seconds=2.0).run(), "--json")
    assert done.returncode == 1, done.stderr
    found = json.loads(done.stdout)
    assert found["holds"] is False
    assert {finding["place"] for finding in found["findings"]} == {"link", "network"}
    assert found["findings"][0]["link"] == [1, 2]


def test_bad_input_ends_with_2_and_one_sentence(tmp_path: Path) -> None:
    path = tmp_path / "x.mcap"
    path.write_bytes(b"no")
    for arguments in (("audit", path), ("export", path, "--out", tmp_path / "x.nc")):
        done = here(*arguments)
        assert done.returncode == 2
        assert done.stderr == f"cotouch: {path}: it is not a cotouch recording, or ends within its header\n"
    assert not (tmp_path / "x.nc").exists()


def test_export(files: list[Path], tmp_path: Path) -> None:
    out = tmp_path / "x.nc"
    done = here("export", *files, "--out", out, "--json")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["sizes"]["step"] == 251
    with xr.open_dataset(out, engine="h5netcdf") as run:
        assert run["user"].values.tolist() == ["Ann", "Ben"]


def test_replay_without_a_terminal_prints_lines(files: list[Path]) -> None:
    done = here("replay", files[0], "--speed", "1000", "--from", "0.5")
    assert done.returncode == 0, done.stderr
    (line,) = done.stdout.splitlines()
    assert line.split()[:7] == ["0.500", "s", "250", "Hz", "period", "4", "ms"]
    assert "2: 62 ms coupled" in line or "ms coupled" in line


def test_replay_sums_up(files: list[Path]) -> None:
    done = here("replay", files[0], "--json")
    summary = json.loads(done.stdout)
    assert (summary["user"], summary["name"], summary["steps"], summary["whole"]) == (1, "Ann", 250, True)
    assert summary["period_s"]["mean"] == pytest.approx(0.004)
    assert summary["events"] == {"setup": 1, "closed": 1}


def test_replay_tells_what_hands_feel_of_tools(tmp_path: Path) -> None:
    path = with_tools(tmp_path)[0]
    pulled = np.linalg.norm(read_recording(path).columns["drive_force"].sum(axis=1), axis=-1)
    assert json.loads(here("replay", path, "--json").stdout)["peak_force_n"] == pytest.approx(pulled.max())
    (line, *_) = here("replay", path, "--speed", "1000", "--from", "0.2").stdout.splitlines()
    assert "force 0 N" not in line


def test_replay_in_a_terminal_shows_the_table(files: list[Path]) -> None:
    """Through a terminal of its own."""
    import os
    import pty

    main, other = pty.openpty()
    code = "from cotouch.cli import main; main()"
    command = [sys.executable, "-c", code, "replay", str(files[0]), "--speed", "10"]
    with subprocess.Popen(
        command, stdout=other, stderr=subprocess.PIPE, env={**os.environ, "TERM": "xterm"}
    ) as process:
        os.close(other)
        shown = b""
        while True:
            try:
                part = os.read(main, 4096)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            shown += part
        assert process.wait(60.0) == 0
    os.close(main)
    assert b"neighbour" in shown
    assert b"1.00 s of 1.00 s" in shown
