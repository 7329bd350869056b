"""The law of one contact and the sweep over several, against their equations and an independent solver."""

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize
from tests.thorough import examples

from cotouch.mechanics import resist
from cotouch.mechanics._contact import SWEEPS, sweep

Array = np.ndarray


def decades(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high).map(lambda exponent: 10.0**exponent)


signed = st.tuples(st.sampled_from([-1.0, 1.0]), decades(-12, 0)).map(lambda pair: pair[0] * pair[1]) | st.just(0.0)
stiffnesses, yields, dampings = decades(0, 8), decades(-10, 2), decades(-3, 6) | st.just(0.0)


def stored(k: float, depth: Fraction) -> Fraction:
    return Fraction(k) * max(depth, Fraction(0)) ** 2 / 2


def pushed(k: float, e: float, d: Fraction, a: float) -> Fraction:
    """The law in exact arithmetic."""
    if d == 0:
        return Fraction(k) * max(Fraction(e), Fraction(0))
    return (stored(k, Fraction(e) + d) - stored(k, Fraction(e))) / d * max(1 + Fraction(a) * d, Fraction(0))


class TestLaw:
    @given(stiffnesses, signed, signed, yields, dampings)
    @settings(max_examples=examples(800))
    @example(1e8, -1.0, 1.0 + 1e-9, 1e2, 0.0)
    @example(1e8, 1e-12, -1.0, 1e-10, 1e6)
    @example(1.0, 0.0, 1.0, 1.0, 1.0)
    def test_is_solved_to_round_off(self, k: float, e: float, free: float, r: float, a: float):
        force = resist(k, e, free, r, a)
        assert force >= 0.0
        assert math.isfinite(force)
        # F(d) = d - free + r f(d) rises: the force is right to round-off if F changes sign within a hair of d.
        slack = Fraction(64 * 2.0**-53) * Fraction(max(abs(free), abs(e), r * force) + abs(free))
        d = Fraction(free) - Fraction(r) * Fraction(force)
        low, high = d - slack, d + slack
        assert low - Fraction(free) + Fraction(r) * pushed(k, e, low, a) <= 0
        assert high - Fraction(free) + Fraction(r) * pushed(k, e, high, a) >= 0

    @given(stiffnesses, signed, signed, yields)
    @settings(max_examples=examples(800))
    @example(1e6, 0.0, 1e-6, 1e2)
    @example(1e8, -1.0, 1.0 + 1e-12, 1e2)
    def test_without_damping_does_the_work_of_its_spring(self, k: float, e: float, free: float, r: float):
        force = resist(k, e, free, r, 0.0)
        if e < 0.0:  # d by the penetration at the end, which is small beside the gap: free - r f loses it
            end = math.sqrt(max(2.0 * force * _closing(k, e, free, r), 0.0) / k)
            d = end - e
            assert force * d == pytest.approx(0.5 * k * end**2, rel=1e-12)
        d_exact = Fraction(free) - Fraction(r) * Fraction(force)
        work = Fraction(force) * d_exact
        gained = stored(k, Fraction(e) + d_exact) - stored(k, Fraction(e))
        size = abs(force * free) + r * force**2 + force * abs(e)
        assert abs(float(work - gained)) <= 1e-14 * size * (1.0 + r * k) ** 0.5 + 1e-300

    @given(stiffnesses, signed, signed, yields, dampings)
    @settings(max_examples=examples(400))
    def test_damping_takes_energy(self, k: float, e: float, free: float, r: float, a: float):
        force = Fraction(resist(k, e, free, r, a))
        d = Fraction(free) - Fraction(r) * force
        gained = stored(k, Fraction(e) + d) - stored(k, Fraction(e))
        size = float(force) * (abs(free) + abs(e) + r * float(force))
        assert float(force * d - gained) >= -1e-14 * size * (1.0 + r * k) ** 0.5 - 1e-300

    @given(stiffnesses, signed, signed, signed, yields, dampings)
    @settings(max_examples=examples(400))
    def test_rises_with_the_motion(self, k: float, e: float, free: float, more: float, r: float, a: float):
        less, most = sorted((free, free + more))
        assert resist(k, e, less, r, a) <= resist(k, e, most, r, a) * (1.0 + 1e-11) + 1e-13 * k * abs(e)

    @given(stiffnesses, signed.filter(bool), yields, dampings)
    @settings(max_examples=examples(300))
    def test_is_continuous_where_one_formula_follows_another(self, k: float, e: float, r: float, a: float):
        s = r * k
        borders = [-e, 0.0, 0.5 * s * e * max(1.0 - a * e, 0.0) - e, s * e]
        if a > 0.0:
            borders.append(-1.0 / a)
        for border in borders:
            hair = 1e-12 * (abs(border) + abs(e))
            below, above = (resist(k, e, border + side, r, a) for side in (-hair, hair))
            # The slope of the force is at most k (1 + a |d|) + a f, and at most 1/r.
            steepest = min(1.0 / r, k * (1.0 + a * (abs(border) + abs(e))) * 2.0)
            assert abs(above - below) <= 3.0 * steepest * hair + 1e-11 * max(above, below)
        nearby = [resist(k, depth, 1e-3, r, a) for depth in (-1e-15, 0.0, 1e-15)]
        assert nearby[0] == pytest.approx(nearby[2], rel=1e-9)
        assert nearby[1] == pytest.approx(nearby[2], rel=1e-9)

    def test_at_rest_in_contact_is_the_spring_to_the_bit(self):
        k, e, r = 1234.5, 0.00321, 1e-5
        assert resist(k, e, r * k * e, r, 0.0) == pytest.approx(k * e, rel=1e-15)

    def test_a_number_that_is_none_is_seen(self):
        for bad in ((np.nan, 1.0, 1.0, 1.0, 1.0), (1.0, np.nan, 1.0, 1.0, 0.0), (1.0, 1e-3, np.nan, 1.0, 1.0)):
            assert np.isnan(resist(*bad))
        assert np.isnan(resist(1e3, -1e-3, np.nan, 1e-5, 1.0))

    def test_what_does_not_yield_gets_the_force_of_the_motion(self):
        assert resist(1000.0, 0.01, 0.002, 0.0, 0.0) == pytest.approx(1000.0 * 0.011)
        assert resist(1000.0, -0.001, 0.003, 0.0, 0.0) == pytest.approx(0.5 * 1000.0 * 0.002**2 / 0.003)


