"""Running a prepared scenario one message and one peer at a time, as live peers do.

The batch engine knows every arrival beforehand; here messages travel through an event queue and each peer chooses for
itself. Both must move alike: this is the batch engine's reference, and where a peer meets a virtual network.
"""

import heapq
from copy import deepcopy
from dataclasses import dataclass, replace
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.interaction import (
    Touching,
    after_step_alone,
    before_step_alone,
    begin_lead_alone,
    end_lead_alone,
    grip,
    tools_of,
)
from cotouch.interrupt import check
from cotouch.mechanics import idle_ports, own_ports
from cotouch.peer import (
    ConstantLink,
    ContentForm,
    CopyMemory,
    Decoder,
    Encoder,
    FreshestLink,
    LawLink,
    Link,
    Peer,
    Sample,
    StepReport,
)
from cotouch.simulation._coding import age_budget
from cotouch.simulation._prepare import Prepared
from cotouch.simulation._timing import AT_ONCE


@final
@dataclass(frozen=True)
class Packet:
    """What a sender's codec makes of a sample: number of its step, its stamp and length [s], and bytes."""

    sender: int
    step: int
    stamp: float
    T: float
    data: bytes


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class PeerRun:
    """What the peers did.

    Attributes:
        position: after every step, in the model's rows, one (steps + 1, rows, width) for each user [m].
        end: when each step was taken, one (steps,) for each user [s].
        reports: of every step, for each user.
        tools: places of the proxies after every step, one (steps, tools of the user, 3) for each user [m].
        velocity: as the positions [m/s].
        encoders: what said the samples of each slot; none without a codec.
    """

    position: list[Float]
    end: list[Float]
    reports: list[list[StepReport]]
    tools: list[Float]
    velocity: list[Float]
    encoders: list[Encoder]


def run_peers(prepared: Prepared) -> PeerRun:
    """Runs a scenario peer by peer."""
    return _World(prepared).run()


