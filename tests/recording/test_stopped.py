"""Which nodes lose their last element in which step."""

import numpy as np
import pytest
from tests.recording.inside import stopped_rows

from cotouch.body import Body, Placed, lattice, rigid_box, together, with_faces


def cells() -> Body:
    return lattice((4, 3, 3), spacing=0.01, stiffness=100.0, mass=0.1, model="cells").with_cutting()


def several() -> Body:
    """Two that are cut, beside one whose faces open and one that cannot be cut."""
    die = rigid_box((0.02, 0.02, 0.02), density=1000.0)
    bodies = (cells(), die, with_faces(cells()), cells())
    return together([Placed(body=one, name=f"{n}", at=(0.1 * n, 0.0, 0.0)) for n, one in enumerate(bodies)])


@pytest.mark.parametrize("body", [cells(), several()], ids=["one", "several"])
def test_a_node_stops_with_its_last_element_and_again_with_every_cut(body: Body) -> None:
    """What a closure gave it since then is lost as well; between cuts nobody stops."""
    parts = [(part.body, part.first) for part in body.parts] or [(body, 0)]
    rng, index = np.random.default_rng(1), np.arange(9.0)
    when = rng.choice([2.0, 3.0, 6.0, np.inf], body.cut_count, p=[0.4, 0.3, 0.2, 0.1])
    expected, count = np.zeros((index.size, body.nodes), dtype=bool), 0
    for own, first in parts:
        if own.cut_count and own.material is not None and not own.material.faces.size:
            cut = when[count : count + own.cut_count]
            for node in range(own.nodes):
                last = cut[(own.material.elements == node).any(axis=1)].max()
                expected[[2, 3, 6], first + node] = [last <= step for step in (2, 3, 6)]
        count += own.cut_count
    assert expected[2].sum() < expected[3].sum() < expected[6].sum()
    found = stopped_rows(body, when, index)
    assert found is not None
    assert np.array_equal(found, expected)
    assert stopped_rows(body, when, index[4:6]) is None


def test_where_faces_open_every_node_keeps_its_element() -> None:
    body = with_faces(cells())
    assert stopped_rows(body, np.full(body.cut_count, 2.0), np.arange(9.0)) is None
