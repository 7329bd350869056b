"""What a neighbour says reaches nobody unbounded: where a newcomer begins, how much it damps, who is told of it."""

import numpy as np
import pytest
from tests.members.liar import Liar, Lie
from tests.session.chain import chain
from tests.session.world import Person, World

from cotouch.members import Status

LATTICE = """
[session]
users = 3
spring = 60.0
initial_energy = 1e-3
allowance = 0.2
power_limit = 2.0
[body]
kind = "lattice"
shape = [5, 4, 4]
spacing = 0.05
mass = 1.0
stiffness = 400.0
damping = 0.4
ground = "x-"
ground_stiffness = 400.0
[steps]
rate = 100
[synchronisation]
law = "spring"
"""


# What those who pay by themselves let liars do is in test_live_law.py.


def begun(person: Person) -> bool:
    return person.member.replica is not None and person.copy.peer is not None


@pytest.mark.parametrize("law", ["noise", "place"])
@pytest.mark.parametrize("third", [False, True])
def test_a_newcomer_begins_at_rest_whatever_a_neighbour_says(law: str, third: bool) -> None:
    """80 nodes told to be 9.9 m away, by one who was there first; an honest third one makes no difference."""
    world = World(LATTICE, tick=2.5e-3)
    Liar(world.join("Zoe", moves=False), Lie(first=True, since=0.0, law=law, size=9.9, pattern=1, state=2, seed=1))
    world.run(0.5)
    if third:
        world.join("Ann", moves=False)
        world.run(0.5)
    ben = world.join("Ben", moves=False)
    world.until(lambda: begun(ben), 3.0)
    start = world.now
    received = False
    while world.now < start + 1.5:
        world.run(0.05)
        totals = ben.copy.totals
        received |= any(held.connected for held in ben.copy.neighbours.values())
        assert totals.initial == 0.0
        # Its seeds, its allowance, and what the power limit lets through: at once, and since.
        allowed = ben.copy.initial_energies + len(ben.copy.neighbours) * 2.0 * (0.1 + world.now - start)
        assert totals.linked <= allowed
        assert 0.5 * float((ben.copy.peer.state.velocity**2).sum()) / 80.0 / 3.0 <= allowed
        assert ben.copy.initial_energies <= 2e-3 + 0.2 + 1e-12
    assert received
    assert ben.copy.totals.alarms == 0


@pytest.mark.parametrize("how", ["third", "second", "again"])
def test_a_newcomer_comes_to_where_a_deformed_object_is_held(how: str) -> None:
    """Nobody moves, so nobody has energy to give: what it takes is the newcomer's allowance, and no more of it."""
    coupled = {}
    for allowance in (1.0, 0.0):
        world = World(chain(more=f"allowance = {allowance}"), tick=2.5e-3)
        ann = world.join("Ann")
        if how != "second":
            ben = world.join("Ben", moves=False)
            world.until(world.all_coupled, 5.0)
        world.run(4.0)
        if how == "again":  # within the time in which nobody notices, so that no share changes
            world.kill(ben)
            world.run(0.5)
        held = float(ann.position[1, 0])
        new = world.join("Ben" if how == "again" else "Cleo", moves=False)
        world.until(lambda: new.member.slot is not None and begun(new), 5.0)  # noqa: B023
        assert float(np.abs(new.position).max()) < 0.01
        world.run(6.0)
        coupled[allowance] = world.all_coupled()
        world.check()
        assert new.copy.totals.advanced <= allowance
        status = new.copy.status(world.now)
        assert status.initial_energies == new.copy.initial_energies >= new.copy.totals.advanced
        if allowance:
            assert new.copy.totals.advanced > 0.01
            assert abs(float(new.position[1, 0]) - held) < 0.04
    # Without it they stay apart: that is what the allowance is for.
    assert coupled == {1.0: True, 0.0: False}


