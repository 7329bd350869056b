import numpy as np
import pytest

from cotouch.body import lattice, point
from cotouch.errors import NetworkError
from cotouch.mechanics import Ports, model
from cotouch.peer import NO_HEADER, ConstantLink, FreshestLink, LinkGuard, LinkHeader, LinkState, Peer, Sample


def sample(sender: int, index: int, value: float) -> Sample:
    return Sample(sender=sender, index=index, stamp=0.0, position=np.full((1, 1), value))


def peer(*, delay: int | None = None, local: float = 2.0, stiffness: float = 0.0) -> Peer:
    ready = model(point(mass=1.0, stiffness=4.0, damping=0.5), copies=2)
    initial = sample(1, -1, 0.0)
    ports = Ports(
        row=np.zeros(1, np.int32),
        shape=ready.port_shapes(np.zeros(1, np.int32)),
        stiffness=np.full(1, stiffness),
        damping=np.zeros(1),
        start=np.ones((1, 1)),
        end=np.ones((1, 1)),
        push=np.zeros((1, 1)),
        force=np.zeros((1, 1)),
    )
    return Peer(
        index=0,
        model=ready,
        links={1: FreshestLink(initial) if delay is None else ConstantLink(initial, delay)},
        strength=[30.0],
        weight=[0],
        local_damping=np.array([local]),
        extra_damping=np.array([0.1]),
        ports=ports,
        position=np.array([[0.2]]),
        velocity=np.array([[-0.1]]),
    )


def test_a_step_is_the_papers_equation() -> None:
    one = peer(stiffness=10.0)
    assert one.receive(sample(1, 0, 0.5))
    T = 0.01
    report = one.step(0.01, T)
    x, v = 0.2, -0.1
    # (1/N)[m a + b v̂ + k x̂] = -(B + B_e) v̂ - κ (x̂ - x̃) + k_h (1 - x̂), with x̂ = x + ½T v̂ and a = 2 (v̂ - v)/T
    left = 0.5 * (2 / T + 0.5 + 4 * T / 2) + 2.0 + 0.1 + 30 * T / 2 + 10 * T / 2
    right = 0.5 * (2 / T * v - 4 * x) - 30 * (x - 0.5) + 10 * (1 - x)
    mean = right / left
    assert one.state.position[0, 0] == pytest.approx(x + T * mean, rel=1e-14)
    assert one.state.velocity[0, 0] == pytest.approx(2 * mean - v, rel=1e-13)
    middle = x + T / 2 * mean
    assert report.sample.position[0, 0] == pytest.approx(middle, rel=1e-14)
    assert report.sample.stamp == pytest.approx(0.005)
    assert report.force[0, 0] == pytest.approx(10 * (1 - middle), rel=1e-13)
    assert report.supplied == pytest.approx(T * mean * 10 * (1 - middle), rel=1e-12)
    assert report.link_work[0] == pytest.approx(-T * mean * 30 * (middle - 0.5), rel=1e-12)
    assert report.local_loss == pytest.approx(T * 2.0 * mean**2, rel=1e-12)
    assert report.extra_loss == pytest.approx(T * 0.1 * mean**2, rel=1e-12)
    assert report.body_loss == pytest.approx(T * 0.25 * mean**2, rel=1e-12)
    assert abs(report.residual) < 1e-15


def test_a_sample_is_there_before_the_books() -> None:
    """`move` and `account` are the two halves of `step`, to the bit."""
    whole, halves = peer(stiffness=10.0), peer(stiffness=10.0)
    for k in range(20):
        for one in (whole, halves):
            one.receive(sample(1, k, 0.5 - 0.01 * k))
        told = halves.move(0.01 * (k + 1), 0.01)
        assert (told.index, halves.steps) == (k, k + 1)
        here, there = whole.step(0.01 * (k + 1), 0.01), halves.account()
        assert there.sample is told
        assert (told.index, told.stamp) == (here.sample.index, here.sample.stamp)
        assert np.array_equal(told.position, here.sample.position)
        assert (there.supplied, there.residual, there.kinetic) == (here.supplied, here.residual, here.kinetic)
        assert np.array_equal(there.age, here.age)
    assert np.array_equal(whole.state.position, halves.state.position)
    assert whole.integrated == halves.integrated


