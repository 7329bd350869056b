"""What every device must do, whoever made it: the checks behind `cotouch devices check` and the tests of all drivers.

A device is checked with forces that no hand notices, most of the time with its motors off.
"""

import itertools
import math
import threading
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import cast, final

import numpy as np

from cotouch.errors import DeviceError
from cotouch.haptics._device import Device, DeviceReading, Flag, TorqueDevice, lacks
from cotouch.haptics._turning import ARM

# Longest that an exchange may take, by the interface [s]; a loaded machine gets as much again.
LIMIT = 0.02
# Force of the check while motors are on: less than the friction of any device with motors [N].
_GENTLE = 0.05
# Fastest that a device may say it moves while nobody does anything violent with it [m/s].
_FASTEST = 20.0
_ZERO = np.zeros(3)
# And torque: what that is at the end of a grip.
_LIGHT = ARM * _GENTLE


@final
@dataclass(frozen=True)
class CheckResult:
    """The result of one check.

    Attributes:
        check: what was looked at.
        passed: whether it is as it must be.
        detail: what was seen.
    """

    check: str
    passed: bool
    detail: str


def conform(
    make: Callable[[], Device],
    *,
    cycles: int = 50,
    allow_motion: bool = False,
    force: bool = True,
    clock: Callable[[], float] = time.monotonic,
    sleep: Callable[[float], None] = time.sleep,
) -> list[CheckResult]:
    """Checks a device; it is closed afterwards.

    Args:
        make: gives the device, not open.
        cycles: exchanges in each state, >= 10.
        allow_motion: whether it may move by itself to calibrate.
        force: whether its motors may be switched on, for a force of 0.05 N.
        clock: monotonic time, that of the device's readings [s].
        sleep: waits so long [s].

    Returns:
        What was found, in order; what came after an error is missing.
    """
    device = make()
    missing = lacks(device)
    if missing:
        return [CheckResult("it has every member", False, f"{', '.join(missing)} missing")]
    found: list[CheckResult] = []

    def note(check: str, passed: bool, detail: str) -> None:
        found.append(CheckResult(check, bool(passed), detail))

    note("stop and close before open", _silent(device.stop) and _silent(device.close), "they must not raise")
    note("exchange before open is refused", _refuses(lambda: device.exchange(_ZERO)), "a DeviceError of one sentence")
    try:
        device = make()
        device.open()
        _limits(device, note)
        before = _cycles(device, cycles, _ZERO + _GENTLE, clock, sleep)
        _readings(before, note, "before calibration", clock, torque=device.spec.torque > 0.0)
        note("no force before it is enabled", _off(before), "force 0 or not reported, and not FORCE_ON")
        device.calibrate(allow_motion=allow_motion)
        after = _cycles(device, cycles, _ZERO + _GENTLE, clock, sleep)
        note("calibrated", all(r.flags & Flag.CALIBRATED for r, _ in after), "CALIBRATED in every cycle")
        note("no force after calibration alone", _off(after), "force 0 or not reported, and not FORCE_ON")
        if force and device.spec.actuated:
            _with_force(device, cycles, clock, sleep, note)
        closes = [_silent(device.close) for _ in range(2)]
        note("close again", all(closes), "it must not raise")
        note("stop after close", _silent(device.stop), "it must not raise")
        note("exchange after close is refused", _refuses(lambda: device.exchange(_ZERO)), "a DeviceError")
    except DeviceError as error:
        note("it works", False, str(error))
    except Exception as error:  # noqa: BLE001 - what somebody wrote may be wrong in any way
        place = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{Path(place.filename).name}, line {place.lineno}"
        note("it works", False, f"{type(error).__name__}: {' '.join(str(error).split())} ({where})")
    finally:
        if not (_silent(device.stop) and _silent(device.close)):
            note("stop and close at the end", False, "they must not raise")
    return found


Note = Callable[[str, bool, str], None]
Cycles = list[tuple[DeviceReading, float]]


def _with_force(
    device: Device, cycles: int, clock: Callable[[], float], sleep: Callable[[float], None], note: Note
) -> None:
    device.enable_force()
    on = _cycles(device, cycles, _ZERO, clock, sleep)
    note("force is on once enabled", all(r.flags & Flag.FORCE_ON for r, _ in on), "FORCE_ON in every cycle")
    gentle = _cycles(device, cycles, np.array([0.0, 0.0, _GENTLE]), clock, sleep)
    _readings(gentle, note, "with force", clock, torque=device.spec.torque > 0.0)
    sizes = [float(np.linalg.norm(r.force)) for r, _ in gentle if np.isfinite(r.force).all()]
    note("no more force than commanded", all(s <= 1.01 * _GENTLE for s in sizes), f"{max(sizes, default=0.0):.3g} N")
    twists = [
        float(np.linalg.norm(r.torque)) for r, _ in gentle if r.torque is not None and np.isfinite(r.torque).all()
    ]
    most = _LIGHT if device.spec.torque > 0.0 else 0.0
    note("no more torque than commanded", all(t <= 1.01 * most for t in twists), f"{max(twists, default=0.0):.3g} Nm")
    raised: list[BaseException] = []

    def stop() -> None:
        try:
            device.stop()
        except BaseException as error:  # noqa: BLE001  # that it raises anything is what is looked for
            raised.append(error)

    stops = [threading.Thread(target=stop) for _ in range(3)]
    for thread in stops:
        thread.start()
    for thread in stops:
        thread.join()
    note("stop from other threads, repeatedly", not raised, "it must not raise")
    stopped = _cycles(device, cycles, _ZERO + _GENTLE, clock, sleep)
    note("no force after stop", _off(stopped), "force 0 or not reported, and not FORCE_ON")
    device.enable_force()
    again = _cycles(device, 10, _ZERO, clock, sleep)
    note("force is on after it is enabled again", all(r.flags & Flag.FORCE_ON for r, _ in again), "FORCE_ON")
    device.enable_force(False)
    note("no force after it is disabled", _off(_cycles(device, 10, _ZERO + _GENTLE, clock, sleep)), "as after stop")


