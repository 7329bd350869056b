"""The peer's way to a device: starts the processes around it, reads what the servo says, tells it of the proxy."""

import json
import os
import select
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, TypedDict, cast, final

from cotouch.coupling import EnergyMessage
from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.files import table_of
from cotouch.haptics._core import Order, ServoReport, silent_for
from cotouch.haptics._coupling import CouplingChoice, coupling_of
from cotouch.haptics._ends import EndOptions
from cotouch.haptics._mailboxes import OrderWriter, ReportReader
from cotouch.haptics._quaternions import Quaternion
from cotouch.haptics._registry import DeviceChoice, driver
from cotouch.haptics._safety import NO_CAUSE, Cause, Vector
from cotouch.haptics._settings import ServoSettings
from cotouch.haptics._warning_log import WarningLog, priority_refused
from cotouch.processes import ONE_THREAD, MemoryFolder

# The servo is started before the guardian loads what it needs itself, so that both load at the same time.
GUARDIAN = """
import os, subprocess, sys
line = sys.stdin.readline()
program = "from cotouch.haptics._servo import main; raise SystemExit(main())"
servo = subprocess.Popen(
    [sys.executable, "-c", program, str(os.getpid())],
    stdin=subprocess.PIPE, text=True,
)
servo.stdin.write(line)
servo.stdin.flush()
from cotouch.haptics._guardian import main
raise SystemExit(main(line, servo))
"""
# Opening and calibrating a device takes seconds; compiling a simulated one for the first time, minutes [s].
_PATIENCE = 300.0
# A servo that says nothing for so long is gone [s].
_GONE = 0.1
_SILENT = EnergyMessage()


class _Ready(TypedDict):
    """What the servo says once it holds the device: its limits, what it obtained from the system, its process id."""

    spec: dict[str, Any]
    process: dict[str, object]
    pid: int


