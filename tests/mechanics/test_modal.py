"""The modal path gives what the nodal one gives."""

from dataclasses import replace

import numpy as np
import pytest
from tests.mechanics.reference import dense_step
from tests.mechanics.support import Copy, Port, Scene, Spring

from cotouch.body import Body, chain, lattice
from cotouch.errors import UnsupportedError
from cotouch.mechanics import model


def commuting(dimension: int, *, weighted: bool = False, full: bool = False) -> Scene:
    rng = np.random.default_rng(dimension)
    body = lattice(
        (4, 3, 2)[:dimension],
        mass=2.0,
        stiffness=300.0,
        damping=0.6,
        ground="all",
        ground_stiffness=20.0,
        ground_damping=0.1,
    )
    shape = (body.nodes, dimension)

    def somewhere() -> np.ndarray:
        return rng.normal(size=shape)

    weight = np.eye(body.nodes) + 0.01 * body.stiffness_int.toarray()
    return Scene(
        body=body.as_full() if full else body,
        position=somewhere(),
        velocity=somewhere(),
        copies=3,
        weights=[weight] if weighted else [],
        springs=[Spring(40.0, somewhere()), Spring(15.0, somewhere(), int(weighted))],
        ports=[
            Port(0, stiffness=100.0, damping=1.0, push=0.3),
            Port(body.nodes - 1),  # a push alone: no gain in the system matrix
            Port(1, stiffness=50.0),
            Port(1, damping=3.0),  # a second hand on the same node
        ],
        local_damping=np.array([0.4, 0.3])[: 1 + weighted],
        extra_damping=np.array([0.1, 0.2])[: 1 + weighted],
    )


CASES = [
    pytest.param(1, False, False, id="line"),
    pytest.param(2, False, False, id="plane"),
    pytest.param(3, False, False, id="space"),
    pytest.param(2, True, False, id="weighted"),
    pytest.param(2, False, True, id="full form"),
    pytest.param(3, True, True, id="weighted full form"),
]


@pytest.mark.parametrize(("dimension", "weighted", "full"), CASES)
class TestAgainstNodal:
    def test_over_many_steps(self, dimension: int, weighted: bool, full: bool):
        scene = commuting(dimension, weighted=weighted, full=full)
        nodal, modal = Copy(scene, basis="nodal"), Copy(scene, basis="modal", others=2)
        assert (nodal.model.basis, modal.model.basis) == ("nodal", "modal")
        rng = np.random.default_rng(4)
        largest = {"position": 0.0, "velocity": 0.0, "forces": 0.0}
        ledger = 0.0
        for T in 10.0 ** rng.uniform(-4.0, 0.0, 200):
            for port in scene.ports:
                port.start = port.end
                port.end = np.asarray(port.end) + T * rng.normal(size=dimension)
            scene.ports[1].push = 5.0 * rng.normal(size=dimension)
            nodal.hold()
            modal.hold()
            before = modal.energy
            nodal.step(T)
            modal.step(T, keep_mean=True)
            assert modal.iterations == 0
            for name, size in largest.items():
                expected = getattr(nodal, name)
                largest[name] = max(size, np.abs(expected).max())
                assert np.abs(getattr(modal, name) - expected).max() <= 1e-10 * largest[name]
            ledger = max(ledger, nodal.turned_over)
            assert modal.ledger[:6] == pytest.approx(nodal.ledger[:6], abs=1e-10 * ledger)
            assert modal.links_did == pytest.approx(nodal.links_did, abs=1e-10 * ledger)
            assert abs(modal.energy - before - modal.gained) <= 1e-13 * (modal.turned_over + before)
        assert nodal.iterations > 0

    @pytest.mark.parametrize("T", [1e-4, 1e-2, 1.0])
    def test_one_step_equals_the_dense_solve(self, dimension: int, weighted: bool, full: bool, T: float):
        scene = commuting(dimension, weighted=weighted, full=full)
        for port in scene.ports:
            port.start, port.end = 0.2, -0.1
        copy, expected = Copy(scene, basis="modal"), dense_step(scene, T)
        copy.step(T, keep_mean=True)
        assert np.allclose(copy.position, expected.position, rtol=0.0, atol=1e-11)
        assert np.allclose(copy.velocity, expected.velocity, rtol=0.0, atol=1e-10 * np.abs(expected.velocity).max())
        assert np.allclose(copy.mean_position, expected.mean_position, rtol=0.0, atol=1e-11)
        assert np.allclose(copy.forces, expected.forces, rtol=0.0, atol=1e-10 * np.abs(expected.forces).max())