def test_a_peer_listens_to_its_neighbours_only() -> None:
    one = peer()
    assert not one.receive(sample(5, 0, 1.0))
    assert one.receive(sample(1, 3, 1.0))
    assert not one.receive(sample(1, 2, 1.0))


def test_a_constant_link_makes_the_peer_wait() -> None:
    one = peer(delay=2)
    for k in range(2):
        assert one.ready
        one.step(0.01 * (k + 1), 0.01)
    assert not one.ready
    one.receive(sample(1, 0, 0.3))
    assert one.ready
    one.step(0.05, 0.03)
    assert one.integrated == pytest.approx(0.05)
    assert not one.ready


def test_a_late_step_takes_longer_and_stays_balanced() -> None:
    one = peer(stiffness=200.0)
    rng = np.random.default_rng(0)
    now = 0.0
    for _ in range(500):
        T = float(rng.choice([0.001, 0.01, 0.3]))
        now += T
        report = one.step(now, T)
        assert abs(report.residual) < 1e-13
    assert one.steps == 500


def alone(
    *, stiffness: float = 4.0, damping: float = 0.5, copies: int = 2, velocity: float = 0.4, allowance: float = 0.0
) -> Peer:
    ready = model(point(mass=1.0, stiffness=stiffness, damping=damping), copies=copies)
    empty = np.zeros(0)
    return Peer(
        index=0,
        model=ready,
        links={},
        strength=[],
        weight=[],
        local_damping=np.array([0.0]),
        extra_damping=np.array([0.0]),
        ports=Ports(
            row=np.zeros(0, np.int32), shape=ready.port_shapes(np.zeros(0, np.int32)),
            stiffness=empty, damping=empty, start=np.zeros((0, 1)), end=np.zeros((0, 1)), push=np.zeros((0, 1)),
            force=np.zeros((0, 1)),
        ),
        position=np.array([[0.3]]),
        velocity=np.array([[velocity]]),
        allowance=allowance,
    )  # fmt: skip


def energy(one: Peer, *, mass: float, stiffness: float) -> float:
    return 0.5 * mass * float(one.state.velocity[0, 0]) ** 2 + 0.5 * stiffness * float(one.state.position[0, 0]) ** 2


def test_one_member_more_takes_its_share_at_once():
    one = alone()
    before = energy(one, mass=1 / 2, stiffness=4 / 2)
    one.rescale(3)
    assert one.state.velocity[0, 0] == 0.4
    report = one.step(0.01, 0.01)
    assert report.rescaled == pytest.approx(-before / 3, rel=1e-14)
    assert report.kinetic + report.elastic == pytest.approx(energy(one, mass=1 / 3, stiffness=4 / 3), rel=1e-14)
    assert abs(report.residual) < 1e-16


def test_one_member_less_keeps_momentum_and_stiffens_as_it_is_paid_for():
    one = alone()
    before = energy(one, mass=1 / 2, stiffness=4 / 2)
    one.rescale(1)
    assert one.state.velocity[0, 0] == pytest.approx(0.2, rel=1e-15)  # half as fast, twice as heavy
    assert one.stiffness_scale == 0.5
    fractions, total, lost = [], 0.0, 0.0
    for k in range(400):
        report = one.step(0.01 * (k + 1), 0.01)
        total, lost = total + report.rescaled, lost + report.body_loss
        assert abs(report.residual) < 1e-15
        # Nobody put anything in, and what changed with the shares never was more than what had been lost.
        assert report.kinetic + report.elastic <= before + 1e-15
        assert total <= lost + 1e-15
        assert report.kinetic + report.elastic == pytest.approx(
            energy(one, mass=1.0, stiffness=4.0 * one.stiffness_scale), abs=1e-15
        )
        fractions.append(one.stiffness_scale)
    assert 0.5 < fractions[0] < 1.0
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1.0


def test_without_losses_the_stiffness_waits_until_the_body_is_at_rest_shape():
    one = alone(damping=0.0, velocity=0.0)
    one.rescale(1)
    lifted = 0.0
    for k in range(200):
        report = one.step(0.01 * (k + 1), 0.01)
        lifted += report.rescaled
        assert report.kinetic + report.elastic <= 0.5 * 2.0 * 0.09 + 1e-14
    assert lifted == 0.0
    assert one.stiffness_scale == 0.5


