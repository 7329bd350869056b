"""Damping and certificates: closed forms, brute force, optimisers, and the energy of random motions."""

import numpy as np
import pytest
import scipy.optimize
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.network.inside import age_sums_of, coefficients, damping_matrices, exact_margin, sync_hermitian
from tests.network.support import five_users, pairs, random_network, uniform
from tests.thorough import examples

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import (
    Network,
    certify,
    complete,
    damping_for,
    exact_scaling,
    link_damping,
    path,
    ring,
    rule_damping,
    star,
)

SPD = np.array([[2.0, 0.5], [0.5, 1.0]])
OTHER = np.array([[1.0, -0.3], [-0.3, 3.0]])


def off_diagonal(value, n):
    return value * (1 - np.eye(n, dtype=int))


def matrix_network(n=3):
    """A triangle (or path) with two different weights and one scalar spring."""
    spring = np.zeros((n, n, 2, 2))
    for (i, j), block in {(0, 1): 3 * SPD, (1, 2): OTHER, (0, 2): 2 * np.eye(2)}.items():
        spring[i, j] = spring[j, i] = block
    return Network(users=[str(i) for i in range(n)], spring=spring, delay=off_diagonal(0.2, n).astype(float))


# --- the rule and its weights -------------------------------------------------------------------------------------


def test_rule_is_theorem_1_with_the_neighbours_period():
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    rng = np.random.default_rng(0)
    steps, periods = rng.integers(1, 9, (5, 5)), rng.uniform(0.001, 0.02, 5)
    expected = [
        sum((steps[i, j] + steps[j, i]) / 2 * periods[j] * network.spring[i, j] for j in network.neighbours(i))
        for i in range(5)
    ]
    np.testing.assert_allclose(rule_damping(network, index_delay=steps, periods=periods)[:, 0], expected)


def test_age_rule_takes_only_the_sum_of_both_ages():
    network = five_users()
    ages = network.delay
    skewed = ages + np.triu(0.03 * np.ones((5, 5)), 1) - np.tril(0.03 * np.ones((5, 5)), -1)
    expected = ((ages + ages.T) / 2 * network.spring).sum(axis=1)
    np.testing.assert_allclose(rule_damping(network, ages=ages)[:, 0], expected)
    np.testing.assert_allclose(rule_damping(network, ages=skewed)[:, 0], expected)
    np.testing.assert_allclose(rule_damping(network)[:, 0], expected, err_msg="delays count as ages")
    of_links = link_damping(network.linked_spring(), ages + ages.T)
    np.testing.assert_allclose(of_links.sum(axis=1), expected, err_msg="of each link")


@settings(max_examples=examples(40), deadline=None)
@given(st.integers(0, 10**6))
def test_minimax_is_the_perron_eigenvalue_and_no_weights_do_better(seed):
    rng = np.random.default_rng(seed)
    network = random_network(rng)
    ages = rng.uniform(0.01, 1.0, (network.size,) * 2)
    best = damping_for(network, "minimax", ages=ages)[:, 0]
    G = (ages + ages.T) / 2 * network.linked_spring()
    np.testing.assert_allclose(best, np.linalg.eigvalsh(G)[-1], rtol=1e-10)
    for _ in range(20):
        d = np.exp(rng.normal(0, 0.5, network.size))
        assert damping_for(network, "rule", weights=d, ages=ages).max() >= best.max() * (1 - 1e-12)


@pytest.mark.parametrize("basis", ["ages", "index"])
def test_minimax_and_sum_agree_with_an_optimiser_over_every_share_of_every_link(basis):
    """The optimiser may choose each link's shares by themselves, `c_ij c_ji = reach^2`: weights d lose nothing."""
    rng = np.random.default_rng(7)
    for _ in range(4):
        network = random_network(rng, size=4)
        n, links = network.size, network.links
        if basis == "ages":
            declared = {"ages": rng.uniform(0.01, 1.0, (n, n))}
        else:
            declared = {"index_delay": rng.integers(1, 50, (n, n)), "periods": rng.uniform(0.001, 0.03, n)}
        reach, costs = age_sums_of(network, **declared).seconds, rng.uniform(0.3, 3.0, n)

        def damping(log_share, reach=reach, network=network, links=links):
            B = np.zeros(network.size)
            for t, (i, j) in zip(log_share, links, strict=True):
                B[i] += reach[i, j] * network.spring[i, j] * np.exp(t)
                B[j] += reach[i, j] * network.spring[i, j] * np.exp(-t)
            return B

        cheapest = scipy.optimize.minimize(
            lambda t, costs=costs: costs @ damping(t), np.zeros(len(links)), method="BFGS", tol=1e-10
        )
        found = damping_for(network, "sum", costs=costs, **declared)[:, 0]
        assert costs @ found == pytest.approx(cheapest.fun, rel=1e-6)

        def worst(z):
            return z[-1]

        level = scipy.optimize.minimize(
            worst,
            np.r_[np.zeros(len(links)), damping(np.zeros(len(links))).max()],
            constraints={"type": "ineq", "fun": lambda z: z[-1] - damping(z[:-1])},
            method="SLSQP",
            options={"ftol": 1e-12, "maxiter": 500},
        )
        assert damping_for(network, "minimax", **declared).max() == pytest.approx(level.fun, rel=1e-5)


