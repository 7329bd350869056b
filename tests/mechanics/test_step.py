"""One step against the energy identity, a dense solve written from the theory, and closed forms."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tests.mechanics.reference import dense_step, energies, held_energy, matrices
from tests.mechanics.support import Copy, Port, Scene, Spring, periods, random_scene, scenes
from tests.thorough import examples

from cotouch.body import Body, chain, point
from cotouch.mechanics import BODY_LOSS, ELASTIC, EXTRA_LOSS, KINETIC, LOCAL_LOSS, SUPPLIED, Basis, State

ROUND_OFF = 1e-13


def residual(copy: Copy, before: float, held: float) -> float:
    """How far the last step missed `E⁺ - E = T(v̂ᵀ(u + f) - v̂ᵀ(B/N)v̂)`, relative to the energies in play.

    Args:
        copy: after the step.
        before: its energy E.
        held: energy in what holds it, at the start.
    """
    return abs(copy.energy - before - copy.gained) / (copy.turned_over + before + held)


class TestEnergyIdentity:
    @given(scenes(), st.lists(periods, min_size=1, max_size=4), st.sampled_from([1, 2, 10_000]))
    @example(random_scene(2765, nodes=1, dimension=1, full=False, ports=2, damped=False), [1.0], 1)
    @settings(max_examples=examples(80))
    def test_holds_to_round_off_for_every_body_and_step_length(self, scene: Scene, Ts: list[float], cap: int):
        copy = Copy(scene)
        for T in Ts:
            before, held = copy.energy, held_energy(scene, copy.position, copy.velocity, T)
            copy.step(T, cap=cap)
            assert residual(copy, before, held) <= ROUND_OFF

    @given(scenes(), periods)
    def test_every_entry_of_the_books_is_what_it_says(self, scene: Scene, T: float):
        copy = Copy(scene)
        before = copy.energy
        assert before == pytest.approx(sum(energies(scene, scene.position, scene.velocity)), rel=1e-12)
        copy.step(T, keep_mean=True)
        mean = (copy.position - scene.position) / T
        exact = dense_step(scene, T)
        size = copy.turned_over + before
        for index, value in [
            (SUPPLIED, exact.supplied),
            (BODY_LOSS, exact.body_loss),
            (LOCAL_LOSS, exact.local_loss),
            (EXTRA_LOSS, exact.extra_loss),
            (KINETIC, exact.kinetic),
            (ELASTIC, exact.elastic),
        ]:
            assert copy.ledger[index] == pytest.approx(value, rel=1e-11, abs=1e-12 * size)
        assert copy.links_did == pytest.approx(exact.links_did, rel=1e-11, abs=1e-12 * size)
        # The energies belong to the state that came out, and the losses are losses.
        assert (copy.ledger[KINETIC], copy.ledger[ELASTIC]) == pytest.approx(
            energies(scene, copy.position, copy.velocity), rel=1e-12, abs=1e-13 * size
        )
        assert np.all(copy.ledger[[BODY_LOSS, LOCAL_LOSS, EXTRA_LOSS]] >= 0.0)
        assert np.allclose(copy.velocity, 2.0 * mean - scene.velocity, rtol=1e-9, atol=1e-9 * np.abs(mean).max())


class TestDenseSolve:
    @given(scenes(), periods)
    @settings(max_examples=examples(80))
    def test_every_body(self, scene: Scene, T: float):
        agrees(scene, T)

    @pytest.mark.parametrize(("dimension", "full", "T"), [(1, True, 1e-2), (2, False, 1.0), (3, False, 1e-3)])
    def test_more_rows_than_a_block_and_every_kind_of_family(self, dimension: int, full: bool, T: float):
        """B is not a multiple of K, M has entries off its diagonal, weights have a pattern of their own."""
        kinds = ["node"] if dimension == 1 else ["axes", "full"]
        scene = random_scene(7, nodes=70, dimension=dimension, full=full, copies=3, weights=kinds, springs=5, ports=6)
        agrees(scene, T)

    def test_families_that_are_multiples_of_each_other(self):
        body = chain(9, mass=3.0, stiffness=200.0, damping=0.7, dimension=3, ground=[2], ground_stiffness=50.0)
        weight = 2.0 * np.eye(9) + body.stiffness_int.toarray() / 400.0
        rng = np.random.default_rng(3)
        scene = Scene(
            body=Body(
                mass=body.mass + 1e-4 * body.stiffness_int,
                rest=body.rest,
                damping_int=body.damping_int,
                stiffness_int=body.stiffness_int,
                stiffness_ext=body.stiffness_ext,
            ),
            position=rng.normal(size=(9, 3)),
            velocity=rng.normal(size=(9, 3)),
            weights=[weight],
            springs=[Spring(30.0, rng.normal(size=(9, 3)), weight=1), Spring(4.0, rng.normal(size=(9, 3)))],
            local_damping=np.array([0.5, 2.0]),
        )
        copy = agrees(scene, 1e-2)
        assert copy.model.operator.entries.shape[0] == 1

    @given(scenes(), periods)
    def test_keeps_tension_momentum_and_sample(self, scene: Scene, T: float):
        copy = Copy(scene)
        M, _, K, _ = matrices(scene)
        for _ in range(2):
            x, v = copy.position.ravel(), copy.velocity.ravel()
            tension, momentum = copy.model.to_nodes(copy.state.tension), copy.model.to_nodes(copy.state.momentum)
            scale = np.abs(K).sum() * np.abs(x).max()
            assert np.allclose(tension.ravel() / scene.copies, K @ x, rtol=0.0, atol=1e-13 * scale)
            if np.any(copy.model.operator.mix[0]):
                scale = np.abs(M).sum() * np.abs(v).max()
                assert np.allclose(momentum.ravel() / scene.copies, M @ v, rtol=0.0, atol=1e-13 * scale)
            before, others = copy.position, copy.links.samples[: copy.mean_slot].copy()
            copy.step(T, keep_mean=True)
            assert np.allclose(copy.mean_position, 0.5 * (before + copy.position), rtol=1e-9, atol=1e-12)
            assert np.array_equal(copy.links.samples[: copy.mean_slot], others, equal_nan=True)

    def test_no_sample_is_kept_unless_asked_for(self):
        copy = Copy(random_scene(1, nodes=3, dimension=2, full=False, springs=2))
        before = copy.links.samples.copy()
        copy.step(1e-2)
        assert np.array_equal(copy.links.samples, before, equal_nan=True)


def agrees(scene: Scene, T: float) -> Copy:
    """Steps a copy and compares with the dense solve to 1e-10."""
    copy, exact = Copy(scene), dense_step(scene, T)
    copy.step(T, keep_mean=True)
    for found, expected in [
        (copy.position, exact.position),
        (copy.velocity, exact.velocity),
        (copy.mean_position, exact.mean_position),
        (copy.forces, exact.forces),
    ]:
        assert np.abs(found - expected).max(initial=0.0) <= 1e-10 * np.abs(expected).max(initial=0.0)
    return copy


class TestArraysOfManyUsers:
    @given(scenes(springs=3, ports=3), periods, st.integers(1, 3))
    def test_only_this_copys_entries_are_read_and_written(self, scene: Scene, T: float, others: int):
        alone, among = Copy(scene), Copy(scene, others=others)
        alone.step(T)
        among.step(T)
        assert np.array_equal(among.position, alone.position)
        assert np.array_equal(among.velocity, alone.velocity)
        assert np.array_equal(among.links_did, alone.links_did)
        assert np.array_equal(among.forces, alone.forces)
        for written in (among.all_link_work, among.all_ports.force):
            assert np.isnan(written[:others]).all()
            assert np.isnan(written[-others:]).all()


class TestWorkspace:
    @given(scenes(), periods, st.sampled_from([np.nan, np.inf, -7.0]), st.sampled_from([1, 2, 10_000]))
    def test_what_it_held_before_does_not_matter(self, scene: Scene, T: float, garbage: float, cap: int):
        """No warm start: the energy identity needs the solver to begin at zero."""
        clean, dirty = Copy(scene), Copy(scene)
        for array in dirty.work:
            if array.dtype == np.float64:  # which rows are solved for at once is no scratch
                array[...] = garbage
        clean.step(T, cap=cap)
        dirty.step(T, cap=cap)
        same(clean, dirty)

    @given(scenes(), periods)
    def test_nor_does_the_solution_of_another_step(self, scene: Scene, T: float):
        clean, used = Copy(scene), Copy(scene)
        used.step(0.3 * T)
        for array, fresh in zip(used.state, Copy(scene).state, strict=True):
            array[...] = fresh
        used.settle()
        clean.step(T, cap=2)
        used.step(T, cap=2)
        same(clean, used)


def same(a: Copy, b: Copy) -> None:
    """Equal to the last bit."""
    for left, right in zip(
        (*a.state, a.ledger, a.links_did, a.forces), (*b.state, b.ledger, b.links_did, b.forces), strict=True
    ):
        assert np.array_equal(left, right)


class TestPoint:
    """One node: the scalar closed form."""

    @given(
        mass=st.floats(1e-3, 1e3),
        damping=st.floats(0.0, 1e3),
        stiffness=st.floats(0.0, 1e6),
        x=st.floats(-1.0, 1.0),
        v=st.floats(-10.0, 10.0),
        springs=st.lists(st.tuples(st.floats(0.0, 1e5), st.floats(-1.0, 1.0)), max_size=3),
        local=st.floats(0.0, 1e3),
        extra=st.floats(0.0, 1e2),
        hand=st.tuples(st.floats(0.0, 1e5), st.floats(0.0, 1e3), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)),
        push=st.floats(-100.0, 100.0),
        T=periods,
        copies=st.integers(1, 8),
    )
    def test_scalar_formula(
        self,
        mass: float,
        damping: float,
        stiffness: float,
        x: float,
        v: float,
        springs: list[tuple[float, float]],
        local: float,
        extra: float,
        hand: tuple[float, float, float, float],
        push: float,
        T: float,
        copies: int,
    ):
        m, b, k = mass / copies, damping / copies, stiffness / copies
        k_hand, b_hand, r, r_next = hand
        pull = sum(k_ij * (sample - x) for k_ij, sample in springs)
        top = 2 * m * v / T - k * x + pull + k_hand * ((r + r_next) / 2 - x) + b_hand * (r_next - r) / T + push
        stiff = k + sum(k_ij for k_ij, _ in springs) + k_hand
        mean = top / (2 * m / T + b + local + extra + b_hand + T / 2 * stiff)

        scene = Scene(
            body=point(mass=mass, damping=damping, stiffness=stiffness),
            position=np.array([[x]]),
            velocity=np.array([[v]]),
            copies=copies,
            springs=[Spring(k_ij, np.array([[sample]])) for k_ij, sample in springs],
            ports=[Port(0, k_hand, b_hand, r, r_next, push)],
            local_damping=np.array([local]),
            extra_damping=np.array([extra]),
        )
        copy = Copy(scene, basis="auto")
        copy.step(T)
        # Terms of opposite sign may cancel: round-off is measured by their sizes.
        terms = abs(2 * m * v / T) + (k + k_hand) * abs(x) + sum(k_ij * (abs(s) + abs(x)) for k_ij, s in springs)
        terms += k_hand * (abs(r) + abs(r_next)) + b_hand * (abs(r) + abs(r_next)) / T + abs(push)
        slack = 1e-14 * terms / (2 * m / T + b + local + extra + b_hand + T / 2 * stiff) + 1e-300
        assert copy.velocity[0, 0] == pytest.approx(2 * mean - v, rel=1e-13, abs=4 * slack + 1e-15 * abs(v))
        assert copy.position[0, 0] == pytest.approx(x + T * mean, rel=1e-13, abs=2 * T * slack)
        assert copy.iterations == 0

    def test_by_hand(self):
        """m = 2, k = 8, T = 1, from x = 1 at rest: v̂ = -8 / (4 + 4) = -1."""
        copy = Copy(Scene(body=point(mass=2.0, stiffness=8.0), position=np.ones((1, 1)), velocity=np.zeros((1, 1))))
        copy.step(1.0)
        assert (copy.position.item(), copy.velocity.item()) == (0.0, -2.0)
        assert (copy.ledger[KINETIC], copy.ledger[ELASTIC]) == (4.0, 0.0)


class TestCopies:
    @given(scenes(springs=0), st.lists(periods, min_size=1, max_size=5), st.integers(2, 8))
    def test_in_step_they_move_like_one_object_with_the_whole_force(self, scene: Scene, Ts: list[float], copies: int):
        """Each of N copies carries 1/N of the body, the controls and the hands."""
        whole = replace(scene, copies=1)
        part = replace(
            whole,
            copies=copies,
            ports=[
                replace(
                    port,
                    stiffness=port.stiffness / copies,
                    damping=port.damping / copies,
                    push=np.asarray(port.push) / copies,
                )
                for port in scene.ports
            ],
            local_damping=scene.local_damping / copies,
            extra_damping=scene.extra_damping / copies,
        )
        one, each = Copy(whole), Copy(part)
        for T in Ts:
            one.step(T)
            each.step(T)
            for field in ("position", "velocity"):
                expected = getattr(one, field)
                assert np.allclose(getattr(each, field), expected, rtol=0.0, atol=1e-10 * np.abs(expected).max())
            assert copies * each.forces == pytest.approx(
                one.forces, rel=1e-8, abs=1e-9 * np.abs(one.forces).max(initial=0)
            )
            assert copies * each.ledger[:6] == pytest.approx(one.ledger[:6], rel=1e-8, abs=1e-9 * one.turned_over)

    def test_springs_between_copies_in_step_do_nothing(self):
        """K_ij (x̂_i - x̂_j) = 0 where the sample is one's own mean position."""
        rng = np.random.default_rng(0)
        free = Scene(
            body=chain(5, dimension=2, damping=0.3), position=rng.normal(size=(5, 2)), velocity=rng.normal(size=(5, 2))
        )
        alone = Copy(free)
        alone.step(1e-2, keep_mean=True)
        together = Copy(replace(free, springs=[Spring(500.0, alone.mean_position), Spring(90.0, alone.mean_position)]))
        together.step(1e-2)
        assert np.allclose(together.position, alone.position, rtol=0.0, atol=1e-12)
        assert np.allclose(together.links_did, 0.0, atol=1e-11)


