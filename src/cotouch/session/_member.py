"""One member of a session, without its process: messages, samples and times in; messages, samples and motion out."""

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.errors import SessionError
from cotouch.live import ControlPlane, Entropy, Message
from cotouch.mechanics import Model
from cotouch.session import _keys
from cotouch.session._coordinator import Coordinator, acting, believed
from cotouch.session._copy import Copy, Recorder
from cotouch.session._file import MOST_USERS, SessionFile
from cotouch.session._hand import Hand
from cotouch.session._messages import Join, LinkStatus, Refused, Roster, Status, read, write
from cotouch.session._replica import Replica
from cotouch.session._ways import Ways

_ASK_EVERY = 0.5
_STATUS_EVERY = 0.5
# A name may still be held by what crashed a moment ago: so long it is asked for again [s].
_PATIENCE = 12.0
# A turn of `service` stands between two steps, so what it takes up is bounded; signatures and rosters count for more.
_EFFORT = 12
_HEAVY = {"roster": 6, _keys.TOPIC: 6, "status": 4}


@final
class Member:
    """Takes part: asks for a seat, follows the roster, moves its copy, decides when it is its turn to.

    Call `service` some fifty times a second, or after the next step while `pending`, and `step` at every step.

    Attributes:
        roster: the newest that is believed.
        copy: of the object; None before there is a seat.
        ended: whether the host ended the session.
    """

    def __init__(
        self,
        *,
        session: SessionFile,
        replica: Replica,
        control: ControlPlane,
        ways: Ways,
        host: bytes,
        name: str,
        version: str,
        hand: Callable[[int, Model], Hand],
        entropy: Entropy,
        secret: bytes = b"",
        coordinator: Coordinator | None = None,
        recorder: Recorder | None = None,
        pace: Callable[[], Mapping[str, float]] = dict,
        delays: Callable[[], npt.NDArray[np.float64]] | None = None,
    ) -> None:
        """Prepares to take part; nothing is said before the first `service`.

        Args:
            session: what was asked for.
            replica: the body as built here.
            control: the control plane.
            ways: the sample plane's transport.
            host: public key of the host.
            name: that others see.
            version: of this software.
            hand: makes what moves the copy, given the seat and the body's model.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
            coordinator: takes over when it is this member's turn to decide; by default one without a planner.
            recorder: is told of everything.
            pace: what the process knows of its steps, for the status: rate, longest, missed, stood, busy.
            delays: that are emulated now, [to, from], (users, users) [s]; None: as the session says.
        """
        self.roster = Roster()
        self.copy: Copy | None = None
        self.ended = False
        self._session = session
        self._replica = replica
        self._control = control
        self._ways = ways
        self._host = host
        self._wish = Join(name=name, fingerprint=replica.fingerprint, version=version)
        self._make_hand = hand
        self._entropy = entropy
        self._secret = secret
        self._coordinator = coordinator or Coordinator(session, fingerprint=replica.fingerprint)
        self._recorder = recorder
        self._pace = pace
        given = session.scenario.network.delay if session.options.emulate else np.zeros((MOST_USERS, MOST_USERS))
        self._delays = delays or (lambda: given)
        self._decides = False
        self._asked = -float("inf")
        self._first_asked: float | None = None
        self._refusal: str | None = None
        self._told = -float("inf")
        self._met = set[int]()
        self._waiting = deque[Message]()
        self._telling: Iterator[None] | None = None

    @property
    def pending(self) -> bool:
        """Whether `service` left something for its next turn."""
        return bool(self._waiting) or self._telling is not None

    @property
    def seat(self) -> int | None:
        """Index of this user; None before the roster has it."""
        entry = self.roster.of(self._control.identity.public)
        return None if entry is None else entry.seat

    def service(self, now: float) -> None:
        """Hears, decides, says; not everything at once, so that no turn keeps the next step waiting for long.

        Args:
            now: [s].

        Raises:
            SessionError: it may not take part; the message says why.
        """
        own = self._control.identity.public
        present = self._control.present() | {own}
        decider = acting(self.roster, self._host, present)
        waiting, effort = self._waiting, 0
        if not waiting:  # else what is said piles up where it is bounded
            waiting.extend(self._control.poll())
        while waiting and effort < _EFFORT:
            message = waiting.popleft()
            effort += _HEAVY.get(message.topic, 1)
            self._hear(message, decider, present, now)
        self._decide(decider == own, present, now)
        if self.seat is None:
            self._telling = None
            self._ask(now)
        elif self.copy is not None:
            since = now - self._told
            if self._telling is None and since >= _STATUS_EVERY and (not waiting or since >= 2.0 * _STATUS_EVERY):
                self._told = now
                self._telling = self._tell(self.copy, now)
            if self._telling is None:
                self.copy.tend(now)
            elif effort and since < _STATUS_EVERY:
                pass  # hearing took this turn
            elif next(self._telling, True):  # it yields nothing but None
                self._telling = None

    def listen(self, now: float) -> None:
        """Reads samples ahead of the step that will use them; may be called at any time between two steps.

        Args:
            now: [s].
        """
        if self.copy is not None:
            self.copy.listen(now)

    def step(self, now: float, T: float) -> bool:
        """Takes a step that ends now; False before there is something to step.

        Args:
            now: [s].
            T: length of the step [s].
        """
        return self.copy is not None and self.copy.step(now, T)

    def status(self, now: float) -> Status | None:
        """What this member says about itself; None before it has a seat.

        Args:
            now: [s].
        """
        if self.copy is None:
            return None
        return self._whole(self.copy.status(now))

    def _tell(self, copy: Copy, now: float) -> Iterator[None]:
        """Says what there is to say about this member, a piece in every turn: all at once would take half a step."""
        links: list[LinkStatus] = []
        for seat in list(copy.neighbours):
            if seat in copy.neighbours:
                links.append(copy.link_status(seat))
            yield
        if copy is not self.copy:
            return
        status = self._whole(copy.status(now, [link for link in links if link.seat in copy.neighbours]))
        yield
        self._control.send("status", write(status))

    def leave(self) -> None:
        """Says that it leaves."""
        self._control.send("leave", b"")

    def _whole(self, status: Status) -> Status:
        """With what the copy does not know."""
        return status.model_copy(update={**self._pace(), "paths": self._paths()})

    def _paths(self) -> list[tuple[int, float]]:
        """Times there and back to all others; pings do not go through what is emulated, so its delays are added."""
        own, delay = self.seat, self._delays()
        found: list[tuple[int, float]] = []
        for seat in self._met:
            path = self._ways.path(seat)
            if own is not None and path is not None:
                found.append((seat, path + float(delay[own, seat] + delay[seat, own])))
        return found

    def _hear(self, message: Message, decider: bytes | None, present: frozenset[bytes], now: float) -> None:
        match message.topic:
            case "roster":
                roster = read(Roster, message.body)
                if roster is not None and believed(roster, self.roster, message.sender, self._host, present):
                    self._follow(roster, now)
            case "refused":
                said = read(Refused, message.body)
                if said is not None and message.sender in (decider, self._host) and message.direct:
                    self._refusal = said.reason
            case "end":
                self.ended |= message.sender == self._host
            case topic if topic.startswith("link."):
                entry = self.roster.of(message.sender)
                if entry is not None and self.copy is not None:
                    self.copy.hear(entry.seat, topic, message.body, now)
            case _ if not self._ways.take(message):
                self._coordinator.hear(message, now)
            case _:
                pass

    def _decide(self, mine: bool, present: frozenset[bytes], now: float) -> None:
        if mine and not self._decides:
            self._coordinator.adopt(self.roster, now)
        self._decides = mine
        if not mine:
            return
        for topic, body, to in self._coordinator.tick(now, present):
            self._control.send(topic, body, to=to)
        if self._coordinator.roster.epoch > self.roster.epoch:
            self._follow(self._coordinator.roster, now)

    def _ask(self, now: float) -> None:
        if self._first_asked is None:
            self._first_asked = now
        if self._refusal is not None and now - self._first_asked > _PATIENCE:
            raise SessionError(f"the host does not let {self._wish.name} in: {self._refusal}")
        if now - self._asked >= _ASK_EVERY:
            self._asked = now
            body = write(self._wish)
            self._control.send("join", body)
            if self._decides:
                self._coordinator.hear(Message(self._control.identity.public, "join", body, direct=True), now)

    def _follow(self, roster: Roster, now: float) -> None:
        self.roster = roster
        self._coordinator.adopt(roster, now)
        seat = self.seat
        if seat is None:
            if self.copy is not None:  # it was cut off for so long that it was taken for gone: it asks anew
                self.copy.alone(now)
                self._meet({})
                self._first_asked, self._refusal = None, None
            return
        if self.copy is not None and self.copy.seat != seat:
            self.copy.alone(now)
            self.copy = None
        if self.copy is None:
            self.copy = Copy(
                session=self._session,
                replica=self._replica,
                seat=seat,
                hand=self._make_hand,
                control=self._control,
                ways=self._ways,
                entropy=self._entropy,
                secret=self._secret,
                recorder=self._recorder,
            )
        self.copy.follow(roster, now)
        self._meet({entry.seat: bytes.fromhex(entry.key) for entry in roster.members if entry.seat != seat})

    def _meet(self, others: Mapping[int, bytes]) -> None:
        """Looks for ways to all others, linked or not: how far they are decides who should be linked."""
        for gone in self._met - others.keys():
            self._ways.transport.forget(gone)
        for seat, key in others.items():
            self._ways.introduce(seat, key)
        self._met = set(others)
