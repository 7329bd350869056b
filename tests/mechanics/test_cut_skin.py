"""Faces that open, and what the world and other bodies meet after a cut."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
import scipy.sparse as sp
from tests.mechanics.materials import Alone, bent, made
from tests.recording.inside import Outside, RecordedMaterial

from cotouch.body import Body, Placed, together, with_faces
from cotouch.mechanics import (
    BETA,
    CUT,
    KINETIC,
    WORLD_STORED,
    Between,
    Box,
    Cutting,
    Obstacle,
    Plane,
    Solid,
    State,
    begin_cut,
    cutting_of,
    decide_cuts,
    sever,
)

Float = npt.NDArray[np.float64]
H = 0.01
TABLE = Obstacle(shape=Plane(point=(0.0, 0.0, 0.0), normal=(0.0, 0.0, 1.0)), stiffness=1e6, loss=5.0, friction=0.4)
CORNERS = np.array([[x, y, z] for x in (-0.02, 0.04) for y in (-0.02, 0.04) for z in (-0.03, 0.0)])
SIDES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
TRIANGLES = np.array([t for a, b, c, d in SIDES for t in ((a, b, c), (a, c, d))])
SLAB = replace(TABLE, shape=Solid(CORNERS, TRIANGLES))


def cutting(copy: Alone) -> Cutting:
    found = cutting_of(copy.model)
    assert found is not None
    return found


def cut(copy: Alone, what: Cutting, elements: npt.NDArray[np.intp]) -> float:
    """Takes elements away; returns the energy that went, of which the ledger must know."""
    before = copy.energy
    begin_cut(what, copy.force.world, copy.state, None)
    what.wanted[elements] = 1
    sever(what, copy.model.operator, copy.force, copy.state, 0, copy.ledger, copy.model.lanes)
    assert before - copy.energy == pytest.approx(float(copy.ledger[CUT]), rel=1e-12, abs=1e-18)
    begin_cut(what, copy.force.world, copy.state, None)
    return float(copy.ledger[CUT])


def run(copy: Alone, steps: int, T: float = 1e-3) -> None:
    """Steps that balance; the ledger's lost energy is in its second place."""
    for _ in range(steps):
        energy = copy.energy
        ledger = copy.step(T)
        size = max(abs(energy), abs(copy.energy), 1e-6)  # of what comes and goes in a step, where they are near 0
        assert copy.energy - energy + ledger[1] == pytest.approx(0.0, abs=1e-12 * size)


# With a mesh far below, which it never meets, one body is stepped by the machine code of several.
FAR = replace(SLAB, shape=Solid(CORNERS - [0.0, 0.0, 1e3], TRIANGLES))


def heavy(block: Body) -> Body:
    """That can be cut."""
    return together([Placed(body=block, name="block")]).with_cutting().with_gravity((0.0, 0.0, -9.81))


def middles(body: Body) -> Float:
    material = body.material
    assert material is not None
    return body.rest[material.elements].mean(axis=1)


