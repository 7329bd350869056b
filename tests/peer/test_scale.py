"""A share of a body that has weight: getting lighter below and heavier above is no source of energy."""

import numpy as np
import pytest

from cotouch.body import lattice
from cotouch.mechanics import State, model
from cotouch.peer._scale import CopyScale


def still() -> tuple[CopyScale, State]:
    ready = model(lattice((2, 2, 2)).with_gravity((0.0, 0.0, -9.81)), basis="nodal")
    rows = [np.zeros((ready.operator_rows, ready.width)) for _ in range(4)]
    return CopyScale(ready.operator), State(*rows, np.zeros(ready.memory))


def test_what_got_lighter_below_pays_to_get_heavier_above() -> None:
    """A body of 1 J a metre: it sinks by one, a newcomer takes half, hands lift it by one, the newcomer leaves."""
    scale, state = still()
    assert scale.rescale(2, state, 0.0, -1.0) == 0.5
    assert scale.rescale(1, state, 0.0, 0.0) == 0.0
    assert scale.rise(state, 0.0) == 0.0
    assert (scale.stiffness, scale.operator.firmness) == (0.5, 0.5)  # with the mass of one, the weight of a half
    scale.tank = 0.25
    assert scale.rise(state, 0.0) == 0.0
    assert scale.stiffness == 0.75
    scale.tank = 0.25
    assert scale.rise(state, 0.0) == 0.0
    assert (scale.stiffness, scale.rising, scale.tank) == (1.0, False, 0.0)


def test_what_is_put_down_gets_heavier_for_nothing() -> None:
    scale, state = still()
    scale.rescale(2, state, 0.0, -1.0)
    scale.rescale(1, state, 0.0, -0.5)
    assert scale.rise(state, -0.5) == -0.5
    assert scale.stiffness == 1.0


def test_what_hangs_above_where_it_began_pays_as_a_spring_does() -> None:
    scale, state = still()
    assert scale.rescale(2, state, 0.0, 1.0) == -0.5
    scale.rescale(1, state, 0.0, 0.5)
    scale.tank = 0.1
    assert scale.rise(state, 0.5) == pytest.approx(0.1)
    assert scale.stiffness == pytest.approx(0.6)
