"""A member's side of its mailboxes: what it shows after every step, and what it is told before one."""

from dataclasses import replace
from typing import Protocol, final

import numpy as np

from cotouch.arrays import Array, Float, Long, Single
from cotouch.mailbox import MailboxReader, MailboxWriter
from cotouch.mechanics import Model
from cotouch.members import Replica, SessionFile, SessionRecorder, SharedModel, StepRecorder, path_laws
from cotouch.observers._mailboxes import (
    LEDGER_COLUMNS,
    RUNAWAY,
    HandCommand,
    MailboxFolder,
    hand_command_of,
    hands_of,
    laws_of,
    order_fields,
    size_of,
    view_fields,
)
from cotouch.observers._takes import Takes
from cotouch.peer import LinkState, StepReport
from cotouch.recording import both_clocks
from cotouch.samples import PathLaw

# Of larger bodies so many views are written in a second, of smaller ones one after every step.
_VIEWS = 125.0
_SMALL = 64


class Emulator(Protocol):
    """What can be told a law for the direction to a neighbour; `ImpairedTransport`."""

    def set(self, neighbour: int, law: PathLaw) -> None:
        """Changes it.

        Args:
            neighbour: slot of the neighbour.
            law: delay, jitter and loss of the path.
        """
        ...


class VisibleHand(Protocol):
    """A hand that can be seen."""

    def show(self, fields: dict[str, Array]) -> None:
        """Writes what it does into a mailbox's fields; see `view_fields`."""
        ...


