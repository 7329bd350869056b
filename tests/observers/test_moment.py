"""What is shown of a session that is over."""

from cotouch.members import Entry, Roster, SessionEvent, Status
from cotouch.observers import LastMoment, Overview, RecordingState


def overview(time: float, *slots: int, ended: bool = False, stepped: int = 0) -> Overview:
    members = [Entry(slot=slot, name=f"user {slot}", key=f"{slot:064x}") for slot in slots]
    return Overview(
        time=time,
        roster=Roster(epoch=1, members=members),
        statuses={slot: Status(slot=slot, steps=stepped, supplied=0.5) for slot in slots},
        alive=dict.fromkeys(slots, True),
        emulated={},
        choices={},
        damping=1.0,
        recording=RecordingState(number=int(time)),
        events=[SessionEvent(time, "something")],
        left=False,
        ended=ended,
    )


def test_who_leaves_because_it_ends_is_still_shown_with_the_books_that_were() -> None:
    moment = LastMoment()
    assert moment.seen(overview(0.0, 0, 1, 2, stepped=1)).statuses[2].steps == 1
    moment.seen(overview(1.0, 0, 1, 2, stepped=7))
    moment.seen(overview(1.2, 0, 1, stepped=8))  # the first leaves before the end is heard of
    last = moment.seen(overview(1.4, ended=True))
    assert last.ended
    assert [entry.slot for entry in last.roster.members] == [0, 1, 2]
    assert {slot: (status.steps, status.supplied) for slot, status in last.statuses.items()} == dict.fromkeys(
        (0, 1, 2), (7, 0.5)
    )
    # What goes on after the end goes on.
    assert (last.time, last.recording.number, last.events[-1].time) == (1.4, 1, 1.4)
    assert moment.seen(overview(9.0, ended=True)).statuses.keys() == {0, 1, 2}


def test_who_left_long_before_is_not_shown_again() -> None:
    moment = LastMoment()
    moment.seen(overview(0.0, 0, 1, 2))
    for tenth in range(40):
        shown = moment.seen(overview(0.1 * tenth, 0, 1, stepped=tenth))
        assert set(shown.statuses) == {0, 1}
    assert moment.seen(overview(4.0, ended=True)).statuses[1].steps == 39
    assert set(moment.seen(overview(4.0, ended=True)).statuses) == {0, 1}


def test_a_session_that_never_was_is_over_too() -> None:
    assert LastMoment().seen(overview(1.0, ended=True)).ended
