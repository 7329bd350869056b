"""Coupling of device and proxy: what modulation does with energy, and when a virtual coupling makes some."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.coupling.inside import credit

from cotouch.coupling import checked_virtual_coupling, modulate, modulation_bound, virtual_coupling_limit
from cotouch.errors import DeviceError

energies = st.floats(0.0, 1e3)


@given(potential=energies, available=st.floats(-1e3, 1e3), cap=energies)
def test_modulation_keeps_every_joule(potential, available, cap):
    barycentric, tank, sent = modulate(potential, available, cap)
    assert 0.0 <= barycentric <= 1.0
    assert sent >= 0.0
    assert barycentric**2 * potential + tank + sent == pytest.approx(available, rel=1e-14, abs=1e-12)
    assert tank <= cap + 1e-15 * abs(available)
    if available <= 0.0:
        assert (barycentric, tank, sent) == (0.0, available, 0.0)
    else:
        assert tank >= 0.0
        # The wish comes true as far as it can: nothing is kept or sent while it does not.
        assert (barycentric == 1.0) or tank == sent == 0.0
    if available > potential:
        assert barycentric == 1.0


def test_modulation_at_its_edges():
    assert modulate(0.0, 0.0, 1.0) == (0.0, 0.0, 0.0)
    assert modulate(0.0, 2.0, 1.0) == (1.0, 1.0, 1.0)
    assert modulate(4.0, 1.0, 1.0) == (0.5, 0.0, 0.0)
    assert modulate(1.0, 1.0, 0.0) == (1.0, 0.0, 0.0)
    assert modulate(0.0, float("nan"), 1.0)[0] == 0.0
    for desired in (float("nan"), float("inf")):
        assert modulate(desired, 1.0, 2.0) == (0.0, 1.0, 0.0)


@given(totals=st.lists(energies, max_size=20))
def test_a_total_is_credited_once_whatever_arrives(totals):
    seen = 0.0
    for total in totals:
        gift = credit(total, seen)
        assert gift >= 0.0
        seen += gift
    assert seen == pytest.approx(max(totals, default=0.0), rel=1e-12)


def coupled(k, b, q, y, T):
    """Energy that the virtual coupling has made in every step: work at both ports plus the change of its spring."""
    made = []
    for n in range(1, T.size):
        v = (q[n] - q[n - 1]) / T[n - 1]
        w = (y[n + 1] - y[n]) / T[n]
        pull = k * (q[n] - y[n + 1]) + b * (v - w)
        work = pull @ (y[n + 1] - y[n]) - pull @ (q[n + 1] - q[n])
        stored = 0.5 * k * (np.sum((q[n + 1] - y[n + 1]) ** 2) - np.sum((q[n] - y[n]) ** 2))
        made.append(work + stored)
    return np.array(made)


@given(
    seed=st.integers(0, 10**6), k=st.floats(0.0, 1e4), b=st.floats(0.0, 10.0), spread=st.sampled_from([1.0, 1.5, 4.0])
)
def test_the_virtual_coupling_makes_no_more_than_the_devices_damping_pays(seed, k, b, spread):
    rng = np.random.default_rng(seed)
    steps = 100
    T = np.full(steps, 1e-3)
    if spread > 1.0:
        T = 1e-3 * spread ** rng.uniform(0.0, 1.0, steps)
    q, y = (np.cumsum(rng.normal(0.0, 1e-3, (steps + 1, 3)), axis=0) for _ in range(2))
    if rng.uniform() < 0.5:
        y[:] = 0.0
    moved, followed = np.sum(np.diff(q, axis=0) ** 2, axis=1), np.sum(np.diff(y, axis=0) ** 2, axis=1)
    made = coupled(k, b, q, y, T)
    spring = 0.5 * k * (moved[1:] - followed[1:])
    if b == 0.0:
        np.testing.assert_allclose(made, spring, rtol=1e-9, atol=1e-15)
    if spread == 1.0:
        own = k * 1e-3 / 2 + b
    else:
        ratio = max((T[1:] / T[:-1]).max(), 1.0)
        own = k * T.max() / 2 + 0.5 * b * (1.0 + ratio)
        assert virtual_coupling_limit(device_damping=own, period=T.max(), damping=b, spread=ratio) == pytest.approx(
            k, rel=1e-6, abs=1e-6
        )
    assert made.sum() <= own * np.sum(moved / T) * (1.0 + 1e-9) + 1e-15


def test_the_bound_is_tight():
    """A device that shakes with the servo's period makes the coupling give all that the bound says."""
    k, b, T, steps = 500.0, 0.3, 1e-3, 1000
    q = np.zeros((steps + 1, 1))
    q[1::2] = 1e-3
    made = coupled(k, b, q, np.zeros_like(q), np.full(steps, T)).sum()
    paid = np.sum(np.diff(q, axis=0) ** 2) / T
    assert made == pytest.approx((k * T / 2 + b) * paid, rel=2e-3)
    assert virtual_coupling_limit(device_damping=k * T / 2 + b, period=T, damping=b) == pytest.approx(k)


