"""One end of a link whose law says what it does, in a single peer."""

from math import inf
from typing import Any, final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.laws import FORCE, BoundEnd, End, Law, feel
from cotouch.mechanics import Contact, Ports
from cotouch.peer._links import Link, Message, Sample, SourcedLink

_NONE = np.zeros(0)
_BURST = 0.1  # [s] of the power that may come at once
_STEADY = 3.0  # over so long an offset of clocks is evened out [s]
_JUMP = 0.02  # unless it differs by more, as it does when it is found first [s]
_LONGEST = 10.0  # age that a law is told at most [s]


# A greatest force that grows from nothing must be a number; this one stops nobody [N].
_STRONGEST = 1e6


@final
class CopyMemory:
    """What the ends of one copy share: the law's memory, and the last step's force of hands and tools."""

    def __init__(self, law: Law, size: int) -> None:
        """Starts with nothing.

        Args:
            law: of the copy's links.
            size: numbers in a field.
        """
        self.law, self.size = law, size
        self.hand = np.zeros(size if law.feels else 0)
        self.touch = np.zeros_like(self.hand)
        self.shared = np.zeros((len(law.shares), size))
        self.scalars = np.zeros(len(law.shares_scalars))
        self._store = [law.shares_scalars.index(name) for name in law.store or ()]

    @property
    def lacking(self) -> float:
        """What the copy's ends hold less than they should, >= 0; 0 for a law without a store [J]."""
        if not self._store:
            return 0.0
        held, level = self.scalars[self._store].tolist()
        return max(level - held, 0.0)

    @property
    def held(self) -> float:
        """Energy that the copy's ends hold together; 0 for a law without a store [J]."""
        return float(self.scalars[self._store[0]]) if self._store else 0.0

    def feel(self, ports: Ports, weight: Float, contact: Contact | None, push: Float | None) -> None:
        """Notes what hands and tools did in a step, for a law that looks at it.

        Args:
            ports: after the step.
            weight: of a link, flat.
            contact: by which tools touched in it; None: they did not.
            push: of tools that are bodies, on the rows; None without them [N].
        """
        if self.law.feels:
            feel(self.hand, ports, weight)
            if contact is not None:
                self.touch[:] = contact.work.push.ravel()
            if push is not None:
                known = 0.0 if contact is None else np.where(weight == 0.0, 0.0, self.touch)
                self.touch[:] = known + push.ravel()

    def help(self, energy: float) -> None:
        """Adds to what they hold.

        Args:
            energy: >= 0 [J].
        """
        self.scalars[self._store[0]] += energy


