"""What a hand does in a step: a spring to its path, or a force, while it holds; and nothing else."""

import numpy as np
import pytest

from cotouch.body import point
from cotouch.interaction import Hands, grip
from cotouch.mechanics import Ports, idle_ports, model
from cotouch.scenario import HandTable, ports_of


def held(**changed: object) -> tuple[Hands, Ports]:
    """A point's only hand, from 0 to 0.1 m in half a second, and its port."""
    table = {"user": 1, "path": [[0, 0], [0.5, 0.1]], "stiffness": 60.0, "damping": 2.0, "begin": 0.1, "release": 0.4}
    body = point()
    ready = model(body)
    hands, _ = ports_of([HandTable.model_validate(table | changed)], 1, body, ready)
    return hands, idle_ports(hands.row, hands.shape, ready.width)


def step(hands: Hands, ports: Ports, end: float, T: float = 0.01) -> None:
    grip(hands, ports, np.zeros(1, dtype=np.int32), 0, end, T, model(point()).lanes)


def test_a_hand_is_a_spring_and_damper_to_where_its_path_is_from_begin_to_end_of_the_step() -> None:
    hands, ports = held()
    step(hands, ports, 0.3)
    assert (ports.stiffness[0], ports.damping[0]) == (60.0, 2.0)
    assert (ports.start[0, 0], ports.end[0, 0]) == pytest.approx((0.058, 0.06), abs=1e-15)
    assert ports.push[0, 0] == 0.0


def test_a_force_pushes_as_much_as_its_path_says_in_the_middle_of_the_step() -> None:
    hands, ports = held(kind="force")
    step(hands, ports, 0.3)
    assert ports.push[0, 0] == pytest.approx(0.059, abs=1e-15)
    assert (ports.stiffness[0], ports.damping[0]) == (0.0, 0.0)


@pytest.mark.parametrize(("end", "holds"), [(0.10, False), (0.11, True), (0.40, True), (0.41, False)])
def test_it_holds_where_the_middle_of_the_step_is_within_its_time(end: float, holds: bool) -> None:
    hands, ports = held()
    step(hands, ports, 0.3)  # what it did before is forgotten
    step(hands, ports, end)
    assert (ports.stiffness[0] > 0.0) == holds
    assert np.any(ports.end) == holds
