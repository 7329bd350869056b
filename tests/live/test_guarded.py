"""Guarded peers over the sample plane: outages, one way and both, and everybody's ledger afterwards."""

import numpy as np
import pytest
from tests.live.support import layout, planes

from cotouch.body import lattice
from cotouch.mechanics import Ports, model
from cotouch.peer import LinkGuard, LinkState, Peer, StepReport
from cotouch.samples import PathLaw

T = 0.004
STRENGTH = 40.0
CUT = PathLaw(loss=1.0)


def session(law: PathLaw, *, encoding: str = "float64", budget: float = 0.06, tank: float = 1e-3):
    """Two users, a lattice of several chunks, a hand each."""
    body = lattice((5, 4, 4), spacing=0.05, mass=1.0, stiffness=80.0, damping=0.2)
    ready = model(body, copies=2, basis="nodal")
    shape = layout(ready.operator_rows, 3, encoding=encoding)
    assert shape.chunks > 1 or encoding != "float64"
    network, users = planes(law, shape, rate=1 / T)
    made: list[Peer] = []
    for user, plane in enumerate(users):
        link = plane.links[1 - user]
        rounding = shape.rounding(0.25) * (3 * shape.rows) ** 0.5
        link.guard = LinkGuard(
            link.assembly, budget=budget, total=2 * budget, initial_energy=tank, cap=1.0, rounding=rounding
        )
        ports = ready.port_rows(40 if user else 3)
        made.append(
            Peer(
                index=user, model=ready, links={1 - user: link.guard}, strength=[STRENGTH], weight=[0],
                local_damping=np.array([0.5 * STRENGTH * 2 * budget]), extra_damping=np.array([0.0]),
                ports=Ports(
                    row=ports, shape=ready.port_shapes(ports), stiffness=np.full(1, 60.0),
                    damping=np.full(1, 0.5), start=np.zeros((1, 4)), end=np.zeros((1, 4)), push=np.zeros((1, 4)),
                    force=np.zeros((1, 4)),
                ),
                position=np.zeros((body.nodes, 3)), velocity=np.zeros((body.nodes, 3)),
            )
        )  # fmt: skip
    return network, users, made


def hand(user: int, now: float) -> np.ndarray:
    still = now > 1.6
    out = np.zeros((1, 4))
    out[0, :3] = 0.0 if still else 0.1 * np.sin([3.0 * now, 5.0 * now + user, 2.0 * now])
    return out


def run(network, users, made, *, seconds: float, cuts=()) -> list[list[StepReport]]:
    reports: list[list[StepReport]] = [[], []]
    for k in range(int(seconds / T)):
        network.now = now = (k + 1) * T
        for when, sender, receiver, law in cuts:
            if when <= now < when + T:
                network.set(f"at {sender}", f"at {receiver}", law)
        for user, (plane, peer) in enumerate(zip(users, made, strict=True)):
            plane.poll(now)
            peer.ports.start[:] = peer.ports.end
            peer.ports.end[:] = hand(user, now)
            report = peer.step(now, T)
            plane.stepped(now)
            plane.send(now, report.sample, T)
            reports[user].append(report)
    return reports


PATH = PathLaw(delay=0.01, jitter=0.005, loss=0.1)
CUTS = {
    "both": [(1.0, 0, 1, CUT), (1.0, 1, 0, CUT), (2.0, 0, 1, PATH), (2.0, 1, 0, PATH)],
    "one way": [(1.0, 0, 1, CUT), (2.0, 0, 1, PATH)],
    "the other way, for long": [(0.5, 1, 0, CUT), (2.2, 1, 0, PATH)],
}


@pytest.mark.parametrize("encoding", ["float64", "float32"])
@pytest.mark.parametrize("cut", CUTS)
def test_outages(cut: str, encoding: str):
    network, users, made = session(PATH, encoding=encoding)
    reports = run(network, users, made, seconds=4.0, cuts=CUTS[cut])
    stored = supplied = 0.0
    for peer, kept in zip(made, reports, strict=True):
        supplied += sum(report.supplied for report in kept)
        most = max(report.kinetic + report.elastic for report in kept)
        assert max(abs(report.residual) for report in kept) < 1e-12 * most
        guard = users[peer.index].links[1 - peer.index].guard
        assert guard is not None
        assert guard.state == LinkState.COUPLED
        states = [event.state for event in guard.events]
        assert states.count(LinkState.COUPLED) >= 2
        assert states.count(LinkState.GUARDED) >= 1
        assert all(report.guards[0].tank >= -1e-9 for report in kept)
        assert max(float(np.abs(report.force).max()) for report in kept) < 60.0 * 0.4
        stored += kept[-1].kinetic + kept[-1].elastic
    assert supplied >= stored - 2e-3 > -2e-3
    apart = made[0].state.position - made[1].state.position
    assert float(np.abs(apart).max()) < 2e-3  # together again


def test_words_travel_with_every_datagram():
    network, users, made = session(PathLaw(delay=0.01))
    run(network, users, made, seconds=0.4)
    for plane in users:
        link = plane.links[1 - plane.user]
        assert link.guard is not None
        assert link.assembly.header[:3] == (LinkState.COUPLED, 1, 1)
        assert link.guard.header[:3] == (LinkState.COUPLED, 1, 1)


def test_half_precision_is_paid_for():
    network, users, made = session(PATH, encoding="float16", budget=0.08, tank=0.02)
    reports = run(network, users, made, seconds=3.0)
    assert any(report.guards[0].state == LinkState.COUPLED for report in reports[0])
    for kept in reports:
        assert kept[-1].guards[0].tank >= -1e-3
        assert max(abs(report.residual) for report in kept) < 1e-13
    supplied = sum(report.supplied for kept in reports for report in kept)
    assert supplied >= -2 * 0.02
