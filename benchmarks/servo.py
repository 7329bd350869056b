"""What a servo costs, how it keeps its deadlines, how soon force is gone whoever dies, and whether it grows.

    python -m benchmarks.servo --write                # 3 to 4 minutes, with the rows of the drivers
    python -m benchmarks.servo --growth 600 --write   # ten minutes of two servos, for their memory, and nothing else

`loaded`: one busy process for every core besides. Devices are simulated ones, the stand-ins of the tests, and a process
that holds its last force for ever. The growth needs no quiet machine, all the rest does.
"""

import argparse
import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Generator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import psutil
from tests.drivers.standin import inverse_service
from tests.haptics import plant as plants
from tests.haptics.test_processes import PEER, Held

from benchmarks import drivers
from benchmarks._report import Row, add_write, finish
from cotouch.device import PRESETS
from cotouch.haptics import (
    DeviceChoice,
    DeviceReading,
    Order,
    ProxyEnd,
    SafetyLimits,
    Servo,
    ServoCore,
    ServoLink,
    ServoSettings,
    open_device,
)
from cotouch.haptics._mailboxes import OrderWriter
from cotouch.pacing import prepare_process

ROOT = str(Path(__file__).parent.parent)
SECONDS, TIMES, CYCLES = 10.0, 3, 5000
# What a servo and its guardian grow by in their first minute is what they need [s]; then they are looked at so often.
_SETTLE, _EVERY = 60.0, 10.0
# A busy machine may end a device before its time; then another is taken.
_ATTEMPTS = 5
_GROWTH = "servo memory"


def load() -> str:
    """Of the machine."""
    return f"load of the machine {os.getloadavg()[0]:.1f}"


def cost(cycles: int = CYCLES) -> list[Row]:
    """A cycle of the core, of the loop with its mailboxes, and of the bare device; no pacing."""
    device = open_device("simulated", variant="cartesian")
    device.calibrate(allow_motion=False)
    device.enable_force()
    bare = [_timed(lambda: device.exchange(np.zeros(3))) for _ in range(cycles)]
    reading = device.exchange(np.zeros(3))
    spec = PRESETS["phantom"]
    with tempfile.TemporaryDirectory() as folder:
        settings = ServoSettings(device=DeviceChoice("simulated"), folder=Path(folder))
        core = ServoCore(spec, SafetyLimits.of(spec), settings.end_options(spec))
        alone: list[float] = []
        for k in range(cycles):
            now = 1e-3 * k
            core.receive(Order(time=now, place=(0.0, 0.0, 0.01), enable=True))
            commanded = _at(reading, now)
            alone.append(_timed(lambda commanded=commanded, now=now: core.cycle(commanded, now)))
        servo = Servo(device, settings, watched=lambda: True)
        orders = OrderWriter(Path(folder))
        whole: list[float] = []
        for _ in range(cycles):
            orders.write(Order(time=time.monotonic(), place=(0.0, 0.0, 0.01), enable=True))
            whole.append(_timed(servo.cycle))
        servo.close()
        orders.close()
    return [
        Row("servo", f"one cycle: {what}, p50 / p99 / p99.9", _quantiles(values), goal, note)
        for what, values, goal, note in (
            ("command read, device, coupling, chain, report", whole, "", "simulated device; of 1000 µs"),
            ("— coupling, wall, safety chain, observer", alone, "", ""),
            ("— bare exchange with the simulated device", bare, "", ""),
        )
    ]


def _timed(call: Callable[[], object]) -> float:
    begun = time.perf_counter()
    call()
    return time.perf_counter() - begun


def _at(reading: DeviceReading, now: float) -> DeviceReading:
    return DeviceReading(
        time=now, position=reading.position, velocity=reading.velocity, force=reading.force, flags=reading.flags
    )


def _quantiles(values: list[float]) -> str:
    return " / ".join(f"{1e6 * value:.0f}" for value in np.quantile(values, [0.5, 0.99, 0.999])) + " µs"


