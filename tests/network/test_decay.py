"""Decay of the closed loop: reference values, closed forms, and eigenvalues of the loop stepped in time."""

import numpy as np
import pytest
import scipy.special
from scipy.stats import spearmanr
from tests.network.support import GRAPHS, five_users, mixings, pairs, random_network, uniform

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.network import closed_loop, complete, generator_eigenvalues, path, rightmost, rightmost_root


def eigenvalues(network, mass, damping, stiffness, sync):
    """Of the loop by fine collocation, the rightmost first; those near the origin are accurate."""
    coupling = network.linked_spring()
    delay = np.where(coupling > 0, network.delay, 0.0)
    inertia, drag = np.full(network.size, mass / network.size), damping / network.size + sync
    ground = stiffness / network.size + coupling.sum(axis=1)
    return generator_eigenvalues(inertia, drag, ground, coupling, delay, order=40)


@pytest.fixture(scope="module")
def decays():
    return [rightmost_root(five_users().with_links(links)) for links in GRAPHS]


def test_reference_values(decays):
    rates = np.array([decay.rate for decay in decays])
    best, worst = int(np.argmin(rates)), int(np.argmax(rates))
    assert GRAPHS[best] == pairs("12 14 23 24 34 45")
    assert rates[best] == pytest.approx(-1.428553, abs=1e-6)
    assert GRAPHS[worst] == pairs("13 14 23 25 34 35")
    assert rates[worst] == pytest.approx(-0.289652, abs=1e-6)
    assert max(decay.residual for decay in decays) < 1e-14


@pytest.mark.parametrize(("convention", "correlation"), [("equation", 0.39), ("matrix", 0.34)])
def test_rank_correlation_with_the_papers_objective(decays, convention, correlation):
    values = [result.value for result in mixings(convention)]
    rates = [decay.rate for decay in decays]
    assert spearmanr(values, rates)[0] == pytest.approx(correlation, abs=0.005)
    if convention == "matrix":
        assert sorted(rates).index(rates[int(np.argmax(values))]) + 1 == 11


def test_two_users_without_delay():
    """Difference mode: m/2 s^2 + (b/2 + B) s + k/2 + 2K = 0; sum mode: m/2 s^2 + (b/2 + B) s + k/2 = 0."""
    network = uniform(path(2), 2, spring=3.0, delay=0.0)
    for b, k, B in ((1.0, 4.0, 2.0), (0.3, 0.0, 5.0), (0.2, 0.0, 0.1)):
        roots = np.concatenate([np.roots([1.0, b / 2 + B, k / 2 + 6.0]), np.roots([1.0, b / 2 + B, k / 2])])
        expected = max(root.real for root in roots if abs(root) > 1e-9)
        decay = rightmost_root(network, mass=2.0, damping=b, stiffness=k, sync_damping=[B, B])
        assert decay.rate == pytest.approx(expected, abs=1e-10)
        np.testing.assert_array_equal(decay.sync_damping, [B, B])
        assert decay.time_constant_s == pytest.approx(-1 / expected)


def test_two_users_without_mass_follow_the_lambert_function():
    """As m vanishes, the difference mode keeps B s + K + K e^(-s d) = 0, the sum mode B s + K - K e^(-s d) = 0."""
    K, d = 3.0, 0.7
    network = uniform(path(2), 2, spring=K, delay=d)
    B = K * d  # The rule.
    branches = np.arange(-4, 5)
    a = d * K / B
    roots = np.concatenate([(scipy.special.lambertw(sign * a * np.exp(a), branches) - a) / d for sign in (-1, 1)])
    expected = max(roots[np.abs(roots) > 1e-9].real)
    assert rightmost_root(network, mass=1e-5).rate == pytest.approx(expected, abs=1e-3)


