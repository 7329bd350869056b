from cotouch.members import Pace


def test_what_was_before_a_restart_does_not_count() -> None:
    pace = Pace(0.002)
    pace.stepped(0.05, 0.3, 0.3)
    assert pace.since()["missed"] == 174
    pace.restart()
    pace.stepped(0.002, 0.0, 0.001)
    assert pace.since() == {"rate": 500.0, "longest_period": 0.002, "missed": 0, "stood": 0.0, "busy": 0.5}
    pace.restart(0.001)
    pace.stepped(0.002, 0.0, 0.001)
    assert pace.since()["missed"] == 1
