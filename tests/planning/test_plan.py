"""The planner against the known table, against itself by other ways, and against brute force."""

import math
import pickle
from itertools import count

import numpy as np
import pytest
from tests.planning.support import GRID, five_users, pairs, small_network

from cotouch import plan
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import Network, complete, connected_graphs, mixing, rightmost_root, ring, rule_damping
from cotouch.planning import PlanInterrupted, survey

TABLE = [
    ("consensus", "equation", "12 14 23 24 34 45", 0.993061, None, 1.0, 7),
    ("consensus", "matrix", "12 23 24 34 35 45", 0.992725, "13 14 23 24 35 45", 0.999828, 0),
    ("decay", "equation", "12 14 23 24 34 45", -1.428553, "13 14 23 25 34 35", -0.289652, 0),
]


@pytest.mark.parametrize(("objective", "convention", "best", "value", "worst", "last", "periodic"), TABLE)
def test_the_paper_s_five_users(objective, convention, best, value, worst, last, periodic):
    found = plan(five_users(), links=6, objective=objective, convention=convention)
    assert (found.status, found.choices, found.graphs, found.periodic) == ("proved", 210, 205, periodic)
    assert found.best.links == pairs(best)
    assert found.best.value == pytest.approx(value, abs=1e-6)
    assert found.worst.value == pytest.approx(last, abs=1e-6)
    if worst is None:
        assert found.worst.cycle_period > 1
        assert found.worst.time_constant_s == math.inf
        assert found.worst.value == 1.0
    else:
        assert found.worst.links == pairs(worst)


@pytest.mark.parametrize(
    ("convention", "unit", "periodic"), [("equation", 0.05, 11), ("matrix", 0.05, 17), ("equation", 0.01, 7)]
)
def test_periodic_graphs_are_counted(convention, unit, periodic):
    found = plan(five_users(), links=6, convention=convention, time_unit=unit, rounding="up")
    assert found.periodic == periodic


def test_a_choice_says_what_the_network_room_says():
    network = five_users()
    for choice in plan(network, links=6, objective="decay", top=3).top:
        linked = network.with_links(choice.links)
        reference = rightmost_root(linked)
        assert choice.value == pytest.approx(reference.rate, rel=1e-9)
        assert choice.time_constant_s == pytest.approx(reference.time_constant_s, rel=1e-9)
        np.testing.assert_allclose(choice.damping, reference.sync_damping)
    for choice in plan(network, links=6, convention="matrix", top=3).top:
        reference = mixing(network.with_links(choice.links), time_unit=0.01, convention="matrix")
        assert choice.value == pytest.approx(reference.value, abs=1e-10)
        assert choice.time_constant_s == pytest.approx(reference.time_constant_s, rel=1e-6)


def test_the_slowest_body_mode_counts():
    network, modes = five_users(), {"mass": [1.0, 1.0], "stiffness": [0.0, 300.0]}
    found = plan(network, links=6, objective="decay", **modes)
    linked = network.with_links(found.best.links)
    rates = [rightmost_root(linked, mass=1.0, stiffness=k).rate for k in modes["stiffness"]]
    assert found.best.value == pytest.approx(max(rates), rel=1e-9)
    assert found.best.value >= plan(network, links=6, objective="decay").best.value


def test_worst_path_follows_the_links_one_way():
    delay = np.array([[0, 0.1, 9, 9], [0.2, 0, 0.3, 9], [9, 0.4, 0, 0.5], [9, 9, 0.6, 0]])
    spring = np.zeros((4, 4))
    for i in range(3):
        spring[i, i + 1] = spring[i + 1, i] = 10.0
    found = plan(Network(users=list("abcd"), spring=spring, delay=delay), links=3, objective="damping")
    assert found.best.worst_path_s == pytest.approx(0.2 + 0.4 + 0.6)  # to the user from its predecessor, all the way


