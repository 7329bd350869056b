"""The process between peer and servo: it takes the force away if the servo dies or stands still.

It is the servo's parent and the peer's child, in a session of its own, so that no Ctrl-C reaches it. It does nothing
but look: whether the servo runs and ticks, and whether the peer still holds the other end of its standard input.
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
from typing import Any

from cotouch.haptics._boards import ReportReader
from cotouch.haptics._registry import Driver, driver, make_device
from cotouch.haptics._servo import STILL
from cotouch.haptics._settings import ServoSettings

# How often it looks [s].
_LOOK = 0.005
# A servo that stands still longer than this is ended [s]: where it can be stopped from outside; and where it cannot, so
# that the system closes the device and its own watchdog acts.
_KILL, _KILL_AT_ONCE = 1.0, 0.09
# A look that comes so late means that the machine stood still, and the servo with it; it gets one more look [s].
_LATE = 0.02
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
    try:
        chosen = driver(settings.device.name)
        _watch(servo, settings, chosen, asked)
    finally:
        code = _ended(servo)
    if code not in {0, 2}:  # it did not stop its device itself
        _said(gone="servo", code=code, halted=halt(chosen, settings))
    if _peer_is_gone():
        shutil.rmtree(settings.folder, ignore_errors=True)
    return 0 if code == 0 else 1


def _watch(servo: subprocess.Popen[str], settings: ServoSettings, chosen: Driver, asked: list[int]) -> None:
    """Until the servo is gone, or should go."""
    reports = ReportReader(settings.folder)
    heard: float | None = None
    looked = time.monotonic()
    said = False
    while servo.poll() is None and not asked:
        if _peer_is_gone(wait=_LOOK):
            return
        now = time.monotonic()
        late, looked = now - looked > _LATE, now
        if reports.read() is not None:
            heard, said = now, False
        still = 0.0 if heard is None else now - heard
        if still > STILL and chosen.halt is not None:
            with contextlib.suppress(Exception):
                chosen.halt(**settings.device.options)
            if not said:
                said = True
                _said(still=still)
        if still > _KILL or (still > _KILL_AT_ONCE and chosen.halt is None and not late):
            servo.kill()


def halt(chosen: Driver, settings: ServoSettings) -> str:
    """Takes the force away from outside, after the servo died.

    By the driver's own way if it has one, else by opening the device anew and stopping it, as far as it lets itself be
    opened. Says how, in words.
    """
    if chosen.halt is not None:
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
    return "opened anew and stopped"


def _ended(servo: subprocess.Popen[str]) -> int:
    """Asks it to end, if it has not, and waits."""
    if servo.poll() is None:
        servo.terminate()
    try:
        return servo.wait(_PATIENCE)
    except subprocess.TimeoutExpired:
        servo.kill()
        return servo.wait(_PATIENCE)


def _peer_is_gone(wait: float = 0.0) -> bool:
    """Whether the peer has closed its end, or is dead; waits for that so long [s]."""
    ready, _, _ = select.select([sys.stdin], [], [], wait)
    return bool(ready) and os.read(sys.stdin.fileno(), 1) == b""


def _said(**values: Any) -> None:
    with contextlib.suppress(OSError, ValueError):
        sys.stdout.write(json.dumps(values) + "\n")
        sys.stdout.flush()
