"""The perceptual codec: a sample is said in one byte while it goes on as said before; errors are paid for.

Until the next content (`cotouch.peer._content`) both ends continue the last alike: sums at their rate, values as they
were. While that is nearer to the truth than people notice, the sender says only since how many steps it goes on: a
deadband [Hinterseer, Hirche, Chaudhuri, Steinbach & Buss 2008] with prediction. What it does to energy, with proofs:
docs/codec.md.
"""

from collections import deque
from collections.abc import Sequence
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.peer._content import FULL, ROUNDED, Content, ContentForm, norms
from cotouch.peer._links import PLAIN, LinkHeader, Sample

# What is left out may cost at most this part of what the account holds: after a large error that emptied it, all would
# have to be said in full for as long as that error may be in use.
_RESERVE = 16.0
# Deadbands that are told later of what energies grow by in a step, and half of it at most.
_LATE = 5.0
# What single precision leaves of a number.
_SINGLE = 1e-7


@final
class Account:
    """What the damping of a copy has paid for the errors of what it says to a neighbour.

    The receiver's spring to a sample that is wrong by e makes at most `½K(ε‖v_i‖² + ‖e‖²/ε)` of power. Damping ½Kε of
    its own pays for the first part. Another ½Kε at the sender pays for the second: per ½K, it earns ε‖v̂‖² and spends
    the largest ‖e‖²/ε of all that may still be in use. It never promises what it has not earned.

    Attributes:
        window: how long after its stamp a sample may be in use [s].
    """

    def __init__(self, age: float, window: float) -> None:
        """Starts with nothing.

        Args:
            age: ε, > 0 [s].
            window: how long after its stamp a sample may be in use [s].
        """
        self._age, self.window = age, window
        self._left = 0.0
        self._errors: deque[tuple[float, float]] = deque()  # stamps and squared errors, those not outdone since

    def begin(self) -> None:
        """Forgets what was earned before the link's spring was there: no recording tells of that."""
        self._left = 0.0
        self._errors.clear()

    def earn(self, square: float, now: float, T: float) -> None:
        """Takes what a step dissipated, and forgets what is no longer in use.

        Args:
            square: ‖v̂‖² of the step, in the link's weight.
            now: stamp of the step [s].
            T: length of the step [s].
        """
        self._left += T * self._age * square
        while self._errors and self._errors[0][0] < now - 0.5 * T - self.window:
            self._errors.popleft()

    def affords(self, error: float, T: float) -> bool:
        """Whether a squared error is paid for as long as it may be in use.

        Args:
            error: ‖e‖² in the link's weight.
            T: length of the step [s].
        """
        worst = max(error, self._errors[0][1] if self._errors else 0.0)
        return error == 0.0 or self._left >= (self.window + T) * worst / self._age

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
class Encoder:
    """Decides how one end of a link sends each sample.

    Attributes:
        account: what its damping has paid for; None for a law that is passive whatever it is told.
        contents: how many samples it said in full.
        unchanged: how many in one byte.
        size: of all that it said [bytes].
        said: of the last sample: `FULL`, `ROUNDED`, or since how many steps it goes on.
    """

    def __init__(
        self,
        form: ContentForm,
        weight: Float,
        shape: tuple[int, int],
        window: float,
        *,
        parts: Sequence[slice] | None = None,
    ) -> None:
        """Starts with nothing said.

        Args:
            form: of contents; a law that needs damping for the age of samples gets an `Account`.
            weight: diagonal of W, flat, (size,).
            shape: of x̂ without padding, (rows, axes).
            window: how long after its stamp a sample may be in use [s].
            parts: rows that contents are cut into; None: they are not cut.
        """
        self._form, self._weight, self._shape = form, weight, shape
        self._codec, self._size = form.codec, shape[0] * shape[1]
        parts = [slice(0, shape[0])] if parts is None else parts
        self._parts = [slice(part.start * shape[1], part.stop * shape[1]) for part in parts]
        self.account = Account(self._codec.age, window) if form.law.rule > 0.0 else None
        self._base: Content | None = None
        self._before: tuple[float, Float, Float] | None = None
        self.contents = self.unchanged = self.size = self.said = 0

    def encode(self, sample: Sample, mean: Float, T: float, *, exact: bool = False) -> list[bytes]:
        """What the neighbour is told of a sample: one byte, or a content for every part.

        Args:
            sample: of the step, with its law's message.
            mean: v̂ of the step, (rows, axes and padding) [m/s].
            T: length of the step [s].
            exact: whether it must be said in full numbers.
        """
        form, hold = self._form, self._codec.hold
        fields, scalars = self._truth(sample)
        before, self._before = self._before, (sample.stamp, fields, scalars)
        self._earn(sample.stamp, mean, T)
        error, base, words = 0.0, self._base, list[bytes]()
        if not exact and base is not None and 1 <= sample.index - base.index <= hold:
            continued, told = form.at(base, sample.stamp, T)
            error = self._error(continued[0] - fields[0])
            near = self._close(fields, scalars, continued, told, base, sample.stamp)
            if near and self._affords(_RESERVE * error, T):
                self.said = sample.index - base.index
                words = [bytes([self.said])]
        if not words:
            self._base, self.said = self._content(sample, fields, scalars, before, T, exact=exact)
            words = [form.pack(self._base.part(part), self.said) for part in self._parts]
            error = self._error(self._base.fields[0] - fields[0])
            self.contents += 1
        else:
            self.unchanged += 1
        if self.account is not None:
            self.account.spend(error, sample.stamp, T)
        self.size += sum(map(len, words))
        return words

    def skip(self, stamp: float, mean: Float, T: float) -> None:
        """Books a step of which nothing is said.

        Args:
            stamp: of the step [s].
            mean: v̂ of the step, (rows, axes and padding) [m/s].
            T: length of the step [s].
        """
        self._earn(stamp, mean, T)
        if self.account is not None:
            self.account.spend(0.0, stamp, T)

    def _earn(self, stamp: float, mean: Float, T: float) -> None:
        if self.account is not None:
            self.account.earn(float(self._weight @ mean[:, : self._shape[1]].ravel() ** 2), stamp, T)

    def _truth(self, sample: Sample) -> tuple[Float, Float]:
        form, (rows, axes) = self._form, self._shape
        fields, scalars = np.empty((form.fields, self._size)), np.zeros(form.scalars)
        fields[0] = sample.position[:, :axes].ravel()
        if sample.message is not None:
            told = sample.message[0].reshape(form.fields - 1, rows, sample.position.shape[1])[:, :, :axes]
            fields[1:], scalars[:] = told.reshape(form.fields - 1, self._size), sample.message[1]
        return fields, scalars

    def _content(
        self,
        sample: Sample,
        fields: Float,
        scalars: Float,
        before: tuple[float, Float, Float] | None,
        T: float,
        *,
        exact: bool,
    ) -> tuple[Content, int]:
        form, codec = self._form, self._codec
        rates, flow = np.zeros((form.rated.size, self._size)), np.zeros(form.energies.size)
        if before is not None and sample.stamp > before[0]:
            passed = sample.stamp - before[0]
            rates = (fields - before[1])[form.rated] / passed
            # Less than it was, for what is told of an energy must stay below the truth.
            flow = (1.0 - codec.deadband) * np.maximum((scalars - before[2])[form.energies], 0.0) / passed
            # Nor can it go on if it is told to the last, as soon as less flows.
            scalars = scalars.copy()
            scalars[form.energies] -= min(_LATE * codec.deadband, 0.5) * passed * flow
        true = Content(index=sample.index, stamp=sample.stamp, fields=fields, rates=rates, scalars=scalars, flow=flow)
        found = form.rounded(true) if codec.quantum > 0.0 and not exact else None
        if found is not None and self._affords(self._error(found.fields[0] - fields[0]), T):
            return found, ROUNDED
        return form.exact(true), FULL

    def _close(self, fields: Float, scalars: Float, continued: Float, told: Float, base: Content, stamp: float) -> bool:
        """Whether what both ends continue is as good as the truth, and promises no energy that is not there."""
        form, deadband = self._form, self._codec.deadband
        if (told[form.energies] > scalars[form.energies]).any():
            return False
        off, slack = continued - fields, self._codec.quantum * np.sqrt(self._size)
        grown, values = form.scales(base, stamp - base.stamp)
        if (norms(off[form.sums]) > deadband * grown + slack).any():
            return False
        if (norms(off[form.values]) > deadband * values + slack).any():
            return False
        others = form.others
        if (told[form.counts] != scalars[form.counts]).any():
            return False
        near = max(deadband, _SINGLE)
        return bool((np.abs(told - scalars)[others] <= near * np.abs(base.scalars[others])).all())

    def _error(self, off: Float) -> float:
        return float(self._weight @ off**2) if self.account is not None else 0.0

    def _affords(self, error: float, T: float) -> bool:
        return self.account is None or self.account.affords(error, T)


