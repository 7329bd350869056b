"""Point, chain and lattice against closed forms: spectra of paths and boxes, and counts of edges."""

import re
from itertools import product
from math import prod
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from cotouch.body import Body, body_from_surface, chain, lattice, point
from cotouch.errors import BodyError

REACH = {6: 1, 18: 2, 26: 3}


def path_eigenvalues(nodes: int) -> np.ndarray:
    """Of the Laplacian of a path: 2 - 2 cos(πk/n)."""
    return 2.0 - 2.0 * np.cos(np.pi * np.arange(nodes) / nodes)


def edges(body: Body) -> int:
    return np.count_nonzero(np.triu(body.stiffness_int.toarray(), 1))


class TestPoint:
    def test_numbers_end_up_in_their_places(self):
        body = point(mass=2.0, damping=0.5, stiffness=30.0, rest=[1.0, 2.0, 3.0])
        assert (body.nodes, body.dimension, body.form) == (1, 3, "node")
        assert body.mass.toarray() == body.mass.toarray() == [[2.0]]
        assert body.damping.toarray() == body.damping_ext.toarray() == [[0.5]]
        assert body.stiffness.toarray() == body.stiffness_ext.toarray() == [[30.0]]
        assert body.rest.tolist() == [[1.0, 2.0, 3.0]]

    def test_defaults_are_a_free_kilogram(self):
        body = point()
        assert body.mass.toarray() == [[1.0]]
        assert body.damping.nnz == body.stiffness.nnz == 0
        assert body.rest.tolist() == [[0.0]]

    @pytest.mark.parametrize("name", ["damping", "stiffness"])
    @pytest.mark.parametrize("value", [-1.0, np.nan, np.inf])
    def test_out_of_range(self, name: str, value: float):
        with pytest.raises(BodyError, match=f"^{name} is {value}; it must be a finite number of at least 0"):
            point(**{name: value})

    @pytest.mark.parametrize(("mass", "message"), [(0.0, "node 1 has mass 0"), (np.nan, "mass[0, 0] is nan")])
    def test_mass_out_of_range(self, mass: float, message: str):
        with pytest.raises(BodyError, match=re.escape(message)):
            point(mass=mass)

    def test_too_many_axes(self):
        with pytest.raises(BodyError, match="rest is 1 x 4"):
            point(rest=[0.0] * 4)


class TestSpectrum:
    @given(nodes=st.integers(1, 40), stiffness=st.floats(1e-3, 1e6), dimension=st.integers(1, 3))
    def test_chain_is_a_path(self, nodes: int, stiffness: float, dimension: int):
        body = chain(nodes, stiffness=stiffness, dimension=dimension)
        found = np.linalg.eigvalsh(body.stiffness.toarray())
        assert np.allclose(found, stiffness * path_eigenvalues(nodes), rtol=1e-12, atol=1e-12 * stiffness)
        assert body.dimension == dimension

    @given(shape=st.lists(st.integers(1, 5), min_size=1, max_size=3), stiffness=st.floats(1e-3, 1e6))
    def test_box_of_six_neighbours_has_sums_of_path_eigenvalues(self, shape: list[int], stiffness: float):
        sums = [sum(parts) for parts in product(*[path_eigenvalues(extent) for extent in shape])]
        found = np.linalg.eigvalsh(lattice(shape, stiffness=stiffness).stiffness.toarray())
        assert np.allclose(found, stiffness * np.sort(sums), rtol=1e-12, atol=1e-11 * stiffness)

    @given(shape=st.lists(st.integers(1, 4), min_size=1, max_size=3))
    def test_box_of_26_neighbours_is_a_strong_product(self, shape: list[int]):
        """Its adjacency plus the identity is the Kronecker product of those of the paths."""
        strong = np.ones((1, 1))
        for extent in shape:
            strong = np.kron(strong, np.eye(extent) + np.eye(extent, k=1) + np.eye(extent, k=-1))
        laplacian = np.diag(strong.sum(axis=1)) - strong
        assert np.array_equal(lattice(shape, neighbours=26, stiffness=1.0).stiffness.toarray(), laplacian)

    def test_held_everywhere_the_spectrum_is_shifted(self):
        body = lattice((3, 4), stiffness=7.0, ground="all", ground_stiffness=2.5)
        free = lattice((3, 4), stiffness=7.0)
        shifted = np.linalg.eigvalsh(free.stiffness.toarray()) + 2.5
        assert np.allclose(np.linalg.eigvalsh(body.stiffness.toarray()), shifted, rtol=1e-12)

    def test_damping_follows_the_same_edges(self):
        body = lattice((2, 3, 2), neighbours=18, stiffness=4.0, damping=1.0)
        assert np.array_equal(4.0 * body.damping_int.toarray(), body.stiffness_int.toarray())


