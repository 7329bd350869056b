"""Two planes over a bad virtual network: what a receiver holds is what the other sent, only older."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.live.support import SESSION, agree, agreements, entropy, identities, layout, planes, state_of
from tests.samples.memory import MemoryNetwork

from cotouch.body import lattice
from cotouch.errors import SessionError
from cotouch.mechanics import Ports, model
from cotouch.peer import FreshestLink, Peer, Sample
from cotouch.samples import (
    Agreement,
    Assembly,
    Identity,
    LinkAges,
    PathLaw,
    Refusal,
    SampleLink,
    SamplePlane,
    Written,
)

T = 0.002
BAD = PathLaw(delay=0.02, jitter=0.03, loss=0.3, duplication=0.2, reordering=0.5, hold=0.02)


def run(network: MemoryNetwork, users: list[SamplePlane], steps: int, first: int = 0) -> None:
    """Both send a state that tells its step and sender."""
    for k in range(first, first + steps):
        network.now = (k + 1) * T
        for plane in users:
            plane.poll(network.now)
            plane.stepped(network.now)
            state = state_of(plane.layout, 1000 * k + plane.user)
            plane.send(network.now, Sample(sender=plane.user, index=k, stamp=(k + 0.5) * T, position=state), T)


@given(
    loss=st.floats(0.0, 0.6), jitter=st.floats(0.0, 0.1),
    duplication=st.floats(0.0, 1.0), reordering=st.floats(0.0, 1.0),
    rows=st.integers(1, 150), encoding=st.sampled_from(["float64", "float32", "float16"]), seed=st.integers(0, 1000),
)  # fmt: skip
def test_what_is_held_was_sent(loss, jitter, duplication, reordering, rows, encoding, seed):
    law = PathLaw(delay=0.01, jitter=jitter, loss=loss, duplication=duplication, reordering=reordering, hold=0.03)
    shape = layout(rows, 3, encoding=encoding)
    network, users = planes(law, shape, seed=seed, rate=500.0)
    run(network, users, 60)
    for plane in users:
        link = plane.links[1 - plane.user]
        for at, step in enumerate(link.assembly.indices):
            if step >= 0:
                sent = state_of(shape, 1000 * step + 1 - plane.user)[shape.span(at)]
                held = link.assembly.state[shape.span(at)]
                assert np.abs(held - sent).max() <= shape.rounding(0.1)
                assert link.assembly.stamps[at] == (step + 0.5) * T
        assert set(link.refused) <= {Refusal.REPLAYED, Refusal.STALE}
        assert not plane.refused


def test_ages_over_a_bad_path():
    """At least the path's own delays; the same sum at both ends, up to what is still on its way."""
    network, users = planes(BAD, layout(4, 3), rate=500.0)
    run(network, users, 1000)
    sums = [plane.links[1 - plane.user].ages.worst_sum for plane in users]
    assert min(sums) >= 2 * 0.02
    assert sums[0] == pytest.approx(sums[1], rel=0.3)
    assert 2 * 0.02 <= users[0].links[1].ages.shortest_path < 0.1


def test_waiting_at_the_other_end_is_not_the_paths():
    """Who is heard rarely is told how long its stamp was held."""
    network, users = planes(PathLaw(delay=0.02), layout(4, 3), rate=500.0)
    link = users[0].links[1]
    link.ages = LinkAges(window=1e-9)  # so that every echo is looked at by itself
    paths: list[float] = []
    for k in range(0, 500, 50):
        run(network, users, 1, first=k)
        for later in range(k + 1, k + (50 if k == 0 else 21)):
            run(network, users[1:] if later < k + 21 else users, 1, first=later)  # at first only the second sends
            users[0].poll(network.now)
            paths += [] if link.ages.shortest_path is None else [link.ages.shortest_path]
    assert len(paths) > 150
    assert min(paths) >= 0.04
    assert max(paths) <= 0.04 + 3 * T


