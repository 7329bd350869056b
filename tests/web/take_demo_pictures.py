"""Photographs a running `cotouch demo` for the documents: `python -m tests.web.take_demo_pictures FOLDER`.

A few minutes on a machine with nothing else to do; on a busy one members miss steps, and no picture of that is kept.
"""

import re
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import psutil
from playwright.sync_api import Browser, Page
from tests.simulation.browser import UNHURRIED, browser
from tests.web.parties import Party, party
from tests.web.pictures import BEFORE, PATIENCE, READY, spot, until
from tests.web.shell_pages import choose
from tests.web.take_pictures import FINE, LIVE, taken

DESK = {"viewport": {"width": 1600, "height": 900}}
PHONE = {"viewport": {"width": 844, "height": 390}, "has_touch": True, "is_mobile": True, "device_scale_factor": 1.5}
# Each of five users hears the four others.
COUPLED = """Object.values(store.state.ends).length === 20 &&
    Object.values(store.state.ends).every((end) => end.state === 'coupled')"""
# What is looked at has come to where it is held, and plots have a past [ms].
SETTLED = 6_000
# The last pictures were drawn finely [ms].
DRAWN_FINELY = 1_500
# The most that any member missed, as a share of the steps that were due; and how much of it a picture may show.
MISSED = """() => Math.max(...Object.values(window.cotouch.store.state.members)
    .map(({ steps = 0, missed = 0 }) => missed / Math.max(steps + missed, 1)))"""
MOST_MISSED = 0.05


def main(folder: Path) -> None:
    """Takes one picture of each kind.

    Args:
        folder: an existing one.
    """
    with browser() as running:
        for process in psutil.Process().children(recursive=True):
            _yields(process)
        _demo(
            running,
            "soft",
            {"page-light.webp": _light, "page.png": _dark, "page-side.webp": _side, "page-cut.webp": _cut},
            folder,
        )
        _demo(running, "soft", {"page-phone.webp": _phone}, folder)
        _demo(running, "point", {"page-rails.webp": _light}, folder)


# All are linked, as in a demo without a file; and all step as often as with the soft body: five times 500 Hz are too
# much beside a browser.
POINTS = (Path(__file__).parents[2] / "examples" / "live.toml").read_text(encoding="utf-8")
OTHERWISE = ((r"^rate = 500\b", "rate = 250"), (r"^links = .*$", ""))


def _yields(process: psutil.Process) -> None:
    """Drawing without a graphics card must not make members late: they are of another session, whose share counts."""
    process.nice(10)
    group, own = (Path(f"/proc/{number}/autogroup") for number in (process.pid, "self"))
    if own.exists() and group.read_text() != own.read_text():
        group.write_text("19")


def _demo(running: Browser, body: str, pictures: dict[str, Callable[[Browser, str], Page]], folder: Path) -> None:
    with tempfile.TemporaryDirectory() as place, party(Path(place)) as made:
        address = _started(made, body, Path(place))
        for name, show in pictures.items():
            page = show(running, address)
            page.evaluate(FINE)
            page.wait_for_timeout(DRAWN_FINELY)
            page.wait_for_function(LIVE)
            missed = page.evaluate(MISSED)
            if missed > MOST_MISSED:
                raise SystemExit(f"{name} is not kept: members missed up to {100 * missed:.0f} % of their steps")
            taken(page, folder / name)
            page.mouse.up()
            page.context.close()


def _started(made: Party, body: str, place: Path) -> str:
    what = ["--body", body]
    if body == "point":
        text = POINTS
        for written, instead in OTHERWISE:
            text, count = re.subn(written, instead, text, flags=re.MULTILINE)
            assert count == 1, written
        (place / "points.toml").write_text(text, encoding="utf-8")
        what = [str(place / "points.toml"), "--law", "paid"]
    made.start("demo", "demo", *what, "--duration", "900", "--page", "--headless", "--port", "0")
    return made.await_line("demo", r"http://127\.0\.0\.1:\d+/#token=\S+")


def _opened(running: Browser, address: str, **settings: object) -> Page:
    context = running.new_context(**settings)  # pyright: ignore[reportArgumentType]  (settings of Playwright's own)
    context.set_default_timeout(PATIENCE)
    context.add_init_script(BEFORE)
    context.add_init_script(UNHURRIED)
    page = context.new_page()
    page.goto(address)
    page.wait_for_function(READY)
    until(page, COUPLED)
    return page


def _held(page: Page) -> Page:
    """Ann pulls the middle up; Ben and Dan wander."""
    for slot, mode in enumerate(("free", "wander", "free", "wander", "free")):
        page.evaluate("([slot, mode]) => window.cotouch.connection.do({ what: 'hand', slot, mode })", [slot, mode])
    page.wait_for_timeout(SETTLED / 2)
    page.click("text=Count from now")  # what scripted hands had put in before is out again
    x, y, _ = spot(page)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y - 190, steps=20)
    page.wait_for_timeout(SETTLED)
    return page


def _light(running: Browser, address: str) -> Page:
    return _held(_opened(running, address, **DESK, color_scheme="light"))


def _dark(running: Browser, address: str) -> Page:
    return _held(_opened(running, address, **DESK, color_scheme="dark"))


def _side(running: Browser, address: str) -> Page:
    page = _opened(running, address, **DESK, color_scheme="light")
    page.click("text=Side by side")
    return _held(page)


def _cut(running: Browser, address: str) -> Page:
    page = _opened(running, address, **DESK, color_scheme="light")
    for other in (0, 2, 3, 4):
        choose(page, min(1, other), max(1, other))
        page.click("#cut")
    page.keyboard.press("Escape")
    return _held(page)


def _phone(running: Browser, address: str) -> Page:
    page = _opened(running, address, **PHONE, color_scheme="light")
    for slot in range(5):
        page.evaluate("slot => window.cotouch.connection.do({ what: 'hand', slot, mode: 'wander' })", slot)
    page.wait_for_timeout(SETTLED)
    return page


if __name__ == "__main__":
    main(Path(sys.argv[1]))
