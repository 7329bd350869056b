import numpy as np
import pytest

from cotouch.body import point
from cotouch.mechanics import Grips, model
from cotouch.peer import ConstantLink, FreshestLink, Peer, Sample


def sample(sender: int, index: int, value: float) -> Sample:
    return Sample(sender=sender, index=index, stamp=0.0, position=np.full((1, 1), value))


def peer(*, delay: int | None = None, local: float = 2.0, stiffness: float = 0.0) -> Peer:
    ready = model(point(mass=1.0, stiffness=4.0, damping=0.5), copies=2)
    initial = sample(1, -1, 0.0)
    grips = Grips(
        first=0,
        last=1,
        row=np.zeros(1, np.int32),
        shape=ready.port_shapes(np.zeros(1, np.int32)),
        stiffness=np.full(1, stiffness),
        damping=np.zeros(1),
        start=np.ones((1, 1)),
        end=np.ones((1, 1)),
        push=np.zeros((1, 1)),
        force=np.zeros((1, 1)),
    )
    return Peer(
        index=0,
        model=ready,
        links={1: FreshestLink(initial) if delay is None else ConstantLink(initial, delay)},
        strength=[30.0],
        weight=[0],
        local_damping=np.array([local]),
        extra_damping=np.array([0.1]),
        grips=grips,
        position=np.array([[0.2]]),
        velocity=np.array([[-0.1]]),
    )


def test_a_step_is_the_papers_equation() -> None:
    one = peer(stiffness=10.0)
    assert one.receive(sample(1, 0, 0.5))
    T = 0.01
    report = one.step(0.01, T)
    x, v = 0.2, -0.1
    # (1/N)[m a + b v̂ + k x̂] = -(B + B_e) v̂ - κ (x̂ - x̃) + k_h (1 - x̂), with x̂ = x + ½T v̂ and a = 2 (v̂ - v)/T
    left = 0.5 * (2 / T + 0.5 + 4 * T / 2) + 2.0 + 0.1 + 30 * T / 2 + 10 * T / 2
    right = 0.5 * (2 / T * v - 4 * x) - 30 * (x - 0.5) + 10 * (1 - x)
    mean = right / left
    assert one.state.position[0, 0] == pytest.approx(x + T * mean, rel=1e-14)
    assert one.state.velocity[0, 0] == pytest.approx(2 * mean - v, rel=1e-13)
    middle = x + T / 2 * mean
    assert report.sample.position[0, 0] == pytest.approx(middle, rel=1e-14)
    assert report.sample.stamp == pytest.approx(0.005)
    assert report.force[0, 0] == pytest.approx(10 * (1 - middle), rel=1e-13)
    assert report.supplied == pytest.approx(T * mean * 10 * (1 - middle), rel=1e-12)
    assert report.link_work[0] == pytest.approx(-T * mean * 30 * (middle - 0.5), rel=1e-12)
    assert report.local_loss == pytest.approx(T * 2.0 * mean**2, rel=1e-12)
    assert report.extra_loss == pytest.approx(T * 0.1 * mean**2, rel=1e-12)
    assert report.body_loss == pytest.approx(T * 0.25 * mean**2, rel=1e-12)
    assert abs(report.residual) < 1e-15


def test_a_peer_listens_to_its_neighbours_only() -> None:
    one = peer()
    assert not one.receive(sample(5, 0, 1.0))
    assert one.receive(sample(1, 3, 1.0))
    assert not one.receive(sample(1, 2, 1.0))


def test_a_constant_link_makes_the_peer_wait() -> None:
    one = peer(delay=2)
    for k in range(2):
        assert one.ready
        one.step(0.01 * (k + 1), 0.01)
    assert not one.ready
    one.receive(sample(1, 0, 0.3))
    assert one.ready
    one.step(0.05, 0.03)
    assert one.integrated == pytest.approx(0.05)
    assert not one.ready


def test_a_late_step_takes_longer_and_stays_balanced() -> None:
    one = peer(stiffness=200.0)
    rng = np.random.default_rng(0)
    now = 0.0
    for _ in range(500):
        T = float(rng.choice([0.001, 0.01, 0.3]))
        now += T
        report = one.step(now, T)
        assert abs(report.residual) < 1e-13
    assert one.steps == 500
