"""What is said of bodies that turn otherwise than the solid would, or where they should not."""

import numpy as np
import pytest
from tests.body.inside import inertia_excess
from tests.body.shapes import block, box, sphere

from cotouch.body import body_from_surface, body_from_tetrahedra

CORNERS = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
# A second tetrahedron at a point, an edge and a face of the first.
AT_POINT = ([*CORNERS, [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]], [[0, 1, 2, 3], [0, 5, 4, 6]])
AT_EDGE = ([*CORNERS, [0.3, -1.0, 0.0], [0.3, -1.0, -1.0]], [[0, 1, 2, 3], [0, 1, 5, 4]])
AT_FACE = ([*CORNERS, [0.0, 0.0, -1.0]], [[0, 1, 2, 3], [0, 2, 1, 4]])


@pytest.mark.parametrize(("mesh", "free"), [(AT_POINT, 3), (AT_EDGE, 1), (AT_FACE, 0)], ids=["point", "edge", "face"])
def test_tetrahedra_that_turn_against_each_other_are_told(mesh: tuple[object, object], free: int) -> None:
    body = body_from_tetrahedra(mesh, unit="m")  # type: ignore[arg-type]
    told = [note for note in body.origin.notes if "turn against each other" in note]
    assert len(told) == (free > 0)
    values = np.linalg.eigvalsh(body.stiffness.toarray())
    assert np.count_nonzero(values < 1e-9 * values.max()) == 6 + free


def test_a_face_that_is_no_plane_is_held_by_a_layer() -> None:
    points, elements = block((6, 4, 4), shake=0.8)
    rolled = np.array(points)
    rolled[:, 2] += 0.5 * (rolled[:, 0] - 0.15) ** 2 + 0.4 * (rolled[:, 1] - 0.05) ** 2  # one node is lowest
    body = body_from_tetrahedra((rolled, elements), unit="m", ground="z-", ground_stiffness=100.0)
    assert body.origin.held.size >= 3
    assert body.origin.free == 0
    assert any('The face "z-" is not flat' in note for note in body.origin.notes)
    flat = body_from_tetrahedra((points, elements), unit="m", ground="x-", ground_stiffness=100.0)
    assert not any("is not flat" in note for note in flat.origin.notes)


def test_moments_of_inertia_beside_closed_forms() -> None:
    """Masses at the corners of a cube: (1/2) a² each, where the cube has a²/6."""
    points, faces = (np.array(part) for part in box())
    assert inertia_excess(points, faces, points, np.ones(8)) == pytest.approx(2.0)
    grid = np.stack(np.meshgrid(*[(np.arange(20) + 0.5) / 20] * 3), axis=-1).reshape(-1, 3)
    assert inertia_excess(points, faces, grid, np.ones(8000)) == pytest.approx(-1.0 / 400.0)


def test_a_lattice_says_by_how_much_its_inertia_is_too_large() -> None:
    told = {}
    for resolution in (4, 12, 40):
        notes = body_from_surface(sphere(), unit="m", resolution=resolution).origin.notes
        told[resolution] = [note for note in notes if "moments of inertia" in note]
    assert "are up to" in told[4][0]
    assert "above the solid's" in told[4][0]
    assert not told[40], told
