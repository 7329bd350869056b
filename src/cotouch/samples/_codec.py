"""A sample on the wire: a head of 92 bytes and the numbers of one chunk, little-endian.

::

    version u8 | coding u8 | flags u16 | epoch u32 | sender u16 | rows u16 | first row u32 |
    received: greatest sequence u32 | heard: count u32 | index u64 |
    stamp | T | echo | held | age | worst, float64 each |
    guard: given float64 | state u8 | epoch u8 | known epoch u8 | starved u8 |
    numbers of the link's law, float64 each | rows × axes numbers |
    fields of the law × rows × axes: float64 of those that are sums, then float32 of the others

With a perceptual codec, what follows the head is a content of those rows (`cotouch.peer.ContentForm`), or, of no rows,
one byte for all of them: since how many steps they go on as was said. Most of those are 41 bytes in all, while there
is nothing else to say::

    version u8 | coding u8 | epoch u32 | sender u16 | guard: state u8 | epoch u8 | known epoch u8 | starved u8 |
    index u64 | stamp float64 | T float32 | given float64 | since u8

Nothing in it raises: what cannot be right is refused with a reason.
"""

import struct
from collections.abc import Sequence
from math import copysign
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.peer import FULL, ROUNDED, LinkHeader, LinkState, Message, Sample
from cotouch.samples._chunk import AGED, BRIEF, ECHO, RENEW, Chunk, Coded, Heading, Refusal, Written
from cotouch.samples._layout import ENCODINGS, HEAD_BYTES, Layout

VERSION = 5
_FLAGS = ECHO | AGED | RENEW
_HEAD = struct.Struct("<BBHIHHIIIQdddddddBBBB")
assert _HEAD.size == HEAD_BYTES
# What the head's coding says besides encodings.
_CODED, _BRIEF_CODED = 3, 4
_BRIEF = struct.Struct("<BBIHBBBBQdfdB")
# 2^40 steps are 34 years at 1 kHz; a clock beyond 1e10 s is not one; no step takes longer than 10 s.
_LAST_INDEX = 1 << 40
_LAST_TIME = 1e10
_LONGEST_STEP = 10.0
_MOST_GIVEN = 1e12  # [J]
_MOST_OF_LAW = 1e12  # of any number that a link law sends, in its own unit
# Of what a law says: sums, and the others.
_EXACT, _COARSE = np.dtype("<f8"), np.dtype("<f4")
_FEW = 16