@final
class Decoder:
    """Turns the codec messages of one neighbour into samples.

    Of what is not whole it makes nothing, and of what goes on from a content that is lost neither; then the sample
    before it stays, and its age grows.
    """

    def __init__(self, form: ContentForm, shape: tuple[int, int], sender: int, *, width: int | None = None) -> None:
        """Starts with nothing heard.

        Args:
            form: of contents.
            shape: of x̂ without padding, (rows, axes); of the part that is sent here.
            sender: index of the neighbour.
            width: axes with padding, which is 0; None: there is none.
        """
        self._form, self._shape, self._sender = form, shape, sender
        self._padding = 0 if width is None else width - shape[1]
        self._contents: dict[int, Content] = {}
        # What goes on from a content that has not come yet.
        self._waiting: dict[int, tuple[int, float, float, LinkHeader]] = {}

    def decode(self, index: int, stamp: float, T: float, data: bytes, header: LinkHeader = PLAIN) -> Sample | None:
        """The sample that was meant; None where there is none.

        Args:
            index: of the sender's step, >= 0.
            stamp: middle of that step on the sender's clock [s].
            T: its length [s].
            data: from the network.
            header: of the sender's guard.
        """
        hold = self._form.codec.hold
        if not data or index < 0 or not np.isfinite(stamp):
            return None
        newest = max(self._contents, default=index)
        if len(data) == 1:
            since = data[0]
            base = index - since
            if not 1 <= since <= hold or base < 0:
                return None
            if base in self._contents:
                return self._sample(self._contents[base], index, stamp, T, header)
            if base > newest - hold and len(self._waiting) <= hold:
                said = self._waiting.get(base)
                if said is None or said[0] < index:
                    self._waiting[base] = index, stamp, T, header
            return None
        if index in self._contents or index < newest - hold:
            return None
        content = self._form.read(data, self._shape[0] * self._shape[1], index, stamp)
        if content is None:
            return None
        self._contents[index] = content
        newest = max(newest, index)
        later = self._waiting.pop(index, None)
        for kept in (self._contents, self._waiting):
            for old in [at for at in kept if at < newest - hold]:
                del kept[old]
        return self._sample(content, *(later or (index, stamp, T, header)))

    def _sample(self, content: Content, index: int, stamp: float, T: float, header: LinkHeader) -> Sample | None:
        fields, scalars = self._form.at(content, stamp, T)
        if stamp < content.stamp or not (np.isfinite(fields).all() and np.isfinite(scalars).all()):
            return None
        rows, axes = self._shape
        told = fields.reshape(-1, rows, axes)
        if self._padding:
            told = np.pad(told, ((0, 0), (0, 0), (0, self._padding)))
        return Sample(
            sender=self._sender,
            index=index,
            stamp=stamp,
            position=told[0],
            header=header,
            message=(told[1:].reshape(fields.shape[0] - 1, told[0].size), scalars),
            content=content.index,
        )
