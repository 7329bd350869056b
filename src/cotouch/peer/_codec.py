"""The perceptual codec: a sample is said in one byte while it goes on as said before; errors are paid for.

A *content* is what a sample holds, x̂ and its law's message, with the rates at which sums among them grow. Until the
next content both ends continue it alike: sums at their rate, values as they were. While that is nearer to the truth
than people notice, the sender says only since how many steps it goes on: a deadband [Hinterseer, Hirche, Chaudhuri,
Steinbach & Buss 2008] with prediction. What it does to energy, with proofs: docs/codec.md.
"""

from collections import deque
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.laws import Law
from cotouch.peer._links import Sample

# First byte: a content in full numbers, one in steps of the quantum; between them, since how many steps it goes on.
_FULL, _ROUNDED = 0, 255
MOST_HOLD = _ROUNDED - 1
_LARGEST = 2**31 - 1


@final
@dataclass(frozen=True, kw_only=True)
class Codec:
    """How a sender saves bytes.

    Attributes:
        deadband: share of a value, or of a sum's growth since the last content, that is not worth saying, 0 to below 1.
        quantum: numbers of fields are rounded to multiples of this, and energies down; 0: they are not [SI units].
        hold: a content is sent at least every so many steps, 1 to 254.
        age: of a law that needs damping for the age of samples, errors are paid for by as much damping more as samples
            that much older would need, > 0 [s].
    """

    deadband: float
    quantum: float = 0.0
    hold: int = 20
    age: float = 1e-3


@final
class Account:
    """What the damping of a copy has paid for the errors of what it says to a neighbour.

    The receiver's spring to a sample that is wrong by e makes at most `½K(ε‖v_i‖² + ‖e‖²/ε)` of power. Damping ½Kε of
    its own pays for the first part. Another ½Kε at the sender pays for the second: per ½K, it earns ε‖v̂‖² and spends
    the largest ‖e‖²/ε of all that may still be in use. It never promises what it has not earned.
    """

    def __init__(self, age: float, window: float) -> None:
        """Starts with nothing.

        Args:
            age: ε, > 0 [s].
            window: how long after its stamp a sample may be in use, with the longest steps of both ends [s].
        """
        self._age, self._window = age, window
        self._left = 0.0
        self._errors: deque[tuple[float, float]] = deque()  # stamps and squared errors, those not outdone since

    def earn(self, square: float, now: float, T: float) -> None:
        """Takes what a step dissipated, and forgets what is no longer in use.

        Args:
            square: ‖v̂‖² of the step, in the link's weight.
            now: stamp of the step [s].
            T: length of the step [s].
        """
        self._left += T * self._age * square
        while self._errors and self._errors[0][0] < now - self._window:
            self._errors.popleft()

    def affords(self, error: float, T: float) -> bool:
        """Whether a squared error is paid for as long as it may be in use.

        Args:
            error: ‖e‖² in the link's weight.
            T: length of the step [s].
        """
        worst = max(error, self._errors[0][1] if self._errors else 0.0)
        return error == 0.0 or self._left >= (self._window + T) * worst / self._age

    def spend(self, error: float, now: float, T: float) -> None:
        """Books a step with what was said in it.

        Args:
            error: ‖e‖² in the link's weight; it was asked for with `affords`.
            now: stamp of the step [s].
            T: length of the step [s].
        """
        while self._errors and self._errors[-1][1] <= error:
            self._errors.pop()
        if error > 0.0:
            self._errors.append((now, error))
        if self._errors:
            self._left -= T * self._errors[0][1] / self._age


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class _Content:
    """x̂ and fields (1 + fields, size), rates of the sums among them, numbers, and rates of the energies among those."""

    index: int
    stamp: float
    fields: Float
    rates: Float
    scalars: Float
    flow: Float

    def at(self, stamp: float, layout: "_Layout") -> tuple[Float, Float]:
        """Fields and numbers as both ends continue them.

        Args:
            stamp: until when [s].
            layout: of the law's contents.
        """
        passed = stamp - self.stamp
        fields, scalars = self.fields.copy(), self.scalars.copy()
        fields[layout.sums] += passed * self.rates
        scalars[layout.energies] += passed * self.flow
        return fields, scalars


