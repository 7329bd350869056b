"""What the page's picture shows and what a hand on it does, in a real browser."""

from collections.abc import Generator
from itertools import pairwise

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.simulation.browser import browser
from tests.web.pictures import PHONE, TOKEN, Shown, heard, move, shown, spot, until, wait

from cotouch.observers import Cut, Impair
from cotouch.web import PageServer

# When each copy's held point had first moved so far, on the server's clock, and how far it came at most.
WATCH = """([point, far]) => {
  const first = {}, most = {};
  window.watched = { first, most };
  window.cotouch.store.on('frame', () => {
    const { copies, scale, time } = window.cotouch.store.frame;
    for (const { slot, displacement: d } of copies) {
      const size = scale * Math.hypot(d[3 * point], d[3 * point + 1], d[3 * point + 2]);
      most[slot] = Math.max(most[slot] ?? 0, size);
      if (size > far) first[slot] ??= time;
    }
  });
}"""

# How far a point of a copy is from its rest [m].
REACH = "store.frame.scale * Math.hypot(...copy.displacement.slice(3 * value, 3 * value + 3))"


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser() as one:
        yield one


def slowly(here: Shown) -> None:
    """All ways take a second and a half: longer than a busy machine takes for a picture."""
    for a, b in here.api.overview().roster.links:
        here.api.do(Impair(a=a, b=b, delay=1.5))


# From Ann: one link to Ben and Dan, two to Cleo and Eve; a picture may show two moments as one.
FARTHER = ((1, 0.1), (2, 1.6), (3, 0.1), (4, 1.6))


def pulled(page: Page, by: tuple[float, float]) -> int:
    """Takes a point with the mouse and draws it so many pixels away; the button stays down."""
    x, y, point = spot(page)
    page.evaluate(WATCH, [point, 0.004])
    page.mouse.move(x, y)
    page.mouse.down()
    move(page, x + by[0], y + by[1], steps=8)
    return point


def node_target(here: Shown, page: Page, point: int) -> tuple[float, float, float]:
    """Where the node is to go that the held point of the skin hangs on: as far beside it as at rest."""
    x, y, z = page.evaluate("() => window.cotouch.stage.probe().hold.target.toArray()")
    body = here.api.scene.body
    assert body.skin is not None
    a, b, c = body.skin.vertices[point] - body.rest[here.api.pointers[-1][1].node]
    return x - a, y - b, z - c


def test_the_stream_advances_and_what_is_drawn_moves(running: Browser) -> None:
    with shown(running, still=False) as here:
        page = here.open()
        number = page.evaluate("() => window.cotouch.store.frame.number")
        before = page.locator(".ct-canvas").screenshot()
        until(page, "store.frame.number > value + 20 && stats.frames > 8", number)
        assert page.locator(".ct-canvas").screenshot() != before
        times = page.evaluate("() => [...window.cotouch.store.history.time()]")
        assert len(times) > 8
        assert all(a < b for a, b in pairwise(times))


# Two labels whose numbers are others in every picture, one in 16 ms; the second has one from the 51st to the 150th.
LABELLED = """() => {
  const parent = document.createElement('div'), now = performance.now;
  const labels = new (window.cotouch.stage.probe().space.labels.constructor)(parent);
  const told = [];
  try {
    for (let k = 0; k < 200; k++) {
      performance.now = () => 1e6 + 16 * k;
      labels.put('one', 'hand', 0, 'One', `${k} N`, 0, 0);
      labels.put('two', 'hand', 1, 'Two', k >= 50 && k < 150 ? `${2 * k} N` : '', 0, 90);
      labels.sweep();
      told.push([...parent.querySelectorAll('span')].map((span) => span.textContent));
    }
  } finally { performance.now = now; }
  return told;
}"""


