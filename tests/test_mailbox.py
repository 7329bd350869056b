import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from cotouch.errors import InputError
from cotouch.mailbox import MailboxReader, MailboxWriter

FIELDS = {"time": ((), "f8"), "place": ((3, 4), "f4"), "count": ((5,), "i8"), "text": ((7,), "u1")}
READER = """
import sys
from pathlib import Path
from cotouch.mailbox import MailboxReader
mailbox, seen, last = MailboxReader(Path(sys.argv[1])), 0, 0
print("ready", flush=True)
while last < int(sys.argv[2]):
    got = mailbox.read()
    if got is None:
        continue
    values = set(got["wide"].tolist())
    assert len(values) == 1, values
    assert values.pop() > last
    last, seen = int(got["wide"][0]), seen + 1
print(seen)
"""


@pytest.mark.parametrize("checked", [False, True])
def test_newest_is_read_and_older_is_not_given_again(tmp_path: Path, checked: bool) -> None:
    writer = MailboxWriter(tmp_path / "mailbox", FIELDS, checked=checked)
    reader = MailboxReader(tmp_path / "mailbox")
    assert reader.read() is None
    for n in range(1, 11):
        writer.fields["time"][()] = 0.5 * n
        writer.fields["place"][...] = np.arange(12).reshape(3, 4) + n
        writer.fields["count"][2] = -n
        writer.publish()
        got = reader.read()
        assert got is not None
        assert reader.number == n
        assert got["time"] == 0.5 * n
        assert (got["place"] == np.arange(12).reshape(3, 4) + n).all()
        assert got["count"].tolist() == [0, 0, -n, 0, 0]
        assert reader.read() is None
        assert reader.read(anew=True) is not None
    writer.fields["time"][()] = 7.0
    writer.publish()
    writer.publish()
    got = reader.read()
    assert got is not None
    assert got["time"] == 7.0
    assert reader.number == 12


def test_what_was_read_is_not_changed_by_later_writing(tmp_path: Path) -> None:
    writer = MailboxWriter(tmp_path / "mailbox", {"x": ((2,), "f8")})
    writer.fields["x"][:] = 1.0
    writer.publish()
    got = MailboxReader(tmp_path / "mailbox").read()
    for _ in range(9):
        writer.fields["x"][:] = 2.0
        writer.publish()
    assert got is not None
    assert got["x"].tolist() == [1.0, 1.0]


@pytest.mark.parametrize("checked", [False, True])
def test_another_process_never_sees_a_torn_board(tmp_path: Path, checked: bool) -> None:
    rounds = 20_000
    writer = MailboxWriter(tmp_path / "mailbox", {"wide": ((700,), "i8")}, checked=checked)
    with subprocess.Popen(
        [sys.executable, "-c", READER, str(writer.path), str(rounds)], stdout=subprocess.PIPE, text=True
    ) as reader:
        assert reader.stdout is not None
        assert reader.stdout.readline() == "ready\n"
        for n in range(1, rounds + 1):
            writer.fields["wide"][:] = n
            writer.publish()
        said, _ = reader.communicate(timeout=60)
        assert reader.returncode == 0
        assert int(said) >= 1


def test_a_slot_that_is_being_written_is_not_read(tmp_path: Path) -> None:
    writer = MailboxWriter(tmp_path / "mailbox", {"x": ((), "f8")}, checked=True)
    writer.publish()
    reader = MailboxReader(tmp_path / "mailbox")
    with (tmp_path / "mailbox").open("r+b") as file:  # slot 1 holds number 1: overtaken
        content = file.read()
        place = content.index(struct.pack("<q", 1), content.index(struct.pack("<q", 1)) + 8)
        file.seek(place)
        file.write(struct.pack("<q", -1))
    assert reader.read() is None


def test_a_wrong_checksum_is_not_read(tmp_path: Path) -> None:
    writer = MailboxWriter(tmp_path / "mailbox", {"x": ((), "f8")}, checked=True)
    writer.fields["x"][()] = 1.25
    writer.publish()
    with (tmp_path / "mailbox").open("r+b") as file:
        place = file.read().index(struct.pack("<d", 1.25))
        file.seek(place)
        file.write(struct.pack("<d", 1.5))
    assert MailboxReader(tmp_path / "mailbox").read() is None


def test_nobody_else_may_read_it_and_closing_removes_it(tmp_path: Path) -> None:
    writer = MailboxWriter(tmp_path / "mailbox", FIELDS)
    assert writer.path.stat().st_mode & 0o777 == 0o600
    writer.publish()
    reader = MailboxReader(writer.path)
    writer.close()
    writer.close()
    assert not writer.path.exists()
    assert reader.read() is not None
    reader.close()


def test_what_is_no_board_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="cannot be opened: No such file"):
        MailboxReader(tmp_path / "none")
    (tmp_path / "empty").touch()
    with pytest.raises(InputError, match="it is empty"):
        MailboxReader(tmp_path / "empty")
    for content in (b"x" * 10, b"y" * 500, b"mailbox format 2" + struct.pack("<qq", 5, 8) + b"{}abc" + bytes(99)):
        (tmp_path / "wrong").write_bytes(content)
        with pytest.raises(InputError, match="not a mailbox of this version"):
            MailboxReader(tmp_path / "wrong")
    MailboxWriter(tmp_path / "there", FIELDS)
    with pytest.raises(InputError, match="File exists"):
        MailboxWriter(tmp_path / "there", FIELDS)
    with pytest.raises(InputError, match="No such file"):
        MailboxWriter(tmp_path / "nowhere" / "mailbox", FIELDS)
