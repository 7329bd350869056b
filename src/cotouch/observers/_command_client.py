"""The watching side of mailboxes: sees members of this machine, and tells them what to do.

Used by several threads; nothing here takes long.
"""

import math
import threading
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias, final

import numpy as np

from cotouch.arrays import Array
from cotouch.errors import InputError
from cotouch.mailbox import MailboxReader, MailboxWriter
from cotouch.members import SessionFile
from cotouch.observers._commands import HAND_MODES, HandMode
from cotouch.observers._mailboxes import LEDGER_COLUMNS, MailboxFolder, emulated, laws_of, order_fields
from cotouch.observers._session_api import CopyView, Emulated, HandView, Pointer

_NO_HANDS: tuple[HandView, ...] = ()
Triple: TypeAlias = tuple[float, float, float]
_ZERO: Triple = (0.0, 0.0, 0.0)


class RecordingOutcome(NamedTuple):
    """The outcome of a member's recording.

    Attributes:
        number: of the recording.
        steps: in the file.
        trouble: what is wrong with it, in words that follow "the recording"; empty: nothing.
    """

    number: int
    steps: int
    trouble: str


@final
@dataclass
class _Own:
    """One member's mailboxes."""

    name: str
    orders: MailboxWriter
    view: MailboxReader | None = None
    fields: dict[str, Array] | None = None
    shown: CopyView | None = None


@final
class CommandClient:
    """The mailboxes of members whose processes run here."""

    def __init__(self, mailboxes: MailboxFolder, session: SessionFile, names: list[str]) -> None:
        """Makes the orders; the members' processes are to be started after that.

        Args:
            mailboxes: where they are.
            session: that the members take part in.
            names: of the members.

        Raises:
            InputError: a mailbox cannot be made.
        """
        self._mailboxes = mailboxes
        self._lock = threading.RLock()
        users = session.scenario.network.size
        fields = order_fields(users)
        self._own = {name: _Own(name, MailboxWriter(mailboxes.orders(name), fields, checked=True)) for name in names}
        self._laws = laws_of(session.scenario, emulate=session.options.emulate)
        for own in self._own.values():
            own.orders.fields["fraction"][()] = 1.0
            own.orders.fields["laws"][...] = self._laws
            own.orders.publish()

    # -- orders ------------------------------------------------------------------------------------------------------

    def point(self, name: str, pointer: Pointer) -> None:
        """Moves a pointer; the next step of the copy knows it.

        Args:
            name: of the member.
            pointer: where the hand is to be.
        """
        self._tell(
            name,
            pointer.mode,
            pointer=pointer.number,
            node=pointer.node,
            target=pointer.target,
            start=pointer.target,
            edge=pointer.edge,
            turn=pointer.turn,
            radius=pointer.radius,
            stiffness=pointer.stiffness,
        )

    def hand(
        self,
        name: str,
        mode: HandMode,
        *,
        node: int = -1,
        to: Triple | None = None,
        at: Triple | None = None,
        edge: Triple | None = None,
        turn: Triple | None = None,
    ) -> None:
        """Tells a hand what to do; see `SessionApi.do`.

        Args:
            name: of the member.
            mode: what the hand does.
            node: of the body; -1: as it is.
            to: where it pulls to, or leads its blade or tool to [m].
            at: where its blade is put down [m].
            edge: of the blade [m].
            turn: of the tool [rad].
        """
        places = {"target": to or _ZERO, "start": at or _ZERO, "edge": edge or _ZERO, "turn": turn or _ZERO}
        self._tell(name, mode, pointer=0, node=node, radius=0.0, stiffness=0.0, **places)

    def mode(self, name: str) -> HandMode:
        """What a hand was told last."""
        with self._lock:
            return HAND_MODES[int(self._own[name].orders.fields["mode"].item())]

    def impair(self, to: int, of: int, **law: float) -> None:
        """Changes what is done to samples from `of` to `to`; what is not named stays.

        Args:
            to: slot that receives.
            of: slot that sends.
            **law: delay, jitter [s], loss, cut.
        """
        with self._lock:
            row = self._laws[to, of]
            row[:] = [law.get(name, value) for name, value in zip(("delay", "jitter", "loss", "cut"), row, strict=True)]
            for own in self._own.values():
                own.orders.fields["laws"][...] = self._laws
                own.orders.fields["impaired"] += 1
                own.orders.publish()

    def damping(self, fraction: float, *, until: float = math.inf) -> int:
        """Orders a share of the damping that is needed.

        Args:
            fraction: 1: all of it.
            until: when members take all of it again, unless `hold_damping` says a later time [s].

        Returns:
            The order's number, which whoever runs away tells.
        """
        with self._lock:
            for own in self._own.values():
                own.orders.fields["damped"] += 1
            self._all(fraction=fraction, lease=until)
            return max(int(own.orders.fields["damped"].item()) for own in self._own.values())

    def hold_damping(self, until: float) -> None:
        """Lets the share that was ordered last hold until then [s]."""
        self._all(lease=until)

    def record(self, number: int, *, on: bool) -> None:
        """Orders a recording, or its end.

        Args:
            number: of the recording, from 1.
            on: begin or end.
        """
        self._all(recording=number, recording_on=on)

    def _all(self, **values: float) -> None:
        with self._lock:
            for own in self._own.values():
                for name, value in values.items():
                    own.orders.fields[name][()] = value
                own.orders.publish()

    def _tell(self, name: str, mode: HandMode, **parts: float | Triple) -> None:
        """Writes an order; its parts are named as the mailbox has them."""
        with self._lock:
            fields = self._own[name].orders.fields
            fields["hand"] += 1
            fields["mode"][()] = HAND_MODES.index(mode)
            for part, value in parts.items():
                fields[part][...] = value
            self._own[name].orders.publish()

    # -- what is seen ------------------------------------------------------------------------------------------------

    def views(self) -> dict[int, CopyView]:
        """The newest of every copy, and of others what neighbours know of them."""
        with self._lock:
            for own in self._own.values():
                self._look(own)
            shown = {own.shown.slot: own.shown for own in self._own.values() if own.shown is not None}
            for own in self._own.values():
                if own.shown is not None and own.fields is not None:
                    _ghosts(own.shown, own.fields, shown)
            return shown

    def emulated(self) -> dict[tuple[int, int], Emulated]:
        """What is done on every path, (to, from)."""
        with self._lock:
            users = range(self._laws.shape[0])
            return {(to, of): emulated(self._laws[to, of]) for to in users for of in users if to != of}

    def number(self, name: str, field: str) -> int:
        """A whole number of a member's mailbox; see `view_fields`. -1 before there is one.

        Args:
            name: of the member.
            field: name of the field.
        """
        with self._lock:
            own = self._own[name]
            self._look(own)
            return -1 if own.fields is None else int(own.fields[field].item())

    def outcome(self, name: str) -> RecordingOutcome | None:
        """How the last recording of a member came out; None before there was one."""
        with self._lock:
            own = self._own[name]
            self._look(own)
            if own.fields is None or not own.fields["recorded"]:
                return None
            trouble = bytes(own.fields["recorded_trouble"].item()).decode(errors="ignore")
            return RecordingOutcome(
                int(own.fields["recorded"].item()), int(own.fields["recorded_steps"].item()), trouble
            )

    def forget(self, name: str) -> None:
        """A member's process ended; it may come again, with another mailbox."""
        with self._lock:
            own = self._own[name]
            if own.view is not None:
                own.view.close()
            own.view = own.fields = own.shown = None
            self._mailboxes.view(name).unlink(missing_ok=True)
            own.orders.fields["mode"][()] = HAND_MODES.index("script")
            own.orders.fields["pointer"][()] = 0
            own.orders.publish()

    def close(self) -> None:
        """Removes the orders."""
        with self._lock:
            for own in self._own.values():
                if own.view is not None:
                    own.view.close()
                    own.view = None
                own.orders.close()

    def _look(self, own: _Own) -> None:
        if own.view is None:
            try:
                own.view = MailboxReader(self._mailboxes.view(own.name))
            except InputError:  # its process did not make it yet
                return
        fields = own.view.read()
        if fields is not None:
            own.fields = fields
            own.shown = _copy(fields) if fields["slot"] >= 0 and fields["step"] > 0 else None


