from collections.abc import Mapping, Sequence
from typing import Any

import pytest

from cotouch.control import SignedMessage
from cotouch.errors import NetworkError, SessionError
from cotouch.laws import law_named
from cotouch.members import (
    ABSENT_AFTER,
    Admission,
    Coordinator,
    Entry,
    Join,
    LinkStatus,
    Refused,
    Roster,
    SessionFile,
    Status,
    present_links,
    read_message,
    write_message,
)
from cotouch.network import Pair

HOST = bytes([255]) * 32
BODY = [1.0, 2.0]
NETWORK = """
[network]
users = ["Ann", "Ben", "Cleo", "Dan"]
spring = [[0, 9, 5, 0], [9, 0, 8, 7], [5, 8, 0, 6], [0, 7, 6, 0]]
delay = [[0, 0.1, 0.1, 0.1], [0.1, 0, 0.1, 0.1], [0.1, 0.1, 0, 0.1], [0.1, 0.1, 0.1, 0]]
links = [[1, 2], [2, 3], [3, 4]]
"""


REPLANNED = '[session]\nusers = 3\nlinks = "plan"\nreplan = true\n'


class Asked:
    """A planner that links all, and keeps the paths that it was told."""

    def __init__(self) -> None:
        self.paths: list[dict[Pair, float]] = []

    def __call__(self, slots: Sequence[int], paths: Mapping[Pair, float]) -> list[Pair]:
        self.paths.append(dict(paths))
        return [(a, b) for a in slots for b in slots if a < b]


def key(number: int) -> bytes:
    return bytes([number]) * 32


class World:
    """A coordinator and those who talk to it, on a clock of its own."""

    def __init__(self, text: str = NETWORK, **options: Any) -> None:
        self.session = SessionFile.from_toml(text)
        self.coordinator = Coordinator(self.session, **({"fingerprint": BODY} | options))
        self.now = 0.0
        self.present = {HOST}
        self.refusals: dict[bytes, str] = {}

    def join(self, number: int, name: str, body: list[float] = BODY, *, start: int = 0) -> None:
        self.present.add(key(number))
        self.tick()
        law = law_named(self.session.law).signature
        request = Join(name=name, fingerprint=body, version="1", law=law, start=f"{start:016x}")
        self.coordinator.receive(SignedMessage(key(number), "join", write_message(request), direct=False), self.now)
        self.tick()

    def tick(self, seconds: float = 0.0) -> None:
        end = self.now + seconds
        while True:
            for topic, body, to in self.coordinator.tick(self.now, frozenset(self.present)):
                if topic == "refused" and to is not None:
                    refused = read_message(Refused, body)
                    assert refused is not None
                    self.refusals[to] = refused.reason
            if self.now >= end:
                break
            self.now = min(end, self.now + 0.1)

    @property
    def roster(self) -> Roster:
        return self.coordinator.roster

    @property
    def names(self) -> dict[int, str]:
        return {entry.slot: entry.name for entry in self.roster.members}


def test_a_name_of_the_file_gets_its_own_slot_and_its_links() -> None:
    world = World()
    world.join(1, "Cleo")
    world.join(2, "Ann")
    world.join(3, "Ben")
    assert world.names == {0: "Ann", 1: "Ben", 2: "Cleo"}
    assert world.roster.links == [(0, 1), (1, 2)]


def test_who_is_there_is_joined_whatever_is_missing() -> None:
    world = World()
    for number, name in enumerate(["Ann", "Ben", "Cleo", "Dan"]):
        world.join(number, name)
    assert world.roster.links == [(0, 1), (1, 2), (2, 3)]
    world.coordinator.receive(SignedMessage(key(1), "leave", b"", direct=False), world.now)  # Ben
    assert world.names == {0: "Ann", 2: "Cleo", 3: "Dan"}
    assert world.roster.links == [(0, 2), (2, 3)]


def test_another_name_takes_a_free_slot_until_none_is_left() -> None:
    world = World()
    for number in range(5):
        world.join(number, f"guest {number}")
    assert len(world.roster.members) == 4
    assert "all 4 slots" in world.refusals[key(4)]


