"""A member's side of its boards: what it shows after every step, and what it is told before one."""

from dataclasses import replace
from threading import Thread
from typing import Any, Protocol, final

import numpy as np
import numpy.typing as npt

from cotouch.board import BoardReader, BoardWriter
from cotouch.errors import RecordingError
from cotouch.live import PathLaw
from cotouch.mechanics import Model
from cotouch.peer import Report
from cotouch.recording import both_clocks
from cotouch.session._boards import (
    BOOKS,
    RUNAWAY,
    BoardFolder,
    Wish,
    hands_of,
    laws_of,
    order_fields,
    size_of,
    view_fields,
    wish_of,
)
from cotouch.session._copy import Copy, Recorder
from cotouch.session._emulate import path_laws
from cotouch.session._file import SessionFile
from cotouch.session._replica import Replica
from cotouch.session._tape import Tape

Float = npt.NDArray[np.float64]

# Of larger bodies so many views are written in a second, of smaller ones one after every step.
_VIEWS = 125.0
_SMALL = 64


class Emulator(Protocol):
    """What can be told a law for the direction to a neighbour; `ImpairedTransport`."""

    def set(self, neighbour: int, law: PathLaw) -> None:
        """Changes it."""
        ...


class Shown(Protocol):
    """A hand that can be seen."""

    def show(self, fields: dict[str, npt.NDArray[Any]]) -> None:
        """Writes what it does into a board's fields; see `view_fields`."""
        ...