def _limits(device: Device, note: Note) -> None:
    spec = device.spec
    numbers = (spec.force, spec.continuous_force, spec.workspace, spec.stiffness, spec.damping, spec.rate)
    good = all(math.isfinite(value) and value >= 0.0 for value in numbers) and spec.rate > 0.0 and spec.workspace > 0.0
    note("limits are numbers", good, f"force {spec.force:g} N, workspace {spec.workspace:g} m, rate {spec.rate:g} Hz")
    note("continuous force within the largest", spec.continuous_force <= spec.force, f"{spec.continuous_force:g} N")
    few = 0 <= spec.actuated <= spec.degrees_of_freedom
    note("no more motors than axes", few, f"{spec.actuated} of {spec.degrees_of_freedom}")
    if spec.torque:
        of_turning = (spec.torque, spec.continuous_torque, spec.turning_stiffness, spec.turning_damping)
        good = all(math.isfinite(value) and value > 0.0 for value in of_turning) and spec.turning_resolution >= 0.0
        note("limits of torque are numbers", good, f"torque {spec.torque:g} Nm, {spec.turning_stiffness:g} Nm/rad")
        note("continuous torque within the largest", spec.continuous_torque <= spec.torque, f"{spec.torque:g} Nm")


def _cycles(
    device: Device, count: int, force: np.ndarray, clock: Callable[[], float], sleep: Callable[[float], None]
) -> Cycles:
    period = 1.0 / min(device.spec.rate, 1000.0)
    seen: Cycles = []
    # Wherever there is force, a device that renders torques gets some as well.
    torque = _LIGHT * (force != 0.0).any() * np.array([0.6, 0.0, 0.8])
    for _ in range(count):
        begun = clock()
        if device.spec.torque > 0.0:
            reading = cast("TorqueDevice", device).exchange(force.copy(), torque.copy())
        else:
            reading = device.exchange(force.copy())
        took = clock() - begun
        seen.append((reading, took))
        if took < period:
            sleep(period - took)
    return seen


def _readings(cycles: Cycles, note: Note, when: str, clock: Callable[[], float], *, torque: bool) -> None:
    readings = [reading for reading, _ in cycles]
    shapes = all(r.position.shape == r.velocity.shape == r.force.shape == (3,) for r in readings)
    note(f"three numbers each, {when}", shapes, "position, velocity, force")
    finite = all(np.isfinite(r.position).all() and np.isfinite(r.velocity).all() for r in readings)
    note(f"finite, {when}", finite, "position and velocity")
    times = [r.time for r in readings]
    rising = all(later >= earlier for earlier, later in itertools.pairwise(times))
    fresh = all(
        later > earlier or readings[n + 1].flags & Flag.STALE
        for n, (earlier, later) in enumerate(itertools.pairwise(times))
    )
    note(f"time rises, {when}", rising and fresh, "and repeated readings are marked STALE")
    note(f"time is the clock's, {when}", abs(clock() - times[-1]) < 1.0, "monotonic, like ours")
    slow = sorted(took for _, took in cycles)[int(0.9 * (len(cycles) - 1))]
    note(f"in time, {when}", slow <= 2.0 * LIMIT, f"9 of 10 exchanges within {1e3 * slow:.2g} ms")
    fast = max(float(np.linalg.norm(r.velocity)) for r in readings) if finite else math.inf
    note(f"velocity is m/s, {when}", fast < _FASTEST, f"at most {fast:.3g} m/s")
    far = max(float(np.linalg.norm(r.position)) for r in readings) if finite else math.inf
    note(f"position is m from the centre of the workspace, {when}", far < 1.0, f"at most {far:.3g} m")
    handles = [r.orientation for r in readings if r.orientation is not None]
    units = all(h.shape == (4,) and abs(float(np.linalg.norm(h)) - 1.0) < 1e-3 for h in handles)
    note(f"orientation is a unit quaternion, {when}", units, "or None")
    if torque:
        note(f"it has an orientation, {when}", len(handles) == len(readings), "in every reading, as it renders torques")


def _off(cycles: Cycles) -> bool:
    return all(
        not reading.flags & Flag.FORCE_ON
        and (bool(np.isnan(reading.force).all()) or not reading.force.any())
        and (reading.torque is None or bool(np.isnan(reading.torque).all()) or not reading.torque.any())
        for reading, _ in cycles
    )


def _silent(call: Callable[[], None]) -> bool:
    try:
        call()
    except Exception:  # noqa: BLE001  # that it raises anything is what is looked for
        return False
    return True


def _refuses(call: Callable[[], object]) -> bool:
    try:
        call()
    except DeviceError as error:
        return 0 < len(str(error)) < 400 and "\n" not in str(error)
    except Exception:  # noqa: BLE001  # any other is none that a user could read
        return False
    return False
