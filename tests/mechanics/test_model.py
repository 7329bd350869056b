"""From a body to the arrays of the kernels, and back."""

import re
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import scipy.linalg as la
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st
from tests.mechanics.reference import wide
from tests.mechanics.support import Scene, scenes

from cotouch.body import Body, chain, lattice, point
from cotouch.errors import BodyError
from cotouch.mechanics import Basis, Model, model, multiply


def rebuilt(ready: Model, matrix: int, diagonal: np.ndarray) -> np.ndarray:
    """A matrix of the operator as dense nd x nd."""
    op = ready.operator
    values = op.mix[matrix] @ op.entries if op.entries.shape[0] else np.zeros(op.column.size)
    off = sp.csr_array((values, op.column, op.pointer), shape=(diagonal.size, diagonal.size)).toarray()
    return wide(np.diag(diagonal) + off, ready.body)


class TestOperator:
    @given(scenes())
    def test_holds_the_matrices_to_round_off(self, scene: Scene):
        ready = model(scene.body, copies=scene.copies, weights=scene.weights, basis="nodal")
        op, body = ready.operator, scene.body
        expected = [body.mass, body.damping, body.stiffness]
        dense = [wide(matrix.toarray(), body) for matrix in expected]
        dense += [np.eye(body.nodes * body.dimension), *(wide(np.asarray(weight), body) for weight in scene.weights)]
        for matrix, (diagonal, exact) in enumerate(
            zip([op.mass, op.damping, op.stiffness, *op.weight], dense, strict=True)
        ):
            found = rebuilt(ready, matrix, diagonal)
            assert np.allclose(found, exact, rtol=0.0, atol=1e-14 * np.abs(exact).max())
        assert op.copy_scale == 1.0 / scene.copies
        assert not np.any(op.column == np.repeat(np.arange(op.mass.size), np.diff(op.pointer)))

    def test_springs_and_dampers_on_the_same_edges_share_one_family(self):
        op = model(lattice((3, 3), damping=0.5, stiffness=200.0), basis="nodal").operator
        assert op.entries.shape[0] == 1
        assert op.mix[:, 0].tolist() == [0.0, 0.5 / 200.0, 1.0, 0.0]

    def test_damping_without_springs_is_a_family_too(self):
        op = model(lattice((3, 3), damping=0.5, stiffness=0.0), basis="nodal").operator
        assert op.mix[:, 0].tolist() == [0.0, 1.0, 0.0, 0.0]

    def test_a_point_has_none(self):
        op = model(point(stiffness=3.0, rest=[0.0, 0.0, 0.0])).operator
        assert op.entries.shape[0] == 0
        assert op.pointer.tolist() == [0, 0]

    def test_independent_patterns_are_independent_families(self):
        ring = np.eye(6) * 2 - np.roll(np.eye(6), 1, axis=0) - np.roll(np.eye(6), -1, axis=0)
        second = np.eye(6) * 2 - np.roll(np.eye(6), 2, axis=0) - np.roll(np.eye(6), -2, axis=0)
        body = Body(mass=np.eye(6) + 0.1 * second, rest=np.arange(6), stiffness_int=ring, damping_int=ring + second)
        assert model(body, weights=[np.eye(6) + 0.05 * ring], basis="nodal").operator.entries.shape[0] == 3

    @given(scenes(), st.integers(0, 1000))
    def test_multiply_is_the_product_and_the_quadratic_form(self, scene: Scene, seed: int):
        ready = model(scene.body, basis="nodal")
        field = np.random.default_rng(seed).normal(size=(scene.body.nodes, scene.body.dimension))
        rows = ready.to_rows(field)
        for matrix, diagonal, own in (
            (0, ready.operator.mass, scene.body.mass),
            (2, ready.operator.stiffness, scene.body.stiffness),
        ):
            out = np.full_like(rows, np.nan)
            form = multiply(ready.operator, matrix, diagonal, rows, out, ready.lanes)
            expected = scene.body.apply(own, field)
            size = np.abs(expected).max()
            assert np.allclose(ready.to_nodes(out), expected, rtol=0.0, atol=1e-12 * size)
            assert form == pytest.approx(np.sum(field * expected), abs=1e-11 * size * np.abs(field).sum())

    @given(scenes())
    def test_magnitude_is_what_a_row_has_off_the_diagonal(self, scene: Scene):
        op = model(scene.body, weights=scene.weights, basis="nodal").operator
        assert op.magnitude.shape == (op.entries.shape[0], op.mass.size)
        for values, found in zip(op.entries, op.magnitude, strict=True):
            rows = [np.abs(values[a:b]).sum() for a, b in pairwise(op.pointer)]
            assert np.allclose(found, rows, rtol=1e-14)

    def test_ground_is_what_rows_of_k_sum_to_without_rounding(self):
        springs = 10.0 ** np.random.default_rng(0).uniform(-3.0, 3.0, (40, 40))
        K = np.diag((springs + springs.T).sum(axis=1)) - springs - springs.T
        held = np.where(np.arange(40) < 3, 0.01, 0.0)
        assert np.any(K.sum(axis=1) != 0.0)
        body = Body(mass=np.eye(40), rest=np.arange(40), stiffness_int=K, stiffness_ext=np.diag(held))
        ground = model(body, basis="nodal").operator.ground
        assert np.allclose(ground[:3], 0.01, rtol=1e-9)
        assert not np.any(ground[3:])


