"""The iterations of the step: a cap costs accuracy, never passivity; a tolerance is kept; the right one is taken."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import given
from hypothesis import strategies as st
from tests.mechanics.reference import dense_step, dense_system
from tests.mechanics.support import Copy, Port, Scene, Spring, periods, random_scene, scenes

from cotouch.body import Body, chain, lattice
from cotouch.mechanics import SUPPLIED, Operator
from cotouch.mechanics._operator import operator_of
from cotouch.mechanics._solve import chebyshev, chebyshev_iterations, conjugate_gradients, invert


def stiff_lattice(dimension: int = 2) -> Body:
    """Springs far stiffer than a step resolves: about 60 iterations to round-off."""
    return lattice((6, 5, 3)[:dimension], stiffness=3e4, damping=0.5, ground="x-", ground_stiffness=200.0)


def soft_lattice(shape: tuple[int, ...]) -> Body:
    """A step of 20 ms resolves its springs: the diagonal outweighs the rest, and the rows have two halves."""
    return lattice(shape, stiffness=30.0, damping=0.01, ground="x-", ground_stiffness=3.0)


def consistent(body: Body) -> Body:
    """The same with a mass that couples neighbours, and dampers that follow no spring."""
    n = body.nodes
    coupled = 0.1 * (abs(body.stiffness_int) / abs(body.stiffness_int).max())
    column = np.sin(np.arange(n))[:, None]
    return Body(
        mass=body.mass + coupled / n,
        rest=body.rest,
        damping_int=0.1 * column @ column.T,
        stiffness_int=body.stiffness_int,
        stiffness_ext=body.stiffness_ext,
    )


def in_motion(body: Body, **rest: object) -> Scene:
    rng = np.random.default_rng(11)
    shape = (body.nodes, body.dimension)
    return Scene(body=body, position=0.01 * rng.normal(size=shape), velocity=rng.normal(size=shape), **rest)  # pyright: ignore[reportArgumentType]


BODIES = {
    "lattice": stiff_lattice(2),
    "chain": stiff_lattice(1),
    "box": stiff_lattice(3),
    "consistent mass": consistent(stiff_lattice(2)),
    "soft lattice": soft_lattice((6, 5)),
    "soft box": soft_lattice((4, 3, 3)),
}


def random_steps(duration: float, seed: int) -> list[float]:
    """Steps of 0.5 ms to 50 ms, every decade alike."""
    rng, steps = np.random.default_rng(seed), [0.0]
    while sum(steps) < duration:
        steps.append(10.0 ** rng.uniform(-3.3, -1.3))
    return steps[1:]


@pytest.mark.parametrize("body", list(BODIES.values()), ids=list(BODIES))
@pytest.mark.parametrize("cap", [1, 3, 5])
class TestCap:
    def test_ten_seconds_of_random_steps_balance_and_stay_passive(self, body: Body, cap: int):
        """Supplied + V(0) >= V at every moment, with hands that push at random and hold moving ends."""
        rng = np.random.default_rng(cap)
        sample = 0.01 * rng.normal(size=(body.nodes, body.dimension))
        ports = [Port(1, stiffness=500.0), Port(body.nodes - 1, damping=2.0), Port(2)]
        copy = Copy(in_motion(body, springs=[Spring(80.0, sample)], ports=ports, local_damping=np.array([0.2])))

        def stored() -> float:
            gap = copy.position - sample
            return copy.energy + 0.5 * 80.0 * float(np.sum(gap * gap))

        first = stored()
        supplied, capped, missed, in_play = 0.0, 0, 0.0, first
        for T in random_steps(10.0, seed=cap):
            for port in ports:
                port.start = port.end
                port.end = np.asarray(port.end) + T * rng.normal(size=body.dimension)
                port.push = rng.normal(size=body.dimension) if port.node == 2 else 0.0
            copy.hold()
            before = copy.energy
            copy.step(T, cap=cap)
            missed = max(missed, abs(copy.energy - before - copy.gained) / (copy.turned_over + before))
            supplied += copy.ledger[SUPPLIED]
            in_play = max(in_play, copy.turned_over)
            capped += copy.iterations == cap
            assert stored() - first - supplied <= 1e-10 * in_play
        assert missed <= 1e-13
        assert first + supplied >= 0.0
        assert capped > 100

    def test_left_alone_the_energy_never_rises(self, body: Body, cap: int):
        copy = Copy(in_motion(body))
        energies = [copy.energy]
        for T in random_steps(10.0, seed=cap):
            copy.step(T, cap=cap)
            energies.append(copy.energy)
        assert max(b - a for a, b in pairwise(energies)) <= 1e-13 * energies[0]
        assert energies[-1] > 0.0


class TestConjugateGradients:
    """By steps of a body whose matrix is neither dominant nor in halves."""

    scene = in_motion(consistent(stiff_lattice(2)), springs=[Spring(50.0, np.zeros((30, 2)))])

    def solve(self, **options: float) -> tuple[Copy, np.ndarray]:
        """A copy after one step, and its mean velocity."""
        copy = Copy(self.scene)
        copy.step(0.02, **options)  # pyright: ignore[reportArgumentType]
        return copy, ((copy.position - self.scene.position) / 0.02).ravel()

    @pytest.mark.parametrize("tolerance", [0.5, 1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10])
    def test_the_residual_is_below_the_tolerance(self, tolerance: float):
        """In the norm of the inverse diagonal, relative to the right-hand side."""
        A, b = dense_system(self.scene, 0.02)
        copy, mean = self.solve(tolerance=tolerance)
        r = b - A @ mean
        assert np.sqrt(r @ (r / np.diag(A))) <= 1.001 * tolerance * np.sqrt(b @ (b / np.diag(A)))
        if tolerance >= 1e-10 and copy.iterations > 1:  # and one iteration less would not have done
            _, earlier = self.solve(tolerance=tolerance, cap=copy.iterations - 1)
            r = b - A @ earlier
            assert np.sqrt(r @ (r / np.diag(A))) > 0.999 * tolerance * np.sqrt(b @ (b / np.diag(A)))

    def test_looser_tolerances_take_fewer_iterations(self):
        counts = [self.solve(tolerance=10.0**-digits)[0].iterations for digits in range(13)]
        assert counts == sorted(counts)
        assert counts[0] <= 1
        assert counts[12] > counts[6] > counts[2] > 0

    def test_every_iteration_brings_the_solution_closer(self):
        """Conjugate gradients minimise the error in the norm of A; 60 rows need at most about 60."""
        A, b = dense_system(self.scene, 0.02)
        exact = np.linalg.solve(A, b)
        errors = []
        for cap in range(1, 25):
            copy, mean = self.solve(cap=cap)
            assert copy.iterations == cap
            errors.append((mean - exact) @ A @ (mean - exact))
            assert abs(mean @ (b - A @ mean)) <= 1e-12 * (mean @ A @ mean)  # what keeps the energy identity
        assert all(later < earlier for earlier, later in pairwise(errors))

    def test_identical_calls_give_identical_bits(self):
        a, b = self.solve()[0], self.solve()[0]
        assert np.array_equal(a.state.position, b.state.position)
        assert np.array_equal(a.ledger, b.ledger)

    @given(scenes(), periods)
    def test_never_more_iterations_than_round_off_needs(self, scene: Scene, T: float):
        copy = Copy(scene)
        copy.step(T, tolerance=1e-8)
        rows = copy.state.position.shape[0]
        assert copy.iterations <= 3 * rows + 5

    def test_a_diagonal_system_takes_none(self):
        scene = random_scene(4, nodes=1, dimension=3, full=False, springs=2, ports=2)
        copy = Copy(scene)
        copy.step(0.01, cap=1)
        assert copy.iterations == 0
        assert np.allclose(copy.position, dense_step(scene, 0.01).position, rtol=1e-12)

    def test_a_uniform_motion_of_a_free_body_takes_one(self):
        """The right-hand side is then along one eigenvector of a lattice of equal masses held nowhere."""
        scene = replace(
            self.scene, body=lattice((2, 2)), position=np.zeros((4, 2)), velocity=np.ones((4, 2)), springs=[]
        )
        copy = Copy(scene)
        copy.step(0.02, tolerance=1e-12)
        assert copy.iterations == 1


class System:
    """`(diag + off) x = b` with rows in two halves, and its solutions by the kernels."""

    def __init__(self, off: np.ndarray, diagonal: np.ndarray, *, scale: float = 1.0, split: int = 0) -> None:
        none = sp.csr_array(off.shape)
        matrices = [
            sp.csr_array(off / scale + np.diag(diagonal)),
            none,
            none,
            sp.eye_array(diagonal.size, format="csr"),
        ]
        self.op: Operator = operator_of(matrices, 1, split)
        self.A = off + np.diag(diagonal)
        self.diagonal, self.inverse, self.scale = diagonal, np.zeros(diagonal.size), scale * self.op.mix[0, 0]
        self.bound = float(invert(self.op, np.array([self.scale]), diagonal, self.inverse))

    def enough(self, tolerance: float) -> int:
        return int(chebyshev_iterations(self.op, self.bound, tolerance))

    def chebyshev(self, b: np.ndarray, iterations: int) -> np.ndarray:
        x = np.full((b.size, 1), np.nan)
        arrays = (self.op, self.op.entries[0], self.scale, self.diagonal, self.inverse, b[:, None].copy(), x)
        self.taken = chebyshev(*arrays, self.bound, iterations, (0,))
        return x[:, 0]

    def conjugate_gradients(self, b: np.ndarray, tolerance: float) -> np.ndarray:
        x, *scratch = (np.full((b.size, 1), np.nan) for _ in range(4))
        arrays = (self.op, self.op.entries[0], self.scale, self.diagonal, self.inverse, b[:, None].copy(), x, *scratch)
        self.taken = conjugate_gradients(*arrays, tolerance, 0, 10_000, (0,))
        return x[:, 0]

    def size(self, residual: np.ndarray) -> float:
        return float(np.sqrt(residual @ (residual / self.diagonal)))

    def missed(self, b: np.ndarray, x: np.ndarray) -> float:
        """Residual relative to the right-hand side."""
        return self.size(b - self.A @ x) / self.size(b)


@st.composite
def systems(draw: st.DrawFn, *, dominance: float = 0.9) -> tuple[System, np.ndarray]:
    """Random dominant systems in two halves and a right-hand side; magnitudes of rows differ by up to 10⁴."""
    rng = np.random.default_rng(draw(st.integers(0, 10**6)))
    first, second = draw(st.integers(1, 25)), draw(st.integers(1, 25))
    across = rng.normal(size=(first, second)) * (rng.random((first, second)) < draw(st.floats(0.1, 1.0)))
    across *= 10.0 ** rng.uniform(-1.0, 1.0, (first, 1)) * 10.0 ** rng.uniform(-1.0, 1.0, second)
    across[0, 0] = 1.0
    off = np.block([[np.zeros((first, first)), across], [across.T, np.zeros((second, second))]])
    most = draw(st.floats(0.01, dominance))
    beside = np.maximum(np.abs(off).sum(axis=1), 1e-2)
    diagonal = beside / np.where(rng.random(beside.size) < 0.5, most, rng.uniform(0.1, 1.0, beside.size) * most)
    scale = float(rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(-3, 3))
    return System(off, diagonal, scale=scale, split=first), rng.normal(size=beside.size)


def even_ring(nodes: int, dominance: float) -> System:
    """Every row alike, so that the bound is an eigenvalue: the hardest case for a number of iterations."""
    place = np.arange(nodes)
    neighbours = np.abs(place[:, None] - place)
    order = np.r_[place[::2], place[1::2]]
    off = np.where((neighbours == 1) | (neighbours == nodes - 1), -0.5 * dominance, 0.0)[np.ix_(order, order)]
    return System(off, np.ones(nodes), split=nodes // 2)


class TestChebyshev:
    @given(systems())
    def test_the_bound_holds_the_spectrum(self, given_system: tuple[System, np.ndarray]):
        system, _ = given_system
        root = 1.0 / np.sqrt(system.diagonal)
        spectrum = np.linalg.eigvalsh(root[:, None] * system.A * root)
        assert np.allclose(system.inverse * system.diagonal, 1.0, rtol=1e-15)
        assert spectrum[0] >= 1.0 - system.bound - 1e-12
        assert spectrum[-1] <= 1.0 + system.bound + 1e-12

    @given(systems(), st.floats(1.0, 12.0))
    def test_as_many_iterations_as_were_said_to_be_enough_are(
        self, given_system: tuple[System, np.ndarray], digits: float
    ):
        system, b = given_system
        enough = system.enough(10.0**-digits)
        if enough > 0:
            x = system.chebyshev(b, enough)
            assert system.taken == enough
            assert system.missed(b, x) <= 10.0**-digits + 1e-14

    @pytest.mark.parametrize("dominance", [0.01, 0.3, 0.62, 0.9])
    @pytest.mark.parametrize("tolerance", [1e-2, 1e-6, 1e-10])
    def test_for_the_worst_side_too_and_not_many_too_many(self, dominance: float, tolerance: float):
        system = even_ring(100, dominance)
        assert system.bound == pytest.approx(dominance, rel=1e-14)
        enough = system.enough(tolerance)
        halves = np.r_[np.ones(50), np.zeros(50)], np.r_[np.zeros(50), np.ones(50)]
        sides = [np.cos(a) * halves[0] + np.sin(a) * halves[1] for a in np.linspace(0.0, np.pi, 50)]
        sides += list(np.random.default_rng(0).normal(size=(20, 100)))
        assert max(system.missed(b, system.chebyshev(b, enough)) for b in sides) <= tolerance
        if enough > 2:
            assert max(system.missed(b, system.chebyshev(b, enough - 2)) for b in sides) > tolerance

    @given(systems())
    def test_agrees_with_a_dense_solve_and_with_conjugate_gradients(self, given_system: tuple[System, np.ndarray]):
        system, b = given_system
        exact = np.linalg.solve(system.A, b)
        energy = exact @ system.A @ exact
        for x in (system.chebyshev(b, 60), system.conjugate_gradients(b, 1e-13)):
            assert (x - exact) @ system.A @ (x - exact) <= 1e-24 * energy

    @given(systems(), st.sampled_from([1, 2, 3, 5, 40]))
    def test_any_number_of_iterations_does_no_work_on_what_it_misses(
        self, given_system: tuple[System, np.ndarray], iterations: int
    ):
        system, b = given_system
        x = system.chebyshev(b, iterations)
        assert x @ b > 0.0
        assert abs(x @ (b - system.A @ x)) <= 1e-14 * (np.abs(x) @ np.abs(system.A) @ np.abs(x))

    def test_every_iteration_brings_the_solution_closer(self):
        system = even_ring(40, 0.8)
        b = np.random.default_rng(1).normal(size=40)
        left = [system.missed(b, system.chebyshev(b, iterations)) for iterations in range(1, 20)]
        assert all(later < 0.6 * earlier for earlier, later in pairwise(left))

    def test_nothing_to_do(self):
        system = even_ring(8, 0.5)
        for size in (0.0, 1e-150, 5e-324):
            assert not np.any(system.chebyshev(np.full(8, size), 5))
            assert system.taken == 0

    @pytest.mark.parametrize("size", [1e-140, 1e-100, 1e100, 1e140])
    def test_the_size_of_the_side_does_not_matter(self, size: float):
        system, b = even_ring(8, 0.5), np.arange(8.0)
        assert np.allclose(system.chebyshev(size * b, 5), size * system.chebyshev(b, 5), rtol=1e-13)

    @pytest.mark.parametrize("place", range(8))
    def test_nan_shows(self, place: int):
        system = even_ring(8, 0.5)
        b = np.where(np.arange(8) == place, np.nan, 0.0)
        for iterations in (1, 4):
            assert np.isnan(system.chebyshev(b, iterations)[place])


class TestChoice:
    def test_more_digits_and_less_dominance_take_more(self):
        by_digits = [even_ring(100, 0.6).enough(10.0**-digits) for digits in range(13)]
        by_bound = [even_ring(100, dominance).enough(1e-6) for dominance in np.linspace(1e-7, 0.9, 10)]
        assert by_digits == sorted(by_digits)
        assert by_bound == sorted(by_bound)
        assert (by_digits[0], by_bound[0]) == (1, 1)
        assert (by_digits[6], by_bound[-1]) == (8, 18)

    @pytest.mark.parametrize(
        "system",
        [
            even_ring(100, 0.91),
            even_ring(100, 1.0),
            even_ring(100, 1.5),
            even_ring(6, 0.6),
            System(even_ring(100, 0.6).A - np.eye(100), np.ones(100)),
        ],
        ids=["weakly dominant", "singular", "not dominant", "fewer rows than iterations", "no halves"],
    )
    def test_otherwise_conjugate_gradients(self, system: System):
        assert system.enough(1e-6) == 0

    def test_a_bound_that_is_no_number(self):
        assert chebyshev_iterations(even_ring(100, 0.6).op, np.nan, 1e-6) == 0

    def step(self, body: Body, T: float, seed: int, tolerance: float = 1e-6) -> Copy:
        rng = np.random.default_rng(seed)
        shape = (body.nodes, body.dimension)
        copy = Copy(Scene(body=body, position=rng.normal(size=shape) * 10.0**-seed, velocity=rng.normal(size=shape)))
        copy.step(T, tolerance=tolerance)
        return copy

    def predicted(self, copy: Copy, tolerance: float = 1e-6) -> int:
        op, work = copy.model.operator, copy.work
        return int(chebyshev_iterations(op, invert(op, work.scale, work.diagonal, work.inverse), tolerance))

    @pytest.mark.parametrize("body", [soft_lattice((6, 5)), soft_lattice((4, 3, 3)), chain(40, stiffness=30.0)])
    def test_a_step_takes_as_many_as_its_matrix_says_however_it_moves(self, body: Body):
        for T in (1e-3, 1e-2):
            copies = [self.step(body, T, seed) for seed in range(3)]
            assert self.predicted(copies[0]) > 0
            assert {copy.iterations for copy in copies} == {self.predicted(copies[0])}

    @pytest.mark.parametrize(
        "body",
        [stiff_lattice(2), consistent(soft_lattice((6, 5))), chain(2, stiffness=3e3)],
        ids=["stiff", "dense", "small"],
    )
    def test_other_steps_take_as_many_as_conjugate_gradients(self, body: Body):
        copy = self.step(body, 0.02, 0)
        op, work = copy.model.operator, copy.work
        values = work.scale @ op.entries
        x, *scratch = (np.zeros_like(work.rhs) for _ in range(4))
        arrays = (op, values, 1.0, work.diagonal, work.inverse, work.rhs, x, *scratch)
        assert copy.iterations == conjugate_gradients(*arrays, 1e-6, 0, 10_000, copy.model.lanes)
        assert self.predicted(copy) == 0
        assert np.allclose(work.mean, x, rtol=1e-9, atol=1e-9 * np.abs(x).max())

    def test_several_families_are_bounded_together(self):
        """Dampers along every other spring only: two families on one pattern."""
        line = chain(60, stiffness=40.0, ground=[0], ground_stiffness=5.0)
        dampers = np.kron(np.eye(30), [[1.0, -1.0], [-1.0, 1.0]])
        body = Body(mass=line.mass, rest=line.rest, damping_int=dampers, stiffness_int=line.stiffness_int)
        copy = self.step(body, 0.01, 1, tolerance=1e-12)
        assert copy.model.operator.entries.shape[0] == 2
        assert copy.iterations == self.predicted(copy, 1e-12) > 0
        A, b = dense_system(copy.scene, 0.01)
        mean = (copy.position - copy.scene.position).ravel() / 0.01
        assert np.allclose(mean, np.linalg.solve(A, b), rtol=0.0, atol=1e-11 * np.abs(mean).max())

    @pytest.mark.parametrize("cap", [1, 3, 10_000])
    def test_what_the_workspace_held_does_not_matter(self, cap: int):
        clean, dirty = Copy(in_motion(soft_lattice((6, 5)))), Copy(in_motion(soft_lattice((6, 5))))
        for array in dirty.work:
            if array.dtype == np.float64:  # which rows are solved for at once is no scratch
                array[...] = np.nan
        clean.step(0.02, cap=cap)
        dirty.step(0.02, cap=cap)
        assert clean.iterations == min(cap, self.predicted(clean, 1e-15))
        assert np.array_equal(clean.position, dirty.position)
        assert np.array_equal(clean.ledger, dirty.ledger)
