"""`cotouch devices`: what there is, whether it does what it must, and what it measures."""

import math
import sys
import time
from collections.abc import Callable
from contextlib import closing
from typing import NotRequired, TypedDict

import numpy as np
from rich.console import Console
from rich.live import Live
from rich.table import Column, Table

from cotouch.arrays import Float
from cotouch.cli._output import print_json
from cotouch.cli._session import stop_signals
from cotouch.errors import DeviceError
from cotouch.haptics import (
    COUPLING,
    Device,
    DeviceChoice,
    DeviceReading,
    Flag,
    ServoSettings,
    conform,
    device_names,
    driver,
    make_device,
    open_device,
    priority_refused,
    vector_of,
)
from cotouch.pacing import real_time_refused

_REDRAW = 10.0  # times a second


class _Row(TypedDict):
    """A driver; one that cannot be loaded says only why."""

    name: str
    summary: str
    variants: list[str]
    options: dict[str, str]
    present: list[str]
    force: NotRequired[float]
    rate: NotRequired[float]
    watchdog: NotRequired[str]
    tested: NotRequired[str]


def show(*, as_json: bool) -> None:
    """Lists all drivers that are installed, and what seems to be connected."""
    rows: list[_Row] = []
    for name in device_names():
        try:
            found = driver(name)
        except DeviceError as error:
            rows.append({"name": name, "summary": str(error), "variants": [], "options": {}, "present": []})
            continue
        rows.append(
            {
                "name": name,
                "summary": found.summary,
                "variants": list(found.variants),
                "options": dict(found.options),
                "force": found.spec.force,
                "rate": found.spec.rate,
                "watchdog": found.watchdog,
                "tested": found.tested,
                "present": list(found.present()),
            }
        )
    if as_json:
        print_json({"devices": rows, "coupling": dict(COUPLING)})
        return

    named = [[f":{variant}" for variant in row["variants"]] + [f"{name}=" for name in row["options"]] for row in rows]
    longest = max((len(name) for names in named for name in names), default=0)  # or a name would be cut
    table = Table("device", "description", "force", Column("options", min_width=longest), "connected")
    for row, names in zip(rows, named, strict=True):
        force = f"{row['force']:g} N" if "force" in row else ""
        table.add_row(row["name"], row["summary"], force, " ".join(names), ", ".join(row["present"]) or "unknown")
    console = Console()
    console.print(table)
    names = " ".join(f"{name}=" for name in COUPLING)
    said = f"With join, every device also takes these coupling options: {names} (docs/devices.md)"
    console.print(said, highlight=False, markup=False, soft_wrap=not console.is_terminal)


def check(text: str, *, allow_motion: bool, force: bool, as_json: bool) -> bool:
    """Runs the checks that every device must pass; whether it did.

    Args:
        text: device as named on the command line.
        allow_motion: whether the device may move by itself.
        force: whether motors may be switched on.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    choice = DeviceChoice.read(text)
    make_device(choice.name, **choice.options)  # what is wrong with the options is said at once
    found = conform(lambda: make_device(choice.name, **choice.options), allow_motion=allow_motion, force=force)
    passed = all(finding.passed for finding in found)
    refused = real_time_refused(ServoSettings.real_time or 1)  # as its servo will ask
    if as_json:
        checks = [{"check": one.check, "passed": one.passed, "detail": one.detail} for one in found]
        print_json({"device": text, "passed": passed, "checks": checks, "real_time_refused": refused})
        return passed
    for one in found:
        sys.stdout.write(f"{'ok  ' if one.passed else 'FAIL'}  {one.check}: {one.detail}\n")
    failed = sum(not one.passed for one in found)
    if refused:
        sys.stdout.write(f"WARN  {priority_refused(refused)}\n")
    verdict = "passes all checks" if passed else f"fails {failed} of {len(found)} checks"
    sys.stdout.write(f"{text} {verdict}\n")
    return passed


def calibrate(text: str, *, allow_motion: bool, as_json: bool) -> None:
    """Makes a device's places absolute.

    Args:
        text: device as named on the command line.
        allow_motion: whether the device may move by itself.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    with closing(_opened(text)) as device:
        device.calibrate(allow_motion=allow_motion)
        reading = device.exchange(np.zeros(3))
    place, calibrated = reading.position.tolist(), Flag.CALIBRATED in reading.flags
    if as_json:
        print_json({"device": text, "calibrated": calibrated, "position": place})
        return
    where = ", ".join(f"{1e3 * value:.1f}" for value in place)
    state = "is calibrated" if calibrated else "does not report that it is calibrated"
    sys.stdout.write(f"{text} {state}; its tip is at ({where}) mm from the centre of its workspace\n")


def monitor(text: str, *, seconds: float | None, as_json: bool) -> None:
    """Shows what a device measures, with its motors off.

    Args:
        text: device as named on the command line.
        seconds: ends after so long [s]; None: does not.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    with closing(_opened(text)) as device:
        device.calibrate(allow_motion=False)
        with stop_signals() as stopped:
            cycles, slowest, last = _watch(device, seconds, stopped, quiet=as_json)
    if as_json:
        print_json(
            {
                "device": text,
                "cycles": cycles,
                "slowest": slowest,
                "position": last.position.tolist(),
                "velocity": last.velocity.tolist(),
                "orientation": None if last.orientation is None else last.orientation.tolist(),
                "buttons": last.buttons,
                "flags": _flags(last.flags),
            }
        )
    else:
        sys.stdout.write(f"{cycles} cycles; the slowest exchange took {1e3 * slowest:.2f} ms\n")


def _watch(
    device: Device, seconds: float | None, stopped: Callable[[], bool], *, quiet: bool
) -> tuple[int, float, DeviceReading]:
    period = 1.0 / min(device.spec.rate, 1000.0)
    begun = drawn = time.monotonic()
    cycles, slowest = 0, 0.0
    with Live(console=Console(stderr=True, quiet=quiet), auto_refresh=False) as live:
        while True:
            before = time.monotonic()
            last = device.exchange(np.zeros(3))
            now = time.monotonic()
            cycles, slowest = cycles + 1, max(slowest, now - before)
            if now - drawn > 1.0 / _REDRAW and not quiet:
                drawn = now
                live.update(_line(last), refresh=True)
            if stopped() or (seconds is not None and now - begun >= seconds):
                return cycles, slowest, last
            time.sleep(max(0.0, period - (now - before)))


def _line(reading: DeviceReading) -> str:
    place = "  ".join(f"{axis} {1e3 * value:+7.2f}" for axis, value in zip("xyz", reading.position, strict=True))
    speed = float(np.linalg.norm(reading.velocity))
    turned = "" if reading.orientation is None else f"   {_turn(reading.orientation)}"
    return f"{place} mm{turned}   {speed:.3f} m/s   buttons {reading.buttons:b}   {', '.join(_flags(reading.flags))}"


def _turn(orientation: Float) -> str:
    """How a handle is turned, as a rotation vector in degrees."""
    x, y, z, w = orientation.tolist()
    way = zip("xyz", vector_of((x, y, z, w)), strict=True)
    return "  ".join(f"{axis} {math.degrees(angle):+6.1f}" for axis, angle in way) + "°"


def _flags(flags: Flag) -> list[str]:
    return [str(flag.name).lower() for flag in Flag if flags & flag]


def _opened(text: str) -> Device:
    choice = DeviceChoice.read(text)
    return open_device(choice.name, **choice.options)