def _copy(fields: Mapping[str, Array]) -> CopyView:
    ledger = dict(zip(LEDGER_COLUMNS, fields["ledger"].tolist(), strict=True))
    hands = tuple(
        HandView(
            mode=HAND_MODES[int(fields["mode"][k])],
            node=int(fields["node"][k]),
            target=fields["target"][k],
            place=fields["place"][k],
            force=fields["force"][k],
            radius=float(fields["radius"][k]),
            edge=fields["edge"][k],
        )
        for k in range(int(fields["hands"].item()))
    )
    return CopyView(
        slot=int(fields["slot"].item()),
        time=float(fields["time"].item()),
        step=int(fields["step"].item()),
        displacement=fields["displacement"],
        direct=True,
        hands=hands,
        supplied=ledger["supplied"],
        lost=ledger["lost"],
        linked=ledger["linked"],
        energy=ledger["energy"],
        received=int(fields["received"].item()),
        cut=fields["cut"] if fields["cut"].size else None,
    )


def _ghosts(own: CopyView, fields: Mapping[str, Array], shown: dict[int, CopyView]) -> None:
    """Adds what a member knows of others that nobody knows better."""
    for slot in np.flatnonzero(fields["known"]).tolist():
        time = own.time - float(fields["ages"][slot])
        better = shown.get(slot)
        if better is None or (not better.direct and better.time < time):
            shown[slot] = CopyView(
                slot=slot,
                time=time,
                step=-1,
                displacement=fields["neighbours"][slot],
                direct=False,
                hands=_NO_HANDS,
            )