def test_a_name_stays_with_its_key_and_who_crashed_comes_back_with_that() -> None:
    world = World()
    world.join(1, "Ben")
    world.join(2, "Ben")
    assert '"Ben" is taken' in world.refusals[key(2)]
    world.present.discard(key(1))  # crashed or cut off, and not yet missed
    world.tick(2.0)
    world.refusals.clear()
    world.join(2, "Ben")
    assert '"Ben" is taken' in world.refusals[key(2)]
    world.join(1, "Ben", start=1)
    assert world.names == {1: "Ben"}
    assert world.roster.members[0].start == f"{1:016x}"
    world.coordinator.receive(SignedMessage(key(1), "leave", b"", direct=False), world.now)
    assert world.names == {}
    world.refusals.clear()
    world.join(2, "Ben")  # nor when it has left
    assert '"Ben" is taken' in world.refusals[key(2)]
    world.join(1, "Bob")
    assert 'known as "Ben"' in world.refusals[key(1)]
    world.join(1, "Ben", start=2)
    assert world.names == {1: "Ben"}


def test_the_host_releases_the_name_of_one_who_is_gone() -> None:
    world = World()
    world.join(1, "Ben")
    with pytest.raises(SessionError, match='"Ben" has joined'):
        world.coordinator.release("Ben")
    world.coordinator.receive(SignedMessage(key(1), "leave", b"", direct=False), world.now)
    with pytest.raises(SessionError, match="nobody has used"):
        world.coordinator.release("Bob")
    slots = world.roster.slots()
    world.coordinator.release("Ben")
    assert world.roster.slots() == slots
    world.join(2, "Ben")
    assert world.names == {1: "Ben"}
    assert world.roster.of(key(2)) is not None


def test_who_was_sent_away_leaves_its_place_and_does_not_come_back() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    with pytest.raises(SessionError, match='nobody here has the name "Eve"; there are: Ann, Ben'):
        world.coordinator.expel("Eve")
    world.coordinator.expel("Ben")
    assert world.names == {0: "Ann"}
    assert world.roster.slots()[key(2).hex()] == {1}  # what it cut there, others tell those who come later
    world.join(2, "Ben", start=1)
    assert "expelled you" in world.refusals[key(2)]
    world.join(3, "Ben")
    assert world.names == {0: "Ann", 1: "Ben"}
    world.coordinator.receive(SignedMessage(key(3), "leave", b"", direct=False), world.now)
    world.coordinator.expel("Ben")  # who is not here can be sent away, too
    world.join(3, "Ben", start=1)
    assert "expelled you" in world.refusals[key(3)]


def test_a_place_can_be_freed_without_a_ban() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    world.coordinator.expel("Ben", ban=False)
    assert world.names == {0: "Ann"}
    world.join(3, "Ben")
    assert world.names == {0: "Ann", 1: "Ben"}
    world.coordinator.expel("Ben", ban=False)
    world.join(2, "Ben", start=1)
    assert world.names == {0: "Ann", 1: "Ben"}


def test_an_address_takes_half_of_the_slots() -> None:
    where = {key(number): "192.0.2.1" for number in range(1, 4)} | {key(9): "192.0.2.9"}
    session = SessionFile.from_toml(NETWORK)
    admission = Admission(session, fingerprint=BODY, each=2, where=lambda who, request: where.get(who))
    world = World(admission=admission)
    for number in (1, 2, 3, 4, 5, 6, 9):
        world.join(number, f"guest {number}")
    assert "192.0.2.1" in world.refusals[key(3)]
    assert "session.per_address" in world.refusals[key(3)]
    assert {entry.key for entry in world.roster.members} == {key(k).hex() for k in (1, 2, 4, 5)}
    assert "all 4 slots" in world.refusals[key(9)]
    world.coordinator.receive(SignedMessage(key(1), "leave", b"", direct=False), world.now)
    world.join(6, "guest 6")
    assert "unknown address" in world.refusals[key(6)]
    world.join(3, "guest 3")
    assert world.roster.of(key(3)) is not None


def test_one_address_takes_only_so_many_names() -> None:
    session = SessionFile.from_toml(NETWORK)
    world = World(admission=Admission(session, fingerprint=BODY, each=2, where=lambda who, request: "192.0.2.1"))
    for number in range(1, 30):
        world.join(number, f"guest {number}")
        world.coordinator.receive(SignedMessage(key(number), "leave", b"", direct=False), world.now)
    assert len(world.roster.names) == 16
    assert "16 names" in world.refusals[key(29)]
    world.join(3, "guest 3", start=1)  # who has a name comes back
    assert world.names == {0: "guest 3"}


