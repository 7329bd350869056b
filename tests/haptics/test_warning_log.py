"""What whoever holds a device is told."""

from tests.haptics.inside import WarningLog

from cotouch.haptics import Cause

NONE = Cause(0)


def test_why_force_is_gone_is_said_once_and_that_it_is_back():
    now = [0.0]
    warning_log = WarningLog(lambda: now[0])
    for causes in (Cause.OFF, Cause.OFF | Cause.DEVICE, Cause.RAMP, Cause.SLEW | Cause.QUIET):
        warning_log.force(causes)  # before there was force, and what needs no words
    assert warning_log.fresh() == []
    for causes in (Cause.SILENT, Cause.SILENT, Cause.RAMP):
        warning_log.force(causes)
    assert warning_log.fresh() == ["force is off or less: the peer has been silent for too long", "force is back"]
    warning_log.force(Cause.FAST)  # other words are said at once
    assert warning_log.fresh() == ["force is off or less: the device moved faster than any hand; re-arm to continue"]


def test_motors_that_come_and_go_at_what_they_can_hold_are_not_said_all_the_time():
    now = [0.0]
    warning_log = WarningLog(lambda: now[0])
    warning_log.force(NONE)
    for k in range(120):  # a minute of pushing
        now[0] = 0.5 * k
        warning_log.force(Cause.HOT if k % 2 else NONE)
    said = warning_log.fresh()
    assert len([text for text in said if "what they can sustain" in text]) == 2
    assert said.count("force is back") == 2
    warning_log.force(Cause.HOT | Cause.SILENT)  # what is graver is said all the same
    assert warning_log.fresh() == ["force is off or less: the peer has been silent for too long"]


def test_what_ends_force_for_good_is_said_though_there_never_was_any():
    warning_log = WarningLog(lambda: 0.0)
    warning_log.force(Cause.FAULT | Cause.OFF)
    assert warning_log.fresh() == ["force is off or less: the device failed or returned no valid numbers"]
