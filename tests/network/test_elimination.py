"""Most users eliminated for certain: the same determinant, the same roots, few steps."""

import numpy as np
import pytest
from tests.network.inside import REGULAR, count_right, cut, definite, evaluate, negatives, scratch

from cotouch.arrays import Float
from cotouch.network import Network, characteristic, closed_loop, generator_eigenvalues, rightmost


def sparse(users: int, links: int, seed: int) -> Network:
    """A random tree with random links on top; delays differ both ways."""
    rng = np.random.default_rng(seed)
    spring = np.triu(rng.uniform(20, 100, (users, users)), 1)
    delay = rng.uniform(0.02, 0.4, (users, users)) * (1 - np.eye(users))
    chosen = {(int(rng.integers(b)), b) for b in range(1, users)}
    while len(chosen) < links:
        a, b = sorted(rng.choice(users, 2, replace=False).tolist())
        chosen.add((a, b))
    names = [str(i + 1) for i in range(users)]
    return Network(users=names, spring=spring + spring.T, delay=delay, links=sorted(chosen))


@pytest.mark.parametrize("seed", range(4))
def test_eliminated_or_not_the_determinant_is_the_same(seed):
    network = sparse(25, 40, seed)
    loop, _ = closed_loop(network, damping=1.0)
    line = -0.3
    parts = cut(loop, line, REGULAR)
    assert 5 < parts.gone < 25
    room = scratch(25, 25 - parts.gone)
    rng = np.random.default_rng(seed)
    for _ in range(10):
        s = complex(line + rng.exponential(0.5), rng.normal(scale=3.0))
        matrix = characteristic(loop, s)
        slope = (characteristic(loop, s + 1e-6) - characteristic(loop, s - 1e-6)) / 2e-6
        turn, phase, speed = evaluate(loop, parts, s, room)
        sign, _ = np.linalg.slogdet(matrix)
        assert turn * np.exp(1j * phase) == pytest.approx(sign, abs=1e-9)
        assert speed == pytest.approx(np.trace(np.linalg.solve(matrix, slope)), rel=1e-6)


def test_negative_eigenvalues_on_the_real_axis_are_counted():
    network = sparse(20, 35, 1)
    loop, _ = closed_loop(network)
    parts = cut(loop, 0.0, -np.inf)
    seen = set()
    for line in np.linspace(-3.0, -0.05, 30):
        mean = (loop.to_first + loop.to_second) / 2
        matrix: Float = np.diag((loop.mass * line + loop.drag) * line + loop.rigid)
        pull = loop.spring * np.exp(-line * mean)
        matrix[loop.first, loop.second] = matrix[loop.second, loop.first] = -pull
        expected = int((np.linalg.eigvalsh(matrix) < 0).sum())
        assert negatives(loop, parts, float(line), np.zeros((20, 20))) == expected
        seen.add(expected)
    assert len(seen) > 3


@pytest.mark.parametrize(("users", "links", "seed"), [(12, 14, 1), (20, 30, 2), (20, 60, 3)])
def test_the_rightmost_root_is_that_of_collocation(users, links, seed):
    network = sparse(users, links, seed)
    loop, _ = closed_loop(network)
    spring = network.linked_spring()
    roots = generator_eigenvalues(loop.mass, loop.drag, loop.rigid, spring, network.delay, order=14)
    expected = np.delete(roots, np.abs(roots).argmin()).real.max()
    root, certain, _ = rightmost(loop, True, np.zeros(0, dtype=np.complex128))
    assert certain
    assert root.real == pytest.approx(expected, rel=1e-6)


def test_a_hundred_users_take_few_matrices():
    """The line is walked near the real axis alone: all along it takes 50 steps, and 400 with users kept too rarely."""
    for seed in range(3):
        loop, _ = closed_loop(sparse(100, 200, seed))
        root, certain, effort = rightmost(loop, True, np.zeros(0, dtype=np.complex128))
        assert certain
        assert effort < 15
        starts = np.empty(64, dtype=np.complex128)
        count, steps, _ = count_right(loop, 1.01 * root.real, starts, True)
        assert count == count_right(loop, 1.01 * root.real, starts, False)[0]
        assert 30 < steps < 150


