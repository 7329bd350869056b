"""One member's copy of the object, and all that joins it to its neighbours."""

from collections.abc import Callable
from typing import Any, Protocol, final

import numpy as np
import numpy.typing as npt

from cotouch.live import ControlPlane, Entropy, IndexedAssembly, SamplePlane
from cotouch.mechanics import Model
from cotouch.peer import COUPLED, Peer, Report
from cotouch.scenario import per_user
from cotouch.session import _keys
from cotouch.session._file import SessionFile
from cotouch.session._hand import AttachedHand, Hand
from cotouch.session._messages import Entry, LinkStatus, Roster, Status
from cotouch.session._neighbour import STATES, Neighbour
from cotouch.session._replica import Replica
from cotouch.session._totals import Totals
from cotouch.session._ways import Ways

Float = npt.NDArray[np.float64]

BUDGET = "link.budget"
# Where nobody is heard for so long after coming, nobody moves yet, and the copy starts at rest [s].
_QUIET = 1.5
# A peer that waits for its neighbours says its last sample again after this [s].
_TELL_AGAIN = 0.1
# Links that are tended at once, between two steps.
_AT_ONCE = 8


class Recorder(Protocol):
    """Whatever keeps what a copy does."""

    def setup(self, copy: "Copy", now: float) -> None:
        """Links, damping or the number of copies changed."""
        ...

    def step(self, copy: "Copy", report: Report, now: float, T: float) -> None:
        """A step was taken."""
        ...

    def event(self, kind: str, time: float, **fields: Any) -> None:
        """Something happened."""
        ...


