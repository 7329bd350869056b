"""Accuracy in time: second order, and nothing gained or lost without damping."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
import scipy.linalg as la
from tests.mechanics.reference import control_damping, matrices, picks
from tests.mechanics.support import Copy, Port, Scene, Spring

from cotouch.body import Body, chain, point
from cotouch.mechanics import Basis


def exact(scene: Scene, time: float) -> tuple[np.ndarray, np.ndarray]:
    """Position and velocity by the matrix exponential; ends of ports stand still or move at a constant rate.

    The state is (x, v, 1, t).
    """
    n, d = scene.body.nodes, scene.body.dimension
    size = n * d
    M, B, K, W = matrices(scene)
    B = B + control_damping(scene, scene.local_damping) + control_damping(scene, scene.extra_damping)
    constant, ramp = np.zeros(size), np.zeros(size)
    for spring in scene.springs:
        K_ij = spring.strength * W[spring.weight]
        K = K + K_ij
        constant += K_ij @ spring.sample.ravel()
    for port, H in zip(scene.ports, picks(scene), strict=True):
        start = np.broadcast_to(port.start, d)
        rate = (np.broadcast_to(port.end, d) - start) / time
        K = K + port.stiffness * H.T @ H
        B = B + port.damping * H.T @ H
        constant += H.T @ (port.stiffness * start + port.damping * rate + port.push)
        ramp += H.T @ (port.stiffness * rate)
    inverse = np.linalg.inv(M)
    generator = np.zeros((2 * size + 2, 2 * size + 2))
    generator[:size, size : 2 * size] = np.eye(size)
    generator[size : 2 * size] = inverse @ np.hstack([-K, -B, constant[:, None], ramp[:, None]])
    generator[-1, -2] = 1.0
    state = la.expm(time * generator) @ np.r_[scene.position.ravel(), scene.velocity.ravel(), 1.0, 0.0]
    return state[:size].reshape(n, d), state[size : 2 * size].reshape(n, d)


def moved(scene: Scene, time: float, steps: int, basis: Basis, uneven: float) -> tuple[np.ndarray, np.ndarray]:
    """Position and velocity after steps whose lengths alternate by a factor (1 ± uneven)."""
    ports = [replace(port) for port in scene.ports]
    copy = Copy(replace(scene, ports=ports), basis=basis)
    now = 0.0
    for k in range(steps):
        T = time / steps * (1.0 + uneven * (-1.0) ** k)
        for port, whole in zip(ports, scene.ports, strict=True):
            start, end = np.asarray(whole.start), np.asarray(whole.end)
            port.start = start + (end - start) * now / time
            port.end = start + (end - start) * (now + T) / time
        copy.hold()
        copy.step(T)
        now += T
    assert now == pytest.approx(time)
    return copy.position, copy.velocity


def order(scene: Scene, time: float, coarsest: int, basis: Basis, uneven: float) -> tuple[float, float]:
    """Measured order of convergence of position and velocity."""
    counts = coarsest * 2 ** np.arange(5)
    found = [moved(scene, time, count, basis, uneven) for count in counts]
    slopes = []
    for part, reference in enumerate(exact(scene, time)):
        errors = [np.abs(outcome[part] - reference).max() for outcome in found]
        assert errors[-1] < 1e-2 * np.abs(reference).max()
        slopes.append(-np.polyfit(np.log2(counts), np.log2(errors), 1)[0])
    return slopes[0], slopes[1]


def oscillator() -> Scene:
    return Scene(
        body=point(mass=2.0, damping=0.8, stiffness=50.0),
        position=np.array([[0.3]]),
        velocity=np.array([[-1.0]]),
    )


def held_chain(dimension: int = 1) -> Scene:
    rng = np.random.default_rng(2)
    body = chain(5, mass=1.0, stiffness=10.0, damping=0.3, dimension=dimension, ground=[0], ground_stiffness=6.0)
    return Scene(
        body=body,
        position=0.1 * rng.normal(size=(5, dimension)),
        velocity=rng.normal(size=(5, dimension)),
        copies=2,
        springs=[Spring(5.0, 0.1 * rng.normal(size=(5, dimension)))],
        ports=[Port(4, 8.0, 0.5, np.zeros(dimension), 0.2 * np.ones(dimension), 0.4)],
        local_damping=np.array([0.2]),
        extra_damping=np.array([0.1]),
    )


def consistent_chain() -> Scene:
    """Masses that couple neighbours; dampers along other edges than the springs."""
    scene = held_chain()
    coupled = np.eye(5) * 4 + np.eye(5, k=1) + np.eye(5, k=-1)
    column = np.array([[1.0, 0.0, -1.0, 0.0, 0.0]])
    body = Body(
        mass=coupled / 30.0,
        rest=scene.body.rest,
        damping_int=0.4 * column.T @ column,
        stiffness_int=scene.body.stiffness_int,
        stiffness_ext=scene.body.stiffness_ext,
    )
    return replace(scene, body=body, weights=[np.eye(5) + 0.1 * coupled], springs=[Spring(5.0, np.zeros((5, 1)), 1)])


def modal_chain() -> Scene:
    scene = held_chain()
    return replace(scene, body=chain(5, mass=1.0, stiffness=10.0, damping=0.3, ground="all", ground_stiffness=8.0))


class TestOrder:
    @pytest.mark.parametrize("uneven", [0.0, 0.4])
    @pytest.mark.parametrize(
        ("make", "basis", "coarsest"),
        [
            (oscillator, "nodal", 32),
            (held_chain, "nodal", 64),
            (lambda: held_chain(3), "nodal", 64),
            (consistent_chain, "nodal", 64),
            (modal_chain, "modal", 64),
        ],
        ids=["oscillator", "chain", "chain in space", "consistent mass", "modal"],
    )
    def test_is_two(self, make: Callable[[], Scene], basis: Basis, coarsest: int, uneven: float):
        assert order(make(), 1.0, coarsest, basis, uneven) == pytest.approx((2.0, 2.0), abs=0.1)

    def test_the_damped_oscillator_against_its_formula(self):
        """x = e^(-βt) (x₀ cos ωt + (v₀ + βx₀)/ω sin ωt)."""
        scene = oscillator()
        m, b, k, x, v = 2.0, 0.8, 50.0, 0.3, -1.0
        beta = b / (2 * m)
        omega = np.sqrt(k / m - beta**2)
        formula = np.exp(-beta) * (x * np.cos(omega) + (v + beta * x) / omega * np.sin(omega))
        assert exact(scene, 1.0)[0].item() == pytest.approx(formula, rel=1e-12)
        assert moved(scene, 1.0, 4000, "nodal", 0.3)[0].item() == pytest.approx(formula, rel=1e-5)


class TestConservation:
    """Without damping and force E stays what it was, however the step length changes."""

    STEPS = 10_000

    @pytest.mark.parametrize(
        ("body", "basis"),
        [
            (point(mass=0.7, stiffness=300.0), "nodal"),
            (chain(4, stiffness=250.0, ground=[1], ground_stiffness=30.0), "nodal"),
            (chain(4, stiffness=250.0, dimension=3, ground="all", ground_stiffness=30.0), "modal"),
        ],
        ids=["point", "chain", "modal"],
    )
    def test_energy_is_constant(self, body: Body, basis: Basis):
        rng = np.random.default_rng(8)
        shape = (body.nodes, body.dimension)
        copy = Copy(Scene(body=body, position=rng.normal(size=shape), velocity=rng.normal(size=shape)), basis=basis)
        first, drift = copy.energy, 0.0
        for T in 10.0 ** rng.uniform(-4.0, 0.0, self.STEPS):
            copy.step(T)
            drift = max(drift, abs(copy.energy / first - 1.0))
        assert drift <= 1e-12

    def test_momentum_of_a_free_body_is_constant(self):
        rng = np.random.default_rng(9)
        body = chain(6, mass=3.0, stiffness=400.0, damping=2.0, dimension=2)
        copy = Copy(Scene(body=body, position=rng.normal(size=(6, 2)), velocity=rng.normal(size=(6, 2))))
        first = copy.velocity.sum(axis=0)
        for T in 10.0 ** rng.uniform(-4.0, -1.0, 1000):
            copy.step(T)
        assert np.allclose(copy.velocity.sum(axis=0), first, rtol=1e-10)

    def test_time_runs_back(self):
        """The step is symmetric: after a reversal of the velocity the same steps return to the start."""
        rng = np.random.default_rng(10)
        body = chain(5, stiffness=120.0, ground="x-", ground_stiffness=15.0)
        scene = Scene(body=body, position=rng.normal(size=(5, 1)), velocity=rng.normal(size=(5, 1)))
        copy, Ts = Copy(scene), 10.0 ** rng.uniform(-3.0, -1.0, 200)
        for T in Ts:
            copy.step(T)
        copy.state.velocity[:] *= -1.0
        copy.settle()
        for T in Ts[::-1]:
            copy.step(T)
        assert np.allclose(copy.position, scene.position, rtol=0.0, atol=1e-10)
        assert np.allclose(copy.velocity, -scene.velocity, rtol=0.0, atol=1e-9)