def test_members_come_and_go_and_the_books_stay_balanced():
    rng = np.random.default_rng(0)
    body = lattice((3, 3, 2), spacing=0.1, mass=1.0, stiffness=80.0, damping=0.5, ground="all", ground_stiffness=2.0)
    ready = model(body, copies=3)
    empty, rows = np.zeros(0), (ready.operator_rows, ready.width)
    one = Peer(
        index=0,
        model=ready,
        links={},
        strength=[],
        weight=[],
        local_damping=np.array([0.0]),
        extra_damping=np.array([0.1]),
        ports=Ports(
            row=np.zeros(0, np.int32), shape=ready.port_shapes(np.zeros(0, np.int32)),
            stiffness=empty, damping=empty, start=np.zeros((0, 4)), end=np.zeros((0, 4)), push=np.zeros((0, 4)),
            force=np.zeros((0, 4)),
        ),
        position=rng.normal(size=(body.nodes, 3)) * 0.01,
        velocity=rng.normal(size=(body.nodes, 3)) * 0.1,
    )  # fmt: skip
    now, copies = 0.0, 3
    guards: dict[int, LinkGuard] = {}
    for k in range(300):
        T = float(rng.uniform(0.002, 0.02))
        now += T
        if k % 20 == 10 and len(guards) < 3:
            new = next(j for j in (1, 2, 3) if j not in guards)
            start = Sample(sender=new, index=-1, stamp=-np.inf, position=np.zeros(rows), header=NO_HEADER)
            guards[new] = LinkGuard(FreshestLink(start), budget=0.05, total=0.1, initial_energy=1.0)
            one.connect(new, guards[new], strength=30.0)
            copies += 1
            one.rescale(copies)
            one.set_local_damping(np.array([0.5 * 30.0 * 0.1 * len(guards)]))
            assert one.neighbours == tuple(guards)
        elif k % 50 == 49:
            gone = next(iter(guards))
            del guards[gone]
            one.disconnect(gone)
            one.disconnect(gone)
            copies -= 1
            one.rescale(copies)
            assert not one.receive(Sample(sender=gone, index=10**6, stamp=now, position=np.zeros(rows)))
        for j, guard in guards.items():
            place = np.zeros(rows)
            place[:, :3] = 0.02 * np.sin(3.0 * now + j)
            one.receive(
                Sample(
                    sender=j,
                    index=k,
                    stamp=now - 0.01,
                    position=place,
                    header=LinkHeader(LinkState.READY, 5, guard.epoch),
                )
            )
        report = one.step(now, T)
        assert len(report.guards) == len(guards) == report.link_work.size
        assert abs(report.residual) < 1e-12 * max(1.0, report.kinetic + report.elastic)
        for at, (guard, ledger) in enumerate(zip(guards.values(), report.guards, strict=True)):
            assert ledger == guard.ledger
            # What the spring holds after the step, by the guard's ledger and by the copy's.
            stretch = one.state.position - one._joined.ends[at].place
            held = 0.5 * 30.0 * float((ready.operator.weight[0][:, None] * stretch**2).sum())
            assert held == pytest.approx(ledger.potential - report.link_work[at], abs=1e-12)
    assert any(guard.state == LinkState.COUPLED for guard in guards.values())


def test_an_allowance_goes_evenly_to_links_that_lack_it_until_all_are_coupled():
    one = alone(velocity=0.0, allowance=0.4)
    far = [np.full((1, 1), 2.0), np.full((1, 1), -1.5)]
    guards = {j: guard_of(j) for j in (3, 4)}
    for j, guard in guards.items():
        one.connect(j, guard, strength=10.0)
    T, given, taken = 0.01, 0.0, 0.0
    for k in range(400):
        now, apart = T * (k + 1), k < 300
        for j, place in zip(guards, far, strict=True):
            shown = place if apart else one.state.position.copy()
            header = LinkHeader(LinkState.GUARDED if apart or k < 350 else LinkState.READY, 7, guards[j].epoch)
            one.receive(Sample(sender=j, index=k, stamp=now, position=shown, header=header))
        report = one.step(now, T)
        given += report.advanced
        assert report.advanced <= 0.2 * T * (1.0 + 1e-12)  # over two seconds
        assert abs(report.residual) < 1e-14
        taken = sum(guard.ledger.taken for guard in guards.values())
    assert 0.1 < given <= 0.4
    assert taken >= given
    assert all(guard.state == LinkState.COUPLED for guard in guards.values())
    before = given
    for k in range(400, 500):  # what is left then is nobody's
        now = T * (k + 1)
        for j, place in zip(guards, far, strict=True):
            one.receive(
                Sample(
                    sender=j,
                    index=k,
                    stamp=now,
                    position=place,
                    header=LinkHeader(LinkState.GUARDED, 8, guards[j].epoch),
                )
            )
        given += one.step(now, T).advanced
    assert given == before


