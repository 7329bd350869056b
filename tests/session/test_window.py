"""Members that are shown and told things by boards, on a virtual clock."""

from pathlib import Path

import numpy as np
import pytest
from tests.session.world import World

from cotouch.recording import audit, read_recording
from cotouch.session import Emulated, Pointer
from cotouch.session._boards import RUNAWAY, BoardFolder

SESSION = """
[session]
users = 2
spring = 60.0
[body]
mass = 0.4
[steps]
rate = 250
"""


CHAIN = SESSION.replace(
    "mass = 0.4",
    'kind = "chain"\nnodes = 2\nspacing = 0.1\ndimension = 1\nmass = 0.4\nstiffness = 50.0\nground = [1]\n'
    "ground_stiffness = 30.0",
)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return made(SESSION, tmp_path)


def made(text: str, tmp_path: Path) -> World:
    (tmp_path / "recordings").mkdir()
    made = World(text, tick=1e-3, boards=BoardFolder(tmp_path))
    for name in made.session.scenario.network.users:
        made.join(name)
    made.until(made.all_coupled, 12.0)
    return made


def told(world: World, name: str):
    assert world.desk is not None
    return world.desk


def test_a_drag_moves_this_copy_then_the_other_and_ends(world: World) -> None:
    one, other = world.people
    desk = told(world, one.name)
    start = world.now
    moved: dict[int, float] = {}
    force = 0.0
    for n in range(150):
        desk.point(one.name, Pointer(number=n + 1, mode="grab", node=0, target=(0.08, 0.0, 0.0)))
        world.run(0.01)
        views = desk.views()
        assert views[0].heard == n + 1
        force = max(force, float(views[0].hands[0].force[0]))
        for seat, view in views.items():
            if abs(float(view.displacement[0, 0])) > 0.005:
                moved.setdefault(seat, world.now - start)
    assert moved[0] + 0.005 < moved[1]
    views = desk.views()
    hand = views[0].hands[0]
    assert (hand.mode, hand.node) == ("grab", 0)
    assert hand.target[0] == pytest.approx(0.08, abs=1e-4)
    assert hand.place[0] == pytest.approx(one.position[0, 0], abs=1e-6)
    assert force > 1.0
    for person in (one, other):
        view = views[person.copy.seat]
        assert view.direct
        assert view.displacement == pytest.approx(person.position, abs=1e-7)
        totals = person.copy.totals
        assert (view.supplied, view.lost, view.linked, view.energy) == (
            totals.supplied,
            totals.lost,
            totals.linked,
            totals.energy,
        )
    desk.point(one.name, Pointer(number=151, mode="free", node=0, target=(0.0, 0.0, 0.0)))
    world.run(0.5)
    assert np.linalg.norm(desk.views()[0].hands[0].force) == 0.0
    world.check()


def test_a_pointer_shows_in_the_view_of_the_step_that_used_it(tmp_path: Path) -> None:
    """Of a body whose views are fewer than its steps."""
    text = CHAIN.replace("nodes = 2", "nodes = 66").replace("rate = 250", "rate = 1000")
    world = made(text, tmp_path)
    name = world.people[0].name
    desk = told(world, name)
    for n in range(1, 20):
        desk.point(name, Pointer(number=n, mode="grab", node=3, target=(0.001 * n, 0.0, 0.0)))
        world.run(0.002 + 0.001 * (n % 3))
        assert desk.views()[0].heard == n
    # And without any it is one in eight again.
    world.run(0.05)
    seen = set[int]()
    for _ in range(80):
        world.run(0.001)
        seen.add(desk.number(name, "step"))
    assert len(seen) > 5
    assert max(seen) - min(seen) == 8 * (len(seen) - 1)


def test_of_a_copy_that_is_not_shown_a_neighbour_tells_what_it_knows(world: World) -> None:
    one, other = world.people
    desk = told(world, one.name)
    desk.hand(one.name, "wander")
    world.run(2.0)
    world.kill(other)
    world.run(0.1)
    ghost = desk.views()[other.copy.seat]
    assert not ghost.direct
    assert ghost.time < desk.views()[one.copy.seat].time
    assert ghost.displacement == pytest.approx(other.position, abs=0.01)
    assert desk.number(other.name, "seat") == -1