@given(seed=st.integers(0, 10**6))
def test_own_clocks_are_paid_for_by_the_age_rule(seed):
    """Each end with its own spring to the other's last sample, and its own rate: positions as random walks in time."""
    rng = np.random.default_rng(seed)
    fine = 1e-4
    n = 4000
    servo, body = int(rng.integers(2, 30)), int(rng.integers(2, 60))
    late = rng.integers(0, 40, 2)
    k, weight = 1.0, float(10.0 ** rng.uniform(-0.5, 0.5))
    # The device moves at random, or shakes with its servo; the proxy, in steps, with it or against it.
    shake = np.sign(np.sin(np.pi * (np.arange(n) + 0.5) / rng.integers(2, 40)))
    speed = rng.normal(0.0, 1.0, n) if rng.uniform() < 0.5 else shake
    speed[-1] = 0.0
    q = np.concatenate([[0.0], np.cumsum(speed) * fine])
    steps = n // body
    follow = np.repeat(np.sign(rng.normal(size=steps)) * (speed[::body][:steps] if rng.uniform() < 0.5 else 1.0), body)
    w = np.zeros(n)
    w[: follow.size] = follow
    y = np.concatenate([[0.0], np.cumsum(w) * fine])
    made = 0.5 * k * (q[-1] - y[-1]) ** 2
    for t in range(n):
        at_servo, at_body = t // servo * servo, t // body * body
        # A sample of the proxy is its place at a body step's start; the spring at the proxy is implicit (continuous).
        told_y = y[max(at_servo - late[0], 0) // body * body]
        told_q = q[max(at_body - late[1], 0) // servo * servo]
        made += k * (told_y - q[at_servo]) * speed[t] * fine
        made += k * (told_q - 0.5 * (y[t] + y[t + 1])) * w[t] * fine
    ages = fine * (servo + late[0] + body + body + late[1] + servo)
    own = k / virtual_coupling_limit(device_damping=1.0, period=servo * fine, ages=ages, weight=weight)
    other = 0.5 * k * ages / weight
    assert made <= own * np.sum(speed**2) * fine + other * np.sum(w**2) * fine + 1e-12


def test_a_coupling_is_refused_lowered_or_taken():
    one = {"device_damping": 0.5, "period": 1e-3}
    assert virtual_coupling_limit(**one) == pytest.approx(1000.0)
    assert virtual_coupling_limit(**one, damping=0.1) == pytest.approx(800.0)
    assert virtual_coupling_limit(**one, damping=0.1, spread=3.0) == pytest.approx(600.0)
    assert virtual_coupling_limit(**one, ages=1e-3) == pytest.approx(500.0)
    assert virtual_coupling_limit(**one, ages=1e-3, weight=0.5) == pytest.approx(1000.0 / 1.5)
    assert checked_virtual_coupling(stiffness=999.0, **one) == 999.0
    assert checked_virtual_coupling(stiffness=2000.0, lower=True, **one) == pytest.approx(1000.0)
    with pytest.raises(DeviceError, match=r"stiffness is 2000 N/m; .* passive up to 1000 N/m; lower it or use PSPM"):
        checked_virtual_coupling(stiffness=2000.0, **one)
    with pytest.raises(
        DeviceError, match=r"damping is 1 Ns/m, but the device's own 0\.5 Ns/m can pay for less than 0\.5"
    ):
        checked_virtual_coupling(stiffness=10.0, damping=1.0, lower=True, **one)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"device_damping": -1.0}, "device_damping is -1; it must be finite and at least 0"),
        ({"period": 0.0}, "period is 0; it must be finite and above 0"),
        ({"damping": float("nan")}, "damping is nan"),
        ({"ages": -1e-3}, r"ages is -0\.001"),
        ({"weight": 0.0}, "weight is 0; it must be finite and above 0"),
        ({"spread": 0.5}, r"spread is 0\.5; it must be finite and at least 1"),
        ({"stiffness": 0.0}, "stiffness is 0 N/m; it must be finite and above 0"),
    ],
)
def test_numbers_out_of_range_are_named(change, message):
    with pytest.raises(DeviceError, match=message):
        checked_virtual_coupling(**{"stiffness": 1.0, "device_damping": 1.0, "period": 1e-3, **change})


def test_the_bound_of_modulation_by_hand():
    assert modulation_bound(stiffness=1000.0, damping=0.0, period=1e-3, speed=2.0) == pytest.approx(0.5 * 1000 * 4e-6)
    assert modulation_bound(stiffness=0.0, damping=3.0, period=1e-3, speed=2.0, reserve=0.1) == pytest.approx(0.112)
    with_encoder = modulation_bound(
        stiffness=0.0, damping=0.0, period=1e-3, speed=0.0, force=2.0, resolution=1e-3, axes=4
    )
    assert with_encoder == pytest.approx(6e-3)


def test_dry_friction_sets_the_limit_that_an_encoder_asks_for():
    """k <= 2 f / Δ of one axis [Abbott & Okamura 2005], and of the velocity that the same encoder measures."""
    step, friction = 1e-4, 0.05
    given = {"device_damping": 10.0, "period": 1e-3, "unseen": step / 2, "dry": friction}
    assert virtual_coupling_limit(**given) == pytest.approx(2.0 * friction / step)
    assert virtual_coupling_limit(**given, damping=0.1, shortest=5e-4) == pytest.approx(1000.0 - 400.0)
    assert virtual_coupling_limit(**{**given, "unseen": 0.0}) == pytest.approx(2e4)
    assert checked_virtual_coupling(stiffness=5000.0, lower=True, **given) == pytest.approx(1000.0)
    with pytest.raises(
        DeviceError, match=r"5e-05 m of its place, with 0\.05 N .* is passive up to 1000 N/m; lower it or"
    ):
        checked_virtual_coupling(stiffness=1001.0, **given)
    for lower in (False, True):
        with pytest.raises(DeviceError, match=r"with 0 N of dry friction .* is passive with none; refine them or use"):
            checked_virtual_coupling(stiffness=1.0, lower=lower, **{**given, "dry": 0.0})
