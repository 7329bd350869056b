"""Weight, planes and boxes in scenarios: the batch engine and peers alike, what is refused, and the example."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cotouch.errors import CotouchError
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate

EXAMPLE = Path(__file__).parents[2] / "examples" / "block-between-two-hands.toml"
PAIR = {"users": ["Ann", "Ben"], "spring": [[0, 20], [20, 0]], "delay": [[0, 0.01], [0.01, 0]]}
BLOCK: dict[str, Any] = {"kind": "lattice", "shape": [3, 3, 3], "mass": 0.3, "stiffness": 4000, "spacing": 0.02}
PLANE: dict[str, Any] = {"planes": [{"point": [0, 0, 0], "friction": 0.5}]}
# Far below: what meets nothing moves by the machine code of what does.
FAR: dict[str, Any] = {"planes": [{"point": [0, 0, -1e3]}]}


@pytest.fixture(scope="module")
def lift() -> Any:
    return simulate(Scenario.read(EXAMPLE).replace(record__nodes="all", record__every=10))


def test_two_hands_lift_a_block_off_a_table(lift: Any) -> None:
    lowest, weight = lift["position"].values[..., 2].min(axis=2), 0.3 * 9.81
    end, before = -1, 30  # 0.3 s: it stands
    assert lift["world_force"].values[:, before, 2].sum() == pytest.approx(weight, rel=0.01)
    assert np.abs(lowest[:, before]).max() < 1e-3
    assert (lowest[:, end] > 0.03).all()
    assert np.all(lift["world_force"].values[:, end] == 0.0)
    # Fingers on their tools carry it.
    assert lift["touch_force"].values[:, end, 2].sum() == pytest.approx(-weight, rel=0.05)
    assert int(lift["closure_alarms"].max()) <= 5  # of 3,000 steps: where fingers and floor meet the block
    assert lift.attrs["energy_residual"] <= 1e-12
    assert lift.attrs["passivity_margin"] >= -1e-12 * lift.attrs["energy_in_play"]
    assert (np.diff(lift["world_loss"].values, axis=1) >= 0.0).all()


def test_what_falls_freely_has_its_motion_in_play() -> None:
    """Weight gives just what motion has, so nothing is stored; rounding is beside that motion."""
    alone = {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}
    world = {"gravity": [3, 0, -9.81], **FAR}
    run = simulate({"network": alone, "body": BLOCK, "world": world, "steps": {"duration": 0.5}})
    moving = 0.5 * 0.3 * (3.0**2 + 9.81**2) * 0.5**2
    assert run.attrs["energy_in_play"] == pytest.approx(moving, rel=1e-9)
    assert run.attrs["energy_residual"] <= 1e-13


def falling() -> Scenario:
    return Scenario.make(body=BLOCK, network=PAIR, world={**PLANE, "gravity": [1, 0, -9]}, steps={"duration": 0.1})


@pytest.mark.parametrize("scenario", [falling, lambda: Scenario.read(EXAMPLE)], ids=["it falls", "hands press it"])
def test_peers_come_to_the_same_bits(scenario: Callable[[], Scenario]) -> None:
    ready = prepare(scenario().replace(steps__duration=0.1))
    batch, peers = run_batch(ready), run_peers(ready)
    assert np.array_equal(batch.position, np.stack([places[-1] for places in peers.position]))
    last = [reports[-1] for reports in peers.reports]
    # The last books of every user, behind those of tools, closed steps and losses: energy and force at the plane.
    told = np.array([[report.world_stored, *report.world_force] for report in last])
    assert np.array_equal(batch.record.running[:, -4:], told)
    assert max(abs(report.residual) for reports in peers.reports for report in reports) <= 1e-15


@pytest.mark.parametrize(
    ("world", "said"),
    [
        ({"gravity": [0, 0]}, "world.gravity is [0, 0]; it must have at least 3 entries"),
        ({"planes": [{"normal": [0, 0, 0]}]}, "world.planes[1].normal is [0.0, 0.0, 0.0]; it must be three finite"),
        ({"planes": [{"stiffness": 0}]}, "world.planes[1].stiffness is 0"),
        ({"planes": [{"friction": 0.2, "kinetic_friction": 0.3}]}, "kinetic_friction is 0.3, but friction is 0.2"),
        ({"boxes": [{"size": [0.1, 0, 0.1]}]}, "world.boxes[1].size"),
        ({"boxes": [{"centre": [0, 0, 0]}]}, "world.boxes[1].size is missing"),
        ({"planes": [{}] * 17}, "it must have at most 16 entries"),
        ({"floor": 0}, "world.floor is not an option that cotouch knows"),
        ({"boxes": [{"size": [1, 1, 1]}]}, "world.boxes[1]: the copy of user 1 begins 0.499 m deep in it, more than"),
        (
            {"boxes": [{"size": [1, 1, 0.003], "centre": [0.0, 0.0, 0.02]}]},
            "world.boxes[1]: the copy of user 1 begins 0.0015 m deep in it, more than a quarter of how thick that is",
        ),
        ({"boxes": [{"size": [1, 1, 1e-6], "centre": [0, 0, -1]}]}, "an obstacle is 1e-06 m thin"),
    ],
)
def test_a_wrong_world_is_one_sentence(world: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        prepare(Scenario.make(body=BLOCK, network=PAIR, world=world, steps={"duration": 0.1}))
    assert said in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ({**BLOCK, "gravity": [0, 0, -1]}, "body.gravity is not an option that cotouch knows"),
        ({"kind": "chain", "nodes": 3}, "the body has one axis; weight, obstacles and what turns need 2 or 3"),
        ({"kind": "point", "rest": [0, 0, 0]}, "the body has no skin; obstacles are met by a skin"),
    ],
)
def test_what_a_world_does_not_take_is_told(body: dict[str, Any], said: str) -> None:
    world = {**PLANE, "gravity": [0, 0, -9.81]}
    with pytest.raises(CotouchError) as caught:
        prepare(Scenario.make(body=body, network=PAIR, world=world, steps={"duration": 0.1}))
    assert said in str(caught.value)


def test_tools_touch_what_meets_a_plane_by_a_contact_law() -> None:
    tool = {"user": 1, "at": [-0.02, 0.02, 0.02], "radius": 0.01, "stiffness": 500}
    ready = prepare(Scenario.make(body=BLOCK, network=PAIR, world=PLANE, tools=[tool], steps={"duration": 0.1}))
    assert ready.touching is not None
    assert ready.touching.contact is not None


def test_the_world_is_in_the_file_and_in_the_result() -> None:
    scenario = Scenario.read(EXAMPLE)
    again = Scenario.from_toml(scenario.to_toml())
    assert again.world == scenario.world
    assert '"planes"' in simulate(falling()).attrs["scenario"]
