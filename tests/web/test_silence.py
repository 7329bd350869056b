"""What a page shows when nobody answers, when the session is over, and of recordings that fail."""

import json
import signal
import socket
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager

import pytest
from playwright.sync_api import Browser, Page
from tests.simulation.browser import UNHURRIED
from tests.web.fake_session_api import FakeSessionApi
from tests.web.shell_pages import BEFORE, PATIENCE, READY, World, grab, words, world
from tests.web.visitor import visit

from cotouch.members import Status
from cotouch.observers import RecordingState
from cotouch.web import PageServer

STATE = "() => window.cotouch.store.connection"


@contextmanager
def served() -> Generator[tuple[subprocess.Popen[str], str]]:
    """A server in a process of its own, which can be stopped; its address."""
    running = subprocess.Popen(
        [sys.executable, "-m", "tests.web.serve", "--body", "1d", "--port", "0"], stdout=subprocess.PIPE, text=True
    )
    try:
        assert running.stdout is not None
        yield running, running.stdout.readline().strip()
    finally:
        running.send_signal(signal.SIGCONT)
        running.kill()
        running.communicate()


def opened(running: Browser, address: str) -> Page:
    context = running.new_context(viewport={"width": 1280, "height": 720})
    context.set_default_timeout(PATIENCE)
    context.add_init_script(BEFORE)
    context.add_init_script(UNHURRIED)
    page = context.new_page()
    page.goto(address)
    page.wait_for_function(READY)
    return page


def test_a_server_that_hangs_is_said_and_one_that_goes_on_too(running: Browser) -> None:
    with served() as (server, address):
        page = opened(running, address)
        grab(page, 0.05)
        page.wait_for_function("() => window.cotouch.store.frame.copies[0].mode === 'grab'")
        server.send_signal(signal.SIGSTOP)
        words(page, "#banner-silent", "The server does not respond")
        words(page, "#verdict", "No response")
        assert page.is_disabled("#record")
        assert not page.evaluate("() => window.cotouch.connection.mayAct")
        # It is tried anew, in vain: a hung server takes connections and says nothing.
        page.evaluate(
            """() => { window.dialled = 0; const Real = WebSocket; window.WebSocket = class extends Real {
                constructor(...all) { super(...all); window.dialled++; } }; }"""
        )
        page.wait_for_function("() => window.dialled >= 2", timeout=30_000)
        assert page.evaluate(STATE) == "silent"
        server.send_signal(signal.SIGCONT)
        page.wait_for_selector("#banner-silent", state="hidden")
        page.wait_for_function("() => window.cotouch.connection.mayAct && !document.querySelector('#record').disabled")
        words(page, "#verdict", "to spare")
        page.context.close()


def test_a_short_halt_needs_no_new_connection(here: World) -> None:
    page = here.open()
    page.evaluate(
        """() => { const { store, connection } = window.cotouch;
            window.socket = connection.socket; store.connected('silent'); }"""
    )
    page.wait_for_function(f"() => ({STATE})() === 'open'")
    page.wait_for_selector("#banner-silent", state="hidden")
    assert page.evaluate("() => window.socket === window.cotouch.connection.socket")


def test_a_server_that_never_answered_is_said(running: Browser, here: World) -> None:
    """Its port takes connections, and that is all."""
    page = here.open()
    with socket.create_server(("127.0.0.1", 0)) as hung:
        address = f"ws://127.0.0.1:{hung.getsockname()[1]}/ws"
        page.evaluate(
            """address => { const { connection } = window.cotouch;
                connection.address = address; connection.socket.close(); }""",
            address,
        )
        page.wait_for_function(f"() => ({STATE})() === 'silent'")
        words(page, "#banner-silent", "The server does not respond")
    here.complaints.clear()  # of a port where nobody listens any more


def test_a_session_whose_process_hangs_is_said(here: World) -> None:
    """The server answers, and what it knows of the session is old."""
    page = here.open()
    here.api.loop_age = 4.0
    words(page, "#banner-silent", "The session’s process does not respond")
    assert page.is_disabled("#record")
    here.api.loop_age = 0.0
    page.wait_for_selector("#banner-silent", state="hidden")
    assert page.is_enabled("#record")


