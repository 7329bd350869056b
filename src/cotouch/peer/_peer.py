"""One user's replica: samples in, sample and books out; time is handed to it, and it opens nothing."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.mechanics import (
    BODY_LOSS,
    BOOKS,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    PROXY,
    SUPPLIED,
    TOUCH_BOOKS,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    Grips,
    Links,
    Model,
    State,
    Surface,
    Tools,
    settle,
    step,
    touch_step,
    touch_work,
    workspace,
)
from cotouch.peer._links import Link, Sample

Float = npt.NDArray[np.float64]


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Report:
    """What one step did.

    Attributes:
        sample: what the neighbours should be told.
        force: mean force of the step at every port, (ports, width) [N].
        supplied: work done at the ports [J].
        body_loss: dissipated by the body's own dampers [J].
        local_loss: by the damping B_i of the synchronisation [J].
        extra_loss: by the extra damping B_e [J].
        link_work: work that each link did on the copy, in the order of `Peer.neighbours` [J].
        kinetic: energy after the step [J].
        elastic: energy after the step [J].
        drive_work: work done on the proxies by what pulls them [J].
        touch_work: work done on the body by contacts and grasps [J].
        touch_loss: dissipated in contacts and grasps [J].
        proxy: kinetic energy of the proxies after the step [J].
        touch_stored: energy in contacts and grasps after the step [J].
        residual: what the books of this step do not explain [J]; round-off, or something is broken.
        age: of each link's sample at the end of the step, by the clocks as they are [s].
        iterations: of the solver.
    """

    sample: Sample
    force: Float
    supplied: float
    body_loss: float
    local_loss: float
    extra_loss: float
    link_work: Float
    kinetic: float
    elastic: float
    drive_work: float
    touch_work: float
    touch_loss: float
    proxy: float
    touch_stored: float
    residual: float
    age: Float
    iterations: int


@final
class Peer:
    """One user's copy of the shared object and its links.

    Use it in three steps: `receive` whatever arrived, write into `grips` and `tools` what the hands do, `step`; then
    send `report.sample` to every neighbour.

    Attributes:
        index: of the user.
        model: the body.
        neighbours: users it is linked to, in the order of their links.
        state: position and velocity.
        grips: what holds the copy; written by the owner before each step.
        tools: the proxies, likewise; None without.
        steps: number of steps taken, so the index of the next one.
        integrated: sum of all T so far [s].
    """

    def __init__(
        self,
        *,
        index: int,
        model: Model,
        links: Mapping[int, Link],
        strength: Sequence[float],
        weight: Sequence[int],
        local_damping: Float,
        extra_damping: Float,
        grips: Grips,
        position: Float,
        velocity: Float,
        surface: Surface | None = None,
        tools: Tools | None = None,
        tolerance: float = 1e-10,
        iterations: int = 500,
    ) -> None:
        """Sets the copy up.

        Args:
            index: of the user.
            model: the body, one for the session.
            links: for each neighbour, how its samples are chosen.
            strength: spring of each link [N/m for the identity weight].
            weight: index of each link's weight among the model's.
            local_damping: B_i as coefficients over the weights, (weights,) [Ns/m].
            extra_damping: B_e likewise.
            grips: the ports.
            position: initial displacement from rest, (n, d) [m].
            velocity: initial velocity, (n, d) [m/s].
            surface: the body's skin (`cotouch.mechanics.surface_of`); with tools.
            tools: the user's proxies.
            tolerance: of the solver.
            iterations: cap of the solver.
        """
        rows, width = model.operator_rows, model.width
        self.index = index
        self.model = model
        self.neighbours = tuple(links)
        self.steps = 0
        self.integrated = 0.0
        self.grips = grips
        self.state = State(
            model.to_rows(position), model.to_rows(velocity), np.zeros((rows, width)), np.zeros((rows, width))
        )
        self._sources = tuple(links.values())
        count = len(self._sources)
        self._links = Links(
            first=0,
            last=count,
            strength=np.asarray(strength, dtype=np.float64),
            weight=np.asarray(weight, dtype=np.int32),
            slot=np.arange(count, dtype=np.int64),
            samples=np.zeros((count + 1, rows, width)),  # the last one receives this peer's own sample
        )
        self._local = np.ascontiguousarray(local_damping, dtype=np.float64)
        self._extra = np.ascontiguousarray(extra_damping, dtype=np.float64)
        self._work = workspace(model.operator, width, grips.last - grips.first)
        self._books = np.zeros(BOOKS)
        self._link_work = np.zeros(count)
        self._tolerance = tolerance
        self._iterations = iterations
        self.tools = tools
        self._surface = surface
        self._touch = None
        self._touch_books = np.zeros(TOUCH_BOOKS)
        settle(model.operator, self.state, self._books, model.lanes)
        self._energy = float(self._books[KINETIC] + self._books[ELASTIC])
        if tools is not None:
            if surface is None:
                raise ValueError("tools are given without a surface; make one of the model with surface_of")
            ports = grips.last - grips.first
            self._touch = touch_work(model, surface, tools=tools.last - tools.first, ports=ports)
            own = slice(tools.first, tools.last)
            self._energy += 0.5 * float(tools.mass[own] @ (tools.rate[own] ** 2).sum(axis=1))
            self._energy += float(tools.account[own].sum() + tools.grip_energy[own].sum())

    @property
    def ready(self) -> bool:
        """Whether every link has what the next step needs."""
        return all(source.ready(self.steps) for source in self._sources)

    def receive(self, sample: Sample) -> bool:
        """Takes a sample that arrived; False if it was of no use, or not from a neighbour."""
        try:
            source = self._sources[self.neighbours.index(sample.sender)]
        except ValueError:
            return False
        return source.offer(sample)

    def step(self, now: float, T: float) -> Report:
        """Takes the step that ends now and lasted T.

        Args:
            now: time on this peer's clock [s].
            T: length of the step, > 0 [s].
        """
        model, links, books = self.model, self._links, self._books
        age = np.zeros(len(self._sources))
        for at, source in enumerate(self._sources):
            sample = source.choose(self.steps)
            links.samples[at] = sample.position
            age[at] = now - sample.stamp
        own = len(self._sources)
        touched = self._touch_books
        if self.tools is None or self._surface is None or self._touch is None:
            step(
                model.operator,
                self.state,
                links,
                self.grips,
                self._local,
                self._extra,
                T,
                own,
                self._work,
                books,
                self._link_work,
                self._tolerance,
                self._iterations,
                model.lanes,
            )
        else:
            touch_step(
                model.operator,
                self.state,
                links,
                self.grips,
                self._surface,
                self.tools,
                self._local,
                self._extra,
                T,
                own,
                self._work,
                self._touch,
                books,
                touched,
                self._link_work,
                self._tolerance,
                self._iterations,
                model.lanes,
            )
        energy = float(books[KINETIC] + books[ELASTIC] + touched[PROXY] + touched[TOUCH_STORED])
        lost = float(books[BODY_LOSS] + books[LOCAL_LOSS] + books[EXTRA_LOSS] + touched[TOUCH_LOSS])
        supplied = float(books[SUPPLIED] + touched[DRIVE])
        report = Report(
            sample=Sample(sender=self.index, index=self.steps, stamp=now - 0.5 * T, position=links.samples[own].copy()),
            force=self.grips.force[self.grips.first : self.grips.last].copy(),
            supplied=float(books[SUPPLIED]),
            body_loss=float(books[BODY_LOSS]),
            local_loss=float(books[LOCAL_LOSS]),
            extra_loss=float(books[EXTRA_LOSS]),
            link_work=self._link_work.copy(),
            kinetic=float(books[KINETIC]),
            elastic=float(books[ELASTIC]),
            drive_work=float(touched[DRIVE]),
            touch_work=float(touched[TOUCHED]),
            touch_loss=float(touched[TOUCH_LOSS]),
            proxy=float(touched[PROXY]),
            touch_stored=float(touched[TOUCH_STORED]),
            residual=energy - self._energy - supplied + lost - float(self._link_work.sum()),
            age=age,
            iterations=int(books[ITERATIONS]),
        )
        self._energy = energy
        self.steps += 1
        self.integrated += T
        return report
