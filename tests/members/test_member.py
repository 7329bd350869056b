import tomllib
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.session.world import World

from cotouch.control import SignedMessage
from cotouch.errors import SessionError
from cotouch.members import Status
from cotouch.network import Network
from cotouch.samples import PathLaw
from cotouch.session import measured_network

BODY = """
[body]
mass = 0.5
damping = 0.2
[steps]
rate = 100
"""


def hand(user: int, path: list[list[float]]) -> str:
    return f"[[hands]]\nuser = {user}\npath = {path}\nstiffness = 40.0\ndamping = 1.0\n"


THREE = "[session]\nusers = 3\nspring = 60.0" + BODY + hand(1, [[0, 0], [1, 0.05]])
SPRINGS = '[synchronisation]\nlaw = "spring"\n'  # where a test is of budgets and guards


def coarse(text: str, **options) -> World:
    """Whose clock goes by a fifth of a step."""
    return World(text, tick=2e-3, **options)


def three(law: str = "") -> World:
    world = coarse(THREE + law)
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 12.0)
    return world


def test_three_meet_couple_and_follow_one_hand() -> None:
    world = three()
    world.run(6.0)
    assert world.apart() < 1e-3
    assert abs(world.people[2].position[0, 0] - 0.05) < 5e-3
    world.check()


# Both pull at once, away from each other, and hold.
APART = "[session]\nusers = 2\nspring = 60.0\nallowance = 0.0\n{gather}" + BODY
APART += SPRINGS + hand(1, [[0, 0], [0.1, 0.05]]) + hand(2, [[0, 0], [0.1, -0.05]])


def test_damping_goes_with_its_links_and_not_a_turn_later() -> None:
    world = three(SPRINGS)
    world.until(world.all_coupled, 12.0)
    copy = world.people[0].copy
    assert copy.damping.max() > 0.0
    copy.follow(world.people[0].member.roster.model_copy(update={"links": []}), world.now)
    assert not copy.neighbours
    assert copy.damping.max() == 0.0


def test_hands_of_the_file_wait_until_their_copies_are_coupled() -> None:
    alone, gathered = (
        coarse(APART.format(gather=given), law=PathLaw(delay=0.1)) for given in ("", "wait_for_peers = 9.0")
    )
    for world in (alone, gathered):
        world.join("Ann")
        world.join("Ben")
        world.run(12.0)
        world.check()
    # Taken apart before they were coupled, and held there, they lack the energy to meet.
    assert not alone.all_coupled()
    assert gathered.all_coupled()
    # Coupled, each hand's spring holds the one between the copies: 40 (0.05 - x) = 60 * 2 x.
    assert abs(gathered.apart() - 0.025) < 1e-4
    assert alone.apart() > 0.035


def test_hands_of_the_file_wait_for_nobody_for_ever() -> None:
    world = coarse(APART.format(gather="wait_for_peers = 3.0"))
    ann = world.join("Ann")
    world.until(lambda: ann.member.replica is not None and ann.copy.peer is not None, 5.0)
    world.run(2.9)
    assert np.abs(ann.position).max() == 0.0
    world.run(1.0)
    assert ann.position[0, 0] > 0.03
    # What waited once goes on, whoever comes.
    ben = world.join("Ben", moves=False)
    world.until(lambda: ben.member.replica is not None and ben.copy.peer is not None, 5.0)
    world.run(2.0)
    assert ann.position[0, 0] > 0.03


def test_one_joins_while_the_others_hold_the_object_without_a_jerk() -> None:
    world = coarse(THREE)
    ann, ben = world.join("Ann"), world.join("Ben", moves=False)
    world.until(world.all_coupled, 12.0)
    world.run(4.0)
    before = ben.position.copy()
    cleo = world.join("Cleo", moves=False)
    fastest = 0.0
    for _ in range(60):
        world.run(0.05)
        for person in (ann, ben):
            fastest = max(fastest, float(np.abs(person.copy.peer.state.velocity).max()))
    world.until(world.all_coupled, 12.0)
    assert fastest < 0.05  # what Cleo brings with her; it was 0.11 to 0.6, for good, where steps were long beside ages
    assert np.abs(cleo.position - before).max() < 5e-3
    assert ann.copy.peer.model is not None
    assert {p.copy.copies for p in world.people} == {3}
    world.check()


