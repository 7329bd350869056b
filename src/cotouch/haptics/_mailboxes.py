"""What peer and servo write on the two mailboxes between them."""

from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import Final, final

import numpy as np

from cotouch.arrays import Array
from cotouch.coupling import EnergyMessage
from cotouch.errors import InputError
from cotouch.haptics._core import Order, ServoReport
from cotouch.haptics._device import Flag
from cotouch.haptics._ends import EndOptions
from cotouch.haptics._quaternions import Quaternion
from cotouch.haptics._safety import Cause, Vector
from cotouch.mailbox import MailboxReader, MailboxWriter

REPORT: Final = "report"
ORDER: Final = "order"
GUARD: Final = "guard"
_OF_COUPLING: Final = tuple(name for name in EndOptions._fields if name != "law")
# A law's name is told in so many bytes.
_NAME: Final = 32
_GUARD_FIELDS: Final = {"looks": ((), "i8")}
_REPORT_FIELDS: Final = {
    "time": ((), "f8"),
    "tick": ((), "i8"),
    "place": ((3,), "f8"),
    "rate": ((3,), "f8"),
    "force": ((3,), "f8"),
    "wanted": ((3,), "f8"),
    "message": ((6,), "f8"),  # all but the last of `EnergyMessage`
    "ledger": ((2,), "f8"),  # work, excess
    "states": ((6,), "i8"),  # starved, causes, buttons, flags, number of the coupling, starved of turning
    "orientation": ((4,), "f8"),  # 0: none
    "torque": ((3,), "f8"),
    "spin": ((3,), "f8"),
    "twist": ((6,), "f8"),
}
_ORDER_FIELDS: Final = {
    "time": ((), "f8"),
    "step": ((), "i8"),
    "place": ((3,), "f8"),
    "message": ((6,), "f8"),
    # starved, followed, enable, rearm, number of the coupling, starved of turning, whether there is a coupling of it
    "states": ((7,), "i8"),
    "law": ((_NAME,), "u1"),  # of the coupling; like its numbers meant where the number is above 0
    "coupling": ((len(_OF_COUPLING),), "f8"),
    "turning": ((len(_OF_COUPLING),), "f8"),  # of its coupling, which is PSPM
    "orientation": ((4,), "f8"),  # 0: none
    "twist": ((6,), "f8"),
}


@final
class ReportWriter:
    """The servo's mailbox."""

    def __init__(self, folder: Path) -> None:
        """Makes it in a private folder."""
        self._mailbox = MailboxWriter(folder / REPORT, _REPORT_FIELDS, checked=True)

    def write(self, report: ServoReport, time: float) -> None:
        """Publishes a report.

        Args:
            report: of a cycle.
            time: of its end, on the clock of all processes of this machine [s].
        """
        fields, message = self._mailbox.fields, report.message
        fields["time"][...] = time
        fields["tick"][...] = report.tick
        fields["place"][:] = report.place
        fields["rate"][:] = report.rate
        fields["force"][:] = report.force
        fields["wanted"][:] = report.wanted
        fields["message"][:] = message[:-1]
        fields["ledger"][:] = (report.work, report.excess)
        states = (message.starved, report.causes, report.buttons, report.flags, report.coupling, report.twist.starved)
        fields["states"][:] = states
        fields["orientation"][:] = 0.0 if report.orientation is None else report.orientation
        fields["torque"][:] = report.torque
        fields["spin"][:] = report.spin
        fields["twist"][:] = report.twist[:-1]
        self._mailbox.publish()

    def close(self) -> None:
        """Removes it."""
        self._mailbox.close()


@final
class OrderWriter:
    """The peer's mailbox."""

    def __init__(self, folder: Path) -> None:
        """Makes it in a private folder."""
        self._mailbox = MailboxWriter(folder / ORDER, _ORDER_FIELDS, checked=True)

    def write(self, order: Order) -> None:
        """Publishes an order."""
        fields, message = self._mailbox.fields, order.message
        fields["time"][...] = order.time
        fields["step"][...] = order.step
        if order.place is not None:
            fields["place"][:] = order.place
        fields["message"][:] = message[:-1]
        said = (message.starved, order.place is not None, order.enable, order.rearm, order.coupling)
        fields["states"][:] = (*said, order.twist.starved, order.turning is not None)
        fields["orientation"][:] = 0.0 if order.orientation is None else order.orientation
        fields["twist"][:] = order.twist[:-1]
        if order.options is not None:
            options = order.options
            fields["law"][:] = np.frombuffer(options.law.encode().ljust(_NAME, b"\0"), np.uint8, _NAME)
            fields["coupling"][:] = [getattr(options, name) for name in _OF_COUPLING]
        if order.turning is not None:
            fields["turning"][:] = [getattr(order.turning, name) for name in _OF_COUPLING]
        self._mailbox.publish()

    def close(self) -> None:
        """Removes it."""
        self._mailbox.close()


