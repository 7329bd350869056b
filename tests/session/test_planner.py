import time
from collections.abc import Callable
from typing import Any

import pytest

from cotouch.members import SessionFile
from cotouch.planning import Plan, plan, worked
from cotouch.session import LinkPlanner

# Three fast users and one at the end of a slow line.
SLOW = {(0, 1): 0.02, (0, 2): 0.02, (1, 2): 0.02, (0, 3): 0.4, (1, 3): 0.1, (2, 3): 0.4}


def planned(text: str, slots: list[int], paths: dict[tuple[int, int], float]) -> list[tuple[int, int]]:
    planner = LinkPlanner(SessionFile.from_toml(text))
    try:
        for _ in range(6000):
            links = planner(slots, paths)
            if links is not None:
                return links
            time.sleep(0.02)
        raise AssertionError("it never answers")
    finally:
        planner.close()


class Here:
    """Works out in this process what a process of its own would, which loads for seconds."""

    done = True

    def __init__(self, function: Callable[..., object], *args: object) -> None:
        self._found = function(*args)

    def result(self) -> object:
        return self._found

    def kill(self) -> None:
        pass


@pytest.fixture
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.session._planner.ChildCall", Here)


@pytest.mark.parametrize("objective", ["damping", "drag", "feel"])
def test_the_one_at_the_end_of_a_slow_line_is_joined_where_it_is_nearest(objective: str) -> None:
    text = f'[session]\nusers = 4\nlinks = "plan"\nlink_count = 3\nobjective = "{objective}"\n'
    links = planned(text, [0, 1, 2, 3], SLOW)
    assert (1, 3) in links
    assert len(links) == 3


@pytest.mark.usefixtures("here")
def test_only_those_who_are_there_are_linked() -> None:
    links = planned('[session]\nusers = 4\nlinks = "plan"\nobjective = "damping"\n', [1, 3], SLOW)
    assert links == [(1, 3)]


@pytest.mark.usefixtures("here")
def test_its_budget_counts_what_it_has_worked_and_hardly_what_it_has_waited(monkeypatch: pytest.MonkeyPatch) -> None:
    clocks: list[object] = []

    def noted(*args: Any, **options: Any) -> Plan:
        clocks.append(options.get("clock"))
        return plan(*args, **options)

    monkeypatch.setattr("cotouch.session._planner.plan", noted)
    monkeypatch.setattr("cotouch.session._planner.compiles", lambda: False)
    planned('[session]\nusers = 4\nlinks = "plan"\nobjective = "damping"\n', [0, 1, 2, 3], SLOW)
    assert clocks == [worked]


@pytest.mark.usefixtures("here")
def test_springs_that_cannot_join_all_keep_what_is_given() -> None:
    text = """
[session]
links = "plan"
[network]
users = ["1", "2", "3"]
spring = [[0, 9, 0], [9, 0, 0], [0, 0, 0]]
delay = [[0, 0.1, 0.1], [0.1, 0, 0.1], [0.1, 0.1, 0]]
links = [[1, 2]]
"""
    assert planned(text, [0, 1, 2], {}) == [(0, 1)]