def turned(loop, line: float, frequency: float, lean: float) -> float:
    """Smallest eigenvalue of the Hermitian part of G turned by arccot(lean)."""
    matrix = (lean - 1j) / abs(lean - 1j) * characteristic(loop, complex(line, frequency))
    return float(np.linalg.eigvalsh(0.5 * (matrix + matrix.conj().T))[0])


@pytest.mark.parametrize("seed", range(4))
def test_what_is_said_to_be_definite_is_so_all_along(seed):
    loop, _ = closed_loop(sparse(15, 25, seed), damping=0.5)
    parts, room = cut(loop, 0.0, -np.inf), np.zeros((15, 15), dtype=np.complex128)
    line = 1.05 * rightmost(loop, True, np.zeros(0, dtype=np.complex128))[0].real
    rng = np.random.default_rng(seed)
    said = []
    for _ in range(300):
        low = float(np.exp(rng.uniform(np.log(1e-3), np.log(20.0))))
        high, lean = low * float(1.0 + rng.exponential(0.5)), float(rng.exponential(0.5))
        said.append(definite(loop, parts, line, low, high, lean, room))
        if said[-1]:
            assert min(turned(loop, line, at, lean) for at in np.linspace(low, high, 9)) > 0.0
        least = turned(loop, line, low, lean)
        if abs(least) > 1e-6:
            assert definite(loop, parts, line, low, low, lean, room) == (least > 0.0)
    assert 20 < sum(said) < 280


@pytest.mark.parametrize("seed", range(6))
def test_roots_are_counted_alike_whether_the_line_is_walked_or_not(seed):
    network = sparse(20, 30 + 5 * seed, seed)
    loop, _ = closed_loop(network, stiffness=float(seed % 2))
    roots = generator_eigenvalues(loop.mass, loop.drag, loop.rigid, network.linked_spring(), network.delay, order=16)
    real = np.sort(roots.real)[::-1]
    starts = np.empty(64, dtype=np.complex128)
    shorter = 0
    for place in (1, 2, 4, 7, 11):
        line = float(0.5 * (real[place] + real[place + 1]))
        if real[place] - real[place + 1] < 1e-4 or line >= 0.0:
            continue
        expected = int((roots.real > line).sum())
        assert count_right(loop, line, starts, True)[0] == expected
        count, steps, _ = count_right(loop, line, starts, False)
        assert count == expected
        shorter += steps < count_right(loop, line, starts, True)[1]
    assert shorter


def test_a_pair_that_left_the_axis_is_found_among_users_about_two_hubs():
    """Between the resting translation and the crowd of the other roots, where no line points at it."""
    rng = np.random.default_rng(30)
    spring = np.triu(rng.uniform(20.0, 100.0, (30, 30)), 1)
    delay = 0.01 * rng.integers(2, 41, (30, 30)) * (1 - np.eye(30))
    every = Network(users=[str(i) for i in range(30)], spring=spring + spring.T, delay=delay)
    for hubs in ((6, 19), (6, 25), (1, 25), (6, 21)):
        links = {tuple(sorted((hub, user))) for hub in hubs for user in range(30) if user not in hubs}
        loop, _ = closed_loop(network := every.with_links(sorted({*links, hubs})))
        roots = generator_eigenvalues(
            loop.mass, loop.drag, loop.rigid, network.linked_spring(), network.delay, order=14
        )
        root, certain, _ = rightmost(loop, True, np.zeros(0, dtype=np.complex128))
        assert certain
        assert root.real == pytest.approx(np.delete(roots, np.abs(roots).argmin()).real.max(), rel=1e-6)
