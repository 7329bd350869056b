"""The picture of bodies without a skin, with a gamepad, and for whoever asked for less motion."""

from collections.abc import Generator
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser, Page
from tests.simulation.browser import browser
from tests.web.fake_session_api import Kind
from tests.web.pictures import heard, move, shown, spot, until, wait

from cotouch.mechanics import Box, Plane
from cotouch.observers import MoveHand

# A gamepad as a browser would give it, and what its motors were asked for.
PAD = """
window.told = [];
window.pad = { connected: true, axes: [0, 0, 0, 0], buttons: [{ pressed: false }], vibrationActuator: {
  playEffect: (kind, how) => { window.told.push({ kind, ...how }); return Promise.resolve('complete'); } } };
navigator.getGamepads = () => [null, window.pad];
"""
# Where the eye is two drawings after it was turned, and where it came to rest.
TURNED = """async () => {
  const { stage } = window.cotouch, { orbit } = stage.probe();
  const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const eye = () => orbit.camera.position.toArray();
  orbit.turn(200, 0);
  stage.pulse(1); // so that it draws, whether or not a frame came
  await drawn();
  const soon = eye();
  for (let k = 0, before = ''; k < 600 && before !== String(eye()); k++) {
    before = String(eye());
    await drawn();
  }
  return [soon, eye()];
}"""


@pytest.fixture(scope="module")
def running() -> Generator[Browser]:
    with browser() as one:
        yield one


# Where the middle of the first tool is drawn.
BAR = """() => {
  const { space } = window.cotouch.stage.probe(), { first, last } = space.shape.tools[0];
  const spots = Array.from({ length: last - first }, (_, k) => window.cotouch.stage.spot(first + k));
  const mean = (axis) => spots.reduce((sum, spot) => sum + spot[axis], 0) / spots.length;
  return [mean('x'), mean('y')];
}"""
ARROW = "stage.probe().space.hands.get(0).group.visible && stage.probe().space.hands.get(0).shaft.visible"


def test_a_rigid_tool_is_led_and_turned_by_its_user_and_its_force_is_drawn(running: Browser) -> None:
    with shown(running, "tool") as here:
        page, api = here.open(), here.api
        page.click('#toolbar [data-value="ball"]')  # pressed on, one's own tool is led all the same
        x, y = page.evaluate(BAR)
        page.mouse.move(x, y)
        page.mouse.down()
        wait(page, lambda: bool(api.pointers))
        slot, taken = api.pointers[-1]
        assert (slot, taken.mode, taken.node) == (0, "pose", 0)
        assert taken.target == pytest.approx((0.0, 0.0, 0.05), abs=1e-5)
        assert taken.turn == pytest.approx((0.0, 0.0, 0.0), abs=1e-4)
        move(page, x + 40, y, steps=4)
        moved = heard(page, api)
        assert np.linalg.norm(np.subtract(moved.target, taken.target)) > 0.005
        assert moved.turn == taken.turn
        page.keyboard.down("Shift")
        move(page, x + 90, y, steps=5)
        turned = heard(page, api)
        up = page.evaluate("() => window.cotouch.stage.probe().orbit.axes()[1].toArray()")
        assert turned.turn == pytest.approx(0.5 * np.array(up), abs=1e-3)
        assert turned.target == moved.target
        page.keyboard.up("Shift")
        move(page, x + 91, y)
        went = np.linalg.norm(np.subtract(heard(page, api).target, moved.target))
        assert 0.0 < went < 0.1 * np.linalg.norm(np.subtract(moved.target, taken.target))  # it does not leap
        page.mouse.up()
        wait(page, lambda: api.pointers[-1][1].mode == "free")
        until(page, f"!({ARROW})")
        api.do(MoveHand(slot=0, mode="pose", to=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0)))
        until(page, ARROW)


@pytest.mark.parametrize("kind", ["chain", "2d", "bare"])
def test_a_body_without_a_skin_is_seen_and_held(running: Browser, kind: Kind) -> None:
    with shown(running, kind) as here:
        page = here.open()
        still = page.locator(".ct-canvas").screenshot()
        x, y, point = spot(page)
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + 80, y - 20, steps=4)
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        assert here.api.pointers[-1][1].node == point
        until(page, "store.frame.copies.every((copy) => copy.displacement[3 * value] > 0)", point)
        assert page.locator(".ct-canvas").screenshot() != still
        page.mouse.up()
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")
        if kind == "chain":  # on rails
            return
        # Without the others, all of one's own copy is there: every node and every edge.
        page.evaluate("() => window.cotouch.store.set({ ghosts: false })")
        until(
            page,
            "(({ points, lines }) => points === store.scene.nodes.count && lines === store.scene.edges.length / 2)"
            "(stage.probe().space.renderer.info.render)",
        )


