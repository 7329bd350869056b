"""The process between peer and servo: it takes the force away if the servo dies or stands still.

It is the servo's parent and the peer's child, in a session of its own, so that no Ctrl-C reaches it. It does nothing
but look, every 2 ms and ahead of the servo where real-time priority is permitted: whether the servo runs and ticks, and
whether the peer still holds the other end of its standard input. Each look is said on a mailbox, so that the servo
knows when nobody watches it.

What it does about a servo that stands still does not depend on the peer: one that has not said that it stopped its
device is halted from outside, or ended and its device opened anew, whether the peer lives, hangs, or is dead.
"""

import contextlib
import json
import os
import select
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from typing import final

from cotouch.haptics._mailboxes import GUARD, GUARD_FIELDS, ReportReader
from cotouch.haptics._registry import Driver, driver, make_device
from cotouch.haptics._safety import FOR_GOOD
from cotouch.haptics._servo import STILL
from cotouch.haptics._settings import ServoSettings
from cotouch.mailbox import MailboxWriter
from cotouch.pacing import prepare_process

# How often it looks [s]; how often it halts a servo from outside that still stands still [s].
_LOOK, _AGAIN = 0.002, 0.02
# A servo is not taken for dead before so many looks found nothing new: where all of the machine stood still, it is
# given the time to say so.
_LEAST = 5
# A servo that stands still longer than this is ended [s], where it can be halted from outside; where it cannot, it is
# ended at once, so that the system closes the device, which is then opened anew.
_KILL = 1.0
# One that is asked to end, and has stopped its device, may take so long to close it [s].
_PATIENCE = 2.0


def main(line: str, servo: subprocess.Popen[str]) -> int:
    """Runs in a process of its own; ends when the servo has.

    Args:
        line: the settings.
        servo: its process, which has them too.
    """
    settings = ServoSettings.read(line)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    asked: list[int] = []
    signal.signal(signal.SIGTERM, lambda number, _: asked.append(number))
    chosen: Driver | None = None
    try:
        chosen = driver(settings.device.name)
        above = None if settings.real_time is None else settings.real_time + 1
        with prepare_process(real_time=above) as state:
            _said(guardian=asdict(state))
            code = ServoWatch(servo, settings, chosen).run(lambda: bool(asked) or _peer_is_gone())
    except Exception as error:  # noqa: BLE001  # whatever failed here, nobody watches the servo any more
        servo.kill()
        code = servo.wait()
        _said(fault=f"the program that watches over it failed: {error}")
    if code not in {0, 2}:  # it did not stop its device itself
        _said(gone="servo", code=code, halted=halt(chosen, settings))
    if _peer_is_gone():
        shutil.rmtree(settings.folder, ignore_errors=True)
    return 0 if code == 0 else 1


@final
class ServoWatch:
    """Looks at the servo until it has ended."""

    def __init__(self, servo: subprocess.Popen[str], settings: ServoSettings, chosen: Driver) -> None:
        """Begins to look.

        Args:
            servo: its process.
            settings: of it.
            chosen: the driver of its device.
        """
        self._servo, self._settings, self._chosen = servo, settings, chosen
        self._reports = ReportReader(settings.folder)
        self._looks = MailboxWriter(settings.folder / GUARD, GUARD_FIELDS)  # that it looks
        self._last_tick: float | None = None  # when the servo ticked last; None: it never had force
        self._safe = False  # whether it said that it stopped its device
        self._vain = 0  # looks since then
        self._halted: float | None = None

    def run(self, unwanted: Callable[[], bool]) -> int:
        """Until the servo has ended; its exit code.

        Args:
            unwanted: whether the servo should end.
        """
        end: float | None = None
        while (code := self._servo.poll()) is None:
            self._looks.publish()
            if end is None and unwanted():
                self._servo.terminate()
                end = time.monotonic() + _PATIENCE
            self._look()
            if end is not None and time.monotonic() > end:
                self._servo.kill()
            time.sleep(_LOOK)
        self._looks.close()
        return code

    def _look(self) -> None:
        now = time.monotonic()
        report = self._reports.read()
        if report is not None:
            self._last_tick, self._vain, self._halted = now, 0, None
            self._safe = bool(report.causes & FOR_GOOD)
        self._vain += 1
        still = 0.0 if self._last_tick is None or self._safe else now - self._last_tick
        if still <= STILL or self._vain < _LEAST:
            return
        halting = self._chosen.halt
        if halting is None:
            self._servo.kill()
            return
        if self._halted is None:
            _said(still=still)
        if self._halted is None or now - self._halted >= _AGAIN:
            with contextlib.suppress(Exception):
                halting(**self._settings.device.options)
            self._halted = now
        if still > _KILL:
            self._servo.kill()


def halt(chosen: Driver | None, settings: ServoSettings) -> str:
    """Takes the force away from outside, after the servo died.

    By the driver's own way if it has one, else by opening the device anew and stopping it, as far as it lets itself be
    opened. Says how, in words.

    Args:
        chosen: driver of the device; None if it is not known.
        settings: of the servo.
    """
    if chosen is not None and chosen.halt is not None:
        try:
            chosen.halt(**settings.device.options)
        except Exception as error:  # noqa: BLE001  # whatever the driver raises, nothing else may fail now
            return f"halting it failed: {error}"
        return "halted from outside"
    try:
        device = make_device(settings.device.name, **settings.device.options)
        try:
            device.open()
            device.stop()
        finally:
            device.close()
    except Exception as error:  # noqa: BLE001  # as above
        return f"only its own watchdog could stop it ({error})"
    return "reopened and stopped"


def _peer_is_gone() -> bool:
    """Whether the peer has closed its end, or is dead."""
    ready, _, _ = select.select([sys.stdin], [], [], 0.0)
    return bool(ready) and os.read(sys.stdin.fileno(), 1) == b""


def _said(**values: object) -> None:
    with contextlib.suppress(OSError, ValueError):
        sys.stdout.write(json.dumps(values) + "\n")
        sys.stdout.flush()
