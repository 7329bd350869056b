"""What a body refuses, and that the message names the matrix, the entry or the eigenvalue, and what would be right."""

import re
from typing import Any

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st
from tests.body.inside import square

from cotouch.body import Body, chain, lattice
from cotouch.errors import BodyError

FORMS = ["csr", "csc", "coo", "lil", "dok", "bsr", "dia"]
SPRING = [[5.0, -5.0], [-5.0, 5.0]]


def two_nodes(**changes: Any) -> Body:
    """A valid body of two nodes on a line, with some arguments replaced."""
    return Body(**({"mass": [2.0, 3.0] * np.eye(2), "rest": [0.0, 1.0], "stiffness_int": SPRING} | changes))


def refuses(message: str, **changes: Any) -> None:
    with pytest.raises(BodyError, match=re.escape(message)):
        two_nodes(**changes)


@pytest.mark.parametrize("name", ["mass", "damping_int", "damping_ext", "stiffness_int", "stiffness_ext"])
class TestEveryMatrix:
    def test_not_symmetric_names_both_entries(self, name: str):
        refuses(
            f"{name} is not symmetric: {name}[0, 1] = -4.5 but {name}[1, 0] = -5; they must be equal",
            **{name: [[5.0, -4.5], [-5.0, 5.0]]},
        )

    def test_asymmetric_pattern(self, name: str):
        refuses(f"{name}[0, 1] = 0.25 but {name}[1, 0] = 0", **{name: sp.csr_array([[5.0, 0.25], [0.0, 5.0]])})

    @pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
    def test_not_finite_names_the_entry(self, name: str, value: float):
        refuses(f"{name}[1, 0] is {value}; every entry must be a finite number", **{name: [[1, 0], [value, 1]]})

    @pytest.mark.parametrize("shape", [(3, 3), (2, 3), (1, 2), (1, 1)])
    def test_wrong_shape_names_the_right_one(self, name: str, shape: tuple[int, int]):
        refuses(f"{name} is {shape[0]} x {shape[1]}; for this body it must be 2 x 2", **{name: np.ones(shape)})

    def test_wrong_shape_in_the_plane_names_both_right_ones(self, name: str):
        with pytest.raises(BodyError, match=re.escape(f"{name} is 3 x 3; for this body it must be 4 x 4 or 2 x 2")):
            Body(**({"mass": np.eye(2), "rest": np.zeros((2, 2))} | {name: np.eye(3)}))

    @pytest.mark.parametrize("value", ["a", [[1.0, 2.0], [3.0]], [["a", "b"], ["c", "d"]], np.ones((2, 2, 2))])
    def test_not_a_matrix(self, name: str, value: Any):
        refuses(f"{name} is not a matrix of real numbers", **{name: value})

    @pytest.mark.parametrize("wrap", [np.asarray, sp.csr_array], ids=["dense", "sparse"])
    def test_complex(self, name: str, wrap: Any):
        refuses(f"{name} has complex entries", **{name: wrap([[1.0, 2j], [-2j, 1.0]])})

    @pytest.mark.parametrize("form", FORMS)
    def test_reads_every_sparse_format(self, name: str, form: str):
        matrix = sp.coo_array(np.diag([4.0, 7.0])).asformat(form)
        assert np.array_equal(getattr(two_nodes(**{name: matrix}), name).toarray(), np.diag([4.0, 7.0]))

    def test_leaves_the_callers_matrix_alone(self, name: str):
        parts = np.array([0.0, 4.0, 0.0, 7.0]), np.array([1, 0, 0, 1]), np.array([0, 2, 4])  # unsorted, stored zeros
        matrix = sp.csr_array(tuple(part.copy() for part in parts), shape=(2, 2))
        for part in (matrix.data, matrix.indices, matrix.indptr):
            part.setflags(write=False)
        body = two_nodes(**{name: matrix})
        assert all(
            np.array_equal(a, b) for a, b in zip(parts, (matrix.data, matrix.indices, matrix.indptr), strict=True)
        )
        assert getattr(body, name).nnz == 2
        assert not np.shares_memory(getattr(body, name).data, matrix.data)

    def test_sums_duplicate_entries(self, name: str):
        matrix = sp.coo_array(([1.0, 3.0, 7.0], ([0, 0, 1], [0, 0, 1])), shape=(2, 2))
        assert np.array_equal(getattr(two_nodes(**{name: matrix}), name).toarray(), np.diag([4.0, 7.0]))