def test_mode_solves_the_equations_and_only_one_zero_is_left_out():
    rng = np.random.default_rng(3)
    for _ in range(20):
        network = random_network(rng)
        for stiffness in (0.0, 2.0):
            decay = rightmost_root(network, mass=1.5, damping=0.4, stiffness=stiffness)
            s, n = decay.root, network.size
            K = network.linked_spring()
            own = s**2 * 1.5 / n + s * (0.4 / n + decay.sync_damping) + stiffness / n + K.sum(axis=1)
            left = own * decay.mode - (K * np.exp(-s * network.delay)) @ decay.mode
            assert np.abs(left).max() < 1e-11 * np.abs(own).max()
            assert s.imag >= 0
            assert abs(s) > 1e-6
            # Nothing just right of it but the translation; the root itself (and its mirror) just left.
            still = 1 if stiffness == 0 and s.real < 0 else 0
            around = s.real + 1e-4 * abs(s) * np.array([[1.0], [-1.0]])
            beyond = np.count_nonzero(eigenvalues(network, 1.5, 0.4, stiffness, decay.sync_damping).real > around, 1)
            assert beyond.tolist() == [still, still + (2 if s.imag > 0 else 1)]


def test_a_guess_that_leads_nowhere_costs_no_certainty():
    """Roots of other links may be no help at all; then the search begins as without them."""
    rng = np.random.default_rng(12)
    for size in (3, 12):
        network = uniform(path(size), size, spring=30.0, delay=0.1)
        network = network.replace(delay=network.delay * rng.uniform(0.5, 2.0, network.delay.shape))
        loop, _ = closed_loop(network)
        root, certain, _ = rightmost(loop, True, np.zeros(0, np.complex128))
        assert certain
        for guess in (1e-12 + 0j, 1e9 + 0j, -1e9 + 1e9j, complex(np.inf, 0.0)):
            other, sure, _ = rightmost(loop, True, np.array([guess]))
            assert sure
            assert other == pytest.approx(root, rel=1e-9)


def test_small_root_beside_the_translation_is_kept():
    """A hardly damped object whose users hardly spring back: a genuine root of 1e-4 sits beside the one at 0."""
    network = uniform(path(3), 3, spring=1.0, delay=0.1)
    decay = rightmost_root(network, mass=1e5)
    assert abs(decay.root) < 2e-2
    free = rightmost_root(network, mass=1.0, sync_damping=[1e-7] * 3, damping=0.0)
    assert free.rate > 0, "without damping the delays feed energy in"


def stepped_loop(network, T, B):
    """One step of the users with index delays: NPMI with explicit neighbours, as a matrix on (x, v, past means)."""
    n = network.size
    K = network.linked_spring()
    steps = np.where(K > 0, np.rint(network.delay / T), 0).astype(int)
    longest = steps.max()
    size = 2 * n + longest * n
    A = np.zeros((size, size))
    solve = 1 / (2 / T / n + B + T / 2 * K.sum(axis=1))
    for i in range(n):
        row = np.zeros(size)
        row[n + i] = 2 / T / n
        row[i] = -K[i].sum()
        for j in np.flatnonzero(K[i]):
            row[2 * n + (steps[i, j] - 1) * n + j] += K[i, j]
        hat = row * solve[i]
        A[i] = T * hat
        A[i, i] += 1
        A[n + i] = 2 * hat
        A[n + i, n + i] -= 1
        A[2 * n + i] = T / 2 * hat
        A[2 * n + i, i] += 1
    A[3 * n :, 2 * n : -n] = np.eye(n * (longest - 1))
    return A


def test_agrees_with_the_stepped_loop_as_steps_shrink():
    network = five_users().with_links(pairs("12 23 34 24")).replace()
    network = uniform(path(3), 3, spring=4.0).replace(delay=[[0, 0.2, 0], [0.1, 0, 0.3], [0, 0.2, 0]])
    decay = rightmost_root(network)
    errors = []
    for T in (0.02, 0.01):
        z = np.linalg.eigvals(stepped_loop(network, T, decay.sync_damping))
        s = np.log(z[np.abs(z) > 1e-6].astype(complex)) / T
        s = s[np.abs(s) > 1e-6]
        errors.append(np.abs(s - decay.root).min())
        assert s.real.max() == pytest.approx(decay.rate, abs=0.05)
    assert errors[1] < 0.02
    # Positions are means of a step held over a step: first order in T would show as 2, second order as 4.
    assert 1.8 < errors[0] / errors[1] < 4.4