def test_nobody_is_answered_before_the_body_is_built_here() -> None:
    """A first joiner's body is not everybody's."""
    world = World(fingerprint=None)
    world.join(1, "Mallory", [6.0, 6.0])
    world.join(2, "Ann")
    assert not world.roster.members
    assert not world.refusals
    world.coordinator.admission.fingerprint = BODY
    world.join(1, "Mallory", [6.0, 6.0])
    world.join(2, "Ann")
    assert world.names == {0: "Ann"}
    assert "a different body" in world.refusals[key(1)]


def test_who_is_not_seen_for_a_while_has_left() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    world.present.discard(key(1))
    world.tick(ABSENT_AFTER - 1.0)
    assert len(world.roster.members) == 2
    world.present.add(key(1))  # it was only cut off
    world.tick(1.0)
    world.present.discard(key(1))
    world.tick(ABSENT_AFTER - 1.0)
    assert len(world.roster.members) == 2
    world.tick(2.0)
    assert world.names == {1: "Ben"}


def test_of_who_crashed_and_came_back_nothing_is_left() -> None:
    world = World()
    world.join(1, "Ann")
    for number in range(2, 60):
        world.tick(2.0)
        world.join(1, "Ann", start=number)
    assert world.names == {0: "Ann"}
    assert world.roster.members[0].start == f"{59:016x}"
    assert set(world.coordinator._seen) == {key(1).hex()}
    assert len(world.roster.names) == 1


def test_another_body_is_refused() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben", [1.0, 2.0 + 1e-9])
    world.join(3, "Cleo", [1.0, -2.0])
    assert world.names == {0: "Ann", 1: "Ben"}
    assert "a different body" in world.refusals[key(3)]


def test_a_wish_said_again_changes_nothing() -> None:
    world = World()
    world.join(1, "Ann")
    epoch = world.roster.epoch
    world.join(1, "Ann")
    world.tick(5.0)
    assert world.roster.epoch == epoch


def test_a_successor_goes_on_with_higher_numbers() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    successor = World()
    successor.coordinator.adopt(world.roster, 0.0)
    successor.present = {key(1), key(2)}
    successor.join(3, "Dan")
    assert successor.roster.epoch > world.roster.epoch
    assert successor.names == {0: "Ann", 1: "Ben", 3: "Dan"}


def status(slot: int, paths: dict[int, float]) -> bytes:
    return write_message(
        Status(slot=slot, links=[LinkStatus(slot=j, state="coupled", round_trip=t) for j, t in paths.items()])
    )


def test_links_are_planned_from_what_is_measured_and_anew_when_it_changes() -> None:
    asked: list[dict[tuple[int, int], float]] = []

    def planner(slots: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]] | None:
        asked.append(paths)
        if len(asked) % 2:
            return None  # still at work
        worst = max(paths, key=lambda pair: paths[pair], default=None)
        return [(a, b) for a in slots for b in slots if a < b and (a, b) != worst]

    world = World('[session]\nusers = 3\nlinks = "plan"\nreplan = true\n', planner=planner)
    for number in range(3):
        world.join(number, f"{number}")
    world.tick(6.0)
    assert world.roster.links == [(0, 1), (0, 2), (1, 2)]
    slow = status(0, {1: 0.5, 2: 0.04})
    world.coordinator.receive(SignedMessage(key(0), "status", slow, direct=False), world.now)
    world.tick(20.0)
    assert world.roster.links == [(0, 2), (1, 2)]
    count = len(asked)
    world.coordinator.receive(SignedMessage(key(0), "status", status(0, {1: 0.51, 2: 0.04}), direct=False), world.now)
    world.tick(20.0)
    assert len(asked) == count


@pytest.mark.parametrize("body", [b"", b"{}", b"\xff" * 50, b'{"name": 3}', b'{"name": "", "fingerprint": []}'])
def test_nonsense_changes_nothing(body: bytes) -> None:
    world = World()
    world.join(1, "Ann")
    before = world.roster
    for topic in ("join", "status", "what"):
        world.coordinator.receive(SignedMessage(key(9), topic, body, direct=False), world.now)
    world.tick()
    assert world.roster == before
    assert not world.refusals


def test_links_of_those_present_are_one_piece() -> None:
    network = SessionFile.from_toml(NETWORK).scenario.network
    assert present_links(network, [0, 1, 2, 3]) == [(0, 1), (1, 2), (2, 3)]
    assert present_links(network, [0, 3]) == []  # no spring may join these
    assert present_links(network, [1, 3]) == [(1, 3)]
    assert present_links(network, [2]) == []


