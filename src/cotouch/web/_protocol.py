"""What a page and its server say to each other: binary layouts, and what a page may ask for; checked before use."""

import json
import math
import struct
from typing import Annotated, Final, Literal, NamedTuple, final

from pydantic import Field, ValidationError

from cotouch.errors import PageError
from cotouch.files import table_of
from cotouch.observers import Command, HandMode, Pointer, read_command
from cotouch.scenario import Table

VERSION: Final = 3
# kind, version, copies, number, time [s], points, scale [m], echo, since the echoed pointer came [µs]
HEADER: Final = struct.Struct("<BBHIdIfII")
# slot, mode, flags, hands, age [s], target, place, force (3 each), radius, energy, supplied, lost, linked, node,
# edge (3)
COPY: Final = struct.Struct("<BBBBf3f3f3ffffffi3f")
DIRECT, HAS_HAND = 1, 2
# kind, slot, action, 0, number, point, target (3), radius, stiffness, client's time [ms], edge or turn (3)
_POINTER: Final = struct.Struct("<BBBBII3fffd3f")
# kind, 0, number, until the next frame is to be made, between two pictures [ms]
_ACK: Final = struct.Struct("<B3xIff")
_FRAME_KIND, _POINTER_KIND, _ACK_KIND = 1, 2, 3
_ACTIONS: Final[tuple[HandMode, ...]] = ("ball", "grab", "free", "blade", "pose")
# No body is so far away, no ball so big [m], no hand so stiff [N/m], and none turns so far [rad].
_FAR, _STIFF, _TURNED = 1e4, 1e5, 4.0
# No screen shows pictures faster, and none that counts slower [ms].
_FASTEST, _SLOWEST = 1.0, 1e3
MOST_BYTES: Final = 16_384  # of a message from a page: every pair of 32 users, written out, fits

Slot = Annotated[int, Field(ge=0, le=255)]


class PointerMessage(NamedTuple):
    """Where the pointer of a page is.

    Attributes:
        slot: that it acts for.
        point: index of the drawn point.
        pointer: the rest, by the page's own rising number; its node is not known to the page.
    """

    slot: int
    point: int
    pointer: Pointer


class FrameReceipt(NamedTuple):
    """A page took a frame.

    Attributes:
        number: of the frame.
        wait: in how long it wants the next one to be made, so that it comes just before a picture of its screen [s].
        every: between two pictures of its screen; 0: it does not know, and `wait` says nothing [s].
    """

    number: int
    wait: float
    every: float


@final
class Hello(Table):
    """What a page says first.

    Attributes:
        type: "hello".
        version: of the protocol.
        token: that lets it act; None: it only watches.
        slot: that it acts for; None: for nobody.
        want: which copies it is sent: all, or that of its slot.
        rate: of frames [1/s].
    """

    type: Literal["hello"]
    version: int
    token: Annotated[str, Field(max_length=200)] | None = None
    slot: Slot | None = None
    want: Literal["all", "mine"] = "all"
    rate: Annotated[float, Field(gt=0.0, le=240.0)] = 60.0


@final
class Do(Table):
    """What a page asks for; the rest of the message are the parts of a command.

    Attributes:
        type: "do".
        id: comes back with the answer.
        what: a command of `SessionApi.do`, or "control", which is the server's own: this page is to lead its slot.
        parts: all other entries.
    """

    type: Literal["do"]
    id: Annotated[int, Field(ge=0, lt=1 << 53)]
    what: Annotated[str, Field(pattern=r"^[a-z]{1,20}$")]
    parts: dict[str, object] = Field(default_factory=dict[str, object])

    def command(self) -> Command:
        """What the session is to do.

        Raises:
            SessionError: it is no command.
        """
        return read_command({**self.parts, "what": self.what})

    @property
    def control(self) -> bool:
        """Whether it is `TakeControl`."""
        return self.what == "control" and not self.parts


@final
class TakeControl(Table):
    """This page is to lead its slot, whoever led it before; the server's own, no command of a session."""

    what: Literal["control"] = "control"


_DO_FIELDS = ("type", "id", "what")


def read_binary(message: bytes) -> PointerMessage | FrameReceipt:
    """A pointer, or which frame is acknowledged.

    Raises:
        PageError: it is neither.
    """
    kind = message[0] if message else -1
    if kind == _POINTER_KIND and len(message) == _POINTER.size:
        return _pointer(message)
    if kind == _ACK_KIND and len(message) == _ACK.size and message[1:4] == b"\0\0\0":
        _, number, wait, every = _ACK.unpack(message)
        if not (0.0 <= wait <= _SLOWEST and (every == 0.0 or _FASTEST <= every <= _SLOWEST)):
            raise PageError(
                f"the next frame is wanted in {wait} ms, a picture every {every} ms; at most {_SLOWEST:.0f}"
            )
        return FrameReceipt(number, 1e-3 * wait, 1e-3 * every)
    raise PageError(f"a binary message of kind {kind} with {len(message)} bytes; pointers are 2, 52, acks 3, 16")


def _pointer(message: bytes) -> PointerMessage:
    _, slot, action, zero, number, point, x, y, z, radius, stiffness, sent, *last = _POINTER.unpack(message)
    if action >= len(_ACTIONS) or zero:
        raise PageError(f"the pointer's action is {action}; it must be 0 to 4, and the byte after it 0")
    mode = _ACTIONS[int(action)]
    moved, most, unit = ("turn", _TURNED, "rad") if mode == "pose" else ("edge", _FAR, "m")
    for name, given, within, of in (("target", (x, y, z), _FAR, "m"), (moved, last, most, unit)):
        if not all(abs(one) <= within for one in given):
            raise PageError(
                f"the pointer's {name} is {', '.join(map(str, given))}; it must be within {within:.0f} {of}"
            )
    if not (0.0 <= radius <= _FAR and 0.0 <= stiffness <= _STIFF and math.isfinite(sent)):
        raise PageError(f"the pointer's radius or stiffness is {radius} or {stiffness}, or its time {sent}")
    place = {"target": (x, y, z), moved: (last[0], last[1], last[2])}
    pointer = Pointer(number=number, mode=mode, node=-1, radius=radius, stiffness=stiffness, **place)
    return PointerMessage(slot, point, pointer)


def read_text(message: str) -> Hello | Do:
    """What a page asks for.

    Raises:
        PageError: it is nothing that can be asked for.
    """
    try:
        content = table_of(json.loads(message, parse_constant=_refuse))
        if content is None:
            raise PageError("a text message must be one JSON object")
        if content.get("type") == "do":
            rest = {name: value for name, value in content.items() if name not in _DO_FIELDS}
            return Do.model_validate({name: content[name] for name in _DO_FIELDS if name in content} | {"parts": rest})
        return Hello.model_validate(content)
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(part) for part in first["loc"]) or "the message"
        raise PageError(f"{place}: {first['msg']}") from error
    except (ValueError, RecursionError) as error:
        if isinstance(error, PageError):
            raise
        raise PageError("a text message must be JSON") from error


def _refuse(constant: str) -> float:
    raise PageError(f"a text message holds {constant}, which is no number of JSON")
