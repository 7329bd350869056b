"""Pages of a made-up session, opened in a real browser, with all that they complain about."""

from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

from playwright.sync_api import Browser, Page
from tests.simulation.browser import UNHURRIED
from tests.web.fake_session_api import FakeSessionApi, Kind

from cotouch.web import PageServer

# Nothing waits longer than it must [ms].
PATIENCE = 60_000
READY = "() => window.cotouch?.store.state && window.cotouch.store.frame && document.querySelector('.user')"
PHONE = {"viewport": {"width": 390, "height": 844}, "has_touch": True, "is_mobile": True}
LINK = '.link[data-link="{}-{}"]'
# Counts the looks of the tour.
LOOKS = """window.looks = 0;
window.setInterval = ((every) => (look, period, ...more) => every(
  period === 200 ? () => { look(); window.looks++; } : look, period, ...more))(window.setInterval.bind(window));
"""
# Whoever was here before is not invited to the tour again.
BEFORE = 'localStorage.setItem("cotouch.tour", localStorage.getItem("cotouch.tour") ?? JSON.stringify({over: true}))'


class World:
    """A stage, its server and the pages that look at it."""

    def __init__(self, running: Browser, kind: Kind = "1d", *, port: int = 0) -> None:
        self.browser = running
        self.api = FakeSessionApi(kind)
        self.server = PageServer(self.api, port=port)
        self.complaints: list[str] = []
        self.pages: list[Page] = []

    def open(self, address: str | None = None, *, first: bool = False, **settings: Any) -> Page:
        """A page that is ready.

        Args:
            address: else the server's, with the token.
            first: whether nobody was here before.
            settings: of the browser's context.
        """
        context = self.browser.new_context(**{"viewport": {"width": 1280, "height": 720}, **settings})
        context.set_default_timeout(PATIENCE)
        if not first:
            context.add_init_script(BEFORE)
        context.add_init_script(LOOKS)
        context.add_init_script(UNHURRIED)
        page = context.new_page()
        self.pages.append(page)
        page.on("console", lambda said: self.complaints.append(f"{said.type}: {said.text}"))
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.goto(address or self.server.url)
        page.wait_for_function(READY)
        return page

    def did(self, what: str) -> list[dict[str, Any]]:
        """What the stage was asked for."""
        return [
            one.model_dump(mode="json", exclude={"what"}, exclude_unset=True)
            for one in self.api.done
            if one.what == what
        ]

    def close(self) -> None:
        """Closes all."""
        for page in self.pages:
            page.context.close()
        self.server.close()


@contextmanager
def world(running: Browser, kind: Kind = "1d") -> Generator[World]:
    """A world that is closed at the end; no page of it may have complained."""
    made = World(running, kind)
    try:
        yield made
        if made.complaints:
            raise AssertionError(made.complaints)
    finally:
        made.close()


def grab(page: Page, offset: float) -> None:
    """Holds the first point of the object so far from its rest, as the picture would."""
    page.evaluate(
        """offset => {
            const { store, connection } = window.cotouch;
            const rest = store.scene.points;
            connection.point({ action: 'grab', point: 0, target: [rest[0] + offset, rest[1], rest[2]],
                radius: 0, stiffness: 0 });
        }""",
        offset,
    )


def looked(page: Page) -> None:
    """Waits until the tour has looked at how things are now; it looks five times a second."""
    page.wait_for_function("looks => window.looks > looks", arg=page.evaluate("() => window.looks"))


def let_go(page: Page) -> None:
    """Lets go of it."""
    page.evaluate(
        """() => window.cotouch.connection.point(
            { action: 'free', point: 0, target: [0, 0, 0], radius: 0, stiffness: 0 })"""
    )


def words(page: Page, selector: str, pattern: str) -> None:
    """Waits until something that is seen says so."""
    page.wait_for_function(
        """([selector, pattern]) => [...document.querySelectorAll(selector)].some(
            (one) => one.getClientRects().length && new RegExp(pattern, 'u').test(one.textContent))""",
        arg=[selector, pattern],
    )


def choose(page: Page, a: int, b: int) -> None:
    """Opens the card of a link, as the keyboard does."""
    page.focus(LINK.format(a, b))
    page.keyboard.press("Enter")
    page.wait_for_selector("#link")