def test_a_step_knows_nothing_of_what_came_after_it_ended():
    """The process stood still between the clock and the socket: as if the sample's own future had been used."""
    network, users = planes(PathLaw(delay=0.02), layout(4, 3), rate=500.0)
    run(network, users, 100)
    link, ended = users[0].links[1], network.now
    held = link.assembly.newest
    run(network, users[1:], 50, first=100)  # meanwhile the other goes on
    users[0].poll(ended)
    users[0].stepped(ended)
    assert link.assembly.newest == held
    assert link.ages.age == pytest.approx(0.02, abs=2 * T)
    users[0].poll(network.now)  # nothing is lost
    assert link.assembly.newest >= held + 45
    users[0].stepped(network.now)
    assert link.ages.age == pytest.approx(0.02, abs=2 * T)


def test_what_is_echoed_is_the_newest_stamp():
    network, users = planes(BAD, layout(4, 3), rate=500.0)
    echoes = 0
    for k in range(200):
        run(network, users, 1, first=k)
        for plane in users:
            link = plane.links[1 - plane.user]
            sample = Sample(sender=plane.user, index=k, stamp=network.now, position=link.assembly.state)
            head = link.heading(plane.epoch, sample, T, network.now)
            echoes += head.flags & 1
            assert not head.flags & 1 or head.echo == max(link.assembly.stamps)
    assert echoes > 300


def test_there_is_no_age_before_all_rows_are_there():
    shape = layout(100, 3)
    network, users = planes(PathLaw(loss=0.5), shape, rate=500.0)
    for k in range(50):
        run(network, users, 1, first=k)
        for plane in users:
            link = plane.links[1 - plane.user]
            if not link.assembly.complete:
                assert link.ages.own is None
    assert link.ages.own is not None
    assert link.ages.own[1] < 50 * T


def test_the_loss_is_seen_by_the_sender():
    network, users = planes(PathLaw(delay=0.02, loss=0.3), layout(4, 3), rate=500.0, back=PathLaw(delay=0.02))
    run(network, users, 5000)
    assert users[0].links[1].rate.loss == pytest.approx(0.3, abs=0.12)
    assert users[1].links[0].rate.loss == 0.0


def test_both_ends_follow_one_that_moves():
    network, users = planes(PathLaw(delay=0.005), layout(4, 3), rate=500.0)
    run(network, users, 20)
    network["at 0"].move("behind another NAT")
    run(network, users, 40, first=20)
    assert [plane.links[1 - plane.user].assembly.newest for plane in users] == [56, 56]


def test_who_only_repeats_a_datagram_moves_nobody():
    network, users = planes(PathLaw(), layout(4, 3), rate=500.0)
    run(network, users, 5)
    kept: list[bytes] = []
    mallory = network.join("mallory")
    network.carry, carry = (
        (lambda sender, receiver, payload: (kept.append(payload), carry(sender, receiver, payload))),
        network.carry,
    )
    run(network, users, 5, first=5)
    network.carry = carry
    mallory.follow(0, "at 0")
    mallory.follow(1, "at 1")
    for payload in kept:
        assert mallory.send(0, payload)
        assert mallory.send(1, payload)
    run(network, users, 20, first=10)
    assert not mallory.poll()
    assert min(plane.links[1 - plane.user].assembly.newest for plane in users) >= 28


def test_a_repeated_old_datagram_of_a_lost_one_moves_nobody_either():
    """Kept from the receiver and sent later from elsewhere: it is authentic, but not the newest."""
    network, users = planes(PathLaw(), layout(4, 3), rate=500.0)
    run(network, users, 5)
    stolen: list[bytes] = []
    carry = network.carry
    network.carry = lambda sender, receiver, payload: (
        stolen.append(payload) if receiver == "at 1" else carry(sender, receiver, payload)
    )
    run(network, users, 1, first=5)
    network.carry = carry
    run(network, users, 5, first=6)
    mallory = network.join("mallory")
    mallory.follow(1, "at 1")
    mallory.send(1, stolen[0])
    users[1].poll(network.now)
    run(network, users[1:], 1, first=11)
    run(network, users, 5, first=12)
    assert users[1].links[0].refused[Refusal.STALE] == 1
    assert not mallory.poll()


