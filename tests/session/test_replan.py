"""Links are chosen anew, by the real planner, while people hold the object; all on a virtual clock."""

import time
from collections.abc import Iterator

import numpy as np
import pytest
from tests.session.world import World

from cotouch.members import SessionFile
from cotouch.samples import PathLaw
from cotouch.session import LinkPlanner

FOUR = """
[session]
users = 4
links = "plan"
link_count = 3
objective = "damping"
replan = {replan}
[body]
mass = 0.5
damping = 0.2
[steps]
rate = 100
[[hands]]
user = 1
path = [[0, 0], [1, 0.05]]
stiffness = 40.0
damping = 1.0
"""
NEAR, FAR = PathLaw(delay=0.005), PathLaw(delay=0.1)


class Waited:
    """The planner, as if its search took no time: its thread's clock is not the session's."""

    def __init__(self, planner: LinkPlanner) -> None:
        self.planner, self.asked = planner, 0

    def __call__(self, slots: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]] | None:
        self.asked += 1
        for _ in range(6000):
            links = self.planner(slots, paths)
            if links is not None:
                return links
            time.sleep(0.01)
        raise AssertionError("it never answers")


@pytest.fixture(params=["true", "false"])
def text(request: pytest.FixtureRequest) -> str:
    return FOUR.format(replan=request.param)


@pytest.fixture
def planner(text: str) -> Iterator[Waited]:
    made = LinkPlanner(SessionFile.from_toml(text))
    yield Waited(made)
    made.close()


def test_who_moved_away_is_joined_where_it_is_now(text: str, planner: Waited) -> None:
    """Dan is near Ann first, and then near Ben: his link goes over, nobody is thrown, and everything couples again."""
    world = World(text, planner=planner, tick=1e-3, law=NEAR)
    ann, ben, cleo, dan = (world.join(name, moves=name == "Ann") for name in ("Ann", "Ben", "Cleo", "Dan"))
    for other in (ben, cleo):
        world.paths(other, dan, FAR)
    world.until(lambda: planner.asked > 0 and world.all_coupled(), 20.0)
    world.run(2.0)
    before = world.people[0].member.roster
    assert [link for link in before.links if 3 in link] == [(0, 3)]
    place = dan.position.copy()

    world.paths(ann, dan, FAR)
    world.paths(ben, dan, NEAR)
    fastest = 0.0
    for _ in range(120):
        world.run(0.1)
        fastest = max(fastest, *(float(np.abs(p.copy.peer.state.velocity).max()) for p in world.people))
    after = world.people[0].member.roster
    if "replan = false" in text:
        assert (after.links, after.epoch, planner.asked) == (before.links, before.epoch, 1)
        return
    assert [link for link in after.links if 3 in link] == [(1, 3)]
    assert len(after.links) == 3
    assert after.epoch == before.epoch + 1  # once, not back and forth
    assert all(p.member.roster.links == after.links for p in world.people)
    assert world.all_coupled()
    assert fastest < 0.01
    assert float(np.abs(dan.position - place).max()) < 5e-3
    assert world.apart() < 1e-3
    world.check()