def test_sum_with_equal_costs_is_the_plain_rule_for_ages():
    network = five_users()
    np.testing.assert_allclose(damping_for(network, "sum"), rule_damping(network))
    np.testing.assert_allclose(damping_for(network, "rule", weights=np.ones(5)), rule_damping(network))


def test_minimax_treats_components_and_lonely_users_by_themselves():
    network = uniform([(0, 1), (2, 3), (3, 4)], 6, spring=2.0)
    damping = damping_for(network, "minimax", ages=off_diagonal(0.5, 6))[:, 0]
    np.testing.assert_allclose(damping, [1, 1, 2**0.5, 2**0.5, 2**0.5, 0])


# --- energy: the rule, the weights and the exact test against motions ----------------------------------------------


def supplied(network, steps, periods, beta, v):
    """Energy that the ports put into the synchronisation control, and its springs' energy at the end. v: (k, N)."""
    K = network.linked_spring()
    count, n = v.shape
    x = np.vstack([np.zeros(n), np.cumsum(v * periods, axis=0)])
    mean = (x[1:] + x[:-1]) / 2
    total = 0.0
    for k in range(count):
        for i in range(n):
            force = beta[i, 0] * v[k, i]
            for j in np.flatnonzero(K[i]):
                late = mean[k - steps[i, j], j] if k >= steps[i, j] else 0.0
                force += K[i, j] * (mean[k, i] - late)
            total += periods[k, i] * v[k, i] * force
    stored = sum(K[i, j] * (x[-1, i] - x[-1, j]) ** 2 / 2 for i, j in network.links)
    return total, stored


