"""One member of a session, without its process: messages, samples and times in; messages, samples and motion out."""

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.control import ControlPlane, SignedMessage
from cotouch.errors import SessionError
from cotouch.mechanics import Model
from cotouch.members import _keys
from cotouch.members._asking import Asking
from cotouch.members._coordinator import Coordinator
from cotouch.members._file import MOST_USERS, SessionFile
from cotouch.members._hand import Hand
from cotouch.members._law_check import signature_of
from cotouch.members._messages import (
    Decided,
    Join,
    LinkStatus,
    Refused,
    Roster,
    Status,
    plain,
    read_message,
    write_message,
)
from cotouch.members._paths import MetPaths, Paths
from cotouch.members._replica import Replica
from cotouch.members._shared_cuts import TOPIC as CUTS
from cotouch.members._shared_model import SharedModel
from cotouch.members._step_recorder import StepRecorder
from cotouch.members._succession import Belief
from cotouch.samples import Entropy, Transport
from cotouch.traversal import Place

_STATUS_EVERY = 0.5
# Whoever decides and says another roster than the one believed is told that one, this often [s].
_TELL_EVERY = 1.0
# What members say they work with counts for so long [s].
_VOTE = 2.0
# A turn of `service` stands between two steps, so what it takes up is bounded; signatures and rosters count for more.
_EFFORT = 12
_HEAVY = {"roster": 6, _keys.TOPIC: 6, CUTS: 4, "status": 4}


