"""Drivers against stand-ins: what a cycle costs beside its bare calls, 1 kHz over the Inverse Service, and faults.

Stand-ins are those of the tests: a stub library for each vendor's, and an Inverse Service in a process of its own.
"""

import math
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from time import perf_counter

import numpy as np
from tests.drivers.driving import fails, ready
from tests.drivers.standin import COMPILER, Fault, build, firmware, inverse_service
from websockets.sync.client import connect

from benchmarks._report import Row, command
from cotouch.drivers import _touch
from cotouch.drivers._dhd import Dhd
from cotouch.drivers._force_dimension import ForceDimension
from cotouch.drivers._hd import BUTTONS, POSITION, VELOCITY, Hd
from cotouch.drivers._inverse import Inverse3
from cotouch.drivers._inverse_session import command as order
from cotouch.drivers._touch import Touch
from cotouch.drivers._websocket import WebSocket
from cotouch.errors import DeviceError
from cotouch.haptics import Device

SECONDS = 10.0
CYCLES = 3000
FORCE = np.array([0.3, 0.2, 0.1])
ROUNDS = 3


def measure() -> list[Row]:
    """All rows."""
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        rows += haply(folder)
        if COMPILER is None:
            return rows
        built = build(folder)
        rows += force_dimension(built, folder)
        rows += touch(built, folder)
        rows += faults(built, folder)
    return rows


def haply(folder: Path) -> list[Row]:
    """Round trips of our own socket, of the package's client, and of the driver, in turns; then 1 kHz."""
    with inverse_service(_fresh(folder, "haply")) as service:
        first, later = order("049D", FORCE, first=True, full=True), order("049D", FORCE)
        ours = WebSocket(service.url, what="it", timeout=2.0)
        ours.receive(1.0)
        device = ready(Inverse3(url=service.url, events=service.events))
        with connect(service.url, compression=None) as theirs:
            theirs.recv()
            theirs.send(first.decode())
            theirs.recv()
            ours.send(first)
            ours.receive(1.0)

            def bare() -> None:
                ours.send(later)
                ours.receive(1.0)

            def package() -> None:
                theirs.send(later.decode())
                theirs.recv()

            times = _in_turns({"bare": bare, "package": package, "driver": lambda: _cycle(device)})
        ours.close()
        trips, late = _paced(device)
        device.close()
    bare_us, package_us, driver_us = (1e6 * np.median(times[name]) for name in ("bare", "package", "driver"))
    p50, p99 = (1e3 * np.quantile(trips, q) for q in (0.5, 0.99))
    return [
        Row(
            "drivers",
            "Inverse3: one cycle of the driver",
            f"{driver_us:.0f} µs",
            "",
            f"bare round trip {bare_us:.0f} µs",
        ),
        Row("drivers", "Inverse3: round trip with websockets' own client", f"{package_us:.0f} µs", "", "median"),
        Row(
            "drivers",
            f"Inverse3: 1 kHz for {SECONDS:.0f} s, round trip p50 / p99 / longest",
            f"{p50:.3f} / {p99:.3f} / {1e3 * max(trips):.2f} ms",
            "",
            f"{late} of {len(trips)} cycles began over 1 ms late",
        ),
    ]


def force_dimension(built: Path, folder: Path) -> list[Row]:
    """The driver beside the calls to the library that it makes, with their ctypes."""
    with firmware(built, _fresh(folder, "dhd")):
        device = ready(ForceDimension(library=str(built)))
        dhd = device._dhd
        assert dhd is not None

        def bare(dhd: Dhd = dhd) -> None:
            dhd.position()
            dhd.velocity()
            dhd.set_force((0.1, 0.2, 0.3))
            dhd.buttons()
            dhd.initialized()

        times = _in_turns({"bare": bare, "driver": lambda: _cycle(device)})
        device.close()
    bare_us, driver_us = (1e6 * np.median(times[name]) for name in ("bare", "driver"))
    return [Row("drivers", "Force Dimension: one cycle", f"{driver_us:.1f} µs", "", f"bare calls {bare_us:.1f} µs")]


