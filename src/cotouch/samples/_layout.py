"""How a state is cut into chunks and written in numbers; agreed once for the session."""

from dataclasses import dataclass, field
from typing import Literal, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.errors import SessionError
from cotouch.peer import FULL, ContentForm
from cotouch.samples._seal import OVERHEAD
from cotouch.samples._transport import MOST_BYTES

Encoding = Literal["float64", "float32", "float16"]
ENCODINGS: tuple[Encoding, ...] = ("float64", "float32", "float16")
HEAD_BYTES = 92
_ROOM = MOST_BYTES - OVERHEAD - HEAD_BYTES
# Largest relative error of rounding to nearest, and half the smallest number there is.
_ROUNDING = {"float64": (0.0, 0.0), "float32": (2.0**-24, 2.0**-150), "float16": (2.0**-11, 2.0**-25)}


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Layout:
    """Which rows travel in which chunk, and in which format.

    Each chunk can be used without the others: a node's spring needs only that node's sample. Where a basis is given,
    its coordinates travel instead of the rows, in one datagram, since every row needs all of them.

    Attributes:
        rows: of the session's model.
        width: of its rows, padding included.
        axes: columns that travel; the rest is zero.
        encoding: of a number on the wire.
        limit: largest number that is accepted; the default is beyond any position in metres.
        fields: of a link law, that travel beside the state, as the rows that they belong to.
        coarse: which of them are no sums, so that they travel as float32: an error of now is no error of later.
        scalars: numbers of a link law that travel with every chunk.
        form: of what a perceptual codec sends in full; None: there is none.
        basis: columns in which the state is sent, (rows, coordinates), of full rank; none: the rows themselves.
        sent: rows that travel: all of them, or as many as there are coordinates.
        chunk: rows in a chunk; the last one may be shorter.
    """

    rows: int
    width: int
    axes: int
    encoding: Encoding = "float64"
    limit: float = 1e4
    fields: int = 0
    coarse: tuple[int, ...] = ()
    scalars: int = 0
    form: ContentForm | None = None
    basis: Float | None = None
    sent: int = field(init=False)
    chunk: int = field(init=False)
    _inverse: Float | None = field(init=False, default=None, repr=False)

    def __post_init__(self) -> None:
        if not 1 <= self.axes <= self.width or self.rows < 1:
            raise SessionError(f"{self.rows} rows of {self.axes} axes in a width of {self.width} do not form a state")
        if self.encoding not in ENCODINGS:
            raise SessionError(f"coding {self.encoding!r} is unknown; it is one of {', '.join(ENCODINGS)}")
        most = float(np.finfo(self.dtype).max)
        if not 0.0 < self.limit < most:
            raise SessionError(f"limit is {self.limit}; with {self.encoding} it must be between 0 and {most:.6g}")
        if (self.fields or self.scalars) and (self.encoding != "float64" or self.basis is not None):
            raise SessionError("a link law's numbers are sent beside rows as float64; leave coding and basis out")
        if self.form is not None and (self.encoding != "float64" or self.basis is not None):
            raise SessionError("a perceptual codec has its own format on the wire; leave coding and basis out")
        if not set(self.coarse) <= set(range(self.fields)):
            raise SessionError(f"{self.fields} fields have no coarse ones {self.coarse}")
        fixed, each = 8 * self.scalars, self.axes * self.dtype.itemsize + self.row_bytes
        if self.form is not None:
            fixed = self.form.size(FULL, 0)
            each = self.axes * (self.form.size(FULL, 1) - fixed)
        room = max(_ROOM - fixed, 0) // each
        if room < 1:
            raise SessionError(
                f"{self.fields} fields and {self.scalars} numbers of a link law do not fit into a datagram"
            )
        sent = self.rows
        if self.basis is not None:
            sent = self.basis.shape[-1]
            if self.basis.shape != (self.rows, sent) or np.linalg.matrix_rank(self.basis) < sent:
                raise SessionError(
                    f"basis has the shape {self.basis.shape}; it must have {self.rows} rows and independent columns"
                )
            if sent > room:
                raise SessionError(f"basis has {sent} coordinates; {room} fit into one datagram as {self.encoding}")
            object.__setattr__(self, "_inverse", np.linalg.pinv(self.basis))
        object.__setattr__(self, "sent", sent)
        object.__setattr__(self, "chunk", min(room, sent))

    @property
    def row_bytes(self) -> int:
        """Of a row of all fields of a link law."""
        return self.axes * (8 * self.fields - 4 * len(self.coarse))

    @property
    def dtype(self) -> np.dtype[np.floating]:
        """Of a number on the wire, little-endian."""
        return np.dtype(self.encoding).newbyteorder("<")

    @property
    def chunks(self) -> int:
        """How many datagrams a state takes."""
        return -(-self.sent // self.chunk)

    def span(self, chunk: int) -> slice:
        """Which of the sent rows a chunk holds."""
        return slice(chunk * self.chunk, min((chunk + 1) * self.chunk, self.sent))

    def rounding(self, magnitude: float) -> float:
        """Bound on the rounding error of a number of at most this magnitude, before it is sent."""
        relative, absolute = _ROUNDING[self.encoding]
        return relative * magnitude + absolute

    def reduce(self, state: Float) -> Float:
        """What of a state travels, (sent, axes)."""
        values = state[:, : self.axes]
        return values if self._inverse is None else self._inverse @ values

    def expand(self, sent: npt.NDArray[np.floating], out: Float) -> None:
        """The state that the receiver sees, written into `out`, (rows, width).

        Args:
            sent: (rows, width) as it was sent.
            out: written to.
        """
        out[:, : self.axes] = sent if self.basis is None else self.basis @ sent
