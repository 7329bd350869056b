"""One user's replica: samples in, sample and books out; time is handed to it, and it opens nothing."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple, final

import numpy as np
import numpy.typing as npt

from cotouch.errors import NetworkError
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
    WEIGHTS,
    Grips,
    Links,
    Model,
    State,
    Surface,
    Tools,
    approach,
    mixed_stretch,
    settle,
    step,
    stretches,
    touch_step,
    touch_work,
    workspace,
)
from cotouch.peer._guard import LinkGuard
from cotouch.peer._links import Link, Sample
from cotouch.peer._report import Report
from cotouch.peer._scale import CopyScale

Float = npt.NDArray[np.float64]


class _End(NamedTuple):
    """A link as a step goes through it."""

    source: Link
    guard: LinkGuard | None
    place: Float
    weight: int
    diagonal: Float | None  # of the weight, the same in any number of copies; None where it couples rows


@final
class Peer:
    """One user's copy of the shared object and its links.

    Use it in three steps: `receive` whatever arrived, write into `grips` and `tools` what the hands do, `step`; then
    send `report.sample` to every neighbour. What a link's guard says goes with it: its `word`.

    Links come and go between steps, and so does the share that the copy has of the body. A newcomer starts where a
    neighbour is, at rest, with guarded links.

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
            links: for each neighbour, how its samples are chosen; a `LinkGuard` starts relaxed, where the copy is.
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
        self.steps = 0
        self.integrated = 0.0
        self.grips = grips
        self.state = State(
            model.to_rows(position), model.to_rows(velocity), np.zeros((rows, width)), np.zeros((rows, width))
        )
        self._lanes = model.lanes
        self._scale = CopyScale(model.operator)
        self._mixed = [bool(np.any(mix)) for mix in model.operator.mix[WEIGHTS:]]
        self._hold(tuple(links), tuple(links.values()), strength, weight, {})
        self._local = np.ascontiguousarray(local_damping, dtype=np.float64)
        self._extra = np.ascontiguousarray(extra_damping, dtype=np.float64)
        self._work = workspace(model.operator, width, grips.last - grips.first)
        self._books = np.zeros(BOOKS)
        self._solver = tolerance, iterations
        self.tools = tools
        self._surface = surface
        self._soft = None if surface is None else surface.soft
        self._touch = None
        self._touch_books = np.zeros(TOUCH_BOOKS)
        self._rescaled = 0.0
        self._moved: tuple[Sample, list[float], float] | None = None  # the last step, not in the books yet
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
            raise NetworkError(f"user index {neighbour} is linked to user index {self.index} already; disconnect it")
        if not (0 <= weight < len(self._mixed) and 0.0 <= strength < np.inf):
            raise NetworkError(
                f"a link has strength {strength:g} and weight {weight}; it takes a finite strength >= 0 and a weight "
                f"from 0 to {len(self._mixed) - 1}"
            )
        held, links = self._held(), self._links
        self._hold(
            (*self.neighbours, neighbour),
            (*self._sources, link),
            (*links.strength, strength),
            (*links.weight, weight),
            held,
        )

    def disconnect(self, neighbour: int) -> None:
        """Lets a link go, and what its spring holds; nothing, where there is none."""
        if neighbour not in self.neighbours:
            return
        held, links = self._held(), self._links
        kept = [at for at, other in enumerate(self.neighbours) if other != neighbour]
        self._hold(
            tuple(self.neighbours[at] for at in kept),
            tuple(self._sources[at] for at in kept),
            [float(links.strength[at]) for at in kept],
            [int(links.weight[at]) for at in kept],
            held,
        )

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
                f"local damping is {wanted.tolist()}; it takes {self._local.size} finite coefficients of at least 0"
            )
        self._local[:] = wanted

    def rescale(self, copies: int) -> None:
        """Takes part in another number of copies, as members come and go.

        With more of them the copy becomes lighter and softer at once. With fewer it becomes heavier at once, at the
        same momentum, and stiffer as far as the copy's own losses pay for it, over the coming steps.

        Args:
            copies: N, >= 1.
        """
        kinetic, elastic = float(self._books[KINETIC]), float(self._books[ELASTIC])
        self._changed(self._scale.rescale(copies, self.state, kinetic, elastic))
        settle(self._scale.operator, self.state, self._books, self.model.lanes)

    @property
    def stiffness_share(self) -> float:
        """Share of K that the copy carries; 1/N, or less while it still rises."""
        return self._scale.stiffness

    def step(self, now: float, T: float) -> Report:
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
        links, books, lanes, scale, x = self._links, self._books, self._lanes, self._scale, self.state.position
        if scale.rising:
            self._changed(scale.rise(self.state, float(books[ELASTIC])))
        age: list[float] = []
        for end in self._ends:
            guard, place, sample = end.guard, end.place, end.source.choose(self.steps)
            age.append(now - sample.stamp)
            share = 1.0 if guard is None else self._decide(guard, end, sample, now, T)
            if share == 1.0:
                place[...] = sample.position
            elif share == 0.0:
                place[...] = x
            else:
                approach(x, sample.position, share, place, lanes)
        own = len(self._ends)
        op, state, grips, work = scale.operator, self.state, self.grips, self._work
        surface, tools, touch, touched = self._surface, self.tools, self._touch, self._touch_books
        damping, rest = (self._local, self._extra), (self._link_work, *self._solver, lanes)
        if tools is None or surface is None or touch is None:
            step(op, state, links, grips, *damping, T, own, work, books, *rest)
        else:
            touch_step(op, state, links, grips, surface, tools, *damping, T, own, work, touch, books, touched, *rest)
        self.steps += 1
        self.integrated += T
        sample = Sample(
            sender=self.index, index=self.steps - 1, stamp=now - 0.5 * T, position=links.samples[own].copy()
        )
        self._moved = sample, age, T
        return sample

    def account(self) -> Report:
        """Books the step that was just moved through; guards get what it left over."""
        assert self._moved is not None
        books, touched, scale, (sample, age, T) = self._books, self._touch_books, self._scale, self._moved
        # As Python's own numbers from here on: one by one out of an array they take longer than the step of a point.
        square, did, touch = self._work.quadratic.tolist(), books.tolist(), touched.tolist()
        for guard, end in self._guarded:
            guard.settle(square[end.weight], T)
        if scale.rising:
            scale.tank += did[BODY_LOSS] + did[EXTRA_LOSS]
        else:
            self._share(did[BODY_LOSS] + did[EXTRA_LOSS])
        energy = did[KINETIC] + did[ELASTIC] + touch[PROXY] + touch[TOUCH_STORED]
        lost = did[BODY_LOSS] + did[LOCAL_LOSS] + did[EXTRA_LOSS] + touch[TOUCH_LOSS]
        supplied = did[SUPPLIED] + touch[DRIVE]
        report = Report(
            sample=sample,
            force=self.grips.force[self.grips.first : self.grips.last].copy(),
            supplied=did[SUPPLIED],
            body_loss=did[BODY_LOSS],
            local_loss=did[LOCAL_LOSS],
            extra_loss=did[EXTRA_LOSS],
            link_work=self._link_work.copy(),
            kinetic=did[KINETIC],
            elastic=did[ELASTIC],
            drive_work=touch[DRIVE],
            touch_work=touch[TOUCHED],
            touch_loss=touch[TOUCH_LOSS],
            proxy=touch[PROXY],
            touch_stored=touch[TOUCH_STORED],
            residual=energy - self._energy - supplied + lost - sum(self._link_work.tolist()),
            age=np.array(age),
            iterations=int(did[ITERATIONS]),
            rescaled=self._rescaled,
            guards=tuple(None if end.guard is None else end.guard.books for end in self._ends),
        )
        self._energy, self._rescaled = energy, 0.0
        return report

    def _decide(self, guard: LinkGuard, end: "_End", sample: Sample, now: float, T: float) -> float:
        """How far the guard lets its spring follow."""
        x, lanes = self.state.position, self._lanes
        _, _, place, w, diagonal = end
        if diagonal is None:
            work, operator = self._work, self._scale.operator
            wish = mixed_stretch(operator, w, x, sample.position, work.stretch, work.image, lanes)
            held = mixed_stretch(operator, w, x, place, work.stretch, work.image, lanes)
        else:
            wish, held = stretches(diagonal, x, sample.position, place, lanes)
        return guard.decide(sample, wish, held, now, T)

    def _share(self, spare: float) -> None:
        """Lets links that cannot follow have what other links, and the copy's own damping, can spare [J]."""
        wanting = [guard for guard, _ in self._guarded if guard.wanting]
        if wanting:
            spare += sum(guard.donate() for guard, _ in self._guarded)
            for guard in wanting:
                guard.help(spare / len(wanting))

    def _changed(self, energy: float) -> None:
        """Books what the copy's energy changed by between steps."""
        self._energy += energy
        self._rescaled += energy
        if self._surface is not None and self._surface.soft.size and self._soft is not None:
            self._surface = self._surface._replace(soft=self._soft * self._scale.softness)

    def _held(self) -> dict[int, Float]:
        """Set positions of the links, by neighbour."""
        return {other: self._places[at].copy() for at, other in enumerate(self.neighbours)}

    def _hold(
        self,
        neighbours: tuple[int, ...],
        sources: tuple[Link, ...],
        strength: Sequence[float],
        weight: Sequence[int],
        held: Mapping[int, Float],
    ) -> None:
        """Takes these links; what was held is kept, what is new starts where the copy is."""
        count, position = len(sources), self.state.position
        samples = np.zeros((count + 1, *position.shape))  # the last one receives this peer's own sample
        for at, other in enumerate(neighbours):
            samples[at] = held.get(other, position)
        self._links = Links(
            first=0,
            last=count,
            strength=np.asarray(strength, dtype=np.float64),
            weight=np.asarray(weight, dtype=np.int32),
            slot=np.arange(count, dtype=np.int64),
            samples=samples,
        )
        self.neighbours, self._sources, self._link_work = neighbours, sources, np.zeros(count)
        self._places = [samples[at] for at in range(count)]
        diagonals = [None if self._mixed[w] else self.model.operator.weight[w] for w in weight]
        self._guards = [source if isinstance(source, LinkGuard) else None for source in sources]
        ends = zip(sources, self._guards, self._places, map(int, weight), diagonals, strict=True)
        self._ends = [_End(*end) for end in ends]
        self._guarded = [(end.guard, end) for end in self._ends if end.guard is not None]
        for guard, stiffness in zip(self._guards, strength, strict=True):
            if guard is not None:
                guard.attach(float(stiffness))
