"""Real peers on a virtual clock, recorded: who steps when, what arrives when, what hands do, is decided here."""

import heapq
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from cotouch.body import Body, point
from cotouch.mechanics import Model, Ports, model
from cotouch.peer import FreshestLink, Link, Peer, Sample, StepReport
from cotouch.recording import RecordedBody, Recorder, RecordHeader

Float = npt.NDArray[np.float64]
Change = Callable[[int, StepReport], StepReport]
Hand = Callable[[Peer, float, float], None]


def pulled(amplitude: float = 0.1, stiffness: float = 40.0, damping: float = 0.4) -> Hand:
    """A spring to a place that moves."""

    def hand(peer: Peer, now: float, T: float) -> None:
        ports = peer.ports
        ports.stiffness[:] = stiffness
        ports.damping[:] = damping
        ports.start[:, 0] = amplitude * np.sin(7.0 * (now - T)) * (now > T)
        ports.end[:, 0] = amplitude * np.sin(7.0 * now)

    return hand


@dataclass
class Driven:
    """Some users around a table; `run` records each into a file of `folder`.

    `damping` None is what the age rule asks for these delays and periods. `change` alters what is recorded, never what
    is done; `disturb` alters the peer before its step, `deliver` what arrives at a receiver.
    """

    folder: Path
    delay: Float = field(default_factory=lambda: np.array([[0.0, 0.05], [0.03, 0.0]]))
    spring: float = 60.0
    periods: Sequence[float] = (0.004, 0.01)
    seconds: float = 1.0
    body: Body = field(default_factory=lambda: point(mass=1.0, stiffness=4.0, damping=0.5))
    hands: dict[int, Hand] = field(default_factory=lambda: {0: pulled()})
    damping: Sequence[float] | None = None
    clocks: Sequence[float] = (0.0, 0.0, 0.0, 0.0, 0.0)
    unix_error: Sequence[float] = (0.0, 0.0, 0.0, 0.0, 0.0)
    change: Change | None = None
    disturb: Callable[[Peer, float], None] | None = None
    deliver: Callable[[int, Sample], Sample] | None = None
    link_state: Callable[[int, float], Sequence[int]] | None = None
    with_used: bool = False
    options: dict[str, Any] = field(default_factory=dict)
    rename: Callable[[int], str] = lambda user: ("Ann", "Ben", "Cyd", "Dot", "Eve")[user]

    def __post_init__(self) -> None:
        self.users = len(self.periods)
        self.model: Model = model(self.body, copies=self.users)
        self.recorders: list[Recorder] = []
        self.links: list[dict[int, Link]] = [{} for _ in range(self.users)]
        self.reports: list[list[StepReport]] = [[] for _ in range(self.users)]
        self.states: list[list[tuple[Float, Float]]] = [[] for _ in range(self.users)]

    def neighbours(self, user: int) -> list[int]:
        return [j for j in range(self.users) if j != user and np.isfinite(self.delay[user, j])]

    def bound(self, user: int, other: int) -> float:
        """The most that a sample may be old: its way, a step of each, and half of one."""
        return float(self.delay[user, other]) + self.periods[user] + 1.5 * self.periods[other]

    def local(self, user: int) -> float:
        if self.damping is not None:
            return self.damping[user]
        sums = [self.bound(user, j) + self.bound(j, user) for j in self.neighbours(user)]
        return 0.5 * self.spring * sum(sums)

    def peer(self, user: int) -> Peer:
        ready, width = self.model, self.model.width
        rows = ready.port_rows(0)
        ports = rows.size
        links = self.links[user] = {
            j: FreshestLink(Sample(sender=j, index=-1, stamp=self.clocks[j], position=zeros_like(ready)))
            for j in self.neighbours(user)
        }
        return Peer(
            index=user,
            model=ready,
            links=links,
            strength=[self.spring] * len(links),
            weight=[0] * len(links),
            local_damping=np.array([self.local(user)]),
            extra_damping=np.array([0.1]),
            ports=Ports(
                row=rows,
                shape=ready.port_shapes(rows),
                stiffness=np.zeros(ports),
                damping=np.zeros(ports),
                start=np.zeros((ports, width)),
                end=np.zeros((ports, width)),
                push=np.zeros((ports, width)),
                force=np.zeros((ports, width)),
            ),
            position=np.zeros((self.body.nodes, self.body.dimension)),
            velocity=np.zeros((self.body.nodes, self.body.dimension)),
        )

    def recorder(self, user: int, peer: Peer) -> Recorder:
        header = RecordHeader(
            user=user,
            name=self.rename(user),
            session="table",
            body=RecordedBody.of(self.model),
            monotonic=self.clocks[user],
            unix=1e9 + self.unix_error[user],
            configuration={"title": "a test"},
        )
        recorder = Recorder(self.path(user), header, **{"buffers": 64, **self.options})  # time runs faster than disks
        axes = self.body.dimension
        recorder.setup(
            self.clocks[user],
            copies=self.users,
            neighbours=peer.neighbours,
            strength=[self.spring] * len(peer.neighbours),
            local_damping=[self.local(user)],
            extra_damping=[0.1],
            ports=[0] * (axes if self.model.full else 1),
        )
        return recorder

    def path(self, user: int) -> Path:
        return self.folder / f"{self.rename(user)}.mcap"

    def paths(self) -> list[Path]:
        return [self.path(user) for user in range(self.users)]

    def run(self) -> list[Path]:
        """Steps, sends and records until the time is over; returns the files."""
        peers = [self.peer(user) for user in range(self.users)]
        recorders = self.recorders = [self.recorder(user, peer) for user, peer in enumerate(peers)]
        queue: list[tuple[float, int, int, Sample]] = []
        steps = sorted(
            (k * period, user)
            for user, period in enumerate(self.periods)
            for k in range(1, int(self.seconds / period) + 1)
        )
        sent = 0
        for now, user in steps:
            peer, own = peers[user], now + self.clocks[user]
            while queue and queue[0][0] < now:
                _, _, receiver, sample = heapq.heappop(queue)
                peers[receiver].receive(sample if self.deliver is None else self.deliver(receiver, sample))
            if user in self.hands:
                self.hands[user](peer, now, self.periods[user])
            if self.disturb is not None:
                self.disturb(peer, now)
            used = [link.choose(peer.steps).index for link in self.links[user].values()]
            report = peer.step(own, self.periods[user])
            self.reports[user].append(report)
            self.states[user].append((peer.state.position.copy(), peer.state.velocity.copy()))
            shown = report if self.change is None else self.change(user, report)
            recorders[user].step(
                shown,
                end=own,
                T=self.periods[user],
                state=peer.state,
                used=used if self.with_used else None,
                link_state=None if self.link_state is None else self.link_state(user, now),
            )
            for j in self.neighbours(user):
                sent += 1
                heapq.heappush(queue, (now + self.delay[j, user], sent, j, report.sample))
        for recorder in recorders:
            done = recorder.close()
            assert done.failure is None
        return self.paths()


def zeros_like(ready: Model) -> Float:
    return np.zeros((ready.operator_rows, ready.width))
