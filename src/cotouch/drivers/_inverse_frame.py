"""What the Inverse Service says: its first frame in full, later ones lean."""

import json
import math
from collections.abc import Mapping
from typing import Any, NamedTuple

from cotouch.errors import DeviceError

Triple = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
_NOWHERE = (math.nan, math.nan, math.nan)
_UPRIGHT = (0.0, 0.0, 0.0, 1.0)
_BUTTONS = ("a", "b", "c")


class InverseState(NamedTuple):
    """One device in one frame, in the vendor's axes.

    Attributes:
        position: of the cursor [m].
        velocity: of the cursor [m/s].
        force: that the service applies; NaN if it does not say [N].
        status: what the frame says of it; may be empty.
        buttons: of the handle; bit n is button n.
        orientation: of the handle, xyzw; None if there is none.
    """

    position: Triple
    velocity: Triple
    force: Triple
    status: Mapping[str, Any]
    buttons: int
    orientation: Quaternion | None


def read_frame(data: bytes) -> dict[str, Any]:
    """A message of the service.

    Raises:
        DeviceError: it is no JSON object.
    """
    try:
        frame = json.loads(data)
    except ValueError:
        frame = None
    if not isinstance(frame, dict):
        raise DeviceError(f"the Inverse Service sent {data[:40]!r}, which is no JSON object")
    return frame


def identities(frame: Mapping[str, Any]) -> list[str]:
    """`device_id` of every Inverse3 in a frame."""
    return [str(entry.get("device_id")) for entry in _entries(frame, "inverse3")]


def choose(frame: Mapping[str, Any], wanted: str | None) -> str:
    """Which Inverse3 of the first frame to use.

    Args:
        frame: as it came.
        wanted: its `device_id`; None: the only one.

    Raises:
        DeviceError: there is none, not this one, or more than one.
    """
    there = identities(frame)
    if not there:
        raise DeviceError("the Inverse Service knows no Inverse3; connect it, switch it on, and look into Haply Hub")
    if wanted is None and len(there) > 1:
        raise DeviceError(f"{len(there)} Inverse3 are connected; name one by its identity: {', '.join(there)}")
    if wanted is not None and wanted not in there:
        raise DeviceError(f'no Inverse3 has the identity "{wanted}"; connected: {", ".join(there)}')
    return wanted or there[0]


def read_state(frame: Mapping[str, Any], identity: str) -> InverseState:
    """What a frame says of one device.

    Args:
        frame: as it came.
        identity: `device_id` of the Inverse3.

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
    buttons, orientation = _handle(frame)
    force = _triple(state.get("current_cursor_force")) or _NOWHERE
    return InverseState(position, velocity, force, _mapping(entry.get("status")), buttons, orientation)


def read_event(data: bytes, identity: str) -> str | None:
    """Why an event of the service is a fault, as a sentence; None if it is none.

    Args:
        data: as it came.
        identity: `device_id` of the Inverse3.
    """
    event = read_frame(data)
    detail = _mapping(event.get("data"))
    whose = detail.get("device_id")
    if isinstance(whose, str) and whose != identity:
        return None
    name = str(event.get("name", ""))
    if name == "device-disconnected":
        return f"the Inverse3 {identity} was disconnected"
    if name == "device-safety-triggered":
        said = str(event.get("message") or "")
        kind = str(detail.get("safety_type", "of no said kind"))
        return f"the safety function of the Inverse3 {identity} was triggered: {kind}" + (f" ({said})" if said else "")
    return None


def _handle(frame: Mapping[str, Any]) -> tuple[int, Quaternion | None]:
    """Buttons and orientation of the first VerseGrip, by cable or without."""
    for grip in _entries(frame, "verse_grip"):
        state = _mapping(grip.get("state"))
        return int(bool(state.get("button"))), _quaternion(state.get("orientation"))
    for grip in _entries(frame, "wireless_verse_grip"):
        state = _mapping(grip.get("state"))
        pressed = _mapping(state.get("buttons"))
        mask = sum(1 << bit for bit, name in enumerate(_BUTTONS) if pressed.get(name))
        return mask, _quaternion(state.get("orientation"))
    return 0, None


def _entries(frame: Mapping[str, Any], kind: str) -> list[Mapping[str, Any]]:
    entries = frame.get(kind)
    return [entry for entry in entries if isinstance(entry, dict)] if isinstance(entries, list) else []


def _mapping(value: object) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _triple(value: object) -> Triple | None:
    """Numbers as they are, NaN too; None if one is missing or no number."""
    if not isinstance(value, dict):
        return None
    try:
        return float(value["x"]), float(value["y"]), float(value["z"])
    except KeyError:
        return None
    except (TypeError, ValueError):
        return _NOWHERE


def _quaternion(value: object) -> Quaternion:
    if not isinstance(value, dict):
        return _UPRIGHT
    try:
        return (
            float(value.get("x", 0.0)),
            float(value.get("y", 0.0)),
            float(value.get("z", 0.0)),
            float(value.get("w", 1.0)),
        )
    except (TypeError, ValueError):
        return _UPRIGHT