def test_links_that_somebody_chose_stay_as_people_come_and_go() -> None:
    world = World(planner=lambda slots, paths: [(0, 1), (1, 2)][: len(slots) - 1])
    for number, name in ((1, "Ann"), (2, "Ben"), (3, "Cleo")):
        world.join(number, name)
    world.tick(10.0)
    assert world.roster.links == [(0, 1), (1, 2)]
    epoch = world.roster.epoch
    world.coordinator.choose([(0, 2), (1, 2), (1, 3)])
    assert world.roster.links == [(0, 2), (1, 2)]
    assert world.roster.epoch == epoch + 1
    world.join(4, "Dan")
    world.tick(20.0)  # no plan takes their place
    assert world.roster.links == [(0, 2), (1, 2), (1, 3)]
    world.coordinator.choose([(0, 1)])
    assert world.roster.links == [(0, 1), (1, 2), (1, 3)]  # everybody is joined to somebody
    with pytest.raises(NetworkError):
        world.coordinator.choose([(0, 3)])


def test_ways_to_slots_that_nobody_has_are_of_no_use() -> None:
    """A slot beyond the session's was an IndexError in the host, at its next look at the delays."""
    planner = Asked()
    world = World(REPLANNED, planner=planner)
    for number in range(3):
        world.join(number, f"{number}")
    world.tick(6.0)
    world.coordinator.receive(SignedMessage(key(0), "status", status(0, {31: 0.5, 1: 0.1}), direct=False), world.now)
    world.tick(20.0)
    assert planner.paths[-1] == {(0, 1): 0.1}


def test_no_number_of_changes_is_an_error() -> None:
    world = World()
    last = (1 << 52) - 1
    world.coordinator.adopt(Roster(epoch=last), 0.0)
    world.join(1, "Ann")
    assert world.roster.epoch == last
    assert world.names == {}


def test_whom_others_let_in_is_taken_up_and_nobody_changes_place() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    mine = world.roster

    def entry(slot: int, name: str, number: int) -> Entry:
        return Entry(slot=slot, name=name, key=key(number).hex())

    forged = Roster(
        epoch=900,
        members=[entry(0, "Ben", 7), entry(2, "Ann", 8), entry(3, "Dan", 9)],
    )
    present = frozenset([key(1), key(2), key(7), key(8), key(9)])
    world.coordinator.take_up(forged, present, world.now)
    assert world.names == {0: "Ann", 1: "Ben", 3: "Dan"}
    assert world.roster.members[:2] == mine.members
    world.coordinator.take_up(Roster(epoch=9, members=[entry(2, "Eve", 5)]), present, world.now)  # who is not there
    assert world.names == {0: "Ann", 1: "Ben", 3: "Dan"}
    world.present.discard(key(2))  # cut off a moment ago: nobody takes its place before it is missed
    world.coordinator.take_up(Roster(epoch=9, members=[entry(1, "Gus", 4)]), frozenset([key(4)]), world.now)
    assert world.names == {0: "Ann", 1: "Ben", 3: "Dan"}
    moved = Roster(epoch=9, members=[entry(0, "Fay", 6), entry(2, "Ann", 1)])
    world.coordinator.take_up(moved, present | {key(6)}, world.now)
    assert world.names == {0: "Ann", 1: "Ben", 3: "Dan"}


def test_whom_others_let_in_take_no_more_places_than_one_address_may() -> None:
    """Nobody showed the host where they are: all of them together count as one address, whoever says who they are."""
    where = {key(1): "192.0.2.1", key(7): "192.0.2.7"}
    admission = Admission(SessionFile.from_toml(NETWORK), fingerprint=BODY, each=1, where=lambda who, _: where.get(who))
    world = World(admission=admission)
    world.join(1, "Ann")
    many = [Entry(slot=slot, name=f"guest {slot}", key=key(slot + 5).hex()) for slot in (1, 2, 3)]
    present = frozenset(key(number) for number in (1, 6, 7, 8))
    world.coordinator.take_up(Roster(epoch=9, members=many), present, world.now)
    assert world.names == {0: "Ann", 1: "guest 1"}
    # Not one by one either, nor by asking; but who shows where it is comes in, and comes back when others say so.
    for one in many[1:]:
        world.coordinator.take_up(Roster(epoch=9, members=[one]), present, world.now)
    world.join(8, "guest 3")
    assert "unknown address" in world.refusals[key(8)]
    world.join(7, "guest 2")
    assert world.roster.of(key(7)) is not None
    left = world.roster.of(key(7))
    world.coordinator.receive(SignedMessage(key(7), "leave", b"", direct=False), world.now)
    world.coordinator.take_up(Roster(epoch=9, members=[left, many[2]]), present, world.now)
    assert {entry.key for entry in world.roster.members} == {key(k).hex() for k in (1, 7, 6)}


