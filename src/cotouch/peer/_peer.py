"""One user's replica: samples in, sample and a ledger out; time is handed to it, and it opens nothing."""

from collections.abc import Mapping, Sequence
from typing import Any, final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.mechanics import (
    BODY_LOSS,
    CUT,
    DRIVE,
    ELASTIC,
    EXTRA_LOSS,
    KINETIC,
    LEDGER_COLUMNS,
    LOCAL_LOSS,
    PROXY,
    SUPPLIED,
    TOUCH_LEDGER,
    TOUCH_LOSS,
    TOUCH_STORED,
    Contact,
    Model,
    Ports,
    State,
    Surface,
    Tools,
    approach,
    are_apart,
    closed_settle,
    closed_step,
    closing_of,
    contact_parts,
    contact_step,
    jammed_about,
    mixed_stretch,
    move_apart,
    push_of,
    settle,
    step,
    stretches,
    unsettled,
)
from cotouch.peer._allowance import Allowance
from cotouch.peer._cuts import CutSet
from cotouch.peer._guard import LinkGuard
from cotouch.peer._joined import JoinedLinks, LinkEnd
from cotouch.peer._law_link import LawLink
from cotouch.peer._links import Link, Message, Sample
from cotouch.peer._report import StepReport, books_of
from cotouch.peer._scale import CopyScale