def test_one_user_and_undamped():
    single = uniform([], 1)
    assert rightmost_root(single, mass=2.0, damping=3.0).root == pytest.approx(-1.5, abs=1e-12)
    assert rightmost_root(single, mass=1.0, damping=1.0, stiffness=4.0).rate == pytest.approx(-0.5, abs=1e-12)
    two = uniform(path(2), 2, spring=3.0, delay=0.0)
    assert rightmost_root(two, mass=2.0, stiffness=1.0).rate == pytest.approx(0.0, abs=1e-9)


def test_another_root_as_a_guess_is_seen_through():
    network = five_users().with_links(pairs("12 14 23 24 34 45"))
    loop, _ = closed_loop(network, 1.0, 0.0, 0.0, None)
    for start in (-3 + 20j, -2 + 1j, -5.0 + 0j, -30 + 300j):
        root, certain, _ = rightmost(loop, True, np.array([start], dtype=np.complex128))
        assert certain
        assert root.real == pytest.approx(-1.428553, abs=1e-6)


@pytest.mark.parametrize("seed", range(16))
def test_agrees_with_fine_collocation(seed):
    rng = np.random.default_rng(seed)
    network = random_network(rng, size=int(rng.integers(2, 7)))
    fraction = rng.choice([0.05, 0.3, 1.0, 2.0])  # of the rule's damping: little of it leaves roots to the right
    sync = fraction * rightmost_root(network).sync_damping
    found = rightmost_root(network, mass=0.7, sync_damping=sync)
    values = eigenvalues(network, 0.7, 0.0, 0.0, sync)
    values = values[np.abs(values) > 1e-5]
    assert found.rate == pytest.approx(values[0].real, rel=1e-6, abs=1e-6)


def test_users_alike_share_their_root():
    # Six users joined alike: one root of five copies, which plain Newton would near by a fifth at a time.
    network = uniform(complete(6), 6, spring=20.0, delay=0.2)
    decay = rightmost_root(network)
    s, K, d, B = decay.root, 20.0, 0.2, decay.sync_damping[0]
    own = s * s / 6 + s * B + 5 * K
    assert min(abs(own + K * np.exp(-s * d)), abs(own - 5 * K * np.exp(-s * d))) < 1e-9 * 5 * K


def test_larger_network_counts_its_roots():
    network = random_network(np.random.default_rng(1), size=12, delays=(0.001, 2.0))
    assert rightmost_root(network, mass=10.0).rate < 0


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"mass": 0.0}, ["mass is 0 kg"]),
        ({"mass": float("nan")}, ["mass is nan"]),
        ({"damping": -1.0}, ["damping is -1 Ns/m"]),
        ({"stiffness": float("inf")}, ["stiffness is inf N/m"]),
        ({"sync_damping": [1.0]}, ["sync_damping", "(5,)"]),
        ({"sync_damping": [1, 1, -2, 1, 1]}, ["user 3", "-2 Ns/m"]),
    ],
)
def test_refuses(options, words):
    with pytest.raises(NetworkError) as caught:
        rightmost_root(five_users(), **options)
    for word in words:
        assert word in str(caught.value)


def test_refuses_separate_groups_and_weights():
    with pytest.raises(NetworkError, match="4 separate groups"):
        rightmost_root(five_users().with_links([(0, 1)]))
    weighted = type(five_users())(
        users=["a", "b"], spring=[[0, 1], [1, 0]], delay=np.zeros((2, 2)), weight=np.diag([1.0, 2.0])
    )
    with pytest.raises(UnsupportedError, match="weights"):
        rightmost_root(weighted)
    assert rightmost_root(uniform(complete(3), 3)).rate < 0
