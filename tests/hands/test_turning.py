from itertools import pairwise

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.hands.inside import Turner, nearest_to, turned

from cotouch.haptics import back, product, turn_of, vector_of


def test_quaternions_are_those_of_everybody() -> None:
    rng = np.random.default_rng(3)
    for a, b in rng.normal(size=(20, 2, 3)):
        one, two = Rotation.from_rotvec(a), Rotation.from_rotvec(b)
        both = product(turn_of(a), turn_of(b))
        assert Rotation.from_quat(both).as_matrix() == pytest.approx((one * two).as_matrix(), abs=1e-12)
        assert vector_of(both) == pytest.approx((one * two).as_rotvec().tolist(), abs=1e-12)
        assert turned(back(both), np.eye(3)) == pytest.approx((one * two).inv().apply(np.eye(3)), abs=1e-12)
        assert vector_of(nearest_to(one.as_matrix())) == pytest.approx(one.as_rotvec().tolist(), abs=1e-9)


def test_a_turner_goes_the_shortest_way_no_faster_than_it_may() -> None:
    """From nearly half a turn one way to nearly half a turn the other: through the half, not back."""
    turner = Turner()
    turner.put(turn_of([0.0, 0.0, 3.0]))
    goal, seen = turn_of([0.0, 0.0, -3.0]), [turner.turn]
    for _ in range(400):
        turner.move(goal, 0.002, speed=1.0, sharpness=60.0, rush=40.0)
        seen.append(turner.turn)
    steps = np.array([vector_of(product(after, back(before))) for before, after in pairwise(seen)])
    assert np.abs(steps[:, :2]).max() < 1e-12
    assert steps[:, 2].sum() == pytest.approx(2.0 * np.pi - 6.0, abs=1e-3)
    assert (steps[:, 2] >= -1e-6).all()
    assert steps[:, 2].max() == pytest.approx(0.002, rel=1e-6)
