"""Members that are shown and told things by mailboxes, on a virtual clock."""

from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest
from tests.session.world import Person, World

from cotouch.mailbox import MailboxReader
from cotouch.observers import Emulated, MailboxFolder, Pointer
from cotouch.recording import audit, read_recording

SESSION = """
[session]
users = 2
spring = 60.0
[body]
mass = 0.4
[steps]
rate = 250
"""


SPRINGS = '[synchronisation]\nlaw = "spring"\n'
CHAIN = SESSION.replace(
    "mass = 0.4",
    'kind = "chain"\nnodes = 2\nspacing = 0.1\ndimension = 1\nmass = 0.4\nstiffness = 50.0\nground = [1]\n'
    "ground_stiffness = 30.0",
)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return made(SESSION, tmp_path)


def made(text: str, tmp_path: Path, *, unsafe: bool = True) -> World:
    (tmp_path / "recordings").mkdir()
    made = World(text, tick=1e-3, mailboxes=MailboxFolder(tmp_path), unsafe=unsafe)
    for name in made.session.scenario.network.users:
        made.join(name)
    made.until(made.all_coupled, 12.0)
    return made


def commanded(world: World, name: str):
    assert world.commands is not None
    return world.commands


def test_a_drag_moves_this_copy_then_the_other_and_ends(world: World) -> None:
    one, other = world.people
    commands = commanded(world, one.name)
    start = world.now
    moved: dict[int, float] = {}
    force = 0.0
    for n in range(150):
        commands.point(one.name, Pointer(number=n + 1, mode="grab", node=0, target=(0.08, 0.0, 0.0)))
        world.run(0.01)
        views = commands.views()
        assert views[0].received == n + 1
        force = max(force, float(views[0].hands[0].force[0]))
        for slot, view in views.items():
            if abs(float(view.displacement[0, 0])) > 0.005:
                moved.setdefault(slot, world.now - start)
    assert moved[0] + 0.005 < moved[1]
    views = commands.views()
    hand = views[0].hands[0]
    assert (hand.mode, hand.node) == ("grab", 0)
    assert hand.target[0] == pytest.approx(0.08, abs=1e-4)
    assert hand.place[0] == pytest.approx(one.position[0, 0], abs=1e-6)
    assert force > 1.0
    for person in (one, other):
        view = views[person.copy.slot]
        assert view.direct
        assert view.displacement == pytest.approx(person.position, abs=1e-7)
        totals = person.copy.totals
        assert (view.supplied, view.lost, view.linked, view.energy) == (
            totals.supplied,
            totals.lost,
            totals.linked,
            totals.energy,
        )
    commands.point(one.name, Pointer(number=151, mode="free", node=0, target=(0.0, 0.0, 0.0)))
    world.run(0.5)
    assert np.linalg.norm(commands.views()[0].hands[0].force) == 0.0
    world.check()


def test_a_pointer_shows_in_the_view_of_the_step_that_used_it(tmp_path: Path) -> None:
    """Of a body whose views are fewer than its steps."""
    text = CHAIN.replace("nodes = 2", "nodes = 66").replace("rate = 250", "rate = 1000")
    world = made(text, tmp_path)
    name = world.people[0].name
    commands = commanded(world, name)
    for n in range(1, 20):
        commands.point(name, Pointer(number=n, mode="grab", node=3, target=(0.001 * n, 0.0, 0.0)))
        world.run(0.002 + 0.001 * (n % 3))
        assert commands.views()[0].received == n
    # And without any it is one in eight again.
    world.run(0.05)
    seen = set[int]()
    for _ in range(80):
        world.run(0.001)
        seen.add(commands.number(name, "step"))
    assert len(seen) > 5
    assert max(seen) - min(seen) == 8 * (len(seen) - 1)