@final
class _World:
    def __init__(self, prepared: Prepared) -> None:
        self.prepared = prepared
        self.timing = prepared.schedule
        users = self.timing.count.size
        self.queue: list[tuple[float, int, int, Sample | Packet]] = []  # arrival, number, receiver, sample
        self.sent = 0
        self.touching: Touching | None = deepcopy(prepared.touching)
        self.leading = deepcopy(prepared.leading)
        self.cursor = prepared.hands.path_first[:-1].copy()
        hands = prepared.hands
        self.ports = idle_ports(hands.row, hands.shape, prepared.model.width)
        self.peers = [self._peer(i) for i in range(users)]
        self.places: list[list[Float]] = [[] for _ in range(users)]
        self.position = [[peer.state.position.copy()] for peer in self.peers]
        self.velocity = [[peer.state.velocity.copy()] for peer in self.peers]
        self.end: list[list[float]] = [[] for _ in range(users)]
        self.reports: list[list[StepReport]] = [[] for _ in range(users)]
        self.encoders: list[Encoder] = []
        self.decoders: dict[tuple[int, int], Decoder] = {}
        self._code()

    def _code(self) -> None:
        """Gives every direction of a link its codec, if the channel has one."""
        prepared, slots, asked = self.prepared, self.timing.slots, self.prepared.scenario.channel.codec
        law = prepared.law
        if asked is None or law is None:
            return
        budget, longest = age_budget(prepared.scenario, self.timing, law.law, 1.0), self.timing.longest()
        form, ready = ContentForm(asked.codec, law.law), prepared.model
        rows, axes = ready.operator_rows, 1 if ready.full else ready.body.dimension
        for s, (i, j) in enumerate(slots.pairs):
            window = float(budget[i, j] + longest[i] + longest[j])
            weight = law.weight[s].reshape(rows, ready.width)[:, :axes].ravel()
            self.encoders.append(Encoder(form, weight, (rows, axes), window))
            self.decoders[i, j] = Decoder(form, (rows, axes), j, width=ready.width)

    def _peer(self, i: int) -> Peer:
        prepared, timing, hands = self.prepared, self.timing, self.prepared.hands
        ready, solver = prepared.model, prepared.scenario.solver
        slots = range(timing.slots.first[i], timing.slots.first[i + 1])
        links: dict[int, Link] = {}
        law = prepared.law
        memory = None if law is None else CopyMemory(law.law, ready.operator_rows * ready.width)
        for s in slots:
            j = int(timing.slots.sender[s])
            initial = Sample(sender=j, index=-1, stamp=0.0, position=ready.to_rows(prepared.position[j]))
            if timing.index_delay is None:
                links[j] = FreshestLink(initial)
            else:
                links[j] = ConstantLink(initial, int(timing.index_delay[i, j]))
            if law is not None and memory is not None:
                links[j] = LawLink(
                    links[j],
                    law=law.law,
                    parameters=law.parameters[s],
                    memory=memory,
                    side=int(i > j),
                    copies=timing.count.size,
                )
        return Peer(
            index=i,
            model=ready,
            links=links,
            strength=[float(prepared.topology.strength[s]) for s in slots],
            weight=[int(prepared.topology.weight[s]) for s in slots],
            local_damping=prepared.local_damping[i],
            extra_damping=prepared.extra_damping[i],
            ports=own_ports(self.ports, int(hands.first[i]), int(hands.first[i + 1])),
            position=prepared.position[i],
            velocity=prepared.velocity[i],
            surface=None if self.touching is None else self.touching.surface,
            tools=None if self.touching is None else tools_of(self.touching, i),
            contact=None if self.touching is None else self.touching.contact,
            cuts=prepared.scenario.cutting is None or prepared.scenario.cutting.may(i + 1),
            tolerance=solver.tolerance,
            iterations=solver.iterations,
        )

    def run(self) -> PeerRun:
        if self.timing.mode == "self-paced":
            self._run_self_paced()
        else:
            self._run_by_clock()
        return PeerRun(
            position=[np.array(kept) for kept in self.position],
            end=[np.array(times) for times in self.end],
            reports=self.reports,
            tools=[np.array(places) for places in self.places],
            velocity=[np.array(kept) for kept in self.velocity],
            encoders=self.encoders,
        )

    def _run_by_clock(self) -> None:
        """Everyone steps at times of their own; messages sent at an instant are seen only after it."""
        timing = self.timing
        moments = sorted({float(t) for i, n in enumerate(timing.count) for t in timing.end[i, :n]})
        following = [0] * len(self.peers)
        for now in moments:
            check()
            self._deliver(now + AT_ONCE)
            outgoing: list[Sample] = []
            for i, peer in enumerate(self.peers):
                k = following[i]
                if k < timing.count[i] and timing.end[i, k] == now:
                    outgoing.append(self._step(peer, now, float(timing.length[i, k])))
                    following[i] += 1
            for sample in outgoing:
                self._send(sample, now)

    def _run_self_paced(self) -> None:
        """A peer steps as soon as its samples are there and its own period is over."""
        scenario, timing = self.prepared.scenario, self.timing
        period = timing.nominal
        longest = timing.bound
        due = [float(period[i, 0]) for i in range(len(self.peers))]
        limit = scenario.steps.duration + 1e-9
        now = 0.0
        while now <= limit:
            check()
            self._deliver(now)
            moved = True
            while moved:  # a step may release a neighbour only through a message, but a peer may owe several steps
                moved = False
                for i, peer in enumerate(self.peers):
                    if peer.steps < period.shape[1] and now >= due[i] and peer.ready:
                        T = min(now - peer.integrated, float(longest[i]))
                        self._send(self._step(peer, now, T), now)
                        if peer.steps < period.shape[1]:
                            due[i] = now + float(period[i, peer.steps])
                        moved = True
            coming = [t for i, t in enumerate(due) if t > now and self.peers[i].steps < period.shape[1]]
            if self.queue:
                coming.append(self.queue[0][0])
            if not coming:
                break
            now = min(coming)

    def _deliver(self, now: float) -> None:
        while self.queue and self.queue[0][0] <= now:
            _, _, receiver, said = heapq.heappop(self.queue)
            if isinstance(said, Packet):
                said = self.decoders[receiver, said.sender].decode(said.step, said.stamp, said.T, said.data)
            if said is not None:
                self.peers[receiver].receive(said)

    def _send(self, sample: Sample, now: float) -> None:
        slots = self.timing.slots
        for s in np.flatnonzero(slots.sender == sample.sender):
            receiver = int(slots.receiver[s])
            told: Sample | Packet = replace(sample, message=self.peers[sample.sender].message(receiver))
            if self.encoders:
                told = self._said(int(s), told)
            if self.timing.latency is None:
                draws = self.timing.draws[s]
                arrivals = [draws.latency[sample.index], draws.second[sample.index]]
            else:
                arrivals = [self.timing.latency[s, sample.index]]
            for latency in arrivals:
                if np.isfinite(latency):
                    self.sent += 1
                    heapq.heappush(self.queue, (now + float(latency), self.sent, receiver, told))

    def _said(self, s: int, sample: Sample) -> Packet:
        j = sample.sender
        last, before = self.position[j][-1], self.position[j][-2]
        T = float(self.timing.length[j, sample.index])
        data = self.encoders[s].encode(sample, (last - before) / T, T)[0]
        return Packet(j, sample.index, sample.stamp, T, data)

    def _step(self, peer: Peer, now: float, T: float) -> Sample:
        i, hands = peer.index, self.prepared.hands
        for p in range(hands.first[i], hands.first[i + 1]):
            grip(hands, self.ports, self.cursor, p, now, T, peer.model.lanes)
        if self.touching is not None:
            before_step_alone(self.touching, i, now, T)
        if self.leading is not None:
            begin_lead_alone(self.leading, self.ports, peer.state.position, i, now, T)
        report = peer.step(now, T)
        if self.leading is not None:
            end_lead_alone(self.leading, self.ports, peer.state.position, i)
        if self.touching is not None:
            after_step_alone(self.touching, i)
            assert peer.tools is not None
            self.places[i].append(peer.tools.place[:, :3].copy())
        self.position[i].append(peer.state.position.copy())
        self.velocity[i].append(peer.state.velocity.copy())
        self.end[i].append(now)
        self.reports[i].append(report)
        return report.sample