def _closing(k: float, e: float, free: float, r: float) -> float:
    """d of an entering contact in 60 digits."""
    from decimal import Decimal, localcontext

    with localcontext() as context:
        context.prec = 60
        K, E, F, R = (Decimal(x) for x in (k, e, free, r))
        if E + F <= 0:
            return float(F)
        a, b, c = 1 + R * K / 2, R * K * E - F, R * K * E * E / 2
        return float((-b + (b * b - 4 * a * c).sqrt()) / (2 * a))


def problem(
    rng: np.random.Generator, count: int, axes: int, *, loss: float = 0.0, friction: float = 0.0
) -> list[Array]:
    """Random contacts: depth, stiffness, loss, friction, free, compliance."""
    size = count * axes
    half = rng.normal(size=(size, size + 2))
    return [
        rng.normal(size=count) * 1e-3,
        10.0 ** rng.uniform(2, 6, count),
        np.full(count, loss),
        np.full(count, friction),
        rng.normal(size=size) * 1e-3,
        1e-6 * half @ half.T,
    ]


def swept(count: int, axes: int, parts: list[Array]) -> tuple[Array, int]:
    force = np.zeros(count * axes)
    sweeps = sweep(count, axes, *parts, force, np.zeros((2, count * axes)))
    return force, sweeps


def primitive(k: Array, e: Array, d: Array) -> Array:
    """∫ of the undamped law over d from 0: convex, so that the problem is the least of a convex function."""
    steps, weights = np.polynomial.legendre.leggauss(400)
    s = 0.5 * (steps[:, None] + 1.0) * d
    return 0.5 * d * (weights[:, None] * law(k, e, s)).sum(axis=0)