class _Pulled:
    """A link whose proxy stays where it is."""

    def __init__(self, choice: DeviceChoice) -> None:
        self.link = ServoLink(choice)
        self._end, self._first = ProxyEnd(self.link.options), None

    def service(self) -> None:
        """A step of the peer."""
        report = self.link.read()
        if report is not None:
            self._first = report.place if self._first is None else self._first
            self._end.pull(self._first, report.place, report.rate, report.message, 0.002)
            self.link.order(self._first, self._end.tank.message)
        for text in self.link.warning_log():
            print(text, file=sys.stderr)


def _held(links: list[_Pulled], seconds: float) -> None:
    finish = time.monotonic() + seconds
    while time.monotonic() < finish:
        for one in links:
            one.service()
        time.sleep(0.002)


@contextmanager
def _busy(count: int) -> Generator[None]:
    running = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for process in running:
            process.kill()
            process.wait()


def pace(seconds: float) -> list[Row]:
    """How late cycles at 1 kHz begin, in processes of their own."""
    rows: list[Row] = []
    for name, busy in (("idle", 0), ("loaded", os.cpu_count() or 1)):
        before = load()
        with _busy(busy):
            held = _Pulled(DeviceChoice("simulated"))
            _held([held], seconds)
            held.link.close()
        found, priority = held.link.statistics, held.link.process["real_time"]
        late = " / ".join(f"{1e6 * found[key]:.1f}" for key in ("late_p50", "late_p99", "late_p999"))
        missed = found["missed"] / (found["steps"] + found["missed"])
        how = f"SCHED_FIFO {priority}" if priority else "no real-time priority"
        rows.append(
            Row(
                "servo",
                f"deadlines at 1 kHz, {name}: late by p50 / p99 / p99.9",
                f"{late} µs",
                "",
                f"{100 * missed:.2g} % of cycles left out; longest step {1e3 * found['period_max']:.2g} ms; "
                f"{how}; {before}",
            )
        )
    return rows


_DEATHS = {
    "peer killed": ("peer", signal.SIGKILL),
    "peer stopped": ("peer", signal.SIGSTOP),
    "servo killed": ("servo", signal.SIGKILL),
    "servo stopped": ("servo", signal.SIGSTOP),
    "servo killed, device not reachable from outside": ("servo alone", signal.SIGKILL),
    "servo stopped, device not reachable from outside": ("servo alone", signal.SIGSTOP),
    "guardian killed": ("guardian", signal.SIGKILL),
    "guardian stopped": ("guardian", signal.SIGSTOP),
    "peer and servo killed": ("peer servo", signal.SIGKILL),
    "peer and servo stopped": ("peer servo", signal.SIGSTOP),
}


def deaths(times: int) -> list[Row]:
    """From the signal to no force on a device that holds its last force for ever."""
    os.environ["PYTHONPATH"] = ROOT
    rows: list[Row] = []
    before = load()
    for what, (whom, number) in _DEATHS.items():
        found = [_death(whom, number) for _ in range(times)]
        each = ", ".join(f"{1e3 * value:.0f}" for value in found)
        rows.append(
            Row("servo", f"force gone, {what}", f"{1e3 * max(found):.0f} ms", "< 100 ms", f"{each} ms; {before}")
        )
    return rows


def _death(whom: str, number: int) -> float:
    """Once; begun again where a busy machine ended the device beforehand [s]."""
    for _ in range(_ATTEMPTS):
        with tempfile.TemporaryDirectory() as folder:
            plant = plants.Plant(Path(folder))
            try:
                with _around(plant, whom) as pids:
                    if not _comes(lambda plant=plant: plant.force > 0.0):
                        continue
                    _rest(0.5)
                    if plant.force == 0.0:
                        continue
                    began = time.monotonic()
                    for pid in pids:
                        os.kill(pid, number)
                    assert _comes(lambda plant=plant, began=began: plant.gone_after(began) < np.inf), whom
                    return plant.gone_after(began)
            finally:
                plant.close()
    raise AssertionError(f"no force that stays, to take it from: {whom}")


_tending: list[Held] = []