def test_of_a_body_by_modes_every_copy_is_shown_as_it_is(tmp_path: Path) -> None:
    """Of what is worked out for all copies at once, each is its own."""
    text = '[solver]\nbasis = "modal"\n' + CHAIN.replace("nodes = 2", "nodes = 6").replace(
        "spring = 60.0", "spring = 5.0"
    )
    world = made(text, tmp_path)
    commands, peer = commanded(world, world.people[0].name), world.people[0].copy.peer
    assert peer is not None
    assert peer.model.modes is not None
    for n, person in enumerate(world.people):
        way = (0.05 - 0.1 * n, 0.0, 0.0)
        commands.point(person.name, Pointer(number=1, mode="grab", node=5, target=way))
    world.run(0.3)
    views, places = commands.views(), [person.position for person in world.people]
    assert np.abs(places[0] - places[1]).max() > 0.01
    for person in world.people:
        assert views[person.copy.slot].displacement == pytest.approx(person.position, abs=1e-6)


def test_of_a_copy_that_is_not_shown_a_neighbour_tells_what_it_knows(world: World) -> None:
    one, other = world.people
    commands = commanded(world, one.name)
    commands.hand(one.name, "wander")
    world.run(2.0)
    world.kill(other)
    world.run(0.1)
    ghost = commands.views()[other.copy.slot]
    assert not ghost.direct
    assert ghost.time < commands.views()[one.copy.slot].time
    assert ghost.displacement == pytest.approx(other.position, abs=0.01)
    assert commands.number(other.name, "slot") == -1


def test_over_a_cut_path_nothing_is_heard(world: World) -> None:
    """And what copies exchange by the default law goes on where it was."""
    one, other = world.people
    commands = commanded(world, one.name)
    for to, of in ((0, 1), (1, 0)):
        commands.impair(to, of, cut=1.0)
    world.run(1.0)
    assert set(one.states().values()) == set(other.states().values()) == {"waiting"}
    assert world.host is not None
    assert f"{one.name} receives nothing from {other.name}" in [event.text for event in world.host.watch.events]
    for to, of in ((0, 1), (1, 0)):
        commands.impair(to, of, cut=0.0, delay=0.08)
    world.until(world.all_coupled, 2.0)
    assert {link.budget for link in one.copy.status(world.now).links} == {None}


def test_a_cut_path_guards_both_ends_and_a_longer_one_is_agreed_on_anew(tmp_path: Path) -> None:
    world = made(SESSION + SPRINGS, tmp_path)
    one, other = world.people
    commands = commanded(world, one.name)
    for to, of in ((0, 1), (1, 0)):
        commands.impair(to, of, cut=1.0)
    world.run(1.0)
    assert set(one.states().values()) == set(other.states().values()) == {"guarded"}
    assert commands.emulated()[0, 1] == Emulated(cut=True)
    for to, of in ((0, 1), (1, 0)):
        commands.impair(to, of, cut=0.0, delay=0.08)
    world.until(world.all_coupled, 15.0)
    budget = one.copy.status(world.now).links[0].budget
    assert budget is not None
    assert budget > 0.16
    ages = one.copy.peer and [link.age for link in one.copy.status(world.now).links]
    assert ages
    assert ages[0] is not None
    assert ages[0] > 0.08
    world.check()