def touch(built: Path, folder: Path) -> list[Row]:
    """The driver's part of a tick beside the bare calls in one."""
    took: dict[str, list[float]] = {"bare": [], "driver": []}
    frame = Touch._frame

    def timed(self: Touch, hd: Hd) -> None:
        began = perf_counter()
        frame(self, hd)
        took["driver"].append(perf_counter() - began)
        began = perf_counter()
        hd.begin()
        hd.vector(POSITION)
        hd.vector(VELOCITY)
        hd.transform()
        hd.integer(BUTTONS)
        hd.set_force(0.0, 0.0, 0.0)
        hd.end()
        hd.check()
        took["bare"].append(perf_counter() - began)

    with firmware(built, _fresh(folder, "hd")):
        _touch.Touch._frame = timed
        try:
            device = ready(Touch(library=str(built)))
            trips = [_once(lambda: _cycle(device)) for _ in range(CYCLES)]
            device.close()
        finally:
            _touch.Touch._frame = frame
    bare_us, driver_us = (1e6 * np.median(took[name]) for name in ("bare", "driver"))
    return [
        Row("drivers", "Touch: one tick", f"{driver_us:.1f} µs", "", f"bare calls {bare_us:.1f} µs"),
        Row(
            "drivers", "Touch: exchange, which waits for a tick", f"{1e3 * np.median(trips):.2f} ms", "", "stub: 1 kHz"
        ),
    ]


def faults(built: Path, folder: Path) -> list[Row]:
    """How long after each fault the stand-in's motors had force for the last time."""
    both = [(Fault.UNPLUGGED, 0.0), (Fault.FROZEN, 0.0), (Fault.SLOW, 0.09)]
    cases: list[tuple[str, Fault, float]] = [("Inverse3", *case) for case in both]
    cases += [
        ("Inverse3", fault, 0.0) for fault in (Fault.SILENT, Fault.SAFETY, Fault.CLOSED, Fault.MISSING, Fault.NOT_READY)
    ]
    cases += [("Force Dimension", *case) for case in (*both, (Fault.TAKEN_AWAY, 2.0), (Fault.SAFETY, 0.0))]
    cases += [("Touch", *case) for case in (*both, (Fault.SILENT, 0.0))]
    cases += [("Touch", Fault.SAFETY, float(code)) for code in (0x201, 0x202, 0x203)]
    worst: dict[str, tuple[float, str]] = {}
    for number, (name, fault, value) in enumerate(cases * ROUNDS):
        zero = _zero(name, built, _fresh(folder, f"fault{number}"), fault, value)
        worst[name] = max(worst.get(name, (-math.inf, "")), (zero, fault.name.lower().replace("_", " ")))
    counts = {name: sum(1 for case in cases if case[0] == name) for name in worst}
    return [
        Row(
            "drivers",
            f"{name}: force gone after a fault, at the motors",
            f"{1e3 * zero:.1f} ms",
            "< 100 ms",
            f"worst of {counts[name]} faults, {ROUNDS} times each: {what}",
        )
        for name, (zero, what) in worst.items()
    ]


def _zero(name: str, built: Path, folder: Path, fault: Fault, value: float) -> float:
    if name == "Inverse3":
        with inverse_service(folder) as service:
            inverse = Inverse3(url=service.url, events=service.events)
            try:
                return fails(inverse, service.board, fault, value)[1]
            finally:
                inverse.close()
    with firmware(built, folder) as mailbox:
        device = ForceDimension(library=str(built)) if name == "Force Dimension" else Touch(library=str(built))
        try:
            return fails(device, mailbox, fault, value)[1]
        finally:
            device.close()


def _paced(device: Device) -> tuple[list[float], int]:
    """Cycles at 1 kHz: how long each took, and how many began more than a period late."""
    trips: list[float] = []
    late = 0
    begun = due = time.monotonic()
    while due < begun + SECONDS:
        now = time.monotonic()
        if now < due:
            time.sleep(due - now)
        elif now > due + 1e-3:
            late += 1
            due = now
        trips.append(_once(lambda: _cycle(device)))
        due += 1e-3
    return trips, late


def _in_turns(calls: dict[str, Callable[[], object]]) -> dict[str, list[float]]:
    """Times of each, taken in turns, so that other work weighs on all alike."""
    times: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(CYCLES):
        for name, call in calls.items():
            times[name].append(_once(call))
    return times


def _cycle(device: Device) -> None:
    """One; where this machine stalled for longer than the device waits, it is opened anew, which shows in the times."""
    try:
        device.exchange(FORCE)
    except DeviceError:
        device.close()
        ready(device)


def _once(call: Callable[[], object]) -> float:
    began = perf_counter()
    call()
    return perf_counter() - began


def _fresh(folder: Path, name: str) -> Path:
    (folder / name).mkdir()
    return folder / name


if __name__ == "__main__":
    command(measure, __doc__)
