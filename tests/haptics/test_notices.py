"""What whoever holds a device is told."""

from cotouch.haptics import Cause
from cotouch.haptics._notices import Notices

NONE = Cause(0)


def test_why_force_is_gone_is_said_once_and_that_it_is_back():
    now = [0.0]
    notices = Notices(lambda: now[0])
    for causes in (Cause.OFF, Cause.OFF | Cause.DEVICE, Cause.RAMP, Cause.SLEW | Cause.QUIET):
        notices.force(causes)  # before there was force, and what needs no words
    assert notices.fresh() == []
    for causes in (Cause.SILENT, Cause.SILENT, Cause.RAMP):
        notices.force(causes)
    assert notices.fresh() == ["force is off or less: the peer has been silent for too long", "force is back"]
    notices.force(Cause.FAST)  # other words are said at once
    assert notices.fresh() == ["force is off or less: the device moved faster than a hand does; re-arm to go on"]


def test_motors_that_come_and_go_at_what_they_can_hold_are_not_said_all_the_time():
    now = [0.0]
    notices = Notices(lambda: now[0])
    notices.force(NONE)
    for k in range(120):  # a minute of pushing
        now[0] = 0.5 * k
        notices.force(Cause.HOT if k % 2 else NONE)
    said = notices.fresh()
    assert len([text for text in said if "what they can hold for long" in text]) == 2
    assert said.count("force is back") == 2
    notices.force(Cause.HOT | Cause.SILENT)  # what is graver is said all the same
    assert notices.fresh() == ["force is off or less: the peer has been silent for too long"]


def test_what_ends_force_for_good_is_said_though_there_never_was_any():
    notices = Notices(lambda: 0.0)
    notices.force(Cause.FAULT | Cause.OFF)
    assert notices.fresh() == ["force is off or less: the device failed or gave no numbers"]
