"""A file is written whole or not at all, wherever its name leads."""

import errno
import multiprocessing
import os
import resource
import stat
import threading
from collections.abc import Generator
from pathlib import Path

import pytest

from cotouch.errors import OutputError, ScenarioError
from cotouch.files import beside, check_writable, folder, write

OLD, NEW = b"what was there before", b"new" * 1000


@pytest.fixture
def old(tmp_path: Path) -> Path:
    path = tmp_path / "x.nc"
    path.write_bytes(OLD)
    return path


@pytest.fixture
def narrow() -> Generator[None]:
    """No file may have more than a hundred bytes."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)


def names(path: Path) -> list[str]:
    return sorted(entry.name for entry in path.iterdir())


def test_a_new_file_has_the_permissions_that_the_user_gives_all(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write(tmp_path / "x.nc", NEW, "result")
        write(tmp_path / "keys", NEW, "keys", private=True)
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "x.nc").stat().st_mode) == 0o640
    assert stat.S_IMODE((tmp_path / "keys").stat().st_mode) == 0o600
    assert names(tmp_path) == ["keys", "x.nc"]


def test_a_file_that_is_replaced_keeps_its_permissions_and_whoever_has_it_open_keeps_it(old: Path) -> None:
    old.chmod(0o604)
    with old.open("rb") as reader:
        write(old, memoryview(NEW), "result")
        assert reader.read() == OLD
    assert old.read_bytes() == NEW
    assert stat.S_IMODE(old.stat().st_mode) == 0o604


def test_what_fails_leaves_the_old_file_and_nothing_else(old: Path, narrow: None) -> None:
    with pytest.raises(OutputError, match=rf"the result cannot be written to {old}: File too large"):
        write(old, NEW, "result")
    assert old.read_bytes() == OLD
    assert names(old.parent) == ["x.nc"]


@pytest.mark.parametrize("there", [True, False])
def test_a_link_is_followed(tmp_path: Path, there: bool) -> None:
    target, link, again = tmp_path / "far" / "x.nc", tmp_path / "x.nc", tmp_path / "y.nc"
    target.parent.mkdir()
    if there:
        target.write_bytes(OLD)
    link.symlink_to("far/x.nc")
    again.symlink_to(link)
    write(again, NEW, "result")
    assert target.read_bytes() == NEW
    assert link.is_symlink()
    assert again.is_symlink()
    assert names(target.parent) == ["x.nc"]


def test_links_in_a_ring_are_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    for attempt in (lambda: write(tmp_path / "a", NEW, "result"), lambda: check_writable(tmp_path / "a")):
        with pytest.raises(OutputError, match="Too many levels of symbolic links"):
            attempt()


def test_devices_are_written_to(tmp_path: Path) -> None:
    (tmp_path / "null").symlink_to("/dev/null")
    for path in ("/dev/null", tmp_path / "null"):
        check_writable(Path(path), (".nc",))
        write(path, NEW, "result")
    assert (tmp_path / "null").is_symlink()
    assert stat.S_ISCHR(Path("/dev/null").stat().st_mode)
    with pytest.raises(OutputError, match="cannot be written to /dev/full: No space left on device"):
        write("/dev/full", NEW, "result")


def test_pipes_are_written_to_also_if_nobody_reads_on(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    check_writable(pipe, (".nc",))
    heard: list[bytes] = []
    reader = threading.Thread(target=lambda: heard.append(pipe.read_bytes()))
    reader.start()
    write(pipe, NEW, "result")
    reader.join()
    assert heard == [NEW]
    reader = threading.Thread(target=lambda: os.close(os.open(pipe, os.O_RDONLY)))
    reader.start()
    with pytest.raises(OutputError, match="Broken pipe"):
        write(pipe, NEW * 1000, "result")
    reader.join()
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_standard_output_by_name_is_the_one_that_is_open(tmp_path: Path) -> None:
    """Also where it leads to a file: what is printed comes behind it, not over it."""
    (tmp_path / "link").symlink_to("/dev/stdout")
    read, end = os.pipe()
    kept = os.dup(1)
    os.dup2(end, 1)
    try:
        for name in ("/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", tmp_path / "link"):
            write(name, b"a", "result")
    finally:
        os.dup2(kept, 1)
        os.close(end)
        os.close(kept)
    with os.fdopen(read, "rb") as stream:
        assert stream.read() == b"aaaa"


def _writes(path: Path, data: bytes, times: int) -> None:
    for _ in range(times):
        write(path, data, "result")


def test_two_who_write_at_once_both_succeed(tmp_path: Path) -> None:
    context = multiprocessing.get_context("spawn")
    contents = [letter * 100_000 for letter in (b"a", b"b")]
    both = [context.Process(target=_writes, args=(tmp_path / "x.nc", content, 50)) for content in contents]
    for process in both:
        process.start()
    while any(process.is_alive() for process in both):
        if (tmp_path / "x.nc").exists():
            assert (tmp_path / "x.nc").read_bytes() in contents
    for process in both:
        process.join()
    assert [process.exitcode for process in both] == [0, 0]
    assert names(tmp_path) == ["x.nc"]


class TestPrepare:
    def test_inputs_are_not_written_over_by_any_name(self, old: Path) -> None:
        (old.parent / "link.nc").symlink_to(old)
        os.link(old, old.parent / "hard.nc")
        for name in ("x.nc", "link.nc", "hard.nc", "./x.nc"):
            with pytest.raises(OutputError, match=r"is read by this command \(.*x.nc\) and would be overwritten"):
                check_writable(old.parent / name, inputs=(old.parent / "none", old))
        with pytest.raises(OutputError, match="would be overwritten"):
            beside(old.parent, ("a.nc", "x.nc"), (old,))
        check_writable(old, inputs=(old.parent / "none",))

    def test_suffixes(self, tmp_path: Path) -> None:
        for name in ("x.mat", "x", "x.nc.gz"):
            with pytest.raises(OutputError, match=r'x.* ends in ".*"; its name must end in .a, .b or .nc'):
                check_writable(tmp_path / name, (".a", ".b", ".nc"))
        check_writable(tmp_path / "x.NC", (".a", ".b", ".nc"))

    def test_folders(self, tmp_path: Path) -> None:
        with pytest.raises(OutputError, match="is a folder; name a file"):
            check_writable(tmp_path)
        with pytest.raises(OutputError, match="does not exist; create it first"):
            check_writable(tmp_path / "no" / "x")
        (tmp_path / "file").touch()
        with pytest.raises(OutputError, match="cannot be created: "):
            folder(tmp_path / "file" / "x")
        assert folder(tmp_path / "a" / "b").is_dir()

    @pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
    def test_a_folder_that_others_own(self, tmp_path: Path) -> None:
        tmp_path.chmod(0o500)
        with pytest.raises(OutputError, match=os.strerror(errno.EACCES)):
            check_writable(tmp_path / "x")

    def test_a_name_with_a_zero_in_it(self) -> None:
        with pytest.raises(OutputError, match="null byte"):
            check_writable(Path("a\0b"))
        with pytest.raises(OutputError, match="null byte"):
            write("a\0b", NEW, "result")


def test_an_output_error_is_no_input_error() -> None:
    assert not issubclass(OutputError, ValueError)
    assert issubclass(ScenarioError, ValueError)
