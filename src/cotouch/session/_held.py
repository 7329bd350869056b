"""The device of somebody who takes part, or one for each hand, for as long as they last."""

from collections import deque
from collections.abc import Callable, Generator, Sequence
from contextlib import ExitStack, contextmanager
from typing import final

from cotouch.errors import DeviceError
from cotouch.haptics import DeviceChoice, ServoLink, reasons
from cotouch.members import MOST_NOTICE, SessionRecorder

# Between the names of two devices.
AND = " + "
_HANDS = 2
# Sentences that wait for a status to tell them.
_MOST_NEWS = 16


@final
class HeldDevice:
    """Devices, or none.

    Attributes:
        wanted: whether any moves the copy.
        link: to each; None: none, or it moves nothing yet.
    """

    def __init__(self, text: str | None, link: Sequence[ServoLink] | None, warn: Callable[[str], None]) -> None:
        """Takes what was asked for.

        Args:
            text: the devices in words; None: none.
            link: to each.
            warn: is told why force is off.
        """
        self.wanted = text is not None
        self.link = link
        self._text, self._warn = text, warn
        self._said: list[list[str]] = [[] for _ in link or ()]
        self._news = deque[str](maxlen=_MOST_NEWS)

    @property
    def unheld(self) -> "HeldDevice":
        """The same with nobody at it, for steps that nobody sees."""
        return HeldDevice(self._text, None, self._warn)

    def service(self, session_recorder: SessionRecorder | None, now: float) -> None:
        """Passes on what is to be said of the devices.

        Args:
            session_recorder: that records; None: none.
            now: [s].
        """
        links = self.link or ()
        for link, said in zip(links, self._said, strict=True):
            for text in link.warning_log():
                whose = text if len(links) == 1 else f"{link.spec.name}: {text}"
                said.append(text)
                self._warn(whose)
                self._news.append("".join(filter(str.isprintable, whose))[:MOST_NOTICE])
                if session_recorder is not None:
                    session_recorder.event("device", now, reason=whose)

    def notice(self) -> str:
        """What others should see of the devices now: the next sentence that was not told yet, else the last."""
        if len(self._news) > 1:
            return self._news.popleft()
        return self._news[0] if self._news else ""

    def summary(self) -> dict[str, object] | None:
        """How it went, with a second device under `other`; None without a device."""
        if not self.link:
            return None
        self.service(None, 0.0)
        assert self._text is not None
        parts = zip(self._text.split(AND), self.link, self._said, strict=True)
        first, *others = [_summary(text, link, said) for text, link, said in parts]
        return first | ({"other": others[0]} if others else {})


def _summary(text: str, link: ServoLink, said: list[str]) -> dict[str, object]:
    report = link.report
    return {
        "device": text,
        "name": link.spec.name,
        "coupling": {"law": link.options.law, "stiffness": link.options.stiffness, "damping": link.options.damping},
        "gone": link.gone,
        "causes": [] if report is None else reasons(report.causes),
        "ticks": 0 if report is None else report.tick,
        "work": 0.0 if report is None else report.work,
        "excess": None if report is None else report.excess,
        "said": said,
        "process": link.process,
    }


def device_choices(text: str) -> list[DeviceChoice]:
    """One device, or one for each hand.

    Args:
        text: as `haply`, or `haply:id=049D + touch`.

    Raises:
        DeviceError: it is neither.
    """
    found = [DeviceChoice.read(part) for part in text.split(AND)]
    if len(found) > _HANDS:
        raise DeviceError(f'device is "{text}", which names {len(found)} devices; a person has two hands')
    return found


@contextmanager
def held_device(text: str | None, warn: Callable[[str], None]) -> Generator[HeldDevice]:
    """Opens devices and the processes around them; all of them end with the context.

    Args:
        text: the device, or two with " + " between them, in words; None: none.
        warn: is told why force is off.

    Raises:
        DeviceError: one does not open.
    """
    if text is None:
        yield HeldDevice(None, None, warn)
        return
    with ExitStack() as stack:
        links: list[ServoLink] = []
        for choice in device_choices(text):
            links.append(ServoLink(choice))
            stack.callback(links[-1].close)
        yield HeldDevice(text, links, warn)
