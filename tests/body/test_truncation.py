"""Modes and static residuals against dense linear algebra."""

import re
from typing import Any

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import eigh
from tests.body.inside import dissect
from tests.body.shapes import block, box, sphere

from cotouch.body import Body, body_from_surface, body_from_tetrahedra, chain, lattice, lowest_modes
from cotouch.errors import BodyError, UnsupportedError

BEAM: dict[str, Any] = {"unit": "m", "young": 1e5, "rayleigh_mass": 0.5, "rayleigh_stiffness": 1e-3}


def beam(**options: Any) -> Body:
    return body_from_tetrahedra(block((4, 2, 2)), **{**BEAM, **options})


def held() -> Body:
    return beam(ground="x-", ground_stiffness=1e4)


def dense_compliance(body: Body, nodes: list[int]) -> np.ndarray:
    """Static compliance among nodes without rigid motions: a sum over all other modes."""
    values, shapes = eigh(body.stiffness.toarray(), body.mass.toarray())
    bends = values > 1e-9 * values.max()
    axes = body.mass.shape[0] // body.nodes
    read = shapes[(np.array(nodes)[:, None] * axes + np.arange(axes)).ravel()][:, bends]
    return (read / values[bends]) @ read.T


@pytest.mark.parametrize("free", [True, False])
def test_sparse_modes_are_the_dense_ones(free: bool, monkeypatch: pytest.MonkeyPatch):
    body = body_from_surface(
        sphere(2), unit="m", resolution=8, model="elastic", ground="none" if free else "z-", ground_stiffness=1e4
    )
    assert body.mass.shape[0] > 1000
    values, shapes = lowest_modes(body.mass, body.stiffness, body.rest, 15)
    exact = eigh(body.stiffness.toarray(), body.mass.toarray(), eigvals_only=True)[:15]
    assert np.allclose(values, exact, rtol=1e-8, atol=1e-6)
    assert np.count_nonzero(values == 0.0) == (6 if free else 0)
    assert np.allclose(shapes.T @ (body.mass @ shapes), np.eye(15), atol=1e-9)
    again = lowest_modes(body.mass, body.stiffness, body.rest, 15)
    assert np.array_equal(values, again[0])
    assert np.array_equal(shapes, again[1])


def test_chain_modes_in_closed_form():
    """ω_k = 2 √(k/m) sin(kπ/2n) of a free chain."""
    nodes = 900  # beyond the dense solve
    body = chain(nodes, mass=float(nodes), stiffness=1.0)
    values, _ = lowest_modes(body.mass, body.stiffness, body.rest, 5)
    assert np.allclose(np.sqrt(values), 2.0 * np.sin(np.arange(5) * np.pi / (2 * nodes)), rtol=1e-7, atol=1e-9)


@given(st.integers(1, 60), st.integers(0, 1000))
def test_nested_dissection_orders_every_node_once(nodes: int, seed: int):
    rng = np.random.default_rng(seed)
    links = rng.random((nodes, nodes)) < 0.1
    graph = sp.csr_array((links | links.T).astype(np.int8))
    order = np.concatenate(dissect(np.arange(nodes), rng.normal(size=(nodes, 3)), graph))
    assert np.array_equal(np.sort(order), np.arange(nodes))


