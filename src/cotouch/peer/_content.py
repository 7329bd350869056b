"""What a perceptual codec sends in full, and how both ends go on from it.

A *content* is what a sample holds, x̂ and its law's message, with the rates at which sums among them grow. In full
numbers, and in steps of a quantum, little-endian::

    0 u8   | x̂ and sums f8 | values f4 | rates of sums f4 | energies f8 | theirs f4
    255 u8 | x̂ and sums i4 | values i4 | rates of sums f4 | energies f8 | theirs f4

and then the other numbers, in both: counts f8, others f4. Sums that only grow are sent whole, never as differences:
whatever is lost, the next content makes up for. Values lose no more than single precision has, towards zero; rates are
guesses that both ends share. Energies are never rounded: a wave waits for them, and 1e-5 J was felt as a drag of 0.3
Ns/m.
"""

from dataclasses import dataclass, replace
from typing import final

import numpy as np

from cotouch.arrays import Array, Float
from cotouch.laws import Law, OriginForce

# First byte: a content in full numbers, one in steps of the quantum; between them, since how many steps it goes on.
FULL, ROUNDED = 0, 255
MOST_HOLD = ROUNDED - 1
_LARGEST = 2**31 - 1
_FASTEST = float(np.finfo(np.float32).max)


@final
@dataclass(frozen=True, kw_only=True)
class Codec:
    """How a sender saves bytes.

    Attributes:
        deadband: share of a value, or of a sum's growth since the last content, that is not worth saying, 0 to below 1.
        quantum: fields are rounded to multiples of this; 0: they are not [SI units].
        hold: a content is sent at least every so many steps, 1 to 254.
        age: of a law that needs damping for the age of samples, errors are paid for by as much damping more as samples
            that much older would need, > 0 [s].
    """

    deadband: float
    quantum: float = 0.0
    hold: int = 20
    age: float = 1e-3


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Content:
    """What is said in full.

    Attributes:
        index: of the step.
        stamp: of the step [s].
        fields: x̂ and the law's, (1 + fields, size).
        rates: of the sums among them that have one, (rated, size) [1/s].
        scalars: the law's numbers.
        flow: rates of the energies among those [W].
    """

    index: int
    stamp: float
    fields: Float
    rates: Float
    scalars: Float
    flow: Float

    def part(self, elements: slice) -> "Content":
        """Of some elements alone, with all numbers.

        Args:
            elements: which.
        """
        return Content(
            index=self.index,
            stamp=self.stamp,
            fields=self.fields[:, elements],
            rates=self.rates[:, elements],
            scalars=self.scalars,
            flow=self.flow,
        )


