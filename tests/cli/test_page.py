"""`--page`: when there is one, where, and what is said of it."""

import json
import sys
import threading
import webbrowser
from contextlib import AbstractContextManager
from typing import Any

import pytest
from tests.cli.inside import page_module
from tests.web.fake_session_api import FakeSessionApi
from typer.testing import CliRunner
from websockets.sync.client import connect

from cotouch.cli import app
from cotouch.errors import SessionError, TransportError
from cotouch.members import Participation
from cotouch.session import demo_session, open_host
from cotouch.web import PageAddress


def test_nothing_is_served_unless_wanted():
    with page_module.page(wanted=False, port=70_000, listen="nonsense.", tell=print) as beside:
        assert beside is None


def test_a_stage_is_served_and_the_address_said(monkeypatch: pytest.MonkeyPatch):
    told: list[str] = []
    monkeypatch.setattr("cotouch.cli._page.desktop", lambda: False)
    with page_module.page(wanted=True, port=0, listen="127.0.0.1", tell=told.append) as beside:
        assert beside is not None
        with beside(FakeSessionApi("1d")):
            (said,) = told
            url = said.split()[-1]
            assert said.startswith("the page is at http://127.0.0.1:")
            own, token = url.split("/#token=")
            with connect(own.replace("http", "ws") + "/ws", origin=own) as page:
                page.send(json.dumps({"type": "hello", "version": 3, "token": token}))
                assert json.loads(page.recv(10))["acts"]
        with pytest.raises(OSError, match="refused"):
            connect(own.replace("http", "ws") + "/ws", origin=own)


def test_who_can_reach_it_from_elsewhere_is_said(monkeypatch: pytest.MonkeyPatch):
    told: list[str] = []
    monkeypatch.setattr(PageAddress, "local", False)  # without opening a port to others here
    with page_module.page(wanted=True, port=0, listen="127.0.0.1", tell=told.append) as beside:
        assert beside is not None
        with beside(FakeSessionApi("1d")):
            assert told[1].startswith("others can reach 127.0.0.1")


@pytest.mark.parametrize(("kind", "opened"), [(webbrowser.BackgroundBrowser, 1), (webbrowser.GenericBrowser, 0)])
def test_a_browser_gets_a_ticket_and_only_one_with_a_window(kind: type, opened: int, monkeypatch: pytest.MonkeyPatch):
    told: list[str] = []
    calls: list[str] = []
    monkeypatch.setattr("cotouch.cli._page.desktop", lambda: True)
    browser = kind("made-up")
    monkeypatch.setattr(browser, "open", calls.append)
    monkeypatch.setattr(webbrowser, "get", lambda: browser)
    with page_module.page(wanted=True, port=0, listen="127.0.0.1", tell=told.append) as beside:
        assert beside is not None
        with beside(FakeSessionApi("1d")):
            for thread in threading.enumerate():
                if thread.name == "cotouch browser":
                    thread.join(10)
    token = told[0].split("#token=")[1]
    assert len(calls) == opened
    assert all("/open?ticket=" in call and token not in call for call in calls)


@pytest.mark.parametrize(("terminal", "display", "sits"), [(True, ":0", True), (True, "", False), (False, ":0", False)])
def test_desktop(terminal: bool, display: str, sits: bool, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(sys, "stderr", type("Terminal", (), {"isatty": lambda self: terminal})())
    monkeypatch.setenv("DISPLAY", display)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    assert page_module.desktop() is sits


class TestDemo:
    @pytest.fixture
    def asked(self, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
        """What `cotouch demo` would play, and whether with a page."""
        found: dict[str, Any] = {}
        monkeypatch.setattr("cotouch.cli._demo.run", lambda **options: found.update(options))
        return found

    @pytest.mark.parametrize(
        ("options", "terminal", "page", "seconds"),
        [
            ((), True, True, None),
            ((), False, True, 30.0),
            (("--no-page",), True, False, 30.0),
            (("--duration", "5"), True, True, 5.0),
            (("--headless",), True, False, 30.0),
            (("--json",), True, False, 30.0),
            (("--json", "--page"), False, True, 30.0),
        ],
    )
    def test_page_and_length(
        self,
        options: tuple[str, ...],
        terminal: bool,
        page: bool,
        seconds: float | None,
        asked: dict[str, Any],
        monkeypatch: pytest.MonkeyPatch,
    ):
        monkeypatch.setattr("cotouch.cli._page.watched", lambda: terminal)
        result = CliRunner().invoke(app, ["demo", *options, "--port", "0"], catch_exceptions=False)
        assert result.exit_code == 0, result.output
        assert (asked["beside"] is not None, asked["seconds"]) == (page, seconds)

    def test_a_taken_port_is_said_before_anything_begins(self, asked: dict[str, Any]):
        at = PageAddress(port=0)
        try:
            with pytest.raises(TransportError, match=f"port {at.port} of 127.0.0.1 is not available"):
                CliRunner().invoke(app, ["demo", "--port", str(at.port)], catch_exceptions=False)
        finally:
            at.close()
        assert asked == {}


@pytest.fixture(scope="module")
def line() -> str:
    """An invitation."""
    with open_host(demo_session()) as opened:
        return opened.invitation.encode()


class TestJoin:
    def test_has_its_own_page(self, monkeypatch: pytest.MonkeyPatch, line: str):
        found: dict[str, Any] = {}

        def staged(
            invitation: object, beside: AbstractContextManager[object], part: Participation, *, quiet: bool
        ) -> None:
            found.update(part=part, beside=beside, quiet=quiet)

        monkeypatch.setattr("cotouch.cli._session.staged", staged)
        CliRunner().invoke(app, ["join", line, "--page", "--port", "0", "--name", "Ann"], catch_exceptions=False)
        assert found["beside"] is not None
        assert (found["part"].name, found["part"].hand, found["quiet"]) == ("Ann", "scripted", False)

    def test_has_no_page_with_json(self, line: str):
        with pytest.raises(SessionError, match="--page and --json"):
            CliRunner().invoke(app, ["join", line, "--page", "--json"], catch_exceptions=False)