@final
class _Layout:
    """What contents of a law hold."""

    def __init__(self, law: Law, shape: tuple[int, int]) -> None:
        sends, told = law.sends, law.sends_scalars
        self.shape, self.size = shape, shape[0] * shape[1]
        self.fields, self.scalars = 1 + len(sends), len(told)
        self.sums = np.array([0, *(1 + sends.index(name) for name in law.sums)])
        self.values = np.array([1 + at for at, name in enumerate(sends) if name not in law.sums], dtype=np.int64)
        self.energies = np.array([told.index(name) for name in law.energies], dtype=np.int64)
        self.others = np.array([at for at in range(len(told)) if at not in self.energies], dtype=np.int64)
        flowing = self.energies.size
        self.count = (self.fields + self.sums.size) * self.size + self.scalars + flowing
        first = (self.fields + self.sums.size) * self.size
        self.down = np.zeros(self.count, dtype=bool)  # rounded down
        self.down[first + self.energies] = True
        self.down[self.count - flowing :] = True
        self.whole = np.zeros(self.count, dtype=bool)  # never rounded
        self.whole[first + self.others] = True
        self.small = np.zeros(self.count, dtype=bool)  # rounded towards zero
        for at in self.values:
            self.small[at * self.size : (at + 1) * self.size] = True

    def content(self, index: int, stamp: float, numbers: Float) -> _Content:
        """A content of all its numbers in a row.

        Args:
            index: of the step.
            stamp: of the step [s].
            numbers: (count,).
        """
        fields = self.fields * self.size
        rates = fields + self.sums.size * self.size
        return _Content(
            index=index,
            stamp=stamp,
            fields=numbers[:fields].reshape(self.fields, self.size),
            rates=numbers[fields:rates].reshape(self.sums.size, self.size),
            scalars=numbers[rates : rates + self.scalars],
            flow=numbers[rates + self.scalars :],
        )

    def rounded(self, numbers: Float, quantum: float) -> tuple[bytes, Float] | None:
        """Numbers in steps of a quantum, and what those come to; None where they do not fit.

        Energies are rounded down and values towards zero, so that nobody gets more than was given.

        Args:
            numbers: of a content, (count,).
            quantum: > 0.
        """
        steps = numbers / quantum
        steps = np.where(self.down, np.floor(steps), np.where(self.small, np.trunc(steps), np.rint(steps)))
        steps[self.whole] = 0.0
        if not (np.abs(steps) <= _LARGEST).all():  # also what is not a number
            return None
        # A product may round to just above the truth.
        steps[self.down] -= steps[self.down] * quantum > numbers[self.down]
        whole = numbers[self.whole]
        return steps[~self.whole].astype("<i4").tobytes() + whole.astype("<f8").tobytes(), self._meant(
            steps[~self.whole], whole, quantum
        )

    def read(self, data: bytes, quantum: float) -> Float | None:
        """All numbers of a content; None of what is none.

        Args:
            data: from the network, not empty.
            quantum: of the sender.
        """
        if data[0] == _FULL and len(data) == 1 + 8 * self.count:
            numbers = np.frombuffer(data, "<f8", offset=1).astype(np.float64)
        elif data[0] == _ROUNDED and quantum > 0.0:
            whole = int(self.whole.sum())
            if len(data) != 1 + 4 * (self.count - whole) + 8 * whole:
                return None
            steps = np.frombuffer(data, "<i4", count=self.count - whole, offset=1)
            numbers = self._meant(
                steps.astype(np.float64), np.frombuffer(data[len(data) - 8 * whole :], "<f8"), quantum
            )
        else:
            return None
        return numbers if np.isfinite(numbers).all() else None

    def _meant(self, steps: Float, whole: Float, quantum: float) -> Float:
        numbers = np.empty(self.count)
        numbers[~self.whole] = steps * quantum
        numbers[self.whole] = whole
        return numbers