@final
class Peer:
    """One user's copy of the shared object and its links.

    Use it in three steps: `receive` whatever arrived, write into `ports` and `tools` what the hands do, `step`; then
    send `report.sample` to every neighbour. What a link's guard says goes with it: its `header`.

    Links come and go between steps, and so does the share that the copy has of the body. A newcomer starts at rest with
    guarded links, at a place that nobody tells it. What it takes to come to where the others are, its links get of an
    `Allowance`, as they need it and evenly over two seconds at the fastest, until all of them are coupled.

    Attributes:
        index: of the user.
        model: the body.
        state: position and velocity.
        ports: what holds the copy; written by the owner before each step.
        tools: the proxies, likewise; None without.
        cuts: what was cut of it; None of a body that cannot be cut.
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
        ports: Ports,
        position: Float,
        velocity: Float,
        allowance: float = 0.0,
        surface: Surface | None = None,
        tools: Tools | None = None,
        contact: Contact | None = None,
        cuts: bool = True,
        tolerance: float = 1e-10,
        iterations: int = 500,
    ) -> None:
        """Sets the copy up.

        Args:
            index: of the user.
            model: the body, one for the session.
            links: for each neighbour, how its samples are chosen; a `LinkGuard` starts relaxed, where the copy is.
            strength: spring of each link [N/m for the identity weight].
            weight: index of each link's weight among the model's.
            local_damping: B_i as coefficients over the weights, (weights,) [Ns/m].
            extra_damping: B_e likewise.
            ports: the ports.
            position: initial displacement from rest, (n, d) [m].
            velocity: initial velocity, (n, d) [m/s].
            allowance: energy that its links may get once, to come to where the others are, >= 0 [J].
            surface: the body's skin (`cotouch.mechanics.surface_of`); with tools.
            tools: the user's proxies.
            contact: the law by which they touch, and scratch; with tools.
            cuts: whether it may cut by itself, where the body can be cut.
            tolerance: of the solver.
            iterations: cap of the solver.
        """
        rows, width = model.operator_rows, model.width
        self.index = index
        self.model = model
        self.steps = 0
        self.integrated = 0.0
        self._allowance = Allowance(allowance)
        self.ports = ports
        self.state = State(
            model.to_rows(position),
            model.to_rows(velocity),
            np.zeros((rows, width)),
            np.zeros((rows, width)),
            unsettled(model, index),
        )
        self._lanes = model.lanes
        self._scale = CopyScale(model.operator)
        self._joined = JoinedLinks(model, self.state.position, links, strength, weight)
        self._local = np.ascontiguousarray(local_damping, dtype=np.float64)
        self._extra = np.ascontiguousarray(extra_damping, dtype=np.float64)
        self._work = model.workspace(ports.row.size)
        self._ledger = np.zeros(LEDGER_COLUMNS)
        self._solver = tolerance, iterations
        self.tools = tools
        self._surface = surface
        self._soft = None if surface is None else surface.soft
        self._contact = contact
        self._touch_ledger = np.zeros(TOUCH_LEDGER)
        self._rescaled = 0.0
        self.cuts = None if model.cut < 0 else CutSet(model, self.state, tools, index + 1, decides=cuts)
        self._moved: tuple[Sample, list[float], float] | None = None  # the last step, not in the ledger yet
        self._settle()
        self._energy = float(self._ledger[KINETIC] + self._ledger[ELASTIC])
        if tools is not None:
            if surface is None or contact is None:
                raise ValueError("tools are given without a surface or a contact law; see surface_of and contact_by")
            self._energy += 0.5 * float(tools.mass @ (tools.rate**2).sum(axis=1)) + float(tools.stored.sum())

    @property
    def neighbours(self) -> tuple[int, ...]:
        """Users it is linked to, in the order of their links."""
        return self._joined.neighbours

    @property
    def mean(self) -> Float:
        """v̂ of the step taken last, (rows, width); changes in place [m/s]."""
        return self._work.mean

    @property
    def ready(self) -> bool:
        """Whether every link has what the next step needs."""
        return all(source.ready(self.steps) for source in self._joined.sources)

    def receive(self, sample: Sample) -> bool:
        """Takes a sample that arrived; False if it was of no use, or not from a neighbour."""
        try:
            source = self._joined.sources[self.neighbours.index(sample.sender)]
        except ValueError:
            return False
        return source.offer(sample)

    def message(self, neighbour: int) -> Message | None:
        """What the link's law tells a neighbour with the sample of the step taken last; None without a law."""
        source = self._joined.sources[self.neighbours.index(neighbour)]
        return source.message if isinstance(source, LawLink) else None

    def connect(self, neighbour: int, link: Link, *, strength: float, weight: int = 0) -> None:
        """Adds a link, which starts relaxed: its spring holds nothing until a step chooses a sample.

        Args:
            neighbour: index of the user.
            link: how its samples are chosen; only a `LinkGuard` engages without making energy.
            strength: of the spring, >= 0 [N/m for the identity weight].
            weight: index among the model's.

        Raises:
            NetworkError: it is a neighbour already, or there is no such weight.
        """
        if neighbour in self.neighbours or neighbour == self.index:
            raise NetworkError(
                f"user index {neighbour} is already linked to user index {self.index}; disconnect it first"
            )
        self._joined.connect(self.state.position, neighbour, link, strength=strength, weight=weight)

    def disconnect(self, neighbour: int) -> None:
        """Lets a link go, and what its spring holds; nothing, where there is none."""
        self._joined.disconnect(self.state.position, neighbour)

    def set_local_damping(self, coefficients: Float) -> None:
        """Changes B_i.

        Args:
            coefficients: over the weights, (weights,), >= 0 [Ns/m].

        Raises:
            NetworkError: their number is another, or one is negative or not finite.
        """
        wanted = np.asarray(coefficients, dtype=np.float64)
        if wanted.shape != self._local.shape or not np.all((wanted >= 0.0) & (wanted < np.inf)):
            raise NetworkError(
                f"local damping is {wanted.tolist()}; it must be {self._local.size} finite coefficients of at least 0"
            )
        self._local[:] = wanted

    def rescale(self, copies: int) -> None:
        """Takes part in another number of copies, as members come and go.

        With more of them the copy becomes lighter and softer at once. With fewer it becomes heavier at once, at the
        same momentum, and stiffer as far as the copy's own losses pay for it, over the coming steps.

        Args:
            copies: N, >= 1.
        """
        ledger, scale = self._ledger, self._scale
        kinetic, elastic = float(ledger[KINETIC]), float(ledger[ELASTIC])
        mass, stiffness = scale.operator.copy_scale, scale.stiffness
        self._changed(scale.rescale(copies, self.state, kinetic, elastic))
        for law in self._joined.laws:
            law.copies = copies
        if self.model.force is None:
            self._settle()
        else:  # from nowhere it might find other rotations
            lighter = scale.operator.copy_scale / mass
            ledger[KINETIC] = kinetic * min(lighter, 1.0 / lighter)
            ledger[ELASTIC] = elastic * (scale.stiffness / stiffness)

    def contact_parts(self) -> list[tuple[Any, tuple[Any, ...]]]:
        """What its steps with tools consist of, for whoever compiles that ahead; nothing without them."""
        if self.tools is None or self._surface is None or self._contact is None:
            return []
        links, ports, op, force = self._joined.kernel, self.ports, self._scale.operator, self.model.force
        what = self._surface, self.tools, self._local, self._work, self._lanes
        return contact_parts(self._contact, op, force, self.state, links, ports, *what)

    @property
    def stiffness_scale(self) -> float:
        """Share of K that the copy carries; 1/N, or less while it still rises."""
        return self._scale.stiffness

    def step(self, now: float, T: float) -> StepReport:
        """Takes the step that ends now and lasted T: `move` and `account`.

        Args:
            now: time on this peer's clock [s].
            T: length of the step, > 0 [s].
        """
        self.move(now, T)
        return self.account()

    def move(self, now: float, T: float) -> Sample:
        """Moves through the step that ends now and lasted T; `account` must follow before anything else changes.

        Args:
            now: time on this peer's clock [s].
            T: length of the step, > 0 [s].

        Returns:
            What the neighbours should be told, with the words that the links' guards have now.
        """
        joined, ledger, lanes, scale, x = self._joined, self._ledger, self._lanes, self._scale, self.state.position
        links = joined.kernel
        if scale.rising:
            self._changed(scale.rise(self.state, float(ledger[ELASTIC])))
        age: list[float] = []
        for end in joined.ends:
            guard, place, sample = end.guard, end.place, end.source.choose(self.steps)
            age.append(now - sample.stamp)
            if self.cuts is not None and sample.cuts is not None:
                self.cuts.hear(sample.cuts)
            if end.law is not None:
                at = len(age) - 1
                links.strength[at], links.brake[at] = end.law.before(sample, age[at], T, x, self.state.velocity)
                continue
            fraction = 1.0 if guard is None else self._decide(guard, end, sample, now, T)
            if fraction == 1.0:
                place[...] = sample.position
            elif fraction == 0.0:
                place[...] = x
            else:
                approach(x, sample.position, fraction, place, lanes)
        own = len(joined.ends)
        op, force, state, ports, work = scale.operator, self.model.force, self.state, self.ports, self._work
        surface, tools, touched = self._surface, self.tools, self._touch_ledger
        contact = self._contact
        apart = tools is not None and bool(self.model.body.tools) and are_apart(force, tools)
        damping, rest = (self._local, self._extra), (joined.work, *self._solver, lanes)
        self._jammed = None
        if self.cuts is not None:
            self.cuts.begin(contact)
        if tools is not None and surface is not None and contact is not None and not apart:
            what = surface, tools, *damping, T, own, work
            contact_step(contact, op, force, state, links, ports, *what, ledger, touched, *rest)
            self._jammed = jammed_about(contact.work, tools, force)
        elif force is not None:
            closed_step(op, force, state, links, ports, *damping, T, own, work, ledger, *rest)
            if tools is not None:
                move_apart(contact, tools, T, touched, lanes)
        else:
            step(op, state, links, ports, *damping, T, own, work, ledger, *rest)
        # Other copies of the process write there, too.
        self._closing = None if force is None or force.parts is None else closing_of(force.parts)
        for law in joined.laws:
            law.after(work.mean)
        if joined.laws:
            push = push_of(self.model, op.copy_scale * op.firmness)
            joined.laws[0].memory.feel(ports, joined.laws[0].weight, None if apart else contact, push)
        if self.cuts is not None:
            self.cuts.end(op, self.steps, ledger)
        self.steps += 1
        self.integrated += T
        sample = Sample(
            sender=self.index,
            index=self.steps - 1,
            stamp=now - 0.5 * T,
            position=links.samples[own].copy(),
            cuts=None if self.cuts is None else self.cuts.by,
        )
        self._moved = sample, age, T
        return sample

    def account(self) -> StepReport:
        """Books the step that was just moved through; guards get what it left over."""
        assert self._moved is not None
        joined, ledger, touched, scale = self._joined, self._ledger, self._touch_ledger, self._scale
        sample, age, T = self._moved
        # As Python's own numbers from here on: one by one out of an array they take longer than the step of a point.
        square, did, touch = self._work.quadratic.tolist(), ledger.tolist(), touched.tolist()
        for guard, end in joined.guarded:
            guard.settle(square[end.weight], T)
        if scale.rising:
            scale.tank += did[BODY_LOSS] + did[EXTRA_LOSS]
        else:
            joined.share(did[BODY_LOSS] + did[EXTRA_LOSS])
        advanced = self._allowance.spend(joined, T) if self._allowance.left > 0.0 else 0.0
        energy = did[KINETIC] + did[ELASTIC] + touch[PROXY] + touch[TOUCH_STORED]
        lost = did[BODY_LOSS] + did[LOCAL_LOSS] + did[EXTRA_LOSS] + touch[TOUCH_LOSS] + did[CUT]
        supplied = did[SUPPLIED] + touch[DRIVE]
        report = StepReport(
            sample=sample,
            force=self.ports.force.copy(),
            link_work=joined.work.copy(),
            speed=square[0],
            residual=energy - self._energy - supplied + lost - sum(joined.work.tolist()),
            age=np.array(age),
            closing=self._closing,
            jammed=self._jammed,
            cut_elements=() if self.cuts is None else self.cuts.new,
            rescaled=self._rescaled,
            advanced=advanced,
            guards=tuple(None if end.guard is None else end.guard.ledger for end in joined.ends),
            **books_of(did, touch),
        )
        self._energy, self._rescaled = energy, 0.0
        return report

    def _settle(self) -> None:
        """Energies of a state that was just set."""
        op, force, lanes = self._scale.operator, self.model.force, self.model.lanes
        if force is None:
            settle(op, self.state, self._ledger, lanes)
        else:
            closed_settle(op, force, self.state, self._work, self._ledger, lanes)

    def _decide(self, guard: LinkGuard, end: LinkEnd, sample: Sample, now: float, T: float) -> float:
        """How far the guard lets its spring follow."""
        x, lanes = self.state.position, self._lanes
        place, w, diagonal = end.place, end.weight, end.diagonal
        if diagonal is None:
            work, operator = self._work, self._scale.operator
            desired = mixed_stretch(operator, w, x, sample.position, work.stretch, work.image, lanes)
            held = mixed_stretch(operator, w, x, place, work.stretch, work.image, lanes)
        else:
            desired, held = stretches(diagonal, x, sample.position, place, lanes)
        return guard.decide(sample, desired, held, now, T)

    def _changed(self, energy: float) -> None:
        """Books what the copy's energy changed by between steps."""
        self._energy += energy
        self._rescaled += energy
        if self._surface is not None and self._surface.soft.size and self._soft is not None:
            self._surface = self._surface._replace(soft=self._soft * self._scale.softness)