def pad(page: Page, **entries: Any) -> None:
    page.evaluate("entries => Object.assign(window.pad, entries)", entries)


@pytest.mark.parametrize("kind", ["1d", "3d"])
def test_a_gamepad_moves_the_hand_and_its_motors_tell_the_force(running: Browser, kind: Kind) -> None:
    with shown(running, kind) as here:
        page = here.open(script=PAD)
        pad(page, buttons=[{"pressed": True}])
        wait(page, lambda: bool(here.api.pointers) and here.api.pointers[-1][1].mode == "grab")
        until(page, "store.frame.copies[0].mode === 'grab'")
        before = np.array(here.api.pointers[-1][1].target)
        # Within what a stick has when nobody touches it, nothing moves.
        pad(page, axes=[0.1, 0, 0, 0])
        number = page.evaluate("() => window.cotouch.stats.frames")
        until(page, "stats.frames > value + 3", number)
        assert np.array(here.api.pointers[-1][1].target) == pytest.approx(before)
        # Where nothing pulls, nothing rumbles, although the node that is drawn is not quite where the skin was taken.
        assert page.evaluate("() => window.told.every((one) => one.weakMagnitude < 0.1)")
        pad(page, axes=[1, 0, 0, 0])
        page.wait_for_function("() => window.told.some((one) => one.weakMagnitude > 0.1)")
        wait(page, lambda: float(np.abs(np.array(here.api.pointers[-1][1].target) - before).max()) > 1e-3)
        right = (
            [1, 0, 0] if kind == "1d" else page.evaluate("() => window.cotouch.stage.probe().orbit.axes()[0].toArray()")
        )
        moved = np.array(here.api.pointers[-1][1].target) - before
        assert moved @ right > 0.9 * np.linalg.norm(moved) > 0.0
        commanded = page.evaluate("() => window.told")
        assert {one["kind"] for one in commanded} == {"dual-rumble"}
        for one in commanded:
            assert one["strongMagnitude"] == pytest.approx(one["weakMagnitude"] ** 2)
            assert 0.0 < one["weakMagnitude"] <= 1.0
        pad(page, axes=[0, 0, 0, 0], buttons=[{"pressed": False}])
        wait(page, lambda: here.api.pointers[-1][1].mode == "free")


@pytest.mark.parametrize("kind", ["bare", "2d"])
def test_nodes_and_the_edges_between_them_are_drawn(running: Browser, kind: Kind) -> None:
    with shown(running, kind) as here:
        page = here.open()
        drawn = page.evaluate(
            """() => {
                const { body } = [...window.cotouch.stage.probe().space.copies.values()][0];
                return body.children.filter(({ visible }) => visible).map(
                    ({ type, geometry }) => [type, (geometry.index ?? geometry.attributes.position).count]);
            }"""
        )
        nodes, edges = here.api.scene.body.nodes, page.evaluate("() => window.cotouch.store.scene.edges.length")
        assert edges >= 2 * (nodes - 1)
        assert drawn == [["Points", nodes], ["LineSegments", edges]]


@pytest.mark.parametrize("calm", ["reduce", "no-preference"])
def test_who_asked_for_less_motion_is_where_he_turned_to_at_once(running: Browser, calm: Any) -> None:
    with shown(running) as here:
        page = here.open(reduced_motion=calm)
        soon, end = map(np.array, page.evaluate(TURNED))
        assert (np.abs(soon - end).max() < 1e-9) == (calm == "reduce")


# Which triangles of each other's copy are drawn over one's own, as a share of all.
OVER = """() => [...window.cotouch.stage.probe().space.copies.values()].slice(1).map(
  ({ moving, shell }) => shell.visible ? moving.film.drawRange.count / moving.shape.triangles.length : 0)"""
# Stretch and displacement are different numbers; plain is neither.
BY = "colour => { window.cotouch.store.set({ colour }); return window.cotouch.stage.probe().space.common.by.value; }"


