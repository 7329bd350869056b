"""What a recording keeps of a body with a material: enough to make it again."""

import numpy as np
import pytest
from tests.recording.inside import RecordedMaterial

from cotouch.body import Placed, lattice, rigid_box, together
from cotouch.mechanics import Between, Obstacle, Plane, Solid, model


@pytest.mark.parametrize("own", [False, True])
def test_what_a_body_does_to_itself_is_kept(own: bool) -> None:
    block = lattice((3, 3, 2), model="cells", stiffness=50.0, spacing=0.01)
    between = Between(stiffness=2e7, loss=4.0, friction=0.3, kinetic=0.2, own=own)
    body = together([Placed(body=block, name="left"), Placed(body=block, name="right", at=(0.1, 0.0, 0.0))])
    kept = RecordedMaterial.of(model(body, between=between))
    again = RecordedMaterial.of_arrays(kept.arrays(), body.rest)
    assert again is not None
    assert again.between == between
    assert again.same(kept)
    assert np.array_equal(again.body.rest, body.rest)


def test_meshes_that_stood_still_are_kept() -> None:
    die = rigid_box([0.1, 0.1, 0.1], resolution=1)
    assert die.skin is not None
    floor = Obstacle(shape=Solid(2.0 * die.skin.vertices - [0.0, 0.0, 0.2], die.skin.triangles), friction=0.5, loss=3.0)
    plane = Obstacle(shape=Plane((0.0, 0.0, -1.0)))
    body = together([Placed(body=die, name="one")]).with_gravity((0.0, 0.0, -9.81))
    kept = RecordedMaterial.of(model(body, obstacles=[plane, floor]))
    again = RecordedMaterial.of_arrays(kept.arrays(), body.rest)
    assert again is not None
    assert again.same(kept)
    first, second = again.obstacles()
    assert first.shape == plane.shape
    assert isinstance(second.shape, Solid)
    assert isinstance(floor.shape, Solid)
    assert np.array_equal(second.shape.vertices, floor.shape.vertices)
    assert (second.friction, second.loss) == (0.5, 3.0)
    assert again.firmness() == pytest.approx(2e7 * 0.06)
