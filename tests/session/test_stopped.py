"""A demonstration that is stopped while its members load."""

import signal

import pytest

from cotouch.errors import SessionError
from cotouch.session import DemoSessionApi, demo_session, play


@pytest.mark.parametrize(("stopped", "error"), [(True, KeyboardInterrupt), (False, SessionError)])
def test_members_that_end_first_fail_only_if_nobody_stopped_them(stopped: bool, error: type[BaseException]) -> None:
    """Ctrl-C reaches everybody at once, and members may have ended before the demonstration looks."""
    asked: list[int] = []

    def ctrl_c(api: DemoSessionApi, now: float) -> None:
        del now
        for member in api.members.values():
            member.kill()
        asked.append(signal.SIGINT)

    with pytest.raises(error) as caught:
        play(demo_session(users=1, body="point"), seconds=1.0, each=ctrl_c, stopped=lambda: stopped and bool(asked))
    assert asked == [signal.SIGINT]
    assert stopped or "could not take part" in str(caught.value)
