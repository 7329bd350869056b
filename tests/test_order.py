"""Nothing is lost when tests are put in order, and modules stay whole."""

import itertools
from dataclasses import dataclass
from pathlib import Path

from tests.order import COMPUTING, TIMED, WAITING, ordered


@dataclass(frozen=True)
class Named:
    nodeid: str


def test_what_is_named_is_there_and_named_once():
    named = [*TIMED, *WAITING, *COMPUTING]
    assert len(set(named)) == len(named)
    assert not [name for name in named if not (Path(__file__).parent / name).is_file()]


def test_what_takes_long_comes_first_and_modules_stay_whole():
    modules = [*(f"quick/test_{k}.py" for k in range(60)), *COMPUTING, *WAITING]
    items = [Named(f"tests/{module}::test_{k}") for module in modules for k in range(3)]
    found = ordered(items)
    assert sorted(found, key=lambda item: item.nodeid) == sorted(items, key=lambda item: item.nodeid)
    seen = [item.nodeid.partition("::")[0].removeprefix("tests/") for item in found]
    assert sum(a != b for a, b in itertools.pairwise(seen)) == len(modules) - 1
    assert seen[:9:3] == [WAITING[0], COMPUTING[0], WAITING[1]]
    assert set(seen[: 3 * (len(WAITING) + len(COMPUTING))]) == {*WAITING, *COMPUTING}