@pytest.mark.parametrize("name", ["damping_int", "stiffness_int"])
class TestSemidefinite:
    def test_negative_eigenvalue_is_named(self, name: str):
        message = f"the smallest eigenvalue of {name} is -1; {name} must be positive semidefinite (no eigenvalue < 0)"
        refuses(message, **{name: [[1.0, 2.0], [2.0, 1.0]]})

    def test_nothing_on_the_diagonal(self, name: str):
        refuses(f"the smallest eigenvalue of {name} is -2;", **{name: [[0.0, 2.0], [2.0, 0.0]]})

    def test_zero_is_allowed(self, name: str):
        assert getattr(two_nodes(**{name: np.zeros((2, 2))}), name).nnz == 0

    def test_not_dominant_but_semidefinite(self, name: str):
        column = np.array([[1.0], [-3.0]])
        assert np.array_equal(getattr(two_nodes(**{name: column @ column.T}), name).toarray(), column @ column.T)

    @given(seed=st.integers(0, 10_000), nodes=st.integers(2, 8), lowest=st.floats(-2.0, 2.0))
    def test_the_sign_of_the_smallest_eigenvalue_decides(self, name: str, seed: int, nodes: int, lowest: float):
        rng = np.random.default_rng(seed)
        turn, _ = np.linalg.qr(rng.normal(size=(nodes, nodes)))
        matrix = turn * np.r_[lowest, rng.uniform(2.0, 5.0, nodes - 1)] @ turn.T
        matrix = 0.5 * (matrix + matrix.T)
        arguments = {"mass": np.eye(nodes), "rest": np.arange(nodes), name: matrix}
        if lowest >= 0.0:
            Body(**arguments)
        elif lowest < -1e-8:
            with pytest.raises(BodyError, match=f"smallest eigenvalue of {name} is -") as caught:
                Body(**arguments)
            assert named_eigenvalue(caught.value) == pytest.approx(lowest, rel=1e-5, abs=1e-13)


class TestDenseAndSparse:
    """A small dense matrix is read by a shorter way; it must come to the same matrix or the same sentence."""

    @staticmethod
    def outcome(matrix: Any, rows: int) -> str | list[list[float]]:
        try:
            result = square("mass", matrix, sizes={rows: "node"})
        except BodyError as error:
            return str(error)
        assert result.has_canonical_format
        assert result.nnz == np.count_nonzero(result.toarray())
        assert (result.dtype, result.indices.dtype, result.indptr.dtype) == (np.float64, np.int32, np.int32)
        return result.toarray().tolist()

    @given(
        values=st.lists(st.sampled_from([0.0, -0.0, 1.0, -2.5, 1e-300, 1e300, np.nan, np.inf]), min_size=6, max_size=6),
        skew=st.sampled_from([0.0, 0.0, 1e-14, 1.0]),
        rows=st.integers(2, 4),
    )
    def test_same_matrix_or_same_sentence(self, values: list[float], skew: float, rows: int):
        matrix = np.zeros((3, 3))
        matrix[np.triu_indices(3)] = values
        matrix = np.where(np.tri(3, k=-1, dtype=bool), matrix.T, matrix)
        matrix[0, 2] += skew
        expected = self.outcome(sp.csr_array(matrix), rows)
        assert self.outcome(matrix, rows) == expected
        assert self.outcome(matrix.tolist(), rows) == expected

    @pytest.mark.parametrize("rows", [1, 2, 64, 65])
    @pytest.mark.parametrize("dtype", [np.float64, np.float32, np.int64, np.uint8, np.bool_])
    def test_same_matrix_of_every_size_and_type(self, rows: int, dtype: Any):
        matrix = np.random.default_rng(rows).integers(0, 2, (rows, rows))
        matrix = (matrix | matrix.T).astype(dtype)
        assert self.outcome(matrix, rows) == matrix.astype(np.float64).tolist()

    @pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan])
    def test_same_sentence_where_a_symmetric_entry_is_not_finite(self, value: float):
        matrix = np.diag([1.0, value])
        expected = f"mass[1, 1] is {value}; every entry must be a finite number"
        assert self.outcome(matrix, 2) == self.outcome(sp.csr_array(matrix), 2) == expected

    def test_leaves_the_callers_array_alone(self):
        matrix = np.eye(2)
        result = square("mass", matrix, sizes={2: "node"})
        result.data[:] = 7.0
        assert np.array_equal(matrix, np.eye(2))