@final
class ReportReader:
    """What the servo says, as the peer or the guardian sees it."""

    def __init__(self, folder: Path) -> None:
        """Waits for the mailbox to appear in this folder."""
        self._mailbox = _Awaited(folder / REPORT)

    def read(self) -> ServoReport | None:
        """The newest report that was not given yet."""
        got = self._mailbox.read()
        if got is None:
            return None
        work, excess = got["ledger"].tolist()
        starved, causes, buttons, flags, coupling, limp = got["states"].tolist()
        return ServoReport(
            time=float(got["time"]),
            tick=int(got["tick"]),
            place=_vector(got["place"]),
            rate=_vector(got["rate"]),
            force=_vector(got["force"]),
            wanted=_vector(got["wanted"]),
            message=EnergyMessage(*got["message"].tolist(), starved=bool(starved)),
            work=work,
            excess=excess,
            causes=Cause(causes),
            buttons=buttons,
            flags=Flag(flags),
            coupling=coupling,
            orientation=_turned(got["orientation"]),
            torque=_vector(got["torque"]),
            spin=_vector(got["spin"]),
            twist=EnergyMessage(*got["twist"].tolist(), starved=bool(limp)),
        )

    def close(self) -> None:
        """Lets go of the mailbox."""
        self._mailbox.close()


@final
class OrderReader:
    """What the peer says, as the servo sees it."""

    def __init__(self, folder: Path) -> None:
        """Waits for the mailbox to appear in this folder."""
        self._mailbox = _Awaited(folder / ORDER)
        self._number = 0
        self._options: EndOptions | None = None
        self._turning: EndOptions | None = None

    def read(self) -> Order | None:
        """The newest order that was not given yet."""
        got = self._mailbox.read()
        if got is None:
            return None
        starved, followed, enable, rearm, coupling, limp, turns = got["states"].tolist()
        if coupling != self._number:
            law = got["law"].tobytes().rstrip(b"\0").decode(errors="replace")
            self._number = coupling
            self._options = EndOptions(law=law, **dict(zip(_OF_COUPLING, got["coupling"].tolist(), strict=True)))
            turning = dict(zip(_OF_COUPLING, got["turning"].tolist(), strict=True))
            self._turning = EndOptions(**turning) if turns else None
        return Order(
            time=float(got["time"]),
            step=int(got["step"]),
            place=_vector(got["place"]) if followed else None,
            message=EnergyMessage(*got["message"].tolist(), starved=bool(starved)),
            enable=bool(enable),
            rearm=rearm,
            coupling=coupling,
            options=self._options,
            turning=self._turning,
            orientation=_turned(got["orientation"]),
            twist=EnergyMessage(*got["twist"].tolist(), starved=bool(limp)),
        )

    def close(self) -> None:
        """Lets go of the mailbox."""
        self._mailbox.close()


@final
class Looks:
    """The guardian's mailbox: that it looks."""

    def __init__(self, folder: Path) -> None:
        """Makes it in a private folder."""
        self._mailbox = MailboxWriter(folder / GUARD, _GUARD_FIELDS)

    def look(self) -> None:
        """Says that it looks now."""
        self._mailbox.publish()

    def close(self) -> None:
        """Removes it."""
        self._mailbox.close()


@final
class Watched:
    """Whether the guardian looks, as the servo sees it."""

    def __init__(self, folder: Path, clock: Callable[[], float]) -> None:
        """Waits for the guardian's mailbox to appear in this folder.

        Args:
            folder: private one.
            clock: monotonic [s].
        """
        self._mailbox, self._clock = _Awaited(folder / GUARD), clock
        self._last = -inf

    def silence(self) -> float:
        """For how long the guardian has not looked, at least as far as this was called; inf: never [s]."""
        now = self._clock()
        if self._mailbox.read() is not None:
            self._last = now
        return now - self._last

    def close(self) -> None:
        """Lets go of the mailbox."""
        self._mailbox.close()


@final
class _Awaited:
    """A mailbox that may not be there yet."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._mailbox: MailboxReader | None = None

    def read(self) -> dict[str, Array] | None:
        """The newest that was not given yet."""
        if self._mailbox is None:
            if not self._path.exists():
                return None
            try:
                self._mailbox = MailboxReader(self._path)
            except InputError:  # whoever makes it is about to
                return None
        return self._mailbox.read()

    def close(self) -> None:
        """Lets go of it."""
        if self._mailbox is not None:
            self._mailbox.close()


def _turned(array: Array) -> Quaternion | None:
    x, y, z, w = array.tolist()
    return (x, y, z, w) if any((x, y, z, w)) else None


def _vector(array: Array) -> Vector:
    x, y, z = array.tolist()
    return x, y, z