@final
class ContentForm:
    """What contents of a law hold, and their bytes.

    Attributes:
        codec: how the sender saves bytes.
        law: of the links.
        sums: which fields go on, x̂ first.
        rated: which of them at a rate that is sent; of a hand's force, ∫∫w follows from ∫w and w.
        values: which fields stay as they are.
        energies: which numbers are energies.
        counts: which must be exact.
        others: the rest; the length of a step is not in it, for every sample says its own.
        length: which number is the length of the step; -1: none.
    """

    def __init__(self, codec: Codec, law: Law) -> None:
        """Looks at what a law sends.

        Args:
            codec: how.
            law: of the links.
        """
        sends, told = law.sends, law.sends_scalars
        self.codec, self.law = codec, law
        self.fields, self.scalars = 1 + len(sends), len(told)
        self.sums = np.array([0, *(1 + sends.index(name) for name in law.sums)])
        self.values = np.array([1 + at for at, name in enumerate(sends) if name not in law.sums], dtype=np.int64)
        self.energies = np.array([told.index(name) for name in law.energies], dtype=np.int64)
        self.length = -1 if law.length is None else told.index(law.length)
        self.counts = np.array([told.index(name) for name in law.counts], dtype=np.int64)
        others = set(range(len(told))) - {*self.energies, *self.counts, self.length}
        self.others = np.array(sorted(others), dtype=np.int64)
        self._order = np.concatenate([self.sums, self.values])
        self._hand = None if law.origin_force is None else _Hand(law.origin_force, law)
        # Of the sums, those with a rate; and, of a hand, where its integrals are among these, its force among values.
        self._with_rate = np.ones(self.sums.size, dtype=np.bool_)
        if self._hand is not None:
            self._with_rate = self.sums != self._hand.double
            self._once, self._twice = (
                int(np.flatnonzero(self.sums == field)[0]) for field in (self._hand.integral, self._hand.double)
            )
            self._force = int(np.flatnonzero(self.values == self._hand.force)[0])
        self.rated = self.sums[self._with_rate]

    def size(self, kind: int, elements: int) -> int:
        """Bytes of a content.

        Args:
            kind: `FULL` or `ROUNDED`.
            elements: of each field.
        """
        rates, numbers = 4 * self.rated.size, 8 * self.counts.size + 4 * self.others.size + 12 * self.energies.size
        if kind == FULL:
            return 1 + elements * (8 * self.sums.size + 4 * self.values.size + rates) + numbers
        return 1 + elements * (4 * self._order.size + rates) + numbers

    def exact(self, content: Content) -> Content:
        """As it is read, if it is sent in full numbers: sums, energies and counts are as they were.

        Args:
            content: the truth.
        """
        fields, scalars = content.fields.copy(), content.scalars.copy()
        fields[self.values] = _towards_zero(fields[self.values])
        scalars[self.others] = _single(scalars[self.others])
        return Content(
            index=content.index,
            stamp=content.stamp,
            fields=fields,
            rates=_single(content.rates),
            scalars=scalars,
            flow=_towards_zero(content.flow),
        )

    def rounded(self, content: Content) -> Content | None:
        """As it is read, if it is sent in steps of the quantum; None where it does not fit.

        Sums are rounded to the nearest, values towards zero.

        Args:
            content: the truth.
        """
        steps = content.fields / self.codec.quantum
        steps[self.sums], steps[self.values] = np.rint(steps[self.sums]), np.trunc(steps[self.values])
        if self._hand is not None:
            acts, force = content.fields[self._hand.force], steps[self._hand.force]
            force += np.sign(acts) * (force == 0.0)  # only where nothing acts is it 0
        if not (np.abs(steps) <= _LARGEST).all():  # nor where it is not a number
            return None
        return replace(self.exact(content), fields=steps * self.codec.quantum)

    def pack(self, content: Content, kind: int) -> bytes:
        """Its bytes.

        Args:
            content: as it is to be read.
            kind: `FULL` or `ROUNDED`, as which it was made.
        """
        fields, scalars = content.fields, content.scalars
        if kind == FULL:
            parts = (fields[self.sums], "<f8"), (fields[self.values], "<f4")
        else:
            parts = ((np.rint(fields[self._order] / self.codec.quantum), "<i4"),)
        parts += (content.rates, "<f4"), (scalars[self.energies], "<f8"), (content.flow, "<f4")
        parts += (scalars[self.counts], "<f8"), (scalars[self.others], "<f4")
        return bytes([kind]) + b"".join(values.astype(kind_).tobytes() for values, kind_ in parts)

    def read(self, data: bytes, elements: int, index: int, stamp: float) -> Content | None:
        """The content in bytes; None of what is none.

        Args:
            data: from the network.
            elements: of each field.
            index: of the step.
            stamp: of the step [s].
        """
        kind = data[0] if data else None
        if kind not in {FULL, ROUNDED} or len(data) != self.size(kind, elements):
            return None
        if kind == ROUNDED and not self.codec.quantum > 0.0:
            return None
        at = 1

        def take(count: int, form: str) -> Float:
            nonlocal at
            values = np.frombuffer(data, form, count, at)
            at += values.nbytes
            return values.astype(np.float64)

        fields, scalars = np.empty((self.fields, elements)), np.zeros(self.scalars)

        def rows(of: Array, form: str) -> Float:
            return take(of.size * elements, form).reshape(of.size, elements)

        if kind == FULL:
            fields[self.sums] = rows(self.sums, "<f8")
            fields[self.values] = rows(self.values, "<f4")
        else:
            fields[self._order] = rows(self._order, "<i4") * self.codec.quantum
        rates = rows(self.rated, "<f4")
        scalars[self.energies] = take(self.energies.size, "<f8")
        flow = take(self.energies.size, "<f4")
        scalars[self.counts] = take(self.counts.size, "<f8")
        scalars[self.others] = take(self.others.size, "<f4")
        if not all(np.isfinite(numbers).all() for numbers in (fields, rates, scalars, flow)):
            return None
        return Content(index=index, stamp=stamp, fields=fields, rates=rates, scalars=scalars, flow=flow)

    def at(self, content: Content, stamp: float, T: float) -> tuple[Float, Float]:
        """Fields and numbers as both ends continue them.

        Args:
            content: as it was read.
            stamp: until when [s].
            T: length of the step [s].
        """
        passed = stamp - content.stamp
        fields, scalars = content.fields.copy(), content.scalars.copy()
        fields[self.rated] += passed * content.rates
        if self._hand is not None:
            once, force = content.fields[self._hand.integral], content.fields[self._hand.force]
            fields[self._hand.double] += passed * once + 0.5 * passed * passed * force
        scalars[self.energies] += passed * content.flow
        if self.length >= 0:
            scalars[self.length] = T
        return fields, scalars

    def scales(self, content: Content, passed: float) -> tuple[Float, Float]:
        """What an error is compared with: of sums how much they grew, of values how large they are, (sums,), (values,).

        The force of a hand at the origin is as large as the origin is far. So it is compared with what the hand exerts
        where the copy is, and integrals with those of that.

        Args:
            content: as it was read.
            passed: since then [s].
        """
        grown, values = np.zeros(self.sums.size), norms(content.fields[self.values])
        grown[self._with_rate] = norms(content.rates * passed)
        if self._hand is not None:
            felt = self._hand.felt(content)
            values[self._force] = felt
            grown[self._once], grown[self._twice] = passed * felt, 0.5 * passed * passed * felt
        return grown, values