@final
class Member:
    """Takes part in a session: asks for a slot, follows the roster, moves its copy, and decides when it is its turn.

    Call `service` some fifty times a second, or after the next step while `pending`, and `step` at every step.

    Attributes:
        complaints: why rosters were not believed, the last ones.
        copy: of the object; None before there is a slot.
        ended: whether the host ended the session.
    """

    def __init__(
        self,
        *,
        session: SessionFile,
        replica: SharedModel,
        control: ControlPlane,
        paths: Paths,
        transport: Transport,
        host: bytes,
        name: str,
        version: str,
        hand: Callable[[int, Model], Hand],
        entropy: Entropy,
        secret: bytes = b"",
        coordinator: Coordinator | None = None,
        recorder: StepRecorder | None = None,
        pace: Callable[[], Mapping[str, float]] = dict,
        delays: Callable[[], Float] | None = None,
        device: Callable[[], str] = str,
        place: Callable[[], Place | None] | None = None,
    ) -> None:
        """Prepares to take part; nothing is said before the first `service`.

        Args:
            session: what was asked for.
            replica: the body as built here.
            control: the control plane.
            paths: finds the ways of samples.
            transport: carries them.
            host: public key of the host.
            name: that others see.
            version: of this software.
            hand: makes what moves the copy, given the slot and the body's model.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
            coordinator: takes over when it is this member's turn to decide; by default one without a planner.
            recorder: is told of everything.
            pace: what the process knows of its steps, for the status: rate, longest_period, missed, stood, busy.
            delays: that are emulated now, [to, from], (users, users) [s]; None: as the session says.
            device: what others should see of the device in the user's hand, in a line; empty for nothing.
            place: what shows the host where this member is, once it was told; None: nobody asks.
        """
        self.complaints = deque[str](maxlen=16)
        start = entropy(8).hex()
        own = control.identity.public
        self._belief = Belief(host, network=session.scenario.network, own=own, start=start)
        self.replica: Replica | None = None
        self.ended = False
        self._session, self._replica, self._control = session, replica, control
        self._paths, self._transport = paths, transport
        self._host = host
        law = signature_of(session.scenario)
        request = Join(name=name, fingerprint=replica.fingerprint, version=version, law=law, start=start)
        self._asking = Asking(request, place)
        self._make_hand = hand
        self._entropy, self._secret = entropy, secret
        self._coordinator = coordinator or Coordinator(session, fingerprint=replica.fingerprint)
        self._recorder, self._pace, self._device = recorder, pace, device
        given = session.scenario.network.delay if session.options.emulate else np.zeros((MOST_USERS, MOST_USERS))
        self._delays = delays or (lambda: given)
        self._decides = False
        self._theirs: tuple[bytes, str] | None = None  # what was said last by one who decides, and by whom
        self._votes: dict[bytes, tuple[float, str | None]] = {}
        self._departed = set[bytes]()
        self._left_out = False
        self._digest = ("", "")
        self._banned = frozenset[bytes]()
        self._announced_to_them = -float("inf")
        self._announced = -float("inf")
        self._met = MetPaths(paths, transport)
        self._waiting = deque[SignedMessage]()
        self._telling: Iterator[None] | None = None

    @property
    def waits_because(self) -> str | None:
        """Why it was not let in so far; None: it was, or nobody said anything."""
        return self._asking.refusal if self.slot is None else None

    @property
    def pending(self) -> bool:
        """Whether `service` left something for its next turn."""
        return bool(self._waiting) or self._telling is not None

    @property
    def roster(self) -> Roster:
        """The newest that is believed."""
        return self._belief.roster

    @property
    def slot(self) -> int | None:
        """Index of this user; None before the roster has it."""
        entry = self.roster.of(self._control.identity.public)
        return None if entry is None or entry.start != self._asking.request.start else entry.slot

    def service(self, now: float) -> None:
        """Hears, decides, says; not everything at once, so that no turn keeps the next step waiting for long.

        Args:
            now: [s].

        Raises:
            SessionError: it may not take part; the message says why.
        """
        own = self._control.identity.public
        present = (self._control.present() - self._departed) | {own}
        decider = self._belief.acting(present)
        waiting, effort = self._waiting, 0
        if not waiting:  # else what is said piles up where it is bounded
            waiting.extend(self._control.poll())
        while waiting and effort < _EFFORT:
            message = waiting.popleft()
            effort += _HEAVY.get(message.topic, 1)
            self._receive(message, decider, present, now)
        self._reconcile(decider, present, now)
        self._decide(decider == own and self._belief.entitled(self._control.identity), present, now)
        if self.slot is None or self._left_out:
            self._ask(now)
        if self.slot is None:
            self._telling = None
        elif self.replica is not None:
            since = now - self._announced
            if self._telling is None and since >= _STATUS_EVERY and (not waiting or since >= 2.0 * _STATUS_EVERY):
                self._announced = now
                self._telling = self._tell(self.replica, now)
            if self._telling is None:
                self.replica.service(now)
            elif effort and since < _STATUS_EVERY:
                pass  # hearing took this turn
            elif next(self._telling, True):  # it yields nothing but None
                self._telling = None

    def listen(self, now: float) -> None:
        """Reads samples ahead of the step that will use them; may be called at any time between two steps.

        Args:
            now: [s].
        """
        if self.replica is not None:
            self.replica.listen(now)

    def step(self, now: float, T: float) -> bool:
        """Takes a step that ends now; False before there is something to step.

        Args:
            now: [s].
            T: length of the step [s].
        """
        if self.replica is None:
            return False
        self.replica.step(now, T)
        return True

    def status(self, now: float) -> Status | None:
        """What this member says about itself; None before it has a slot.

        Args:
            now: [s].
        """
        if self.replica is None:
            return None
        return self._whole(self.replica.status(now))

    def _tell(self, copy: Replica, now: float) -> Iterator[None]:
        """Says what there is to say about this member, a piece in every turn: all at once would take half a step."""
        links: list[LinkStatus] = []
        for slot in list(copy.neighbours):
            if slot in copy.neighbours:
                links.append(copy.link_status(slot))
            yield
        if copy is not self.replica:
            return
        status = self._whole(copy.status(now, [link for link in links if link.slot in copy.neighbours]))
        yield
        self._control.send("status", write_message(status))

    def leave(self) -> None:
        """Says that it leaves."""
        self._control.send("leave", b"")

    def _whole(self, status: Status) -> Status:
        """With what the copy does not know."""
        known = dict(self._pace())
        if self.replica is not None:
            known["stood"] = known.get("stood", 0.0) + self.replica.stood
        met = self._met.round_trips(self.slot, self._delays())
        said = {"round_trips": met, "device": self._device(), "roster": self._working_with()}
        return status.model_copy(update={**known, **said, **self._recording()})

    def _recording(self) -> dict[str, str]:
        recorder = self._recorder
        if recorder is None:
            return {}
        if recorder.failure is not None:
            return {"recording": "failed", "recording_failure": plain(recorder.failure)}
        return {"recording": "on" if recorder.begun else "off"}

    def _receive(self, message: SignedMessage, decider: bytes | None, present: frozenset[bytes], now: float) -> None:
        match message.topic:
            case "roster":
                self._receive_roster(message, decider, present, now)
            case "refused":
                said = read_message(Refused, message.body)
                if said is not None and message.sender in (decider, self._host) and message.direct:
                    self._asking.refuse(said)
            case "end":
                self.ended |= message.sender == self._host
            case topic if topic.startswith("link."):
                entry = self.roster.of(message.sender)
                if entry is not None and self.replica is not None:
                    self.replica.receive(entry.slot, topic, message.body, now)
            case _ if self._paths.take(message):
                pass
            case _:
                self._note(message, now)
                if self._decides:
                    self._coordinator.receive(message, now)
                else:
                    self._coordinator.learn(message)

    def _note(self, message: SignedMessage, now: float) -> None:
        """What others say of themselves that decides whom to believe."""
        entry = self.roster.of(message.sender)
        if message.topic == "leave" and entry is not None:
            self._departed.add(message.sender)
        elif message.topic == "join":
            self._departed.discard(message.sender)
        elif message.topic == "status" and entry is not None and (status := read_message(Status, message.body)):
            self._votes[message.sender] = (now, status.roster)

    def _receive_roster(
        self, message: SignedMessage, decider: bytes | None, present: frozenset[bytes], now: float
    ) -> None:
        decided = read_message(Decided, message.body)
        if decided is None:
            return
        if message.sender == decider:
            self._theirs = (message.sender, decided.chain[-1].signature)
        before = self._belief.complaint
        if self._belief.receive(decided, message.sender, present):
            self._follow(now)
        elif message.sender == decider and self._belief.chain and decided.chain[-1] != self._belief.chain[-1]:
            # Whoever decides took this member for gone; the others may see that it is not.
            said = decided.chain[-1].roster.of(self._control.identity.public)
            self._left_out = self.slot is not None and (said is None or said.start != self._asking.request.start)
        if self._belief.complaint is not None and self._belief.complaint != before:
            self.complaints.append(self._belief.complaint)
            if self._recorder is not None:
                self._recorder.event("roster", now, reason=self._belief.complaint)
        announced, self._belief.announced = self._belief.announced, None
        if announced is not None and self._decides:
            self._coordinator.take_up(announced[-1].roster, present, now)

    def _reconcile(self, decider: bytes | None, present: frozenset[bytes], now: float) -> None:
        """Gives way where most work with another roster, and tells whoever decides what it does not know."""
        votes = {key: digest for key, (time, digest) in self._votes.items() if now - time <= _VOTE}
        if self._belief.settle(votes, present):
            self._follow(now)
        chain = self._belief.chain
        if decider in (None, self._control.identity.public) or not chain or now - self._announced_to_them < _TELL_EVERY:
            return
        if self._theirs != (decider, chain[-1].signature):  # also one who has come, or come back, and said nothing yet
            self._announced_to_them = now
            self._control.send("roster", write_message(Decided(chain=list(chain))), to=decider)

    def _working_with(self) -> str | None:
        """Digest of the roster; worked out once for each."""
        if not self._belief.chain:
            return None
        about = self._belief.chain[-1].signature
        if self._digest[0] != about:
            self._digest = (about, self.roster.digest)
        return self._digest[1]

    def _decide(self, mine: bool, present: frozenset[bytes], now: float) -> None:
        if mine and not self._decides:
            # Whom the host let in keeps its slot while the host is gone.
            chain = self._belief.chain
            self._coordinator.admission.mine = {e.key: e.slot for one in chain[:1] for e in one.roster.members}
            self._coordinator.adopt(self.roster, now)
        self._decides = mine
        if not mine:
            return
        for topic, body, to in self._coordinator.tick(now, present):
            self._control.send(topic, body, to=to)
        if self._coordinator.roster != self.roster:
            self._belief.decide(self._control.identity, self._coordinator.roster)
            self._follow(now)
        if self._coordinator.due(now):
            self._control.send("roster", write_message(Decided(chain=list(self._belief.chain))))

    def _ask(self, now: float) -> None:
        body = self._asking.due(now, inside=self.slot is not None)
        if body is None:
            return
        self._control.send("join", body)
        if self._decides:
            self._coordinator.receive(SignedMessage(self._control.identity.public, "join", body, direct=True), now)

    def _follow(self, now: float) -> None:
        roster = self.roster
        self._left_out = False
        keys = {bytes.fromhex(entry.key) for entry in roster.members}
        self._departed &= keys
        self._votes = {key: vote for key, vote in self._votes.items() if key in keys}
        if self._coordinator.roster != roster:
            self._coordinator.adopt(roster, now)
        own = self._control.identity.public.hex()
        if own in roster.banned:
            raise SessionError(f"the host expelled {self._asking.request.name} from this session")
        banned = frozenset(map(bytes.fromhex, roster.banned))
        if banned != self._banned:
            self._banned = banned
            self._control.shun(banned)
            for neighbour in self.replica.neighbours.values() if self.replica is not None else ():
                neighbour.keys.renew()
        slot = self.slot
        if slot is None:
            if self.replica is not None:  # it was cut off for so long that it was taken for gone: it asks anew
                self.replica.alone(now)
                self._met.meet({})
                self._asking.begin()
            return
        if self.replica is not None and self.replica.slot != slot:
            self.replica.alone(now)
            self.replica = None
        if self.replica is None:
            self.replica = Replica(
                session=self._session,
                replica=self._replica,
                slot=slot,
                hand=self._make_hand,
                control=self._control,
                paths=self._paths,
                transport=self._transport,
                entropy=self._entropy,
                secret=self._secret,
                recorder=self._recorder,
            )
        self.replica.follow(roster, now)
        self._met.meet({entry.slot: bytes.fromhex(entry.key) for entry in roster.members if entry.slot != slot})
