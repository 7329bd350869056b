"""Users, links and pages of a session, as the page shows them and as it can change them."""

from dataclasses import replace

import pytest
from playwright.sync_api import Browser
from tests.web.shell_pages import LINK, READY, World, choose, grab, words, world

from cotouch.observers import SetDamping
from cotouch.web import PageAddress, PageServer


def test_cutting_a_link_shows_in_the_graph_the_card_and_the_verdict(here: World) -> None:
    page = here.open()
    assert page.get_attribute("#verdict", "data-level") == "good"
    choose(page, 1, 3)
    page.click("#cut")
    page.wait_for_selector(LINK.format(1, 3) + '[data-condition="cut"]')
    words(page, LINK.format(1, 3) + " .link-words", "✕ cut")
    words(page, "#verdict", "attention: Safe: link 2–4")
    assert here.did("cut") == [{"a": 1, "b": 3, "on": True}]
    assert page.get_attribute(LINK.format(0, 1), "data-condition") == "coupled"
    page.click("#cut")
    page.wait_for_selector(LINK.format(1, 3) + '[data-condition="coupled"]')
    words(page, "#verdict", "to spare")


def test_a_copy_that_is_too_far_away_to_be_told_of_is_named_in_the_card_and_the_verdict(here: World) -> None:
    page = here.open()
    choose(page, 1, 3)
    words(page, "#link .means", "Both ends feel each other")
    here.api.away.add(3)
    words(page, "#link .means", "^A copy is farther away than samples can tell, so it sends none.$")
    words(page, "#verdict", "attention: Safe: Dan's copy is farther away than samples can tell")
    here.api.away.clear()
    words(page, "#link .means", "Both ends feel each other")


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
    words(first, '.user[data-slot="0"] .hand-mode', "pointer grabs")
    second = here.open()
    words(second, '.user[data-slot="0"] .hand-mode', "pointer grabs")
    second.wait_for_selector("#banner-control")
    words(second, "#banner-control", "Another page controls Ann")
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
    page.click('.user[data-slot="2"] .user-head')
    card = page.locator('.user[data-slot="2"]')
    for order, mode in (("Hold", "hold"), ("Let go", "free"), ("Script", "script"), ("Wander", "wander")):
        card.get_by_role("radio", name=order).click()
        page.wait_for_function("mode => window.cotouch.store.state.members[2].hand === mode", arg=mode)
        assert card.get_by_role("radio", name=order).get_attribute("aria-checked") == "true"
    card.get_by_role("radio", name="Pull").click()
    words(page, "#banner-aim", "where Cleo should pull")
    assert card.get_by_role("button", name="Pull forward").is_visible()
    # In one dimension there are two directions.
    assert card.locator(".directions button").count() == 2
    card.get_by_role("button", name="Pull forward").click()
    page.wait_for_function("() => window.cotouch.store.state.members[2].hand === 'pull'")
    order = here.did("hand")[-1]
    assert order["slot"] == 2
    assert order["node"] == 0
    assert order["to"][0] >= 0.1
    assert page.is_hidden("#banner-aim")


def test_a_user_is_stopped_and_brought_back(here: World) -> None:
    page = here.open()
    page.click('.user[data-slot="4"] .user-head')
    page.click('.user[data-slot="4"] >> text=Stop process')
    page.wait_for_selector('.user[data-slot="4"][data-presence="stopped"]')
    words(page, "#users .panel-note", "4 of 5 here")
    page.wait_for_selector('.node[data-slot="4"]:not([data-presence="here"])')
    assert page.locator(LINK.format(3, 4)).count() == 0
    page.click('.user[data-slot="4"] >> text=Restart process')
    page.wait_for_selector('.user[data-slot="4"][data-presence="here"]')
    page.wait_for_selector(LINK.format(3, 4))


def test_links_are_switched_and_drawn(here: World) -> None:
    page = here.open()
    page.click("#topology >> text=Worst")
    page.wait_for_selector(LINK.format(0, 4))
    words(page, "#topology .means", "fade slowest")
    words(page, "#topology .expected", r"mean round trip .*s\. The user with the highest load needs about \d")
    page.click("#topology >> text=Best")
    page.wait_for_selector(LINK.format(3, 4))
    page.click("#topology >> text=Yours")
    page.wait_for_selector('.pair[data-link="3-4"][aria-checked="true"]')
    apply = page.get_by_role("button", name="Apply")
    page.focus('.pair[data-link="3-4"]')
    page.keyboard.press("Enter")
    words(page, "#topology .problem", "No path leads to Eve")
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


def test_an_invitation_is_shown_and_a_slot_freed(here: World) -> None:
    page = here.open()
    page.click("#invite")
    # The invitation is in no command, which every user of a machine could read.
    assert page.get_by_label("Command").input_value() == "cotouch join - --name Eve"
    assert page.get_by_label("Invitation").input_value() == here.api.scene.invitation
    # Nobody else reaches this page, so there is nothing to scan.
    assert page.is_hidden(".qr")
    words(page, "dialog", "--page-listen")
    page.click("text=Free this slot")
    words(page, "dialog", "The slot of Eve is free")
    assert here.did("expel") == [{"slot": 4}]
    page.keyboard.press("Escape")
    assert page.evaluate("() => document.activeElement.id") == "invite"