@pytest.mark.parametrize("how", ["leave", "kill"])
def test_one_goes_and_the_others_go_on(how: str) -> None:
    world = three()
    world.run(2.0)
    ben = world.people[1]
    getattr(world, how)(ben)
    world.run(10.0)
    assert [p.name for p in world.people] == ["Ann", "Cleo"]
    assert {p.copy.copies for p in world.people} == {2}
    assert world.all_coupled()
    assert world.apart() < 1e-3
    world.check()


def test_who_crashed_comes_back_under_its_name() -> None:
    world = three()
    cleo = world.people[2]
    slot = cleo.member.slot
    world.kill(cleo)
    world.run(1.0)
    again = world.join("Cleo", moves=False)
    world.until(lambda: again.member.slot is not None and world.all_coupled(), 20.0)
    assert again.member.slot == slot
    world.run(3.0)
    assert world.apart() < 1e-3
    world.check()


def test_the_host_dies_and_people_still_come_and_go() -> None:
    world = three()
    world.kill_host()
    world.run(3.0)
    assert world.all_coupled()
    world.leave(world.people[1])
    world.run(3.0)
    dan = world.join("Dan", moves=False)
    world.until(lambda: dan.member.slot is not None and world.all_coupled(), 15.0)
    assert {p.copy.copies for p in world.people} == {3}
    world.check()


def test_the_first_takes_over_when_the_host_and_the_lowest_slot_die_at_once() -> None:
    world = three()
    world.kill_host()
    world.kill(world.people[0])
    world.run(12.0)
    assert {p.copy.copies for p in world.people} == {2}
    assert world.all_coupled()
    world.check()


def test_an_outage_guards_the_link_and_it_couples_again() -> None:
    """At once: the outage is in nobody's budget, so nobody has to hold still for as long as it was."""
    world = three(SPRINGS)
    ann, ben, cleo = world.people
    world.run(1.0)

    def totals() -> list[float]:
        return [held.guard.total for person in world.people for held in person.copy.neighbours.values()]

    before = totals()
    for other in (ben, cleo):
        world.paths(ann, other, PathLaw(delay=0.005, down=True))
    world.run(4.0)
    assert "coupled" not in ann.states().values()
    for other in (ben, cleo):
        world.paths(ann, other, PathLaw(delay=0.005))
    world.until(world.all_coupled, 1.0)
    world.run(6.0)
    assert world.all_coupled()
    assert max(totals()) < 1.5 * max(before)
    assert world.apart() < 2e-3
    world.check()


def test_one_way_is_enough_to_guard_both_ends() -> None:
    world = three(SPRINGS)
    ann, ben, _ = world.people
    world.paths(ann, ben, PathLaw(delay=0.005, down=True), both=False)
    world.run(2.0)
    assert ann.states()[1] != "coupled"
    assert ben.states()[0] != "coupled"
    world.check()


def test_a_bad_network() -> None:
    law = PathLaw(delay=0.03, jitter=0.05, loss=0.3, duplication=0.1, reordering=0.3, hold=0.03)
    world = coarse(THREE, law=law, seed=3)
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 25.0)
    world.run(8.0)
    assert world.apart() < 5e-3
    world.check()


def test_a_peer_that_stalls_is_waited_for_by_nobody() -> None:
    world = three()
    ben = world.people[1]
    ben.stalled_until = world.now + 3.0
    world.run(3.0)
    assert world.people[0].states()[1] != "coupled"
    world.until(world.all_coupled, 1.5)
    world.check()


