"""The device of somebody who takes part, for as long as it lasts."""

from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any, final

from cotouch.haptics import DeviceChoice, ServoLink, reasons
from cotouch.session._tape import Tape


@final
class HeldDevice:
    """A device, or none.

    Attributes:
        wanted: whether one moves the copy.
        link: to it; None: none, or it moves nothing yet.
    """

    def __init__(self, text: str | None, link: ServoLink | None, warn: Callable[[str], None]) -> None:
        """Takes what was asked for.

        Args:
            text: the device in words; None: none.
            link: to it.
            warn: is told why force is off.
        """
        self.wanted = text is not None
        self.link = link
        self._text, self._warn = text, warn
        self._said: list[str] = []

    @property
    def unheld(self) -> "HeldDevice":
        """The same with nobody at it, for steps that nobody sees."""
        return HeldDevice(self._text, None, self._warn)

    def tend(self, tape: Tape | None, now: float) -> None:
        """Passes on what is to be said of the device.

        Args:
            tape: that records; None: none.
            now: [s].
        """
        if self.link is None:
            return
        for text in self.link.notices():
            self._said.append(text)
            self._warn(text)
            if tape is not None:
                tape.event("device", now, reason=text)

    def summary(self) -> dict[str, Any] | None:
        """How it went; None without a device."""
        link = self.link
        if link is None:
            return None
        self.tend(None, 0.0)
        report = link.report
        return {
            "device": self._text,
            "name": link.spec.name,
            "coupling": {"law": link.options.law, "stiffness": link.options.stiffness, "damping": link.options.damping},
            "gone": link.gone,
            "causes": [] if report is None else reasons(report.causes),
            "ticks": 0 if report is None else report.tick,
            "work": 0.0 if report is None else report.work,
            "excess": None if report is None else report.excess,
            "said": self._said,
            "process": link.process,
        }


@contextmanager
def held_device(text: str | None, warn: Callable[[str], None]) -> Generator[HeldDevice]:
    """Opens a device and the processes around it; all of them end with the context.

    Args:
        text: the device in words; None: none.
        warn: is told why force is off.

    Raises:
        DeviceError: it does not open.
    """
    link = None if text is None else ServoLink(DeviceChoice.read(text))
    try:
        yield HeldDevice(text, link, warn)
    finally:
        if link is not None:
            link.close()
