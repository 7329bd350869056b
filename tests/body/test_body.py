"""The two forms of a body's matrices, and products with them."""

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st

from cotouch.body import Body, lattice, point

MATRICES = ("mass", "damping_int", "damping_ext", "stiffness_int", "stiffness_ext")


def random_body(seed: int, nodes: int, dimension: int, full: bool) -> tuple[Body, dict[str, np.ndarray]]:
    """A body, and its matrices as they were given."""
    rng = np.random.default_rng(seed)
    size = nodes * dimension if full else nodes

    def semidefinite() -> np.ndarray:
        half = rng.normal(size=(size, size))
        return half @ half.T

    given_ = {
        "mass": semidefinite() + np.eye(size),
        "damping_int": semidefinite(),
        "damping_ext": np.diag(rng.uniform(size=size)),
        "stiffness_int": semidefinite(),
        "stiffness_ext": np.diag(rng.uniform(size=size)),
    }
    return Body(rest=rng.normal(size=(nodes, dimension)), **given_), given_


bodies = st.builds(
    random_body, st.integers(0, 10_000), nodes=st.integers(1, 5), dimension=st.integers(1, 3), full=st.booleans()
)


@given(bodies)
def test_keeps_what_was_given(made: tuple[Body, dict[str, np.ndarray]]):
    body, matrices = made
    for name in MATRICES:
        assert np.allclose(getattr(body, name).toarray(), matrices[name], rtol=1e-15, atol=0.0)
    assert np.allclose(body.damping.toarray(), matrices["damping_int"] + matrices["damping_ext"], rtol=1e-15)
    assert np.allclose(body.stiffness.toarray(), matrices["stiffness_int"] + matrices["stiffness_ext"], rtol=1e-15)


@given(bodies)
def test_full_form_is_the_kronecker_product_with_the_identity(made: tuple[Body, dict[str, np.ndarray]]):
    body, matrices = made
    full = body.as_full()
    for name in MATRICES:
        wide = matrices[name] if body.form == "full" else np.kron(matrices[name], np.eye(body.dimension))
        assert np.allclose(getattr(full, name).toarray(), wide, rtol=1e-15, atol=0.0)
    assert np.array_equal(full.rest, body.rest)
    assert full.form == ("node" if body.dimension == 1 else "full")


@given(bodies, st.lists(st.integers(1, 3), max_size=2), st.integers(0, 10_000))
def test_apply_is_the_product_on_the_flattened_field(
    made: tuple[Body, dict[str, np.ndarray]], batch: list[int], seed: int
):
    body, _ = made
    field = np.random.default_rng(seed).normal(size=(*batch, body.nodes, body.dimension))
    dense = body.as_full().stiffness.toarray()
    for index in np.ndindex(*batch):
        expected = (dense @ field[index].ravel()).reshape(body.nodes, body.dimension)
        assert np.allclose(body.apply(body.stiffness, field)[index], expected, rtol=1e-12, atol=1e-12)
    assert body.apply(body.stiffness, field).shape == field.shape


def test_sizes_and_form():
    body = Body(mass=np.eye(4), rest=np.zeros((4, 3)))
    assert (body.nodes, body.dimension, body.form) == (4, 3, "node")
    assert body.damping.shape == body.stiffness.shape == (4, 4)
    body = Body(mass=np.eye(12), rest=np.zeros((4, 3)))
    assert (body.nodes, body.dimension, body.form) == (4, 3, "full")
    assert body.damping.shape == body.stiffness.shape == (12, 12)


def test_one_full_matrix_makes_all_full():
    spring = np.array([[5.0, -5.0], [-5.0, 5.0]])
    only_x = np.diag([1.0, 0.0, 0.0, 0.0])
    body = Body(mass=2.0 * np.eye(2), rest=np.zeros((2, 2)), stiffness_int=spring, stiffness_ext=only_x)
    assert body.form == "full"
    assert np.array_equal(body.mass.toarray(), 2.0 * np.eye(4))
    assert np.array_equal(body.stiffness.toarray(), np.kron(spring, np.eye(2)) + only_x)
    assert body.damping.shape == (4, 4)


def test_full_form_orders_rows_node_by_node():
    body = Body(mass=np.eye(6), rest=np.zeros((2, 3)), stiffness_ext=np.diag([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))
    assert np.array_equal(body.apply(body.stiffness, np.ones((2, 3))), [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])


def test_as_full_of_a_full_body_is_itself():
    body = lattice((2, 2)).as_full()
    assert body.as_full() is body


def test_apply_does_not_change_the_field():
    body, field = lattice((2, 2)), np.ones((4, 2))
    body.apply(body.mass, field)[:] = 7.0
    assert np.array_equal(field, np.ones((4, 2)))


def test_a_body_is_frozen():
    body = point()
    with pytest.raises(AttributeError):
        body.mass = sp.eye_array(1)  # pyright: ignore[reportAttributeAccessIssue]
    with pytest.raises(TypeError):
        Body([[1.0]], [0.0])  # pyright: ignore[reportCallIssue]