@final
class Encoder:
    """What one end of a link says to its neighbour.

    Attributes:
        contents: how many it sent.
        unchanged: how many samples it said in one byte.
        size: of all that it said [bytes].
    """

    def __init__(self, codec: Codec, law: Law, weight: Float, shape: tuple[int, int], window: float) -> None:
        """Starts with nothing said.

        Args:
            codec: how.
            law: of the link; one that needs damping for the age of samples gets an `Account`.
            weight: diagonal of W, flat, (size,).
            shape: of x̂, (rows, width).
            window: how long after its stamp a sample may be in use, with the longest steps of both ends [s].
        """
        self._codec, self._layout, self._weight = codec, _Layout(law, shape), weight
        self._account = Account(codec.age, window) if law.rule > 0.0 else None
        self._base: _Content | None = None
        self._before: tuple[float, Float, Float] | None = None
        self.contents = self.unchanged = self.size = 0

    def encode(self, sample: Sample, mean: Float, T: float) -> bytes:
        """What the neighbour is told of a sample, one byte or a content.

        Args:
            sample: of the step, with its law's message.
            mean: v̂ of the step, (rows, width) [m/s].
            T: length of the step [s].
        """
        codec, layout, account = self._codec, self._layout, self._account
        fields, scalars = self._truth(sample)
        before, self._before = self._before, (sample.stamp, fields, scalars)
        if account is not None:
            account.earn(float(self._weight @ mean.ravel() ** 2), sample.stamp, T)
        error, said = 0.0, b""
        base = self._base
        if base is not None and 1 <= sample.index - base.index <= codec.hold:
            continued, told = base.at(sample.stamp, layout)
            error = self._error(continued[0] - fields[0])
            if self._close(fields, scalars, continued, told, base, sample.stamp) and self._affords(error, T):
                said = bytes([sample.index - base.index])
        if not said:
            said, self._base = self._content(sample, fields, scalars, before, T)
            error = self._error(self._base.fields[0] - fields[0])
            self.contents += 1
        else:
            self.unchanged += 1
        if account is not None:
            account.spend(error, sample.stamp, T)
        self.size += len(said)
        return said

    def _truth(self, sample: Sample) -> tuple[Float, Float]:
        layout = self._layout
        fields, scalars = np.empty((layout.fields, layout.size)), np.zeros(layout.scalars)
        fields[0] = sample.position.ravel()
        if sample.message is not None:
            fields[1:], scalars[:] = sample.message
        return fields, scalars

    def _content(
        self, sample: Sample, fields: Float, scalars: Float, before: tuple[float, Float, Float] | None, T: float
    ) -> tuple[bytes, _Content]:
        codec, layout = self._codec, self._layout
        rates, flow = np.zeros((layout.sums.size, layout.size)), np.zeros(layout.energies.size)
        if before is not None and sample.stamp > before[0]:
            passed = sample.stamp - before[0]
            rates = (fields - before[1])[layout.sums] / passed
            # Less than it was, for what is told of an energy must stay below the truth.
            flow = (1.0 - codec.deadband) * np.maximum((scalars - before[2])[layout.energies], 0.0) / passed
        numbers = np.concatenate([fields.ravel(), rates.ravel(), scalars, flow])
        if codec.quantum > 0.0 and (found := layout.rounded(numbers, codec.quantum)) is not None:
            content = layout.content(sample.index, sample.stamp, found[1])
            if self._affords(self._error(content.fields[0] - fields[0]), T):
                return bytes([_ROUNDED]) + found[0], content
        whole = layout.content(sample.index, sample.stamp, numbers)
        return bytes([_FULL]) + numbers.astype("<f8").tobytes(), whole

    def _close(
        self, fields: Float, scalars: Float, continued: Float, told: Float, base: _Content, stamp: float
    ) -> bool:
        """Whether what both ends continue is as good as the truth, and promises no energy that is not there."""
        layout, deadband = self._layout, self._codec.deadband
        if (told[layout.energies] > scalars[layout.energies]).any():
            return False
        off, slack = continued - fields, self._codec.quantum * np.sqrt(layout.size)
        grown = base.rates * (stamp - base.stamp)
        if (_norms(off[layout.sums]) > deadband * _norms(grown) + slack).any():
            return False
        if (_norms(off[layout.values]) > deadband * _norms(base.fields[layout.values]) + slack).any():
            return False
        others = layout.others
        return bool((np.abs(told - scalars)[others] <= deadband * np.abs(base.scalars[others])).all())

    def _error(self, off: Float) -> float:
        return float(self._weight @ off**2) if self._account is not None else 0.0

    def _affords(self, error: float, T: float) -> bool:
        return self._account is None or self._account.affords(error, T)


@final
class Decoder:
    """What one end of a link makes of what its neighbour says.

    Of what is not whole it makes nothing, and of what goes on from a content that is lost neither; then the sample
    before it stays, and its age grows.
    """

    def __init__(self, codec: Codec, law: Law, shape: tuple[int, int], sender: int) -> None:
        """Starts with nothing heard.

        Args:
            codec: of the sender.
            law: of the link.
            shape: of x̂, (rows, width).
            sender: index of the neighbour.
        """
        self._codec, self._layout, self._sender = codec, _Layout(law, shape), sender
        self._contents: dict[int, _Content] = {}
        self._waiting: dict[int, tuple[int, float]] = {}  # what goes on from a content that has not come yet

    def decode(self, index: int, stamp: float, data: bytes) -> Sample | None:
        """The sample that was meant; None where there is none.

        Args:
            index: of the sender's step, >= 0.
            stamp: middle of that step on the sender's clock [s].
            data: from the network.
        """
        if not data or index < 0 or not np.isfinite(stamp):
            return None
        newest = max(self._contents, default=index)
        if len(data) == 1:
            since = data[0]
            base = index - since
            if not 1 <= since <= self._codec.hold or base < 0:
                return None
            if base in self._contents:
                return self._sample(self._contents[base], index, stamp)
            if base > newest - self._codec.hold and len(self._waiting) <= self._codec.hold:
                self._waiting[base] = max(self._waiting.get(base, (-1, 0.0)), (index, stamp))
            return None
        if index in self._contents or index < newest - self._codec.hold:
            return None
        numbers = self._layout.read(data, self._codec.quantum)
        if numbers is None:
            return None
        content = self._layout.content(index, stamp, numbers)
        self._contents[index] = content
        newest = max(newest, index)
        later = self._waiting.pop(index, None)
        for kept in (self._contents, self._waiting):
            for old in [at for at in kept if at < newest - self._codec.hold]:
                del kept[old]
        return self._sample(content, *(later or (index, stamp)))

    def _sample(self, content: _Content, index: int, stamp: float) -> Sample | None:
        layout = self._layout
        fields, scalars = content.at(stamp, layout)
        if stamp < content.stamp or not (np.isfinite(fields).all() and np.isfinite(scalars).all()):
            return None
        return Sample(
            sender=self._sender,
            index=index,
            stamp=stamp,
            position=fields[0].reshape(layout.shape),
            message=(fields[1:], scalars),
            content=content.index,
        )


def _norms(fields: Float) -> Float:
    return np.sqrt((fields**2).sum(axis=1))
