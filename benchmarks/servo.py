"""What the servo costs, how it keeps its deadlines, how soon force is gone, and whether it grows.

    python -m benchmarks.servo                   # a minute or two
    python -m benchmarks.servo --growth 600      # and ten minutes of one servo, for its memory

Prints a table for RESULTS.md. `loaded`: one busy process for every core besides.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import psutil

from cotouch.device import PRESETS
from cotouch.haptics import (
    DeviceChoice,
    Order,
    ProxyEnd,
    SafetyLimits,
    Servo,
    ServoCore,
    ServoLink,
    ServoSettings,
    open_device,
)
from cotouch.haptics._boards import OrderWriter

ROOT = str(Path(__file__).parent.parent)


def quantiles(values: list[float]) -> str:
    low, high = np.quantile(values, [0.5, 0.99])
    return f"{1e6 * low:.0f} | {1e6 * high:.0f}"


def cost(cycles: int = 5000) -> None:
    """A cycle of the core, of the loop with its boards, and of the bare device; no pacing [µs]."""
    device = open_device("simulated", variant="cartesian")
    device.calibrate(allow_motion=False)
    device.enable_force()
    bare: list[float] = []
    for _ in range(cycles):
        begun = time.perf_counter()
        reading = device.exchange(np.zeros(3))
        bare.append(time.perf_counter() - begun)
    spec = PRESETS["phantom"]
    settings = ServoSettings(device=DeviceChoice("simulated"), folder=Path())
    core = ServoCore(spec, SafetyLimits.of(spec), settings.end_options(spec))
    alone: list[float] = []
    for k in range(cycles):
        now = 1e-3 * k
        core.hear(Order(time=now, place=(0.0, 0.0, 0.01), enable=True))
        fields = (reading.position, reading.velocity, reading.force, reading.buttons, reading.flags)
        told = type(reading)(
            time=now, position=fields[0], velocity=fields[1], force=fields[2], buttons=fields[3], flags=fields[4]
        )
        begun = time.perf_counter()
        core.cycle(told, now)
        alone.append(time.perf_counter() - begun)
    with tempfile.TemporaryDirectory() as folder:
        servo = Servo(
            device, ServoSettings(device=DeviceChoice("simulated"), folder=Path(folder)), watched=lambda: True
        )
        orders = OrderWriter(Path(folder))
        whole: list[float] = []
        for _ in range(cycles):
            orders.write(Order(time=time.monotonic(), place=(0.0, 0.0, 0.01), enable=True))
            begun = time.perf_counter()
            servo.cycle()
            whole.append(time.perf_counter() - begun)
        servo.close()
        orders.close()
    print("| cycle [µs] | p50 | p99 |\n|---|---|---|")
    print(f"| bare exchange with the simulated device | {quantiles(bare)} |")
    print(f"| coupling, wall, chain, observer | {quantiles(alone)} |")
    print(f"| whole cycle: order read, exchange, core, report published | {quantiles(whole)} |")


def held(choice: DeviceChoice, seconds: float) -> ServoLink:
    link = ServoLink(choice)
    end, first = ProxyEnd(link.options), None
    finish = time.monotonic() + seconds
    while time.monotonic() < finish:
        report = link.read()
        if report is not None:
            first = report.place if first is None else first
            end.pull(first, report.place, report.rate, report.word, 0.002)
            link.order(first, end.purse.word)
        link.notices()
        time.sleep(0.002)
    return link


def pace(seconds: float) -> None:
    print("| deadlines at 1 kHz | late p50 / p99 / p99.9 [µs] | left out | longest step [ms] |\n|---|---|---|---|")
    for name in ("idle", "loaded"):
        busy = [
            subprocess.Popen([sys.executable, "-c", "while True: pass"])
            for _ in range((os.cpu_count() or 1) if name == "loaded" else 0)
        ]
        try:
            link = held(DeviceChoice("simulated"), seconds)
            link.close()
        finally:
            for process in busy:
                process.kill()
                process.wait()
        s, priority = link.statistics, link.process["real_time"]
        late = " / ".join(f"{1e6 * s[key]:.1f}" for key in ("late_p50", "late_p99", "late_p999"))
        how = f"{name}, SCHED_FIFO {priority}" if priority else name
        share = s["missed"] / (s["steps"] + s["missed"])
        print(f"| {how} | {late} | {100 * share:.2g} % | {1e3 * s['T_max']:.2g} |")


def deaths(times: int) -> None:
    """From the kill to no force on a device that holds its last force for ever [ms]."""
    sys.path.insert(0, ROOT)
    os.environ["PYTHONPATH"] = ROOT
    from tests.haptics.plant import Plant
    from tests.haptics.test_processes import PEER, Held

    print("| killed with -9 | force gone after [ms], each time |\n|---|---|")
    for what in ("servo", "servo, no way from outside", "servo stopped", "guardian", "peer"):
        found: list[float] = []
        for _ in range(times):
            with tempfile.TemporaryDirectory() as folder:
                plant = Plant(Path(folder))
                try:
                    found.append(1e3 * _death(what, plant, Held, PEER))
                finally:
                    plant.close()
        print(f"| {what} | {', '.join(f'{value:.0f}' for value in found)} |")


def _death(what, plant, Held, PEER) -> float:
    if what == "peer":
        command = [sys.executable, "-c", PEER, ROOT, str(plant.folder)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as peer:
            assert peer.stdout is not None
            peer.stdout.readline()
            _until(lambda: plant.force > 0.0)
            time.sleep(1.0)
            at = time.monotonic()
            peer.kill()
        _until(lambda: plant.force == 0.0)
        return plant.changes()[-1][0] - at
    made = Held(plant, "PLANT_ALONE" if "outside" in what else "PLANT")
    try:
        made.until(lambda: plant.force > 0.0, "force")
        begun = time.monotonic()
        made.until(lambda: time.monotonic() - begun > 1.0 and plant.force > 0.0, "force that stays")
        at = time.monotonic()
        pid = made.link.guardian if what == "guardian" else made.link.servo
        os.kill(pid, signal.SIGSTOP if "stopped" in what else signal.SIGKILL)
        made.until(lambda: plant.changes()[-1][1] == 0.0, "no force")
        return next(time for time, force in plant.changes() if time > at and force == 0.0) - at
    finally:
        made.link.close()


def _until(done) -> None:
    end = time.monotonic() + 120.0
    while not done():
        assert time.monotonic() < end
        time.sleep(0.001)


def growth(seconds: float) -> None:
    link = held(DeviceChoice("simulated"), 10.0)
    servo = psutil.Process(link.servo)
    before = servo.memory_info().rss
    end, first = ProxyEnd(link.options), None
    finish = time.monotonic() + seconds
    while time.monotonic() < finish:
        report = link.read()
        if report is not None:
            first = report.place if first is None else first
            end.pull(first, report.place, report.rate, report.word, 0.002)
            link.order(first, end.purse.word)
        time.sleep(0.002)
    after = servo.memory_info().rss
    link.close()
    print(f"| resident memory of the servo after {seconds:.0f} s more | {(after - before) / 1024:+.0f} KiB |")


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=10.0, help="of each row of the pace [s]")
    options.add_argument("--times", type=int, default=3, help="each program is killed so often")
    options.add_argument("--growth", type=float, default=0.0, help="so long for the memory [s]")
    asked = options.parse_args()
    cost()
    print()
    pace(asked.seconds)
    print()
    deaths(asked.times)
    if asked.growth:
        print("\n| memory | |\n|---|---|")
        growth(asked.growth)


if __name__ == "__main__":
    main()