@final
class _Hand:
    """Where a law's `OriginForce` is in its message."""

    def __init__(self, hand: OriginForce, law: Law) -> None:
        self.force, self.integral, self.double = (
            1 + law.sends.index(name) for name in (hand.force, hand.integral, hand.double)
        )
        self._numbers = [law.sends_scalars.index(name) for name in (hand.stiffness, hand.damping, hand.plain)]

    def felt(self, content: Content) -> float:
        """What the hand exerts where the copy is, all of it [N]."""
        k, b, plain = content.scalars[self._numbers]
        force = content.fields[self.force]
        if not plain > 0.0:
            acts = force != 0.0
            force = force - acts * (k * content.fields[0] + b * content.rates[0])
        return float(norms(force[None])[0])


def norms(fields: Float) -> Float:
    """Of each field the root of its squares' sum, (fields,).

    Args:
        fields: (fields, size).
    """
    return np.sqrt((fields**2).sum(axis=1))


def _single(numbers: Float) -> Float:
    """As single precision says them: half of it is too little for how a hand's force far off changes."""
    return np.clip(numbers, -_FASTEST, _FASTEST).astype("<f4").astype(np.float64)


def _towards_zero(values: Float) -> Float:
    """Values as single precision says them, never larger than they are."""
    with np.errstate(all="ignore"):
        said: Array = values.astype("<f4")
        over = np.abs(said.astype(np.float64)) > np.abs(values)
        said[over] = np.nextafter(said[over], said.dtype.type(0.0))
        return said.astype(np.float64)