def test_who_was_there_first_is_not_pulled_at_by_a_newcomer() -> None:
    """A seed of 1 mJ would pull Ann's free copy with 0.35 N; she lets Ben come instead."""
    world = World(chain(path="[[0, 0.0], [1, 0.05]]"), tick=2.5e-3)
    ann = world.join("Ann")
    world.run(4.0)
    ben = world.join("Ben", moves=False)
    world.until(lambda: begun(ben) and bool(ann.copy.neighbours) and ann.copy.copies == 2, 3.0)
    pulled = []
    for _ in range(10):
        world.run(0.05)
        (held,) = ann.copy.neighbours.values()
        pulled.append((2.0 * 60.0 * held.guard.ledger.potential) ** 0.5)
    assert max(pulled) < 0.12
    world.until(world.all_coupled, 6.0)


def test_nobody_is_asked_for_more_damping_than_the_limit_and_all_are_told_who_did() -> None:
    world = World(chain(more="age_limit = 0.8"), tick=2.5e-3)
    ann, ben = world.join("Ann"), world.join("Ben", moves=False)
    liar = world.join("Zoe", moves=False)
    Liar(liar, Lie(since=2.0, ask=2e10, grant=2e10))
    world.run(2.0)
    assert world.all_coupled()
    before = float(ann.copy.damping[0])
    world.run(3.0)
    assert before < float(ann.copy.damping[0]) <= 0.5 * 60.0 * (0.8 + 0.15)  # Zoe's limit, and what Ben needs
    assert ann.states()[1] == "coupled" == ben.states()[0]
    (link,) = [link for link in ann.copy.status(world.now).links if link.slot == 2]
    assert link.asked is not None
    assert link.asked > 1e10
    assert link.budget == pytest.approx(0.8)
    assert world.host is not None
    commanded = [event.text for event in world.host.watch.events]
    assert "Zoe asks Ann for damping for samples up to 2e+10 s old; 0.8 s is granted" in commanded
    assert not any("Ben asks" in text for text in commanded)


def test_a_neighbour_that_says_impossible_ages_gets_no_more() -> None:
    """Stamps of the past make this end itself ask for more; what it asks for is bounded with the rest."""
    world = World(chain(more="age_limit = 0.8"), tick=2.5e-3)
    ann = world.join("Ann")
    Liar(world.join("Zoe", moves=False), Lie(since=1.5, drift=-20.0, age=1e9))
    for _ in range(80):
        world.run(0.05)
        if begun(ann):
            assert float(ann.copy.damping[0]) <= 0.5 * 60.0 * 0.8 * (1.0 + 1e-12)


def test_who_never_goes_on_is_waited_for_only_so_long() -> None:
    """Where everybody waits for the others' indices, one that says nothing more would hold up all."""
    world = World(chain(mode="self-paced"), tick=2.5e-3)
    ann, ben = world.join("Ann"), world.join("Ben", moves=False)
    Liar(world.join("Zoe", moves=False), Lie(since=3.0, silence=1.0))
    world.run(3.0)
    assert world.all_coupled()
    before = [person.copy.peer.steps for person in (ann, ben)]
    world.run(2.0)
    for person, steps in zip((ann, ben), before, strict=True):
        assert person.copy.peer.steps - steps > 120
    for person, other in ((ann, 1), (ben, 0)):  # each goes on with the other's samples as young as ever
        age = next(link.age for link in person.copy.status(world.now).links if link.slot == other)
        assert age is not None
        assert age < 0.2
    assert ann.states()[2] in {"guarded", "ready"}  # it may have caught up with where she was last


def test_what_is_said_of_itself_bears_seeds_and_what_was_asked() -> None:
    status = Status.model_validate_json(
        '{"slot": 0, "initial_energies": 0.5, "links": [{"slot": 1, "state": "coupled", "asked": 3}]}'
    )
    assert status.initial_energies == 0.5
    assert status.links[0].asked == 3.0
