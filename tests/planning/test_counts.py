"""Several numbers of links, and links with their springs."""

import numpy as np
import pytest
from tests.planning.support import five_users, pairs

from cotouch.errors import NetworkError
from cotouch.network import Network, rightmost_root
from cotouch.planning import plan, plan_counts, plan_springs, tune_springs


def test_the_paper_s_users_are_faster_with_fewer_links():
    found = plan_counts(five_users(), links=range(4, 8), objective="decay")
    rates = {len(one.best.links): one.best.value for one in found.plans}
    assert rates[5] == pytest.approx(-5.1, abs=0.05)
    assert rates[6] == pytest.approx(-1.428553, abs=1e-6)
    best = min(rates, key=lambda count: rates[count])
    near = min(count for count, rate in rates.items() if rate <= 0.9 * rates[best])
    assert (len(found.best.best.links), len(found.knee.best.links)) == (best, near)
    said = found.numbers()
    assert (said["knee"], [one["links"] for one in said["counts"]]) == (near, [4, 5, 6, 7])
    assert all(one["value"] == pytest.approx(rates[one["links"]]) for one in said["counts"])


def test_numbers_of_links_that_cannot_be_are_left_out():
    found = plan_counts(five_users(), links=[3, 4, 5], objective="damping")
    assert [len(one.best.links) for one in found.plans] == [4, 5]
    with pytest.raises(NetworkError, match="links is 2"):
        plan_counts(five_users(), links=[2, 3], objective="damping")


@pytest.mark.slow
def test_springs_decide_which_links_are_best():
    """With springs of their own, other links are better than those that are best with the paper's springs."""
    limits = {"links": 6, "require": pairs("12 23 24 34 45")}
    first = plan(five_users(), objective="decay", **limits).best.links
    alone = tune_springs(five_users().with_links(first), damping_limit=42.0)
    joint = plan_springs(five_users(), damping_limit=42.0, **limits)
    assert alone.after > -6.0
    assert joint.tuned.after < -6.6
    assert joint.rank != 1
    network = joint.tuned.network
    assert set(limits["require"]) < set(network.links)
    assert rightmost_root(network).rate == pytest.approx(joint.tuned.after, rel=1e-9)
    assert np.max(joint.tuned.sync_damping) <= 42.0 * (1 + 1e-9)


def test_links_that_are_forbidden_are_not_swapped_in():
    """Three users in a row: what the row in the middle lacks is best, and a swap would lead to it."""
    delay = np.array([[0.0, 0.02, 0.4], [0.02, 0.0, 0.03], [0.4, 0.03, 0.0]])
    network = Network(users=list("abc"), spring=40.0 * (1 - np.eye(3)), delay=delay)
    options = {"links": 2, "damping_limit": 20.0}
    assert plan_springs(network, **options).tuned.network.links == ((0, 1), (1, 2))
    barred = plan_springs(network, forbid=[(1, 2)], **options).tuned.network
    assert barred.links == ((0, 1), (0, 2))


def test_all_numbers_of_links_share_the_time_and_begin_at_the_one_before(monkeypatch: pytest.MonkeyPatch):
    seconds, begins = [], []

    def planned(network, *, begin, **more):
        seconds.append(more.pop("seconds"))
        begins.append(begin)
        return plan(network, **more)

    monkeypatch.setattr("cotouch.planning._counts.plan", planned)
    found = plan_counts(five_users(), links=[4, 5, 6], objective="damping", seconds=9.0, clock=lambda: sum(seconds))
    assert seconds == [3.0, 3.0, 3.0]
    assert begins == [(), *(one.best.links for one in found.plans[:2])]
