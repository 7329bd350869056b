"""Everything around the picture, in a real browser."""

import io
import re
import zipfile
from collections.abc import Generator
from dataclasses import replace
from typing import Any

import pytest
from playwright.sync_api import Browser, Page
from tests.simulation.browser import FLAT, browser
from tests.web.shell_pages import PHONE, READY, World, grab, let_go, words, world

from cotouch.web import PageServer

LINK = '.link[data-link="{}-{}"]'


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser(FLAT) as one:
        yield one


@pytest.fixture
def here(running: Browser) -> Generator[World]:
    with world(running) as made:
        yield made


def choose(page: Page, a: int, b: int) -> None:
    """Opens the card of a link, as the keyboard does."""
    page.focus(LINK.format(a, b))
    page.keyboard.press("Enter")
    page.wait_for_selector("#link")


def test_cutting_a_link_shows_in_the_graph_the_card_and_the_verdict(here: World) -> None:
    page = here.open()
    assert page.get_attribute("#verdict", "data-level") == "good"
    choose(page, 1, 3)
    page.click("#cut")
    page.wait_for_selector(LINK.format(1, 3) + '[data-condition="cut"]')
    words(page, LINK.format(1, 3) + " .link-words", "✕ cut")
    words(page, "#verdict", "take note: Passive: link 2–4")
    assert here.did("cut") == [{"a": 1, "b": 3, "on": True}]
    assert page.get_attribute(LINK.format(0, 1), "data-condition") == "coupled"
    page.click("#cut")
    page.wait_for_selector(LINK.format(1, 3) + '[data-condition="coupled"]')
    words(page, "#verdict", "to spare")


def test_a_link_is_disturbed_by_sliders_by_drawing_and_by_keys(here: World) -> None:
    page = here.open()
    choose(page, 1, 3)
    page.evaluate(
        """() => { const one = document.querySelector('#link input[aria-label="loss"]');
             one.value = '0.25'; one.dispatchEvent(new Event('input', { bubbles: true })); }"""
    )
    page.wait_for_function("() => window.cotouch.store.state.emulated['1-3'].loss === 0.25")
    words(page, "#link output", "^25\u202f%$")
    page.keyboard.press("Escape")
    before = page.evaluate("() => window.cotouch.store.state.emulated['1-3'].delay")
    page.focus(LINK.format(1, 3))
    page.keyboard.press("+")
    page.wait_for_function("before => window.cotouch.store.state.emulated['1-3'].delay > before", arg=before)
    box = page.locator(LINK.format(1, 3) + " .link-plate").bounding_box()
    assert box is not None
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y, steps=6)
    words(page, LINK.format(1, 3) + " .link-words", r"^\+1\d\d\u202fms each way$")
    page.mouse.up()
    page.wait_for_function("() => window.cotouch.store.state.emulated['1-3'].delay > 0.1")
    # Drawing is not choosing.
    assert page.is_hidden("#link")
    assert all(set(one) == {"a", "b", "loss"} or set(one) == {"a", "b", "delay"} for one in here.did("impair"))


def test_a_second_page_follows_is_told_and_can_take_over(here: World) -> None:
    first = here.open()
    grab(first, 0.05)
    words(first, '.user[data-seat="0"] .hand-mode', "pointer grabs")
    second = here.open()
    words(second, '.user[data-seat="0"] .hand-mode', "pointer grabs")
    second.wait_for_selector("#banner-control")
    words(second, "#banner-control", "Another page holds the control of Ann")
    assert first.is_hidden("#banner-control")
    second.click("#banner-control >> text=Take over")
    second.wait_for_selector("#banner-control", state="hidden")
    first.wait_for_selector("#banner-control")
    # Another user's hand is another page's.
    second.keyboard.press("3")
    first.wait_for_selector("#banner-control", state="hidden")
    assert "user=3" in second.url
    assert "#token=" in second.url


