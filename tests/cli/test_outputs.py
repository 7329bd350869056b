"""What cannot be written is one sentence and exit code 2, and what was there before still is."""

import multiprocessing
import os
import subprocess
import sys
from pathlib import Path

import pytest
import xarray as xr
from tests.cli.commands import FIVE_USERS, Done, cotouch, here
from tests.files.places import PYTHON, each_on_a_small_disk, left, needs_mounts, on_a_small_disk

PAIR = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.05], [0.05, 0]]

[steps]
duration = 2.0
period = 0.001

[[hands]]
user = 1
path = 0.1
"""
ROD = "\n".join(
    [
        "OFF",
        "8 12 0",
        *(f"{x} {y} {z}" for x in (0, 40) for y in (0, 10) for z in (0, 10)),
        *("3 0 1 3", "3 0 3 2", "3 4 6 7", "3 4 7 5", "3 0 4 5", "3 0 5 1"),
        *("3 2 3 7", "3 2 7 6", "3 0 2 6", "3 0 6 4", "3 1 5 7", "3 1 7 3"),
    ]
)


OUTPUTS = (("--out", "x.nc"), ("--animation", "x.html"), ("--figures", ""))


@pytest.fixture
def pair(tmp_path: Path) -> Path:
    path = tmp_path / "pair.toml"
    path.write_text(PAIR)
    return path


def one_sentence(done: Done, *words: str) -> None:
    said = [line for line in done.stderr.splitlines() if line.startswith("cotouch: ")]
    assert len(said) == 1, done.stderr
    assert all(word in said[0] for word in words), said[0]
    assert "Traceback" not in done.stderr
    assert "Exception" not in done.stderr
    assert done.returncode == 2


@needs_mounts
@pytest.mark.parametrize(
    ("name", "option"), [("x.nc", "--out"), ("x.html", "--animation"), ("energies.png", "--figures")]
)
def test_a_full_disk(tmp_path: Path, pair: Path, name: str, option: str) -> None:
    """A disk of 64 kB; HDF5 that met it took the process down."""
    disk = tmp_path / "disk"
    path = disk if option == "--figures" else disk / name
    done = on_a_small_disk(disk, "size=64k", "simulate", pair, option, path, old=name)
    one_sentence(done, f"cannot be written to {disk}", "No space left on device")
    assert f"{name} b'what was there before'" in left(done)
    assert all(not entry.startswith(".") for entry in left(done))


@needs_mounts
def test_a_full_disk_and_smaller_outputs(tmp_path: Path, pair: Path) -> None:
    disk, mesh, session = tmp_path / "disk", tmp_path / "rod.off", tmp_path / "two.toml"
    mesh.write_text(ROD)
    session.write_text("[session]\nusers = 2\n")
    for name, command in (
        ("body.png", ("body", mesh, "--unit", "mm", "--figures", disk)),
        ("networks.png", ("plan", FIVE_USERS, "--links", "6", "--figures", disk)),
        ("keys", ("host", session, "--duration", "1", "--key-file", disk / "keys", "--headless")),
    ):
        size = "size=4k" if name != "keys" else "size=1M,nr_inodes=1"
        done = on_a_small_disk(disk, size, *map(str, command), old="" if name == "keys" else name)
        one_sentence(done, "cannot be written to", str(disk / name), "No space left on device")
        assert left(done) == ([] if name == "keys" else [f"{name} b'what was there before'"])


@needs_mounts
def test_a_disk_that_cannot_be_written_is_found_out_before_the_work(tmp_path: Path, pair: Path) -> None:
    disk = tmp_path / "disk"
    commands = [("simulate", pair, option, disk / name) for option, name in OUTPUTS] + [("reproduce", "--out", disk)]
    ran = each_on_a_small_disk(disk, "size=1M,ro", *commands, old="x.nc")
    for done in ran:
        one_sentence(done, "Read-only file system")
        assert left(done) == ["x.nc b'what was there before'"]
    assert len(ran) == len(commands)


def test_a_limit_on_files(tmp_path: Path, pair: Path) -> None:
    """The same where nothing can be mounted."""
    (tmp_path / "x.nc").write_text("old")
    limited = "import resource, sys; resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)); "
    done = subprocess.run(
        [sys.executable, "-c", limited + PYTHON[2], "simulate", pair, "--out", tmp_path / "x.nc"],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    one_sentence(done, "cannot be written to", "File too large")
    assert (tmp_path / "x.nc").read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["pair.toml", "x.nc"]


def ended(*command: str | Path) -> None:
    """Ends this process as the command would."""
    os._exit(here(*command).returncode)


def test_two_with_the_same_file_both_succeed(tmp_path: Path, pair: Path) -> None:
    # What they need is loaded already.
    fork = multiprocessing.get_context("fork")
    command = ("simulate", pair, "--out", tmp_path / "x.nc", "--json")
    both = [fork.Process(target=ended, args=command) for _ in range(2)]
    for process in both:
        process.start()
    for process in both:
        process.join(300)
    assert [process.exitcode for process in both] == [0, 0]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["pair.toml", "x.nc"]
    with xr.open_dataset(tmp_path / "x.nc", engine="h5netcdf") as run:
        assert run.sizes["user"] == 2


def test_what_is_read_is_not_written_over(tmp_path: Path, pair: Path) -> None:
    mesh = tmp_path / "rod.off"
    mesh.write_text(ROD)
    soft = tmp_path / "soft.toml"
    soft.write_text(PAIR.split("[[hands]]", maxsplit=1)[0] + '[body]\nkind = "file"\nfile = "rod.off"\nunit = "mm"\n')
    (tmp_path / "x.nc").symlink_to(pair)
    (tmp_path / "x.html").symlink_to(mesh)
    (tmp_path / "figures").mkdir()
    (tmp_path / "figures" / "ages.png").symlink_to(pair)
    (tmp_path / "figures" / "body.png").symlink_to(mesh)
    for command in (
        ("simulate", pair, "--out", pair),
        ("simulate", pair, "--out", tmp_path / "x.nc"),
        ("simulate", pair, "--animation", pair),
        ("simulate", soft, "--animation", tmp_path / "x.html"),
        ("simulate", pair, "--figures", tmp_path / "figures"),
        ("body", mesh, "--unit", "mm", "--figures", tmp_path / "figures"),
    ):
        one_sentence(here(*command), "is read by this command", "would be overwritten; name another file")
    assert (pair.read_text(), mesh.read_text()) == (PAIR, ROD)


@pytest.mark.parametrize("name", ["x.mat", "x.csv", "x", "x.toml"])
def test_only_what_is_written_is_promised(tmp_path: Path, pair: Path, name: str) -> None:
    one_sentence(here("simulate", pair, "--out", tmp_path / name), "must end in .nc, .nc4, .h5 or .hdf5")
    one_sentence(here("simulate", pair, "--animation", tmp_path / name), "must end in .html or .htm")
    one_sentence(here("export", pair, "--out", tmp_path / name), "must end in .nc, .nc4, .h5 or .hdf5")
    assert [path.name for path in tmp_path.iterdir()] == ["pair.toml"]


def test_links_and_devices_stay_what_they_are(tmp_path: Path, pair: Path) -> None:
    (tmp_path / "far").mkdir()
    (tmp_path / "x.nc").symlink_to("far/x.nc")
    assert here("simulate", pair, "--out", tmp_path / "x.nc").returncode == 0
    assert (tmp_path / "x.nc").is_symlink()
    assert (tmp_path / "far" / "x.nc").read_bytes()[:4] == b"\x89HDF"
    done = subprocess.run([*PYTHON, "simulate", pair, "--out", "/dev/stdout"], capture_output=True, check=False)
    assert done.stdout.startswith((tmp_path / "far" / "x.nc").read_bytes())
    assert here("simulate", pair, "--out", "/dev/null").returncode == 0
    one_sentence(here("simulate", pair, "--out", "/dev/full"), "cannot be written to /dev/full", "No space left")


@pytest.mark.parametrize("command", [("--json",), ()])
class TestStandardOutput:
    def ran(self, command: tuple[str, ...], redirected: str) -> Done:
        line = " ".join(["certify", str(FIVE_USERS), *command, redirected])
        unbuffered = "" if command else "1"  # what is not held back is lost when it is refused
        return subprocess.run(
            ["bash", "-c", f'set -o pipefail; "{sys.executable}" -m cotouch {line}'],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONUNBUFFERED": unbuffered},
            timeout=300,
            check=False,
        )

    def test_full(self, command: tuple[str, ...]) -> None:
        one_sentence(self.ran(command, "> /dev/full"), "standard output cannot be written: No space left on device")

    def test_closed(self, command: tuple[str, ...]) -> None:
        one_sentence(self.ran(command, ">&-"), "standard output cannot be written: Bad file descriptor")
        done = self.ran(command, ">&- 2>&- <&-")
        assert (done.returncode, done.stdout, done.stderr) == (2, "", "")

    def test_nobody_reads_on(self, command: tuple[str, ...]) -> None:
        done = self.ran(command, "| true")
        assert (done.returncode, done.stdout, done.stderr) == (1, "", "")


def test_a_full_standard_output_without_our_end_of_the_process(tmp_path: Path) -> None:
    """Also where Python is taken down as usual."""
    script = "from cotouch.cli import main; main()"
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-c", script, "--version"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    one_sentence(done, "standard output cannot be written")


@pytest.mark.parametrize(
    "command", [("simulate",), ("certify",), ("plan", "--links", "6"), ("host",), ("replay",), ("audit",)]
)
def test_a_pipe_in_place_of_a_file_is_a_sentence(tmp_path: Path, command: tuple[str, ...]) -> None:
    os.mkfifo(tmp_path / "a.toml")
    one_sentence(cotouch(command[0], tmp_path / "a.toml", *command[1:]), "it is a pipe; name an ordinary file")