def test_the_worst_path_of_no_delays_is_none():
    spring = 10.0 * (1.0 - np.eye(3))
    assert (
        plan(
            Network(users=list("abc"), spring=spring, delay=np.zeros((3, 3))), links=2, objective="decay"
        ).best.worst_path_s
        == 0.0
    )


@pytest.mark.parametrize("seed", range(100))
def test_three_ways_agree_on_random_networks(seed: int):
    """Enumeration, branch and bound, and local search; damping also against brute force."""
    network, links = small_network(np.random.default_rng(seed))
    rule = {
        graph: float(rule_damping(network.with_links(graph), ages=network.delay).max())
        for graph in connected_graphs(network, links=links)
    }
    every = plan(network, links=links, objective="damping", top=3)
    assert every.graphs == len(rule)
    assert every.worst.value == pytest.approx(max(rule.values()), rel=1e-12)
    for method, status in (("enumerate", "proved"), ("bound", "proved"), ("local", "best found")):
        found = plan(network, links=links, objective="damping", top=3, method=method, starts=24, seed=seed)
        assert found.status == ("proved" if found.bound == found.best.value else status)
        values = [choice.value for choice in found.top]
        expected = sorted(rule.values())[: len(values)]
        np.testing.assert_allclose(
            values if method != "local" else values[:1], expected[: None if method != "local" else 1]
        )
        assert all(choice.value == pytest.approx(rule[choice.links], rel=1e-12) for choice in found.top)
    for objective in ("consensus", "decay"):
        options = {"links": links, "objective": objective, "time_unit": GRID}
        proved = plan(network, **options)
        # Where no graph mixes, none is better than another.
        assert proved.status == ("best found" if proved.periodic == proved.graphs else "proved")
        for starts in (24, 80):  # few networks need more than the first, which are the same
            found = plan(network, **options, method="local", starts=starts, seed=seed)
            if found.best.value == pytest.approx(proved.best.value, abs=1e-9):
                break
        assert found.best.value == pytest.approx(proved.best.value, abs=1e-9)


def test_limits_on_the_links_are_kept():
    network = five_users()
    require, forbid = pairs("13"), pairs("24 45")
    for method in ("enumerate", "bound", "local"):
        found = plan(network, links=5, objective="damping", require=require, forbid=forbid, max_degree=3, method=method)
        allowed = [
            graph
            for graph in connected_graphs(network, links=5)
            if set(require) <= set(graph)
            and not set(forbid) & set(graph)
            and network.with_links(graph).adjacency().sum(axis=1).max() <= 3
        ]
        best = min(rule_damping(network.with_links(graph), ages=network.delay).max() for graph in allowed)
        assert found.best.value == pytest.approx(best)
        assert all(choice.links in allowed for choice in (*found.top, found.worst))
        if method == "enumerate":
            assert found.graphs == len(allowed)


def test_branch_and_bound_proves_what_nobody_can_enumerate():
    rng = np.random.default_rng(10)
    spring, delay = np.triu(rng.uniform(10, 100, (10, 10)), 1), rng.uniform(0.01, 0.5, (10, 10)) * (1 - np.eye(10))
    network = Network(users=[str(i) for i in range(10)], spring=spring + spring.T, delay=delay)
    found = plan(network, links=15, objective="damping")
    assert (found.status, found.method) == ("proved", "bound")
    assert found.choices == math.comb(45, 15)


def test_a_seed_repeats_whatever_the_number_of_jobs():
    one, two = (
        plan(five_users(), links=6, objective="decay", method="local", starts=6, seed=3, jobs=jobs) for jobs in (1, 3)
    )
    assert [choice.links for choice in one.top] == [choice.links for choice in two.top]
    assert (one.graphs, one.best.value, one.worst.links) == (two.graphs, two.best.value, two.worst.links)


