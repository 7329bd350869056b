"""The perceptual codec of one link: what its end says to a neighbour, and what it makes of what that says."""

from dataclasses import replace
from typing import final

from cotouch.arrays import Float
from cotouch.peer import Decoder, Encoder, Sample
from cotouch.samples._chunk import RENEW, Chunk, Coded, Heading, Refusal
from cotouch.samples._codec import SampleCodec
from cotouch.samples._layout import HEAD_BYTES, Layout
from cotouch.samples._seal import OVERHEAD

# Echoes, ages and losses are told at least so often, and whenever a sample is said in full [s].
_TELL = 0.05


@final
class CodedLink:
    """Both directions of the codec on a link.

    Attributes:
        encoder: of this end's samples.
        full: bytes that a sample would take without a codec.
        age: so much older may samples be for what the damping pays for, at either end [s].
    """

    def __init__(self, layout: Layout, weight: Float, *, sender: int) -> None:
        """Starts with nothing said.

        Args:
            layout: of the session, with a form of contents.
            weight: diagonal of the link's weight, of each row, (rows,).
            sender: index of the neighbour.
        """
        assert layout.form is not None
        spans = [layout.span(chunk) for chunk in range(layout.chunks)]
        shape = layout.rows, layout.axes
        self.encoder = Encoder(layout.form, weight.repeat(layout.axes), shape, 0.0, parts=spans)
        self._decoders = [Decoder(layout.form, (span.stop - span.start, layout.axes), sender) for span in spans]
        plain = replace(layout, form=None)
        row = layout.axes * 8 + layout.row_bytes
        self.full = plain.chunks * (OVERHEAD + HEAD_BYTES + 8 * layout.scalars) + layout.rows * row
        self.age = layout.form.codec.age
        self._told = -float("inf")

    def say(
        self, codec: SampleCodec, heading: Heading, sample: Sample, mean: Float, T: float, *, exact: bool
    ) -> list[bytes]:
        """Datagrams, still open: of every chunk its content, or of all together that they go on.

        Args:
            codec: of the session's layout.
            heading: what they say besides.
            sample: of the step, with the law's message.
            mean: v̂ of the step, (rows, width) [m/s].
            T: length of the step [s].
            exact: whether it must be said in full numbers.
        """
        words = self.encoder.encode(sample, mean, T, exact=exact)
        goes_on = len(words[0]) == 1
        brief = goes_on and not heading.flags & RENEW and heading.stamp - self._told < _TELL
        if not brief:
            self._told = heading.stamp
        return [codec.coded(heading, None if goes_on else at, data, brief=brief) for at, data in enumerate(words)]

    def hear(self, codec: SampleCodec, coded: Coded) -> list[Chunk] | Refusal:
        """The chunks that are meant, or why there are none.

        Args:
            codec: of the session's layout.
            coded: what came.
        """
        heading, chunk, data = coded
        asked = range(len(self._decoders)) if chunk is None else (chunk,)
        found: list[Chunk] = []
        why = Refusal.BASELESS if chunk is None else Refusal.STALE
        for at in asked:
            sample = self._decoders[at].decode(heading.step, heading.stamp, heading.T, data, heading.header)
            if sample is None:
                continue
            made = codec.decoded(heading, at, sample)
            if isinstance(made, Refusal):
                why = made
            else:
                found.append(made)
        return found or why
