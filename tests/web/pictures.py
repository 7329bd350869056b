"""Pages that show the picture of a made-up session, and hands on them."""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any
from urllib.parse import urlsplit

from playwright.sync_api import Browser, Page
from tests.simulation.browser import UNHURRIED
from tests.web.fake_session_api import FakeSessionApi, Kind

from cotouch.observers import MoveHand, Pointer
from cotouch.web import PageServer

# A machine without a graphics card and with other work draws a few pictures a second [ms].
PATIENCE = 60_000
TOKEN = "a-token-for-tests-only"
READY = "() => window.cotouch?.store.state && window.cotouch.stats.frames > 1"
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True, "device_scale_factor": 1}
# Whoever was here before is not asked to take the tour.
BEFORE = 'localStorage.setItem("cotouch.tour", JSON.stringify({over: true}))'
# Where the pointer was when the page, picture and all, last heard of it.
POINTED = "addEventListener('pointermove', ({ clientX, clientY }) => { window.pointed = [clientX, clientY]; });"


class Shown:
    """A stage, its server, and pages with all that they asked for and complained about."""

    def __init__(self, running: Browser, kind: Kind, *, still: bool, **stands: Any) -> None:
        self.browser, self.kind, self.stands = running, kind, stands
        self.complaints: list[str] = []
        self.requests: list[str] = []
        self.pages: list[Page] = []
        self.api = self.made(still=still)
        self.server = PageServer(self.api, port=0, token=TOKEN)

    def made(self, *, still: bool = True) -> FakeSessionApi:
        """A stage; still: no hand holds anything."""
        api = FakeSessionApi(self.kind, stands=self.stands)
        for slot in range(5) if still else ():
            api.do(MoveHand(slot=slot, mode="free"))
        return api

    def open(self, *, token: bool = True, script: str | None = None, **settings: Any) -> Page:
        """A page that drew something; a script runs in it before its own."""
        context = self.browser.new_context(**{"viewport": {"width": 900, "height": 600}, **settings})
        context.set_default_timeout(PATIENCE)
        context.add_init_script(BEFORE)
        context.add_init_script(POINTED)
        context.add_init_script(UNHURRIED)
        if script is not None:
            context.add_init_script(script)
        page = context.new_page()
        self.pages.append(page)
        page.on("console", lambda said: self.complaints.append(f"{said.type}: {said.text}"))
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))
        page.on("websocket", lambda socket: self.requests.append(socket.url))
        page.goto(self.server.url if token else self.server.address)
        page.wait_for_function(READY)
        return page

    def close(self) -> None:
        for page in self.pages:
            page.context.close()
        self.server.close()


@contextmanager
def shown(running: Browser, kind: Kind = "3d", *, still: bool = True, **stands: Any) -> Generator[Shown]:
    """Closed at the end; no page may have complained, or asked for anything from elsewhere.

    Args:
        running: the browser.
        kind: of body.
        still: no hand holds anything.
        **stands: what else the scene has, by name.
    """
    made = Shown(running, kind, still=still, **stands)
    try:
        yield made
        assert made.complaints == []
        assert {urlsplit(address).hostname for address in made.requests} == {"127.0.0.1"}
        assert {urlsplit(address).scheme for address in made.requests} == {"http", "ws"}
    finally:
        made.close()


def spot(page: Page, point: int | None = None) -> tuple[float, float, int]:
    """Where a point of the page's own copy is drawn [pixels], and which it is; waits for the first picture."""
    where = page.wait_for_function("point => window.cotouch.stage.spot(point ?? undefined)", arg=point)
    found = where.json_value()
    return found["x"], found["y"], found["point"]


def until(page: Page, condition: str, value: Any = None) -> None:
    """Waits until an expression of `store`, `stats` and a value is true in the page."""
    page.wait_for_function(
        f"value => {{ const {{ store, stats, connection, stage }} = window.cotouch; return {condition}; }}", arg=value
    )


def move(page: Page, x: float, y: float, steps: int = 1) -> None:
    """Moves the mouse there, and waits until the page knows that it is there."""
    page.mouse.move(x, y, steps=steps)
    until(page, "Math.hypot(window.pointed[0] - value[0], window.pointed[1] - value[1]) < 1", [x, y])


def heard(page: Page, api: FakeSessionApi) -> Pointer:
    """The newest that the page's hand has said, once it is with the server and the page was told so."""
    until(page, "connection.pending === null && store.frame.echo === connection.number")
    return api.pointers[-1][1]


def pictures_later(page: Page) -> None:
    """Waits until what was due with the browser's next picture has been done."""
    page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")


def wait(page: Page, condition: Callable[[], bool]) -> None:
    """Waits until the server's side is so; the page goes on meanwhile."""
    for _ in range(PATIENCE // 20):
        if condition():
            return
        page.wait_for_timeout(20)
    raise AssertionError("it did not come to that")