def test_energy_of_a_motion_is_what_the_hermitian_part_says():
    """Sign of the phase included: the delays differ by direction on an odd cycle, where it cannot be gauged away."""
    rng = np.random.default_rng(4)
    network = random_network(rng, size=3).with_links(complete(3))
    steps = np.array([[0, 1, 5], [3, 0, 2], [1, 7, 0]])
    T, beta = 0.1, rng.uniform(0, 0.3, (3, 1))
    active, count = 12, 256
    v = np.zeros((count, 3))
    v[:active] = rng.normal(size=(active, 3))
    v[:active] -= v[:active].mean(axis=0)  # All return, so nothing stays in the springs.
    energy, stored = supplied(network, steps, np.full((count, 3), T), beta, v)
    assert stored == pytest.approx(0.0, abs=1e-20)
    theta = 2 * np.pi * np.arange(1, count // 2) / count
    V = np.fft.fft(v, axis=0)
    H = sync_hermitian(network, theta, index_delay=steps, period=T, damping=beta)
    power = np.einsum("ki,kij,kj->k", V[1 : count // 2].conj(), H, V[1 : count // 2]).real
    at_pi = (np.abs(V[count // 2]) ** 2 * beta[:, 0]).sum()
    assert energy == pytest.approx(T / count * (2 * power.sum() + at_pi), rel=1e-9)


def worst_start(H):
    return np.linalg.eigh(H)[1][:, 0]


@pytest.mark.parametrize("fraction", ["rule", "own", "random"])
def test_index_rule_with_own_varying_periods_never_gives_energy_away(fraction):
    rng = np.random.default_rng(11)
    for _ in range(25):
        network = random_network(rng, size=3)
        longest = rng.uniform(0.02, 0.3, 3)
        steps = rng.integers(0, 5, (3, 3))
        d = {"rule": np.ones(3), "own": 1 / longest, "random": np.exp(rng.normal(size=3))}[fraction]
        beta = damping_for(network, "rule", weights=d, index_delay=steps, periods=longest)
        if fraction == "own":
            half = (steps + steps.T) / 2 * network.linked_spring()
            np.testing.assert_allclose(beta[:, 0], longest * half.sum(axis=1), err_msg="one's own period, d = 1/T")
        periods = longest * rng.uniform(0.2, 1.0, (40, 3))
        for v in (rng.normal(size=(40, 3)), np.outer(np.ones(40), rng.normal(size=3))):
            energy, stored = supplied(network, steps, periods, beta, v)
            assert energy >= stored - 1e-12


def test_mixing_the_two_periods_over_one_link_is_not_valid():
    """The smaller of both shares looks like a rule, but gives energy away."""
    network = uniform(path(2), 2)
    longest, steps = np.array([0.01, 1.0]), off_diagonal(40, 2)
    beta = np.full((2, 1), 40 * 0.01)
    # Different periods on a common index: the users move equal distances per step, in opposite senses.
    v = np.outer(np.ones(4000), [1.0, -1.0]) / longest
    energy, stored = supplied(network, steps, np.broadcast_to(longest, v.shape), beta, v)
    assert energy < stored - 1e5
    beta = rule_damping(network, index_delay=steps, periods=longest)
    energy, stored = supplied(network, steps, np.broadcast_to(longest, v.shape), beta, v)
    assert energy >= stored


def freshest_energy(network, rng, *, count=40):
    """Energy into the control less that of its springs, as a quadratic form in all steps' motions, and the ages.

    Every user steps at its own changing rate and uses the newest sample that has arrived; those overtake each other.
    """
    n, K = network.size, network.linked_spring()
    steps = [rng.uniform(0.2, 1.8, int(count / rate)) * rate for rate in rng.uniform(1, 5, n)]
    steps = [step * count / step.sum() for step in steps]
    end = [np.cumsum(step) for step in steps]
    first = np.r_[0, np.cumsum([len(step) for step in steps])]

    def mean(i, k):
        row = np.zeros(first[-1])
        row[first[i] : first[i] + k] = steps[i][:k]
        row[first[i] + k] = steps[i][k] / 2
        return row

    Q, ages = np.zeros((first[-1], first[-1])), np.zeros((n, n))
    for i, j in np.argwhere(K):
        arrival = end[j] + rng.uniform(0, 4, len(end[j]))
        for k, step in enumerate(steps[i]):
            there = np.flatnonzero(arrival <= end[i][k] - step)
            middle = end[j][there.max()] - steps[j][there.max()] / 2 if there.size else 0.0
            ages[i, j] = max(ages[i, j], end[i][k] - middle)
            late = mean(j, there.max()) if there.size else 0.0
            Q[first[i] + k] += step * K[i, j] * (mean(i, k) - late)
    for i, j in network.links:
        apart = np.zeros(first[-1])
        apart[first[i] : first[i + 1]], apart[first[j] : first[j + 1]] = steps[i], -steps[j]
        Q -= K[i, j] / 2 * np.outer(apart, apart)
    T = np.concatenate(steps)
    user = np.repeat(np.arange(n), np.diff(first))
    return (Q + Q.T) / 2 / np.sqrt(np.outer(T, T)), user, ages


def test_age_rule_covers_the_freshest_sample_at_any_rate():
    rng = np.random.default_rng(5)
    lowest = []
    for _ in range(12):
        network = random_network(rng, size=3)
        Q, user, ages = freshest_energy(network, rng)
        for beta in (
            rule_damping(network, ages=ages),
            damping_for(network, "minimax", ages=ages),
            damping_for(network, "rule", weights=np.exp(rng.normal(size=3)), ages=ages),
        ):
            B = beta[user, 0]
            assert np.linalg.eigvalsh(Q + np.diag(B))[0] > -1e-9 * B.max()
            lowest.append(np.linalg.eigvalsh(Q + np.diag(B / 4))[0])
    assert min(lowest) < 0, "a quarter of it is too little somewhere"


def test_exact_test_is_tight_both_ways():
    """Just below the exact damping a long enough sinusoid takes energy out; at it, nothing does."""
    network = uniform(complete(5), 5)
    steps, T = off_diagonal(4, 5), 0.1
    damping = damping_for(network, "exact", index_delay=steps, periods=T)
    theta = np.linspace(0.01, 3.1, 4000)
    H = sync_hermitian(network, theta, index_delay=steps, period=T, damping=damping)
    smallest = np.linalg.eigvalsh(H)[:, 0]
    at = int(np.argmin(smallest))
    mode = worst_start(H[at])
    k = np.arange(6000)
    envelope = np.sin(np.pi * (k + 0.5) / len(k)) ** 2
    v = np.real(np.exp(1j * theta[at] * k)[:, None] * mode[None, :]) * envelope[:, None]
    for factor, sign in ((1.02, 1), (0.98, -1)):
        energy, stored = supplied(network, steps, np.full(v.shape, T), factor * damping, v)
        assert np.sign(energy - stored) == sign


# --- the exact test ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("steps", [1, 5, 200])
@pytest.mark.parametrize("shape", [path(2), path(5), star(6), ring(4), ring(6)])
def test_rule_is_tight_on_bipartite_graphs(shape, steps):
    n = 1 + max(max(link) for link in shape)
    rng = np.random.default_rng(steps)
    network = uniform(shape, n)
    factor = rng.uniform(0.3, 2.0, (n, n))
    spring = network.spring * (factor + factor.T)
    network = network.replace(spring=spring)
    rule = rule_damping(network, index_delay=off_diagonal(steps, n), periods=0.01)
    scaling = exact_scaling(network, index_delay=off_diagonal(steps, n), period=0.01, damping=rule)
    assert scaling == pytest.approx(1.0, abs=1e-9)
    assert scaling >= 1.0 - 1e-14, "never on the wrong side"


@pytest.mark.parametrize("n", [3, 5, 9])
@pytest.mark.parametrize("steps", [1, 6, 300])
def test_odd_rings(n, steps):
    network = uniform(ring(n), n)
    rule = rule_damping(network, index_delay=off_diagonal(steps, n), periods=0.01)
    scaling = exact_scaling(network, index_delay=off_diagonal(steps, n), period=0.01, damping=rule)
    assert scaling == pytest.approx(np.cos(np.pi / n), abs=1e-9)


def test_complete_graph_of_eight():
    """K N T = 5 on every link: the rule asks 35. As steps shrink, the lowest value of sin(x)/x decides: 7.604."""
    x = scipy.optimize.brentq(lambda y: np.tan(y) - y, 4.4, 4.6)
    dip = -np.sin(x) / x
    assert dip == pytest.approx(0.2172, abs=5e-5)
    network = uniform(complete(8), 8)
    exact = []
    for steps in (5, 50, 1000):
        rule = rule_damping(network, index_delay=off_diagonal(steps, 8), periods=5 / steps)
        np.testing.assert_allclose(rule, 35.0)
        exact.append(35 * exact_scaling(network, index_delay=off_diagonal(steps, 8), period=5 / steps, damping=rule))
    assert exact[2] == pytest.approx(7 * 5 * dip, rel=1e-5)
    assert exact[0] == pytest.approx(7.088, abs=1e-3), "longer steps need less"
    assert exact[0] < exact[1] < exact[2]


@settings(max_examples=examples(30), deadline=None)
@given(st.integers(0, 10**6), st.sampled_from([3, 30, 2000]))
def test_scaling_and_margin_against_brute_force(seed, longest):
    rng = np.random.default_rng(seed)
    network = random_network(rng, size=int(rng.integers(2, 6)))
    n, T = network.size, 0.003
    steps = rng.integers(0, longest + 1, (n, n))
    steps[0, 1:] = np.maximum(steps[0, 1:], 1)
    beta = rng.uniform(0.2, 1.0, (n, 1)) * T * longest
    scaling = exact_scaling(network, index_delay=steps, period=T, damping=beta)
    margin = exact_margin(network, index_delay=steps, period=T, damping=beta)
    # Coarse over all angles (where a maximum of width 1/N may hide), fine where the envelope lets it be.
    theta = np.r_[0.0, np.geomspace(1e-7, np.pi, 3000), np.linspace(0, 12 * np.pi / longest, 3000) % np.pi]
    C = sync_hermitian(network, theta, index_delay=steps, period=T, damping=0 * beta)
    root = np.sqrt(beta[:, 0])
    brute = np.linalg.eigvalsh(-C / root[:, None] / root)[:, -1].max()
    assert scaling >= brute * (1 - 1e-12)
    assert scaling == pytest.approx(brute, rel=2e-3)
    lowest = np.linalg.eigvalsh(C + np.diag(beta[:, 0]))[:, 0].min()
    assert margin <= lowest + 1e-12
    assert margin == pytest.approx(lowest, abs=2e-3 * np.abs(C).max() * n)
    assert (scaling <= 1) == (margin >= 0) or abs(scaling - 1) < 1e-8
    # The two measures are one: with all damping scaled, the smallest eigenvalue is just 0.
    assert exact_margin(network, index_delay=steps, period=T, damping=scaling * beta) == pytest.approx(
        0.0, abs=1e-8 * np.abs(C).max() * n
    )


def test_common_weight_is_a_scalar_problem_times_the_weight():
    plain = five_users().with_links(pairs("12 14 24 23 34 45"))
    weighted = Network(users=plain.users, spring=plain.spring, delay=plain.delay, links=plain.links, weight=SPD)
    rule = rule_damping(weighted, periods=0.01)
    np.testing.assert_allclose(rule, np.c_[np.zeros(5), rule_damping(plain, periods=0.01)[:, 0]])
    same = exact_scaling(plain, period=0.01, damping=rule[:, 1])
    assert exact_scaling(weighted, period=0.01, damping=rule) == same
    assert exact_scaling(weighted, period=0.01, damping=rule[:, 1]) == same
    low, high = np.linalg.eigvalsh(SPD)
    for factor, eigenvalue in ((2.0, low), (0.1, high)):
        assert exact_margin(weighted, period=0.01, damping=factor * rule) == pytest.approx(
            eigenvalue * exact_margin(plain, period=0.01, damping=factor * rule[:, 1])
        )
    # The same through the block matrices, which identity damping forces.
    blocks = exact_scaling(weighted, period=0.01, damping=rule + np.array([[1e-13, 0.0]]))
    assert blocks == pytest.approx(same, rel=1e-9)


def test_different_weights_against_brute_force():
    network = matrix_network()
    steps, T = np.array([[0, 3, 1], [2, 0, 6], [4, 1, 0]]), 0.05
    rule = rule_damping(network, index_delay=steps, periods=T)
    assert rule.shape == (3, 3)
    theta = np.linspace(0, np.pi, 4001)
    C = sync_hermitian(network, theta, index_delay=steps, period=T, damping=0 * rule)
    D = damping_matrices(network, rule)
    root = scipy.linalg.block_diag(*[np.linalg.inv(scipy.linalg.sqrtm(block)) for block in D])
    brute = np.linalg.eigvalsh(-root @ C @ root)[:, -1].max()
    scaling = exact_scaling(network, index_delay=steps, period=T, damping=rule)
    assert brute <= scaling <= brute * (1 + 1e-5)
    assert exact_margin(network, index_delay=steps, period=T, damping=rule) >= -1e-12
    many = Network(
        users=[str(i) for i in range(130)],
        spring=np.einsum("ij,pq->ijpq", off_diagonal(1.0, 130), SPD),
        delay=np.zeros((130, 130)),
        links=path(130),
    )
    with pytest.raises(UnsupportedError, match="260 rows; it takes at most 256"):
        exact_scaling(many, period=0.1, damping=np.ones((130, 2)))


def test_nothing_to_cover_and_nothing_to_cover_it_with():
    network = uniform(path(3), 3)
    zero, two = np.zeros((3, 3)), off_diagonal(2, 3)
    assert exact_scaling(network, index_delay=zero, period=0.1, damping=np.zeros(3)) == 0.0
    assert exact_scaling(network, index_delay=two, period=0.1, damping=[1, 0, 1]) == np.inf
    assert exact_margin(network, index_delay=two, period=0.1, damping=[1, 0, 1]) < 0
    assert exact_margin(uniform([], 2), index_delay=zero[:2, :2], period=0.1, damping=[3, 2]) == pytest.approx(2.0)
    certificates = certify(network, index_delay=two, periods=0.1, damping=np.zeros(3))
    assert all(c.margin == -np.inf and not c.holds for c in certificates.values())
    certificates = certify(network, index_delay=zero, periods=0.1)
    assert all(c.margin == 1 and c.holds for c in certificates.values())


# --- certificates --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("declared", [{"ages": None}, {"periods": 0.01}, {"periods": [0.01, 0.02, 0.03, 0.01, 0.02]}])
def test_designed_damping_stands_on_its_bound(declared):
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    if "ages" in declared:
        declared = {"ages": network.delay + 0.01 * (1 - np.eye(5))}
    elif np.ndim(declared["periods"]):
        declared |= {"index_delay": network.index_delays(0.01)}
    certificates = certify(network, **declared)
    common = np.ptp(declared.get("periods", [0, 1])) == 0
    assert set(certificates) == {"rule", "minimax", "sum"} | ({"exact"} if common else set())
    for method, certificate in certificates.items():
        assert certificate.method == method
        assert certificate.holds
        assert certificate.margin == pytest.approx(0.0, abs=1e-9)
        assert certificate.covers
        np.testing.assert_array_equal(certificate.damping, damping_for(network, method, **declared))
        # A thousandth less, and it fails; the same damping checked, and it holds.
        if method != "sum":
            name = "weighted" if method == "minimax" else method
            assert certify(network, damping=certificate.damping, **declared)[name].holds
            assert not certify(network, damping=0.999 * certificate.damping, **declared)[name].holds
    if "ages" in declared:
        assert certificates["rule"].modes == ("constant", "freshest")
        assert certificates["rule"].basis == "age"
    else:
        assert certificates["rule"].modes == ("constant", "self-paced")
    if common:
        assert certificates["exact"].modes == ("constant",)
        assert (certificates["exact"].damping < certificates["rule"].damping).all()


@settings(max_examples=examples(25), deadline=None)
@given(st.integers(0, 10**6))
def test_margins_say_how_much_can_go(seed):
    rng = np.random.default_rng(seed)
    network = random_network(rng)
    n = network.size
    ages = rng.uniform(0.05, 0.3, (n, n))
    damping = damping_for(network, "minimax", ages=ages) * rng.uniform(1.1, 2.0, (n, 1))
    checked = certify(network, ages=ages, damping=damping)
    weighted, rule = checked["weighted"], checked["rule"]
    assert weighted.holds
    assert weighted.margin >= rule.margin - 1e-9

    def holds(name, damping, ages=ages):
        return certify(network, ages=ages, damping=damping)[name].holds

    for certificate, name in ((weighted, "weighted"), (rule, "rule")):
        if not certificate.holds:
            continue
        for part, verdict in ((1 - 1e-6, True), (1 + 1e-6, False)):
            assert holds(name, damping * (1 - part * certificate.margin)) == verdict
            i = int(rng.integers(n))
            less = damping.copy()
            less[i] *= 1 - part * certificate.user_margin[i]
            assert holds(name, less) == verdict
            link = int(rng.integers(len(network.links)))
            a, b = network.links[link]
            longer = ages.copy()
            longer[[a, b], [b, a]] *= 1 + part * certificate.link_margin[link]
            assert holds(name, damping, longer) == verdict


def test_failing_margins_say_how_much_it_takes():
    network = uniform(path(2), 2)
    for certificate in certify(network, ages=off_diagonal(1.0, 2), damping=[0.8, 0.8]).values():
        assert not certificate.holds
        assert certificate.margin == pytest.approx(-0.25)
        np.testing.assert_allclose(certificate.user_margin, -0.25)
        np.testing.assert_allclose(certificate.link_margin, -0.2)


def test_weights_rescue_what_the_plain_rule_refuses():
    network = uniform(path(2), 2)
    checked = certify(network, ages=off_diagonal(1.0, 2), damping=[0.5, 2.1])
    assert not checked["rule"].holds
    assert checked["weighted"].holds
    assert checked["weighted"].margin == pytest.approx(1 - 1 / np.sqrt(0.5 * 2.1))


def test_certificates_of_different_weights_hold_as_matrices():
    network = matrix_network()
    certificates = certify(network, periods=0.05)
    for certificate in certificates.values():
        assert certificate.holds
        assert certificate.damping.shape == (3, 3)
    rule = certificates["rule"].damping
    K = {(0, 1): 3 * SPD, (1, 2): OTHER, (0, 2): 2 * np.eye(2)}
    np.testing.assert_allclose(damping_matrices(network, rule)[1], 0.2 * (K[0, 1] + K[1, 2]))
    # Plain damping big enough as a matrix passes too; the identity alone just at the largest eigenvalue.
    need = damping_matrices(network, rule)
    top = max(np.linalg.eigvalsh(block)[-1] for block in need)
    plain = np.c_[np.full(3, top), np.zeros((3, 2))]
    checked = certify(network, periods=0.05, damping=plain)["rule"]
    assert checked.holds
    assert checked.margin == pytest.approx(0.0, abs=1e-12)
    assert not certify(network, periods=0.05, damping=0.99 * plain)["rule"].holds


def test_mixed_weights_and_the_weighted_certificate():
    """Sufficient, and never beyond the exact test."""
    rng = np.random.default_rng(2)
    network = matrix_network()
    for _ in range(20):
        damping = rule_damping(network, periods=0.05) * rng.uniform(0.3, 2.0, (3, 3))
        checked = certify(network, periods=0.05, damping=damping)
        assert checked["exact"].margin >= checked["weighted"].margin - 1e-9
        assert checked["exact"].margin >= checked["rule"].margin - 1e-9


# --- forms and refusals --------------------------------------------------------------------------------------------


def test_coefficients():
    network = matrix_network()
    assert coefficients(network.with_links([(0, 1)]), [1, 2, 3]).tolist() == [[0, 1, 0], [0, 2, 0], [0, 3, 0]]
    assert coefficients(five_users(), np.ones(5)).shape == (5, 1)
    assert damping_matrices(five_users(), np.ones(5), rows=3).shape == (5, 3, 3)
    with pytest.raises(NetworkError, match="3 different weights"):
        coefficients(network, [1, 2, 3])
    with pytest.raises(NetworkError, match=r"\(3, 3\)"):
        coefficients(network, np.ones((3, 2)))
    with pytest.raises(NetworkError, match=r"user 2 .* is -1 Ns/m"):
        coefficients(five_users().replace(users=list("abcde")), [0, -1, 0, 0, 0])
    with pytest.raises(NetworkError, match="rows is 3; it must be 2"):
        damping_matrices(network, np.ones((3, 3)), rows=3)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"method": "best"}, ['"best"', '"minimax"']),
        ({"method": "rule", "costs": np.ones(5)}, ["costs", '"sum"']),
        ({"method": "sum", "costs": np.zeros(5)}, ["costs of user 1 is 0", "above 0"]),
        ({"method": "sum", "costs": np.ones(4)}, ["costs has shape (4,)"]),
        ({"method": "exact"}, ["common period"]),
        ({"method": "exact", "ages": np.ones((5, 5)), "periods": 0.1}, ["no ages"]),
        ({"method": "exact", "periods": [0.1, 0.2, 0.1, 0.1, 0.1]}, ["0.1 s to 0.2 s", "one common period"]),
        ({"method": "rule", "ages": np.ones((5, 5)), "periods": 0.1}, ["ages", "one kind"]),
        ({"method": "rule", "index_delay": np.ones((5, 5))}, ["without periods"]),
        ({"method": "rule", "index_delay": 0.5 * np.ones((5, 5)), "periods": 0.1}, ["user 1", "0.5", "whole number"]),
        ({"method": "rule", "index_delay": -np.ones((5, 5)), "periods": 0.1}, ["index_delay", "-1 steps"]),
        ({"method": "rule", "periods": [0.1, 0.2, 0.1, 0.1, 0.1]}, ["periods differ", "index_delay"]),
        ({"method": "rule", "periods": [0.1, 0.2]}, ["periods has shape (2,)"]),
        ({"method": "rule", "periods": -0.1}, ["user 1 has -0.1 s"]),
        ({"method": "rule", "ages": np.full((5, 5), np.nan)}, ["ages", "nan s", "finite"]),
        ({"method": "rule", "ages": np.ones(5)}, ["ages has shape (5,)", "(5, 5)"]),
    ],
)
def test_refuses(options, words):
    method = options.pop("method")
    with pytest.raises(NetworkError) as caught:
        damping_for(five_users(), method, **options)
    for word in words:
        assert word in str(caught.value)


def test_exact_refuses_a_list_of_periods():
    with pytest.raises(NetworkError, match="one common period"):
        exact_scaling(five_users(), period=[0.1] * 5, damping=np.ones(5))
    for method, name in (("sum", "costs"), ("rule", "weights")):
        with pytest.raises(NetworkError, match=f"{name} of user 2 is 0"):
            damping_for(five_users(), method, **{name: [1, 0, 1, 1, 1]})
        with pytest.raises(NetworkError, match=f'{name} are given with method "minimax"'):
            damping_for(five_users(), "minimax", **{name: np.ones(5)})