def test_without_its_damping_a_session_runs_away_is_caught_and_settles(tmp_path: Path) -> None:
    world = made(SESSION + SPRINGS, tmp_path)
    one, _ = world.people
    commands = commanded(world, one.name)
    for to, of in ((0, 1), (1, 0)):
        commands.impair(to, of, delay=0.06)
    world.run(1.0)
    world.until(world.all_coupled, 15.0)
    commands.hand(one.name, "pull", to=(0.05, 0.0, 0.0))
    world.run(0.3)
    commands.hand(one.name, "free")
    world.run(0.2)
    quiet = sum(person.copy.totals.energy for person in world.people)
    commands.damping(0.02)
    world.run(0.1)
    assert [person.copy.damping_fraction for person in world.people] == [0.02, 0.02]
    certificate = one.copy.status(world.now).damping_margin
    assert certificate == pytest.approx(-0.98)
    most = 0.0
    for _ in range(200):
        world.run(0.05)
        most = max(most, sum(person.copy.totals.energy for person in world.people))
        if any(commands.number(person.name, "caught") for person in world.people):
            break
    assert most > 100.0 * quiet
    caught = [person for person in world.people if commands.number(person.name, "caught")]
    assert caught
    assert all(person.copy.damping_fraction == 1.0 for person in caught)
    assert (
        max(float(np.abs(person.position).max()) for person in caught) > 0.1
    )  # half of what is too far: two radii of a point
    commands.damping(1.0)
    world.run(8.0)
    assert sum(person.copy.totals.energy for person in world.people) < 1e-3 * most
    assert world.all_coupled()
    assert one.copy.status(world.now).damping_margin == pytest.approx(0.0)
    assert all(person.copy.totals.alarms == 0 for person in world.people)


def test_who_may_not_lower_the_damping_does_not(tmp_path: Path) -> None:
    world = made(SESSION, tmp_path, unsafe=False)
    commanded(world, "").damping(0.02)
    world.run(0.5)
    assert [person.copy.damping_fraction for person in world.people] == [1.0, 1.0]


def test_a_recording_begins_and_ends_while_everybody_moves_and_holds(tmp_path: Path) -> None:
    world = made(CHAIN, tmp_path)
    one, other = world.people
    commands = commanded(world, one.name)
    commands.hand(one.name, "wander", node=0)
    world.run(1.0)
    commands.record(1, on=True)
    world.run(0.5)
    assert {commands.number(person.name, "recording") for person in world.people} == {1}
    commands.point(other.name, Pointer(number=1, mode="grab", node=1, target=(0.15, 0.0, 0.0)))
    world.run(0.8)
    commands.record(1, on=False)
    for _ in range(100):
        world.run(0.05)
        if not any(commands.number(person.name, "recording") for person in world.people):
            break
    assert world.mailboxes is not None
    files = world.mailboxes.recordings(1)
    assert len(files) == 2
    recordings = [read_recording(path) for path in files]
    result = audit(recordings)
    assert result.holds, result.verdict
    assert all(recording.steps > 250 for recording in recordings)
    world.run(0.3)
    assert [path for path in world.mailboxes.recordings(1) if path not in files] == []


def ended(world: World) -> None:
    """Waits until everybody said what became of the recording that was ordered last."""
    for _ in range(100):
        world.run(0.05)
        if not any(commanded(world, person.name).number(person.name, "recording") for person in world.people):
            return
    raise AssertionError("a recording did not end")


def test_the_shortest_recording_has_a_step(world: World) -> None:
    """It is over before any member heard of it."""
    commands = commanded(world, "")
    commands.record(1, on=True)
    commands.record(1, on=False)
    world.run(0.1)
    ended(world)
    assert world.mailboxes is not None
    files = world.mailboxes.recordings(1)
    assert len(files) == 2
    assert all(read_recording(path).steps >= 1 for path in files)
    for person in world.people:
        outcome = commands.outcome(person.name)
        assert outcome is not None
        assert (outcome.number, outcome.trouble) == (1, "")
        assert outcome.steps == read_recording(file_of(world, person)).steps


def file_of(world: World, person: Person) -> Path:
    """The one file of its first recording."""
    assert world.mailboxes is not None
    (path,) = (path for path in world.mailboxes.recordings(1) if unquote(path.name).startswith(f"{person.name}."))
    return path


def test_what_was_over_before_a_member_came_is_not_for_it(tmp_path: Path) -> None:
    (tmp_path / "recordings").mkdir()
    world = World(SESSION, tick=1e-3, mailboxes=MailboxFolder(tmp_path))
    assert world.commands is not None
    world.commands.record(1, on=True)
    world.commands.record(1, on=False)
    for name in world.session.scenario.network.users:
        world.join(name)
    world.until(world.all_coupled, 12.0)
    assert world.mailboxes is not None
    assert world.mailboxes.recordings(1) == []


