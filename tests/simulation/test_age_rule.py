"""The damping rules against the worst possible users.

With forces free, the velocities of all users at all steps are free, and the energy that they supply is a quadratic form
in them: `Σ T v̂ᵀ (B v̂ + Σ_j K (x̂_i - x̃_ij))`, started at rest, without mass and body (which only add what is passive
already). The users are N-port passive if and only if this form is positive semidefinite. That leaves nothing to chance.
"""

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.scenario import Scenario
from cotouch.simulation import Schedule, prepare, schedule


def supply_form(
    timing: Schedule, spring: npt.NDArray[np.float64], damping: npt.NDArray[np.float64]
) -> npt.NDArray[Any]:
    """The form, scaled by the steps so that its unit is that of damping."""
    users = timing.count.size
    first = np.concatenate([[0], np.cumsum(timing.count)])
    middle = np.zeros((first[-1], first[-1]))  # row: the position at mid-step as a combination of all velocities
    T = np.concatenate([timing.length[i, :n] for i, n in enumerate(timing.count)])
    for i, n in enumerate(timing.count):
        for k in range(n):
            row = first[i] + k
            middle[row, first[i] : row] = T[first[i] : row]
            middle[row, row] = T[row] / 2
    force = np.diag(np.repeat(damping, timing.count))
    for i in range(users):
        for s in range(timing.slots.first[i], timing.slots.first[i + 1]):
            j = timing.slots.sender[s]
            for k in range(timing.count[i]):
                row, used = first[i] + k, timing.used[s, k]
                force[row] += spring[i, j] * middle[row]
                if used >= 0:
                    force[row] -= spring[i, j] * middle[first[j] + used]
    form = T[:, None] * force
    scale = 1.0 / np.sqrt(T)
    return scale[:, None] * (form + form.T) / 2 * scale[None, :]


def users_of(draw: st.DrawFn, mode: str) -> Scenario:
    count = draw(st.integers(2, 4))
    value = st.floats(0.0, draw(st.sampled_from([0.0, 0.02, 0.2])))
    spring, delay = np.zeros((count, count)), np.zeros((count, count))
    for a in range(count):
        for b in range(a):
            spring[a, b] = spring[b, a] = draw(st.sampled_from([0.0, 5.0, 60.0])) if b else 20.0
            delay[a, b], delay[b, a] = draw(value), draw(value)
    if mode == "constant" or draw(st.booleans()):  # of a common index the users' clocks are alike, but for chance
        steps: dict[str, Any] = {"random": {"low": 0.005, "high": draw(st.floats(0.01, 0.1))}}
    else:
        steps = {"period": [draw(st.sampled_from([0.01, 0.025, 0.08])) for _ in range(count)]}
    return Scenario.make(
        network={"users": [str(i) for i in range(count)], "spring": spring.tolist(), "delay": delay.tolist()},
        steps={"duration": 0.8, **steps},
        synchronisation={"mode": mode},
        channel={
            "jitter": {"scale": draw(st.floats(0.0, 0.1))},
            "loss": draw(st.sampled_from([0.0, 0.3])),
            "duplication": 0.1,
            "reordering": 0.2,
            "reordering_delay": 0.05,
        },
        seed=draw(st.integers(0, 1000)),
    )


@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
@pytest.mark.parametrize("method", ["rule", "minimax"])
@given(data=st.data())
def test_no_user_whatsoever_can_get_energy_out(mode: str, method: str, data: st.DataObject) -> None:
    scenario = data.draw(st.composite(users_of)(mode))
    timing = schedule(scenario)
    prepared = prepare(scenario.replace(synchronisation__damping=method))
    damping = prepared.local_damping[:, 0]
    least = np.linalg.eigvalsh(supply_form(timing, scenario.network.spring, damping))[0]
    assert least >= -1e-10 * max(damping.max(), 1.0)


def test_a_common_index_keeps_to_the_rule_with_users_steps_that_differ() -> None:
    """T_i(k) of the paper: here up to four times those of the others, in the same index."""
    scenario = Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.04], [0.06, 0]]},
        steps={"duration": 3.0, "random": {"low": 0.005, "high": 0.02}},
        synchronisation={"mode": "constant"},
    )
    timing = schedule(scenario)
    assert (timing.length[0] / timing.length[1]).max() > 3.0
    rule = prepare(scenario).local_damping[:, 0]
    assert timing.index_delay is not None
    both = (timing.index_delay[0, 1] + timing.index_delay[1, 0]) / 2
    assert rule == pytest.approx(50.0 * both * timing.length.max(axis=1)[::-1], rel=1e-12)
    assert np.linalg.eigvalsh(supply_form(timing, scenario.network.spring, rule))[0] >= -1e-10


@pytest.mark.parametrize("mode", ["constant", "freshest"])
def test_the_rule_is_tight_for_two_users(mode: str) -> None:
    """With 90 % of the rule, and long enough, two users find a way to get energy out."""
    scenario = Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.04], [0.06, 0]]},
        steps={"duration": 3.0, "period": 0.01},
        synchronisation={"law": "spring", "mode": mode},
    )
    timing = schedule(scenario)
    rule = prepare(scenario).local_damping[:, 0]
    assert np.linalg.eigvalsh(supply_form(timing, scenario.network.spring, rule))[0] >= -1e-10
    # The freshest mode's age starts at the middle of the sender's step, half a step before the paper's delay.
    low = 0.9 if mode == "constant" else 0.75
    assert np.linalg.eigvalsh(supply_form(timing, scenario.network.spring, low * rule))[0] < -1e-3


@pytest.mark.parametrize("slow", [0.1, 0.3])
def test_a_slow_receiver_of_a_fast_sender_is_covered(slow: float) -> None:
    """Here a sample may be newer than most of the step that uses it, and its age shorter than that step."""
    scenario = Scenario.make(
        network={"users": ["slow", "fast"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.0], [0.0, 0]]},
        steps={"duration": 3.0, "period": [slow, 0.01]},
        synchronisation={"law": "spring"},
    )
    timing = schedule(scenario)
    assert timing.age[0, : timing.count[0]].max() < slow
    form = supply_form(timing, scenario.network.spring, prepare(scenario).local_damping[:, 0])
    assert np.linalg.eigvalsh(form)[0] >= -1e-10