@final
class SampleCodec:
    """Writes and reads samples of one layout."""

    def __init__(self, layout: Layout) -> None:
        self.layout = layout
        self._encoding, self._axes, self._chunk = ENCODINGS.index(layout.encoding), layout.axes, layout.chunk
        self._form = layout.form
        if self._form is not None:
            self._encoding = _CODED
        self._wire = layout.dtype
        self._item = layout.dtype.itemsize * layout.axes
        self._spans = [layout.span(chunk) for chunk in range(layout.chunks)]
        self._starts = np.array([span.start for span in self._spans])
        self._places: list[tuple[int, int]] = [(span.start, span.stop - span.start) for span in self._spans]
        self._head = HEAD_BYTES + 8 * layout.scalars
        self._says = bool(layout.fields or layout.scalars)
        sums = [field for field in range(layout.fields) if field not in layout.coarse]
        self._sums, self._coarse = _run(sums), _run(layout.coarse)
        self._numbers: list[tuple[int, int]] = [
            (len(sums) * n * layout.axes, len(layout.coarse) * n * layout.axes) for _, n in self._places
        ]
        self._sizes = [{self._head + count * (self._item + layout.row_bytes)} for _, count in self._places]
        if self._form is not None:
            kinds, axes = (FULL, ROUNDED), layout.axes
            self._sizes = [{HEAD_BYTES + self._form.size(k, n * axes) for k in kinds} for _, n in self._places]
        # Rounding is monotone: what is within the limit before it is within the rounded limit after it.
        self._bits = np.dtype(f"<u{self._wire.itemsize}")
        self._unsigned = self._bits.type((1 << 8 * self._wire.itemsize - 1) - 1)
        # In half precision a sum of squares says little.
        self._surely = 0.99 * layout.limit**2 if layout.encoding != "float16" else -1.0
        limit = np.array(layout.limit, dtype=self._wire)
        self._limit, self._most = int(limit.view(self._bits)), float(limit)

    def write(self, state: Float) -> Written | Refusal:
        """Puts a state into numbers of the wire; refused if no receiver would take them.

        Args:
            state: (rows, width).
        """
        layout = self.layout
        exact = layout.reduce(state)
        if layout.encoding != "float64" and not float(np.abs(exact).max()) <= layout.limit:  # would not even round
            return Refusal.STATE
        wire = np.ascontiguousarray(exact, dtype=self._wire)
        if not self._within(wire.reshape(-1)):
            return Refusal.STATE
        raw, item = wire.tobytes(), self._item
        bodies = [raw[span.start * item : span.stop * item] for span in self._spans]
        if layout.encoding == "float64" and layout.basis is None:
            return Written(bodies, state, np.zeros(len(bodies)))
        seen = np.zeros_like(state)
        layout.expand(wire.astype(np.float64), seen)
        error = np.abs(seen - state)[:, : layout.axes].max(axis=1)
        return Written(bodies, seen, np.maximum.reduceat(error, self._starts))

    def told(self, message: Message | None) -> list[tuple[bytes, bytes]] | Refusal:
        """What a link's law tells a neighbour, for each chunk: numbers before the state's, and fields after them.

        Args:
            message: of the law; None: nothing, which only a layout without a law may say.
        """
        layout = self.layout
        if not self._says:
            return [(b"", b"")] * len(self._spans)
        if message is None:
            return Refusal.LAW
        fields, scalars = message[0].reshape(layout.fields, layout.rows, layout.width), message[1]
        if scalars.size != layout.scalars:
            return Refusal.LAW
        if not (self._surely_within(message[0].reshape(-1), scalars) or _usable(fields, scalars)):
            return Refusal.LAW
        said, axes = np.asarray(scalars, _EXACT).tobytes(), slice(layout.axes)
        exact, coarse = np.asarray(fields[self._sums], _EXACT), fields[self._coarse].astype(_COARSE)
        parts = [(exact[:, span, axes], coarse[:, span, axes]) for span in self._spans]
        return [(said, precise.tobytes() + rough.tobytes()) for precise, rough in parts]

    def datagram(self, heading: Heading, chunk: int, body: bytes, told: tuple[bytes, bytes] = (b"", b"")) -> bytes:
        """The datagram of a chunk, still open.

        Args:
            heading: what the datagram says besides the state.
            chunk: which part of the state.
            body: what it carries.
            told: what the link's law says with it.
        """
        first, rows = self._places[chunk]
        head = self._pack(heading, first, rows)
        return head + told[0] + body + told[1]

    def coded(self, heading: Heading, chunk: int | None, data: bytes, *, brief: bool = False) -> bytes:
        """The datagram of what a perceptual codec says, still open.

        Args:
            heading: what the datagram says besides.
            chunk: which part of the state; None: all of it goes on.
            data: of the encoder.
            brief: whether of the heading goes only what no step can do without; of all that goes on.
        """
        if brief:
            state, guard, known, given, starved = heading.header
            words = (
                heading.epoch,
                heading.sender,
                state,
                guard,
                known,
                starved,
                heading.step,
                heading.stamp,
                heading.T,
                given,
            )
            return _BRIEF.pack(VERSION, _BRIEF_CODED, *words, data[0])
        first, rows = (0, 0) if chunk is None else self._places[chunk]
        return self._pack(heading, first, rows) + data

    def _pack(self, heading: Heading, first: int, rows: int) -> bytes:
        epoch, sender, step, stamp, T, flags, newest, count, echo, held, age, worst, header = heading
        state, guard, known, given, starved = header
        return _HEAD.pack(
            VERSION,
            self._encoding,
            flags,
            epoch,
            sender,
            rows,
            first,
            newest & 0xFFFF_FFFF,
            count & 0xFFFF_FFFF,
            step,
            stamp,
            T,
            echo,
            held,
            age,
            worst,
            given,
            state,
            guard,
            known,
            starved,
        )

    def read(self, payload: bytes, *, epoch: int, sender: int) -> Chunk | Coded | Refusal:
        """The chunk in a datagram, or what a codec says of one, or why it is of no use.

        Args:
            payload: as it was opened.
            epoch: of the session, now.
            sender: whose link it came by.
        """
        if len(payload) == _BRIEF.size and payload[1] == _BRIEF_CODED and self._form is not None:
            return self._read_brief(payload, epoch=epoch, sender=sender)
        if len(payload) < HEAD_BYTES:
            return Refusal.SHORT
        (
            version,
            encoding,
            flags,
            said,
            user,
            count,
            first,
            newest,
            received,
            index,
            stamp,
            T,
            echo,
            held,
            age,
            worst,
            given,
            state,
            guard,
            known,
            starved,
        ) = _HEAD.unpack_from(payload)
        if version != VERSION:
            return Refusal.VERSION
        if encoding != self._encoding:
            return Refusal.ENCODING
        if flags & ~_FLAGS:
            return Refusal.FLAGS
        if said != epoch:
            return Refusal.EPOCH
        if user != sender:
            return Refusal.SENDER
        chunk, rest = divmod(first, self._chunk)
        if self._form is not None and first == count == 0:
            chunk = None
            if len(payload) != HEAD_BYTES + 1:
                return Refusal.SIZE
            if not 1 <= payload[-1] <= self._form.codec.hold:
                return Refusal.RANGE
        elif rest or chunk >= len(self._spans) or count != self._places[chunk][1]:
            return Refusal.RANGE
        elif len(payload) not in self._sizes[chunk]:
            return Refusal.SIZE
        if index > _LAST_INDEX:
            return Refusal.INDEX
        # One comparison that is false for NaN stands for each.
        times = abs(stamp) <= _LAST_TIME and 0.0 < T <= _LONGEST_STEP
        times = times and abs(echo) <= _LAST_TIME and 0.0 <= held <= _LAST_TIME
        if not (times and -2.0 * _LAST_TIME <= age <= worst <= 2.0 * _LAST_TIME):
            return Refusal.TIME
        if not _of_guard(state, given, starved):
            return Refusal.GUARD
        header = LinkHeader(state, guard, known, given, bool(starved))
        heading = Heading(said, user, index, stamp, T, flags, newest, received, echo, held, age, worst, header)
        if chunk is None or self._form is not None:
            return Coded(heading, chunk, payload[HEAD_BYTES:])
        body = payload[HEAD_BYTES:]  # a copy, in which numbers begin where a machine reads them at once
        values = np.frombuffer(body, self._wire, count * self._axes, 8 * self.layout.scalars)
        if not self._says:
            return Chunk(heading, chunk, values.reshape(count, self._axes)) if self._within(values) else Refusal.STATE
        precise, rough = self._numbers[int(chunk)]
        told = self.layout.scalars
        exact = np.frombuffer(body, _EXACT, told + values.size + precise)
        coarse = np.frombuffer(body, _COARSE, rough, exact.nbytes)
        scalars, sums = exact[:told], exact[told + values.size :]
        if not self._surely_within(exact, coarse):
            if not self._within(values):
                return Refusal.STATE
            if not _usable(scalars, sums, coarse):
                return Refusal.LAW
        shape = (-1, count, self._axes)
        fields = np.empty((self.layout.fields, count, self._axes))
        fields[self._sums] = sums.reshape(shape)
        fields[self._coarse] = coarse.reshape(shape)
        values = values.reshape(count, self._axes)
        return Chunk(heading, chunk, values, scalars, fields)

    def _read_brief(self, payload: bytes, *, epoch: int, sender: int) -> Coded | Refusal:
        version, _, said, user, state, guard, known, starved, index, stamp, T, given, since = _BRIEF.unpack(payload)
        assert self._form is not None
        if version != VERSION:
            return Refusal.VERSION
        if said != epoch:
            return Refusal.EPOCH
        if user != sender:
            return Refusal.SENDER
        if not 1 <= since <= self._form.codec.hold:
            return Refusal.RANGE
        if index > _LAST_INDEX:
            return Refusal.INDEX
        if not (abs(stamp) <= _LAST_TIME and 0.0 < T <= _LONGEST_STEP):
            return Refusal.TIME
        if not _of_guard(state, given, starved):
            return Refusal.GUARD
        header = LinkHeader(state, guard, known, given, bool(starved))
        return Coded(Heading(said, user, index, stamp, T, BRIEF, header=header), None, payload[-1:])

    def decoded(self, heading: Heading, chunk: int, sample: Sample) -> Chunk | Refusal:
        """The chunk that a decoder found, if it is within what anybody takes.

        Args:
            heading: of the datagram that it was in.
            chunk: which part of the state.
            sample: of its rows.
        """
        assert sample.message is not None
        fields, scalars = sample.message
        if not self._within(sample.position.reshape(-1)):
            return Refusal.STATE
        if not _usable(scalars, fields):
            return Refusal.LAW
        head = heading._replace(step=sample.index, stamp=sample.stamp, header=sample.header)
        told = fields.reshape(self.layout.fields, *sample.position.shape)
        return Chunk(head, chunk, sample.position, scalars, told, sample.content)

    def _surely_within(self, *parts: npt.NDArray[np.floating]) -> bool:
        """Whether sums of squares say at once that all numbers are what a state's may be; never for NaN."""
        with np.errstate(all="ignore"):
            return all(float(part.dot(part)) <= self._surely for part in parts)

    def _within(self, values: npt.NDArray[np.floating]) -> bool:
        """Whether all numbers are finite and within the limit."""
        if values.size <= _FEW:  # the reader's own numbers cost less than a call about all of them
            most = self._most
            return all(-most <= value <= most for value in values.tolist())
        if self._surely_within(values):
            return True
        # Without their sign, floating point numbers are ordered as their bits are, infinity and NaN above all others;
        # and integers raise no flags, whatever is in them.
        return int((values.view(self._bits) & self._unsigned).max()) <= self._limit


def _of_guard(state: int, given: float, starved: int) -> bool:
    """Whether a guard can be so; false for -0, which is not below 0."""
    return state <= LinkState.COUPLED and starved <= 1 and copysign(1.0, given) > 0.0 and given <= _MOST_GIVEN


def _usable(*parts: npt.NDArray[np.floating]) -> bool:
    """Whether all numbers of a law are finite and within what is of any use; false for NaN."""
    with np.errstate(all="ignore"):
        return all(bool(np.abs(part).max(initial=0.0) <= _MOST_OF_LAW) for part in parts)


def _run(places: Sequence[int]) -> slice | list[int]:
    """Places one after the other as a slice, which costs less than a list of them."""
    if list(places) == list(range(places[0], places[-1] + 1) if places else ()):
        return slice(places[0], places[-1] + 1) if places else slice(0)
    return list(places)