def test_a_copy_moves_from_the_step_after_it_was_made() -> None:
    """Making it may take a second, and a sample that bore the time from before would be as old."""
    world = coarse(THREE)
    ann = world.join("Ann")
    for _ in range(6000):
        world.run(0.002)
        if ann.member.replica is not None and ann.copy.peer is not None:
            break
    assert ann.copy.peer is not None
    assert ann.copy.peer.steps == 0
    made = world.now  # and its first step comes a period later
    world.until(lambda: ann.copy.status(world.now).steps >= 3, 1.0)
    status = ann.copy.status(world.now)
    assert 0.0 < status.time <= world.now - made - 0.9 * status.nominal_period + 0.003


def test_a_name_that_stays_taken_is_an_error() -> None:
    world = three()
    other = world.join("Ben", moves=False)
    with pytest.raises(SessionError, match='"Ben" is taken'):
        world.run(20.0)
    assert other.member.slot is None


def test_what_is_said_of_itself_adds_up() -> None:
    world = three()
    world.run(3.0)
    for person in world.people:
        status = person.copy.status(world.now)
        assert status.steps > 0
        assert status.damping_margin is None  # nothing is needed
        balance = status.initial + status.supplied + status.linked + status.rescaled - status.lost - status.energy
        assert abs(balance) < 1e-9
        assert {link.path_state for link in status.links} == {"direct"}
    host = world.host
    assert host is not None
    assert {seen.entry.name for seen in host.watch.members.values()} == {"Ann", "Ben", "Cleo"}
    assert all(seen.status is not None for seen in host.watch.members.values())


def test_everybodys_joules_are_somewhere_when_members_come_and_go() -> None:
    world = three()
    ann, ben, cleo = world.people
    world.run(1.0)
    world.kill(ben)
    world.until(lambda: ann.copy.copies == 2, 10.0)
    world.run(0.5)
    again = world.join("Ben", moves=False)
    world.until(lambda: again.member.slot is not None and ann.copy.copies == 3 and world.all_coupled(), 20.0)
    world.leave(cleo)
    world.until(lambda: ann.copy.copies == 2, 10.0)
    changed = 0.0
    for person in (ann, ben, cleo, again):
        status = person.copy.status(world.now)
        came = status.initial + status.supplied + status.linked + status.rescaled
        assert abs(came - status.lost - status.energy) <= 1e-12 * max(1.0, person.copy.totals.in_play)
        changed = max(changed, abs(status.rescaled))
    # Without the change of shares it would not add up.
    assert changed > 1e-8


def test_others_cannot_decide() -> None:
    world = three()
    mallory = world.people[1]
    before = world.people[2].member.roster
    forged = before.model_copy(update={"epoch": before.epoch + 100, "links": []})
    mallory.control.send("roster", forged.model_dump_json().encode())
    mallory.control.send("end", b"")
    world.run(2.0)
    assert world.people[2].member.roster.epoch == before.epoch
    assert not world.people[2].member.ended

    assert world.host is not None
    world.host.end()
    world.run(0.1)
    assert all(person.member.ended for person in world.people)
    assert world.host.watch.ended


@pytest.mark.parametrize("mode", ["constant", "self-paced"])
def test_a_constant_index_delay_couples_too(mode: str) -> None:
    world = coarse(THREE + f'[synchronisation]\nmode = "{mode}"\n', law=PathLaw(delay=0.01, loss=0.02))
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 15.0)
    world.run(6.0)
    assert world.apart() < 2e-3
    assert abs(world.people[2].position[0, 0] - 0.05) < 5e-3
    world.check()


def test_a_common_index_goes_on_with_the_clock_of_who_misses_steps() -> None:
    """Steps that are left out are not taken later: else every one would make a user's samples older, for good."""
    world = coarse(THREE + '[synchronisation]\nmode = "constant"\n', law=PathLaw(delay=0.01))
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 15.0)
    world.run(2.0)
    ann, ben, _ = world.people

    def lead() -> int:
        assert ann.copy.peer is not None
        assert ben.copy.peer is not None
        return ann.copy.peer.steps - ben.copy.peer.steps

    before, began = lead(), world.now
    taken = ben.copy.totals.steps
    for _ in range(60):
        ben.stalled_until = world.now + 0.03
        world.run(0.1)
    period = world.session.period(1)
    assert ben.copy.totals.steps - taken < 0.85 * (world.now - began) / period
    assert abs(lead() - before) <= 2
    assert world.apart() < 2e-3
    world.check()


