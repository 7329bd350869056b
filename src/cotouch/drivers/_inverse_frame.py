"""What the Inverse Service says: its first frame in full, later ones lean."""

import json
import math
from collections.abc import Mapping
from typing import NamedTuple

from cotouch.errors import DeviceError
from cotouch.files import list_of, table_of

Triple = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
_NOWHERE = (math.nan, math.nan, math.nan)
_UPRIGHT = (0.0, 0.0, 0.0, 1.0)
_BUTTONS = ("a", "b", "c")
_GRIPS = ("verse_grip", "wireless_verse_grip", "custom_verse_grip")
# Levels of events that are no more than news.
_NEWS = ("info", "notice")
_MOST_FIELDS = 200


class Grip(NamedTuple):
    """A handle that belongs to a device.

    Attributes:
        kind: list of the frame that it is in.
        identity: its `device_id`.
        only: whether it was taken because there was no other, and no other device.
    """

    kind: str
    identity: str
    only: bool = False


class InverseState(NamedTuple):
    """One device in one frame, in the vendor's axes.

    Attributes:
        position: of the cursor [m].
        velocity: of the cursor [m/s].
        force: that the service applies; NaN if it does not say [N].
        status: what the frame says of it; may be empty.
        config: how it is set; empty in a lean frame.
        raw: its state as it came.
        buttons: of the handle; bit n is button n.
        orientation: of the handle, xyzw; None if there is none.
    """

    position: Triple
    velocity: Triple
    force: Triple
    status: Mapping[str, object]
    config: Mapping[str, object]
    raw: Mapping[str, object]
    buttons: int
    orientation: Quaternion | None


def read_frame(data: bytes) -> dict[str, object]:
    """A message of the service.

    Raises:
        DeviceError: it is no JSON object.
    """
    try:
        frame = table_of(json.loads(data))
    except ValueError:
        frame = None
    if frame is None:
        raise DeviceError(f"the Inverse Service sent {data[:40]!r}, which is not a JSON object")
    return frame


def identities(frame: Mapping[str, object]) -> list[str]:
    """`device_id` of every Inverse3 in a frame."""
    return [str(entry.get("device_id")) for entry in _entries(frame, "inverse3")]


def choose(frame: Mapping[str, object], wanted: str | None) -> str:
    """Which Inverse3 of the first frame to use.

    Args:
        frame: as it came.
        wanted: its `device_id`; None: the only one.

    Raises:
        DeviceError: there is none, not this one, or more than one.
    """
    there = identities(frame)
    if not there:
        raise DeviceError("the Inverse Service finds no Inverse3; connect it, switch it on, and check Haply Hub")
    if wanted is None and len(there) > 1:
        raise DeviceError(f"{len(there)} Inverse3 are connected; name one by its identity: {', '.join(there)}")
    if wanted is not None and wanted not in there:
        raise DeviceError(f'no Inverse3 has the identity "{wanted}"; connected: {", ".join(there)}')
    return wanted or there[0]


def grip_of(frame: Mapping[str, object], identity: str, wanted: str | None) -> Grip | None:
    """The handle that belongs to a device, in a full frame; None where that cannot be told for certain.

    A handle that names a device belongs to it and to no other; else the hand that both are for decides, if it does;
    else one device and one handle belong together. With the wrong one, a hand could re-arm the device of another.

    Args:
        frame: in full.
        identity: `device_id` of the Inverse3.
        wanted: `device_id` of the handle; None: see above.
    """
    devices = {str(entry.get("device_id")): entry for entry in _entries(frame, "inverse3")}
    grips = [(kind, entry) for kind in _GRIPS for entry in _entries(frame, kind)]
    if wanted is not None:
        return next((Grip(kind, wanted) for kind, entry in grips if str(entry.get("device_id")) == wanted), None)
    named = [(kind, entry, _names(entry, devices)) for kind, entry in grips]
    own = [(kind, entry) for kind, entry, names in named if names == {identity}]
    free = [(kind, entry) for kind, entry, names in named if not names]
    if not own and identity in devices:
        hand = _hand(devices[identity])
        alike = [other for other in devices.values() if hand is not None and _hand(other) == hand]
        own = [(kind, entry) for kind, entry in free if hand is not None and _hand(entry) == hand]
        own = own if len(alike) == 1 else []
    if own:
        return Grip(own[0][0], str(own[0][1].get("device_id"))) if len(own) == 1 else None
    if len(devices) == 1 and len(grips) == len(free) == 1 and _hand(free[0][1]) in {None, _hand(devices[identity])}:
        return Grip(free[0][0], str(free[0][1].get("device_id")), only=True)
    return None


def _names(entry: Mapping[str, object], devices: Mapping[str, object]) -> set[str]:
    """Which devices a handle names, wherever it does so in what is said of it beside its own identity."""
    found: set[str] = set()
    left: list[object] = [value for key, value in entry.items() if key != "device_id"]
    for _ in range(_MOST_FIELDS):
        if not left:
            break
        value = left.pop()
        if (inner := table_of(value)) is not None:
            left.extend(inner.values())
        elif (entries := list_of(value)) is not None:
            left.extend(entries)
        elif isinstance(value, str) and value in devices:
            found.add(value)
    return found


def _hand(entry: Mapping[str, object]) -> str | None:
    hand = _mapping(entry.get("config")).get("handedness", _mapping(entry.get("status")).get("handedness"))
    return hand if isinstance(hand, str) and hand in {"left", "right"} else None