def guard_of(j: int) -> LinkGuard:
    start = Sample(sender=j, index=-1, stamp=-np.inf, position=np.zeros((1, 1)), header=NO_HEADER)
    return LinkGuard(FreshestLink(start), budget=0.1, total=0.2)


def test_a_new_link_is_relaxed_where_the_copy_is():
    one = alone()
    start = Sample(sender=4, index=-1, stamp=-np.inf, position=np.zeros((1, 1)), header=NO_HEADER)
    one.connect(4, LinkGuard(FreshestLink(start), budget=0.1, total=0.2), strength=1e4)
    one.receive(
        Sample(sender=4, index=0, stamp=0.0, position=np.full((1, 1), 9.0), header=LinkHeader(LinkState.COUPLED, 1, 1))
    )
    report = one.step(0.01, 0.01)
    assert report.guards[0].potential == 0.0
    # Only the implicit part of the spring acts, K T/2 v̂, which is a damper.
    assert -1.0 < report.link_work[0] < 0.0


@pytest.mark.parametrize("change", [
    lambda one: one.connect(0, guard_of(1), strength=1.0),
    lambda one: one.connect(1, guard_of(1), strength=1.0),
    lambda one: one.connect(2, guard_of(1), strength=-1.0),
    lambda one: one.connect(2, guard_of(1), strength=1.0, weight=1),
    lambda one: one.set_local_damping(np.array([-1.0])),
    lambda one: one.set_local_damping(np.array([np.nan])),
    lambda one: one.set_local_damping(np.zeros(2)),
    lambda one: one.rescale(0),
])  # fmt: skip
def test_what_cannot_be_is_refused(change):
    with pytest.raises(NetworkError):
        change(peer())


def test_norms_in_a_weight_that_couples_rows_are_the_dense_ones():
    """Guarded links under every kind of weight: what the guard is told is ‖x - y‖²_W."""
    body = lattice((3, 2, 2), spacing=0.1, mass=1.0, stiffness=80.0)
    rng = np.random.default_rng(1)
    laplacian = body.stiffness / 80.0
    ready = model(body, copies=2, weights=[laplacian + 0.5 * np.eye(body.nodes)], basis="nodal")
    empty, rows = np.zeros(0), (ready.operator_rows, ready.width)
    y = np.zeros(rows)
    y[:, :3] = rng.normal(size=(body.nodes, 3))
    seen: list[tuple[float, float]] = []

    guard = LinkGuard(FreshestLink(Sample(sender=1, index=0, stamp=0.0, position=y)), initial_energy=1e9)
    decide = guard.decide
    guard.decide = lambda sample, desired, held, now, T: (  # pyright: ignore[reportAttributeAccessIssue]
        seen.append((desired, held)),
        decide(sample, desired, held, now, T),
    )[1]
    one = Peer(
        index=0, model=ready, links={1: guard}, strength=[3.0], weight=[1],
        local_damping=np.array([0.0, 1.0]), extra_damping=np.zeros(2),
        ports=Ports(
            row=np.zeros(0, np.int32), shape=ready.port_shapes(np.zeros(0, np.int32)),
            stiffness=empty, damping=empty, start=np.zeros((0, 4)), end=np.zeros((0, 4)), push=np.zeros((0, 4)),
            force=np.zeros((0, 4)),
        ),
        position=rng.normal(size=(body.nodes, 3)), velocity=rng.normal(size=(body.nodes, 3)),
    )  # fmt: skip
    W = np.asarray(laplacian + 0.5 * np.eye(body.nodes))
    for k in range(3):
        x, held = ready.to_nodes(one.state.position), ready.to_nodes(one._joined.ends[0].place)
        one.step(0.01 * (k + 1), 0.01)
        away, before = x - ready.to_nodes(y), x - held
        assert seen[k][0] == pytest.approx(np.einsum("ia,ij,ja", away, W, away), rel=1e-12)
        assert seen[k][1] == pytest.approx(np.einsum("ia,ij,ja", before, W, before), rel=1e-12, abs=1e-12)