def test_who_is_in_an_adopted_roster_is_waited_for_as_if_seen_now_and_measured_anew() -> None:
    asked: list[dict[tuple[int, int], float]] = []

    def planner(slots: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]] | None:
        asked.append(paths)
        return [(0, 1)]

    world = World(planner=planner)
    world.coordinator.measured((0, 1), 0.3)  # before anybody was there
    world.now = 100.0
    members = [Entry(slot=slot, name=name, key=key(slot + 1).hex()) for slot, name in enumerate(["Ann", "Ben"])]
    world.coordinator.adopt(Roster(epoch=5, members=members), world.now)
    world.tick()
    assert asked == []  # what was measured is of somebody else
    world.tick(5.5)
    assert world.names == {0: "Ann", 1: "Ben"}
    assert asked == [{}]
    world.tick(1.0)
    assert world.names == {}


def test_only_so_many_are_kept_out() -> None:
    world = World()
    world.join(1, "Ann")
    full = [f"{number:064x}" for number in range(1, 257)]
    world.coordinator.adopt(world.roster.model_copy(update={"banned": full}), world.now)
    with pytest.raises(SessionError, match="256 users have already been expelled"):
        world.coordinator.expel("Ann")
    assert world.names == {0: "Ann"}
    world.coordinator.expel("Ann", ban=False)
    assert world.names == {}


def test_a_roster_is_said_when_it_changes_when_one_did_not_hear_it_and_every_two_seconds() -> None:
    world = World()
    coordinator = world.coordinator
    world.join(1, "Ann")
    assert coordinator.due(1.0)
    assert not coordinator.due(2.9)
    assert coordinator.due(3.0)
    assert not coordinator.due(3.0)
    world.join(1, "Ann")  # it asks again, as it did not hear the answer
    assert coordinator.due(3.1)
    epoch = world.roster.epoch
    coordinator.renew()
    assert world.roster.epoch == epoch + 1
    assert coordinator.due(3.2)
    coordinator.renew(5)
    assert world.roster.epoch == epoch + 6
    assert coordinator.refused == 0
    world.join(2, "Ben", [3.0, 2.0])
    assert coordinator.refused == 1


PLANNED = '[session]\nusers = 3\nlinks = "plan"\nreplan = {replan}\n'


class Planner:
    """Joins all but the slowest pair, when it is let."""

    def __init__(self) -> None:
        self.asked: list[tuple[list[int], dict[tuple[int, int], float]]] = []
        self.ready = True

    def __call__(self, slots: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]] | None:
        self.asked.append((slots, paths))
        worst = max(paths, key=lambda pair: paths[pair], default=None)
        return [(a, b) for a in slots for b in slots if a < b and (a, b) != worst] if self.ready else None


@pytest.mark.parametrize("replan", [True, False])
def test_a_plan_is_made_anew_only_where_asked_for_ten_seconds_later_and_for_a_quarter(replan: bool) -> None:
    planner = Planner()
    world = World(PLANNED.format(replan=str(replan).lower()), planner=planner)
    world.join(0, "0")
    world.tick(20.0)
    assert planner.asked == []  # one alone needs no links
    world.join(1, "1")
    world.coordinator.measured((0, 1), 0.1)
    world.tick(0.2)
    assert planner.asked == [([0, 1], {(0, 1): 0.1})]  # all is measured: nothing to wait for
    world.join(2, "2")
    world.tick(4.8)
    assert len(planner.asked) == 1
    world.tick(0.4)
    assert planner.asked[1:] == [([0, 1, 2], {(0, 1): 0.1})]  # five seconds are enough
    begun = world.now
    world.coordinator.measured((0, 2), 1.0)
    world.coordinator.measured((1, 2), 0.2)
    world.tick(9.0)
    assert len(planner.asked) == 2
    world.tick(begun + 10.5 - world.now)
    assert len(planner.asked) == (3 if replan else 2)
    if replan:
        assert world.roster.links == [(0, 1), (1, 2)]
        world.coordinator.measured((0, 2), 1.2)
        world.tick(11.0)
        assert len(planner.asked) == 3  # a fifth more is not worth it
        world.coordinator.measured((0, 2), 1.4)
        world.tick(0.2)
        assert len(planner.asked) == 4