def read_state(frame: Mapping[str, object], identity: str, grip: Grip | None = None) -> InverseState:
    """What a frame says of one device.

    Args:
        frame: as it came.
        identity: `device_id` of the Inverse3.
        grip: its handle; None: it has none.

    Raises:
        DeviceError: it is not in the frame, or its place or velocity is missing.
    """
    for entry in _entries(frame, "inverse3"):
        if entry.get("device_id") == identity:
            break
    else:
        raise DeviceError(f"the Inverse3 {identity} is gone from the service's list; is its cable loose?")
    state = _mapping(entry.get("state"))
    position, velocity = _triple(state.get("cursor_position")), _triple(state.get("cursor_velocity"))
    for name, value in (("cursor_position", position), ("cursor_velocity", velocity)):
        if value is None:
            raise DeviceError(f"the Inverse Service left out {name} of the Inverse3 {identity}")
    assert position is not None
    assert velocity is not None
    buttons, orientation = _handle(frame, grip)
    force = _triple(state.get("current_cursor_force")) or _NOWHERE
    status, config = _mapping(entry.get("status")), _mapping(entry.get("config"))
    return InverseState(position, velocity, force, status, config, state, buttons, orientation)


def read_event(data: bytes, identity: str, session: object = None) -> str | None:
    """Why an event of the service is a fault, as a sentence; None if it is none.

    The service pushes news to everybody. What ends a device is what its maker calls a warning or worse: that it is
    gone, that a safety function has acted, or that another session has it.

    Args:
        data: as it came.
        identity: `device_id` of the Inverse3.
        session: number of our own session; None if the service did not say.
    """
    event = read_frame(data)
    detail = _mapping(event.get("data"))
    family = detail.get("device_family")
    if str(detail.get("device_id", identity)) != identity or (isinstance(family, str) and "inverse" not in family):
        return None
    said = str(event.get("message") or "")[:200]
    behind = f" ({said})" if said else ""
    name = event.get("name")
    if name == "device-disconnected":
        return f"the Inverse3 {identity} was disconnected"
    if event.get("level") in _NEWS:
        return None
    if name == "device-safety-triggered":
        kind = str(detail.get("safety_type", "of no said kind"))[:80]
        if kind == "ebrake_released":
            return None
        return f"the safety function of the Inverse3 {identity} was triggered: {kind}{behind}"
    if name == "device-busy":
        holder = detail.get("session_id", detail.get("session"))
        if session is not None and holder == session:
            return None  # another wanted what we have
        who = next((text for key in ("profile", "profile_name", "session") if (text := named(detail.get(key)))), "")
        who = who or (f"number {holder}" if isinstance(holder, int) else "")
        return f"the Inverse3 {identity} is in use by another session{f' {who}' if who else ''}{behind}; end that first"
    return None


def named(session: object) -> str:
    """What a session calls itself; empty for nothing, and never long or with odd characters."""
    if (said := table_of(session)) is not None:
        profile = said.get("profile", said.get("profile_name", said.get("name")))
        session = profile if (table := table_of(profile)) is None else table.get("name")
    text = session if isinstance(session, str) else ""
    return "".join(letter for letter in text if letter.isprintable())[:60]


def _handle(frame: Mapping[str, object], grip: Grip | None) -> tuple[int, Quaternion | None]:
    """Buttons and orientation of a VerseGrip, by cable or without."""
    if grip is None:
        return 0, None
    if grip.only and (len(_entries(frame, "inverse3")) != 1 or sum(len(_entries(frame, kind)) for kind in _GRIPS) != 1):
        return 0, None  # another came; whose this is must be looked at anew
    for entry in _entries(frame, grip.kind):
        if str(entry.get("device_id")) == grip.identity:
            break
    else:
        return 0, None
    state, status = _mapping(entry.get("state")), _mapping(entry.get("status"))
    orientation = _quaternion(state.get("orientation"))
    if any(status.get(name) is False for name in ("connected", "awake", "ready")):
        return 0, orientation  # a handle that sleeps says what it said last
    pressed = _mapping(state.get("buttons"))
    mask = sum(1 << bit for bit, name in enumerate(_BUTTONS) if pressed.get(name))
    return mask | int(bool(state.get("button"))), orientation


def _entries(frame: Mapping[str, object], kind: str) -> list[Mapping[str, object]]:
    return [entry for entry in map(table_of, list_of(frame.get(kind)) or []) if entry is not None]


def _mapping(value: object) -> Mapping[str, object]:
    return table_of(value) or {}


def _triple(value: object) -> Triple | None:
    """Numbers as they are, NaN too; None if one is missing or no number."""
    place = table_of(value)
    if place is None:
        return None
    try:
        return _number(place["x"]), _number(place["y"]), _number(place["z"])
    except KeyError:
        return None
    except (TypeError, ValueError):
        return _NOWHERE


def _quaternion(value: object) -> Quaternion:
    turn = table_of(value)
    if turn is None:
        return _UPRIGHT
    try:
        return (
            _number(turn.get("x", 0.0)),
            _number(turn.get("y", 0.0)),
            _number(turn.get("z", 0.0)),
            _number(turn.get("w", 1.0)),
        )
    except (TypeError, ValueError):
        return _UPRIGHT


def _number(value: object) -> float:
    """As `float` has it; a list or an object is a `TypeError`."""
    if not isinstance(value, str | float | int):
        raise TypeError(value)
    return float(value)
