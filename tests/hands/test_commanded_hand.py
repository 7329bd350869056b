"""A hand that is told what to do: where it draws to, that it never jerks, and that the ledger stays exact."""

import numpy as np
import pytest
import trimesh
from tests.body.shapes import sphere
from tests.session.hands import BODIES, Held, scenario

from cotouch.observers import HAND_MODES, size_of
from cotouch.scenario import resolve_penetration

SCRIPT = """
[[hands]]
user = 1
node = 1
path = {path}
stiffness = 60.0
damping = 2.0
"""


STYLUS = """
[[tools]]
user = 1
at = [0.0, 0.0, 0.2]
axis = {axis}
radius = 0.004
"""


TURNING = (
    '[body]\nkind = "lattice"\nshape = [4, 3, 3]\nspacing = 0.03\nmass = 0.5\nstiffness = 80\ndamping = 1\n'
    'model = "cells"\nground = "x-"\nground_stiffness = 80.0\n[world]\ngravity = [0.0, 0.0, -3.0]'
)


def held(body: str) -> Held:
    axes = scenario(body).build_body().dimension
    path = [[0, *[0] * axes], [0.2, *[0.03] * axes]]
    return Held(scenario(body, SCRIPT.format(path=path)))


@pytest.fixture(scope="module")
def cushion_body(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("body") / "cushion.stl"
    corners, triangles = sphere(3)
    trimesh.Trimesh(corners * [0.06, 0.045, 0.035], triangles, process=False).export(path)
    return (
        f'[body]\nfile = "{path}"\nunit = "m"\nresolution = 5\nmodel = "elastic"\nyoung = 1e4\npoisson = 0.35\n'
        "density = 250\nrayleigh_mass = 1.0\nrayleigh_stiffness = 0.01\nground_stiffness = 20\nmodes = 20\n"
        "ground = {box = {low = [-1, -1, -1], high = [1, 1, -0.02]}}"
    )


@pytest.mark.parametrize("body", [*BODIES, "cushion"])
def test_any_node_is_drawn_to_where_the_pointer_is(body: str, cushion_body: str) -> None:
    copy = held(cushion_body if body == "cushion" else body)
    node = copy.body.nodes // 2
    rest, axes = copy.body.rest[node], copy.body.dimension
    before = float(np.linalg.norm(copy.moved(node)))
    goal = np.zeros(3)
    goal[:axes] = rest + 0.4 * size_of(copy.body)
    for n in range(50):
        copy.tell("grab", node, goal, pointer=n + 1, stiffness=600.0)
        copy.run(0.02)
    reached = copy.moved(node) - (goal[:axes] - rest)
    assert np.linalg.norm(reached) < 0.5 * 0.4 * size_of(copy.body) * np.sqrt(axes)
    assert np.linalg.norm(copy.moved(node)) > 5.0 * before
    assert copy.hand.nodes[-1] == node
    assert copy.hand.received == 50
    copy.tell("free")
    copy.run(1.5)
    assert np.linalg.norm(copy.moved(node)) < 0.5 * np.linalg.norm(goal[:axes] - rest)
    assert not copy.hand.ports.stiffness.any()
    assert copy.worst < 1e-11


@pytest.mark.parametrize("body", [*BODIES, "cushion"])
def test_books_stay_exact_whatever_it_is_told(body: str, cushion_body: str) -> None:
    copy = held(cushion_body if body == "cushion" else body)
    rng = np.random.default_rng(7)
    copy.run(0.3)
    used = set[str]()
    for _ in range(40):
        mode = HAND_MODES[rng.integers(len(HAND_MODES))]
        target = np.zeros(3)
        target[: copy.body.dimension] = rng.uniform(-0.2, 0.2, copy.body.dimension)
        copy.tell(mode, int(rng.integers(copy.body.nodes)), target, 1, radius=float(rng.uniform(0.01, 0.04)))
        copy.run(float(rng.uniform(0.004, 0.1)), length=float(rng.uniform(0.001, 0.004)))
        used.add(copy.hand.mode)
    assert used >= {"script", "free", "hold", "pull", "wander", "grab"}
    assert ("ball" in used) == (copy.body.skin is not None)
    assert copy.worst < 1e-10


def test_a_blade_cuts_where_it_is_led_and_nowhere_before() -> None:
    light = TURNING.partition("[world]")[0]
    copy = Held(scenario(light, "[cutting]"))
    cuts, material = copy.peer.cuts, copy.body.material
    assert cuts is not None
    assert material is not None
    middle = copy.body.rest[material.elements].mean(axis=1)
    # It lies along y, above the body, and comes down at x = 45 mm.
    top, edge = copy.body.rest[:, 2].max(), (0.0, 0.2, 0.0)
    above, through = (0.045, -0.07, top + 0.03), (0.045, -0.07, -0.03)
    for n in range(10):
        copy.tell("blade", -1, above, n + 1, edge=edge)
        copy.run(0.02)
    assert not cuts.by.any()
    copy.tell("blade", -1, above, 20, edge=(0.0, 0.0, -1.0))  # the tip comes in where it was put down
    copy.run(0.3)
    assert cuts.by.any()
    fresh = Held(scenario(light, "[cutting]"))
    fresh.tell("cut", -1, through, start=above, edge=edge)
    fresh.run(1.0)
    assert fresh.peer.cuts is not None
    slab = np.abs(middle[:, 0] - 0.045) < 0.016
    assert np.array_equal(fresh.peer.cuts.by > 0, slab)
    assert fresh.hand.mode == "cut"  # nobody's pointer: silence does not end it
    fresh.tell("free")
    fresh.run(0.5)
    assert fresh.hand.tools is not None
    fresh.tell("cut", -1, above, start=above, edge=(0.0, 0.0, 900.0))  # as far as a command may say
    fresh.run(0.05)
    size = np.linalg.norm(copy.body.rest - copy.body.rest.mean(axis=0), axis=1).max()
    assert 0.0 < np.linalg.norm(fresh.hand.tools.axis) <= 4.0 * size * 1.001
    fresh.tell("free")
    fresh.run(0.5)
    assert np.abs(fresh.hand.tools.rate).max() < 1e-3
    for one in (copy, fresh):
        assert one.worst < 1e-10
    nobody = Held(scenario(light, "[cutting]\nusers = []"))
    nobody.tell("cut", -1, through, start=above, edge=edge)
    nobody.run(0.2)
    assert nobody.hand.mode == "free"


@pytest.mark.parametrize("body", ["point", "plane", "modal"])
def test_it_never_jerks(body: str) -> None:
    """The pointer begins a step's length away from the node, and leaps; modes change at any moment."""
    copy = held(body)
    rng = np.random.default_rng(3)
    copy.run(0.3)
    copy.forces.clear()
    for _ in range(60):
        mode = HAND_MODES[rng.integers(len(HAND_MODES) - 1)]
        target = np.zeros(3)
        target[: copy.body.dimension] = rng.uniform(-0.3, 0.3, copy.body.dimension)
        copy.tell(mode, int(rng.integers(copy.body.nodes)), target, 1)
        copy.run(float(rng.uniform(0.01, 0.2)))
    most = float(np.linalg.norm(copy.forces, axis=1).max())
    assert most > 2.0
    assert copy.jerk() < 0.15 * most


def test_a_grab_begins_where_the_node_is() -> None:
    copy = Held(scenario("point"))
    copy.run(0.1)
    copy.tell("grab", 0, (0.3, 0.0, 0.0), 1, stiffness=200.0)
    copy.run(0.02)
    assert 0.0 < float(copy.force()[0]) < 1.0  # of 60 N that a spring to the pointer would have
    copy.run(0.5)
    assert max(float(force[0]) for force in copy.forces) > 5.0


def test_hold_keeps_what_is_held_where_it_is_and_script_goes_on_at_the_present_time() -> None:
    path = [[0, 0], [1.0, 0.1], [2.0, -0.1]]
    copy = Held(scenario("point", SCRIPT.format(path=path)))
    copy.run(1.0)
    there = copy.moved(0).copy()
    copy.tell("hold")
    copy.run(1.5)
    away = abs(float(copy.moved(0)[0] - there[0]))
    assert away < 0.4 * abs(float(there[0]))
    assert copy.hand.mode == "hold"
    copy.tell("script")
    copy.run(3.0)
    undisturbed = Held(scenario("point", SCRIPT.format(path=path)))
    undisturbed.run(5.5)
    assert copy.moved(0) == pytest.approx(undisturbed.moved(0), abs=1e-3)
    assert float(copy.moved(0)[0]) < 0.0


def test_pull_goes_there_and_wander_stays_about() -> None:
    copy = held("solid")
    goal = copy.body.rest[35] + [0.0, 0.0, 0.03]
    copy.tell("pull", 35, goal)
    copy.run(2.0)
    assert copy.moved(35)[2] > 0.01
    copy.tell("wander")
    seen = []
    for _ in range(20):
        copy.run(0.2)
        seen.append(copy.moved(35).copy())
    spread = np.ptp(seen, axis=0)
    assert (spread > 0.002).all()
    assert (np.abs(seen) < size_of(copy.body)).all()


def test_a_pointer_that_is_not_heard_of_for_a_second_lets_go() -> None:
    copy = held("point")
    copy.tell("grab", 0, (0.05, 0, 0), 1)
    copy.run(0.9)
    assert copy.hand.mode == "grab"
    copy.tell("grab", 0, (0.05, 0, 0), 2)
    copy.run(0.9)
    assert copy.hand.mode == "grab"
    copy.run(0.2)
    assert copy.hand.mode == "free"
    copy.run(0.2)
    assert not copy.hand.ports.stiffness.any()
    copy.tell("hold")
    copy.run(1.5)
    assert copy.hand.mode == "hold"


def test_a_ball_pushes_the_skin_and_lets_go() -> None:
    copy = held("solid")
    top = int(np.argmax(copy.body.rest @ [1.0, 0.1, 1.0]))
    start = copy.body.rest[top] + [0.0, 0.0, 0.05]
    for n in range(60):
        copy.tell("ball", -1, start - [0.0, 0.0, 0.001 * n], n + 1, radius=0.015)
        copy.run(0.016)
    assert copy.moved(top)[2] < -0.002
    assert copy.force()[2] < -0.05
    fields = {
        "received": np.zeros((), int),
        "hands": np.zeros((), int),
        "mode": np.zeros(2, int),
        "node": np.zeros(2, int),
    }
    fields |= {name: np.zeros((2, 3)) for name in ("target", "place", "force", "edge")} | {"radius": np.zeros(2)}
    copy.hand.show(fields)
    assert HAND_MODES[fields["mode"][0]] == "ball"
    assert fields["force"][0] == pytest.approx(copy.force())
    assert fields["radius"][0] == pytest.approx(0.015)
    assert fields["place"][0, 2] > copy.body.rest[top, 2]
    copy.tell("free")
    copy.run(2.0)
    assert copy.moved(top)[2] == pytest.approx(0.0, abs=5e-4)
    assert copy.force() == pytest.approx(0.0)
    assert copy.worst < 1e-10


def test_of_a_stylus_the_tip_is_shown_too() -> None:
    axis = [0.02, 0.0, -0.01]
    copy = Held(scenario("solid", STYLUS.format(axis=axis)))
    copy.run(0.01)
    fields = {name: np.zeros((2, 3)) for name in ("target", "place", "force", "edge")} | {"radius": np.zeros(2)}
    fields |= {name: np.zeros(2, int) for name in ("mode", "node")}
    copy.hand.show({**fields, "received": np.zeros((), int), "hands": np.zeros((), int)})
    assert HAND_MODES[fields["mode"][0]] == "script"
    assert fields["radius"][0] == pytest.approx(0.004)
    assert fields["edge"][0] == pytest.approx(axis)


def test_a_ball_that_is_put_into_the_body_begins_outside_and_pushes() -> None:
    copy = held("solid")
    copy.tell("ball", -1, copy.body.rest.mean(axis=0), 1, radius=0.01)
    copy.run(0.002)
    assert copy.hand.tools is not None
    place = copy.hand.tools.place[-1, :3].copy()
    low, high = copy.body.rest.min(axis=0), copy.body.rest.max(axis=0)
    assert ((place < low) | (place > high)).any()
    for n in range(40):
        copy.tell("ball", -1, copy.body.rest.mean(axis=0), 2 + n, radius=0.01)
        copy.run(0.016)
    assert np.linalg.norm(copy.force()) > 0.05
    place = copy.hand.tools.place[-1, :3]
    assert resolve_penetration(copy.body, copy.positions(), place, 0.002, 0) is None  # its middle is not in it


def test_a_ball_that_grows_while_it_touches_by_a_law_gives_no_energy() -> None:
    """Its radius is another from step to step; the ledger of a heavy body that turns is exact all the same."""
    copy, rng = held(TURNING), np.random.default_rng(3)
    start = copy.body.rest.mean(axis=0) + np.array([0.0, 0.0, 0.04])
    pressed = 0.0
    for n in range(150):
        goal = start + rng.normal(scale=0.01, size=3)
        copy.tell("ball", -1, goal, n + 1, radius=float(rng.uniform(0.01, 0.04)))
        report = copy.run(0.016)
        assert report.touch_loss >= 0.0
        pressed = max(pressed, report.touch_stored)
    assert pressed > 1e-5
    assert copy.worst < 1e-13


def test_what_a_body_without_skin_cannot_do_frees_it() -> None:
    copy = held("point")
    copy.tell("ball", -1, (0, 0, 0), 1)
    copy.run(0.01)
    assert copy.hand.mode == "free"


def test_a_ball_that_nobody_uses_stays_where_it_is() -> None:
    copy = held("solid")
    tools = copy.hand.tools
    assert tools is not None
    before = tools.place.copy()
    report = copy.run(0.1)
    assert (tools.place == before).all()
    assert report.proxy == 0.0
    goal = copy.body.rest.max(axis=0) + 0.2
    for n in range(20):
        copy.tell("ball", -1, goal + np.array([0.02 * n, 0.0, 0.0]), n + 1, radius=0.015)
        copy.run(0.016)
    copy.tell("free")
    copy.run(0.5)
    before = tools.place.copy()
    report = copy.run(0.5)
    assert tools.place == pytest.approx(before, abs=1e-4)
    assert report.proxy < 1e-9
    assert copy.worst < 1e-11
