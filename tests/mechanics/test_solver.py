"""Conjugate gradients: a cap costs accuracy, never passivity; a tolerance is kept."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from tests.mechanics.reference import dense_step, dense_system
from tests.mechanics.support import Copy, Port, Scene, Spring, periods, random_scene, scenes

from cotouch.body import Body, lattice
from cotouch.mechanics import SUPPLIED


def stiff_lattice(dimension: int = 2) -> Body:
    """Springs far stiffer than a step resolves: about 60 iterations to round-off."""
    return lattice((6, 5, 3)[:dimension], stiffness=3e4, damping=0.5, ground="x-", ground_stiffness=200.0)


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
            supplied += copy.books[SUPPLIED]
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


class TestAccuracy:
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
        assert np.array_equal(a.books, b.books)

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