@final
class Copy:
    """Follows the roster with its links, and moves.

    Attributes:
        seat: index of this user.
        peer: None until the copy knows where to start.
        neighbours: by seat.
        totals: what was booked since the start.
        damping: B_i in force, as coefficients over the weights, (weights,) [Ns/m].
        extra_damping: B_e likewise.
        damping_share: of what the rule needs; below 1 the copy is not passive, see `give_damping`.
    """

    def __init__(
        self,
        *,
        session: SessionFile,
        replica: Replica,
        seat: int,
        hand: Callable[[int, Model], Hand],
        control: ControlPlane,
        ways: Ways,
        entropy: Entropy,
        secret: bytes,
        recorder: Recorder | None,
    ) -> None:
        """Prepares a copy that has no links yet; see `Member` for the arguments."""
        self.seat = seat
        self.peer: Peer | None = None
        self.neighbours: dict[int, Neighbour] = {}
        self.totals = Totals()
        self._session, self._options, self._replica = session, session.options, replica
        self._make_hand, self._control, self._ways = hand, control, ways
        self._hand: Hand | None = None
        self._entropy, self._secret = entropy, secret
        self._recorder = recorder
        self._plane = SamplePlane(ways.transport, replica.layout, user=seat)
        self._roster = Roster()
        self._numbers: dict[int, int] = {}  # that datagrams to this copy bear, by seat
        self._since: float | None = None  # when it came
        self._began = 0.0  # when it began to move
        self._acts: float | None = None  # since when its hand does what the file says
        self._last: Report | None = None
        self._mode = replica.scenario.synchronisation.mode
        self._owed = 0.0  # time since the last step, where steps may have to wait [s]
        self._told = -float("inf")
        self._length = 0.0  # of the last step [s]
        self._seeds = 0.0
        self._turn = 0
        self.damping = np.zeros(1 + len(replica.scenario.network.weights))
        self.extra_damping = np.zeros_like(self.damping)
        self.damping_share = 1.0

    @property
    def copies(self) -> int:
        """Members that share the object."""
        return max(1, len(self._roster.members))

    @property
    def seeds(self) -> float:
        """Energy that the links were given once, so far [J]."""
        return self._seeds

    @property
    def ports(self) -> list[int]:
        """Nodes that the hand's ports hold; see `Hand`."""
        return [] if self._hand is None else self._hand.nodes

    # -- who is there ------------------------------------------------------------------------------------------------

    def follow(self, roster: Roster, now: float) -> None:
        """Takes up and lets go of links as the roster says, and takes its share of the object.

        Args:
            roster: the newest.
            now: [s].
        """
        self._since = now if self._since is None else self._since
        self._roster = roster
        members = roster.by_seat()
        wanted = {seat: members[seat] for seat in roster.neighbours(self.seat) if seat in members}
        for seat in [seat for seat, held in self.neighbours.items() if wanted.get(seat) != held.entry]:
            self._drop(seat)
        for seat, entry in wanted.items():
            if seat not in self.neighbours:
                self._add(seat, entry, now)
        if self.peer is not None:
            self.peer.rescale(self.copies)
        self._changed(now)

    def alone(self, now: float) -> None:
        """Lets go of all links."""
        for seat in list(self.neighbours):
            self._drop(seat)
        self._changed(now)

    def hear(self, seat: int, topic: str, body: bytes, now: float) -> None:
        """Takes what a member said about a link.

        Args:
            seat: of the member.
            topic: what about.
            body: what it said.
            now: [s].
        """
        neighbour = self.neighbours.get(seat)
        if neighbour is None:
            return
        if topic == _keys.TOPIC:
            neighbour.keys.hear(body)
        elif topic == BUDGET:
            neighbour.budget.receive(now, body)

    def tend(self, now: float) -> None:
        """Says again what was not answered, and keeps budgets and damping at what is agreed.

        Args:
            now: [s].
        """
        for neighbour in self._turns():
            key = bytes.fromhex(neighbour.entry.key)
            neighbour.keys.tend(now, asked=neighbour.link.asked)
            if neighbour.connected:
                neighbour.budget.propose(now, neighbour.link.ages)
                neighbour.budget.advance(now)
                body = neighbour.budget.message(now)
                if body is not None:
                    self._control.send(BUDGET, body, to=key)
        self._damp(now)

    def _turns(self) -> list[Neighbour]:
        """Whose turn it is to be tended: everybody's, or so many one after the other."""
        held = list(self.neighbours.values())
        if len(held) <= _AT_ONCE:
            return held
        first = self._turn % len(held)
        self._turn = first + _AT_ONCE
        return (held + held)[first : first + _AT_ONCE]

    # -- moving ------------------------------------------------------------------------------------------------------

    def step(self, now: float, T: float) -> bool:
        """Hears the neighbours, moves, and tells them; False as long as there is nothing to move.

        Args:
            now: end of the step [s].
            T: its length [s].
        """
        if self.peer is None:
            self._plane.poll(now)
            # It moves from the next step on: beginning may take a second, and a sample of this step were as old.
            return self._start(now)
        peer, hand = self.peer, self._hand
        assert peer is not None
        assert hand is not None
        self._owed = min(self._owed + T, self._options.longest_step)
        waits = self._mode == "self-paced"
        if waits:
            self._hear(peer, now)
        if waits and not peer.ready:
            if now - self._told >= _TELL_AGAIN and self._last is not None:  # two must not wait for each other for ever
                self._told = now
                self._plane.send(now, self._last.sample, self._length)
            return True
        if self._last is None:
            self._began = now
        length, self._owed = self._owed, 0.0
        self._told, self._length = now, length
        hand.before(self._scripted(now), length)
        if not waits:  # as late as can be: what comes after this waits for the next step
            self._hear(peer, now)
        sample = peer.move(now, length)
        self._plane.stepped(now)
        self._plane.send(now, sample, length)  # as early as can be: what is only for this copy comes after it
        hand.after()
        report = peer.account()
        self._last = report
        self.totals.add(report, peer.neighbours)
        self._notice()
        if self._recorder is not None:
            self._recorder.step(self, report, now, length)
        return True

    def _scripted(self, now: float) -> float:
        """Time of what the file says of hands; stands at 0 until everybody is there and coupled, for as long as wanted.

        Copies that hands take apart before they are coupled, and hold there, lack the energy to meet.
        """
        if self._acts is None:
            there = len(self._roster.members) == self._session.seats
            coupled = all(held.guard.state == COUPLED for held in self.neighbours.values())
            if (there and coupled) or now - self._began >= self._options.gather:
                self._acts = now
        return 0.0 if self._acts is None else now - self._acts

    def listen(self, now: float) -> None:
        """Reads what arrived, ahead of the step that will use it.

        Args:
            now: [s].
        """
        self._plane.poll(now)

    def _hear(self, peer: Peer, now: float) -> None:
        """Reads what arrived; a neighbour that is heard first gets its spring."""
        self._plane.poll(now)
        for seat, neighbour in self.neighbours.items():
            if not neighbour.connected and neighbour.heard:
                neighbour.connected = True
                self._align(neighbour)
                peer.connect(seat, neighbour.guard, strength=neighbour.strength, weight=neighbour.weight)
                self._changed(now)

    def _start(self, now: float) -> bool:
        """Begins to move where a neighbour is, or where the file says, if nobody moves yet."""
        heard = [held for held in self.neighbours.values() if held.heard]
        quiet = self._since is not None and now - self._since > _QUIET
        agreed = all(held.keys.agreed for held in self.neighbours.values())
        if not heard and not (quiet and (agreed or now - (self._since or now) > 4.0 * _QUIET)):
            return False
        scenario = self._replica.scenario
        model = self._replica.model(self.copies)
        hand = self._hand = self._make_hand(self.seat, model)
        shape = (self._replica.body.nodes, self._replica.body.dimension)
        if heard:
            place = model.to_nodes(heard[0].link.assembly.state)
        else:
            given = scenario.initial.position
            place = np.zeros(shape) if given is None else np.broadcast_to(np.asarray(given[self.seat]), shape)
        extra = self.extra_damping
        extra[0] = per_user(scenario.synchronisation.extra_damping, self._session.seats, "extra_damping")[self.seat]
        self.peer = Peer(
            index=self.seat,
            model=model,
            links={},
            strength=[],
            weight=[],
            local_damping=self.damping,
            extra_damping=extra,
            grips=hand.grips,
            position=place,
            velocity=np.zeros(shape),
            surface=hand.surface,
            tools=hand.tools,
            tolerance=scenario.solver.tolerance,
            iterations=scenario.solver.iterations,
        )
        if isinstance(hand, AttachedHand):
            hand.attach(self.peer.state.position)
        if self._mode != "freshest" and heard:
            self.peer.steps = 1 + max(held.link.assembly.newest for held in heard)
        self._began = now
        self._changed(now)
        return True

    def _add(self, seat: int, entry: Entry, now: float) -> None:
        """Prepares a link; its spring comes when the neighbour is heard."""
        number = int.from_bytes(self._entropy(4), "big")
        while number in self._numbers.values():
            number = (number + 1) % (1 << 32)
        self._numbers[seat] = number
        self.neighbours[seat] = made = Neighbour.make(
            entry,
            session=self._session,
            replica=self._replica,
            seat=self.seat,
            control=self._control,
            number=number,
            entropy=self._entropy,
            secret=self._secret,
            now=now,
        )
        self._seeds += self._options.seed
        self._plane.connect(seat, made.link)
        self._ways.introduce(seat, bytes.fromhex(entry.key))

    def _align(self, neighbour: Neighbour) -> None:
        """Counts a neighbour's steps from where they are when it is heard first: nobody began at the same time."""
        assembly, peer = neighbour.link.assembly, self.peer
        if isinstance(assembly, IndexedAssembly) and peer is not None:
            assembly.delay = max(1, peer.steps - assembly.newest + assembly.delay)

    def _drop(self, seat: int) -> None:
        """Lets a link go."""
        del self.neighbours[seat]
        del self._numbers[seat]
        self._plane.disconnect(seat)
        if self.peer is not None:
            self.peer.disconnect(seat)

    # -- what is agreed ----------------------------------------------------------------------------------------------

    def give_damping(self, share: float, now: float) -> None:
        """Takes so much of the damping that the rule needs, and trusts every link, to show what becomes of that.

        Args:
            share: 1: the rule and its guards; below, nothing is passive.
            now: [s].
        """
        if share != self.damping_share:
            self.damping_share = share
            if self._recorder is not None:
                self._recorder.event("damping", now, share=share)
            self._damp(now)

    def _damp(self, now: float) -> None:
        """Keeps the damping at what the budgets in force need, by the rule [age rule; Lee & Huang 2010, theorem 1]."""
        needed = np.zeros_like(self.damping)
        for neighbour in self.neighbours.values():
            needed[neighbour.weight] += 0.5 * neighbour.strength * neighbour.budget.total
            neighbour.guard.budget, neighbour.guard.total = neighbour.budget.budget, neighbour.budget.total
            neighbour.guard.bypassed = self.damping_share < 1.0
        needed *= self.damping_share
        if (needed != self.damping).any():
            self.damping = needed
            if self.peer is not None:
                self.peer.set_local_damping(needed)
            self._changed(now)

    def _changed(self, now: float) -> None:
        if self._recorder is not None and self.peer is not None:
            self._recorder.setup(self, now)

    def _notice(self) -> None:
        """Counts and tells what the guards noted."""
        for seat, neighbour in self.neighbours.items():
            events = neighbour.guard.events
            while events:
                event = events.popleft()
                state = STATES.get(event.state, "guarded")
                neighbour.guarded += state == "guarded"
                if self._recorder is not None:
                    self._recorder.event(state, event.time, seat=seat, reason=event.reason)

    # -- what is seen ------------------------------------------------------------------------------------------------

    def status(self, now: float, links: list[LinkStatus] | None = None) -> Status:
        """What this member says about itself.

        Args:
            now: [s].
            links: what it says of its links, if that was worked out before.
        """
        if links is None:
            links = [self.link_status(seat) for seat in self.neighbours]
        peer, totals, report = self.peer, self.totals, self._last
        if peer is None or report is None:
            return Status(seat=self.seat, epoch=self._roster.epoch, links=links)
        needed = sum(held.strength * held.guard.total for held in self.neighbours.values()) * 0.5
        model = peer.model
        return Status(
            seat=self.seat,
            epoch=self._roster.epoch,
            time=now - self._began,
            steps=peer.steps,
            period=self._session.period(self.seat),
            force=self._force(report),
            position=model.to_nodes(peer.state.position).mean(axis=0).tolist(),
            supplied=totals.supplied,
            lost=totals.lost,
            linked=totals.linked,
            rescaled=totals.rescaled,
            energy=totals.energy,
            initial=totals.initial,
            residual=totals.residual,
            damping=float(self.damping.max()),
            certificate=float(self.damping.sum() / needed - 1.0) if needed > 0.0 else None,
            links=links,
            alarms=totals.alarms,
        )

    def _force(self, report: Report) -> float:
        """Of the hands on the copy and on the proxies, as a whole [N]."""
        force = report.force.sum(axis=0)
        tools = None if self._hand is None else self._hand.tools
        if tools is not None:
            force = force + tools.drive_force[tools.first : tools.last].sum(axis=0)[: force.size]
        return float(np.linalg.norm(force))

    def link_status(self, seat: int) -> LinkStatus:
        """What is known of a link.

        Args:
            seat: of a neighbour.
        """
        position = None if self.peer is None else self.peer.state.position
        work = self.totals.link_work.get(seat, 0.0)
        return self.neighbours[seat].status(position, way=self._ways.way(seat), work=work)