def test_a_scripted_hand_can_be_told(here: World) -> None:
    page = here.open()
    page.click('.user[data-seat="2"] .user-head')
    card = page.locator('.user[data-seat="2"]')
    for order, mode in (("Hold", "hold"), ("Let go", "free"), ("Script", "script"), ("Wander", "wander")):
        card.get_by_role("radio", name=order).click()
        page.wait_for_function("mode => window.cotouch.store.state.members[2].hand === mode", arg=mode)
        assert card.get_by_role("radio", name=order).get_attribute("aria-checked") == "true"
    card.get_by_role("radio", name="Pull").click()
    words(page, "#banner-aim", "where Cleo shall pull")
    assert card.get_by_role("button", name="Pull forward").is_visible()
    # In one dimension there are two directions.
    assert card.locator(".directions button").count() == 2
    card.get_by_role("button", name="Pull forward").click()
    page.wait_for_function("() => window.cotouch.store.state.members[2].hand === 'pull'")
    order = here.did("hand")[-1]
    assert order["seat"] == 2
    assert order["node"] == 0
    assert order["to"][0] >= 0.1
    assert page.is_hidden("#banner-aim")


def test_a_user_is_stopped_and_brought_back(here: World) -> None:
    page = here.open()
    page.click('.user[data-seat="4"] .user-head')
    page.click('.user[data-seat="4"] >> text=Stop process')
    page.wait_for_selector('.user[data-seat="4"][data-presence="stopped"]')
    words(page, "#users .panel-note", "4 of 5 here")
    page.wait_for_selector('.node[data-seat="4"]:not([data-presence="here"])')
    assert page.locator(LINK.format(3, 4)).count() == 0
    page.click('.user[data-seat="4"] >> text=Bring back')
    page.wait_for_selector('.user[data-seat="4"][data-presence="here"]')
    page.wait_for_selector(LINK.format(3, 4))


def test_links_are_switched_and_drawn(here: World) -> None:
    page = here.open()
    page.click("#topology >> text=Worst")
    page.wait_for_selector(LINK.format(0, 4))
    words(page, "#topology .means", "fade slowest")
    words(page, "#topology .expected", r"mean way there and back .*s\. The busiest user needs about \d")
    page.click("#topology >> text=Best")
    page.wait_for_selector(LINK.format(3, 4))
    page.click("#topology >> text=Yours")
    page.wait_for_selector('.pair[data-link="3-4"][aria-checked="true"]')
    apply = page.get_by_role("button", name="Apply")
    page.focus('.pair[data-link="3-4"]')
    page.keyboard.press("Enter")
    words(page, "#topology .problem", "No way leads to Eve")
    assert apply.is_disabled()
    page.focus('.pair[data-link="0-4"]')
    page.keyboard.press("Space")
    page.wait_for_selector("#topology .problem", state="hidden")
    apply.click()
    page.wait_for_selector(LINK.format(0, 4))
    asked = here.did("links")[-1]["links"]
    assert [0, 4] in asked
    assert [3, 4] not in asked
    assert page.locator(".pair").count() == 0


def test_plots_draw_and_hold_no_growing_memory(here: World) -> None:
    page = here.open()
    drawn = """() => [...document.querySelectorAll('#plots canvas')].map((one) => {
        const copy = new OffscreenCanvas(one.width, one.height).getContext('2d', { willReadFrequently: true });
        copy.drawImage(one, 0, 0);
        const pixels = copy.getImageData(0, 0, one.width, one.height).data;
        const colours = new Set();
        for (let i = 0; i < pixels.length; i += 4) if (pixels[i + 3] > 200) colours.add(`${pixels[i] >> 5} ${pixels[i + 1] >> 5} ${pixels[i + 2] >> 5}`);
        return colours.size; })"""
    page.wait_for_function(f"() => ({drawn})().length === 3 && ({drawn})().every((n) => n > 6)")
    words(page, "#plots .chart:nth-child(2) .reading", r"^\d")
    # Frames as they would come in five minutes, between drawings.
    feed = """async (bursts) => {
        const { store } = window.cotouch;
        let last = store.frame;
        for (let burst = 0; burst < bursts; burst++) {
            for (let i = 0; i < 300; i++) {
                last = { ...last, time: last.time + 1 / 60, number: last.number + 1, received: performance.now() };
                store.drawn(last);
            }
            await new Promise((done) => setTimeout(done, 60));
        }
        return store.history.count; }"""
    session = page.context.new_cdp_session(page)

    def heap() -> float:
        session.send("HeapProfiler.collectGarbage")
        return session.send("Runtime.getHeapUsage")["usedSize"]

    assert page.evaluate(feed, 20) <= 1300
    before = heap()
    page.evaluate(feed, 40)
    # Whoever kept only a frame's objects would hold ten times as much.
    assert heap() - before < 2_000_000
    assert page.locator("#plots canvas").count() == 3


