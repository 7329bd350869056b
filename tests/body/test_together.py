"""Several bodies as one: what it is made of, where its parts are, and what is refused."""

from typing import Any

import numpy as np
import pytest

from cotouch.body import Body, Placed, body_from_tetrahedra, chain, lattice, point, rigid_box, together
from cotouch.errors import CotouchError

BLOCK = lattice((2, 3, 2), mass=0.6, stiffness=100.0, spacing=0.02, model="cells")


def solid() -> Body:
    places = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]])
    return body_from_tetrahedra((places, np.array([[0, 1, 2, 3]])), unit="m", young=1e4, poisson=0.2)


def test_is_made_of_what_its_parts_are() -> None:
    turn = (0.0, 0.0, 0.5 * np.pi)
    both = together([Placed(body=BLOCK, name="a"), Placed(body=solid(), name="b", at=(1.0, 2.0, 3.0), turn=turn)])
    assert both.nodes == 16
    assert both.form == "full"
    first, second = both.parts
    assert np.array_equal(both.rest[: first.last], BLOCK.rest)
    assert 0.5 * (second.rest().min(axis=0) + second.rest().max(axis=0)) == pytest.approx([1.0, 2.0, 3.0])
    # x became y.
    assert second.rest()[1] - second.rest()[0] == pytest.approx([0.0, 0.1, 0.0])
    assert both.mass.sum() == pytest.approx(BLOCK.mass.sum() * 3 + second.body.mass.sum())
    assert both.stiffness_int[:36, 36:].nnz == 0
    assert both.skin is not None
    vertices = both.skin.vertices + both.skin.carried(np.zeros((16, 3)))
    assert vertices[: first.skin().vertices.shape[0]] == pytest.approx(first.skin().vertices)
    # A stretch along the second's own x costs what it did, now along y.
    own, moved = np.zeros((4, 3)), np.zeros((16, 3))
    own[1, 0] = moved[13, 1] = 1e-3
    stiff = second.body.stiffness_int
    expected = own.ravel() @ (stiff @ own.ravel())
    assert moved.ravel() @ (both.stiffness_int @ moved.ravel()) == pytest.approx(expected)


def test_what_holds_a_rigid_one_is_its_own() -> None:
    die = rigid_box([0.02, 0.02, 0.02], mass=0.01, resolution=1)
    pair = together([Placed(body=die, name="low"), Placed(body=die, name="high", at=(0.0, 0.0, 0.02))])
    shares, vertices = pair.held_shares, die.skin.vertices.shape[0] if die.skin is not None else 0
    assert shares is not None
    assert pair.rigid
    assert shares.sum(axis=1) == pytest.approx(1.0)
    own = pair.held_by(1)
    assert own[:4].tolist() == [4, 5, 6, 7]
    assert own.size == 4 + vertices
    assert np.abs(shares[own][:, :4]).max() == 0.0
    assert shares @ pair.rest == pytest.approx(pair.held_rest)
    placed = pair.with_places([[0.01, 0.0, 0.025]])
    assert placed.held_by(1)[-1] == placed.holds - 1


@pytest.mark.parametrize(
    ("bodies", "said"),
    [
        ([], "there are no bodies; give at least one"),
        ([("a", BLOCK), ("a", solid())], 'two bodies are named "a"; each needs a different name'),
        ([("", BLOCK)], "a body has an empty name; each needs a different name"),
        ([("p", point())], 'body "p" has 1 axes; bodies meet by their skins, so take it from a mesh or a lattice'),
        ([("p", chain(3, dimension=3))], 'body "p" has no skin; bodies meet by their skins'),
        ([("s", lattice((3, 3, 1)))], 'body "s" is a sheet of one layer, which has no inside; bodies and meshes meet'),
        ([("m", lattice((3, 3, 3), ground="z-", ground_stiffness=1.0).truncated(modes=3))], 'body "m" is truncated'),
        (
            [("t", together([Placed(body=BLOCK, name="a")]))],
            'body "t" consists of several bodies; list them one by one',
        ),
    ],
)
def test_what_is_no_set_of_bodies_is_one_sentence(bodies: list[tuple[str, Body]], said: str) -> None:
    with pytest.raises(CotouchError) as caught:
        together([Placed(body=body, name=name) for name, body in bodies])
    assert said in str(caught.value)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (
            {"at": (0.0, np.nan, 0.0)},
            r'^at of body "a" is \[0.0, nan, 0.0\]; it must be three finite numbers of at most',
        ),
        ({"at": (0.0, 1e300, 0.0)}, "at most .* m, a million times its size$"),
        ({"turn": (0.0, 0.0, 1e300)}, r'^turn of body "a" is .*; it must be three finite numbers of at most 100 rad$'),
    ],
)
def test_a_place_is_three_numbers_within_reason(options: dict[str, Any], said: str) -> None:
    with pytest.raises(CotouchError, match=said):
        together([Placed(body=BLOCK, name="a", **options)])