def test_a_phone_opens_the_page_by_its_qr_code(running: Browser, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(PageAddress, "elsewhere", "http://192.0.2.7:8765/")
    with world(running) as here:
        page = here.open()
        page.click("#invite")
        page.wait_for_function(
            "() => { const code = document.querySelector('.qr'); return code.complete && code.naturalWidth > 0; }"
        )
        words(page, ".qr-frame", "opens this page on a phone, as Eve")
        assert "user=5" in (page.get_attribute(".qr", "src") or "")


def test_whoever_takes_part_from_elsewhere_is_sent_away_after_a_question(here: World) -> None:
    here.api.elsewhere.add(1)
    page = here.open()
    card = page.locator('.user[data-slot="1"]')
    card.locator(".user-head").click()
    assert card.get_attribute("data-presence") == "here"
    assert card.get_by_role("button", name="Stop process").is_hidden()
    card.get_by_role("button", name="Remove").click()
    question = page.get_by_role("dialog", name="Remove Ben?")
    assert "for the rest of the session" in (question.text_content() or "")
    page.keyboard.press("Enter")  # what takes nothing away has the focus
    assert here.did("expel") == []
    card.get_by_role("button", name="Remove").click()
    question.get_by_role("button", name="Remove").click()
    page.wait_for_selector('.user[data-slot="1"][data-presence="stopped"]')
    assert here.did("expel") == [{"slot": 1}]
    # One whose process runs here is stopped instead; and who only watches does neither.
    page.click('.user[data-slot="2"] .user-head')
    assert page.locator('.user[data-slot="2"]').get_by_role("button", name="Remove").is_hidden()
    here.api.elsewhere.add(2)
    watching = here.open(here.server.address)
    watching.click('.user[data-slot="2"] .user-head')
    assert watching.locator('.user[data-slot="2"]').get_by_role("button", name="Remove").count() == 0


def test_a_banner_moves_nothing(here: World) -> None:
    page = here.open()
    places = """() => [...document.querySelectorAll('button, .panel, .tabs, #stage')].filter((one) =>
        one.getClientRects().length && !one.closest('.notices, #verdict')).map((one) => {
            const { left, top, width, height } = one.getBoundingClientRect();
            return [one.id || one.textContent, left, top, width, height].join(' '); })"""
    page.wait_for_function("() => document.fonts.status === 'loaded'")
    before = page.evaluate(places)
    here.api.do(SetDamping(fraction=0.4))
    page.wait_for_selector("#banner-damping")
    during = [place for place in page.evaluate(places) if "damping" not in place]
    assert len(during) > 20
    assert set(during) <= set(before)


def test_a_verdict_is_said_once(here: World) -> None:
    page = here.open()
    here.api.do(SetDamping(fraction=0.4))
    words(page, "#verdict", "Not safe: damping lowered to 40 %")
    page.wait_for_function("() => /not safe/.test(document.querySelector('#spoken').textContent)")
    assert page.is_hidden(".toast")
    page.click("#tab-margin")
    assert "not safe" not in (page.text_content("#margin .panel-body") or "").lower()


def test_without_the_token_one_watches(here: World) -> None:
    page = here.open(here.server.address)
    words(page, "#banner-view", "You are only watching")
    assert page.is_hidden("#invite")
    assert page.is_disabled("#record")
    page.click('.user[data-slot="1"] .user-head')
    for name in ("Stop process",):
        assert page.get_by_role("button", name=name).first.is_disabled()
    assert page.locator('.user[data-slot="1"]').get_by_role("radio", name="Hold").is_disabled()
    choose(page, 1, 3)
    assert page.is_disabled("#cut")
    page.keyboard.press("r")
    grab(page, 0.05)
    assert here.api.done == []
    assert here.api.pointers == []
    # Who watches is nobody, and takes hold of nothing.
    assert page.locator(".chip-mine:visible").count() == 0
    assert page.locator(".user[data-mine], .node[data-mine]").count() == 0
    assert page.locator(".ct-hint:visible").count() == 0


def test_an_old_token_is_told_and_offers_nothing(here: World) -> None:
    mine = here.open()
    mine.wait_for_function("() => window.cotouch.connection.mayAct")
    page = here.open(here.server.address + "#token=of-yesterday")
    words(page, "#banner-view", "does not belong to the running session")
    page.wait_for_function("() => window.cotouch.store.state.control === 'other'")
    assert page.is_hidden("#banner-control")
    assert not page.evaluate("() => window.cotouch.connection.mayAct")


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
        again = PageServer(made.api, port=port, token=token)
        page.wait_for_selector("#banner-lost", state="hidden")
        page.wait_for_function("before => window.cotouch.store.scene.started !== before", arg=before)
        page.wait_for_function(READY)
        words(page, "#verdict", "to spare")
        overview = made.api.overview
        made.api.overview = lambda: replace(overview(), ended=True)  # type: ignore[method-assign]
        words(page, "#banner-ended", "The session has ended")
        # While nobody listens, the browser says so itself; nothing else was said.
        assert [said for said in made.complaints if "ERR_CONNECTION_REFUSED" not in said] == []
    finally:
        if again is not None:
            again.close()
        made.close()


def test_choices_that_are_not_known_yet_say_so(here: World) -> None:
    found = dict(here.api.choices)
    here.api.choices = {"start": found["start"]}
    page = here.open()
    best, worst = (page.get_by_role("radio", name=name) for name in ("Best", "Worst"))
    words(page, "#topology .means", "The links that the session started with. Best and worst are being computed.")
    assert best.is_disabled()
    assert "computed" in (best.get_attribute("data-tip") or "")
    assert best.inner_text() == "Best …"
    here.api.choices = found | {"worst": []}
    page.wait_for_function("() => document.querySelector('#topology [data-value=best]').textContent === 'Best'")
    assert best.is_enabled()
    assert worst.is_disabled()
    assert worst.get_attribute("data-tip") == "None found."
    assert "worked out" not in page.locator("#topology .means").inner_text()