def test_another_epoch_of_the_session_is_refused_and_changes_nothing():
    network, users = planes(PathLaw(), layout(4, 3), rate=500.0)
    run(network, users, 5)
    users[0].epoch = 4
    before = users[1].links[0].assembly.state.copy()
    run(network, users, 5, first=5)
    assert np.array_equal(users[1].links[0].assembly.state, before)
    assert users[1].links[0].refused[Refusal.EPOCH] == 5
    users[1].epoch = 4
    run(network, users, 5, first=10)
    assert users[1].links[0].assembly.newest == 14


def test_a_member_cannot_send_on_anothers_link():
    """Three members; the third has keys with both, and uses its own link to speak for the first."""
    shape = layout(4, 3)
    network = MemoryNetwork()
    members = sorted(identities(3), key=lambda who: who.public)
    made = [SamplePlane(network.join(f"at {user}"), shape, user=user, epoch=3) for user in range(3)]
    for i, j in ((0, 1), (1, 2), (0, 2)):
        ends = [
            Agreement(
                identity=members[a],
                other=members[b].public,
                session=SESSION,
                connection=10 * a + b,
                entropy=entropy(10 * a + b),
            )
            for a, b in ((i, j), (j, i))
        ]
        for a, b, keys in zip((i, j), (j, i), agree(*ends), strict=True):
            link = SampleLink(Assembly(shape, sender=b, initial=np.zeros((4, 4))))
            link.seal.install(keys)
            made[a].connect(b, link, at=f"at {b}")
    forger = made[2]
    forger.user = 0
    sample = Sample(sender=0, index=5, stamp=0.1, position=np.ones((4, 4)))
    forger.send(0.1, sample, T)
    network.now = 1.0
    assert made[1].poll(1.0) == 0
    assert made[1].links[2].refused == {Refusal.SENDER: 1}
    assert not made[1].links[0].assembly.state.any()


def test_a_neighbour_that_left_is_not_heard():
    network, users = planes(PathLaw(), layout(4, 3), rate=500.0)
    run(network, users, 5)
    users[1].disconnect(0)
    run(network, users, 5, first=5)
    assert users[1].refused[Refusal.CONNECTION] == 5
    users[1].disconnect(0)


def test_what_is_sent_is_reported_with_its_error():
    _, users = planes(PathLaw(), layout(4, 3, encoding="float16"), rate=500.0)
    state = state_of(users[0].layout, 1)
    sample = Sample(sender=0, index=0, stamp=0.0, position=state)
    written = users[0].send(0.0, sample, T)
    assert isinstance(written, Written)
    assert 0.0 < np.abs(written.state - state).max() == written.error[0] <= users[0].layout.rounding(0.1)
    assert users[0].send(0.0, sample, T) is None
    bad = Sample(sender=0, index=1, stamp=0.0, position=np.full((4, 4), np.nan))
    assert not users[0].unsent
    assert users[0].send(1.0, bad, T) is Refusal.STATE
    assert users[0].send(1.0, sample, T) is None
    assert users[0].unsent
    assert isinstance(users[0].send(2.0, sample, T), Written)
    assert not users[0].unsent