@final
class ServoLink:
    """A device in processes of its own, as its peer sees it.

    Attributes:
        spec: limits of the opened device.
        said: of the coupling, by whoever chose the device.
        options: of the coupling.
        turning: of the coupling of turning, as for places at the arm; None: there is none.
        report: the newest of the servo; None before the first.
        process: what the servo obtained from the system, by name; and the guardian, under `guardian`.
        servo: its process id.
        guardian: that of its parent.
    """

    def __init__(
        self,
        choice: DeviceChoice,
        *,
        limits: Mapping[str, float] | None = None,
        real_time: int | None = 20,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Starts the guardian, the servo and the device, and waits until it is held.

        Args:
            choice: which device; it may say something of the coupling, too (`coupling=virtual,friction=0.8`).
            limits: safety limits other than the default, by name.
            real_time: priority asked for; None: none.
            clock: monotonic, the same in all processes [s].

        Raises:
            DeviceError: there is no such device, it cannot be opened or calibrated, or a limit is beyond what is safe.
        """
        driver(choice.name)
        choice, self.said = coupling_of(choice)
        self._clock = clock
        self._folder = MemoryFolder()
        self._process: subprocess.Popen[bytes] | None = None
        self.report: ServoReport | None = None
        self._came = 0.0  # when that came [s]
        self._rest = b""
        self._warning_log = WarningLog(clock)
        self._step = self._rearm = 0
        self._over = ""
        self._kept_waiting = False  # real-time priority was refused
        self._silent = False
        self.statistics: dict[str, float] = {}
        self.process: dict[str, object] = {}
        self._number = 0  # of the coupling
        self.turning: EndOptions | None = None
        settings = self._settings = ServoSettings(
            device=choice,
            folder=self._folder.path,
            coupling=self.said,
            limits=dict(limits or {}),
            real_time=real_time,
        )
        try:
            self._orders = OrderWriter(self._folder.path)
            self._reports = ReportReader(self._folder.path)
            said = self._start(settings)
            self.spec: DeviceSpec = DeviceSpec(**said["spec"])
            self.process |= said["process"]
            self._priority(said["process"])
            self.servo = said["pid"]
            assert self._process is not None
            self.guardian = self._process.pid
            self.options: EndOptions = settings.end_options(self.spec)
            settings.turning_options(self.spec)  # what was said of turning fits the device
        except BaseException:
            self.close()
            raise

    @property
    def gone(self) -> bool:
        """Whether nothing is heard of the servo any more."""
        if self._over or self.report is None:
            return bool(self._over)
        return silent_for(self.report.time, self._came, self._clock()) > _GONE

    @property
    def causes(self) -> Cause:
        """Why force is removed now."""
        return NO_CAUSE if self.report is None else self.report.causes

    def read(self) -> ServoReport | None:
        """The newest report of this coupling, also if it was given before; None without one, or with the servo gone."""
        got = self._reports.read()
        if got is not None:
            self.report, self._came = got, self._clock()
        return None if self.gone or self.report is None or self.report.coupling != self._number else self.report

    def couple(self, below: CouplingChoice) -> EndOptions:
        """Begins anew with a coupling: relaxed, with a new ledger at both ends; the force comes back by the ramp.

        To be called whenever the proxy's end is made anew: what the device's end gave to the one before is spent.

        Args:
            below: what counts where the choice of the device says nothing.

        Returns:
            Its options, for the proxy's end.

        Raises:
            DeviceError: it does not fit the device.
        """
        chosen = self.said.over(below)
        self.options = replace(self._settings, coupling=chosen).end_options(self.spec)
        self.turning = None
        self._number += 1
        return self.options

    def couple_turning(self, below: CouplingChoice) -> EndOptions | None:
        """Lets this coupling turn as well, with a device that renders torques; after `couple`, before an order.

        Args:
            below: as of `couple`.

        Returns:
            Options of that, for the proxy's end of turning; None: the device renders no torque.

        Raises:
            DeviceError: it does not fit the device.
        """
        chosen = self.said.over(below)
        self.turning = replace(self._settings, coupling=chosen).turning_options(self.spec)
        return self.turning

    def order(
        self,
        place: Vector | None,
        message: EnergyMessage,
        *,
        enable: bool = True,
        orientation: Quaternion | None = None,
        twist: EnergyMessage = _SILENT,
    ) -> None:
        """Tells the servo where the proxy is now, and how it is turned.

        Args:
            place: in the device's frame [m]; None: nowhere.
            message: of the proxy's end.
            enable: whether force is wanted.
            orientation: in the device's frame, quaternion xyzw; None: none to follow.
            twist: of the proxy's end of turning.
        """
        self._step += 1
        self._orders.write(
            Order(
                time=self._clock(),
                step=self._step,
                place=place,
                message=message,
                enable=enable,
                rearm=self._rearm,
                coupling=self._number,
                options=self.options if self._number else None,
                turning=self.turning if self._number else None,
                orientation=orientation,
                twist=twist,
            )
        )

    def rearm(self) -> None:
        """Lets the force come back after it was latched off; with the next order."""
        self._rearm += 1

    def warning_log(self) -> list[str]:
        """What the user should be told since the last call: why force was removed, that a process is gone."""
        for said in self._received(0.0):
            self._take(said)
        if not self._over and self._process is not None and self._process.poll() is not None:
            self._over = "guardian"
            self._warning_log.say("the program that watches over the device is gone; force is off")
        if self.report is not None:
            self._warning_log.force(self.causes)
        silent = self.gone and not self._over
        if silent and not self._silent:
            self._warning_log.say("the device's servo is silent; the proxy moves freely until it is back")
        self._silent = silent
        return self._warning_log.fresh()

    def close(self) -> None:
        """Ends the processes and takes the mailboxes away; the device is stopped first."""
        process, self._process = self._process, None
        if process is not None:
            assert process.stdin is not None
            assert process.stdout is not None
            process.stdin.close()  # the guardian sees it, ends the servo, and the servo stops its device
            try:
                process.wait(10.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait(10.0)
            for said in self._received(0.0, process):
                self._take(said)
            process.stdout.close()
        if hasattr(self, "_reports"):
            self._reports.close()
            self._orders.close()
        self._folder.close()

    def _start(self, settings: ServoSettings) -> _Ready:
        process = self._process = subprocess.Popen(  # noqa: S603
            [sys.executable, "-c", GUARDIAN],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
            env={**os.environ, **ONE_THREAD},
        )
        assert process.stdin is not None
        process.stdin.write(settings.line().encode())
        process.stdin.flush()
        end = self._clock() + _PATIENCE
        while self._clock() < end:
            ready: _Ready | None = None
            for said in self._received(0.1):
                ready = cast("_Ready", said) if "ready" in said else ready
                self._watched(said)
                if "error" in said:
                    raise DeviceError(str(said["error"]))
            if ready is not None:
                return ready
            if process.poll() is not None:
                break
        raise DeviceError(f'the device "{settings.device.name}" did not start; its process ended or hangs')

    def _received(self, wait: float, ended: "subprocess.Popen[bytes] | None" = None) -> list[dict[str, object]]:
        """What the processes wrote; never waits longer than it says."""
        process = self._process or ended
        if process is None or process.stdout is None:
            return []
        pipe = process.stdout.fileno()
        while select.select([pipe], [], [], wait)[0]:
            content = os.read(pipe, 65536)
            if not content:
                break
            self._rest += content
            wait = 0.0
        return self._lines()

    def _lines(self) -> list[dict[str, object]]:
        *whole, self._rest = self._rest.split(b"\n")
        found: list[dict[str, object]] = []
        for line in whole:
            try:
                found.append(json.loads(line))
            except ValueError:  # a vendor's library that prints
                continue
        return found

    def _priority(self, state: Mapping[str, object]) -> None:
        """Tells whoever holds the device, once, that its processes may be kept waiting."""
        refused = state.get("real_time_refused")
        if self._settings.real_time is None or not refused or self._kept_waiting:
            return
        self._kept_waiting = True
        self._warning_log.say(priority_refused(str(refused)))

    def _watched(self, said: dict[str, object]) -> None:
        """Takes what the guardian says of itself; it may be slower to load than the servo."""
        if (guardian := table_of(said.get("guardian"))) is not None:
            self.process["guardian"] = guardian
            self._priority(guardian)

    def _take(self, said: dict[str, object]) -> None:
        self.statistics.update(cast("dict[str, float]", said.get("pace") or {}))
        self._watched(said)
        if said.get("fault"):
            self._warning_log.say(f"the device failed: {said['fault']}")
        elif "error" in said:
            self._warning_log.say(f"the device failed: {said['error']}")
        elif "gone" in said:
            self._over = "servo"
            self._warning_log.say(f"the device's servo is gone; the device was {said['halted']}")
        elif "still" in said:
            self._warning_log.say("the device's servo has stopped; its force was removed by the guardian")
