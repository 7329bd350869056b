"""How a member shows that it is there, and leaves."""

from typing import Any

import pytest
import zenoh
from tests.control.inside import Line
from tests.live.support import entropy, identities

from cotouch.control import Endpoint, Invitation


class Session:
    """A session of Zenoh, and a token in it, that only note what is asked of them."""

    def __init__(self, fails: bool) -> None:
        self.did, self._fails = list[str](), fails

    def liveliness(self) -> "Session":
        return self

    def declare_token(self, key: str) -> "Session":
        self.did.append(key)
        return self

    def undeclare(self) -> None:
        self.did.append("withdrawn")
        if self._fails:
            raise zenoh.ZError("it is closing")

    def close(self) -> None:
        self.did.append("closed")


@pytest.mark.parametrize("fails", [False, True])
def test_a_token_is_withdrawn_before_the_session_closes(fails: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Which takes ten seconds where it dials somebody who does not answer; others would take it for connected."""
    session: Any = Session(fails)
    monkeypatch.setattr("cotouch.control._line.open_session", lambda configured: session)
    at = (Endpoint("127.0.0.1", 9),)
    made = Invitation.make(session="a", host=identities()[0].public, digest=bytes(32), entropy=entropy(1), endpoints=at)
    line = Line(made, (), mode="client", connect=at)
    line.show("a key")
    line.close()
    assert session.did == ["a key", "withdrawn", "closed"]