def test_frozen_plots_stand_still_and_are_saved(here: World) -> None:
    page = here.open()
    page.wait_for_function("() => window.cotouch.store.history.count > 20")
    page.keyboard.press("f")
    assert page.get_attribute("#freeze", "aria-pressed") == "true"
    with page.expect_download() as saved:
        page.click("#plots >> text=CSV")
    lines = saved.value.path().read_text().splitlines()
    heads = lines[0].split(",")
    assert heads[:2] == ["time_s", "position_m 1 Ann"]
    assert len(heads) == 1 + 3 * 5
    assert all(len(line.split(",")) == len(heads) for line in lines)
    shown = page.evaluate("() => document.querySelector('#plots .reading').textContent")
    page.wait_for_function("count => window.cotouch.store.frame.number > count + 10", arg=len(lines))
    assert page.evaluate("() => document.querySelector('#plots .reading').textContent") == shown
    with page.expect_download() as saved:
        page.click("#plots >> text=CSV")
    assert saved.value.path().read_text().splitlines() == lines
    with page.expect_download() as saved:
        page.click("#plots >> text=PNG")
    assert saved.value.path().read_bytes().startswith(b"\x89PNG")
    page.keyboard.press("f")
    words(page, "#freeze", "Freeze")


def joules(words_: str) -> float:
    """A number with its prefix."""
    match = re.fullmatch(r"(−?[\d.]+)\u202f([kmµnp]?)J", words_.strip())
    assert match, words_
    scale = {"": 1.0, "k": 1e3, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "p": 1e-12}[match[2]]
    return float(match[1].replace("−", "-")) * scale


def test_every_joule_is_somewhere(here: World) -> None:
    page = here.open()
    page.wait_for_function(
        "() => Object.values(window.cotouch.store.state.members).reduce((a, b) => a + (b.supplied ?? 0), 0) > 0.01"
    )
    rows = page.evaluate(
        """() => [...document.querySelectorAll('#energy tbody tr, #energy tfoot tr')].map(
            (row) => [...row.querySelectorAll('td')].map((cell) => cell.textContent))"""
    )
    assert len(rows) == 6
    for row in rows:
        hands, links, start, damped, stored, left = map(joules, row)
        assert hands + links + start - damped - stored == pytest.approx(left, abs=0.01 * abs(hands))
        assert abs(left) < 1e-9
    sums = page.evaluate("() => [...document.querySelectorAll('#energy .sum')].map((one) => one.textContent)")
    assert joules(sums[0]) == pytest.approx(joules(sums[1]), rel=1e-6)
    assert joules(sums[0]) > 0.01
    # The bars are filled.
    filled = page.evaluate(
        """() => [...document.querySelectorAll('.stack')].map((bar) => bar.lastElementChild.getBoundingClientRect().right
             / bar.getBoundingClientRect().right)"""
    )
    assert all(0.99 < share < 1.01 for share in filled)
    page.click("#energy >> text=Count from now")
    page.wait_for_function(
        "() => parseFloat(document.querySelector('#energy tfoot td').textContent) !== 0 || true"
        " && document.querySelector('#energy table').hasAttribute('data-initial')"
    )