def test_numbers_in_the_picture_change_as_often_as_they_can_be_read(running: Browser) -> None:
    with shown(running) as here:
        one, two = np.array(here.open().evaluate(LABELLED)).T
    changes = np.flatnonzero(one[1:] != one[:-1]) + 1
    assert set(np.diff(changes)) == {8}  # an eighth of a second
    assert [int(number.removesuffix(" N")) for number in one[changes]] == changes.tolist()
    # A number comes and goes at once, and changes with those of others: the page is laid out once.
    assert (two[49], two[50], two[149], two[150]) == ("", "100 N", two[148], "")
    assert set(np.flatnonzero(two[51:150] != two[50:149]) + 51) <= set(changes.tolist())


def test_how_things_are_is_told_where_no_picture_is_drawn(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        page.evaluate("() => { window.requestAnimationFrame = () => 1; }")
        until(page, "store.state.time > value + 1.0", page.evaluate("() => window.cotouch.store.state.time + 1.0"))


def test_numbers_arrive_as_the_server_has_them(running: Browser) -> None:
    with shown(running, still=False) as here:
        stopped = here.api.clock()
        here.api.clock = lambda: stopped
        page = here.open()
        views, body = here.api.views(), here.api.scene.body
        assert body.skin is not None
        frame = page.evaluate(
            """() => { const { frame, scene } = window.cotouch.store;
                 return { scale: frame.scale, centre: scene.centre, vertices: scene.points.length / 3,
                   triangles: [...scene.skin.triangles.slice(-6)], rest: [...scene.points.slice(-6)],
                   copies: frame.copies.map(c => ({ ...c, displacement: [...c.displacement] })) }; }"""
        )
        assert frame["vertices"] == len(body.skin.vertices)
        np.testing.assert_allclose(frame["rest"], body.skin.vertices[-2:].ravel(), rtol=1e-6)
        assert frame["triangles"] == body.skin.triangles[-2:].ravel().tolist()
        assert [copy["slot"] for copy in frame["copies"]] == sorted(views)
        for copy in frame["copies"]:
            view = views[copy["slot"]]
            skin = np.einsum("vk,vkd->vd", body.skin.weights, view.displacement[body.skin.nodes])
            error = np.array(copy["displacement"]).reshape(-1, 3) * frame["scale"] - skin
            assert np.abs(error).max() <= 0.51 * frame["scale"]
            hand = view.hands[0]
            assert (copy["mode"], copy["node"], copy["direct"]) == (hand.mode, hand.node, view.direct)
            for name in ("target", "place", "force"):
                np.testing.assert_allclose(copy[name], getattr(hand, name), rtol=1e-6)
            for name in ("energy", "supplied", "lost", "linked"):
                assert copy[name] == pytest.approx(getattr(view, name), rel=1e-6)


def test_a_drag_moves_the_held_point_here_first_then_there_and_release_lets_it_return(running: Browser) -> None:
    with shown(running) as here:
        slowly(here)
        page = here.open()
        x, y, _ = spot(page)
        point = pulled(page, (-70.0, -50.0))
        until(page, "Object.keys(window.watched.first).length === 5")
        first = page.evaluate("() => window.watched.first")
        late = [first[str(slot)] - first["0"] for slot in range(5)]
        assert all(late[slot] > least for slot, least in FARTHER)
        until(page, "store.frame.copies[0].mode === 'grab' && stats.dragToMesh.length > 0")
        # The hand is where the pointer is, in the plane through the point that faces the eye.
        slot, pointer = here.api.pointers[-1]
        assert (slot, pointer.mode) == (0, "grab")
        wanted = node_target(here, page, point)
        wait(page, lambda: here.api.pointers[-1][1].target == pytest.approx(wanted, rel=1e-5, abs=1e-7))
        where = page.evaluate("() => window.cotouch.stage.probe().target")
        assert where == pytest.approx([x - 70.0, y - 50.0], abs=2.0)
        assert page.evaluate("() => window.watched.most[0]") > 0.005
        # And what is drawn follows.
        until(page, "(at => at.x < value[1] - 2 && at.y < value[2] - 2)(stage.spot(value[0]))", [point, x, y])
        page.mouse.up()
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")
        until(page, f"store.frame.copies.every(copy => {REACH} < 0.001)", point)
        assert all(most > 0.004 for most in page.evaluate("() => Object.values(window.watched.most)"))


def test_pointers_are_few_and_the_last_counts(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        point = pulled(page, (5.0, 0.0))
        until(page, "store.frame.copies[0].mode === 'grab'")
        heard(page, here.api)
        before = page.evaluate("() => window.cotouch.connection.number")
        x, y, _ = spot(page)
        took = page.evaluate(
            """([x, y]) => { const canvas = document.querySelector('.ct-canvas'), began = performance.now();
                 for (let k = 1; k <= 400; k++) canvas.dispatchEvent(new PointerEvent('pointermove',
                   { pointerId: 1, pointerType: 'mouse', clientX: x - k / 4, clientY: y, bubbles: true }));
                 return performance.now() - began; }""",
            [x, y],
        )
        last = heard(page, here.api)
        assert 0 < page.evaluate("() => window.cotouch.connection.number") - before <= 10 + took / 8
        assert last.target == pytest.approx(node_target(here, page, point), rel=1e-5, abs=1e-7)
        page.keyboard.press("Escape")
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")


def test_wheel_goes_into_the_depth_and_a_ball_pushes(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        pulled(page, (3.0, 0.0))
        before = np.array(heard(page, here.api).target)
        away = np.array(page.evaluate("() => window.cotouch.stage.probe().orbit.axes()[2].toArray()"))
        page.mouse.wheel(0, -300)
        wait(page, lambda: float((np.array(here.api.pointers[-1][1].target) - before) @ away) > 0.005)
        moved = np.array(here.api.pointers[-1][1].target) - before
        np.testing.assert_allclose(moved, (moved @ away) * away, atol=1e-6)
        page.mouse.up()
        page.evaluate("() => window.cotouch.store.set({ tool: 'ball' })")
        # Only the newest place is sent: on a busy machine the ball is as deep as it goes when the server hears of it.
        page.evaluate(
            """() => { const { connection } = window.cotouch, point = connection.point.bind(connection);
                 window.said = []; connection.point = said => { window.said.push(said); point(said); }; }"""
        )
        page.mouse.down()
        wait(page, lambda: here.api.pointers[-1][1].mode == "ball")
        put = np.array(page.evaluate("() => window.said.find(said => said.action === 'ball').target"))
        wait(page, lambda: float((np.array(here.api.pointers[-1][1].target) - put) @ away) > 0.001)
        assert here.api.pointers[-1][1].radius > 0.0
        page.mouse.up()
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")


def test_keys_grab_move_and_let_go(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        page.focus(".ct-canvas")
        page.keyboard.press("g")
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        right = np.array(page.evaluate("() => window.cotouch.stage.probe().orbit.axes()[0].toArray()"))
        before = np.array(here.api.pointers[-1][1].target)
        page.keyboard.press("ArrowRight")
        wait(page, lambda: float((np.array(here.api.pointers[-1][1].target) - before) @ right) > 0.0)
        page.keyboard.press("Escape")
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")


def test_without_the_token_a_drag_only_turns_the_picture(running: Browser) -> None:
    with shown(running) as here:
        page = here.open(token=False)
        x, y, point = spot(page)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + 60, y, steps=3)
        page.mouse.up()
        until(page, "Math.abs(stage.spot(value[0]).x - value[1]) > 5", [point, x])
        assert here.api.pointers == []


def test_the_page_survives_the_servers_restart(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        started = page.evaluate("() => window.cotouch.store.scene.started")
        port = here.server.port
        here.server.close()
        until(page, "store.connection === 'lost'")
        here.api = here.made()
        here.server = PageServer(here.api, port=port, token=TOKEN)
        until(
            page, "store.connection === 'open' && store.scene.started !== value && store.frame && store.state", started
        )
        frames = page.evaluate("() => window.cotouch.stats.frames")
        until(page, "stats.frames > value + 3 && connection.mayAct", frames)
        assert page.locator(".ct-canvas").count() == 1
        pulled(page, (-40.0, 0.0))
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        page.mouse.up()
        # What a browser says of a server that is away cannot be kept from it.
        here.complaints[:] = [said for said in here.complaints if "ERR_CONNECTION" not in said]


def test_what_is_held_is_held_again_after_the_connection_was_lost(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        pulled(page, (-20.0, 0.0))
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        page.evaluate("() => window.cotouch.connection.socket.close()")

        def again() -> bool:
            modes = [pointer.mode for _, pointer in here.api.pointers]
            return "free" in modes and "grab" in modes[modes.index("free") :]

        wait(page, again)
        page.mouse.up()


class Fingers:
    """On a touch screen."""

    def __init__(self, page: Page) -> None:
        self._session = page.context.new_cdp_session(page)

    def __call__(self, kind: str, *places: tuple[float, float]) -> None:
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
        self._session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})


def test_one_finger_pulls_and_two_turn_and_zoom(running: Browser) -> None:
    with shown(running) as here:
        page = here.open(**PHONE)
        fingers = Fingers(page)
        x, y, point = spot(page)
        fingers("touchStart", (x, y))
        for k in range(1, 6):
            fingers("touchMove", (x - 6 * k, y - 4 * k))
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        until(page, "store.frame.copies[0].mode === 'grab'")
        fingers("touchEnd")
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")
        commanded = len(here.api.pointers)
        until(page, f"store.frame.copies.every(copy => {REACH} < 0.001)", point)
        zoom = page.evaluate("() => window.cotouch.stage.probe().orbit.metres(100)")
        corner = page.locator(".ct-canvas").bounding_box()
        assert corner is not None
        low = corner["y"] + corner["height"] - 60
        fingers("touchStart", (150.0, low), (240.0, low))
        for k in range(1, 8):
            fingers("touchMove", (150.0 - 8 * k, low), (240.0 + 8 * k, low))
        fingers("touchEnd")
        until(page, "stage.probe().orbit.metres(100) < 0.9 * value", zoom)
        assert {pointer.mode for _, pointer in here.api.pointers[commanded:]} <= {"grab", "free"}
        assert here.api.pointers[-1][1].mode == "free"


def slider(here: Shown, running: Page) -> None:
    """Drags one's own slider to the right and lets it go."""
    x, y, _ = spot(running)
    running.evaluate(WATCH, [0, 0.004])
    running.mouse.move(x, y)
    running.mouse.down()
    running.mouse.move(x + 90, y, steps=6)
    wait(running, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].target[0] > 0.005)
    until(running, "Object.keys(window.watched.first).length === 5")
    running.mouse.up()
    wait(running, lambda: here.api.pointers[-1][1].mode == "free")


def test_a_slider_is_dragged_on_its_rail_and_the_others_follow(running: Browser) -> None:
    with shown(running, "1d") as here:
        slowly(here)
        page = here.open()
        before = page.locator(".ct-canvas").screenshot()
        slider(here, page)
        first = page.evaluate("() => window.watched.first")
        assert all(first[str(slot)] - first["0"] > least for slot, least in FARTHER)
        assert page.locator(".ct-canvas").screenshot() != before
        # For another user, on his rail.
        _, own, _ = spot(page)
        page.evaluate("() => window.cotouch.store.take(3)")
        until(page, "store.state.control === 'mine' && connection.mayAct")
        assert spot(page)[1] > own + 50
        slider(here, page)
        assert here.api.pointers[-1][0] == 3


def test_side_by_side_every_copy_has_its_name_and_delay(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        page.evaluate("() => window.cotouch.store.set({ layout: 'side' })")
        page.wait_for_selector(".ct-title >> nth=4")
        until(page, "!!store.state.emulated['1-0']")
        titles = page.locator(".ct-title").all_inner_texts()
        assert [title.split()[0] for title in titles] == ["Ann", "Ben", "Cleo", "Dan", "Eve"]
        for title, words in zip(titles, ("you", "50 ms", "90 ms", "90 ms", "130 ms"), strict=True):
            assert words in title.replace("\u202f", " ")
        here.api.do(Cut(a=3, b=4, on=True))
        page.wait_for_function("() => document.querySelectorAll('.ct-title')[4].textContent.includes('out of reach')")