def test_a_wait_longer_than_a_step_may_last_is_time_in_which_the_copy_stood() -> None:
    world = coarse(THREE + '[synchronisation]\nmode = "self-paced"\n', law=PathLaw(delay=0.01))
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 15.0)
    world.run(2.0)
    ann, ben, _ = world.people
    before = ann.copy.stood
    ben.stalled_until = world.now + 0.4
    world.run(1.0)
    status = ann.member.status(world.now)
    assert status is not None
    assert status.stood == ann.copy.stood
    # All of the wait but for one step of the longest, and what the neighbour's last samples still allowed.
    assert 0.4 - 2.0 * world.session.options.max_step - 0.1 < ann.copy.stood - before < 0.4


def test_ways_are_measured_where_there_is_no_link() -> None:
    world = coarse(
        """
[network]
users = ["Ann", "Ben", "Cleo"]
spring = [[0, 60, 50], [60, 0, 45], [50, 45, 0]]
delay = [[0, 0.02, 0.07], [0.01, 0, 0.03], [0.05, 0.04, 0]]
links = [[1, 2], [2, 3]]
[steps]
rate = 100
[session]
emulate = true
""",
        law=PathLaw(delay=0.005),
    )
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=True)
    world.run(3.0)
    host = world.host
    assert host is not None
    expected = {(0, 1): 0.03 + 0.01, (0, 2): 0.12 + 0.01, (1, 2): 0.07 + 0.01}
    assert host.watch.paths() == pytest.approx(expected, abs=1e-9)
    found = measured_network(host.watch, world.session)
    assert not found.missing
    assert found.network.delay[0, 2] == found.network.delay[2, 0] == pytest.approx(0.065)
    again = Network.from_table(tomllib.loads(found.toml())["network"], source="written")
    assert again.links == ((0, 1), (1, 2)) or list(again.links) == [(0, 1), (1, 2)]
    assert np.abs(again.delay - found.network.delay).max() < 1e-6
    world.leave(world.people[1])
    world.run(1.0)
    assert set(host.watch.paths()) == {(0, 2)}


def test_rounded_samples_are_paid_for() -> None:
    world = coarse(THREE.replace("users = 3", 'users = 3\nencoding = "float32"\nmax_displacement = 1.0'))
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    assert 0.0 < world.replica.rounding < 1e-7
    world.until(world.all_coupled, 15.0)
    world.run(4.0)
    assert abs(world.people[2].position[0, 0] - 0.05) < 5e-3
    world.check()


def test_who_is_farther_away_than_samples_can_tell_says_so() -> None:
    world = coarse(THREE.replace("users = 3", "users = 3\nmax_displacement = 0.03"))
    for name in ("Ann", "Ben", "Cleo"):
        world.join(name, moves=name == "Ann")
    world.until(world.all_coupled, 12.0)
    assert not any(person.copy.status(world.now).unsent for person in world.people)
    world.run(6.0)
    away = [bool(person.position[0, 0] > 0.03) for person in world.people]
    assert away[0]
    assert [person.copy.status(world.now).unsent for person in world.people] == away
    world.check()


def test_a_turn_takes_up_so_many_messages_and_forgets_none() -> None:
    world = three()
    member, received = world.people[0].member, []
    poll, paths = world.people[0].control.poll, world.people[0].paths
    paths.take = lambda message: (received.append(message), False)[1]  # whatever is said of nothing else comes by here
    flood = [SignedMessage(world.people[1].identity.public, "status", bytes([k]), direct=False) for k in range(100)]
    world.people[0].control.poll = lambda: [flood.pop(0) for _ in range(len(flood))] + poll()
    most, turns = 0, 0
    while turns == 0 or member.pending:
        before = len(received)
        member.service(world.now)
        most, turns = max(most, len(received) - before), turns + 1
        assert turns < 50
    said = [message.body[0] for message in received if len(message.body) == 1]
    assert said == list(range(100))
    assert most <= 12
    assert turns >= 9


