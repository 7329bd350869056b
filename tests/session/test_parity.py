"""One scenario, simulated and lived: what users do and feel is the same."""

import tomllib
from typing import NamedTuple

import numpy as np
import pytest
import xarray as xr
from tests.session.world import Person, World

from cotouch.samples import PathLaw
from cotouch.simulation import settling_time, simulate

BEGIN, END = 4.0, 10.0
PERIOD = 0.002
NAMES = ("Ann", "Ben", "Cleo")
# Both hands move once everybody is coupled, which the simulator's users are from the start.
SCENARIO = f"""
[network]
users = ["Ann", "Ben", "Cleo"]
spring = [[0, 60, 50], [60, 0, 45], [50, 45, 0]]
delay = [[0, 0.12, 0.2], [0.08, 0, 0.1], [0.2, 0.15, 0]]
links = [[1, 2], [2, 3]]
[body]
mass = 0.5
[steps]
period = {PERIOD}
duration = {END}
[synchronisation]
law = LAW
[session]
OPTIONS
[[hands]]
user = 1
path = [[0, 0], [{BEGIN}, 0], [{BEGIN + 0.5}, 0.1]]
stiffness = 60.0
damping = 2.0
[[hands]]
user = 3
path = [[0, 0], [{BEGIN}, 0], [{BEGIN + 0.5}, -0.06]]
stiffness = 60.0
damping = 2.0
"""


class Lived(NamedTuple):
    run: xr.Dataset
    damping: np.ndarray
    guarded: int


# Live, what ends tell of each other's hands begins later and has bounds of its own: a longer way to the same rest.
ALONE = '{kind = "paid", relay = 0.0}'


def live(law: str) -> Lived:
    """The members' motion, with the names of a simulated run; each one's time begins when it begins to move."""
    text = SCENARIO.replace("LAW", ALONE if law == "paid" else f'"{law}"')
    rows: list[list[tuple[float, float, float]]] = [[] for _ in NAMES]
    world = World(text.replace("OPTIONS", "margin = 0.0" if law == "spring" else ""), tape=Tape(rows))
    network = world.session.scenario.network
    people = [world.join(name) for name in NAMES]
    for i, one in enumerate(people):
        for j, other in enumerate(people):
            if i != j:
                world.paths(one, other, PathLaw(delay=float(network.delay[j, i])), both=False)
    world.until(world.all_coupled, BEGIN)
    assert all(person.copy.peer is not None for person in people)
    world.run(END + 1.8 - world.now)
    world.check()
    size = min(len(kept) for kept in rows)
    kept = np.array([entry[:size] for entry in rows])
    for person in people:
        kept[person.copy.slot, :, 0] -= world.now - person.copy.status(world.now).time
    run = xr.Dataset(
        attrs={"scenario": simulated(law=law).attrs["scenario"]},
        data_vars={
            "time": (("user", "step"), kept[..., 0]),
            "position": (("user", "step", "node", "axis"), kept[..., 1, None, None]),
            "force": (("user", "step", "axis"), kept[..., 2, None]),
        },
    )
    return Lived(run, np.array([damping_of(person) for person in people]), sum(map(guarded, people)))


class Tape:
    """Keeps time on the world's clock, place and the hand's force of every step."""

    begun, failure = True, None

    def __init__(self, rows: list[list[tuple[float, float, float]]]) -> None:
        self._rows = rows

    def setup(self, copy, now: float) -> None:
        pass

    def step(self, copy, report, now: float, T: float) -> None:
        place = float(copy.peer.model.to_nodes(copy.peer.state.position)[0, 0])
        self._rows[copy.slot].append((now, place, float(report.force.sum())))

    def event(self, kind: str, time: float, **fields) -> None:
        pass


def damping_of(person: Person) -> float:
    return float(person.copy.damping.sum())


def guarded(person: Person) -> int:
    return sum(held.guarded for held in person.copy.neighbours.values())


def simulated(law: str | dict[str, object] = "spring", **synchronisation: object) -> xr.Dataset:
    tables = tomllib.loads(SCENARIO.replace("LAW", '"spring"').replace("OPTIONS", ""))
    del tables["session"]
    return simulate(tables | {"synchronisation": {"law": law, **synchronisation}})


@pytest.fixture(scope="module")
def lived() -> Lived:
    return live("spring")


@pytest.fixture(scope="module")
def expected() -> xr.Dataset:
    return simulated()


def test_with_the_law_that_pays_copies_are_at_the_same_places() -> None:
    """Forces are what is left of hands that nearly balance, and differ by more: live, links that may come count too."""
    lived, expected = live("paid"), simulated({"kind": "paid", "relay": 0.0})
    for user in (0, 2):
        moved, foreseen = during(lived.run, "position", user), during(expected, "position", user)
        assert np.abs(moved - foreseen).max() < 0.06 * np.abs(foreseen).max()
        assert abs(moved[-1] / foreseen[-1] - 1.0) < 3e-3


def settled(run: xr.Dataset, variable: str) -> float:
    found = settling_time(run, variable, start=BEGIN, stop=END)
    assert found is not None
    return found


def during(run: xr.Dataset, variable: str, user: int) -> np.ndarray:
    time = run["time"].values[user]
    return np.interp(np.linspace(BEGIN, END, 1201), time, run[variable].values[user].reshape(time.size, -1)[:, 0])


@pytest.mark.parametrize("variable", ["position", "force"])
def test_it_settles_as_soon(lived: Lived, expected: xr.Dataset, variable: str) -> None:
    assert abs(settled(lived.run, variable) / settled(expected, variable) - 1.0) < 0.05
    assert lived.guarded == 0


@pytest.mark.parametrize("user", [0, 2])
def test_hands_feel_the_same_force_at_every_moment(lived: Lived, expected: xr.Dataset, user: int) -> None:
    felt, foreseen = during(lived.run, "force", user), during(expected, "force", user)
    assert np.abs(felt - foreseen).max() < 0.05 * np.abs(foreseen).max()
    assert abs(felt[-1] / foreseen[-1] - 1.0) < 1e-3


def test_what_differs_is_the_slack_of_the_budgets(lived: Lived, expected: xr.Dataset) -> None:
    """Live users agree on budgets with two periods of slack at each end, and their steps are not on one grid.

    In the simulator they are: each sample is there at the instant of a step, where a live one waits for up to a period.
    """
    by_rule = expected["local_damping"].values[:, 0]
    joined = np.array([60.0, 105.0, 45.0])  # springs of each user's links [N/m]
    more = 2.0 * (lived.damping - by_rule) / joined  # in both ages of a link [s]
    slack = 2 * 2 * PERIOD
    assert (more >= slack).all()
    assert (more < slack + 4 * PERIOD).all()
    same = simulated(damping=lived.damping.tolist())
    assert abs(settled(lived.run, "position") / settled(same, "position") - 1.0) < 0.015
    for user in range(3):
        moved, foreseen = during(lived.run, "position", user), during(same, "position", user)
        assert np.abs(moved - foreseen).max() < 0.01 * np.abs(foreseen).max()
