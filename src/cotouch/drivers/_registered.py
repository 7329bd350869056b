"""Drivers in the registry of devices, except Haply's; a vendor's library loads when a device is opened."""

import contextlib
from collections.abc import Sequence
from dataclasses import replace

from cotouch.device import PRESETS
from cotouch.drivers._dhd import count
from cotouch.drivers._evdev import gamepads
from cotouch.drivers._force_dimension import ForceDimension
from cotouch.drivers._gamepad import Gamepad
from cotouch.drivers._passive import PASSIVE
from cotouch.drivers._touch import Touch
from cotouch.errors import DeviceError
from cotouch.haptics import Device, Driver


def _force_dimension(
    *,
    variant: str | None = None,
    index: int = 0,
    library: str | None = None,
    watchdog: float = 0.02,
    velocity_threshold: int | None = None,
    wait: float = 20.0,
) -> Device:
    return ForceDimension(
        index,
        family=variant,
        library=library,
        watchdog=float(watchdog),
        velocity_threshold=velocity_threshold,
        reset_seconds=float(wait),
    )


def _touch(*, name: str | None = None, library: str | None = None, wait: float = 20.0, reset: bool = False) -> Device:
    return Touch(name, library=library, hand_seconds=float(wait), reset=reset is True)


def _gamepad(*, path: str | None = None, speed: float = 0.2) -> Device:
    return Gamepad(path, speed=float(speed))


def _recorded(*, path: str = "", tool: int = 1, repeat: bool = False) -> Device:
    from cotouch.drivers._recorded import RecordedHand

    if not path:
        raise DeviceError("the device recorded needs the recording to play, as in recorded:path=ada.mcap")
    return RecordedHand(path, tool=tool, repeat=repeat)


def _present_force_dimension() -> Sequence[str]:
    with contextlib.suppress(DeviceError):
        return [f"number {index}" for index in range(count())]
    return ()


FORCE_DIMENSION = Driver(
    name="force_dimension",
    summary="Force Dimension omega, delta, sigma and lambda, and the Falcon, through the vendor's SDK",
    make=_force_dimension,
    spec=PRESETS["omega"],
    variants=("omega", "delta", "sigma", "lambda", "falcon"),
    options={
        "index": "number of the device in the SDK's order, from 0",
        "library": "file or folder of libdrd; else $COTOUCH_FORCE_DIMENSION, or where the system looks",
        "watchdog": "silence after which the device switches its forces off, 0.001 to 0.03 [s]; 0.02",
        "velocity_threshold": "speed at which the device brakes, in firmware units; can only be lowered",
        "wait": "time for a hand to put the handle into its rest [s]; 20",
    },
    watchdog="Firmware 3.0 and newer switches forces off after 20 ms without a command; older firmware does not.",
    present=_present_force_dimension,
    tested="a stub library with a firmware of its own; no device",
)
"""Force Dimension's devices."""

TOUCH = Driver(
    name="touch",
    summary="3D Systems Touch, Touch X and PHANToM through OpenHaptics",
    make=_touch,
    spec=PRESETS["touch"],
    options={
        "name": "name of the device in the vendor's setup; Default Device",
        "library": "file or folder of libHD; else $COTOUCH_OPENHAPTICS, or where the system looks",
        "wait": "time for a hand to put the stylus into the inkwell [s]; 20",
        "reset": "true: it is being held in its reset position; for a device that has no other calibration",
    },
    watchdog="Not published; the vendor's driver stops the servo with the program, and reportedly cuts the motors.",
    tested="a stub library with a scheduler of its own; no device",
)
"""3D Systems' devices."""

GAMEPAD = Driver(
    name="gamepad",
    summary="a gamepad on Linux: sticks move a point, rumble renders force",
    make=_gamepad,
    spec=PASSIVE,
    options={"path": "its event file; else the first gamepad", "speed": "maximum speed of the point [m/s]; 0.2"},
    watchdog="The kernel ends its rumble when the program dies; a rumble lasts 0.1 s.",
    present=gamepads,
    tested="a stand-in for its event file; no pad",
)
"""Gamepads."""

RECORDED = Driver(
    name="recorded",
    summary="the hand of a recording, replayed",
    make=_recorded,
    spec=replace(PASSIVE, name="recorded hand", rate=1000.0, resolution=1e-6),
    options={
        "path": "of the recording",
        "tool": "which tool, from 1",
        "repeat": "whether to play to and fro for ever: true or false",
    },
    watchdog="It has no motors.",
    tested="recordings",
)
"""Hands of recordings."""
