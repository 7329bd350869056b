"""The safety chain: whatever comes in, what comes out keeps every limit; and each stage does what it is there for."""

import itertools
import math
from math import inf, nan

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.haptics.inside import STOOD
from tests.thorough import examples

from cotouch.device import PRESETS
from cotouch.errors import DeviceError
from cotouch.haptics import Cause, Heat, Observation, SafetyChain, SafetyLimits, norm, saturate, silence, slew, spoken

LIMITS = SafetyLimits.of(PRESETS["touch"])
anything = st.floats(allow_nan=True, allow_infinity=True)
force = st.one_of(st.floats(-20.0, 20.0), anything)
forces = st.tuples(force, force, force)
cycle = st.tuples(
    forces,
    st.floats(1e-4, 0.3),  # T
    st.one_of(st.floats(0.0, 0.2), anything),  # age
    st.one_of(st.floats(0.0, 0.2), st.just(0.0)),  # stale
    st.one_of(st.floats(0.0, 2.0), anything),  # speed
    st.one_of(st.floats(-1.0, 0.01), anything),  # excess
    st.sampled_from([True, True, True, False]),
    st.sampled_from([True, True, True, False]),
    st.sampled_from([False, False, True]),  # re-arm
)


@settings(max_examples=examples(200))
@given(st.lists(cycle, min_size=1, max_size=40))
def test_whatever_comes_in_what_comes_out_keeps_every_limit(cycles):
    chain = SafetyChain(LIMITS)
    now, before, heat, back = 0.0, (0.0, 0.0, 0.0), 0.0, None
    broken = latched = False
    for wanted, T, age, stale, speed, excess, enabled, follows, rearm in cycles:
        now += T
        if rearm:
            chain.rearm()
            latched = False
        fraction = chain.limit(wanted, Observation(now, T, age, stale, speed, excess, enabled, follows))
        assert 0.0 <= fraction <= 1.0
        out = tuple(fraction * value for value in wanted) if fraction else (0.0, 0.0, 0.0)
        assert all(math.isfinite(value) for value in out)
        length = norm(out)
        broken |= not (math.isfinite(norm(wanted)) and math.isfinite(speed))
        latched |= speed > LIMITS.speed or excess > 0.0
        off = broken or latched or not enabled or not follows
        off |= not age < LIMITS.zero_after or not stale < LIMITS.zero_after or min(STOOD, LIMITS.zero_after) < T
        if off:
            assert length == 0.0
            assert chain.causes
            back = None
        else:
            back = now if back is None else back
            bound = min((now - back) / LIMITS.ramp, 1.0) * silence(age, LIMITS.fade_after, LIMITS.zero_after)
            assert length <= bound * norm(wanted) * (1 + 1e-9)
        assert length <= LIMITS.force * (1 + 1e-9)
        # No farther than the slew limit from all that lies between nothing and the force before.
        assert _distance(out, before) <= LIMITS.force * min(1.0, T / LIMITS.rise) * (1 + 1e-6) + 1e-9
        heat += T / (LIMITS.heat + T) * (norm(before) ** 2 - heat)
        assert heat <= LIMITS.continuous**2 * (1 + 1e-9)
        before = out


def _distance(a, b):
    along = sum(x * y for x, y in zip(a, b, strict=True))
    square = sum(y * y for y in b)
    part = min(1.0, max(0.0, along / square)) if square > 0.0 else 0.0
    return math.dist(a, tuple(part * y for y in b))


@given(st.tuples(*[st.floats(-5, 5)] * 3), st.tuples(*[st.floats(-5, 5)] * 3), st.floats(1e-3, 2.0))
def test_slew_takes_the_largest_share_that_is_near_enough(wanted, before, most):
    fraction = slew(wanted, before, most)
    at = tuple(fraction * x for x in wanted)
    assert _distance(at, before) <= most * (1 + 1e-6) + 1e-9
    if fraction < 1.0:
        more = tuple((fraction + 1e-3) * x for x in wanted)
        assert _distance(more, before) > most * (1 - 1e-6)


def test_slew_never_holds_a_force_up():
    assert slew((0.0, 0.0, 0.0), (3.0, 0.0, 0.0), 0.1) == 1.0  # letting go
    assert slew((1.0, 0.0, 0.0), (3.0, 0.0, 0.0), 0.1) == 1.0  # letting go in part
    assert slew((-1.0, 0.0, 0.0), (3.0, 0.0, 0.0), 0.1) == pytest.approx(0.1)  # the other way: from nothing
    assert slew((4.0, 0.0, 0.0), (3.0, 0.0, 0.0), 0.1) == pytest.approx(3.1 / 4.0)


