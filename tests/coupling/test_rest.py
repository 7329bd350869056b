"""A place at rest: still where it flickers, true where it moves, and never far from what is measured."""

import numpy as np
import pytest

from cotouch.coupling import REST_DRIFT, REST_FIELDS, place_at_rest, rest_fraction

STEP, T = 5e-5, 1e-3


def taken(measured: np.ndarray, stiffness: float = 500.0, step: float = STEP) -> np.ndarray:
    memory = np.zeros((2, REST_FIELDS))
    fraction = rest_fraction(stiffness, step)
    return np.array([place_at_rest(memory, 1, float(one), step, fraction, T) for one in measured])


def test_what_flickers_between_two_steps_hardly_moves_the_force() -> None:
    measured = STEP * (7 + (np.arange(2000) // 37) % 2)
    places = taken(measured)
    np.testing.assert_array_equal(places[:490], measured[:490])
    assert np.ptp(500.0 * places[1600:]) <= 0.0041
    assert np.abs(places[1600:] - 7.5 * STEP).max() < 0.3 * STEP  # where it is, on average


def test_the_force_of_a_step_is_the_same_at_any_stiffness_and_resolution() -> None:
    assert rest_fraction(500.0, 0.0) == rest_fraction(0.0, STEP) == rest_fraction(50.0, STEP) == 1.0
    for stiffness, step in ((500.0, 6e-5), (5000.0, 2e-5), (3000.0, 6e-5)):
        assert stiffness * step * rest_fraction(stiffness, step) == pytest.approx(0.004)


@pytest.mark.parametrize("speed", [2e-4, 0.01, 1.0])
def test_who_moves_on_is_followed_to_the_step(speed: float) -> None:
    measured = STEP * np.round(speed * T * np.arange(1, 1000) / STEP)
    np.testing.assert_array_equal(taken(measured), measured)


def test_who_leaves_is_followed_without_a_jump() -> None:
    still, away = np.zeros(700), STEP * np.arange(1, 41)
    measured = np.concatenate([still, np.repeat(away, 3), np.full(2000, away[-1])])
    places = taken(measured)
    # While it moves, and while what it is off by fades, a tick moves it by little more than the encoder does.
    assert np.abs(np.diff(places)).max() < 1.1 * STEP
    assert np.abs(places - measured).max() < 13 * STEP
    assert abs(places[-1] - measured[-1]) < 0.1 * STEP


@pytest.mark.parametrize("seed", range(5))
def test_it_is_never_far_off_and_not_much_faster_whatever_comes(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pace = np.repeat(rng.choice([0.0, 0.2, 1.0, 40.0], 40), rng.integers(5, 400))
    measured = STEP * np.round(np.cumsum(rng.normal(0.0, 1.0, pace.size) * pace) * 0.5)
    places = taken(measured)
    assert np.abs(places - measured).max() <= 15.1 * STEP
    for window in (10, 30):
        fastest = np.abs(np.diff(measured)).max() / T
        mean = np.abs(places[window:] - places[:-window]) / (window * T)
        assert mean.max() <= fastest + REST_DRIFT * STEP
        own = np.array([np.abs(np.diff(measured[k : k + window + 1])).sum() for k in range(len(measured) - window)])
        assert (mean <= own / (window * T) + REST_DRIFT * STEP).all()