def test_out_of_time_gives_the_best_so_far():
    seconds, calls = count(), []
    found = plan(
        five_users(),
        links=6,
        objective="decay",
        method="local",
        starts=10_000,
        seconds=5,
        clock=lambda: float(next(seconds)),
        progress=lambda *report: calls.append(report),
    )
    assert found.status == "best found"
    assert 0 < len(calls) <= 6
    assert found.best.value == pytest.approx(calls[-1][2])


def test_out_of_time_in_the_middle_of_every_flood_gives_what_they_hold():
    """Whatever the size, the budget does not wait for a flood to end."""
    rng = np.random.default_rng(0)
    spring = np.triu(rng.uniform(20, 100, (40, 40)), 1)
    delay = rng.uniform(0.02, 0.4, (40, 40)) * (1 - np.eye(40))
    network = Network(users=[str(i) for i in range(40)], spring=spring + spring.T, delay=delay)
    rounds = []
    found = plan(
        network,
        links=80,
        objective="decay",
        method="local",
        seconds=2,
        # After one slice of every flood it is time to close, and over once one of them is worked out.
        clock=lambda: (0.0, 1.96, 3.0)[(len(rounds) >= 8) + (len(rounds) >= 9)],
        progress=lambda *report: rounds.append(report),
        jobs=1,
    )
    assert found.status == "best found"
    assert rounds[0][2] < math.inf, "the first start is worked out before its flood"
    assert len(rounds) < 20
    assert found.graphs > 8, "beside the first starts, what a flood held is worked out at the end"
    assert found.best.value <= rounds[0][2]
    assert found.best.value == pytest.approx(rightmost_root(network.with_links(found.best.links)).rate, rel=1e-9)


def test_interrupted_gives_the_best_so_far():
    def interrupt(done: int, total: int, best: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt) as raised:
        plan(five_users(), links=6, objective="decay", progress=interrupt, jobs=1)
    assert isinstance(raised.value, PlanInterrupted)
    found = raised.value.plan
    assert found.status == "best found"
    assert 0 < found.graphs < 205


def test_a_ring_of_equals_never_mixes():
    """Even rings with equal delays are bipartite: information goes to and fro."""
    spring = np.zeros((4, 4))
    for i, j in ring(4):
        spring[i, j] = spring[j, i] = 1.0
    found = plan(Network(users=list("abcd"), spring=spring, delay=0.01 * (1 - np.eye(4))), links=4)
    assert (found.best.value, found.best.cycle_period, found.periodic) == (1.0, 2, 1)


def make(**changes: object) -> Network:
    base = {"users": list("abcd"), "spring": 10.0 * (1 - np.eye(4)), "delay": 0.01 * (1 - np.eye(4))}
    return Network(**(base | changes))


NOT_JOINED = np.kron(np.eye(2), [[0, 1], [1, 0]])

BAD = [
    ({"links": 2}, "links is 2; .* it must be 3 to 6"),
    ({"links": 7}, "links is 7; .* it must be 3 to 6"),
    ({"links": 4, "forbid": pairs("12 13 14")}, "separate groups"),
    ({"links": 4, "require": pairs("12"), "forbid": pairs("12")}, "the link a-b is both in require and in forbid"),
    ({"links": 3, "require": pairs("12 13 14 23")}, "require holds 4 links but links is 3"),
    (
        {"links": 4, "require": pairs("12 13 14"), "max_degree": 2},
        r'require gives user 1 \("a"\) 3 links but max_degree is 2',
    ),
    ({"links": 5, "max_degree": 2}, "links is 5; with max_degree 2 .* at most 4"),
    ({"links": 4, "max_degree": 1}, "max_degree is 1; .* at least 2"),
    ({"links": 3, "require": [(0, 4)]}, "require holds 1-5; .* numbered 1 to 4"),
    ({"links": 3, "forbid": [(1, 1)]}, "forbid holds 2-2"),
    ({"links": 3, "max_degree": 2, "forbid": pairs("23 24 34")}, "no choice of 3 links connects all 4 users"),
    ({"links": 3, "objective": "speed"}, 'objective is "speed"'),
    ({"links": 3, "convention": "both"}, 'convention is "both"'),
    ({"links": 3, "time_unit": math.nan}, "time_unit is nan"),
    ({"links": 3, "method": "bound"}, 'method is "bound" but objective is "consensus"'),
    ({"links": 3, "method": "luck"}, 'method is "luck"'),
    ({"links": 3, "top": 0}, "top is 0"),
    ({"links": 3, "top": 10**12}, "top is 1000000000000; it must be at most 1000"),
    ({"links": 3, "seed": -1}, "seed is -1"),
    ({"links": 3, "seconds": math.nan}, r"the time limit \(seconds\) is nan"),
    ({"links": 3, "objective": "decay", "mass": 0.0}, "mass is 0 kg"),
    ({"links": 3, "objective": "decay", "mass": [1.0, 2.0], "damping": [1.0, 2.0, 3.0]}, "have 2, 3, 1 entries"),
    ({"links": 3, "objective": "decay", "sync_damping": [1.0]}, "sync_damping has shape"),
]