@pytest.mark.parametrize("name", ["mass", "damping_int", "stiffness_int"])
def test_round_off_of_the_assembly_is_taken_out(name: str):
    matrix = getattr(two_nodes(**{name: [[5.0, -2.0], [-2.0 - 1e-14, 5.0]]}), name)
    assert (matrix - matrix.T).nnz == 0
    assert matrix[0, 1] == pytest.approx(-2.0, rel=1e-13)


class TestMass:
    def test_massless_node_is_named(self):
        refuses("node 2 has mass 0 (mass[1, 1]); every node needs a mass > 0", mass=np.diag([1.0, 0.0]))

    def test_negative_mass(self):
        refuses("node 1 has mass -2 (mass[0, 0])", mass=np.diag([-2.0, 1.0]))

    def test_massless_axis_of_a_node(self):
        with pytest.raises(BodyError, match=re.escape("node 2 has mass 0 (mass[3, 3])")):
            Body(mass=np.diag([1.0, 1.0, 1.0, 0.0]), rest=np.zeros((2, 2)))

    @pytest.mark.parametrize(("off", "lowest"), [(1.0, "0"), (2.0, "-1")])
    def test_not_definite(self, off: float, lowest: str):
        message = r"the smallest eigenvalue of mass is (\S+); mass must be positive definite \(every eigenvalue > 0\)"
        with pytest.raises(BodyError, match=message) as caught:
            two_nodes(mass=[[1.0, off], [off, 1.0]])
        assert named_eigenvalue(caught.value) == pytest.approx(float(lowest), abs=1e-12)

    def test_heavy_and_light_nodes_together(self):
        assert two_nodes(mass=np.diag([1e9, 1e-6])).mass.diagonal().tolist() == [1e9, 1e-6]

    def test_consistent_mass_of_a_bar(self):
        matrix = np.array([[2.0, 1.0], [1.0, 2.0]]) / 6.0
        assert np.array_equal(two_nodes(mass=matrix).mass.toarray(), matrix)

    def test_only_whole_numbers(self):
        assert two_nodes(mass=np.eye(2, dtype=np.int64)).mass.dtype == np.float64


@pytest.mark.parametrize("name", ["damping_ext", "stiffness_ext"])
class TestGround:
    def test_not_diagonal(self, name: str):
        message = f"{name}[0, 1] is -5; {name} binds nodes to the ground, so it must be diagonal"
        refuses(message, **{name: SPRING})

    def test_negative(self, name: str):
        refuses(f"{name}[1, 1] is -0.5; it must be 0 or more", **{name: np.diag([0.0, -0.5])})


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        (0.0, "rest is a single number; it must be n x d, with at least one node and d from 1 to 3"),
        ([], "rest is 0 x 1; it must be n x d"),
        (np.zeros((2, 4)), "rest is 2 x 4; it must be n x d"),
        (np.zeros((2, 0)), "rest is 2 x 0; it must be n x d"),
        (np.zeros((1, 2, 3)), "rest is 1 x 2 x 3; it must be n x d"),
        ([[0.0, 1.0], [2.0, np.nan]], "rest[1, 1] is nan; every coordinate must be a finite number"),
        ([0.0, np.inf], "rest[1, 0] is inf; every coordinate must be a finite number"),
        ([[0.0], [-2e300]], "rest[1, 0] is -2e+300 m; a body is within 1e+09 m"),
        ([[0.0], [1.0, 2.0]], "rest is not an array of positions"),
        (["left", "right"], "rest is not an array of positions"),
    ],
)
def test_rest_shape(rest: Any, message: str):
    refuses(message, rest=rest)