@final
class LawLink(SourcedLink):
    """A link with a law, as a source of samples; a `Link` of the peer that needs no guard.

    Attributes:
        source: of the samples.
        law: of the link.
        memory: what the ends of this copy share.
        message: fields and numbers for the neighbour, of the step taken last.
        copies: N.
        offset: what ages are too great by, because clocks differ [s].
        received: energy that the neighbour says it gave, as far as it was believed, so far [J].
        weight: diagonal of W, flat, (rows * width,).
        apart: greatest distance of any node from the neighbour's when that was heard first; 0 before [m].
    """

    def __init__(
        self,
        source: Link,
        *,
        law: Law,
        parameters: Float,
        memory: CopyMemory,
        side: int,
        copies: int,
        power: float = inf,
        burst: float | None = None,
        patience: float = 0.0,
    ) -> None:
        """Starts with nothing heard.

        Args:
            source: which sample a step uses.
            law: the link's.
            parameters: of the law, all of them.
            memory: one for all links of this copy.
            side: 0 at the user with the lower number, 1 at the other.
            copies: N.
            power: what the neighbour may be believed to give, for long, > 0; below infinity, what it gave before it was
                heard first does not count, and ages are kept from 0 to 10 s [W].
            burst: and at once, > 0; None: what the power gives in 0.1 s [J].
            patience: over so long the law's greatest force grows from nothing, while a newcomer is coming, >= 0 [s].
        """
        size = memory.size
        self.source, self.law, self.memory = source, law, memory
        self._parameters, self._side = np.array(parameters, dtype=np.float64), side
        self._patience, self._waited = patience, 0.0
        self._forces = [at for at, known in enumerate(law.parameters) if known.name == FORCE]
        self._limits = self._parameters[self._forces]
        self.copies, self.offset, self._steady, self.received = copies, 0.0, 0.0, 0.0
        self._power, self._burst = power, _BURST * power if burst is None else burst
        self._bucket, self._told = self._burst, np.zeros(len(law.sends_scalars))
        self._energies = [law.sends_scalars.index(name) for name in law.energies]
        self._known: list[float] | None = None  # of its energies, as heard first
        self._admitted: list[float] = []
        self._fields = np.zeros((len(law.keeps), size))
        self._scalars = np.zeros(len(law.keeps_scalars))
        self._empty: Message = np.zeros((len(law.sends), size)), np.zeros(len(law.sends_scalars))
        self.message: Message = self._empty
        self._sent: Message = self._empty[0].copy(), self._empty[1].copy()
        self._gains = np.zeros(2)
        self._spring, self._place, self._width = 0.0, (0, 0), 1
        self.weight = self._target = self._push = _NONE
        self._used, self._steps = -1, 0
        self.apart, self._heard = 0.0, False
        self._end: BoundEnd | None = None
        self._position = _NONE

    def attach(self, *, spring: float, place: tuple[int, int], weight: Float, target: Float, push: Float) -> None:
        """Learns of the copy's links; the peer calls it.

        Args:
            spring: K [N/m for the identity weight].
            place: number of the link among the copy's, and how many those are.
            weight: diagonal of W, (rows,).
            target: where y belongs, (rows, width).
            push: where c belongs, (rows, width).
        """
        self._spring, self._place = spring, place
        self.weight, self._width = np.repeat(weight, target.shape[1]), target.shape[1]
        self._target, self._push = target.reshape(-1), push.reshape(-1)
        self._end = None

    def set_parameters(self, parameters: Float) -> None:
        """Goes on with others; what a newcomer may push with grows as before.

        Args:
            parameters: of the law, all of them, its initial energy and greatest force as before.
        """
        forces = self._parameters[self._forces]
        self._parameters[:] = parameters
        self._parameters[self._forces] = forces

    def before(self, sample: Sample, age: float, T: float, position: Float, velocity: Float) -> tuple[float, float]:
        """Lets the law say what the link does in the coming step; y and c go where they belong.

        Args:
            sample: that the step uses.
            age: of it, at the end of the step [s].
            T: length of the step [s].
            position: of the copy, (rows, width) [m].
            velocity: likewise [m/s].

        Returns:
            k and b [N/m, Ns/m]; NaN where the motion, or what is told of another, is not finite any more.

        Raises:
            NetworkError: of a motion that is, the law gives one that is not a finite number of at least 0.
        """
        fields, scalars = self._empty if sample.message is None else sample.message
        if self._power < inf:
            off = self.offset - self._steady
            self._steady += off if abs(off) > _JUMP else off * min(T / _STEADY, 1.0)
            age = min(max(age - self._steady, 0.0), _LONGEST)
            if sample.message is not None:
                scalars = self._believed(scalars, T)
        if not self._heard and sample.message is not None:
            self._heard = True
            self.apart = float(np.abs(sample.position - position).max())
        if self._waited <= self._patience:
            grown = (self._waited / self._patience) ** 3 if self._patience > 0.0 else 1.0
            self._parameters[self._forces] = (
                self._limits if grown >= 1.0 else grown * np.minimum(self._limits, _STRONGEST)
            )
            self._waited += T * self._heard
        link, links = self._place
        content = sample.index if sample.content is None else sample.content
        changed: dict[str, Any] = {
            "T": T,
            "age": age,
            "sample_index": sample.index,
            "new": content > self._used,
            "step": self._steps,
            "first": link == 0,
            "last": link + 1 == links,
            "copies": self.copies,
            "spring": self._spring,
            "position": position,
            "velocity": velocity,
            "sample": sample.position,
            "received": fields,
            "received_scalars": scalars,
        }
        if self._end is None:
            self._end = self._bound(changed)
        else:
            self._end.write(**changed)
        self._end.run(self.law.parts[0])
        self._position, self._used = position.reshape(-1), content
        k, b = self._gains.tolist()
        if not (0.0 <= k < np.inf and 0.0 <= b < np.inf):
            told = (position, velocity, sample.position, self.memory.hand, self.memory.touch, fields, scalars)
            if not all(np.isfinite(values).all() for values in told):
                return np.nan, np.nan  # a motion that left floating point shows in the state; no law could help it
            raise NetworkError(
                f'law "{self.law.name}" gives a link stiffness {k:g} and damping {b:g}; both must be finite and >= 0'
            )
        return k, b

    def _bound(self, changed: dict[str, Any]) -> BoundEnd:
        """The end as it is in its first step with such links."""
        end = End(
            **changed,
            side=self._side,
            width=self._width,
            parameters=self._parameters,
            weight=self.weight,
            mean=_NONE,
            hand=self.memory.hand,
            touch=self.memory.touch,
            memory=self._fields,
            scalars=self._scalars,
            shared=self.memory.shared,
            shared_scalars=self.memory.scalars,
            target=self._target,
            push=self._push,
            gains=self._gains,
            sent=self._sent[0],
            sent_scalars=self._sent[1],
        )
        return BoundEnd(end)

    @property
    def initial_energy(self) -> float:
        """What this end may make [J]."""
        return self.law.initial_energy_of(self._parameters.tolist())

    @property
    def sent(self) -> float:
        """Energy that this end says it gave to the neighbour, so far [J]."""
        return sum(float(self.message[1][at]) for at in self._energies)

    @property
    def force(self) -> float:
        """Of the link's push and spring on the copy where it stands, as chosen last [N]."""
        if self._end is None:
            return 0.0
        pull = float(self._gains[0]) * (self._target - self._position) + self._push
        return float(np.sqrt(self.weight @ pull**2))

    def _believed(self, scalars: Float, T: float) -> Float:
        """The neighbour's numbers, with no more energy than the power limit lets in; the rest may come later."""
        told = self._told
        told[:], said = scalars, [float(scalars[at]) for at in self._energies]
        if self._known is None:
            self._known = said
            self._admitted = [0.0] * len(said)
        self._bucket = min(self._bucket + self._power * T, self._burst)
        for nth, at in enumerate(self._energies):
            due = said[nth] - self._known[nth] - self._admitted[nth]
            taken = min(max(due, 0.0), self._bucket)
            self._bucket -= taken
            self._admitted[nth] += taken
            self.received += taken
            told[at] = self._admitted[nth]
        return told

    def after(self, mean: Float) -> None:
        """Lets the law say what the neighbour is told; the copy has moved.

        Args:
            mean: v̂ of the step, (rows, width) [m/s].
        """
        assert self._end is not None
        fields, scalars = self._sent
        fields.fill(0.0)
        scalars.fill(0.0)
        self._end.write(mean=mean)
        self._end.run(self.law.parts[1])
        self.message = fields.copy(), scalars.copy()
        self._steps += 1