def test_damping_is_lowered_behind_a_warning_and_restored_with_one_click(here: World) -> None:
    other = here.open(here.server.address)
    page = here.open()
    page.click("#tab-margin")
    page.click("#lower")
    dialog = page.get_by_role("dialog", name="Lower the damping")
    assert "nothing keeps energy from growing" in (dialog.text_content() or "")
    # What is safe has the focus.
    assert page.evaluate("() => document.activeElement.textContent") == "Leave it as it is"
    page.keyboard.press("Enter")
    assert here.did("damping") == []
    page.click("#lower")
    dialog.get_by_role("button", name="Lower it").click()
    words(page, "#banner-damping", "lowered to 20\u202f%")
    words(page, "#verdict", "not guaranteed: Not passive")
    words(other, "#banner-damping", "lowered to 20\u202f%")
    page.click("#banner-damping >> text=Restore now")
    page.wait_for_selector("#banner-damping", state="hidden")
    assert here.did("damping") == [{"share": 0.2}, {"share": 1}]


def test_a_recording_is_made_and_downloaded(here: World) -> None:
    page = here.open()
    assert page.is_hidden("#download")
    page.click("#record")
    words(page, "#record", r"^0:0\d$")
    page.keyboard.press("r")
    page.wait_for_selector("#download")
    with page.expect_download() as saved:
        page.click("#download")
    with zipfile.ZipFile(io.BytesIO(saved.value.path().read_bytes())) as archive:
        assert len(archive.namelist()) == 5


def test_an_invitation_is_shown_and_a_place_freed(here: World) -> None:
    page = here.open()
    page.click("#invite")
    page.wait_for_function("() => { const code = document.querySelector('.qr'); return code.complete && code.naturalWidth > 0; }")
    command = page.get_by_label("Command")
    assert command.input_value() == f"cotouch join {here.stage.scene.invitation} --name Eve"
    page.click("text=Free this place")
    words(page, "dialog", "The place of Eve is free")
    assert here.did("kill") == [{"seat": 4}]
    page.keyboard.press("Escape")
    assert page.evaluate("() => document.activeElement.id") == "invite"


def test_without_the_token_one_watches(here: World) -> None:
    page = here.open(here.server.address)
    words(page, "#banner-view", "You are watching")
    assert page.is_hidden("#invite")
    assert page.is_disabled("#record")
    page.click('.user[data-seat="1"] .user-head')
    for name in ("Stop process",):
        assert page.get_by_role("button", name=name).first.is_disabled()
    assert page.locator('.user[data-seat="1"]').get_by_role("radio", name="Hold").is_disabled()
    choose(page, 1, 3)
    assert page.is_disabled("#cut")
    page.keyboard.press("r")
    grab(page, 0.05)
    assert here.stage.done == []
    assert here.stage.pointers == []


def test_a_restart_is_shown_and_the_end_too(running: Browser) -> None:
    made = World(running)
    again: PageServer | None = None
    try:
        page = made.open()
        page.wait_for_function("() => window.cotouch.store.history.count > 5")
        before = page.evaluate("() => window.cotouch.store.scene.started")
        port, token = made.server.port, made.server.token
        made.server.close()
        words(page, "#banner-lost", "connection is lost")
        words(page, "#verdict", "Connection lost")
        assert page.is_disabled("#record")
        again = PageServer(made.stage, port=port, token=token)
        page.wait_for_selector("#banner-lost", state="hidden")
        page.wait_for_function("before => window.cotouch.store.scene.started !== before", arg=before)
        page.wait_for_function(READY)
        words(page, "#verdict", "to spare")
        overview = made.stage.overview
        made.stage.overview = lambda: replace(overview(), ended=True)  # type: ignore[method-assign]
        words(page, "#banner-ended", "The session has ended")
        # While nobody listens, the browser says so itself; nothing else was said.
        assert [said for said in made.complaints if "ERR_CONNECTION_REFUSED" not in said] == []
    finally:
        if again is not None:
            again.close()
        made.close()


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
    assert page.evaluate("() => window.cotouch.store.seat") == 1
    page.wait_for_selector('.user[data-seat="1"] .chip-mine')
    page.focus("#tab-energy")
    page.keyboard.press("ArrowRight")
    assert page.evaluate("() => document.activeElement.id") == "tab-margin"
    assert page.is_visible("#margin")
    assert page.is_hidden("#energy")


