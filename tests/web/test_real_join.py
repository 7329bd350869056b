"""A session as people start it by hand, each with a page of their own: host, joins, a guest, and what goes wrong."""

import signal
from pathlib import Path
from typing import Any

from playwright.sync_api import Page
from tests.simulation.browser import FLAT, UNHURRIED, browser
from tests.web.parties import PATIENCE, party
from tests.web.pictures import BEFORE, spot, until
from tests.web.shell_pages import words

# How far a copy has moved in this page [m].
FAR = "store.frame.scale * Math.abs(store.frame.copies.find((copy) => copy.slot === {})?.displacement[0] ?? 0)"
# Whether this page's own copy is coupled with all who are linked to it.
COUPLED = """(ends => ends.length > 0 && ends.every(([, end]) => end.state === 'coupled'))(
    Object.entries(store.state.ends).filter(([key]) => key.startsWith(`${store.slot}-`)))"""


def opened(running: Any, address: str, said: list[str]) -> Page:
    """A page in a browser of its own, with all that it complains about."""
    context = running.new_context(viewport={"width": 1024, "height": 600})
    context.set_default_timeout(1e3 * PATIENCE)
    context.add_init_script(BEFORE)
    context.add_init_script(UNHURRIED)
    page = context.new_page()
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(address)
    until(page, "store.state && store.frame && store.scene.own.length === 1")
    return page


def test_people_meet_by_an_invitation_feel_each_other_and_part(tmp_path: Path) -> None:
    said: list[str] = []
    with party(tmp_path) as here, browser(FLAT) as running:
        invitation = here.host()
        addresses = {
            "Ann": here.join("Ann", invitation),
            "Ben": here.join("Ben", invitation),
        }
        ann, ben = (opened(running, address, said) for address in addresses.values())
        for page in (ann, ben):
            until(page, COUPLED)
        # Each page acts for its own user alone, and knows of the others what came over the network.
        until(ben, "store.slot === 1 && store.frame.copies.every((copy) => copy.direct === (copy.slot === 1))")
        words(ben, '.user[data-slot="0"]', "on another computer")

        x, y, _ = spot(ann)
        ann.mouse.move(x, y)
        ann.mouse.down()
        ann.mouse.move(x + 120, y, steps=6)
        until(ann, f"{FAR.format(0)} > 0.01")
        until(ben, f"{FAR.format(0)} > 0.01 && {FAR.format(1)} > 0.005")
        ann.mouse.up()

        # An old address says so, and offers nothing that it would be refused.
        old = opened(running, addresses["Ann"].split("#")[0] + "#token=of-yesterday", said)
        words(old, "#banner-view", "does not belong to the running session")
        assert old.is_hidden("#banner-control")
        assert not old.evaluate("() => window.cotouch.connection.mayAct")
        old.context.close()

        # A window that is gone takes its part with it; whoever has the invitation can have the slot.
        here.end("Ben", signal.SIGKILL)
        words(ben, "#banner-lost", "Reconnecting")
        until(ann, "!store.state.members[1]?.here")
        shown = str(ann.evaluate("() => window.cotouch.store.scene.invitation"))
        guest = opened(running, here.join("guest", shown), said)
        until(guest, f"store.slot !== 0 && connection.mayAct && {COUPLED}")
        x, y, _ = spot(guest)
        guest.mouse.move(x, y)
        guest.mouse.down()
        guest.mouse.move(x - 120, y, steps=6)
        until(ann, f"{FAR.format(0)} > 0.005")
        guest.mouse.up()

        assert here.end("host") == 0
        for page in (ann, guest):
            words(page, "#banner-ended", "The session has ended")
        for page in (ann, ben, guest):
            page.context.close()
    assert said == []


def test_who_joins_with_a_device_holds_the_object_from_the_first_moment(tmp_path: Path) -> None:
    said: list[str] = []
    with party(tmp_path) as here, browser(FLAT) as running:
        page = opened(running, here.join("Cleo", here.host(), device="simulated:touch"), said)
        until(page, "connection.mayAct && store.state.members[store.slot].hand !== null")
        page.context.close()
    assert said == []