def test_rest_shape_is_a_read_only_copy():
    rest = np.array([0.0, 1.0])
    body = two_nodes(rest=rest)
    rest[0] = 9.0
    assert body.rest.tolist() == [[0.0], [1.0]]
    with pytest.raises(ValueError, match="read-only"):
        body.rest[0, 0] = 1.0


class TestLarge:
    """Beyond the size of a dense eigenvalue solve, with matrices that no row sum decides."""

    NODES = 2000

    def beam(self) -> sp.csr_array:
        """Bending of a free beam: not dominant, two rigid motions, and eigenvalues down to 1e-12 of the largest."""
        second = sp.diags_array([1.0, -2.0, 1.0], offsets=[0, 1, 2], shape=(self.NODES - 2, self.NODES))
        return sp.csr_array(second.T @ second)

    def body(self, **matrices: Any) -> Body:
        return Body(**({"mass": sp.eye_array(self.NODES), "rest": np.arange(self.NODES)} | matrices))

    @pytest.mark.parametrize("name", ["damping_int", "stiffness_int"])
    def test_semidefinite_is_accepted(self, name: str):
        matrix = self.beam()
        assert np.min(2 * matrix.diagonal() - abs(matrix).sum(axis=1)) < -1.0
        assert abs(getattr(self.body(**{name: matrix}), name) - matrix).max() == 0.0

    @pytest.mark.parametrize("lowest", [-3.0, -1e-2, -1e-5, -1e-8])
    def test_indefinite_is_refused_with_its_eigenvalue(self, lowest: float):
        with pytest.raises(BodyError, match="smallest eigenvalue of stiffness_int is -") as caught:
            self.body(stiffness_int=self.beam() + lowest * sp.eye_array(self.NODES))
        assert named_eigenvalue(caught.value) == pytest.approx(lowest, rel=1e-3)

    def test_one_bad_entry_is_found(self):
        matrix = self.beam().tolil()
        matrix[1234, 1234] -= 3.0
        exact = np.linalg.eigvalsh(matrix.toarray()[1134:1334, 1134:1334])[0]  # its vector is confined to the place
        with pytest.raises(BodyError, match="smallest eigenvalue of stiffness_int is -") as caught:
            self.body(stiffness_int=matrix)
        assert named_eigenvalue(caught.value) == pytest.approx(exact, rel=1e-3)

    def test_definite_mass(self):
        self.body(mass=self.beam() + 1e-6 * sp.eye_array(self.NODES))

    def test_singular_mass_is_refused(self):
        with pytest.raises(BodyError, match="mass must be positive definite") as caught:
            self.body(mass=self.beam())
        assert named_eigenvalue(caught.value) == pytest.approx(0.0, abs=1e-9)

    def test_negative_definite(self):
        with pytest.raises(BodyError, match="the smallest eigenvalue of stiffness_int is -1;"):
            self.body(stiffness_int=-sp.eye_array(self.NODES))

    def test_nothing_on_the_diagonal(self):
        matrix = sp.coo_array(([2.0, 2.0], ([5, 70], [70, 5])), shape=(self.NODES, self.NODES))
        with pytest.raises(BodyError, match="the smallest eigenvalue of stiffness_int is -2;"):
            self.body(stiffness_int=matrix)

    def test_without_springs_or_dampers(self):
        assert chain(self.NODES, stiffness=0.0).stiffness.nnz == 0
        assert lattice((13, 13, 13)).damping.nnz == 0


def named_eigenvalue(error: BodyError) -> float:
    match = re.search(r"smallest eigenvalue of \w+ is (\S+);", str(error))
    assert match is not None, error
    return float(match[1])