def test_everything_that_can_be_pressed_has_a_name_and_events_are_said(here: World) -> None:
    page = here.open()
    page.click('.user[data-seat="0"] .user-head')
    nameless = page.evaluate(
        """() => [...document.querySelectorAll('button, a, input, select, textarea, [role=button], [role=checkbox], [role=img]')]
            .filter((one) => !(one.getAttribute('aria-label') || one.textContent.trim() || one.closest('label')))
            .map((one) => one.outerHTML.slice(0, 120))"""
    )
    assert nameless == []
    doubled = page.evaluate(
        "() => { const all = [...document.querySelectorAll('[id]')].map((one) => one.id); return all.filter((id, i) => all.indexOf(id) !== i); }"
    )
    assert doubled == []
    here.stage.do("kill", {"seat": 3})
    page.wait_for_function("() => /Dan was killed/.test(document.querySelector('#spoken').textContent)")
    page.click("#tab-events")
    words(page, "#events li", "Dan was killed")
    page.click("#energy-title + .ask", force=True, timeout=1000) if page.is_visible("#energy-title") else None
    page.click("#network-title + .ask")
    words(page, "#network .explanation", "Who is joined to whom")


def test_nothing_is_wider_than_a_phone(here: World) -> None:
    page = here.open(**PHONE)
    for tab in ("users", "network", "plots", "energy", "margin", "events"):
        page.tap(f"#tab-{tab}")
        page.wait_for_selector(f"#{tab}")
        wide = page.evaluate(
            """() => [document.documentElement.scrollWidth, ...[...document.querySelectorAll('.layout > *, .panel-body, .tabs')]
                .filter((one) => one.getClientRects().length).map((one) => Math.ceil(one.getBoundingClientRect().right))]"""
        )
        assert max(wide) <= 390
        seen = page.evaluate(
            "() => [...document.querySelectorAll('.layout > .panel')].filter((one) => one.getClientRects().length).map((one) => one.id)"
        )
        assert seen == [tab]
        assert page.evaluate("() => document.querySelector('#stage').getBoundingClientRect().height") > 200
        small = page.evaluate(
            """() => [...document.querySelectorAll('button, select, a.button, input')].filter((one) => {
                const { width, height } = one.getBoundingClientRect();
                return width && (width < 24 || height < 22) && !one.closest('table, .skip') && !one.classList.contains('skip'); }).map((one) => one.outerHTML.slice(0, 90))"""
        )
        assert small == []
    page.tap("#tab-network")
    page.tap(LINK.format(1, 3) + " .link-plate", force=True)
    page.wait_for_selector("#link")
    box = page.locator("#link").bounding_box()
    assert box is not None
    assert box["x"] == 0
    assert box["x"] + box["width"] == 390
    assert box["y"] + box["height"] == pytest.approx(844, abs=1)


