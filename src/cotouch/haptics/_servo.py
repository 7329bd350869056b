"""The servo's process: opens the device, holds it at its rate, and talks to the peer by two mailboxes.

Started as the guardian's child (`_link.py`), told what to do in the first line of its standard input. It says on
standard output, in lines of JSON, that it is ready or why not, and what went wrong; nothing is written in the loop.
"""

import contextlib
import json
import os
import select
import signal
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from math import inf
from typing import cast, final

import numpy as np

from cotouch.arrays import Float
from cotouch.device import DeviceSpec
from cotouch.errors import CotouchError
from cotouch.haptics._core import Order, ServoCore, ServoReport
from cotouch.haptics._device import Device, DeviceReading, Flag, TorqueDevice
from cotouch.haptics._mailboxes import OrderReader, ReportWriter, Watched
from cotouch.haptics._registry import open_device
from cotouch.haptics._safety import ZERO, Cause
from cotouch.haptics._settings import ServoSettings
from cotouch.pacing import Pacer, prepare_process

# A servo that stands still because of a fault still says so, this often [s].
_IDLE = 0.01
# A servo that says nothing for so long is taken for dead as far as force goes [s]: 40 ticks, and where it has to be
# ended and its device opened anew, that is still done within 100 ms. It knows it by itself a little earlier, and for a
# second switches its motors on again if the guardian has them off.
STILL = 0.04
_MARGIN, _RETURN = 0.01, 1.0