class TestFaces:
    def test_energy_falls_by_what_the_ties_held(self) -> None:
        body = with_faces(made("cells", viscosity=1e-3).with_cutting())
        rng = np.random.default_rng(4)
        copy = Alone(body, bent(body, 0.3), rng.normal(scale=0.05, size=body.rest.shape), copies=2)
        run(copy, 5)
        material, place = body.material, copy.position
        assert material is not None
        chosen = rng.choice(body.cut_count, body.cut_count // 3, replace=False)
        gap = place[material.faces[:, 4:]] - place[material.faces[:, :4]]
        held = 0.5 * material.ties * (gap**2).sum(axis=(1, 2))
        assert cut(copy, cutting(copy), chosen) == pytest.approx(0.5 * held[chosen].sum(), rel=1e-12)
        run(copy, 20)

    def test_cut_through_both_halves_fly_on(self) -> None:
        body = with_faces(made("cells", viscosity=1e-3, shape=(5, 3, 3)).with_cutting())
        material = body.material
        assert material is not None
        half = middles(body)[:, 0] > 0.02
        right = np.isin(np.arange(body.nodes), material.elements[half])
        speed = np.zeros((body.nodes, 3))
        speed[right, 0], speed[~right, 0] = 0.5, -0.5
        for through in (True, False):
            copy = Alone(body, None, speed)
            between = half[material.sides[:, 0]] != half[material.sides[:, 1]]
            assert between.sum() == 4
            assert cut(copy, cutting(copy), np.flatnonzero(between)[0 if through else 1 :]) == 0.0
            run(copy, 20)
            if through:
                assert np.abs(copy.velocity - speed).max() < 1e-9
                assert np.abs(copy.position - 0.02 * speed).max() < 1e-11
            else:  # one face holds them
                assert np.abs(copy.velocity - speed).max() > 0.1

    def test_what_one_half_does_the_other_does_not_feel(self) -> None:
        """One half is stretched and rings, the other rests: neither forces nor the matrix of directions join them."""
        body = with_faces(made("cells", viscosity=1e-3, shape=(5, 3, 3)).with_cutting())
        material = body.material
        assert material is not None
        half = middles(body)[:, 0] > 0.02
        right = np.isin(np.arange(body.nodes), material.elements[half])
        stretched = np.where(right[:, None], 0.1 * (body.rest - body.rest[right].mean(axis=0)), 0.0)
        copy = Alone(body, stretched)
        begun = copy.energy
        what, factor = cutting(copy), 0.0
        cut(copy, what, np.flatnonzero(half[material.sides[:, 0]] != half[material.sides[:, 1]]))
        for _ in range(50):
            begin_cut(what, None, copy.state, None)
            factor = max(factor, float(copy.step(1e-3)[BETA]))
        assert factor < 1e-3
        # A coarse solve leaves some of each half's momentum; only that of both is put right.
        assert np.abs(copy.position[~right]).max() < 1e-3 * np.abs(copy.position[right] - stretched[right]).max()
        assert copy.energy < 0.9 * begun  # it rang

    def test_copies_that_share_a_matrix_each_have_it_as_they_were_cut(self) -> None:
        body = with_faces(made("corotated", viscosity=1e-3).with_cutting())
        first = Alone(body, bent(body, 0.3))
        what, op, memory = cutting(first), first.model.operator, first.state.memory
        whole, rng = op.entries.copy(), np.random.default_rng(3)
        other = State(*(np.zeros_like(first.state.position) for _ in range(4)), memory.copy())
        cut(first, what, rng.choice(body.cut_count, body.cut_count // 2, replace=False))
        begin_cut(what, None, first.state, None)
        halved, taken = op.entries.copy(), op.taken.copy()
        assert np.count_nonzero(halved) < np.count_nonzero(whole)
        beside = sp.csr_array((whole[0] - halved[0], op.column, op.pointer), shape=(op.mass.size, op.mass.size))
        assert taken[0] == pytest.approx(beside.sum(axis=1), rel=1e-12)
        begin_cut(cutting(first), None, other, None)  # as another peer of the process has it
        assert np.array_equal(op.entries, whole)
        assert not op.taken.any()
        begin_cut(what, None, first.state, None)
        assert np.array_equal(op.entries, halved)
        assert np.array_equal(op.taken, taken)

    def test_a_blade_opens_what_it_goes_between_and_a_pull_what_bears_less(self) -> None:
        """Stretched by 4 % along x: E times that across each face of that direction, nothing across the others."""
        body = with_faces(made("cells").with_cutting())
        material, count = body.material, body.cut_count
        assert material is not None
        across = np.abs(np.diff(middles(body)[material.sides], axis=1)[:, 0, 0]) > 1e-6
        pull = 0.04 * 1e4
        for strength, breaks in ((0.9 * pull, True), (1.1 * pull, False), (np.inf, False)):
            own = with_faces(made("cells").with_cutting(strength=strength))
            x = np.zeros((body.nodes, 3))
            x[:, 0] = 0.04 * body.rest[:, 0]
            gap = pull * H * H / 4.0 / float(material.ties[0])  # of each tie's share of a face
            column = np.round(middles(body)[:, 0] / H - 0.5)
            x[material.elements, 0] += gap * column[:, None]
            copy = Alone(own, x)
            what = cutting(copy)
            decide_cuts(what, copy.state.memory, copy.state.position, None, 1, True)
            assert np.array_equal(what.wanted != 0, across if breaks else np.zeros(count, dtype=np.bool_))


class TestWorld:
    def test_it_comes_to_lie_on_what_is_left(self) -> None:
        """Without its lowest layer a block falls by a layer's height, onto the faces that came to light."""
        block = made("cells", viscosity=2e-3, shape=(3, 3, 4))
        body = heavy(block)
        copy = Alone(body, obstacles=[TABLE, FAR], between=Between())
        run(copy, 60)
        what, high = cutting(copy), body.rest[:, 2] > 0.5 * H
        before = copy.position[high, 2].mean()
        cut(copy, what, np.flatnonzero(middles(block)[:, 2] < H))
        run(copy, 250)
        fallen = before - copy.position[high, 2].mean()
        assert fallen == pytest.approx(H, rel=0.05)
        assert np.abs(copy.velocity[high]).max() < 0.02

    def test_what_comes_to_light_within_something_gives_no_energy(self) -> None:
        """A bar is sunk in soft ground; whatever is cut, nothing holds more, nor does it a moment later."""
        ground = Obstacle(shape=Plane(point=(0.0, 0.0, 0.012), normal=(0.0, 0.0, 1.0)), stiffness=2e5, friction=0.5)
        body = heavy(made("cells", viscosity=1e-3, shape=(5, 3, 3)))
        most = 0.0
        for seed in range(3):
            rng = np.random.default_rng(seed)
            copy = Alone(body, obstacles=[ground, TABLE, FAR], between=Between())
            what, world = cutting(copy), copy.force.world
            assert world is not None
            run(copy, 4)
            for _ in range(4):
                energy, held = copy.energy, float(copy.ledger[WORLD_STORED])
                gone = cut(copy, what, rng.choice(body.cut_count, 3, replace=False))
                booked, count = float(copy.ledger[WORLD_STORED]), world.told.shape[0]
                assert gone >= 0.0
                assert copy.energy <= energy
                assert booked <= held
                offsets = copy.state.memory[world.offset + count : world.offset + 2 * count]
                kept_out = 2e5 * ((world.area * world.there) * offsets[: world.area.size] ** 2).sum() / 2.0
                most = max(most, kept_out / booked) if booked > 0.0 else most
                run(copy, 1, T=1e-7)
                assert float(copy.ledger[WORLD_STORED]) <= 1.001 * booked  # friction that slips may hold less
                run(copy, 4)
        assert most > 0.01  # what inner faces would have held that came to light deep in it

    def test_an_audit_finds_what_was_booked(self) -> None:
        """From places alone: what obstacles hold after each step and its cuts, and what went with these."""
        block = Obstacle(shape=Box(size=(0.1, 0.1, 0.02), centre=(0.0, 0.0, -0.009)), stiffness=1e6, friction=0.5)
        body = heavy(made("cells", viscosity=1e-3, shape=(5, 3, 3)))
        copy, rng = Alone(body, obstacles=[block, TABLE, FAR], between=Between()), np.random.default_rng(5)
        what, steps, T = cutting(copy), 24, 1e-3
        when = np.full(body.cut_count, np.inf)
        when[rng.choice(body.cut_count, 6, replace=False)] = 7, 7, 7, 15, 15, 16
        places, held, gone = [copy.position], np.zeros(steps), np.zeros(steps)
        for step in range(steps):
            begin_cut(what, copy.force.world, copy.state, None)
            copy.step(T)
            what.wanted[when == step] = 1
            moving = copy.ledger[KINETIC]
            sever(what, copy.model.operator, copy.force, copy.state, step, copy.ledger, copy.model.lanes)
            places.append(copy.position)
            stopped = moving - copy.ledger[KINETIC]  # what nodes moved with that lost their last element
            held[step], gone[step] = copy.ledger[WORLD_STORED], copy.ledger[CUT] - stopped
        assert (gone > 0.0).sum() == 3
        first = np.arange(steps) == 0
        start, after = np.array(places[:-1]), np.array(places[1:])
        told, material = Outside(np.full(steps, np.nan), *np.zeros((3, steps))), RecordedMaterial.of(copy.model)
        index = {"index": np.arange(steps, dtype=np.float64), "when": when}
        found = material.outside(start, after, np.full(steps, T), told, fresh=first, follows=~first, user=0, **index)
        assert found.after == pytest.approx(held, rel=1e-9, abs=1e-15)
        _, _, _, inner = material.energies(start, after, (after - start) / T, **index)
        assert inner + found.cut == pytest.approx(gone, rel=1e-9, abs=1e-13)
        assert found.cut.max() > 0.0

    @pytest.mark.parametrize("table", [TABLE, SLAB], ids=["plane", "mesh"])
    def test_another_body_sinks_into_the_hole(self, table: Obstacle) -> None:
        """Two blocks lie on each other; where the lower one's upper layer goes, the upper one comes down by as much."""
        block = made("cells", viscosity=2e-3, shape=(3, 3, 3))
        pair = together([Placed(body=block, name="low"), Placed(body=block, name="high", at=(H, H, 3.0 * H))])
        body = pair.with_cutting().with_gravity((0.0, 0.0, -9.81))
        copy = Alone(body, obstacles=[table], between=Between(stiffness=1e6, loss=5.0, friction=0.4))
        run(copy, 60)
        what, n = cutting(copy), block.nodes
        before = copy.position[n:, 2].mean()
        low = np.concatenate([middles(block)[:, 2], np.full(8, -1.0)])
        cut(copy, what, np.flatnonzero(low > H))
        run(copy, 250)
        assert before - copy.position[n:, 2].mean() == pytest.approx(H, rel=0.1)
        kept = block.rest[:, 2] < 1.5 * H
        assert np.abs(copy.position[:n][kept, 2]).max() < 1e-3