def test_new_keys_are_asked_for_in_time(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.samples._seal.RENEW_AFTER", 8)
    network, users = planes(PathLaw(), layout(4, 3), rate=500.0)
    run(network, users, 5)
    assert not users[1].links[0].asked
    assert users[0].links[1].seal.sealed == 5
    run(network, users, 3, first=5)
    assert not users[1].links[0].asked
    run(network, users, 2, first=8)
    assert users[1].links[0].asked


def test_keys_change_while_samples_flow():
    """No step without a sample, and the ledger of both ends begin anew."""
    shape = layout(4, 3)
    network = MemoryNetwork(law=PathLaw(delay=0.003))
    ends = agreements(*identities())
    users = []
    for user, keys in enumerate(agree(*ends)):
        plane = SamplePlane(network.join(f"at {user}"), shape, user=user, epoch=3)
        link = SampleLink(Assembly(shape, sender=1 - user, initial=np.zeros((4, 4))))
        link.seal.install(keys)
        plane.connect(1 - user, link, at=f"at {1 - user}")
        users.append(plane)
    for k in range(200):
        if k % 50 == 49:
            for plane, keys in zip(users, agree(*ends), strict=True):
                plane.links[1 - plane.user].seal.install(keys)
        run(network, users, 1, first=k)
        assert k < 5 or [plane.links[1 - plane.user].assembly.newest for plane in users] == [k - 2, k - 2]
    assert [plane.links[1 - plane.user].seal.epoch for plane in users] == [5, 5]


@pytest.mark.parametrize("make", [
    lambda plane, link: plane.connect(0, link),
    lambda plane, link: plane.connect(2, link),
    lambda plane, link: SamplePlane(MemoryNetwork().join("here"), plane.layout, user=-1),
    lambda plane, link: SamplePlane(MemoryNetwork().join("here"), plane.layout, user=0, epoch=1 << 32),
])  # fmt: skip
def test_what_cannot_be_is_refused(make):
    _, users = planes(PathLaw(), layout(4, 3))
    with pytest.raises(SessionError):
        make(users[0], users[0].links[1])


def peers(links, body, ready):
    """Two users that pull a lattice apart and let it go, with these links."""
    empty = np.zeros(0)
    for user in range(2):
        yield Peer(
            index=user,
            model=ready,
            links={1 - user: links[user]},
            strength=[40.0],
            weight=[0],
            local_damping=np.array([1.0]),
            extra_damping=np.array([0.1]),
            ports=Ports(
                row=np.zeros(0, np.int32), shape=ready.port_shapes(np.zeros(0, np.int32)),
                stiffness=empty, damping=empty, start=np.zeros((0, ready.width)), end=np.zeros((0, ready.width)),
                push=np.zeros((0, ready.width)), force=np.zeros((0, ready.width)),
            ),
            position=np.random.default_rng(user).normal(size=(body.nodes, body.dimension)) * 0.01,
            velocity=np.zeros((body.nodes, body.dimension)),
        )  # fmt: skip


def test_peers_over_the_plane_do_the_same_as_peers_that_are_handed_samples():
    """Several chunks, both directions, the same delay: the same bits."""
    body = lattice((5, 4, 4), spacing=0.05, mass=1.0, stiffness=50.0)
    ready = model(body, copies=2)
    shape = layout(ready.operator_rows, body.dimension if ready.width > 1 else 1)
    assert shape.chunks > 1
    network, users = planes(PathLaw(delay=0.005), shape, rate=500.0)
    zero = np.zeros((ready.operator_rows, ready.width))
    first = [FreshestLink(Sample(sender=1 - user, index=-1, stamp=0.0, position=zero)) for user in range(2)]
    direct = list(peers(first, body, ready))
    live = list(peers([plane.links[1 - plane.user].assembly for plane in users], body, ready))
    flying: list[tuple[float, int, Sample]] = []
    for k in range(100):
        network.now = now = (k + 1) * T
        for user in range(2):
            for due in [entry for entry in flying if entry[0] <= now and entry[1] == user]:
                flying.remove(due)
                direct[user].receive(due[2])
            users[user].poll(now)
            expected, got = direct[user].step(now, T), live[user].step(now, T)
            users[user].stepped(now)
            assert np.array_equal(expected.sample.position, got.sample.position)
            assert expected.link_work == got.link_work
            assert abs(got.residual) < 1e-14
            users[user].send(now, got.sample, T)
            flying.append((now + 0.005, 1 - user, expected.sample))
    assert live[0].state.position.any()


def test_identities_are_made_of_entropy():
    assert Identity.make(entropy(1)) == Identity.make(entropy(1)) != Identity.make(entropy(2))
