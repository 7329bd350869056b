"""A body whose nodes are doubled along faces is the body that it was, until something is cut."""

import numpy as np
import numpy.typing as npt
import pytest
import scipy.sparse as sp
from scipy.sparse.linalg import eigsh, spsolve
from tests.mechanics.materials import made

from cotouch.body import Body, Placed, body_from_surface, cut_skin, pulls_of, together, with_faces
from cotouch.errors import BodyError

Float = npt.NDArray[np.float64]


def doubled(name: str) -> tuple[Body, Body, sp.csr_array]:
    """A body, the same with faces, and which node of the one each of the other was."""
    body = made(name, viscosity=1e-3, shape=(7, 3, 3), ground="x-", hold=2e4).with_cutting()
    faced = with_faces(body)
    near: npt.NDArray[np.int64] = np.argmin(((faced.rest[:, None] - body.rest[None]) ** 2).sum(axis=2), axis=1)
    assert np.array_equal(faced.rest, body.rest[near])
    assert np.array_equal(near[: body.nodes], np.arange(body.nodes))  # numbers in files stay
    was = sp.csr_array((np.ones(near.size), (np.arange(near.size), near)), shape=(near.size, body.nodes))
    axes = 1 if body.form == "node" else 3
    return body, faced, sp.csr_array(sp.kron(was, sp.eye_array(axes)))


@pytest.mark.parametrize("name", ["cells", "neo-hookean"])
def test_it_behaves_as_before(name: str) -> None:
    body, faced, was = doubled(name)
    for matrix in ("mass", "stiffness", "stiffness_ext"):  # with what was one node moving as one
        before, after = getattr(body, matrix).toarray(), (was.T @ getattr(faced, matrix) @ was).toarray()
        assert np.abs(after - before).max() <= 1e-12 * np.abs(before).max()
    assert was.T @ np.repeat(pulls_of(faced), was.shape[0] // faced.nodes) == pytest.approx(1.0)
    few = [
        np.sqrt(np.sort(eigsh(one.stiffness, 6, one.mass, sigma=0.0, return_eigenvectors=False)))
        for one in (body, faced)
    ]
    assert np.abs(few[1] / few[0] - 1.0).max() < 0.01
    assert (few[1] < few[0]).all()  # it is softer, by what the ties yield
    load = np.zeros(body.mass.shape[0])
    load[-1] = 1.0  # a corner of the free end, and how far it gives way
    shared = np.repeat(pulls_of(faced), was.shape[0] // faced.nodes) * (was @ load)
    before = load @ spsolve(body.stiffness, load)
    after = shared @ spsolve(faced.stiffness, shared)
    assert 1.0 < after / before < 1.01


@pytest.mark.parametrize("name", ["cells", "corotated"])
def test_a_cut_around_opens_two_walls(name: str) -> None:
    _, faced, _ = doubled(name)
    faces, material = cut_skin(faced), faced.material
    assert faces is not None
    assert material is not None
    whole = faces.shown(np.zeros(faced.cut_count, dtype=np.bool_))
    assert np.array_equal(whole, faces.beyond < 0)
    middle = faced.rest[material.elements].mean(axis=1)[:, 0] > 0.03
    between = middle[material.sides[:, 0]] != middle[material.sides[:, 1]]
    shown = faces.shown(between)
    opened = shown & ~whole
    corners = faces.skin.vertices[faces.skin.triangles]
    normal = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert np.abs(corners[opened, :, 0] - 0.03).max() < 1e-12
    for sign in (1.0, -1.0):  # each half has a wall that looks at the other's
        own = opened & (normal[:, 0] * sign > 0.0)
        assert np.abs(normal[own]).sum() == pytest.approx(4e-4)
        carried = faces.skin.nodes[np.unique(faces.skin.triangles[own])][:, 0]
        half = np.unique(material.elements[middle == (sign < 0.0)])
        assert np.isin(carried, half).all()
    assert np.abs(normal[shown].sum(axis=0)).max() < 1e-15
    ends = material.elements[middle], material.elements[~middle]
    assert not set(ends[0].ravel().tolist()) & set(ends[1].ravel().tolist())  # nothing holds them but ties


def test_a_skin_that_runs_through_cubes_is_divided_between_them() -> None:
    points = 0.05 * np.concatenate([np.eye(3), -np.eye(3)])
    sides = [(a, b, c) for a in (0, 3) for b in (1, 4) for c in (2, 5)]
    turned = [s if np.linalg.det(points[list(s)]) > 0.0 else s[::-1] for s in sides]
    body = body_from_surface((points, turned), unit="m", resolution=5, model="cells").with_cutting()
    faced = with_faces(body)
    skin, was, material = faced.skin, body.skin, faced.material
    assert skin is not None
    assert was is not None
    assert material is not None
    measured = [
        (np.einsum("ta,ta->", c[:, 0], n) / 6.0, np.linalg.norm(n, axis=1).sum() / 2.0)
        for one in (was, skin)
        for c in [one.vertices[one.triangles]]
        for n in [np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])]
    ]
    assert measured[1] == pytest.approx(measured[0], rel=1e-12)
    assert skin.triangles.shape[0] > 5 * len(sides)
    # Every triangle hangs on one cube, and follows it: also a shear of the whole, which trilinear weights reproduce.
    owner = np.full(faced.nodes, -1)
    owner[material.elements] = np.arange(material.elements.shape[0])[:, None]
    carried = owner[skin.nodes[skin.triangles]].reshape(skin.triangles.shape[0], -1)
    assert (carried == carried[:, :1]).all()
    shear = np.array([[0.0, 0.2, 0.0], [0.0, 0.0, -0.1], [0.3, 0.0, 0.0]])
    assert skin.carried(faced.rest @ shear) == pytest.approx(skin.vertices @ shear, abs=1e-15)


def test_several_are_doubled_each_by_itself() -> None:
    low, high = made("cells", shape=(3, 3, 2)), made("rigid")
    pair = together([Placed(body=low, name="low"), Placed(body=high, name="high", at=(0.0, 0.0, 0.1))])
    faced = with_faces(pair.with_cutting())
    alone = with_faces(low.with_cutting())
    assert faced.nodes == alone.nodes + 4
    assert faced.cut_count == alone.cut_count == 4
    assert [part.first for part in faced.parts] == [0, alone.nodes]


def test_what_has_no_faces_is_told() -> None:
    with pytest.raises(BodyError, match='faces is true, but model is "spring-network", whose elements have none'):
        with_faces(made("spring-network").with_cutting())
