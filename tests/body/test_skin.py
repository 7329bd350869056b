"""A skin follows its nodes, and forces on it do the same work at the nodes."""

import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.body import Body, Skin, chain
from cotouch.errors import BodyError


def random_skin(seed: int, vertices: int, width: int, nodes: int) -> Skin:
    rng = np.random.default_rng(seed)
    return Skin(
        vertices=rng.normal(size=(vertices, 3)),
        triangles=rng.integers(0, vertices, size=(4, 3)),
        nodes=rng.integers(0, nodes, size=(vertices, width)),
        weights=rng.dirichlet(np.ones(width), size=vertices),
    )


skins = st.builds(random_skin, st.integers(0, 1000), st.integers(1, 20), st.integers(1, 8), st.just(9))


@given(skins, st.integers(0, 1000))
def test_forces_do_the_same_work_at_the_nodes(skin: Skin, seed: int):
    rng = np.random.default_rng(seed)
    move, force = rng.normal(size=(9, 3)), rng.normal(size=skin.vertices.shape)
    at_skin = np.sum(force * skin.carried(move))
    at_nodes = np.sum(skin.spread(force, 9) * move)
    assert at_skin == pytest.approx(at_nodes, abs=1e-12 * (1.0 + np.abs(force).sum()))
    assert np.allclose(skin.spread(force, 9).sum(axis=0), force.sum(axis=0))


@given(skins, st.lists(st.floats(-1e3, 1e3), min_size=3, max_size=3))
def test_a_shift_of_the_body_shifts_the_skin(skin: Skin, shift: list[float]):
    assert np.allclose(skin.carried(np.tile(shift, (9, 1))), shift, rtol=1e-12, atol=1e-9)


@given(skins)
def test_pattern_is_the_interpolation(skin: Skin):
    pointer, columns, values = skin.pattern
    assert pointer.dtype == columns.dtype == np.int32
    dense = np.zeros((skin.vertices.shape[0], 9))
    for vertex, (names, fractions) in enumerate(zip(skin.nodes, skin.weights, strict=True)):
        for node, fraction in zip(names, fractions, strict=True):
            dense[vertex, node] += fraction
    assert np.allclose(skin.interpolation(9).toarray(), dense)
    assert pointer[-1] == columns.size == values.size


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"weights": [[0.5, 0.4], [0.5, 0.5]]}, "the weights of skin vertex 0 sum to 0.9; they must sum to 1"),
        ({"weights": [[0.5, np.nan], [0.5, 0.5]]}, "the weights of skin vertex 0 sum to nan"),
        ({"weights": [[1.0], [1.0]]}, "skin nodes are 2 x 2 and skin weights 2 x 1; both must be 2 x k"),
        ({"nodes": [[0, 1]], "weights": [[0.5, 0.5]]}, "both must be 2 x k"),
        ({"nodes": np.zeros((2, 9)), "weights": np.full((2, 9), 1 / 9)}, "k from 1 to 8"),
        ({"triangles": [[0, 1, 2]]}, "a skin triangle names vertex 2; this skin has vertices 0 to 1"),
        ({"triangles": [[0, 1, -1]]}, "a skin triangle names vertex -1"),
        ({"triangles": [[0, 1]]}, "skin triangles are 1 x 2; they must be rows of 3"),
        ({"triangles": [[0, 1, 0.5]]}, "skin triangles must be whole numbers"),
        (
            {"vertices": [[0, 0, 0], [0, np.inf, 0]]},
            "skin vertex 1 is [0.0, inf, 0.0]; every coordinate must be a finite",
        ),
        ({"vertices": "here"}, "skin vertices are not an array of numbers"),
    ],
)
def test_refused(change: dict[str, Any], message: str):
    good: dict[str, Any] = {
        "vertices": np.zeros((2, 3)),
        "triangles": [[0, 1, 0]],
        "nodes": [[0, 1], [1, 1]],
        "weights": [[0.5, 0.5], [1.0, 0.0]],
    }
    Skin(**good)
    with pytest.raises(BodyError, match=re.escape(message)):
        Skin(**{**good, **change})


def test_a_body_refuses_a_skin_that_does_not_fit():
    skin = Skin(vertices=np.zeros((1, 3)), triangles=[], nodes=[[4]], weights=[[1.0]])
    with pytest.raises(BodyError, match="the skin hangs on node index 4; this body has nodes 0 to 2"):
        Body(mass=np.eye(3), rest=np.zeros((3, 3)), skin=skin)
    with pytest.raises(BodyError, match="the body has 1 axes; a skin needs 3"):
        Body(mass=np.eye(3), rest=np.zeros(3), skin=skin)


def test_a_body_keeps_its_skin_when_it_becomes_full():
    body = chain(5, dimension=3)
    skin = Skin(vertices=np.zeros((1, 3)), triangles=[], nodes=[[4]], weights=[[1.0]])
    dressed = Body(mass=body.mass, rest=body.rest, skin=skin)
    assert dressed.as_full().skin is skin
    assert body.skin is None
