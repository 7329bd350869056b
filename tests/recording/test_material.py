"""What a recording keeps of a body with a material: enough to make it again."""

import numpy as np
import pytest

from cotouch.body import Placed, lattice, together
from cotouch.mechanics import Between, model
from cotouch.recording._material import RecordedMaterial


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