class TestEdges:
    @given(shape=st.lists(st.integers(1, 5), min_size=1, max_size=3), neighbours=st.sampled_from([6, 18, 26]))
    def test_count(self, shape: list[int], neighbours: Any):
        """Moves that change s axes: 2^(s-1) directions on every choice of s axes."""
        expected = 0
        for chosen in product([0, 1], repeat=len(shape)):
            if 0 < sum(chosen) <= REACH[neighbours]:
                places = prod(extent - used for extent, used in zip(shape, chosen, strict=True))
                expected += places * 2 ** (sum(chosen) - 1)
        body = lattice(shape, neighbours=neighbours)
        assert edges(body) == expected
        assert np.allclose(body.stiffness_int.sum(axis=1), 0.0, atol=1e-11)

    @pytest.mark.parametrize(
        ("shape", "neighbours", "count"),
        [
            ((10,), 6, 9),
            ((10,), 26, 9),
            ((3, 3), 6, 12),
            ((3, 3), 18, 20),
            ((3, 3), 26, 20),
            ((3, 3, 3), 6, 54),
            ((3, 3, 3), 18, 126),
            ((3, 3, 3), 26, 158),
        ],
    )
    def test_counted_by_hand(self, shape: tuple[int, ...], neighbours: Any, count: int):
        assert edges(lattice(shape, neighbours=neighbours)) == count

    @pytest.mark.parametrize("neighbours", [6, 18, 26])
    def test_a_node_in_the_middle_has_all_its_neighbours(self, neighbours: Any):
        assert lattice((3, 3, 3), neighbours=neighbours, stiffness=1.0).stiffness_int[13, 13] == neighbours


class TestShape:
    @given(shape=st.lists(st.integers(1, 4), min_size=1, max_size=3), spacing=st.floats(1e-3, 10.0))
    def test_nodes_lie_on_the_grid_in_order(self, shape: list[int], spacing: float):
        body = lattice(shape, spacing=spacing)
        assert np.array_equal(body.rest, np.array(list(np.ndindex(*shape))) * spacing)

    @given(shape=st.lists(st.integers(1, 4), min_size=1, max_size=3), mass=st.floats(1e-3, 1e3))
    def test_mass_is_that_of_the_whole_body(self, shape: list[int], mass: float):
        body = lattice(shape, mass=mass)
        assert body.mass.sum() == pytest.approx(mass, rel=1e-12)
        assert np.ptp(body.mass.diagonal()) == 0.0

    def test_chain_runs_along_x(self):
        body = chain(3, dimension=3, spacing=0.5)
        assert body.rest.tolist() == [[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]]

    @pytest.mark.parametrize("shape", [(), (0,), (2, -1), (2, 2, 2, 2), (2.5,), (np.nan, 2)])
    def test_refused(self, shape: Any):
        with pytest.raises(BodyError, match=re.escape(f"the lattice's shape is {shape}; it must be 1 to 3 whole num")):
            lattice(shape)

    @pytest.mark.parametrize("dimension", [0, -1, 4])
    def test_dimension_refused(self, dimension: int):
        with pytest.raises(BodyError, match=f"dimension is {dimension}; it must be 1, 2 or 3"):
            chain(3, dimension=dimension)

    @pytest.mark.parametrize("neighbours", [0, 4, 8, 27])
    def test_neighbours_refused(self, neighbours: Any):
        with pytest.raises(BodyError, match=f"neighbours is {neighbours}; it must be 6, 18 or 26"):
            lattice((2, 2), neighbours=neighbours)

    @pytest.mark.parametrize("spacing", [0.0, -0.1, np.nan, np.inf])
    def test_spacing_refused(self, spacing: float):
        with pytest.raises(BodyError, match=f"spacing is {spacing}; it must be more than 0 m"):
            chain(2, spacing=spacing)

    @pytest.mark.parametrize("name", ["stiffness", "damping", "ground_stiffness", "ground_damping"])
    @pytest.mark.parametrize("value", [-1.0, np.nan, np.inf])
    @pytest.mark.parametrize("build", [lambda **rest: chain(3, **rest), lambda **rest: lattice((2, 2), **rest)])
    def test_values_refused(self, build: Any, name: str, value: float):
        with pytest.raises(BodyError, match=f"^{name} is {value}; it must be a finite number of at least 0"):
            build(**{name: value})

    @pytest.mark.parametrize("mass", [0.0, -1.0])
    def test_mass_refused(self, mass: float):
        with pytest.raises(BodyError, match="node 1 has mass"):
            chain(3, mass=mass)