def test_of_a_ghost_only_what_differs_is_drawn(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        until(page, "store.frame.copies.every(copy => copy.displacement.every(d => d === 0))")
        page.wait_for_function(f"() => ({OVER})().every((share) => share === 0)")
        for slot in range(1, 5):
            here.api.do(MoveHand(slot=slot, mode="pull", node=3, to=(0.2, 0.2, 0.2)))
        page.wait_for_function(f"() => ({OVER})().every((share) => share > 0.02 && share < 0.9)")
        page.evaluate("() => window.cotouch.store.set({ ghosts: false })")
        page.wait_for_function(f"() => ({OVER})().every((share) => share === 0)")


def test_what_is_drawn_can_be_chosen(running: Browser) -> None:
    with shown(running, still=False) as here:
        page = here.open()
        assert [page.evaluate(BY, colour) for colour in ("displacement", "stress", "plain")] == [0, 1, 2]
        page.wait_for_selector(".ct-legend", state="hidden")  # with the next picture
        page.evaluate(BY, "stress")
        page.wait_for_function("() => /stretch.*%/.test(document.querySelector('.ct-legend').textContent)")
        page.evaluate(BY, "displacement")
        page.wait_for_function("() => /displacement.*m$/.test(document.querySelector('.ct-legend').textContent)")


def test_the_picture_gets_coarser_where_it_is_late_and_finer_where_it_is_not(running: Browser) -> None:
    with shown(running) as here:
        page = here.open()
        ratios = page.evaluate(
            """() => {
                const quality = new (window.cotouch.stage.probe().space.quality.constructor)(() => 1);
                const after = (count, skipped, seconds) => {
                    for (let k = 0; k < count; k++) quality.took(skipped, seconds);
                    return quality.ratio;
                };
                // In time; two clocks that drift; a slow server; late; late for ever; in time again, for long.
                return [after(100, 0, 0.017), after(100, 1, 0.017), after(100, 0, 0.034), after(24, 2, 0.05),
                        after(1000, 2, 0.05), after(20000, 0, 0.017), after(60000, 0, 0.017)];
            }"""
        )
        assert ratios[:5] == [1, 1, 1, 0.75, 0.4]
        assert 0.4 < ratios[5] <= ratios[6] == 1


@pytest.mark.parametrize(("wide", "high"), [(844, 390), (667, 375), (390, 400), (360, 640)])
def test_every_window_has_a_picture(running: Browser, wide: int, high: int) -> None:
    with shown(running) as here:
        page = here.open(viewport={"width": wide, "height": high})
        size = page.evaluate(
            "() => (b => [b.width, b.height])(document.querySelector('.ct-canvas').getBoundingClientRect())"
        )
        assert size[0] >= 200
        assert size[1] >= 180
        assert np.isfinite(spot(page)[:2]).all()
        assert page.evaluate("() => document.documentElement.scrollWidth") <= wide
        name = page.locator(".tabs button").first.bounding_box()
        assert name is not None
        assert name["x"] + name["width"] <= wide


def test_nobody_zooms_into_the_object(running: Browser) -> None:
    """The eye stays outside of the ball around all that is shown, wherever it looks."""
    with shown(running) as here:
        page = here.open(viewport={"width": 500, "height": 400})
        far = """() => { const { stage, store } = window.cotouch, eye = stage.probe().orbit.camera.position;
            return Math.hypot(...store.scene.centre.map((x, i) => eye.getComponent(i) - x)) / store.scene.radius; }"""
        assert page.evaluate(far) > 2.0
        page.evaluate(
            """() => { const { orbit } = window.cotouch.stage.probe();
                for (let k = 0; k < 60; k++) orbit.zoom(0.8);
                while (orbit.step(1)); }"""
        )
        near = page.evaluate(far)
        assert 1.0 < near < 1.3
        page.evaluate(
            """() => { const { orbit } = window.cotouch.stage.probe();
                orbit.pan(300, 100, 400); orbit.turn(900, 0);
                while (orbit.step(1)); }"""
        )
        assert page.evaluate(far) > 1.0
        page.evaluate(
            """() => { const { orbit } = window.cotouch.stage.probe(); orbit.zoom(1.5); while (orbit.step(1)); }"""
        )
        assert page.evaluate(far) > near


def test_what_stands_around_is_drawn_where_it_is(running: Browser) -> None:
    wall, box = Plane((0.5, 0.0, 0.0), (-2.0, 0.0, 0.0)), Box((0.1, 0.2, 0.3), (0.0, 0.6, 0.1))
    with shown(running, shapes=(Plane((0.0, 0.0, -0.4)), wall, box)) as here:
        page = here.open()
        floor, places = page.evaluate(
            """() => { const { ground, obstacles } = window.cotouch.stage.probe().space;
                return [ground.mesh.position.z, obstacles.group.children.map((one) => one.position.toArray())]; }"""
        )
    sheet, solid, edges = np.array(places)
    assert floor == -0.4
    assert sheet[0] == pytest.approx(0.5)
    np.testing.assert_array_equal(solid, [0.0, 0.6, 0.1])
    np.testing.assert_array_equal(edges, solid)
