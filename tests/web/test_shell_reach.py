"""Whether everybody can use the page: by keys, by ear, on a phone, and led by the tour."""

from typing import Any

import pytest
from playwright.sync_api import Page
from tests.web.pictures import pictures_later, wait
from tests.web.shell_pages import LINK, PHONE, READY, World, choose, grab, let_go, looked, words
from tests.web.shell_scripts import CONTRAST, DOUBLED, MOVING, NAMELESS, PANELS, RIGHTMOST, SEEN, SMALL

from cotouch.observers import Cut, Kill, SetDamping


def test_keys_do_what_buttons_do(here: World) -> None:
    page = here.open()
    page.keyboard.press("Tab")
    assert page.evaluate("() => document.activeElement.className") == "skip"
    page.keyboard.press("?")
    page.wait_for_selector("dialog[open]")
    page.keyboard.press("s")
    page.uncheck("dialog[open] input")
    page.keyboard.press("Escape")
    assert page.evaluate("() => window.cotouch.store.settings.layout") == "overlay"
    page.keyboard.press("s")
    assert page.evaluate("() => window.cotouch.store.settings.layout") == "overlay"
    page.keyboard.press("?")
    page.check("dialog[open] input")
    page.keyboard.press("Escape")
    page.keyboard.press("s")
    page.keyboard.press("c")
    page.keyboard.press("b")
    assert page.evaluate("() => ({ ...window.cotouch.store.settings })") == {
        "layout": "side", "colour": "stress", "tool": "ball", "theme": "auto", "ghosts": True,
    }  # fmt: skip
    page.keyboard.press("d")
    page.keyboard.press("d")
    assert page.evaluate("() => document.documentElement.dataset.theme") == "dark"
    page.keyboard.press("2")
    assert page.evaluate("() => window.cotouch.store.slot") == 1
    page.wait_for_selector('.user[data-slot="1"] .chip-mine')
    page.focus("#tab-energy")
    page.keyboard.press("ArrowRight")
    assert page.evaluate("() => document.activeElement.id") == "tab-margin"
    assert page.is_visible("#margin")
    assert page.is_hidden("#energy")


def test_everything_that_can_be_pressed_has_a_name_and_events_are_said(here: World) -> None:
    page = here.open()
    page.click('.user[data-slot="0"] .user-head')
    nameless = page.evaluate(NAMELESS)
    assert nameless == []
    doubled = page.evaluate(DOUBLED)
    assert doubled == []
    here.api.do(Kill(slot=3))
    page.wait_for_function("() => /Dan was killed/.test(document.querySelector('#spoken').textContent)")
    page.click("#tab-events")
    words(page, "#events li", "Dan was killed")
    page.click("#network-title + .ask")
    words(page, "#network .explanation", "Who is linked to whom")


def test_nothing_is_wider_than_a_phone(here: World) -> None:
    page = here.open(**PHONE)
    for tab in ("users", "network", "plots", "energy", "margin", "events"):
        page.tap(f"#tab-{tab}")
        page.wait_for_selector(f"#{tab}")
        wide = page.evaluate(RIGHTMOST)
        assert max(wide) <= 390
        seen = page.evaluate(PANELS)
        assert seen == [tab]
        assert page.evaluate("() => document.querySelector('#stage').getBoundingClientRect().height") > 200
        small = page.evaluate(SMALL)
        assert small == []
    page.tap("#tab-network")
    page.tap(LINK.format(1, 3) + " .link-plate", force=True)
    page.wait_for_selector("#link")
    box = page.locator("#link").bounding_box()
    assert box is not None
    assert box["x"] == 0
    assert box["x"] + box["width"] == 390
    assert box["y"] + box["height"] == pytest.approx(844, abs=1)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_all_text_stands_out_from_its_ground(here: World, scheme: Any) -> None:
    page = here.open(color_scheme=scheme, reduced_motion="reduce")
    assert page.evaluate("() => document.documentElement.dataset.theme") == scheme
    found = page.evaluate(CONTRAST)
    assert len(found) > 30
    assert [(a, b, ratio) for a, b, ratio in found if ratio < 4.5] == []
    # Whoever asked for less motion gets none.
    moving = page.evaluate(MOVING)
    assert moving == 0


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_all_that_is_seen_stands_out_from_what_is_behind_it(here: World, scheme: Any) -> None:
    page = here.open(color_scheme=scheme, reduced_motion="reduce")
    here.api.do(Kill(slot=3))
    here.api.do(SetDamping(fraction=0.4))
    page.click('.user[data-slot="2"] .user-head')
    page.wait_for_selector('.user[data-slot="3"][data-presence="stopped"]')
    page.wait_for_selector("#banner-damping")
    faint: list[Any] = []
    for tab in ("energy", "margin", "events"):
        page.click(f"#tab-{tab}")
        found = page.evaluate(SEEN)
        assert len(found) > 60
        faint += [(what, round(ratio, 1)) for what, ratio in found if ratio < 4.5]
    assert faint == []


def done(page: Page) -> None:
    """Waits until the step of the tour says that it is done, and goes on."""
    page.wait_for_selector("#tour[data-done]")
    page.click("#tour-next")