class TestWidths:
    """One axis runs on one lane; two and three axes on four, padded."""

    def scene(self, dimension: int, *, springs: int = 2) -> Scene:
        """The same random motion on every axis."""
        rng = np.random.default_rng(5)

        def column(rows: int = 80) -> np.ndarray:
            return np.repeat(rng.normal(size=(rows, 1)), dimension, axis=1)

        body = chain(80, stiffness=900.0, damping=0.4, dimension=dimension, ground=[0], ground_stiffness=10.0)
        weight = np.eye(80) + 0.2 * (np.eye(80, k=1) + np.eye(80, k=-1))
        return Scene(
            body=body,
            position=column(),
            velocity=column(),
            weights=[weight],
            springs=[Spring(40.0 + index, column(), weight=index % 2) for index in range(springs)],
            ports=[Port(3, 70.0, 2.0, 0.1, 0.2, 0.5), Port(79, 0.0, 0.0, push=-1.0)],
            local_damping=np.array([0.3, 0.4]),
            extra_damping=np.array([0.1, 0.0]),
        )

    @pytest.mark.parametrize("dimension", [2, 3])
    def test_every_axis_moves_as_on_a_line(self, dimension: int):
        line, space = Copy(self.scene(1)), Copy(self.scene(dimension))
        assert (line.model.width, space.model.width) == (1, 4)
        for T in (1e-3, 2e-2, 5e-3, 0.3):
            line.step(T)
            space.step(T)
            for field in ("position", "velocity"):
                expected = getattr(line, field)
                assert np.allclose(getattr(space, field), expected, rtol=0.0, atol=1e-11 * np.abs(expected).max())
                assert np.ptp(getattr(space, field), axis=1).max() == 0.0
            assert space.ledger[:6] == pytest.approx(dimension * line.ledger[:6], rel=1e-10)

    @pytest.mark.parametrize("dimension", [2, 3])
    def test_axes_do_not_mix(self, dimension: int):
        """Node form: what happens on one axis leaves the others at rest."""
        scene = self.scene(dimension)
        only = np.eye(dimension)[dimension - 1]
        for spring in scene.springs:
            spring.sample = spring.sample * only
        scene = replace(scene, position=scene.position * only, velocity=scene.velocity * only)
        scene.ports = [
            replace(port, start=port.start * only, end=port.end * only, push=port.push * only) for port in scene.ports
        ]
        copy = Copy(scene)
        for T in (1e-3, 0.3):
            copy.step(T)
        assert np.abs(copy.position[:, -1]).min() > 0.0
        assert not np.any(copy.position[:, :-1])
        assert not np.any(copy.velocity[:, :-1])

    @given(seed=st.integers(0, 1000), nodes=st.integers(1, 5), T=periods)
    @example(seed=0, nodes=70, T=1e-2)
    def test_node_and_full_form_agree(self, seed: int, nodes: int, T: float):
        scene = random_scene(seed, nodes=nodes, dimension=2, full=False, springs=2, ports=3)
        node, full = Copy(scene), Copy(replace(scene, body=scene.body.as_full()))
        assert (node.model.width, full.model.width) == (4, 1)
        node.step(T)
        full.step(T)
        for field in ("position", "velocity", "forces"):
            expected = getattr(node, field)
            assert np.allclose(getattr(full, field), expected, rtol=0.0, atol=1e-10 * np.abs(expected).max())
        assert full.ledger[:6] == pytest.approx(node.ledger[:6], rel=1e-9, abs=1e-11 * node.turned_over)

    @pytest.mark.parametrize("basis", ["nodal", "modal"])
    @pytest.mark.parametrize("dimension", [2, 3])
    def test_padded_lanes_stay_zero(self, dimension: int, basis: Basis):
        scene = random_scene(0, nodes=6, dimension=dimension, full=False, springs=2, ports=4)
        if basis == "modal":
            scene = replace(scene, body=chain(6, damping=0.1, dimension=dimension))
        copy = Copy(scene, basis=basis)
        for T in (1e-3, 2e-2, 0.3):
            copy.step(T, keep_mean=True)
        for array in (*copy.state[:4], copy.links.samples[copy.mean_slot], copy.ports.force, copy.work.mean):
            assert array.shape[-1] == 4
            assert not np.any(array[..., dimension:])