def law(k: Array, e: Array, d: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        quotient = 0.5 * k * (np.maximum(e + d, 0.0) ** 2 - np.maximum(e, 0.0) ** 2) / d
    return np.where(d == 0.0, k * np.maximum(e, 0.0), quotient)


class TestSweep:
    @pytest.mark.parametrize("seed", range(12))
    def test_agrees_with_a_convex_minimum(self, seed: int):
        """d minimises `½ (d - free)ᵀ R⁻¹ (d - free) + Σ ∫ f`; solved here by another method over d."""
        rng = np.random.default_rng(seed)
        count = int(rng.integers(2, 7))
        parts = problem(rng, count, 1)
        e, k, _, _, free, R = parts
        force, sweeps = swept(count, 1, parts)
        assert sweeps < SWEEPS
        inverse = np.linalg.inv(R)
        scale = 1e-3

        def slope(z: Array) -> Array:
            d = z * scale
            return (inverse @ (d - free) + law(k, e, d)) * scale

        def value(z: Array) -> float:
            d = z * scale
            return float(0.5 * (d - free) @ inverse @ (d - free) + primitive(k, e, d).sum())

        best = minimize(value, free / scale, jac=slope, method="BFGS", options={"gtol": 1e-12, "maxiter": 2000})
        d = best.x * scale
        assert force == pytest.approx(inverse @ (free - d), abs=1e-4 * force.max() + 1e-12)
        # And without any other solver: the equations themselves.
        d = free - R @ force
        assert force == pytest.approx(law(k, e, d), rel=1e-8, abs=1e-10 * force.max())
        assert np.all(force >= 0.0)

    @pytest.mark.parametrize("seed", range(20))
    def test_friction(self, seed: int):
        rng = np.random.default_rng(seed)
        count, mu = int(rng.integers(1, 5)), float(rng.choice([0.1, 0.5, 1.0]))
        parts = problem(rng, count, 3, friction=mu)
        force, sweeps = swept(count, 3, parts)
        d = parts[4] - parts[5] @ force
        size = np.abs(force).max() + 1e-300
        for c in range(count):
            normal, across, slip = force[3 * c], force[3 * c + 1 : 3 * c + 3], d[3 * c + 1 : 3 * c + 3]
            assert normal >= 0.0
            assert np.linalg.norm(across) <= mu * normal * (1.0 + 1e-12)
            assert across @ slip >= -1e-9 * size * np.abs(d).max()
            if sweeps < SWEEPS:
                if np.linalg.norm(across) < mu * normal * (1.0 - 1e-6):
                    assert np.abs(slip).max() <= 1e-7 * np.abs(d).max()
                elif normal > 1e-9 * size:
                    cosine = across @ slip / (np.linalg.norm(across) * np.linalg.norm(slip) + 1e-300)
                    assert cosine >= 1.0 - 1e-6 or np.linalg.norm(slip) <= 1e-7 * np.abs(d).max()

    @pytest.mark.parametrize("stiffness", [1e3, 1e6, 1e8])
    def test_contacts_that_are_one(self, stiffness: float):
        """Several contacts at one place share its force as their springs in parallel would."""
        count, r, e, free = 4, 1e-4, 1e-3, 1e-4
        parts = [np.full(count, e), np.full(count, stiffness), np.zeros(count), np.zeros(count)]
        parts += [np.full(count, free), np.full((count, count), r)]
        force, _ = swept(count, 1, parts)
        together = resist(count * stiffness, e, free, r, 0.0)
        assert force.sum() == pytest.approx(together, rel=1e-9)
        assert force == pytest.approx(np.full(count, together / count), rel=1e-6)

    @pytest.mark.parametrize("apart", [3e-2, 1e-2, 1e-3])
    def test_contacts_that_hardly_move_apart_settle(self, apart: float):
        """On a light body: plain sweeps come nearer by a share of `apart` only. All of them touch: a linear problem."""
        r, stiffness, e = 1e-2, 1e6, np.array([1.0e-3, 1.2e-3, 0.8e-3])
        R = r * ((1.0 - apart) * np.ones((3, 3)) + apart * np.eye(3))
        wanted = stiffness * np.array([1.1e-3, 1.0e-3, 0.9e-3])
        free = (R + 2.0 / stiffness * np.eye(3)) @ wanted - 2.0 * e
        force, _ = swept(3, 1, [e, np.full(3, stiffness), np.zeros(3), np.zeros(3), free, R])
        assert force == pytest.approx(wanted, rel=1e-7)

    def test_nothing_near_takes_one_sweep(self):
        parts = problem(np.random.default_rng(1), 3, 1)
        parts[0][:] = -1.0
        force, sweeps = swept(3, 1, parts)
        assert not force.any()
        assert sweeps == 1