def test_the_tour_invites_runs_through_and_is_taken_up_again(here: World) -> None:
    page = here.open(first=True)
    words(page, "#tour-offer", "two-minute tour")
    page.click("#tour-offer >> text=Start")
    assert page.evaluate("() => document.activeElement.id") == "tour"
    words(page, "#tour .tour-number", "Step 1 of 10")
    assert page.get_attribute("#tour", "data-done") is None
    grab(page, 0.08)
    done(page)
    words(page, "#tour h2", "Let go")
    looked(page)  # it has seen that something is held
    let_go(page)
    done(page)
    # Left and taken up again, by keys, also after a new visit.
    page.focus("#tour")
    page.keyboard.press("Escape")
    assert page.is_hidden("#tour")
    page.reload()
    page.wait_for_function(READY)
    assert page.is_hidden("#tour-offer")
    page.keyboard.press("t")
    words(page, "#tour .tour-number", "Step 3 of 10")
    # So it is where nobody said that he leaves.
    page.reload()
    page.wait_for_function(READY)
    page.keyboard.press("t")
    words(page, "#tour .tour-number", "Step 3 of 10")
    page.evaluate("() => window.cotouch.store.set({ layout: 'side' })")
    grab(page, 0.08)
    done(page)
    page.click('.user[data-slot="2"] .user-head')
    page.click('.user[data-slot="2"] >> text=Hold')
    done(page)
    let_go(page)
    choose(page, 1, 3)
    done(page)
    page.click("#cut")
    done(page)
    page.click("#cut")
    done(page)
    page.click("#topology >> text=Worst")
    page.wait_for_selector(LINK.format(0, 4))
    looked(page)
    page.click("#topology >> text=Best")
    done(page)
    assert page.is_visible("#energy")
    done(page)
    page.click("#lower")
    page.click("text=Lower it")
    page.wait_for_selector("#banner-damping")
    looked(page)
    page.click("#banner-damping >> text=Restore now")
    page.wait_for_selector("#tour[data-done]")
    words(page, "#tour-next", "Finish")
    page.keyboard.press("ArrowLeft")
    words(page, "#tour .tour-number", "Step 9 of 10")
    page.keyboard.press("ArrowRight")
    page.click("#tour-next")
    assert page.is_hidden("#tour")
    assert page.evaluate("() => JSON.parse(localStorage.getItem('cotouch.tour')).step") == 0
    assert here.did("damping") == [{"fraction": 0.05}, {"fraction": 1}]


def test_the_tour_never_blocks_and_fits_a_phone(here: World) -> None:
    page = here.open(first=True, **PHONE)
    page.tap("#tour-offer >> text=Start")
    for number in range(1, 11):
        words(page, "#tour .tour-number", f"Step {number} of 10")
        pictures_later(page)
        box = page.locator("#tour").bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        assert box["y"] >= 0
        assert box["y"] + box["height"] <= 844
        # What lies beside it can be reached.
        under = page.evaluate("() => document.elementFromPoint(195, 20)?.closest('.bar') !== null")
        assert under
        wait(page, lambda: hidden(page) < 0.05)  # the card moves, and is placed five times a second
        if number < 10:
            page.tap("#tour-next")
    page.tap("#tour-next")
    assert page.is_hidden("#tour")


def hidden(page: Page, what: str = ".tour-hole") -> float:
    """How much of something the tour's card lies over, as a share of it; by default of what the step is about."""
    return page.evaluate(
        """what => {
            const [card, one] = ['#tour', what].map((name) => document.querySelector(name).getBoundingClientRect());
            const common = (low, high) => Math.max(0, Math.min(card[high], one[high]) - Math.max(card[low], one[low]));
            return common('left', 'right') * common('top', 'bottom') / (one.width * one.height); }""",
        what,
    )


@pytest.mark.parametrize("size", [(1440, 900), (1024, 768)])
def test_the_tour_covers_nothing_that_it_speaks_of(here: World, size: tuple[int, int]) -> None:
    page = here.open(first=True, viewport={"width": size[0], "height": size[1]}, reduced_motion="reduce")
    page.click("#tour-offer >> text=Start")
    seen = {5: "#network", 6: "#link", 7: "#link", 8: "#stage", 9: "#stage", 10: "#stage"}
    for number in range(1, 11):
        words(page, "#tour .tour-number", f"Step {number} of 10")
        if number == 6:
            choose(page, 1, 3)
        looked(page)  # the card is placed then
        wait(page, lambda: hidden(page) < 0.02)
        assert hidden(page, "#verdict") == 0.0
        assert hidden(page, seen.get(number, ".tour-hole")) < 0.02, number
        if number in {6, 7}:
            assert hidden(page, "#network") < 0.02, number
        if number in {1, 2, 3}:  # what moves with a hand
            assert hidden(page, "#energy") + hidden(page, "#network") < 0.02, number
        if number < 10:
            page.click("#tour-next")


def test_a_step_of_the_tour_is_done_only_by_doing_it(here: World) -> None:
    page = here.open()
    page.evaluate("localStorage.setItem('cotouch.tour', JSON.stringify({step: 6, over: false}))")
    page.keyboard.press("t")
    words(page, "#tour h2", "Reconnect it")
    words(page, "#tour .tour-task", "No link is cut")
    looked(page)
    assert page.get_attribute("#tour", "data-done") is None
    here.api.do(Cut(a=1, b=3, on=True))
    words(page, "#tour .tour-task", "Press Reconnect")
    looked(page)
    assert page.get_attribute("#tour", "data-done") is None
    here.api.do(Cut(a=1, b=3, on=False))
    page.wait_for_selector("#tour[data-done]")