@final
class TelemetryPublisher:
    """The mailboxes of one member; a `copy.Recorder`, behind which another may stand.

    Attributes:
        damping: share of the damping that is ordered; 1 if it may not be lowered here.
        delays: that are emulated now, [to, from], for what is said of paths, (users, users) [s].
    """

    def __init__(
        self,
        mailboxes: MailboxFolder,
        name: str,
        session: SessionFile,
        replica: SharedModel,
        *,
        unsafe: bool = False,
        recorder: StepRecorder | None = None,
    ) -> None:
        """Opens the mailboxes.

        Args:
            mailboxes: where they are.
            name: of the member.
            session: that it takes part in.
            replica: the body as built here.
            unsafe: whether damping below the rule may be ordered.
            recorder: that is told of everything, too.

        Raises:
            InputError: there are no orders, or the mailbox cannot be made.
        """
        self._mailboxes, self._name, self._session, self._replica = mailboxes, name, session, replica
        self._unsafe, self._recorder = unsafe, recorder
        body, users = replica.body, replica.scenario.network.size
        path = mailboxes.view(name)
        path.unlink(missing_ok=True)  # of one that was killed
        self._orders = MailboxReader(mailboxes.orders(name))
        self._view = MailboxWriter(path, view_fields(body, users=users, hands=hands_of(replica.scenario)))
        self._fields = self._view.fields
        self._fields["slot"][()] = -1
        self._size = size_of(body)
        # Steps between two views.
        self._skip = 1
        self._count = 0  # of them so far
        self._moved = False  # whether a pointer was passed on since
        self._seen = {name: np.zeros(shape, kind) for name, (shape, kind) in order_fields(users).items()}
        self._seen["fraction"][()] = 1.0
        self.delays = laws_of(replica.scenario, emulate=session.options.emulate)[:, :, 0]
        self._applied = 0  # number of the laws in force
        self._damped = 0  # number of the order of damping that is followed
        self.damping = 1.0
        self._caught = False
        self._takes = Takes(self._fields, self._view.publish, self._session_recorder)
        self._copy: Replica | None = None
        self._ports: list[int] = []
        self._hand: VisibleHand | None = None
        self._commanded = False  # whether the hand asks for requests by itself
        self._order: Long | None = None
        self._model: Model | None = None
        self._modes: Single | None = None
        self._life = both_clocks()[1]

    # -- orders ------------------------------------------------------------------------------------------------------

    def requests(self) -> HandCommand | None:
        """An order to the hand that was not given before."""
        orders = self._orders.read()
        if orders is None:
            return None
        before, self._seen = self._seen, orders
        if orders["hand"] == before["hand"]:
            return None
        request = hand_command_of(orders)
        self._moved = self._moved or request.pointer > 0
        return request

    def holds(self, hand: VisibleHand, slot: int, *, commanded: bool) -> None:
        """The copy has another hand.

        Args:
            hand: what it does is shown.
            slot: of the copy.
            commanded: whether it asks for requests; a device's does not.
        """
        self._hand, self._commanded = hand, commanded
        self._fields["slot"][()] = slot
        small = self._replica.body.nodes <= _SMALL
        self._skip = 1 if small else max(1, int(1.0 / (self._session.period(slot) * _VIEWS)))

    def service(self, now: float, slot: int | None, emulator: Emulator | None) -> None:
        """Follows what is ordered besides; to be called now and then.

        Args:
            now: [s].
            slot: of the member, if it has one.
            emulator: takes laws.
        """
        if not self._commanded or self._copy is None or self._copy.peer is None:
            self.requests()  # nobody else asks yet
        orders = self._seen
        if orders["impaired"] != self._applied and slot is not None:
            self._applied = int(orders["impaired"].item())
            self._impair(orders["laws"], slot, emulator)
        if orders["damped"] != self._damped:
            self._damped, self._caught = int(orders["damped"].item()), False
        held = self._unsafe and not self._caught and now <= float(orders["lease"].item())
        self.damping = float(orders["fraction"].item()) if held else 1.0
        if not 0.0 < self.damping <= 1.0:
            self.damping = 1.0
        if self._orders.number:
            number, on = int(orders["recording"].item()), bool(orders["recording_on"].item())
            self._takes.follow(number, self._copy, now, on=on)

    def _impair(self, laws: Float, slot: int, emulator: Emulator | None) -> None:
        self.delays = laws[:, :, 0]
        if emulator is None:
            return
        given = path_laws(self._session.scenario, slot) if self._session.options.emulate else {}
        for to in range(laws.shape[0]):
            delay, jitter, loss, cut = laws[to, slot].tolist()
            if to != slot:
                law = given.get(to, PathLaw())
                emulator.set(to, replace(law, delay=delay, jitter=jitter, loss=loss, down=bool(cut)))

    def _session_recorder(self, number: int) -> SessionRecorder:
        path = self._mailboxes.recording(self._name, number, int(1e3 * self._life))
        return SessionRecorder(path, self._session, self._replica, name=self._name)

    # -- what is told by the copy ------------------------------------------------------------------------------------

    def setup(self, copy: Replica, now: float) -> None:
        """Links, damping or the number of copies changed.

        Args:
            copy: the replica.
            now: time [s].
        """
        assert copy.peer is not None
        if self._model is not copy.peer.model:
            self._model = copy.peer.model
            self._order = None if self._model.order is None else np.argsort(self._model.order)
            modes = self._model.modes
            self._modes = None if modes is None else np.ascontiguousarray(modes, dtype=np.float32)
        self._copy, self._ports = copy, copy.ports
        for recorder in self._behind():
            recorder.setup(copy, now)

    def step(self, copy: Replica, report: StepReport, now: float, T: float) -> None:
        """A step was taken.

        Args:
            copy: the replica.
            report: of the step.
            now: time [s].
            T: length of the step [s].
        """
        if copy.ports is not self._ports:  # the hand holds another node
            self.setup(copy, now)
        for recorder in self._behind():
            recorder.step(copy, report, now, T)
        self._count += 1
        # Whoever moves a pointer waits for the first view that knows of it.
        if self._count >= self._skip or self._moved:
            self._count, self._moved = 0, False
            self._show(copy, report, now, T)

    def event(self, kind: str, time: float, **fields: object) -> None:
        """Something happened.

        Args:
            kind: of message or event.
            time: when [s].
            fields: what else is to be known of it.
        """
        for recorder in self._behind():
            recorder.event(kind, time, **fields)

    @property
    def begun(self) -> bool:
        """Whether anything is recorded."""
        return any(recorder.begun for recorder in self._behind())

    @property
    def failure(self) -> str | None:
        """Why it is not, or not everything, any more."""
        return next((recorder.failure for recorder in self._behind() if recorder.failure is not None), None)

    def close(self) -> None:
        """Ends a recording, and removes the mailbox that it writes."""
        self._takes.end(wait=True)
        self._view.close()
        self._orders.close()

    def _behind(self) -> list[StepRecorder]:
        return [recorder for recorder in (self._recorder, self._takes.session_recorder) if recorder is not None]

    def _show(self, copy: Replica, report: StepReport, now: float, T: float) -> None:
        peer, fields, totals = copy.peer, self._fields, copy.totals
        assert peer is not None
        fields["time"][()] = now
        fields["step"][()] = peer.steps
        fields["period"][()] = T
        shown = [(peer.state.position, fields["displacement"])]
        if peer.cuts is not None:
            fields["cut"][...] = peer.cuts.by
        fields["known"][...] = 0
        fields["links"][...] = np.nan
        for k, slot in enumerate(peer.neighbours):
            held = copy.neighbours[slot]
            fields["known"][slot] = 1
            shown.append((held.link.assembly.state, fields["neighbours"][slot]))
            age, ledger = float(report.age[k]), held.ledger
            tank, state = (0.0, LinkState.COUPLED) if ledger is None else (ledger.tank, ledger.state)
            fields["ages"][slot] = _age(age, held.link.ages.worst_sum)
            fields["links"][slot] = (age, totals.link_work.get(slot, 0.0), held.force, tank, state)
        self._displaced(shown)
        if self._hand is not None:
            self._hand.show(fields)
        fields["ledger"][...] = [getattr(totals, name) for name in LEDGER_COLUMNS]
        fields["damping"][()] = copy.damping_fraction
        if copy.damping_fraction < 1.0:
            self._catch(copy, now)
        self._view.publish()

    def _displaced(self, shown: list[tuple[Float, Single]]) -> None:
        """As `Model.to_nodes`, of rows of several copies into what is there for each."""
        model, axes = self._model, shown[0][1].shape[1]
        assert model is not None
        columns = [rows[:, :1] if model.full else rows[:, :axes] for rows, _ in shown]
        if self._modes is not None:  # all at once, and in single precision: the modes are large, and are read once
            columns = list((self._modes @ np.concatenate(columns, axis=1, dtype=np.float32)).T)
        elif self._order is not None:
            columns = [values[self._order] for values in columns]
        for values, (_, out) in zip(columns, shown, strict=True):
            out[...] = values.reshape(out.shape)

    def _catch(self, copy: Replica, now: float) -> None:
        """Gives a copy that runs away its damping back."""
        moved = self._fields["displacement"]
        if not float(np.abs(moved).max()) < RUNAWAY * self._size:
            self._caught, self.damping = True, 1.0
            self._fields["caught"][()] = self._damped
            copy.give_damping(1.0, now)


def _age(age: float, both: float | None) -> float:
    """Of a state: as it is between processes with one clock; else half of what both ends know [s]."""
    plausible = 0.0 <= age <= (10.0 if both is None else both)
    return age if plausible else 0.5 * (both or 0.0)
