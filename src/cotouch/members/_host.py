"""The host: hands out the session's file, and decides who takes part as long as it is there."""

from collections.abc import Callable
from typing import final

from cotouch.control import ControlPlane, SignedMessage
from cotouch.errors import OutputError
from cotouch.members._admission import Admission
from cotouch.members._coordinator import Coordinator, Planner
from cotouch.members._file import SessionFile
from cotouch.members._messages import Decided, Decision, Roster, read_message, write_message
from cotouch.members._succession import Belief, Chain, order_of
from cotouch.members._watch import HANDED_ON, SessionEvent, SessionWatch

# How often who only watches is told what members say of themselves [s].
_HAND_ON = 0.5
# A host that was started again listens for so long to what was decided without it [s].
_LISTEN = 3.0
# Of those whom it had not let in itself, so many tell it what was decided.
_MOST_TOLD = 32
# What it signed before it ended may be beyond what it kept, by less than this.
_STRIDE = 1 << 10


@final
class Host:
    """Keeps a session open without taking a slot in it.

    Attributes:
        coordinator: decides who takes part, and can be asked to choose links, expel and release.
        watch: what is seen of the session.
    """

    def __init__(
        self,
        session: SessionFile,
        control: ControlPlane,
        *,
        planner: Planner | None = None,
        admission: Admission | None = None,
        kept: Decision | None = None,
        keep: Callable[[Decision], None] | None = None,
    ) -> None:
        """Opens the session.

        Args:
            session: what was asked for.
            control: the control plane; this member's key is the one that the invitation names.
            planner: chooses the links, for links = "plan".
            admission: says who may come in, once it has the body's fingerprint.
            kept: the last roster of this host before it ended; members may have gone on since.
            keep: keeps a roster before it is said, or raises OutputError.
        """
        self._control = control
        self._handed_on = -float("inf")
        self.coordinator = Coordinator(
            session, planner=planner, admission=admission or Admission(session, fingerprint=None)
        )
        self._belief = Belief(control.identity.public, network=session.scenario.network)
        self._keep = keep
        self._kept, self._listens_until = kept, float("inf") if kept is not None else -float("inf")
        self._resumed = False
        self._announced: dict[bytes, Chain] = {}
        self.watch = SessionWatch(control, host=control.identity.public)
        control.offer(session.content)
        for data in session.files.values():
            control.offer(data)

    def service(self, now: float) -> None:
        """Hears, decides, says.

        Args:
            now: [s].
        """
        own = self._control.identity.public
        present = self._control.present() | {own}
        if self._kept is not None:
            self._resume(self._kept, now)
        listening = now < self._listens_until
        for message in self._control.poll():
            if message.topic == "roster":  # while the host is there, nobody else decides
                self._receive_roster(message, now)
                continue
            if not listening or message.topic == "status":
                self.coordinator.receive(message, now)
            self.watch.receive(message, present, now)
        if not listening:
            self._decide(present, now)
        self.watch.follow(self.coordinator.roster, now)
        if now - self._handed_on >= _HAND_ON:
            self._handed_on = now
            self._hand_on(present - {own}, now)

    def _decide(self, present: frozenset[bytes], now: float) -> None:
        self._take_up(present, now)
        for topic, body, to in self.coordinator.tick(now, present):
            self._control.send(topic, body, to=to)
        roster = self.coordinator.roster
        if not self._belief.chain or roster != self._belief.roster:
            banned = self._belief.roster.banned
            self._belief.decide(self._control.identity, roster)
            if roster.banned != banned:
                self._control.shun(frozenset(map(bytes.fromhex, roster.banned)))
            if self._keep is not None:
                try:
                    self._keep(self._belief.chain[0])
                except OutputError as error:
                    self.watch.events.append(SessionEvent(now, f"ALARM: the roster cannot be saved: {error}"))
        if self.coordinator.due(now):
            self._control.send("roster", write_message(Decided(chain=list(self._belief.chain))))

    def _resume(self, kept: Decision, now: float) -> None:
        """Begins with what this host decided last, and listens."""
        if self._listens_until == float("inf"):
            self._listens_until = now + _LISTEN
            self._belief.chain = (kept,)
            self._control.shun(frozenset(map(bytes.fromhex, kept.roster.banned)))
            self.coordinator.adopt(kept.roster, now)
        elif now >= self._listens_until:
            self._kept, self._resumed = None, True
            self.coordinator.renew(_STRIDE)

    def _receive_roster(self, message: SignedMessage, now: float) -> None:
        """What was decided while the host was gone: its own newer word, or by whom it had let in."""
        decided = read_message(Decided, message.body)
        if decided is None:
            return
        if self._belief.receive(decided, message.sender, frozenset({self._control.identity.public})):
            self.coordinator.adopt(self._belief.roster, now)  # older files were kept than what it had said
            self.coordinator.renew(_STRIDE)
        announced, self._belief.announced = self._belief.announced, None
        if announced is not None and (
            self._belief.chain[0].roster.of(message.sender) or len(self._announced) < _MOST_TOLD
        ):
            self._announced[message.sender] = announced

    def _take_up(self, present: frozenset[bytes], now: float) -> None:
        """Takes up who came meanwhile: first as most of those say whom the host had let in, then by their slots."""
        if not self._announced or not self._belief.chain:
            return
        order = [key.hex() for key in order_of(self._belief.chain)]
        votes = self.watch.votes(now)

        def rank(chain: Chain) -> tuple[bool, int]:
            digest = chain[-1].roster.digest
            count = sum(votes.get(bytes.fromhex(key)) == digest for key in order)
            signer = chain[-1].signer
            return 2 * count <= len(order), order.index(signer) if signer in order else len(order)

        for chain in sorted(self._announced.values(), key=rank):
            if chain[0].signature == self._belief.chain[0].signature:
                self.coordinator.take_up(chain[-1].roster, present, now, instead=self._resumed)
        self._announced.clear()
        self._resumed = False

    def _hand_on(self, others: frozenset[bytes], now: float) -> None:
        """Tells who only watches what members say of themselves: members behind NATs see nobody but the host.

        That a member sees a watcher cannot be known here, so it is told to all, and taken of those unseen.
        """
        watchers = others - {bytes.fromhex(entry.key) for entry in self.roster.members}
        if not watchers:
            return
        said = [seen.status for seen in self.watch.members.values() if not seen.stale(now)]
        for body in [write_message(status) for status in said if status is not None]:
            for watcher in watchers:
                self._control.send(HANDED_ON, body, to=watcher)

    @property
    def roster(self) -> Roster:
        """Who takes part, and who is linked to whom."""
        return self.coordinator.roster

    def end(self) -> None:
        """Ends the session for everybody."""
        self.watch.ended = True
        self._control.send("end", b"")
