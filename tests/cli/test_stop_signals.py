"""What ends a live command in order: Ctrl-C, SIGTERM, and a terminal that goes away."""

import os
import signal
import sys

import pytest
from tests.cli.inside import stop_signals

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="sends signals")


@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP"])
def test_a_signal_ends_the_loop_in_order_and_a_second_one_at_once(name: str) -> None:
    number = signal.Signals[name]
    given = signal.signal(number, signal.SIG_DFL)  # it is ignored where `nohup` runs the tests
    try:
        with stop_signals() as stopped:
            assert not stopped()
            os.kill(os.getpid(), number)
            assert stopped()
            with pytest.raises(KeyboardInterrupt):
                os.kill(os.getpid(), number)
        assert signal.getsignal(number) == signal.SIG_DFL
    finally:
        signal.signal(number, given)


class Behind:
    """Something behind which Python tidies up: it drops what is raised meanwhile."""

    def __del__(self) -> None:
        os.kill(os.getpid(), signal.SIGINT)


def test_a_signal_that_python_drops_is_kept_in_mind(capsys: pytest.CaptureFixture[str]) -> None:
    """A member that compiled as Ctrl-C came went on for good, with a traceback that concerned nobody."""
    with stop_signals() as stopped:
        things = [Behind()]
        things.clear()
        assert stopped()
    assert capsys.readouterr().err == ""


def test_a_command_that_is_to_outlive_its_terminal_does() -> None:
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        with stop_signals() as stopped:
            assert not stopped()
            os.kill(os.getpid(), signal.SIGHUP)
            assert not stopped()
    finally:
        signal.signal(signal.SIGHUP, before)