@final
class Window:
    """The boards of one member; a `copy.Recorder`, and the one that another may stand behind.

    Attributes:
        damping: share of the damping that is ordered; 1 if it may not be lowered here.
        delays: that are emulated now, [to, from], for what is said of paths, (users, users) [s].
    """

    def __init__(
        self,
        boards: BoardFolder,
        name: str,
        session: SessionFile,
        replica: Replica,
        *,
        key: bytes = b"",
        unsafe: bool = False,
        recorder: Recorder | None = None,
    ) -> None:
        """Opens the boards.

        Args:
            boards: where they are.
            name: of the member.
            session: that it takes part in.
            replica: the body as built here.
            key: its public key, for recordings.
            unsafe: whether damping below the rule may be ordered.
            recorder: that is told of everything, too.

        Raises:
            InputError: there are no orders, or the board cannot be made.
        """
        self._boards, self._name, self._session, self._replica = boards, name, session, replica
        self._key, self._unsafe, self._recorder = key, unsafe, recorder
        body, users = replica.body, replica.scenario.network.size
        path = boards.view(name)
        path.unlink(missing_ok=True)  # of one that was killed
        self._orders = BoardReader(boards.orders(name))
        self._view = BoardWriter(path, view_fields(body, users=users, hands=hands_of(replica.scenario)))
        self._fields = self._view.fields
        self._fields["seat"][()] = -1
        self._size = size_of(body)
        # Steps between two views.
        self._skip = 1
        self._count = 0  # of them so far
        self._moved = False  # whether a pointer was passed on since
        self._seen = {name: np.zeros(shape, kind) for name, (shape, kind) in order_fields(users).items()}
        self._seen["share"][()] = 1.0
        self.delays = laws_of(replica.scenario, emulate=session.options.emulate)[:, :, 0]
        self._applied = 0  # number of the laws in force
        self._damped = 0  # number of the order of damping that is followed
        self.damping = 1.0
        self._caught = False
        self._tape: Tape | None = None
        self._closing: tuple[Thread, int] | None = None
        self._copy: Copy | None = None
        self._ports: list[int] = []
        self._hand: Shown | None = None
        self._told = False  # whether the hand asks for wishes by itself
        self._order: npt.NDArray[np.int64] | None = None
        self._model: Model | None = None
        self._life = both_clocks()[1]

    # -- orders ------------------------------------------------------------------------------------------------------

    def wishes(self) -> Wish | None:
        """An order to the hand that was not given before."""
        orders = self._orders.read()
        if orders is None:
            return None
        before, self._seen = self._seen, orders
        if orders["hand"] == before["hand"]:
            return None
        wish = wish_of(orders)
        self._moved = self._moved or wish.pointer > 0
        return wish

    def holds(self, hand: Shown, seat: int, *, told: bool) -> None:
        """The copy has another hand.

        Args:
            hand: what it does is shown.
            seat: of the copy.
            told: whether it asks for wishes; a device's does not.
        """
        self._hand, self._told = hand, told
        self._fields["seat"][()] = seat
        small = self._replica.body.nodes <= _SMALL
        self._skip = 1 if small else max(1, int(1.0 / (self._session.period(seat) * _VIEWS)))

    def service(self, now: float, seat: int | None, emulator: Emulator | None) -> None:
        """Follows what is ordered besides; to be called now and then.

        Args:
            now: [s].
            seat: of the member, if it has one.
            emulator: takes laws.
        """
        if not self._told or self._copy is None or self._copy.peer is None:
            self.wishes()  # nobody else asks yet
        orders = self._seen
        if orders["impaired"] != self._applied and seat is not None:
            self._applied = int(orders["impaired"].item())
            self._impair(orders["laws"], seat, emulator)
        if orders["damped"] != self._damped:
            self._damped, self._caught = int(orders["damped"].item()), False
        self.damping = float(orders["share"].item()) if self._unsafe and not self._caught else 1.0
        if not 0.0 < self.damping <= 1.0:
            self.damping = 1.0
        self._record(int(orders["recording"].item()), now)

    def _impair(self, laws: Float, seat: int, emulator: Emulator | None) -> None:
        self.delays = laws[:, :, 0]
        if emulator is None:
            return
        given = path_laws(self._session.scenario, seat) if self._session.options.emulate else {}
        for to in range(laws.shape[0]):
            delay, jitter, loss, cut = laws[to, seat].tolist()
            if to != seat:
                law = given.get(to, PathLaw())
                emulator.set(to, replace(law, delay=delay, jitter=jitter, loss=loss, down=bool(cut)))

    # -- recordings --------------------------------------------------------------------------------------------------

    def _record(self, wanted: int, now: float) -> None:
        self._ended()
        fields = self._fields
        under_way = int(fields["recording"].item())
        if wanted == under_way or self._closing is not None:
            return
        if under_way:
            self._stop()
        elif wanted > int(fields["recorded"].item()) and self._copy is not None and self._copy.peer is not None:
            path = self._boards.recording(self._name, wanted, int(1e3 * self._life))
            try:
                self._tape = Tape(path, self._session, self._replica, name=self._name, key=self._key)
                self._tape.setup(self._copy, now)
                fields["recording"][()] = wanted
            except RecordingError:
                self._tape = None
                fields["recorded"][()] = wanted

    def _stop(self) -> None:
        """Ends a recording in a thread, because the disk may take its time."""
        fields = self._fields
        if self._tape is not None:
            closing = Thread(target=self._tape.close, name="cotouch end of recording")
            self._closing = (closing, int(fields["recording"].item()))
            self._tape = None
            closing.start()

    def _ended(self, *, wait: bool = False) -> None:
        """Says that a recording is whole, once it is."""
        if self._closing is not None:
            thread, number = self._closing
            if wait:
                thread.join()
            if not thread.is_alive():
                self._closing = None
                self._fields["recorded"][()] = number
                self._fields["recording"][()] = 0

    # -- what is told by the copy ------------------------------------------------------------------------------------

    def setup(self, copy: Copy, now: float) -> None:
        """Links, damping or the number of copies changed."""
        assert copy.peer is not None
        if self._model is not copy.peer.model:
            self._model = copy.peer.model
            self._order = None if self._model.order is None else np.argsort(self._model.order)
        self._copy, self._ports = copy, copy.ports
        for recorder in self._behind():
            recorder.setup(copy, now)

    def step(self, copy: Copy, report: Report, now: float, T: float) -> None:
        """A step was taken."""
        if copy.ports is not self._ports:  # the hand holds another node
            self.setup(copy, now)
        for recorder in self._behind():
            recorder.step(copy, report, now, T)
        self._count += 1
        # Whoever moves a pointer waits for the first view that knows of it.
        if self._count >= self._skip or self._moved:
            self._count, self._moved = 0, False
            self._show(copy, report, now, T)

    def event(self, kind: str, time: float, **fields: Any) -> None:
        """Something happened."""
        for recorder in self._behind():
            recorder.event(kind, time, **fields)

    def close(self) -> None:
        """Ends a recording, and removes the board that it writes."""
        self._stop()
        self._ended(wait=True)
        self._view.close()
        self._orders.close()

    def _behind(self) -> list[Recorder]:
        return [recorder for recorder in (self._recorder, self._tape) if recorder is not None]

    def _show(self, copy: Copy, report: Report, now: float, T: float) -> None:
        peer, fields, totals = copy.peer, self._fields, copy.totals
        assert peer is not None
        fields["time"][()] = now
        fields["step"][()] = peer.steps
        fields["T"][()] = T
        self._displaced(peer.state.position, fields["displacement"])
        fields["known"][...] = 0
        fields["links"][...] = np.nan
        for k, seat in enumerate(peer.neighbours):
            held = copy.neighbours[seat]
            fields["known"][seat] = 1
            self._displaced(held.link.assembly.state, fields["neighbours"][seat])
            age, books = float(report.age[k]), held.guard.books
            fields["ages"][seat] = _age(age, held.link.ages.worst_sum)
            force = (2.0 * max(0.0, books.potential) * held.strength) ** 0.5
            fields["links"][seat] = (age, totals.link_work.get(seat, 0.0), force, books.tank, books.state)
        if self._hand is not None:
            self._hand.show(fields)
        fields["books"][...] = [getattr(totals, name) for name in BOOKS]
        fields["damping"][()] = copy.damping_share
        if copy.damping_share < 1.0:
            self._catch(copy, now)
        self._view.publish()

    def _displaced(self, rows: Float, out: npt.NDArray[np.float32]) -> None:
        """As `Model.to_nodes`, into what is there."""
        model = self._model
        assert model is not None
        axes = out.shape[1]
        columns = rows[:, :1] if model.full else rows[:, :axes]
        if model.modes is not None:
            columns = model.modes @ columns
        elif self._order is not None:
            columns = columns[self._order]
        out[...] = columns.reshape(out.shape)

    def _catch(self, copy: Copy, now: float) -> None:
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
