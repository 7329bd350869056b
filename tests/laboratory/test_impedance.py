"""What a hand feels: predicted against measured, and against what is known."""

from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import two

from cotouch.body import Body, chain
from cotouch.errors import ScenarioError, UnsupportedError
from cotouch.laboratory import Study, ideal, impedance
from cotouch.scenario import Scenario

TONES = [0.3, 1.0, 3.0, 10.0]


def scenario(law: Any, **tables: Any) -> Scenario:
    return Scenario.make(
        **{
            "network": two(0.025),
            "synchronisation": {"mode": "constant", "law": law},
            "hands": [{"user": 1, "stiffness": 300}, {"user": 2, "stiffness": 300, "damping": 3.0}],
            **tables,
        }
    )


def both(found: Any) -> tuple[np.ndarray, np.ndarray]:
    predicted = found["predicted_real"].values + 1j * found["predicted_imag"].values
    return predicted, found["measured_real"].values + 1j * found["measured_imag"].values


@pytest.mark.parametrize("others", ["free", "holding"])
@pytest.mark.parametrize("law", ["spring", "pd", "once", {"kind": "wave", "impedance": 2.0}])
def test_measured_is_what_was_predicted(law: Any, others: Any) -> None:
    predicted, measured = both(impedance(scenario(law), 1, others=others, frequencies=TONES))
    assert np.abs(measured / predicted - 1.0).max() < 0.03


def test_of_a_body_with_nodes_too() -> None:
    body = chain(4, dimension=2, stiffness=300, damping=0.5, ground=[0], ground_stiffness=100)
    table = scenario("spring", body=body, hands=[{"user": 1, "node": 3}, {"user": 2, "node": 4, "stiffness": 50}])
    found = impedance(table, 1, others="holding", axis=1, frequencies=TONES)
    assert found.attrs["node"] == 3
    predicted, measured = both(found)
    assert np.abs(measured / predicted - 1.0).max() < 0.03


def test_drag_and_mass_are_those_that_are_known() -> None:
    spring = impedance(scenario("spring"), 1, measured=False, frequencies=[0.05, 0.1])
    assert spring.attrs["predicted_drag"] == pytest.approx(4 * 50 * 0.025, rel=0.05)
    wave = impedance(scenario({"kind": "wave", "impedance": 4.0}), 1, measured=False, frequencies=[0.05, 0.1])
    assert wave.attrs["predicted_drag"] == pytest.approx(2 * 0.5, rel=0.05)
    assert wave.attrs["predicted_mass"] == pytest.approx(1.0 + 4.0 * 0.025, rel=0.01)
    pressed = impedance(scenario("spring"), 1, others="holding", measured=False, frequencies=[0.05, 0.1])
    assert pressed.attrs["predicted_stiffness"] == pytest.approx(1.0 / (1.0 / 50 + 1.0 / 300), rel=0.01)


def test_what_can_only_be_measured_is_not_asked_for_a_prediction() -> None:
    with pytest.raises(
        UnsupportedError, match='law "paid" is not linear, so what hands feel of it can only be measured'
    ):
        impedance(scenario("paid"), 1, measured=False)
    alone = scenario("paid", network={"users": ["a"], "spring": [[0]], "delay": [[0]]}, hands=[])
    assert impedance(alone, 1, measured=False).attrs["predicted_mass"] == pytest.approx(1.0)
    with pytest.raises(ScenarioError, match='others is "still"; it must be "free" or "holding"'):
        impedance(scenario("spring"), 1, others="still", measured=False)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("channel", [{}, {"jitter": {"scale": 0.02}, "loss": 0.05}])
def test_a_wave_line_is_felt_as_predicted_where_samples_come_unevenly(channel: dict[str, Any]) -> None:
    """Of three users with rates of their own; taken as it came, energy made the drag 26 % larger."""
    network = {"users": ["a", "b", "c"], "spring": [[0, 30, 80], [30, 0, 0], [80, 0, 0]]}
    delay = [[0, 0.01, 0.05], [0.03, 0, 0.02], [0.015, 0.06, 0]]
    table = scenario("wave", network={**network, "delay": delay}, channel=channel, hands=[])
    uneven = table.replace(synchronisation__mode="freshest", steps={"period": [0.001, 0.002, 0.005]})
    found = impedance(uneven, 2, frequencies=[0.2, 0.5]).attrs
    assert found["measured_drag"] == pytest.approx(found["predicted_drag"], rel=0.06)


def test_a_law_that_is_not_linear_is_measured_only() -> None:
    found = impedance(scenario("paid"), 1, frequencies=[0.5, 1.0])
    assert np.isnan(found["predicted_real"].values).all()
    assert abs(found.attrs["measured_drag"]) < 0.1 * 4 * 50 * 0.025
    assert found.attrs["measured_mass"] == pytest.approx(1.0, rel=0.06)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"user": 3}, "user is 3; the network has users 1 to 2"),
        ({"user": 1, "node": 2}, "node is 2; the body has nodes 1 to 1"),
        ({"user": 1, "axis": 1}, "axis is 1; the body has axes 0 to 0"),
        ({"user": 1, "frequencies": [0.0, 1.0]}, "frequencies are .*; they must be finite numbers above 0"),
    ],
)
def test_wrong_questions_are_one_sentence(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ScenarioError, match=message):
        impedance(scenario("spring"), **options)


PULL = np.array([[300.0, 100.0], [100.0, 200.0]])
COUPLED = {
    "mass": np.eye(4).tolist(),
    "rest": [[0.0, 0.0], [0.1, 0.0]],
    "stiffness_int": np.block([[PULL, -PULL], [-PULL, PULL]]).tolist(),
    "damping_int": (0.02 * np.block([[PULL, -PULL], [-PULL, PULL]])).tolist(),
}


@pytest.mark.parametrize("axis", [0, 1])
def test_of_a_body_whose_axes_pull_on_each_other(axis: int) -> None:
    holding = scenario("spring", body=Body(**COUPLED), hands=[{"user": 2, "stiffness": 50}])
    predicted, measured = both(impedance(holding, 1, axis=axis, frequencies=[1.0, 3.0]))
    assert np.abs(measured / predicted - 1.0).max() < 0.03


def test_the_ideal_force_on_such_a_body_has_all_axes() -> None:
    body = {"kind": "matrices", **COUPLED}
    study = Study.make(laws=["spring"], networks=[{"name": "near", "delay": 0.0}], body=body, duration=4.0)
    force = ideal(study, [{"user": 1, "path": [0.01, 0.02], "stiffness": 100.0}]).force
    assert force.shape == (1, 4000, 2)
    assert force[0, 0] == pytest.approx([1.0, 2.0], rel=1e-3)
