"""Who went away is looked for with a knock; a session beside is opened only where somebody answers."""

import socket
import threading
import time
from collections.abc import Callable, Sequence

import pytest
from tests.control.inside import Introducer, answering
from tests.live.support import identities

from cotouch.control import Endpoint, free_port

ONE, TWO = (identity.public for identity in identities(2))
HERE = Endpoint("127.0.0.1", 9)


def until(done: Callable[[], object]) -> None:
    end = time.monotonic() + 60.0
    while not done():
        if time.monotonic() > end:
            pytest.fail("it did not come")
        time.sleep(0.005)


def test_knocking_finds_who_listens():
    with socket.create_server(("127.0.0.1", 0)) as server:
        there, gone = Endpoint("127.0.0.1", server.getsockname()[1]), Endpoint("127.0.0.1", free_port())
        assert answering([gone, there], threading.Event()) == {there}
        assert answering([gone], threading.Event()) == set()
        assert answering([], threading.Event()) == set()
    # Names are left to whoever resolves them: that may take long.
    named = Endpoint("somewhere.example", 7)
    assert answering([named, gone], threading.Event()) == {named}


class Beside:
    """Stands for a session of Zenoh."""

    def __init__(self) -> None:
        self.open = True

    def close(self) -> None:
        self.open = False


def test_no_session_is_opened_for_who_does_not_answer(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.control._introducer._PATIENCE", 0.0)
    monkeypatch.setattr("cotouch.control._introducer._PERIOD", 0.01)
    monkeypatch.setattr("cotouch.control._introducer._KNOCK_EVERY", 0.05)
    opened, made = list[tuple[Endpoint, ...]](), list[Beside]()
    knocks = list[int]()
    monkeypatch.setattr(
        "cotouch.control._introducer.answering", lambda at, closing: (knocks.append(len(at)), answering(at, closing))[1]
    )

    def beside(endpoints: Sequence[Endpoint]) -> Beside:
        opened.append(tuple(endpoints))
        made.append(Beside())
        return made[-1]

    port = free_port()
    crashed, cut_off = Endpoint("127.0.0.1", free_port()), Endpoint("127.0.0.1", port)
    looks = Introducer(HERE, beside, time.monotonic)  # type: ignore[arg-type]
    try:
        looks.gone(ONE, crashed)
        looks.gone(TWO, cut_off)
        until(lambda: sum(count == 2 for count in knocks) >= 3)
        assert opened == []
        with socket.create_server(("127.0.0.1", port)):
            until(lambda: opened)
            assert opened == [(HERE, cut_off)]
            until(lambda: knocks[-1] == 1)  # on the other one only
            looks.back(TWO)
            until(lambda: not made[0].open)
        assert opened == [(HERE, cut_off)]
    finally:
        looks.close()
    assert not any(one.open for one in made)
