"""A page asks for frames so that they come just before a picture of its screen, and says a movement once."""

from collections.abc import Generator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser
from tests.simulation.browser import browser
from tests.web.pictures import heard, move, pictures_later, shown, spot, until

# A screen, and a server that makes every frame when it was asked for; on the way it takes some time. Returns how long
# before the next picture frames came, of the second half.
PLAYED = """([every, ways, jumps]) => {
  const screen = new (window.cotouch.connection.screen.constructor)();
  const left = [];
  let picture = 0, made = 0, n = 0;
  for (let k = 0; k < 40; k++) screen.picture(picture += every);
  for (let k = 0; k < ways.length; k++) {
    const came = made + ways[k];
    while (picture + every <= came) screen.picture(picture += (jumps && n++ % 7 === 0 ? 2 : 1) * every);
    const [wait, pictures] = screen.came(came);
    if (k >= ways.length / 2) left.push((((picture - came) % every) + every) % every);
    made = pictures ? came + 0.3 + wait : came + every;
    if (pictures && Math.abs(pictures - every) > 0.01) throw new Error(`${pictures} for ${every}`);
  }
  return left;
}"""


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser() as one:
        yield one


@pytest.mark.parametrize("every", [1000 / 60, 1000 / 144, 1000 / 30])
@pytest.mark.parametrize("jumps", [False, True])
def test_frames_come_just_before_a_picture(running: Browser, every: float, jumps: bool) -> None:
    rng = np.random.default_rng(3)
    steady, shaken = [3.0] * 3000, (2.0 + rng.exponential(0.4, 6000)).tolist()
    with shown(running) as here:
        page = here.open()
        left = np.array(page.evaluate(PLAYED, [every, steady, jumps]))
        assert left.max() < 2.0
        left = np.array(page.evaluate(PLAYED, [every, shaken, jumps]))
    late = left > 0.7 * every
    assert late.mean() < 0.08
    assert np.median(left[~late]) < 2.5


def test_a_way_that_gets_short_is_not_taken_for_a_missed_picture(running: Browser) -> None:
    with shown(running) as here:
        left = np.array(here.open().evaluate(PLAYED, [1000 / 60, [12.0] * 1000 + [1.0] * 1000, False]))
    assert left[0] > 11.0
    assert (np.diff(left[:200]) < 0.0).all()


def test_nothing_is_asked_for_while_the_screen_is_not_known_or_stands_still(running: Browser) -> None:
    with shown(running) as here:
        commanded: Any = here.open().evaluate(
            """() => { const screen = new (window.cotouch.connection.screen.constructor)(), before = screen.came(1);
                 for (let k = 1; k <= 40; k++) { screen.picture(10 * k); screen.picture(10 * k); }
                 return [before, screen.came(405), screen.came(1000)]; }"""
        )
    assert commanded[0] == commanded[2] == [0, 0]
    wait_, every = commanded[1]
    assert every == 10
    assert 0 < wait_ <= 10


def test_a_movement_is_told_once(running: Browser) -> None:
    """Browsers tell of it at once, and again with their next picture."""
    with shown(running) as here:
        page = here.open()
        x, y, _ = spot(page)
        page.mouse.move(x, y)
        page.mouse.down()
        for k in range(1, 11):
            move(page, x + 3.0 * k, y)
            until(page, "(([x, y]) => Math.abs(x - value) < 0.5)(stage.probe().target)", x + 3.0 * k)
            pictures_later(page)
            heard(page, here.api)
        assert len({pointer.target for _, pointer in here.api.pointers}) == 11
        assert page.evaluate("() => window.cotouch.connection.number") == 11