def test_saturation_and_silence():
    assert saturate(1.0, 2.0) == 1.0
    assert saturate(4.0, 2.0) == 0.5
    fractions = [silence(age, 0.02, 0.1) for age in (0.0, 0.02, 0.06, 0.1, inf, nan)]
    assert fractions == pytest.approx([1.0, 1.0, 0.5, 0.0, 0.0, 0.0])


def test_heat_lets_much_for_a_moment_and_what_may_stay_for_ever():
    heat, held = Heat(0.88, 10.0), []
    for _ in range(30_000):
        limit = min(3.3, heat.limit)
        heat.hold(limit, 1e-3)
        held.append(limit)
    assert held[0] > 2.5
    assert held[-1] == pytest.approx(0.88, rel=1e-2)
    assert heat.square <= 0.88**2
    assert max(a - b for a, b in itertools.pairwise(held)) < 0.01  # it comes down smoothly


def test_a_force_that_stays_comes_down_to_what_may_stay():
    chain, found = SafetyChain(LIMITS), 0.0
    for k in range(6000):
        found = chain.limit((1.6, 0.0, 0.0), _quiet(0.005 * k, T=0.005)) * 1.6
    assert found == pytest.approx(LIMITS.continuous, rel=0.02)
    assert chain.causes == Cause.HOT


def _quiet(now: float, **changes) -> Observation:
    usual = {"T": 1e-3, "age": 0.0, "stale": 0.0, "speed": 0.1, "excess": -1.0, "enabled": True, "follows": True}
    return Observation(now=now, **(usual | changes))


def _risen(chain: SafetyChain, start: float = 0.0) -> float:
    """Time after a second in which the force came up."""
    for k in range(1000):
        chain.limit((0.5, 0.0, 0.0), _quiet(start + 1e-3 * k))
    assert chain.limit((0.5, 0.0, 0.0), _quiet(start + 1.0)) == 1.0
    assert chain.causes == Cause(0)
    return start + 1.0


@pytest.mark.parametrize(
    ("seen", "cause", "latches"),
    [
        ({"speed": 1.6}, Cause.FAST, True),
        ({"excess": 1e-3}, Cause.ACTIVE, True),
        ({"age": 0.2}, Cause.SILENT, False),
        ({"stale": 0.2}, Cause.LATE, False),
        ({"T": 0.025}, Cause.LATE, False),
        ({"enabled": False}, Cause.OFF, False),
        ({"follows": False}, Cause.DEVICE, False),
    ],
)
def test_what_removes_force_and_how_it_comes_back(seen, cause, latches):
    chain = SafetyChain(LIMITS)
    now = _risen(chain)
    assert chain.limit((0.5, 0.0, 0.0), _quiet(now + 1e-3, **seen)) == 0.0
    assert chain.causes & cause
    assert spoken(chain.causes)
    fraction = chain.limit((0.5, 0.0, 0.0), _quiet(now + 2e-3))
    if latches:
        assert fraction == 0.0
        chain.rearm()
        chain.limit((0.5, 0.0, 0.0), _quiet(now + 3e-3))
    assert chain.causes == Cause.RAMP
    assert chain.limit((0.5, 0.0, 0.0), _quiet(now + 0.1)) < 0.25
    _risen(chain, now + 0.2)


@pytest.mark.parametrize("wanted", [(nan, 0.0, 0.0), (0.0, inf, 0.0), (0.0, 0.0, -inf)])
def test_what_is_no_number_ends_it_for_good(wanted):
    chain = SafetyChain(LIMITS)
    now = _risen(chain)
    assert chain.limit(wanted, _quiet(now + 1e-3)) == 0.0
    chain.rearm()
    assert chain.limit((0.5, 0.0, 0.0), _quiet(now + 2e-3)) == 0.0
    assert chain.causes & Cause.FAULT


def test_limits_by_default():
    omega, unknown = PRESETS["omega"], PRESETS["omega"].__class__(**(vars(PRESETS["omega"]) | {"force": 0.0}))
    assert SafetyLimits.of(omega).force == 6.0
    assert SafetyLimits.of(unknown).force == 2.0
    assert SafetyLimits.of(omega, force=12.0).force == 12.0
    assert SafetyLimits.of(PRESETS["touch"]).continuous == 0.88


@pytest.mark.parametrize(
    "wanted",
    [
        {"force": 12.1},
        {"force": nan},
        {"rise": 0.005},
        {"ramp": 0.1},
        {"fade_after": 0.03},
        {"zero_after": 0.2},
        {"zero_after": 0.01},
        {"speed": 3.0},
        {"radius": 0.2},
        {"wall": 6000.0},
        {"continuous": 13.0},
        {"heat": 20.0},
        {"mass": 1.0},
    ],
)
def test_limits_move_towards_the_safe_side_only(wanted):
    with pytest.raises(DeviceError, match="safety limit"):
        SafetyLimits.of(PRESETS["omega"], **wanted)