def test_a_status_is_said_in_pieces_and_whole() -> None:
    world = three()
    person, said = world.people[0], list[tuple[str, bytes]]()
    control = person.control
    send = control.send
    control.send = lambda topic, body, *, to=None: (said.append((topic, body)), send(topic, body, to=to))[1]
    turns, looked = 0, list[int]()  # in which turn a link was looked at
    status_of, serve = person.copy.link_status, person.member.service

    def service(now: float) -> None:
        nonlocal turns
        turns += 1
        serve(now)

    person.copy.link_status = lambda slot: (looked.append(turns), status_of(slot))[1]
    person.member.service = service
    world.until(lambda: any(topic == "status" for topic, _ in said) and len(looked) >= 2, 2.0)
    assert len(set(looked)) == len(looked)
    status = Status.model_validate_json(next(body for topic, body in said if topic == "status"))
    assert [link.slot for link in status.links] == [1, 2]
    assert status.steps > 0
    for _ in range(3):
        person.member.service(world.now)
    assert not person.member.pending


def test_a_neighbour_that_goes_is_left_out_of_what_is_being_said() -> None:
    world = three()
    person = world.people[0]
    for _ in range(200):
        if person.member.pending:
            break
        world.run(0.005)
    assert person.member.pending
    person.copy.alone(world.now)
    for _ in range(5):
        person.member.service(world.now)
    assert not person.member.pending


def test_samples_are_read_between_steps_and_used_in_the_next() -> None:
    world = three()
    ann, ben = world.people[0], world.people[1]
    link = ann.copy.neighbours[1].link
    steps, before = ann.copy.peer.steps, link.assembly.newest
    ann.stalled_until = world.now + 0.1
    world.run(0.09)
    assert link.assembly.newest == before  # nobody read
    ann.member.listen(world.now)
    assert ann.copy.peer.steps == steps
    assert link.assembly.newest > before + 5
    assert ben.copy.peer.steps > link.assembly.newest
    world.run(1.0)
    world.check()


def test_links_are_tended_in_turns_where_they_are_many() -> None:
    world = three()
    copy, seen = world.people[0].copy, list[int]()

    class Keys:
        """Notes whose turn it is."""

        def __init__(self, slot: int) -> None:
            self.slot = slot

        def service(self, now: float, *, asked: bool) -> None:
            del now, asked
            seen.append(self.slot)

    one = next(iter(copy.neighbours.values()))
    many: Any = {slot: replace(one, connected=False, keys=Keys(slot)) for slot in range(1, 21)}  # type: ignore[arg-type]
    copy.neighbours.clear()
    copy.neighbours.update(many)
    for _ in range(5):
        copy.service(world.now)
    assert len(seen) == 40
    assert sorted(seen) == sorted([*range(1, 21)] * 2)


def test_a_refusal_that_stays_is_told_at_once_and_a_full_session_is_waited_for() -> None:
    """One who asks for a name of somebody else's needs no twelve seconds to hear so; slots may become free."""
    pair = 'users = ["Ann", "Ben"]\nspring = [[0, 50], [50, 0]]\ndelay = [[0, 0.01], [0.01, 0]]'
    world = coarse(f"[network]\n{pair}\n[steps]\nrate = 100\n")
    world.join("Ann")
    world.join("Ben")
    world.run(1.0)
    began = world.now
    world.join("Ann", stranger=True)
    with pytest.raises(SessionError, match='does not admit Ann: the name "Ann" is taken'):
        world.run(5.0)
    assert world.now - began < 2.0
    world.people.pop()
    began = world.now
    late = world.join("Cleo")
    world.run(2.0)
    assert late.member.waits_because == "all 2 slots of this session are taken"
    with pytest.raises(SessionError, match="all 2 slots"):
        world.run(12.0)
    assert world.now - began > 10.0
