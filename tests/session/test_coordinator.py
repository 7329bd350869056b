from typing import Any

import pytest

from cotouch.errors import NetworkError
from cotouch.live import Message
from cotouch.session import ABSENT_AFTER, Coordinator, Roster, SessionFile, acting, present_links
from cotouch.session._messages import Join, LinkStatus, Refused, Status, read, write

HOST = bytes([255]) * 32
BODY = [1.0, 2.0]
NETWORK = """
[network]
users = ["Ann", "Ben", "Cleo", "Dan"]
spring = [[0, 9, 5, 0], [9, 0, 8, 7], [5, 8, 0, 6], [0, 7, 6, 0]]
delay = [[0, 0.1, 0.1, 0.1], [0.1, 0, 0.1, 0.1], [0.1, 0.1, 0, 0.1], [0.1, 0.1, 0.1, 0]]
links = [[1, 2], [2, 3], [3, 4]]
"""


def key(number: int) -> bytes:
    return bytes([number]) * 32


class World:
    """A coordinator and those who talk to it, on a clock of its own."""

    def __init__(self, text: str = NETWORK, **options: Any) -> None:
        self.session = SessionFile.from_toml(text)
        self.coordinator = Coordinator(self.session, **options)
        self.now = 0.0
        self.present = {HOST}
        self.refusals: dict[bytes, str] = {}

    def join(self, number: int, name: str, body: list[float] = BODY) -> None:
        self.present.add(key(number))
        self.tick()
        wish = Join(name=name, fingerprint=body, version="1")
        self.coordinator.hear(Message(key(number), "join", write(wish), direct=False), self.now)
        self.tick()

    def tick(self, seconds: float = 0.0) -> None:
        end = self.now + seconds
        while True:
            for topic, body, to in self.coordinator.tick(self.now, frozenset(self.present)):
                if topic == "refused" and to is not None:
                    refused = read(Refused, body)
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
        return {entry.seat: entry.name for entry in self.roster.members}


def test_a_name_of_the_file_gets_its_own_seat_and_its_links() -> None:
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
    world.coordinator.hear(Message(key(1), "leave", b"", direct=False), world.now)  # Ben
    assert world.names == {0: "Ann", 2: "Cleo", 3: "Dan"}
    assert world.roster.links == [(0, 2), (2, 3)]


def test_another_name_takes_a_free_seat_until_none_is_left() -> None:
    world = World()
    for number in range(5):
        world.join(number, f"guest {number}")
    assert len(world.roster.members) == 4
    assert "all 4 seats" in world.refusals[key(4)]


def test_a_name_that_is_here_is_refused_and_one_that_crashed_comes_back_to_its_seat() -> None:
    world = World()
    world.join(1, "Ben")
    world.join(2, "Ben")
    assert '"Ben" is taken' in world.refusals[key(2)]
    world.present.discard(key(1))  # crashed, and not yet missed
    world.join(3, "Ben")
    assert world.names == {1: "Ben"}
    assert world.roster.members[0].key == key(3).hex()


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
        world.present.discard(key(number - 1))
        world.join(number, "Ann")
    assert world.names == {0: "Ann"}
    assert set(world.coordinator._seen) == {key(59).hex()}


def test_another_body_is_refused() -> None:
    world = World()
    world.join(1, "Ann")
    world.join(2, "Ben", [1.0, 2.0 + 1e-9])
    world.join(3, "Cleo", [1.0, -2.0])
    assert world.names == {0: "Ann", 1: "Ben"}
    assert "another body" in world.refusals[key(3)]


def test_a_wish_said_again_changes_nothing() -> None:
    world = World()
    world.join(1, "Ann")
    epoch = world.roster.epoch
    world.join(1, "Ann")
    world.tick(5.0)
    assert world.roster.epoch == epoch


def test_the_host_decides_then_the_lowest_seat_that_is_there() -> None:
    world = World()
    world.join(7, "Cleo")
    world.join(8, "Ann")
    roster = world.roster
    assert acting(roster, HOST, frozenset([HOST, key(7), key(8)])) == HOST
    assert acting(roster, HOST, frozenset([key(7), key(8)])) == key(8)
    assert acting(roster, HOST, frozenset([key(7), key(9)])) == key(7)
    assert acting(roster, HOST, frozenset([key(9)])) is None


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


def status(seat: int, paths: dict[int, float]) -> bytes:
    return write(Status(seat=seat, links=[LinkStatus(seat=j, state="coupled", path=t) for j, t in paths.items()]))


def test_links_are_planned_from_what_is_measured_and_anew_when_it_changes() -> None:
    asked: list[dict[tuple[int, int], float]] = []

    def planner(seats: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]] | None:
        asked.append(paths)
        if len(asked) % 2:
            return None  # still at work
        worst = max(paths, key=lambda pair: paths[pair], default=None)
        return [(a, b) for a in seats for b in seats if a < b and (a, b) != worst]

    world = World('[session]\nusers = 3\nlinks = "plan"\nreplan = true\n', planner=planner)
    for number in range(3):
        world.join(number, f"{number}")
    world.tick(6.0)
    assert world.roster.links == [(0, 1), (0, 2), (1, 2)]
    slow = status(0, {1: 0.5, 2: 0.04})
    world.coordinator.hear(Message(key(0), "status", slow, direct=False), world.now)
    world.tick(20.0)
    assert world.roster.links == [(0, 2), (1, 2)]
    count = len(asked)
    world.coordinator.hear(Message(key(0), "status", status(0, {1: 0.51, 2: 0.04}), direct=False), world.now)
    world.tick(20.0)
    assert len(asked) == count


@pytest.mark.parametrize("body", [b"", b"{}", b"\xff" * 50, b'{"name": 3}', b'{"name": "", "fingerprint": []}'])
def test_nonsense_changes_nothing(body: bytes) -> None:
    world = World()
    world.join(1, "Ann")
    before = world.roster
    for topic in ("join", "status", "roster", "what"):
        world.coordinator.hear(Message(key(9), topic, body, direct=False), world.now)
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
    world = World(planner=lambda seats, paths: [(0, 1), (1, 2)][: len(seats) - 1])
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
