"""What datagrams of samples say, once they are read."""

from enum import Enum
from typing import NamedTuple, final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.peer import LinkHeader

ECHO = 1  # echo and held mean something
AGED = 2  # age and worst mean something
RENEW = 4  # the sender would like new keys
BRIEF = 8  # of what was read: it says nothing of echoes, ages and what was received
_PLAIN = LinkHeader()


class Heading(NamedTuple):
    """What a datagram contains besides the state.

    Attributes:
        epoch: of the session: which members, links and layout.
        sender: index of the user.
        step: its index, k.
        stamp: middle of the step, on the sender's clock [s].
        T: length of the step [s].
        flags: `ECHO`, `AGED`, `RENEW`, `BRIEF`.
        received_newest: greatest sequence number that the sender opened of the addressee's, modulo 2^32.
        received_count: how many datagrams of the addressee it opened, modulo 2^32.
        echo: newest stamp that the sender has of the addressee, on the addressee's clock [s].
        held: how long ago that arrived, on the sender's clock [s].
        age: end of the sender's step minus the oldest stamp in use, each on its own clock; so the age plus an unknown
            offset [s].
        worst: greatest of these in the sender's window [s].
        header: of the sender's guard of this link; see `cotouch.peer.LinkGuard`.
    """

    epoch: int
    sender: int
    step: int
    stamp: float
    T: float
    flags: int = 0
    received_newest: int = 0
    received_count: int = 0
    echo: float = 0.0
    held: float = 0.0
    age: float = 0.0
    worst: float = 0.0
    header: LinkHeader = _PLAIN


class Chunk(NamedTuple):
    """A datagram that can be used.

    Attributes:
        heading: what it says besides.
        chunk: which one of the layout.
        values: as on the wire, (rows of the chunk, axes).
        scalars: of the link's law, (scalars,); None: it says nothing.
        fields: likewise, of these rows, (fields, rows of the chunk, axes).
        content: number of the step whose content it continues; None: it is its own.
    """

    heading: Heading
    chunk: int
    values: npt.NDArray[np.floating]
    scalars: Float | None = None
    fields: Float | None = None
    content: int | None = None


class Coded(NamedTuple):
    """A datagram of a perceptual codec, which the link's decoder turns into chunks.

    Attributes:
        heading: what it says besides.
        chunk: which one of the layout; None: all, as they go on.
        data: for the decoder.
    """

    heading: Heading
    chunk: int | None
    data: bytes


class Written(NamedTuple):
    """A state as it is on the wire, the same for every neighbour.

    Attributes:
        bodies: of each chunk.
        state: what the receivers will see, (rows, width).
        error: greatest |state - x̂| of each chunk; of the only chunk over all rows where a basis is used.
    """

    bodies: list[bytes]
    state: Float
    error: Float


@final
class Refusal(Enum):
    """Reasons to refuse a datagram, in the order in which they are checked."""

    SHORT = "too short to be one of ours"
    VERSION = "another version of the format"
    CONNECTION = "no link of this number"
    EPOCH_OF_KEYS = "sealed in an epoch of keys that is over or not agreed"
    REPLAYED = "seen before, or too old to know"
    FORGED = "the seal does not fit"
    ENCODING = "another coding than the session's"
    FLAGS = "unknown flags"
    EPOCH = "another epoch of the session"
    SENDER = "sent in another user's name"
    RANGE = "no chunk of the session's layout"
    SIZE = "another size than its rows take"
    INDEX = "a step index beyond all use"
    TIME = "a stamp, echo, age or T that no clock gives"
    GUARD = "a guard's state that there is not"
    LAW = "numbers of a link law that are not finite or beyond all use"
    STATE = "a state that is not finite or beyond the session's limit"
    BASELESS = "goes on from a sample that did not come"
    STALE = "older than what is held"
    BACKWARDS = "a later step with an earlier stamp"
