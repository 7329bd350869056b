import numpy as np
import pytest

from cotouch.session import demo_session
from cotouch.session._cushion import HALF, THICK, cushion, stl


def test_it_is_one_closed_surface_of_some_2000_vertices() -> None:
    points, corners = cushion()
    assert points.shape == (1962, 3)
    sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    there, back = {(a, b) for a, b in sides.tolist()}, {(b, a) for a, b in sides.tolist()}
    assert there == back  # every edge once each way
    assert len(there) == len(sides)
    assert len(points) - len(sides) // 2 + len(corners) == 2
    a, b, c = (points[corners[:, k]] for k in range(3))
    volume = float((np.cross(a, b) * c).sum() / 6.0)
    assert 0.4 < volume / (8 * HALF * HALF * THICK) < 0.8  # outside is outside
    assert np.ptp(points, axis=0) == pytest.approx([2.03 * HALF, 2.03 * HALF, 1.67 * THICK], rel=0.02)


def test_its_file_is_read_as_it_is() -> None:
    points, corners = cushion()
    assert len(stl(points, corners)) == 84 + 50 * len(corners)
    session = demo_session(body="soft", seconds=None)
    assert session.files == {"cushion.stl": stl(points, corners)}
    assert demo_session(body="soft", seconds=None).digest == session.digest
    assert all(hand.release is None and hand.frequency > 0.0 for hand in session.scenario.hands)
    delays = [float(session.scenario.network.delay[a, b]) for a, b in session.scenario.network.links]
    assert max(delays) < 0.5
