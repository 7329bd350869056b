import numpy as np
import pytest

from cotouch.members import SessionFile
from cotouch.session import demo_session

HALF, THICK = 0.12, 0.05  # half its width and half its height [m]
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


@pytest.fixture(scope="module")
def session() -> SessionFile:
    return demo_session(body="soft", seconds=None)


def test_it_is_one_closed_surface_of_some_2000_vertices(session: SessionFile) -> None:
    stl = session.files["cushion.stl"]
    triangles = np.frombuffer(stl, TRIANGLE, offset=84)
    assert int.from_bytes(stl[80:84], "little") == len(triangles)
    points, corners = np.unique(triangles["corners"].reshape(-1, 3).astype(float), axis=0, return_inverse=True)
    corners = corners.reshape(-1, 3)
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


def test_its_hands_move_it_for_ever_over_paths_that_are_short_enough(session: SessionFile) -> None:
    assert list(session.files) == ["cushion.stl"]
    assert demo_session(body="soft", seconds=None).digest == session.digest
    assert all(hand.release is None and hand.frequency > 0.0 for hand in session.scenario.hands)
    delays = [float(session.scenario.network.delay[a, b]) for a, b in session.scenario.network.links]
    assert max(delays) < 0.5
