"""Every recording that is ordered comes to an end that is told: with files, or with what went wrong."""

from pathlib import Path

import pytest

from cotouch.errors import SessionError
from cotouch.observers import MailboxFolder, RecordingClient, RecordingOutcome

NAMES = ("Ann", "Ben")


class FakeCommandClient:
    """Members as their mailboxes say they are."""

    def __init__(self) -> None:
        self.steps = dict.fromkeys(NAMES, 5)
        self.under_way = dict.fromkeys(NAMES, 0)
        self.outcomes: dict[str, RecordingOutcome] = {}
        self.orders: list[tuple[int, bool]] = []

    def number(self, name: str, field: str) -> int:
        return {"step": self.steps, "recording": self.under_way}[field][name]

    def outcome(self, name: str) -> RecordingOutcome | None:
        return self.outcomes.get(name)

    def record(self, number: int, *, on: bool) -> None:
        self.orders.append((number, on))


class Room:
    """A recording desk, and what it is about."""

    def __init__(self, folder: Path) -> None:
        (folder / "recordings").mkdir()
        self.mailboxes, self.commands, self.said = MailboxFolder(folder), FakeCommandClient(), list[str]()
        self.recordings = RecordingClient(self.mailboxes, self.commands, NAMES, lambda _, text: self.said.append(text))  # type: ignore[arg-type]

    def file(self, name: str, number: int, size: int = 100) -> Path:
        path = self.mailboxes.recording(name, number, 7)
        path.write_bytes(b"x" * size)
        return path

    def ends(self, name: str, number: int, steps: int = 3, trouble: str = "") -> None:
        if steps:
            self.file(name, number)
        self.commands.under_way[name] = 0
        self.commands.outcomes[name] = RecordingOutcome(number, steps, trouble)


@pytest.fixture
def room(tmp_path: Path) -> Room:
    return Room(tmp_path)


def test_members_that_did_not_hear_of_it_yet_are_waited_for(room: Room) -> None:
    """Of the whole recording nothing was on the mailboxes when it ended; a while later there are its files."""
    room.recordings.switch(True, 1.0)
    room.recordings.turn(1.0, NAMES)
    room.recordings.switch(False, 1.05)
    for now in (1.06, 1.5, 3.0):
        room.recordings.turn(now, NAMES)
        assert room.recordings.look(now).state == "ending"
        assert room.recordings.hand_out() == ()
    with pytest.raises(SessionError, match="still being finished"):
        room.recordings.switch(True, 3.0)
    room.ends("Ann", 1)
    room.recordings.turn(3.1, NAMES)
    assert room.recordings.look(3.1).state == "ending"
    room.ends("Ben", 1)
    room.recordings.turn(3.2, NAMES)
    now = room.recordings.look(3.2)
    assert (now.state, now.text, now.troubles) == ("done", "2 files of 0.1 s, 0.00 MB", ())
    assert [name for name, _ in now.files] == ["Ann.1.7.mcap", "Ben.1.7.mcap"]
    assert room.commands.orders == [(1, True), (1, False)]
    assert room.said == ["recording 1: 2 files of 0.1 s, 0.00 MB"]
    assert room.recordings.troubles == []


def test_trouble_is_told_at_once_and_what_is_left_is_kept(room: Room) -> None:
    room.recordings.switch(True, 0.0)
    room.commands.under_way = dict.fromkeys(NAMES, 1)
    room.recordings.turn(1.0, NAMES)
    room.ends("Ann", 1, trouble="ends after 3 of 9 steps: No space left on device")
    room.recordings.turn(2.0, NAMES)
    now = room.recordings.look(2.0)
    assert (now.state, now.seconds) == ("on", 2.0)
    assert now.troubles == ("Ann's ends after 3 of 9 steps: No space left on device",)
    assert room.said == ["ALARM: recording 1: Ann's ends after 3 of 9 steps: No space left on device"]
    room.recordings.switch(False, 4.0)
    room.ends("Ben", 1)
    room.recordings.turn(4.1, NAMES)
    assert room.recordings.look(4.1).state == "done"
    assert len(room.recordings.hand_out()) == 2
    assert len(room.recordings.troubles) == 1