def test_a_cut_path_guards_both_ends_and_a_longer_one_is_agreed_on_anew(world: World) -> None:
    one, other = world.people
    desk = told(world, one.name)
    for to, of in ((0, 1), (1, 0)):
        desk.impair(to, of, cut=1.0)
    world.run(1.0)
    assert set(one.states().values()) == set(other.states().values()) == {"guarded"}
    assert desk.emulated()[0, 1] == Emulated(cut=True)
    for to, of in ((0, 1), (1, 0)):
        desk.impair(to, of, cut=0.0, delay=0.08)
    world.until(world.all_coupled, 15.0)
    budget = one.copy.status(world.now).links[0].budget
    assert budget is not None
    assert budget > 0.16
    ages = one.copy.peer and [link.age for link in one.copy.status(world.now).links]
    assert ages
    assert ages[0] is not None
    assert ages[0] > 0.08
    world.check()


def test_without_its_damping_a_session_runs_away_is_caught_and_settles(world: World) -> None:
    one, _ = world.people
    desk = told(world, one.name)
    for to, of in ((0, 1), (1, 0)):
        desk.impair(to, of, delay=0.06)
    world.run(1.0)
    world.until(world.all_coupled, 15.0)
    desk.hand(one.name, "pull", to=(0.05, 0.0, 0.0))
    world.run(0.3)
    desk.hand(one.name, "free")
    world.run(0.2)
    quiet = sum(person.copy.totals.energy for person in world.people)
    desk.damping(0.02)
    world.run(0.1)
    assert [person.copy.damping_share for person in world.people] == [0.02, 0.02]
    certificate = one.copy.status(world.now).certificate
    assert certificate == pytest.approx(-0.98)
    most = 0.0
    for _ in range(200):
        world.run(0.05)
        most = max(most, sum(person.copy.totals.energy for person in world.people))
        if any(desk.number(person.name, "caught") for person in world.people):
            break
    assert most > 100.0 * quiet
    caught = [person for person in world.people if desk.number(person.name, "caught")]
    assert caught
    assert all(person.copy.damping_share == 1.0 for person in caught)
    assert max(float(np.abs(person.position).max()) for person in caught) > 0.5 * RUNAWAY * 0.1
    desk.damping(1.0)
    world.run(8.0)
    assert sum(person.copy.totals.energy for person in world.people) < 1e-3 * most
    assert world.all_coupled()
    assert one.copy.status(world.now).certificate == pytest.approx(0.0)
    assert all(person.copy.totals.alarms == 0 for person in world.people)


def test_who_may_not_lower_the_damping_does_not(world: World) -> None:
    for person in world.people:
        assert person.window is not None
        person.window._unsafe = False
    told(world, "").damping(0.02)
    world.run(0.5)
    assert [person.copy.damping_share for person in world.people] == [1.0, 1.0]


def test_a_recording_begins_and_ends_while_everybody_moves_and_holds(tmp_path: Path) -> None:
    world = made(CHAIN, tmp_path)
    one, other = world.people
    desk = told(world, one.name)
    desk.hand(one.name, "wander", node=0)
    world.run(1.0)
    desk.record(1)
    world.run(0.5)
    assert {desk.number(person.name, "recording") for person in world.people} == {1}
    desk.point(other.name, Pointer(number=1, mode="grab", node=1, target=(0.15, 0.0, 0.0)))
    world.run(0.8)
    desk.record(0)
    for _ in range(100):
        world.run(0.05)
        if not any(desk.number(person.name, "recording") for person in world.people):
            break
    assert world.boards is not None
    files = world.boards.recordings(1)
    assert len(files) == 2
    recordings = [read_recording(path) for path in files]
    result = audit(recordings)
    assert result.holds, result.verdict
    assert all(recording.steps > 250 for recording in recordings)
    world.run(0.3)
    assert [path for path in world.boards.recordings(1) if path not in files] == []


def test_views_come_after_every_step_of_a_small_body(world: World) -> None:
    one, _ = world.people
    before = told(world, one.name).number(one.name, "step")
    world.run(0.2)
    assert one.copy.peer is not None
    assert told(world, one.name).number(one.name, "step") == one.copy.peer.steps > before