class TestGround:
    @pytest.mark.parametrize(
        ("ground", "held"),
        [
            ("none", []),
            ("all", list(range(12))),
            ("x-", [0, 1, 2, 3, 4, 5]),
            ("x+", [6, 7, 8, 9, 10, 11]),
            ("y-", [0, 1, 6, 7]),
            ("y+", [4, 5, 10, 11]),
            ("z-", [0, 2, 4, 6, 8, 10]),
            ("z+", [1, 3, 5, 7, 9, 11]),
            ([3, 7], [3, 7]),
            ([], []),
            ((5, 5), [5]),
            (np.array([2, 4]), [2, 4]),
        ],
    )
    def test_which_nodes_are_held(self, ground: Any, held: list[int]):
        body = lattice((2, 3, 2), ground=ground, ground_stiffness=8.0, ground_damping=0.25)
        expected = np.zeros(12)
        expected[held] = 1.0
        assert np.array_equal(body.stiffness_ext.toarray(), np.diag(8.0 * expected))
        assert np.array_equal(body.damping_ext.toarray(), np.diag(0.25 * expected))

    def test_chain_passes_it_on(self):
        body = chain(3, ground="x+", ground_stiffness=8.0, ground_damping=0.25)
        assert body.stiffness_ext.diagonal().tolist() == [0.0, 0.0, 8.0]
        assert body.damping_ext.diagonal().tolist() == [0.0, 0.0, 0.25]

    @pytest.mark.parametrize("ground", ["z-", "x", "", "x*", "-x", "left", "All"])
    def test_unknown_face(self, ground: Any):
        message = f'ground is "{ground}"; it must be node indices, "none", "all" or a face: "x-", "x+", "y-", "y+"'
        with pytest.raises(BodyError, match=re.escape(message) + "$"):
            lattice((2, 2), ground=ground)

    @pytest.mark.parametrize("index", [-1, 4, 100])
    def test_unknown_node(self, index: int):
        with pytest.raises(BodyError, match=f"ground names node index {index}; this body has nodes 0 to 3"):
            lattice((2, 2), ground=[0, index])


@pytest.mark.parametrize("value", [[1.0, 2.0], "soft", True, 1j])
@pytest.mark.parametrize("name", ["young", "density", "poisson", "rayleigh_mass"])
def test_what_is_no_number_is_a_sentence(name: str, value: object) -> None:
    with pytest.raises(BodyError, match=rf"{name} is .*; it must be one number") as caught:
        body_from_surface(([[0.0, 0.0, 0.0]], [[0, 0, 0]]), unit="m", **{name: value})
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["mass", "stiffness", "damping", "spacing"])
def test_what_is_no_number_of_a_lattice_is_a_sentence(name: str) -> None:
    with pytest.raises(BodyError, match=rf"{name} is \[1, 2\]; it must be one number"):
        lattice((2, 2), **{name: [1, 2]})