CONTRAST = """() => {
    const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    const probe = document.body.appendChild(document.createElement('span'));
    const channels = (colour) => {
        probe.style.color = ''; probe.style.color = colour;
        canvas.fillStyle = getComputedStyle(probe).color; canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3).map((value) => value / 255);
    };
    const light = (colour) => channels(colour)
        .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4))
        .reduce((sum, value, i) => sum + value * [0.2126, 0.7152, 0.0722][i], 0);
    const contrast = (a, b) => { const [x, y] = [light(a), light(b)].sort((p, q) => q - p); return (x + 0.05) / (y + 0.05); };
    const pairs = [];
    for (const ground of ['panel', 'paper', 'sunk', 'accent-tint']) pairs.push(['var(--ink)', `var(--${ground})`]);
    for (const ground of ['panel', 'paper', 'sunk']) pairs.push(['var(--muted)', `var(--${ground})`]);
    for (const tone of ['good', 'warn', 'bad', 'accent']) pairs.push([`var(--${tone})`, 'var(--panel)'], [`var(--${tone})`, `var(--${tone}-tint)`]);
    pairs.push(['var(--on-accent)', 'var(--accent)'], ['var(--on-bad)', 'var(--bad)'], ['var(--panel)', 'var(--ink)']);
    for (let seat = 0; seat < 8; seat++) {
        pairs.push([`var(--on-user-${seat})`, `var(--user-${seat})`]);
        pairs.push([`color-mix(in oklab, var(--user-${seat}) 45%, var(--ink))`, 'var(--panel)']);
    }
    const found = pairs.map(([a, b]) => [a, b, contrast(a, b)]);
    probe.remove();
    return found; }"""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_all_text_stands_out_from_its_ground(here: World, scheme: Any) -> None:
    page = here.open(color_scheme=scheme, reduced_motion="reduce")
    assert page.evaluate("() => document.documentElement.dataset.theme") == scheme
    found = page.evaluate(CONTRAST)
    assert len(found) > 30
    assert [(a, b, ratio) for a, b, ratio in found if ratio < 4.5] == []
    # Whoever asked for less motion gets none.
    moving = page.evaluate(
        "() => [...document.querySelectorAll('*')].filter((one) => parseFloat(getComputedStyle(one).transitionDuration) > 0).length"
    )
    assert moving == 0


def done(page: Page) -> None:
    """Waits until the step of the tour says that it is done, and goes on."""
    page.wait_for_selector("#tour[data-done]")
    page.click("#tour-next")


def test_the_tour_invites_runs_through_and_is_taken_up_again(here: World) -> None:
    page = here.open(first=True)
    words(page, "#tour-offer", "Two minutes")
    page.click("#tour-offer >> text=Start")
    assert page.evaluate("() => document.activeElement.id") == "tour"
    words(page, "#tour .tour-number", "Step 1 of 10")
    assert page.get_attribute("#tour", "data-done") is None
    grab(page, 0.08)
    done(page)
    words(page, "#tour h2", "Let go")
    page.wait_for_timeout(500)  # the tour looks five times a second: it has seen that something is held
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
    page.evaluate("() => window.cotouch.store.set({ layout: 'side' })")
    grab(page, 0.08)
    done(page)
    page.click('.user[data-seat="2"] .user-head')
    page.click('.user[data-seat="2"] >> text=Hold')
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
    page.wait_for_timeout(500)
    page.click("#topology >> text=Best")
    done(page)
    assert page.is_visible("#energy")
    done(page)
    page.click("#lower")
    page.click("text=Lower it")
    page.wait_for_selector("#banner-damping")
    page.wait_for_timeout(500)
    page.click("#banner-damping >> text=Restore now")
    page.wait_for_selector("#tour[data-done]")
    words(page, "#tour-next", "Finish")
    page.keyboard.press("ArrowLeft")
    words(page, "#tour .tour-number", "Step 9 of 10")
    page.keyboard.press("ArrowRight")
    page.click("#tour-next")
    assert page.is_hidden("#tour")
    assert page.evaluate("() => JSON.parse(localStorage.getItem('cotouch.tour')).step") == 0
    assert here.did("damping") == [{"share": 0.2}, {"share": 1}]


def test_the_tour_never_blocks_and_fits_a_phone(here: World) -> None:
    page = here.open(first=True, **PHONE)
    page.tap("#tour-offer >> text=Start")
    for number in range(1, 11):
        words(page, "#tour .tour-number", f"Step {number} of 10")
        page.wait_for_timeout(60)
        box = page.locator("#tour").bounding_box()
        assert box is not None
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        assert box["y"] >= 0
        assert box["y"] + box["height"] <= 844
        # What lies under the veil can be reached.
        under = page.evaluate("() => document.elementFromPoint(195, 20)?.closest('.bar') !== null")
        assert under
        if number < 10:
            page.tap("#tour-next")
    page.tap("#tour-next")
    assert page.is_hidden("#tour")
