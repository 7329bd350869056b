import numpy as np
import pytest
from tests.hands.inside import Mover, Wander


def test_it_reaches_a_goal_and_hardly_passes_it() -> None:
    mover = Mover(1)
    seen = []
    for _ in range(500):
        mover.move([0.1], 0.002, speed=1.0, sharpness=60.0, rush=8.0)
        seen.append(mover.place[0])
    assert seen[-1] == pytest.approx(0.1, abs=1e-6)
    assert max(seen) < 0.101


def test_it_is_never_faster_than_it_may_and_starts_gently() -> None:
    mover, last = Mover(3), np.zeros(3)
    rates = []
    for _ in range(300):
        mover.move([3.0, -4.0, 0.0], 0.002, speed=2.0, sharpness=120.0, rush=40.0)
        rates.append(np.linalg.norm(np.array(mover.place) - last) / 0.002)
        last = np.array(mover.place)
    assert max(rates) == pytest.approx(2.0)
    assert np.diff([0.0, *rates]).max() < 0.1


def test_a_pointer_at_60_hz_is_smooth_at_500_hz() -> None:
    """Steps of the pointer are some 5 mm; what follows it moves by parts of a millimetre, nearly evenly."""
    mover, moves = Mover(1), []
    for k in range(1000):
        goal = 0.3 * np.floor(k * 0.002 * 60.0) / 60.0
        before = mover.place[0]
        mover.move([goal], 0.002, speed=5.0, sharpness=120.0, rush=20.0)
        moves.append(mover.place[0] - before)
    steady = np.array(moves[200:])
    assert steady.mean() == pytest.approx(0.3 * 0.002, rel=0.01)
    assert steady.max() < 2.0 * steady.mean()
    assert steady.min() > 0.0


def test_different_lengths_of_steps_lead_to_the_same_place() -> None:
    one, two = Mover(2), Mover(2)
    one.put([0.01, 0.0])
    two.put([0.01, 0.0])
    one.rate, two.rate = [0.1, 0.1], [0.1, 0.1]
    for _ in range(10):
        one.move([0.0, 0.0], 0.01, speed=1e3, sharpness=30.0, rush=1e6)
    two.move([0.0, 0.0], 0.1, speed=1e3, sharpness=30.0, rush=1e6)
    assert one.place == pytest.approx(two.place)
    assert one.rate == pytest.approx(two.rate)


def test_wandering_stays_in_reach_and_differs_by_seed() -> None:
    times = np.linspace(0.0, 60.0, 600)
    one, other = (np.array([Wander(3, reach=0.05, seed=seed).at(t) for t in times]) for seed in (1, 2))
    assert np.abs(one).max() <= 0.05
    assert np.ptp(one, axis=0).min() > 0.04
    assert np.abs(one - other).max() > 0.02
    assert np.abs(np.diff(one, axis=0)).max() < 0.05 * 2 * np.pi * 0.22 * 0.11