def ring(nodes: int, copies: int = 1) -> Body:
    """Separate rings of equal masses and springs."""
    one = 2.0 * np.eye(nodes) - np.roll(np.eye(nodes), 1, axis=0) - np.roll(np.eye(nodes), -1, axis=0)
    size = nodes * copies
    return Body(mass=np.eye(size), rest=np.arange(size), stiffness_int=np.kron(np.eye(copies), one))


class TestHalves:
    @pytest.mark.parametrize(
        ("body", "split"),
        [
            (chain(7), 4),
            (lattice((4, 3, 5)), 30),
            (lattice((3, 3, 3)), 14),
            (lattice((4, 3)).as_full(), 12),
            (ring(6), 3),
            (ring(6, copies=3), 9),
        ],
        ids=["chain", "box", "odd box", "full form", "ring", "three rings"],
    )
    def test_entries_lie_across_only(self, body: Body, split: int):
        ready = model(body, basis="nodal")
        op = ready.operator
        row = np.repeat(np.arange(op.mass.size), np.diff(op.pointer))
        assert np.all((row < op.split) != (op.column < op.split))
        assert op.split == split
        assert ready.order is not None
        assert sorted(ready.order) == list(range(op.mass.size))

    def test_within_a_half_rows_keep_their_order(self):
        """Neighbours stay near each other in memory."""
        order = model(lattice((5, 4, 3)), basis="nodal").order
        assert order is not None
        assert np.all(np.diff(order[:30]) > 0)
        assert np.all(np.diff(order[30:]) > 0)

    @pytest.mark.parametrize("body", [ring(5), ring(3), ring(5, copies=2)])
    def test_an_odd_ring_has_none(self, body: Body):
        ready = model(body, basis="nodal")
        assert (ready.order, ready.operator.split) == (None, 0)

    def test_one_odd_ring_beside_an_even_one_is_enough(self):
        even, odd = (ring(nodes).stiffness_int.toarray() for nodes in (6, 5))
        body = Body(mass=np.eye(11), rest=np.arange(11), stiffness_int=la.block_diag(even, odd))
        assert model(body, basis="nodal").operator.split == 0

    def test_every_matrix_counts(self):
        """Springs along a chain have halves; a damper, a mass or a weight between every other node undoes them."""
        line, skip = chain(6), np.zeros((6, 6))
        skip[:3:2, :3:2] = [[1.0, -1.0], [-1.0, 1.0]]
        assert model(line, basis="nodal").operator.split == 3
        assert model(line, weights=[np.eye(6) + 0.1 * skip], basis="nodal").operator.split == 0
        for name in ("mass", "damping_int"):
            parts = {"mass": line.mass, "damping_int": line.damping_int, name: getattr(line, name) + 0.01 * skip}
            body = Body(rest=line.rest, stiffness_int=line.stiffness_int, **parts)
            assert model(body, basis="nodal").operator.split == 0

    def test_a_point_and_modes_need_none(self):
        assert model(point()).order is None
        assert model(chain(4), basis="modal").order is None
        assert model(chain(4), basis="modal").operator.split == 0

    @pytest.mark.parametrize("full", [False, True])
    def test_ports_and_nodes_follow_the_order(self, full: bool):
        body = lattice((3, 3))
        ready = model(body.as_full() if full else body, basis="nodal")
        field = np.random.default_rng(0).normal(size=(9, 2))
        rows = ready.to_rows(field)
        assert np.array_equal(ready.to_nodes(rows), field)
        for node in range(9):
            held = rows[ready.port_rows(node)]
            assert np.array_equal(held[:, 0] if full else held[0, :2], field[node])
            assert ready.port_rows(node).dtype == np.int32

    @pytest.mark.parametrize("full", [False, True])
    def test_the_operator_is_the_body_in_that_order(self, full: bool):
        body = lattice((4, 3), damping=0.3, ground="x-", ground_stiffness=2.0)
        body = body.as_full() if full else body
        ready = model(body, basis="nodal")
        order = ready.order if full else np.add.outer(2 * np.asarray(ready.order), [0, 1]).ravel()
        found = rebuilt(ready, 2, ready.operator.stiffness)
        assert np.array_equal(found, wide(body.stiffness.toarray(), body)[np.ix_(order, order)])