class TestPorts:
    """Dense ports are a low-rank change of a diagonal system."""

    def test_no_gain_at_all(self):
        scene = replace(commuting(2), ports=[Port(0, push=1.0), Port(5, push=np.array([0.0, -2.0]))])
        copy, expected = Copy(scene, basis="modal"), dense_step(scene, 0.01)
        copy.step(0.01)
        assert np.allclose(copy.velocity, expected.velocity, rtol=0.0, atol=1e-12)

    @pytest.mark.parametrize("gain", [1e-6, 1.0, 1e6, 1e9])
    def test_soft_and_stiff_hands(self, gain: float):
        ports = [Port(node, stiffness=gain, damping=gain / 100, end=0.1) for node in (0, 3, 11)]
        scene = replace(commuting(2), ports=ports)
        copy, expected = Copy(scene, basis="modal"), dense_step(scene, 0.01)
        copy.step(0.01)
        assert np.allclose(copy.velocity, expected.velocity, rtol=0.0, atol=1e-8 * np.abs(expected.velocity).max())

    def test_a_hand_on_every_node(self):
        scene = commuting(2)
        scene = replace(scene, ports=[Port(node, 10.0 * node, 1.0, 0.0, 0.1) for node in range(scene.body.nodes)])
        copy, expected = Copy(scene, basis="modal"), dense_step(scene, 0.01)
        copy.step(0.01)
        assert np.allclose(copy.velocity, expected.velocity, rtol=0.0, atol=1e-11)
        assert np.allclose(copy.forces, expected.forces, rtol=0.0, atol=1e-9)


class TestChoice:
    def test_auto_takes_modes_where_everything_commutes(self):
        scene = commuting(2, weighted=True)
        assert model(scene.body, weights=scene.weights).basis == "modal"

    def test_auto_stays_nodal_where_something_does_not(self):
        assert model(chain(4, ground=[0], ground_stiffness=1.0, damping=1.0)).basis == "nodal"
        assert model(chain(4), weights=[np.diag([1.0, 2.0, 3.0, 4.0])]).basis == "nodal"

    def test_auto_stays_nodal_where_everything_is_diagonal(self):
        assert model(chain(4, stiffness=0.0, ground="all", ground_stiffness=3.0)).basis == "nodal"

    def test_auto_stays_nodal_where_modes_would_not_pay(self):
        assert model(chain(256)).basis == "modal"
        assert model(chain(257)).basis == "nodal"

    def test_repeated_eigenvalues_are_split_by_the_other_matrices(self):
        """K alone leaves the eigenspaces of a square open; B chooses within them."""
        ring = np.eye(6) * 2 - np.roll(np.eye(6), 1, axis=0) - np.roll(np.eye(6), -1, axis=0)
        second = np.eye(6) * 2 - np.roll(np.eye(6), 2, axis=0) - np.roll(np.eye(6), -2, axis=0)
        flip = np.eye(6)[::-1] + np.eye(6)
        body = Body(mass=np.eye(6), rest=np.arange(6), stiffness_int=ring, damping_int=second)
        assert model(body, weights=[flip + 0.1 * np.eye(6)], basis="modal").basis == "modal"

    @pytest.mark.parametrize(
        ("body", "weights", "named"),
        [
            (chain(4, ground=[0], ground_stiffness=1.0, damping=1.0), [], "damping"),
            (chain(4), [np.diag([1.0, 2.0, 3.0, 4.0])], "link weight 1"),
            (
                Body(mass=np.diag([1.0, 2.0]), rest=[0.0, 1.0], stiffness_int=[[1.0, -1.0], [-1.0, 1.0]]),
                [],
                "the identity link weight",
            ),
        ],
    )
    def test_modal_by_name_where_there_is_no_common_basis(self, body: Body, weights: list[np.ndarray], named: str):
        message = r'^basis is "modal", but .+ is not diagonal in the basis.*; use "nodal" or "auto"$'
        with pytest.raises(UnsupportedError, match=message) as caught:
            model(body, weights=weights, basis="modal")
        assert any(name in str(caught.value) for name in (named, "stiffness"))