def test_a_recording_that_is_taken_away_is_told_at_once_and_the_copy_moves_on(world: World) -> None:
    one, other = world.people
    commands = commanded(world, one.name)
    commands.record(1, on=True)
    world.run(0.5)
    assert world.mailboxes is not None
    assert other.member.status(world.now).recording == "on"
    file_of(world, one).unlink()
    for _ in range(200):
        world.run(0.02)
        outcome = commands.outcome(one.name)
        if outcome is not None:
            break
    assert outcome is not None
    assert outcome.trouble.endswith("the file was removed while it was written")
    assert commands.outcome(other.name) is None  # who has no trouble goes on
    before = commands.number(one.name, "step")
    world.run(0.2)
    assert commands.number(one.name, "step") > before
    commands.record(1, on=False)
    ended(world)
    outcome = commands.outcome(other.name)
    assert outcome is not None
    assert outcome.trouble == ""


def test_a_recording_that_cannot_be_made_is_told(world: World) -> None:
    one, _ = world.people
    assert world.mailboxes is not None
    (world.mailboxes.path / "recordings").rmdir()
    commanded(world, one.name).record(1, on=True)
    world.run(0.1)
    outcome = commanded(world, one.name).outcome(one.name)
    assert outcome is not None
    assert (outcome.steps, outcome.trouble) == (0, "was not started: No such file or directory")


def test_a_whole_part_that_is_not_recorded_any_more_is_in_the_status(tmp_path: Path) -> None:
    """And with whoever watches: the host makes an event of it."""
    world = World(SESSION, tick=1e-3, folder=tmp_path)
    for name in world.session.scenario.network.users:
        world.join(name)
    world.until(world.all_coupled, 12.0)
    one, other = world.people
    assert one.member.status(world.now).recording == "on"
    world.recordings[0].unlink()
    world.until(lambda: one.member.status(world.now).recording == "failed", 60.0)
    assert one.member.status(world.now).recording_failure == "the file was removed while it was written"
    world.run(1.5)
    assert world.host is not None
    texts = [event.text for event in world.host.watch.events if "recording" in event.text]
    assert texts == [f"ALARM: the recording of {one.name} stopped: the file was removed while it was written"]
    assert world.host.watch.members[other.copy.slot].status.recording == "on"
    assert one.session_recorder is not None
    one.session_recorder.close()
    assert one.session_recorder.trouble.startswith("ends after ")
    world.check()


def test_lowered_damping_is_back_where_nobody_says_any_more_that_it_holds(tmp_path: Path) -> None:
    """A process that shows the session may hang or die; members do not wait for it."""
    world = made(SESSION + SPRINGS, tmp_path)
    commands = commanded(world, "")
    commands.damping(0.5, until=world.now + 0.3)
    world.run(0.2)
    assert [person.copy.damping_fraction for person in world.people] == [0.5, 0.5]
    commands.hold_damping(world.now + 0.3)
    world.run(0.25)
    assert [person.copy.damping_fraction for person in world.people] == [0.5, 0.5]
    world.run(0.15)
    assert [person.copy.damping_fraction for person in world.people] == [1.0, 1.0]


def test_views_come_after_every_step_of_a_small_body(world: World) -> None:
    one, _ = world.people
    before = commanded(world, one.name).number(one.name, "step")
    world.run(0.2)
    assert one.copy.peer is not None
    assert commanded(world, one.name).number(one.name, "step") == one.copy.peer.steps > before


def test_a_view_says_how_long_the_last_step_was(world: World, tmp_path: Path) -> None:
    name = world.people[0].name
    view = MailboxReader(MailboxFolder(tmp_path).view(name)).read()
    assert view is not None
    assert float(view["period"]) == pytest.approx(1.0 / 250.0, rel=0.3)