def test_it_ends_by_itself_where_nobody_records_any_more(room: Room) -> None:
    room.recordings.switch(True, 0.0)
    for name in NAMES:
        room.ends(name, 1, steps=0, trouble="was not started: Read-only file system")
    room.recordings.turn(1.0, NAMES)
    now = room.recordings.look(1.0)
    assert (now.state, now.text, now.files) == ("failed", "nothing was recorded", ())
    assert len(now.troubles) == 2
    assert room.commands.orders[-1] == (1, False)


def test_who_does_not_finish_is_named_and_not_waited_for(room: Room) -> None:
    room.recordings.switch(True, 0.0)
    room.recordings.switch(False, 5.0)
    room.file("Ben", 1)
    room.ends("Ann", 1)
    room.recordings.turn(14.9, NAMES)
    assert room.recordings.look(14.9).state == "ending"
    room.recordings.turn(15.1, NAMES)
    now = room.recordings.look(15.1)
    assert (now.state, now.troubles) == ("done", ("Ben's was not finished within 10 s and is cut off",))
    assert len(now.files) == 2


def test_whose_process_ended_is_named(room: Room) -> None:
    room.recordings.switch(True, 0.0)
    room.file("Ben", 1)
    room.recordings.turn(1.0, ("Ann",))
    assert room.recordings.look(1.0).troubles == ("Ben's is cut off because the process ended",)
    room.recordings.switch(False, 2.0)
    room.ends("Ann", 1)
    room.recordings.turn(2.1, ("Ann",))
    assert room.recordings.look(2.1).state == "done"
    # Who comes back records again, and is waited for again.
    room.recordings.switch(True, 3.0)
    room.recordings.turn(3.1, ("Ann",))
    room.commands.under_way["Ben"] = 2
    room.recordings.turn(3.2, NAMES)
    room.recordings.switch(False, 4.0)
    room.ends("Ann", 2)
    room.recordings.turn(4.1, NAMES)
    assert room.recordings.look(4.1).state == "ending"


def test_a_session_that_ends_ends_its_recording_which_is_kept(room: Room, tmp_path: Path) -> None:
    room.recordings.switch(True, 0.0)
    for name in NAMES:
        room.ends(name, 1)
    room.recordings.turn(1.0, (), ended=True)
    assert room.recordings.look(1.0).state == "done"
    said = room.recordings.close(1.0)
    assert said is not None
    folder = Path(said.rpartition(" ")[2])
    assert sorted(path.name for path in folder.iterdir()) == ["Ann.1.7.mcap", "Ben.1.7.mcap"]
    assert folder.stat().st_mode & 0o777 == 0o700
    for path in folder.iterdir():
        path.unlink()
    folder.rmdir()


def test_what_was_fetched_is_not_kept_and_what_never_came_is_told(room: Room) -> None:
    room.recordings.switch(True, 0.0)
    for name in NAMES:
        room.ends(name, 1)
    room.recordings.switch(False, 1.0)
    room.recordings.turn(1.0, NAMES)
    assert len(room.recordings.hand_out()) == 2
    # The next one lacks all its files, and the one before can still be had.
    room.recordings.switch(True, 2.0)
    assert room.recordings.close(3.0) is None
    now = room.recordings.look(3.0)
    assert (now.state, now.text) == ("failed", "nothing was recorded")
    assert len(now.troubles) == 2
    assert len(room.recordings.hand_out()) == 2


def test_orders_that_cannot_be_are_refused(room: Room) -> None:
    with pytest.raises(SessionError, match="nothing is being recorded"):
        room.recordings.switch(False, 0.0)
    room.commands.steps = dict.fromkeys(NAMES, -1)
    with pytest.raises(SessionError, match="no copy is moving yet"):
        room.recordings.switch(True, 0.0)
    room.commands.steps["Ben"] = 1
    room.recordings.switch(True, 0.0)
    with pytest.raises(SessionError, match="already under way"):
        room.recordings.switch(True, 0.0)
    # Nobody waits for Ann, who does not move.
    room.ends("Ben", 1)
    room.recordings.turn(0.1, NAMES)
    assert room.recordings.look(0.1).state == "done"