@final
class Servo:
    """One device and its loop, in any process.

    Attributes:
        core: the cycle.
        fault: what the device failed by; empty if it did not.
        ticks: cycles so far.
    """

    def __init__(
        self,
        device: Device,
        settings: ServoSettings,
        *,
        watched: Callable[[], bool],
        attended: Callable[[], bool] = lambda: True,
        unwatched: Callable[[], float] = lambda: 0.0,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Takes an open, calibrated device.

        Args:
            device: that only this loop uses from now on.
            settings: see there.
            watched: whether whoever would take the force away if this loop died is still there.
            attended: whether the peer's process is still there.
            unwatched: for how long whoever watches has not looked [s].
            clock: that of the peer's orders [s].

        Raises:
            DeviceError: the settings do not fit the device.
        """
        spec = device.spec
        period = settings.period(spec)
        self.core = ServoCore(
            spec,
            settings.safety(spec),
            settings.end_options(spec),
            turning_limits=settings.turning_safety(spec),
            period=period,
        )
        self.fault = ""
        self.ticks = 0
        self._device, self._clock = device, clock
        self._watched, self._attended, self._unwatched = watched, attended, unwatched
        self._orders = OrderReader(settings.folder)
        self._reports = ReportWriter(settings.folder)
        self._force, self._torque = np.zeros(3), np.zeros(3)
        self._exchange = device.exchange if spec.torque <= 0.0 else self._exchange_both
        self._on, self._armed, self._coupling = False, -1, 0
        self._report: ServoReport | None = None
        self._last = self._stood = -inf  # when the last cycle was, and when one was so late that others took over

    def cycle(self) -> bool:
        """One cycle; False once the force is gone for good."""
        self.ticks += 1
        core = self.core
        if not self._watched():
            core.chain.fail(Cause.PARENT)
        if not self._attended():  # rather than wait until its silence is long
            core.chain.fail(Cause.PEER)
        try:
            order = self._orders.read()
            if order is not None:
                core.receive(order)
                if core.coupling > self._coupling:  # what acts is of the one before
                    self._coupling = core.coupling
                    self._force[:] = self._torque[:] = 0.0
            if core.chain.broken:
                return self._end()
            now = self._clock()
            if now - self._last > STILL - _MARGIN:
                self._stood = now
            self._last = now
            self._enable(core.order, now)
            reading = self._exchange(self._force)
        except Exception as error:  # noqa: BLE001  # whatever a driver raises, the motors go off
            self.fault = _sentence(error)
            core.chain.fail(Cause.FAULT)
            return self._end()
        report = self._report = core.cycle(reading, self._clock(), self._unwatched())
        if core.chain.broken:
            return self._end()
        self._force[:], self._torque[:] = report.force, report.torque
        self._reports.write(report, self._clock())
        return True

    def say(self) -> None:
        """Says again how things stand; for a loop that has ended."""
        self.ticks += 1
        report = self._report or _nothing(self._clock())
        causes = self.core.chain.broken or report.causes
        report = report._replace(tick=self.ticks, force=ZERO, torque=ZERO, wanted=ZERO, causes=causes)
        self._reports.write(report, self._clock())

    def stop(self) -> None:
        """Takes the force away at once, and says so."""
        self._device.stop()
        self._force[:] = self._torque[:] = 0.0
        if not self.core.chain.broken:
            self.core.chain.fail(Cause.STOPPED)
        self.say()

    def close(self) -> None:
        """Stops the device, lets go of it, and removes the mailbox."""
        self._device.stop()
        self._device.close()
        self._orders.close()
        self._reports.close()

    def _enable(self, order: Order, now: float) -> None:
        """Switches the motors as the peer wants it; again where somebody re-arms, as the device may have let go.

        Also again where this loop stood still for so long that the guardian has switched them off.
        """
        off = self._report is not None and bool(self._report.causes & Cause.DEVICE)
        if order.enable and (not self._on or order.rearm > self._armed or (off and now - self._stood < _RETURN)):
            self._device.enable_force(True)
            self._on, self._armed = True, order.rearm
        elif self._on and not order.enable:
            self._device.enable_force(False)
            self._on = False

    def _end(self) -> bool:
        self.stop()
        return False

    def _exchange_both(self, force: Float) -> DeviceReading:
        return cast("TorqueDevice", self._device).exchange(force, self._torque)


def _sentence(error: Exception) -> str:
    if isinstance(error, CotouchError):
        return str(error)
    return f"its driver failed with {type(error).__name__}: {str(error).partition(chr(10))[0]}"


def _nothing(now: float) -> ServoReport:
    from cotouch.coupling import EnergyMessage

    return ServoReport(now, 0, ZERO, ZERO, ZERO, ZERO, EnergyMessage(), 0.0, 0.0, Cause.OFF, 0, Flag(0))


def warm(spec: DeviceSpec, settings: ServoSettings) -> None:
    """Takes some cycles that nobody feels, so that everything is compiled and loaded before the first real one.

    Args:
        spec: limits of the device.
        settings: of the servo.
    """
    core = ServoCore(spec, settings.safety(spec), settings.end_options(spec), period=settings.period(spec))
    for tick in range(20):
        now = 1e-3 * tick
        core.receive(Order(time=now, place=(1e-4, 0.0, 0.0), enable=True))
        place = np.array([1e-5 * tick, 0.0, 0.0])
        reading = DeviceReading(
            time=now, position=place, velocity=np.zeros(3), force=np.zeros(3), flags=Flag.FORCE_ON | Flag.CALIBRATED
        )
        core.cycle(reading, now)


def main() -> int:
    """Runs in a process of its own; 0 if it was asked to end."""
    parent = int(sys.argv[1])  # which may be gone by now
    settings = ServoSettings.read(sys.stdin.readline())
    asked: list[int] = []
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda number, _: asked.append(number))
    above = _hung_up(sys.stdin.fileno())  # told a little earlier than the parent's death
    watched = lambda: os.getppid() == parent and not above()  # noqa: E731
    try:
        device = open_device(settings.device.name, **settings.device.options)
    except Exception as error:  # noqa: BLE001  # drivers of others may raise anything
        return _said(error=_sentence(error))
    servo: Servo | None = None
    below = _hung_up(sys.stdout.fileno())
    guard = Watched(settings.folder, time.monotonic)
    try:
        device.calibrate(allow_motion=False)
        servo = Servo(device, settings, watched=watched, attended=lambda: not below(), unwatched=guard.silence)
        warm(device.spec, settings)
        with prepare_process(real_time=settings.real_time) as state:
            if _said(ready=True, spec=asdict(device.spec), process=asdict(state), pid=os.getpid()) != 0:
                return 0  # nobody waits for it any more
            _loop(servo, settings.period(device.spec), asked, watched)
    except Exception as error:  # noqa: BLE001  # as above
        return _said(error=_sentence(error))
    finally:
        device.stop()
        if servo is None:
            device.close()
        else:
            servo.close()
        guard.close()
    return 0


def _loop(servo: Servo, period: float, asked: list[int], watched: Callable[[], bool]) -> None:
    pacer = Pacer(period)
    while not asked and servo.cycle():
        pacer.wait()
    servo.stop()  # before anything else takes time
    pace = pacer.statistics()
    if asked:
        _said(ended=True, ticks=servo.ticks, pace=asdict(pace))
        return
    _said(fault=servo.fault or "", causes=int(servo.core.chain.broken), pace=asdict(pace))
    while not asked and watched():  # so that the peer reads why, and not only silence
        servo.say()
        time.sleep(_IDLE)


def _hung_up(pipe: int) -> Callable[[], bool]:
    """Whether nobody holds the other end of a pipe any more: the system closes it for whoever dies, at once.

    Args:
        pipe: its descriptor: standard input comes from the guardian, standard output goes to the peer.
    """
    if not hasattr(select, "poll"):
        return lambda: False
    poll = select.poll()
    poll.register(pipe, 0)  # errors and hang-ups are told in any case
    return lambda: bool(poll.poll(0))


def _said(**values: object) -> int:
    """Tells the peer; 1 if nobody is there to hear it, else 2 for an error and 0 for anything else."""
    try:
        sys.stdout.write(json.dumps(values) + "\n")
        sys.stdout.flush()
    except (OSError, ValueError):
        with contextlib.suppress(OSError, ValueError):  # or Python would complain of the rest when it ends
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    return 2 if "error" in values else 0