class TestRest:
    @pytest.mark.parametrize("dimension", [1, 2, 3])
    def test_nothing_moves_without_force(self, dimension: int):
        scene = Scene(
            body=chain(4, damping=0.1, dimension=dimension),
            position=np.zeros((4, dimension)),
            velocity=np.zeros((4, dimension)),
        )
        copy = Copy(scene)
        copy.step(1e-2)
        assert not any(np.any(array) for array in copy.state)
        assert not np.any(copy.ledger)

    def test_the_last_of_a_motion_is_not_a_nan(self):
        """Amplitudes whose squares underflow."""
        for size in (1e-140, 1e-160, 1e-300, 5e-324):
            scene = Scene(body=chain(4), position=size * np.eye(4)[:, :1], velocity=np.zeros((4, 1)))
            copy = Copy(scene)
            for _ in range(3):
                copy.step(1e-2)
            assert np.isfinite(copy.position).all()
            assert np.abs(copy.position).max() <= 2 * size

    def test_a_whole_translation_costs_no_force(self):
        scene = Scene(body=chain(6, dimension=2), position=np.full((6, 2), 0.25), velocity=np.full((6, 2), 2.0))
        copy = Copy(scene)
        copy.step(0.5)
        assert np.allclose(copy.position, 1.25, rtol=1e-14)
        assert np.allclose(copy.velocity, 2.0, rtol=1e-13)

    @pytest.mark.parametrize("place", ["position", "velocity"])
    def test_nan_stays_visible(self, place: str):
        scene = random_scene(2, nodes=4, dimension=1, full=False)
        getattr(scene, place)[2, 0] = np.nan
        copy = Copy(scene)
        copy.step(1e-2)
        assert np.isnan(copy.energy)

    @pytest.mark.parametrize("basis", ["nodal", "modal"])
    def test_nan_from_outside_shows_in_the_balance(self, basis: Basis):
        """A hand or a sample that is no number must not pass for a step that balances."""
        still = Scene(body=chain(4), position=np.zeros((4, 1)), velocity=np.ones((4, 1)))
        pushed = replace(still, ports=[Port(1, push=np.nan)])
        pulled = replace(still, springs=[Spring(3.0, np.array([[0.0], [np.nan], [0.0], [0.0]]))])
        for scene in (pushed, pulled):
            copy = Copy(scene, basis=basis)
            before = copy.energy
            copy.step(1e-2)
            assert np.isnan(copy.energy - before - copy.gained)

    def test_state_is_changed_in_place(self):
        copy = Copy(random_scene(2, nodes=4, dimension=1, full=False))
        arrays: State = copy.state
        before = arrays.position.copy()
        copy.step(1e-2)
        assert copy.state.position is arrays.position
        assert not np.array_equal(arrays.position, before)
