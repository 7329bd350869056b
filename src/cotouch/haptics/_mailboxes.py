"""What peer and servo write on the two mailboxes between them: one record each, and that a guardian looks."""

from collections.abc import Callable, Iterator
from itertools import islice
from math import inf
from pathlib import Path
from struct import Struct
from typing import Any, Final, TypeAlias, final

from cotouch.arrays import Array
from cotouch.coupling import NAME_BYTES, EnergyMessage
from cotouch.errors import InputError
from cotouch.haptics._core import Order, ServoReport
from cotouch.haptics._device import Flag
from cotouch.haptics._ends import EndOptions
from cotouch.haptics._quaternions import Quaternion
from cotouch.haptics._safety import ZERO, Cause, Vector
from cotouch.mailbox import MailboxReader, MailboxWriter

# Values as they come out of a record, the next first.
_Said: TypeAlias = Iterator[Any]

REPORT: Final = "report"
ORDER: Final = "order"
GUARD: Final = "guard"
GUARD_FIELDS: Final = {"looks": ((), "i8")}
_RECORD: Final = "record"
_MESSAGE: Final = "6d?"
_OPTIONS: Final = "".join(f"{NAME_BYTES}s" if name == "law" else "d" for name in EndOptions._fields)
# What a `ServoReport` says, in its order.
_REPORT: Final = Struct(f"<dq12d{_MESSAGE}2d4q4d6d{_MESSAGE}")
# Likewise an `Order`; first whether there is a place, a coupling and one of turning, and these.
_ORDER: Final = Struct(f"<3?3d{_OPTIONS}{_OPTIONS}dq{_MESSAGE}?2q4d{_MESSAGE}")
_UNTOLD: Final = (0.0, 0.0, 0.0, 0.0)  # no orientation


class _Writer:
    """The end of a mailbox that writes one record."""

    def __init__(self, path: Path, record: Struct) -> None:
        self._mailbox, self._record = MailboxWriter(path, {_RECORD: ((record.size,), "u1")}, checked=True), record

    def _publish(self, *values: object) -> None:
        self._record.pack_into(self._mailbox.fields[_RECORD].data, 0, *values)
        self._mailbox.publish()

    def close(self) -> None:
        """Removes it."""
        self._mailbox.close()


class _Reader:
    """The other end, of a mailbox that may not be there yet."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._mailbox: MailboxReader | None = None

    def _newest(self) -> dict[str, Array] | None:
        """What was not given yet."""
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


@final
class ReportWriter(_Writer):
    """The servo's mailbox."""

    def __init__(self, folder: Path) -> None:
        """Makes it in a private folder."""
        super().__init__(folder / REPORT, _REPORT)

    def write(self, report: ServoReport, time: float) -> None:
        """Publishes a report.

        Args:
            report: of a cycle.
            time: of its end, on the clock of all processes of this machine [s].
        """
        self._publish(
            time,
            report.tick,
            *report.place,
            *report.rate,
            *report.force,
            *report.wanted,
            *report.message,
            report.work,
            report.excess,
            report.causes,
            report.buttons,
            report.flags,
            report.coupling,
            *(report.orientation or _UNTOLD),
            *report.torque,
            *report.spin,
            *report.twist,
        )


@final
class OrderWriter(_Writer):
    """The peer's mailbox."""

    def __init__(self, folder: Path) -> None:
        """Makes it in a private folder."""
        super().__init__(folder / ORDER, _ORDER)

    def write(self, order: Order) -> None:
        """Publishes an order."""
        self._publish(
            order.place is not None,
            order.options is not None,
            order.turning is not None,
            *(order.place or ZERO),
            *_told(order.options),
            *_told(order.turning),
            order.time,
            order.step,
            *order.message,
            order.enable,
            order.rearm,
            order.coupling,
            *(order.orientation or _UNTOLD),
            *order.twist,
        )


@final
class ReportReader(_Reader):
    """What the servo says, as the peer or the guardian sees it."""

    def __init__(self, folder: Path) -> None:
        """Waits for the mailbox to appear in this folder."""
        super().__init__(folder / REPORT)

    def read(self) -> ServoReport | None:
        """The newest report that was not given yet."""
        got = self._newest()
        if got is None:
            return None
        said: _Said = iter(_REPORT.unpack(got[_RECORD].data))
        return ServoReport(
            time=next(said),
            tick=next(said),
            place=_vector(said),
            rate=_vector(said),
            force=_vector(said),
            wanted=_vector(said),
            message=_message(said),
            work=next(said),
            excess=next(said),
            causes=Cause(next(said)),
            buttons=next(said),
            flags=Flag(next(said)),
            coupling=next(said),
            orientation=_turned(said),
            torque=_vector(said),
            spin=_vector(said),
            twist=_message(said),
        )


@final
class OrderReader(_Reader):
    """What the peer says, as the servo sees it."""

    def __init__(self, folder: Path) -> None:
        """Waits for the mailbox to appear in this folder."""
        super().__init__(folder / ORDER)

    def read(self) -> Order | None:
        """The newest order that was not given yet."""
        got = self._newest()
        if got is None:
            return None
        said: _Said = iter(_ORDER.unpack(got[_RECORD].data))
        followed, coupled, turns = islice(said, 3)
        place, options, turning = _vector(said), _options(said), _options(said)
        return Order(
            time=next(said),
            step=next(said),
            place=place if followed else None,
            message=_message(said),
            enable=next(said),
            rearm=next(said),
            coupling=next(said),
            options=options if coupled else None,
            turning=turning if turns else None,
            orientation=_turned(said),
            twist=_message(said),
        )


@final
class Watched(_Reader):
    """Whether the guardian looks, as the servo sees it."""

    def __init__(self, folder: Path, clock: Callable[[], float]) -> None:
        """Waits for the guardian's mailbox to appear in this folder.

        Args:
            folder: private one.
            clock: monotonic [s].
        """
        super().__init__(folder / GUARD)
        self._clock, self._last = clock, -inf

    def silence(self) -> float:
        """For how long the guardian has not looked, at least as far as this was called; inf: never [s]."""
        now = self._clock()
        if self._newest() is not None:
            self._last = now
        return now - self._last


def _told(options: EndOptions | None) -> tuple[object, ...]:
    return tuple(field.encode() if isinstance(field, str) else field for field in options or EndOptions())


def _options(said: _Said) -> EndOptions:
    told = dict(zip(EndOptions._fields, said, strict=False))  # more follows
    return EndOptions(**told | {"law": told["law"].rstrip(b"\0").decode(errors="replace")})


def _message(said: _Said) -> EnergyMessage:
    return EnergyMessage(*islice(said, len(EnergyMessage._fields)))


def _turned(said: _Said) -> Quaternion | None:
    x, y, z, w = islice(said, 4)
    return (x, y, z, w) if any((x, y, z, w)) else None


def _vector(said: _Said) -> Vector:
    return next(said), next(said), next(said)