class TestRows:
    @pytest.mark.parametrize("basis", ["nodal", "modal"])
    @pytest.mark.parametrize("dimension", [1, 2, 3])
    @pytest.mark.parametrize("full", [False, True])
    def test_there_and_back(self, dimension: int, full: bool, basis: Basis):
        body = chain(4, mass=3.0, dimension=dimension)
        ready = model(body.as_full() if full else body, basis=basis)
        field = np.random.default_rng(0).normal(size=(4, dimension))
        rows = ready.to_rows(field)
        assert rows.shape == (ready.operator_rows, ready.width)
        assert ready.basis == basis
        assert ready.lanes == (0,) * ready.width
        assert np.allclose(ready.to_nodes(rows), field, rtol=1e-13, atol=1e-13)

    @pytest.mark.parametrize("dimension", [1, 2, 3])
    def test_both_directions_copy(self, dimension: int):
        ready, field = model(chain(4, dimension=dimension), basis="nodal"), np.ones((4, dimension))
        rows = ready.to_rows(field)
        nodes = ready.to_nodes(rows)
        rows[:] = 7.0
        assert np.array_equal(field, np.ones((4, dimension)))
        assert np.array_equal(nodes, np.ones((4, dimension)))

    @pytest.mark.parametrize(("dimension", "width"), [(1, 1), (2, 4), (3, 4)])
    def test_width(self, dimension: int, width: int):
        body = chain(4, dimension=dimension)
        assert model(body).width == width
        assert model(body.as_full()).width == 1

    def test_port_rows(self):
        body = chain(4, dimension=3)
        assert model(body).port_rows(2).tolist() == [2]
        assert model(body.as_full()).port_rows(2).tolist() == [6, 7, 8]
        assert model(body).port_rows(2).dtype == np.int32

    def test_port_shapes_read_a_node_out_of_the_modes(self):
        ready = model(chain(4, dimension=2), basis="modal")
        field = np.random.default_rng(0).normal(size=(4, 2))
        rows = np.concatenate([ready.port_rows(node) for node in (3, 1)])
        assert np.allclose(ready.port_shapes(rows) @ ready.to_rows(field)[:, :2], field[[3, 1]])
        assert ready.port_shapes(rows).flags.c_contiguous

    def test_port_shapes_are_empty_in_the_nodal_basis(self):
        ready = model(chain(4, dimension=2), basis="nodal")
        assert ready.port_shapes(ready.port_rows(1)).shape == (0, 4)

    @given(scenes())
    def test_kernels_get_contiguous_arrays_of_one_type(self, scene: Scene):
        op = model(scene.body, weights=scene.weights, basis="nodal").operator
        for name, array in op._asdict().items():
            if name not in {"copy_scale", "firmness", "split"}:
                assert array.flags.c_contiguous
                assert array.flags.writeable
                assert array.dtype == (np.int32 if name in {"pointer", "column", "gone", "debris"} else np.float64)


class TestWeights:
    def weight(self, body: Body, weight: Any) -> np.ndarray:
        ready = model(body, weights=[weight], basis="nodal")
        return rebuilt(ready, 4, ready.operator.weight[1])

    def random(self, size: int) -> np.ndarray:
        half = np.random.default_rng(size).normal(size=(size, size))
        return half @ half.T + np.eye(size)

    @pytest.mark.parametrize("full", [False, True])
    @pytest.mark.parametrize("wrap", [np.asarray, sp.csr_array, sp.coo_array])
    def test_every_size(self, full: bool, wrap: Any):
        body = chain(4, dimension=3)
        body = body.as_full() if full else body
        for size, expected in [
            (4, np.kron(self.random(4), np.eye(3))),
            (3, np.kron(np.eye(4), self.random(3))),
            (12, self.random(12)),
        ]:
            assert np.allclose(self.weight(body, wrap(self.random(size))), expected, rtol=1e-14)

    def test_only_what_mixes_axes_needs_the_full_form(self):
        body = chain(4, dimension=3)
        assert not model(body, weights=[self.random(4)]).full
        assert model(body, weights=[self.random(3)]).full
        assert model(body, weights=[self.random(4), self.random(12)]).full
        assert model(body, weights=[self.random(3)]).body.form == "full"

    def test_on_a_line_n_is_nd(self):
        assert np.allclose(self.weight(chain(4), self.random(4)), self.random(4))

    def test_a_scalar_on_a_line_scales_the_identity(self):
        assert np.array_equal(self.weight(chain(4), 2.5), 2.5 * np.eye(4))

    def test_a_point_takes_a_matrix_over_its_axes(self):
        assert np.allclose(self.weight(point(rest=[0.0, 0.0]), self.random(2)), self.random(2))

    def test_as_many_nodes_as_axes_leaves_only_the_full_size(self):
        body = chain(3, dimension=3)
        assert np.allclose(self.weight(body, self.random(9)), self.random(9))
        with pytest.raises(BodyError, match=r"link weight 1 is 3 x 3; for this body it must be 9 x 9$"):
            model(body, weights=[self.random(3)])

    @pytest.mark.parametrize("shape", [(5, 5), (4, 3), (3, 4), (1, 4), (12, 4)])
    def test_wrong_size(self, shape: tuple[int, int]):
        message = f"link weight 2 is {shape[0]} x {shape[1]}; for this body it must be 4 x 4 or 3 x 3 or 12 x 12"
        with pytest.raises(BodyError, match=re.escape(message)):
            model(chain(4, dimension=3), weights=[np.eye(4), np.ones(shape)])

    @pytest.mark.parametrize("copies", [0, -1])
    def test_no_copies(self, copies: int):
        with pytest.raises(BodyError, match=f"copies is {copies}; there must be at least 1 user"):
            model(point(), copies=copies)
