"""Who only watches sees everybody, members behind NATs too, and keeps no more than it can."""

import numpy as np
from tests.session.world import World, entropy

from cotouch.control import SignedMessage
from cotouch.members import Entry, Roster, SessionWatch, Status, write_message
from cotouch.samples import Identity

THREE = """
[session]
users = 3
spring = 60.0
[steps]
rate = 50
"""


def watched(world: World) -> tuple[SessionWatch, Identity]:
    identity = Identity.make(entropy(99))
    control = world.controls.join(identity)
    return SessionWatch(control, host=world.host_identity.public), identity


def said(entry: Entry, status: Status) -> SignedMessage:
    return SignedMessage(bytes.fromhex(entry.key), "status", write_message(status), direct=False)


def tell(watch: SessionWatch, entry: Entry, status: Status, now: float) -> None:
    """Somebody who is alone in the session says something of itself."""
    watch.follow(Roster(members=[entry]), now)
    watch.receive(said(entry, status), frozenset(), now)


def test_members_that_a_watcher_cannot_reach_are_handed_on_by_the_host() -> None:
    world = World(THREE, tick=2e-3)
    people = [world.join(name, moves=False) for name in ("Ann", "Ben", "Cleo")]
    watch, identity = watched(world)
    for hidden in people[1:]:
        world.controls.cut(identity.public, hidden.identity.public)
    for _ in range(100):
        world.run(0.05)
        watch.service(world.now)
    assert {seen.entry.name for seen in watch.members.values()} == {"Ann", "Ben", "Cleo"}
    for slot, seen in watch.members.items():
        assert seen.status is not None
        assert seen.status.slot == slot
        assert seen.status.steps > 0
        assert not seen.stale(world.now)
    assert set(watch.paths()) == {(0, 1), (0, 2), (1, 2)}
    # Only while it watches: members do not need it.
    said, send = list[str](), world.host_control.send
    world.host_control.send = lambda topic, body, *, to=None: (said.append(topic), send(topic, body, to=to))[1]
    world.run(2.0)
    assert "seen" in said
    world.controls.kill(identity.public)
    world.run(3.0)
    said.clear()
    world.run(2.0)
    assert "seen" not in said


def test_only_the_host_hands_on_and_what_is_heard_directly_counts() -> None:
    world = World(THREE, tick=2e-3)
    people = [world.join(name, moves=False) for name in ("Ann", "Ben", "Cleo")]
    watch, identity = watched(world)
    for _ in range(60):
        world.run(0.05)
        watch.service(world.now)
    present = frozenset(person.identity.public for person in people)
    seen = watch.members[1]
    before = seen.status
    assert before is not None
    lie = before.model_copy(update={"steps": 10**9}).model_dump_json().encode()
    host, ann = world.host_identity.public, people[0].identity.public
    watch.receive(SignedMessage(host, "seen", lie, direct=True), present, world.now)
    assert seen.status == before
    hidden = present - {people[1].identity.public}
    watch.receive(SignedMessage(ann, "seen", lie, direct=True), hidden, world.now)
    assert seen.status == before
    watch.receive(SignedMessage(host, "seen", b"no status", direct=True), hidden, world.now)
    watch.receive(SignedMessage(host, "seen", lie, direct=True), hidden, world.now)
    assert seen.status is not None
    assert seen.status.steps == 10**9
    assert identity.public not in present


def test_names_are_remembered_only_so_many() -> None:
    world = World(THREE, tick=2e-3)
    world.join("Ann", moves=False)
    watch, _ = watched(world)
    for _ in range(60):
        world.run(0.05)
        watch.service(world.now)
    entry = watch.members[0].entry
    rng = np.random.default_rng(0)
    for k in range(400):
        tell(watch, entry.model_copy(update={"name": f"guest {k}"}), Status(slot=0, steps=int(rng.integers(9))), 0.0)
    assert len(watch.last) == 256
    assert "guest 399" in watch.last
    assert "guest 143" not in watch.last


def test_it_is_said_once_that_forces_and_energy_disagree() -> None:
    world = World(THREE, tick=2e-3)
    watch, _ = watched(world)
    entry = Entry(slot=0, name="Ann", key="0" * 64)
    for alarms in (0, 0, 2, 2, 5):
        tell(watch, entry, Status(slot=0, steps=9, closure_alarms=alarms), 0.0)
    texts = [event.text for event in watch.events if event.text != "Ann joined"]
    assert texts == ["ALARM: forces and energy of Ann's copy disagree; its steps are too long"]


def test_what_there_is_to_say_of_a_device_reaches_who_watches() -> None:
    world = World(THREE, tick=2e-3)
    ann = world.join("Ann", moves=False)
    watch, _ = watched(world)
    said = ["", "real-time priority was refused", "force is off", "force is off"]
    assert ann.member is not None
    ann.device = lambda: said.pop(0) if len(said) > 1 else said[0]
    for _ in range(100):
        world.run(0.05)
        watch.service(world.now)
    texts = [event.text for event in watch.events if "device" in event.text]
    assert texts == ["Ann's device: real-time priority was refused", "Ann's device: force is off"]


def test_it_knows_that_somebody_took_a_part_of_the_ledger_along() -> None:
    world = World(THREE, tick=2e-3)
    people = [world.join(name, moves=False) for name in ("Ann", "Ben")]
    watch, _ = watched(world)

    def look(seconds: float) -> None:
        for _ in range(round(seconds / 0.05)):
            world.run(0.05)
            watch.service(world.now)

    look(3.0)
    assert set(watch.members) == {0, 1}
    assert not watch.left
    again = watch.members[1].status
    assert again is not None
    began = again.model_copy(update={"steps": again.steps - 1})
    watch.receive(said(watch.members[1].entry, began), frozenset(), world.now)
    assert watch.left  # began anew
    watch.left = False
    world.leave(people[0])
    look(3.0)
    assert watch.left
    late = SessionWatch(world.controls.join(Identity.make(entropy(98))), host=world.host_identity.public)
    late.follow(watch.roster, world.now)
    assert late.left  # who came later knows it, too