def cells(page: Page) -> list[str]:
    return page.evaluate("() => [...document.querySelectorAll('#energy td')].map((cell) => cell.textContent)")


def test_the_last_moment_stands_still(running: Browser) -> None:
    made = world(running)
    with made as here:
        page = here.open()
        page.wait_for_function(
            "() => Object.values(window.cotouch.store.state.members).reduce((a, b) => a + b.supplied, 0) > 0.01"
        )
        here.api.ended = True
        words(page, "#banner-ended", "You see its final state")
        words(page, "#verdict", "session is over")
        words(page, '.user[data-slot="0"] .presence', "finished")
        words(page, '.user[data-slot="0"] .metrics', "500")
        words(page, "#users .panel-note", "5 of 5 here")
        assert page.evaluate("() => getComputedStyle(document.querySelector('#energy h2'), '::after').content") == (
            '"last moment"'
        )
        before = page.evaluate("() => window.cotouch.store.frame.number")
        page.wait_for_function("() => window.cotouch.store.state.time > 1")
        assert page.evaluate("() => window.cotouch.store.frame.number") == before
        assert page.is_disabled("#record")
        last = cells(page)
        assert any(cell not in {"0", "–", ""} for cell in last)
        # The server goes with the session; what is seen stays, and no connection is said to be lost.
        here.server.close()
        page.wait_for_function(f"() => ({STATE})() === 'lost'")
        assert page.is_hidden("#banner-lost")
        assert page.is_visible("#banner-ended")
        words(page, "#verdict", "session is over")
        assert cells(page) == last
        here.complaints.clear()  # the browser's own, of a port where nobody listens


class TestLoweredDamping:
    def test_goes_with_its_page(self) -> None:
        api = FakeSessionApi("1d")
        with PageServer(api, port=0) as server, visit(server, slot=None) as other:
            with visit(server) as page:
                assert page.do("damping", fraction=0.3)["ok"]
                other.text("state", lambda m: m["damping"] == 0.3)
                for _ in range(5):
                    other.text("state")
                assert set(api.held) == {True}  # it is there, and it is said again and again
            other.text("state", lambda m: m["damping"] == 1.0)
            assert api.held[-1] is False
            other.text("state", lambda m: any("gone" in event["text"] for event in m["events"]))

    def test_goes_with_the_control(self) -> None:
        api = FakeSessionApi("1d")
        with PageServer(api, port=0) as server, visit(server) as page, visit(server) as other:
            assert page.do("damping", fraction=0.3)["ok"]
            assert other.do("control")["ok"]
            other.text("state", lambda m: m["damping"] == 1.0)
            assert False in api.held

    def test_goes_with_a_page_that_hangs(self) -> None:
        """Its connection is there and answers pings; it takes no frame and says nothing."""
        api = FakeSessionApi("1d")
        with PageServer(api, port=0) as server, visit(server, slot=1) as other, visit(server) as page:
            page.frame()
            assert page.do("damping", fraction=0.3)["ok"]
            page.acknowledge = False
            other.text("state", lambda m: m["damping"] == 0.3)
            other.text("state", lambda m: m["damping"] == 1.0)
            assert False in api.held

    def test_is_anothers_who_lowers_it_further(self) -> None:
        api = FakeSessionApi("1d")
        with PageServer(api, port=0) as server, visit(server, slot=1) as other:
            with visit(server) as page:
                assert page.do("damping", fraction=0.3)["ok"]
                assert other.do("damping", fraction=0.2)["ok"]
            for _ in range(4):
                assert other.text("state")["damping"] == 0.2
            assert other.do("damping", 2, fraction=1.0)["ok"]
        assert api.held[-1] is True or set(api.held) == {True}