@pytest.mark.parametrize(("options", "message"), BAD)
def test_what_cannot_be_is_one_sentence(options, message):
    with pytest.raises(NetworkError, match=message) as caught:
        plan(make(), **options)
    assert "\n" not in str(caught.value)


def test_networks_that_cannot_be_planned():
    with pytest.raises(NetworkError, match="separate groups"):
        plan(make(spring=NOT_JOINED), links=3)
    with pytest.raises(NetworkError, match="equation convention needs at least 1"):
        plan(make(delay=np.zeros((4, 4))), links=3)
    assert plan(make(delay=np.zeros((4, 4))), links=6, convention="matrix").best.cycle_period == 1
    with pytest.raises(NetworkError, match="at least 2"):
        plan(Network(users=["a"], spring=[[0]], delay=[[0]]), links=0)
    with pytest.raises(UnsupportedError, match="weights"):
        plan(make(weight=np.diag([1.0, 2.0])), links=3, objective="decay")
    found = plan(make(weight=np.diag([1.0, 2.0])), links=3, objective="damping")
    assert math.isnan(found.best.time_constant_s)


def test_a_never_that_only_max_degree_makes_impossible_is_found_by_every_way():
    """A star is all that is left, and its middle may not have three links."""
    for method in ("enumerate", "bound", "local"):
        with pytest.raises(NetworkError, match="no choice of 3 links"):
            plan(make(), links=3, max_degree=2, forbid=pairs("23 24 34"), method=method, objective="damping")


def test_a_plan_survives_a_pipe():
    found = plan(make(), links=6, objective="damping")
    again = pickle.loads(pickle.dumps(found))
    assert again.best.links == found.best.links == complete(4)
    assert again.numbers() == found.numbers()


@pytest.mark.parametrize("seed", range(4))
def test_what_is_not_worked_out_is_neither_among_the_best_nor_the_worst(seed):
    """The enumeration of a consensus leaves out what cannot count; the survey leaves out nothing."""
    network, links = small_network(np.random.default_rng(100 + seed))
    found = plan(network, links=links, time_unit=GRID, top=4)
    every = survey(network, links=links, objectives={"all": {"time_unit": GRID}}).values["all"]
    np.testing.assert_allclose([choice.value for choice in found.top], np.sort(every)[:4], rtol=1e-9)
    assert found.worst.value == pytest.approx(every.max(), rel=1e-9)
    assert (found.graphs, found.periodic) == (len(every), int((every == 1.0).sum()))


def test_only_a_look_at_every_choice_proves_the_worst():
    for method, status, worst in (
        ("enumerate", "proved", "proved"),
        ("bound", "proved", "worst found"),
        ("local", "best found", "worst found"),
    ):
        found = plan(five_users(), links=6, objective="damping", method=method)
        assert (found.status, found.worst_status, found.numbers()["worst_status"]) == (status, worst, worst)