def test_a_plan_for_others_than_are_there_now_is_not_taken() -> None:
    planner = Planner()
    planner.ready = False
    world = World(PLANNED.format(replan="false"), planner=planner)
    for number in range(3):
        world.join(number, f"{number}")
    for pair, both in (((0, 1), 0.1), ((0, 2), 0.2), ((1, 2), 0.3)):
        world.coordinator.measured(pair, both)
    world.tick(0.2)
    before = world.roster.links
    world.coordinator.receive(SignedMessage(key(2), "leave", b"", direct=False), world.now)
    planner.ready = True
    links, epoch = world.roster.links, world.roster.epoch
    assert links == [(0, 1)] != before
    world.coordinator.tick(world.now, frozenset(world.present))
    assert (world.roster.links, world.roster.epoch) == (links, epoch)


def test_who_left_and_is_taken_up_again_is_waited_for_as_if_seen_now() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben")
    ben = world.roster.of(key(2))
    assert ben is not None
    world.coordinator.receive(SignedMessage(key(2), "leave", b"", direct=False), world.now)
    world.now = 50.0
    world.coordinator.take_up(Roster(epoch=9, members=[ben]), frozenset([key(1), key(2)]), world.now)
    world.present = {HOST, key(1)}
    world.tick(ABSENT_AFTER - 0.5)
    assert world.names == {0: "Ann", 1: "Ben"}
    world.tick(1.0)
    assert world.names == {0: "Ann"}


def test_one_who_is_not_there_loses_its_slot_only_where_it_is_said_so() -> None:
    def entry(slot: int, name: str, number: int) -> Entry:
        return Entry(slot=slot, name=name, key=key(number).hex())

    for instead in (False, True):
        world = World()
        world.join(1, "Ann")
        world.join(2, "Ben")
        other = Roster(epoch=9, members=[entry(0, "Eve", 5), entry(1, "Hal", 6), entry(3, "Gus", 7)])
        there = frozenset([key(2), key(5), key(6), key(7)])  # Ann is not
        world.coordinator.take_up(other, there, world.now, instead=instead)
        assert world.names == ({0: "Eve", 1: "Ben"} if instead else {0: "Ann", 1: "Ben"}) | {3: "Gus"}
        assert [one.slot for one in world.roster.members] == [0, 1, 3]
        assert world.roster.owners()["Gus"] == key(7).hex()
    gone = Roster(epoch=9, members=[entry(1, "Hal", 8)])  # nor for one who is not there itself
    world.coordinator.take_up(gone, frozenset([key(5)]), world.now, instead=True)
    assert world.names[1] == "Ben"


def test_nobody_leaves_twice_and_nonsense_of_a_member_changes_nothing() -> None:
    planner = Asked()
    world = World(REPLANNED, planner=planner)
    world.join(1, "Ann")
    world.join(2, "Ben")
    world.tick(6.0)
    before = world.roster
    for sender, topic, body in ((9, "leave", b""), (1, "status", b"{}"), (9, "status", status(0, {1: 0.1}))):
        world.coordinator.receive(SignedMessage(key(sender), topic, body, direct=False), world.now)
    assert world.roster is before
    world.tick(20.0)
    world.join(3, "Cleo")
    world.tick(20.0)
    assert set(world.roster.links) == {(0, 1), (0, 2), (1, 2)}
    assert planner.paths
    assert not any(planner.paths)


def test_who_does_not_fit_need_not_ask_again_and_who_finds_no_room_may() -> None:
    world = World()
    for number in range(4):
        world.join(number, f"guest {number}")
    final: list[bool] = []
    for number, body in ((7, BODY), (8, [5.0, 5.0])):
        law = law_named(world.session.law).signature
        request = Join(name=f"guest {number}", fingerprint=body, version="1", law=law, start="0" * 16)
        world.coordinator.receive(SignedMessage(key(number), "join", write_message(request), direct=False), world.now)
        (out,) = world.coordinator.tick(world.now, frozenset(world.present))
        refused = read_message(Refused, out.body)
        assert refused is not None
        final.append(refused.final)
    assert final == [False, True]


def test_who_joins_and_is_never_there_is_missed_too() -> None:
    world = World()
    law = law_named(world.session.law).signature
    request = Join(name="Ann", fingerprint=BODY, version="1", law=law, start="0" * 16)
    world.coordinator.receive(SignedMessage(key(1), "join", write_message(request), direct=False), world.now)
    world.tick(ABSENT_AFTER - 0.5)
    assert world.names == {0: "Ann"}
    world.tick(1.0)
    assert world.names == {}