def test_a_page_that_hangs_lets_go_and_takes_hold_again_when_it_goes_on() -> None:
    api = FakeSessionApi("1d")
    with PageServer(api, port=0) as server, visit(server) as page, visit(server) as other:
        page.frame()
        page.text("state", lambda m: m["control"] == "mine")
        other.text("state", lambda m: m["control"] == "other")
        page.acknowledge = False
        other.text("state", lambda m: m["control"] == "mine")  # who waits longest has it
        page.acknowledge = True
        page.hello(token=server.token, slot=0)
        page.text("state", lambda m: m["control"] == "other")


class TestRecordings:
    def test_a_failure_is_said_at_once_and_its_end_too(self, here: World) -> None:
        page = here.open()
        page.click("#record")
        words(page, "#record", r"^0:0\d$")
        trouble = "Ann's ends after 3 of 9 steps: No space left on device"
        here.api.recording_state = here.api.recording_state._replace(troubles=(trouble,))
        words(page, "#banner-recording", "The recording is incomplete: Ann's ends after 3 of 9 steps")
        assert page.get_attribute("#record", "data-wrong") == ""
        assert "incomplete" in (page.get_attribute("#record", "aria-label") or "")
        here.api.recording_since = None
        here.api.recording_state = RecordingState(
            state="failed", number=1, text="nothing was recorded", troubles=(trouble, "no user left a file")
        )
        words(page, "#banner-recording", "Nothing was recorded: ")
        words(page, ".toast", "Nothing was recorded")
        assert page.is_hidden("#download")
        page.click("#banner-recording >> text=Dismiss")
        page.wait_for_selector("#banner-recording", state="hidden")

    def test_while_it_is_finished_nothing_can_be_begun(self, here: World) -> None:
        page = here.open()
        here.api.recording_state = RecordingState(state="ending", number=1, seconds=10.0)
        words(page, "#record", "Finishing")
        assert page.is_disabled("#record")
        page.keyboard.press("r")
        here.api.recording_state = RecordingState(
            state="done", number=1, seconds=10.0, text="5 files of 10.0 s, 3.10 MB"
        )
        words(page, ".toast", "Recorded: 5 files of 10.0 s")
        words(page, "#record", "Record")
        assert here.did("record") == []
        # The server lost it meanwhile.
        here.api.files = ()
        here.api.recording_state = here.api.recording_state._replace(number=1)
        page.route("**/recording.zip*", lambda route: route.fulfill(status=404))
        page.click("#download")
        words(page, ".toast", "no longer has the recording")
        here.complaints.clear()  # the browser's own, of the 404

    def test_what_was_over_before_is_no_news(self, here: World) -> None:
        here.api.recording_state = RecordingState(state="done", number=3, text="5 files")
        page = here.open()
        page.wait_for_selector("#download")
        assert page.is_hidden(".toast")

    def test_a_members_own_recording_that_stops_is_said(self, here: World, monkeypatch: pytest.MonkeyPatch) -> None:
        page = here.open()
        status = here.api.status

        def failed(slot: int, roster: object) -> Status:
            commanded = status(slot, roster)  # type: ignore[arg-type]
            if slot != 2:
                return commanded
            return commanded.model_copy(update={"recording": "failed", "recording_failure": "No space left on device"})

        monkeypatch.setattr(here.api, "status", failed)
        words(page, "#banner-recording", "The recording of Cleo stopped: No space left on device")

    def test_one_that_comes_late_is_offered_all_the_same(self) -> None:
        """The one of 10 s that never came: its files were whole only after the server had looked for them."""
        api = FakeSessionApi("1d")
        with PageServer(api, port=0) as server, visit(server) as page:
            assert page.do("record", on=True)["ok"]
            assert page.do("record", 2, on=False)["ok"]
            done = api.recording_state
            api.recording_state = RecordingState(state="ending", number=1)
            for _ in range(6):  # more than a second
                page.text("state", lambda m: m["recording"]["state"] == "ending")
            api.recording_state = done
            commanded = page.text("state", lambda m: m["recording"]["state"] == "done")
        assert json.loads(json.dumps(commanded["recording"]))["files"][0][0] == "Ann.mcap"
