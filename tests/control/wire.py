"""What goes over Zenoh between members, for tests that listen to it or say there what no member would."""

import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, final

import pytest
from tests.control.inside import SessionKeys, open_session, start_of

if TYPE_CHECKING:
    import zenoh


@final
class Sessions:
    """The sessions of Zenoh that members open where this is made, in the order in which they join.

    Args:
        monkeypatch: puts this between members and Zenoh.
        around: what members are given instead of a session.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch, around: Callable[[Any], Any] = lambda session: session) -> None:
        self._joined: list[zenoh.Session] = []
        here = threading.get_ident()

        def opened(configured: str) -> "zenoh.Session":
            session = around(open_session(configured))
            if threading.get_ident() == here:  # others open what introduces members to each other
                self._joined.append(session)
            return session

        monkeypatch.setattr("cotouch.control._line.open_session", opened)

    def __getitem__(self, member: int) -> "zenoh.Session":
        return self._joined[member]


def starts_of(session: "zenoh.Session", keys: SessionKeys, member: bytes) -> set[str]:
    """Names of the starts of a member that a session sees.

    Args:
        session: of another member.
        keys: of any member.
        member: its public key.
    """
    shown = [start_of(str(reply.ok.key_expr)) for reply in session.liveliness().get(keys.starts) if reply.ok]
    return {start.name for start in shown if start is not None and start.member == member}
