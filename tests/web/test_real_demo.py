"""The page of a real session in a real browser: `cotouch demo`, its processes, its page, and a hand on it."""

import re
import signal
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from playwright.sync_api import Page
from tests.simulation.browser import UNHURRIED, browser
from tests.web.pictures import BEFORE, spot, until
from tests.web.shell_pages import choose, words

USERS = 3
# Longer than a session takes to begin where other work leaves it a third of a core; nothing waits longer than it must.
PATIENCE = 300_000
# The last copy comes to about 9 mm once all links are coupled, and to 6 mm or less where a busy machine keeps links
# guarded.
MOVED = 0.0035

# How far the held point of each copy is from where it was.
WATCH = """(point) => {
  const at = (copy, scale) => [0, 1, 2].map((axis) => scale * copy.displacement[3 * point + axis]);
  const from = {}, now = {};
  window.watched = { now };
  window.cotouch.store.on('frame', () => {
    const { copies, scale } = window.cotouch.store.frame;
    for (const copy of copies) {
      const place = at(copy, scale);
      from[copy.slot] ??= place;
      now[copy.slot] = Math.hypot(...place.map((value, axis) => value - from[copy.slot][axis]));
    }
  });
}"""
# All copies have followed, and the one that is held is the furthest out: the others are drawn by it. Which one moved
# first cannot be told where pictures, and ages of what they show, are as coarse as the links' delays.
DRAWN_ALONG = """(([held, ...others]) => others.every((far) => far > value && far < held))(
    Object.values(window.watched.now))"""

# Everybody takes part and hears the neighbours; on a busy machine links are coupled much later, or guarded for long.
JOINED = """Object.values(store.state.members).every((one) => one.here && one.steps > 0) &&
    Object.values(store.state.ends).length === 6 &&
    Object.values(store.state.ends).every((end) => ['guarded', 'ready', 'coupled'].includes(end.state))"""
# Nothing of any copy is far from its rest [m].
REST = "store.frame.copies.every((copy) => copy.displacement.every((d) => Math.abs(d) * store.frame.scale < 0.002))"
# What is left of what came in, as the page says it; of what members say, themselves.
LEFT = "() => Number(document.querySelector('#energy .expected').dataset.left)"
OFF = """() => Object.values(window.cotouch.store.state.members).filter((one) => one.steps).map((one) =>
    one.initial + one.supplied + one.linked + one.rescaled - one.lost - one.energy)"""


@contextmanager
def demo(log: Path) -> Generator[str]:
    """A demonstration of real processes; its page's address. Ended at the end."""
    command = [sys.executable, "-m", "cotouch", "demo", "--users", str(USERS), "--body", "soft", "--duration", "900"]
    with log.open("wb") as said:
        running = subprocess.Popen([*command, "--page", "--headless", "--port", "0"], stdout=said, stderr=said)
    try:
        for _ in range(PATIENCE // 100):
            found = re.search(r"http://127\.0\.0\.1:\d+/#token=\S+", log.read_text(encoding="utf-8"))
            if found or running.poll() is not None:
                break
            try:
                running.wait(0.1)
            except subprocess.TimeoutExpired:
                continue
        assert found, log.read_text(encoding="utf-8")
        yield found[0]
    finally:
        running.send_signal(signal.SIGINT)
        try:
            running.wait(30)
        except subprocess.TimeoutExpired:
            running.kill()
            running.wait()
        print(log.read_text(encoding="utf-8", errors="replace"))  # shown where the test fails


def opened(context: Any, address: str, said: list[str], asked: list[str]) -> Page:
    """A page, with all that it asks for and complains about."""
    page = context.new_page()
    page.on("console", lambda one: said.append(f"{one.type}: {one.text}"))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    page.on("websocket", lambda socket: asked.append(socket.url))
    page.goto(address)
    page.wait_for_function("() => window.cotouch?.store.state && window.cotouch.stats.frames > 1")
    return page


def drag(page: Page) -> None:
    """The copy that is held is drawn out, and draws the others along."""
    x, y, point = spot(page)
    page.evaluate(WATCH, point)
    page.wait_for_function("count => Object.keys(window.watched.now).length === count", arg=USERS)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y - 190, steps=6)
    until(page, "store.frame.copies.find((copy) => copy.slot === 0).mode === 'grab'")
    until(page, DRAWN_ALONG, MOVED)
    until(page, "stats.dragToMesh.length > 0")


def test_a_session_is_held_cut_killed_and_watched_from_a_page(tmp_path: Path) -> None:
    said: list[str] = []
    asked: list[str] = []
    with demo(tmp_path / "said") as address, browser() as running:
        context = running.new_context(viewport={"width": 1024, "height": 600})
        context.set_default_timeout(PATIENCE)
        context.add_init_script(BEFORE)
        context.add_init_script(UNHURRIED)
        page = opened(context, address, said, asked)
        until(page, JOINED)
        for slot in range(USERS):
            page.evaluate("slot => window.cotouch.connection.do({ what: 'hand', slot, mode: 'free' })", slot)
        until(page, REST)
        drag(page)

        # A page beside it, without the token, sees the same.
        second = opened(context, address.split("#")[0], said, asked)
        until(second, "store.frame.copies.find((copy) => copy.slot === 0).mode === 'grab' && !connection.mayAct")
        page.bring_to_front()
        page.mouse.up()
        until(page, "store.frame.copies.find((copy) => copy.slot === 0).mode === 'free'")
        until(page, "Object.values(window.watched.now).every((far) => far < value)", MOVED)

        choose(page, 0, 1)
        page.click("#cut")
        page.wait_for_selector('.link[data-link="0-1"][data-condition="cut"]')
        until(page, "['0-1', '1-0'].every((end) => store.state.ends[end].state === 'waiting')")
        words(page, "#verdict", "nothing, network slow")
        page.click("#cut")
        page.wait_for_selector('.link[data-link="0-1"]:not([data-condition="cut"])')
        page.keyboard.press("Escape")

        page.click('.user[data-slot="2"] .user-head')
        page.click('.user[data-slot="2"] >> text=Stop process')
        page.wait_for_selector('.user[data-slot="2"]:not([data-presence="here"])')
        until(page, "!store.state.members[2].here")
        page.click('.user[data-slot="2"] >> text=Restart process')
        page.wait_for_selector('.user[data-slot="2"][data-presence="here"]')
        until(page, JOINED)

        # Members came and went, and still every joule is somewhere.
        assert max(map(abs, page.evaluate(OFF))) < 1e-9
        page.click("#tab-energy")
        until(page, "Object.values(store.state.members).some((one) => one.rescaled)")
        page.wait_for_function(f"() => ({LEFT})() <= 1e-9 && ({LEFT})() >= 0")
        context.close()
    assert [one for one in said if not one.startswith("log")] == []
    assert {urlsplit(one).hostname for one in asked} == {"127.0.0.1"}
    assert any(urlsplit(one).scheme == "ws" for one in asked)