@contextmanager
def _around(plant: plants.Plant, whom: str) -> Generator[list[int]]:
    """The processes around a device; those that are meant."""
    if "peer" not in whom:
        held = Held(plant, "PLANT_ALONE" if "alone" in whom else "PLANT")
        _tending.append(held)
        try:
            yield [held.link.guardian if whom == "guardian" else held.link.servo]
        finally:
            _tending.remove(held)
            os.kill(held.link.guardian, signal.SIGCONT) if psutil.pid_exists(held.link.guardian) else None
            held.link.close()
        return
    command = [sys.executable, "-c", PEER, ROOT, str(plant.folder)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as peer:
        try:
            assert peer.stdout is not None
            servo, _ = map(int, peer.stdout.readline().split())
            yield [peer.pid, servo] if "servo" in whom else [peer.pid]
        finally:
            peer.kill()


def _comes(done: Callable[[], bool], seconds: float = 20.0) -> bool:
    """Whether it does in time; meanwhile this process is the peer of whatever it is the peer of."""
    end = time.monotonic() + seconds
    while not done():
        if time.monotonic() > end:
            return False
        _service()
        time.sleep(0.002)
    return True


def _rest(seconds: float) -> None:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        _service()
        time.sleep(0.002)


def _service() -> None:
    for held in _tending:
        tended = iter((False, True))
        held.until(lambda tended=tended: next(tended), "a step")


def growth(seconds: float) -> list[Row]:
    """Memory that servos and guardians share with nobody, after they settled; simulated device and Haply's."""
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        service = stack.enter_context(inverse_service(Path(folder), "--long"))
        with contextlib.suppress(OSError, AttributeError):  # or a busy machine ends the device in these ten minutes
            os.sched_setscheduler(service.process.pid, os.SCHED_FIFO, os.sched_param(15))
        stack.enter_context(prepare_process())
        choices = {
            "simulated device": DeviceChoice("simulated"),
            "Inverse3": DeviceChoice("haply", {"url": service.url, "events": service.events}),
        }
        links = {name: _Pulled(choice) for name, choice in choices.items()}
        for one in links.values():
            stack.callback(one.link.close)
        _held(list(links.values()), min(_SETTLE, 0.1 * seconds))
        seen: dict[tuple[str, str], list[float]] = {}
        begun, times = time.monotonic(), list[float]()
        while time.monotonic() < begun + seconds:
            times.append(time.monotonic() - begun)
            for name, one in links.items():
                for part in ("servo", "guardian"):
                    used = psutil.Process(getattr(one.link, part)).memory_full_info().uss
                    seen.setdefault((name, part), []).append(used / 1024)
            _held(list(links.values()), _EVERY)
        for name, one in links.items():
            report: Any = one.link.report
            for part in ("servo", "guardian"):
                kept = np.array(seen[name, part])
                half = kept.size // 2
                slope = np.polyfit(times[half:], kept[half:], 1)[0] if kept.size - half > 1 else 0.0
                rows.append(
                    Row(
                        _GROWTH,
                        f"{part}, {name}: private memory after {seconds:.0f} s more",
                        f"{kept[-1] - kept[0]:+.0f} KiB",
                        "0",
                        f"of {kept[0]:,.0f}; slope of the second half {60 * slope:+.2f} KiB/min; "
                        f"{report.tick:,} cycles; looked at {kept.size} times",
                    )
                )
    return rows


def measure(seconds: float = SECONDS, times: int = TIMES) -> list[Row]:
    """All rows but those of growth."""
    return [*cost(), *pace(seconds), *deaths(times), *drivers.measure()]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=SECONDS, help="of each row of the pace [s]")
    parser.add_argument("--times", type=int, default=TIMES, help="each program is killed so often")
    parser.add_argument("--growth", type=float, help="only the memory, for so long [s]")
    add_write(parser)
    asked = parser.parse_args()
    rows = measure(asked.seconds, asked.times) if asked.growth is None else growth(asked.growth)
    finish(rows, write=asked.write)


if __name__ == "__main__":
    main()