class TestTruncation:
    @pytest.mark.parametrize("make", [held, beam])
    @pytest.mark.parametrize("contacts", [[44], [44, 7, 30]])
    def test_compliance_at_the_contacts_is_exact(self, make: Any, contacts: list[int]):
        body = make()
        kept = body.truncated(modes=10, contacts=contacts).truncation
        rows = (np.array(contacts)[:, None] * 3 + np.arange(3)).ravel()
        readings = np.eye(body.mass.shape[0])[rows]
        exact = dense_compliance(body, contacts)
        assert np.allclose(kept.compliance(readings), exact, rtol=1e-8, atol=1e-10 * np.abs(exact).max())
        assert kept.error < 1e-9
        assert kept.error_without > 0.01

    @pytest.mark.parametrize("make", [held, beam])
    def test_shapes_are_orthonormal_and_hold_the_modes(self, make: Any):
        body = make()
        kept = body.truncated(modes=10, contacts=[44, 7]).truncation
        shapes = kept.shapes
        assert shapes.shape == (body.mass.shape[0], 16)
        assert np.allclose(shapes.T @ (body.mass @ shapes), np.eye(16), atol=1e-8)
        turned = shapes.T @ (body.stiffness @ shapes)
        assert np.allclose(turned, np.diag(kept.stiffness), atol=1e-8 * kept.stiffness.max())
        exact = eigh(body.stiffness.toarray(), body.mass.toarray(), eigvals_only=True)[:10]
        assert np.allclose(kept.stiffness[:10], exact, rtol=1e-6, atol=1e-6)
        assert np.allclose(kept.frequencies, np.sqrt(kept.stiffness[:10]) / 2 / np.pi)

    def test_what_is_missing_elsewhere_is_a_compliance(self):
        """Away from the contacts a truncated body is too stiff, never too soft: the residual is semidefinite."""
        body = held()
        everything = np.eye(body.mass.shape[0])
        exact = dense_compliance(body, list(range(body.nodes)))
        last = np.inf
        for modes in (1, 5, 20, 60):
            kept = body.truncated(modes=modes, contacts=[44]).truncation
            missing = exact - kept.compliance(everything)
            values = np.linalg.eigvalsh(missing)
            assert values.min() > -1e-9 * np.abs(exact).max()
            assert values.max() < last
            last = values.max()

    @pytest.mark.parametrize("make", [held, beam])
    def test_missing_compliance_makes_up_for_it_anywhere_on_the_skin(self, make: Any):
        body = make()
        made = body.truncated(modes=9, contacts=[44])
        assert made.skin is not None
        vertices = [0, 5, int(np.flatnonzero(made.skin.nodes[:, 0] == 44)[0])]
        nodes = made.skin.nodes[vertices, 0].tolist()
        rows = (np.array(nodes)[:, None] * 3 + np.arange(3)).ravel()
        missing = made.missing_compliance(vertices)
        exact = dense_compliance(body, nodes)
        found = made.truncation.compliance(np.eye(body.mass.shape[0])[rows]) + missing
        assert np.allclose(found, exact, rtol=1e-8, atol=1e-9 * np.abs(exact).max())
        assert np.linalg.eigvalsh(missing).min() > -1e-9 * np.abs(exact).max()
        assert np.abs(missing[6:, 6:]).max() < 1e-9 * np.abs(exact).max()  # the contact lacks nothing
        assert np.diag(missing)[:6].min() > 0.01 * np.diag(exact)[:6].min()

    def test_missing_compliance_of_a_lattice_is_the_same_along_every_axis(self):
        body = body_from_surface(box(), unit="m", resolution=3, ground="z-", ground_stiffness=1e3)
        made = body.truncated(modes=4)
        wide = Body(
            mass=made.as_full().mass,
            rest=made.rest,
            stiffness_int=made.as_full().stiffness_int,
            stiffness_ext=made.as_full().stiffness_ext,
            skin=made.skin,
            truncation=made.as_full().truncation,
        )
        assert np.allclose(
            wide.missing_compliance([1, 7]), np.kron(made.missing_compliance([1, 7]), np.eye(3)), atol=1e-12
        )

    def test_missing_compliance_needs_both(self):
        with pytest.raises(BodyError, match="the body has no truncation; it needs both"):
            beam().missing_compliance([0])
        with pytest.raises(BodyError, match="the body has no skin; it needs both"):
            chain(4, dimension=3).truncated(modes=2).missing_compliance([0])
        with pytest.raises(BodyError, match="vertices names 999; the skin has vertices 0 to"):
            beam().truncated(modes=6).missing_compliance([999])

    def test_all_modes_leave_nothing_over(self):
        body = beam()
        kept = body.truncated(modes=body.mass.shape[0], contacts=[3]).truncation
        assert kept.shapes.shape[1] == body.mass.shape[0]
        assert kept.error_without < 1e-8

    def test_node_form(self):
        body = lattice((5, 4, 3), ground="x-", ground_stiffness=10.0)
        made = body.truncated(modes=6, contacts=[59, 0])
        assert made.form == "node"
        kept = made.truncation
        assert kept is not None
        assert kept.shapes.shape == (60, 8)
        assert np.allclose(kept.compliance(np.eye(60)[[59, 0]]), dense_compliance(body, [59, 0]))
        wide = made.as_full().truncation
        assert wide is not None
        assert wide.modes == 18
        assert np.allclose(wide.shapes.T @ made.as_full().mass @ wide.shapes, np.eye(24), atol=1e-9)

    def test_skin_and_matrices_stay(self):
        body = held()
        made = body.truncated(modes=4)
        assert made.skin is body.skin
        assert made.origin is body.origin
        assert abs(made.stiffness - body.stiffness).max() == 0.0

    @pytest.mark.parametrize(
        ("options", "message"),
        [
            ({"modes": 0}, "modes is 0; it must be from 1 to 135, the rows of this body"),
            ({"modes": 136}, "modes is 136; it must be from 1 to 135"),
            ({"modes": 5}, "modes is 5, but more rigid motions are free"),
            ({"modes": 8, "contacts": [45]}, "contacts names node index 45; this body has nodes 0 to 44"),
        ],
    )
    def test_refused(self, options: Any, message: str):
        with pytest.raises(BodyError, match=re.escape(message)):
            beam().truncated(**options)

    def test_damping_that_the_modes_do_not_share_is_refused(self):
        body = beam(ground="x-", ground_stiffness=1e3, ground_damping=5.0)
        with pytest.raises(UnsupportedError, match="the damping of this body is not diagonal in its modes"):
            body.truncated(modes=8)


def test_known_sums_of_squares_are_only_looked_over():
    """Minors catch what cannot be semidefinite; a matrix of unknown descent is still factorised."""
    from cotouch.body import SumOfSquares

    good = np.array([[2.0, -2.0], [-2.0, 2.0]])
    Body(mass=np.eye(2), rest=[0, 1], stiffness_int=SumOfSquares(sp.csr_array(good)))
    for bad in ([[2.0, -2.1], [-2.1, 2.0]], [[-1.0, 0.0], [0.0, 1.0]]):
        with pytest.raises(
            BodyError, match=r"stiffness_int\[\d, \d\] is .*; stiffness_int must be positive semidefinite"
        ):
            Body(mass=np.eye(2), rest=[0, 1], stiffness_int=SumOfSquares(sp.csr_array(np.array(bad))))
