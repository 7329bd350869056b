"""Why a datagram was refused: counted, never raised."""

from enum import Enum
from typing import final


@final
class Refusal(Enum):
    """Reasons, in the order in which they are looked for."""

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
