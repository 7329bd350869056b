"""One member's copy of the object, and all that joins it to its neighbours."""

from collections.abc import Callable
from typing import final

import numpy as np

from cotouch.control import ControlPlane
from cotouch.mechanics import Model
from cotouch.members._felt import force_felt, predicted_drag
from cotouch.members._file import SessionFile
from cotouch.members._hand import AttachedHand, Hand
from cotouch.members._messages import Entry, LinkStatus, Roster, Status
from cotouch.members._neighbour import Neighbour
from cotouch.members._neighbours import Neighbours
from cotouch.members._paths import Paths
from cotouch.members._shared_cuts import TOPIC, SharedCuts, digest_of
from cotouch.members._shared_model import SharedModel
from cotouch.members._step_recorder import StepRecorder
from cotouch.members._totals import Totals
from cotouch.network import link_damping
from cotouch.peer import Peer, StepReport, without_debris
from cotouch.samples import Entropy, IndexedAssembly, SamplePlane, Transport
from cotouch.scenario import per_user

# A peer waits for its neighbours so long at most: one may have gone, or never mean to go on [s].
_MOST_WAIT = 0.5
# A peer that waits for its neighbours says its last sample again after this [s].
_TELL_AGAIN = 0.1


@final
class Replica:
    """One member's copy: follows the roster with its links, and moves.

    Attributes:
        slot: index of this user.
        peer: None before the first step.
        totals: what was booked since the start.
        damping: B_i in force, as coefficients over the weights, (weights,) [Ns/m].
        extra_damping: B_e likewise.
        damping_fraction: of what the rule needs; below 1 the copy is not passive, see `give_damping`.
        stood: time in which it stood still, because it waited for samples longer than a step may last [s].
    """

    def __init__(
        self,
        *,
        session: SessionFile,
        replica: SharedModel,
        slot: int,
        hand: Callable[[int, Model], Hand],
        control: ControlPlane,
        paths: Paths,
        transport: Transport,
        entropy: Entropy,
        secret: bytes,
        recorder: StepRecorder | None,
    ) -> None:
        """Prepares a copy that has no links yet; see `Member` for the arguments."""
        self.slot = slot
        self.peer: Peer | None = None
        self.totals = Totals()
        self._session, self._options, self._replica = session, session.options, replica
        self._make_hand, self._recorder = hand, recorder
        self._hand: Hand | None = None
        self._law = replica.law
        self._plane = SamplePlane(transport, replica.layout, user=slot)
        self._links = Neighbours(
            session=session,
            replica=replica,
            slot=slot,
            control=control,
            paths=paths,
            plane=self._plane,
            entropy=entropy,
            secret=secret,
            recorder=recorder,
        )
        self._cuts = None if replica.uncut else SharedCuts(control, replica, session.digest + secret, slot)
        self._roster = Roster()
        self._began = 0.0  # when it began to move
        self._acts: float | None = None  # since when its hand does what the file says
        self._last: StepReport | None = None
        self._mode = replica.scenario.synchronisation.mode
        self._owed = 0.0  # time since the last step, where steps may have to wait [s]
        self._first = 0  # index of the first step
        self.stood = 0.0
        self._announced = -float("inf")
        self._stepped = 0.0  # when the last step was taken [s]
        self._stands = False  # whether a neighbour stands still, and is not waited for
        self._length = 0.0  # of the last step [s]
        self.damping = np.zeros(1 + len(replica.scenario.network.weights))
        self.extra_damping = np.zeros_like(self.damping)
        self.damping_fraction = 1.0

    @property
    def neighbours(self) -> dict[int, Neighbour]:
        """Ends of the links, by slot."""
        return self._links.by_slot

    @property
    def copies(self) -> int:
        """Members that share the object."""
        return max(1, len(self._roster.members))

    @property
    def entry(self) -> Entry | None:
        """What the roster says of this copy's user; None: it is not there."""
        return self._roster.by_slot().get(self.slot)

    @property
    def initial_energies(self) -> float:
        """Energy that the links were given once, and of the allowance, so far [J]."""
        return self._links.given + self.totals.advanced

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
        before, self._roster = self._roster.members, roster
        members = roster.by_slot()
        wanted = {slot: members[slot] for slot in roster.neighbours(self.slot) if slot in members}
        for slot in [slot for slot, held in self.neighbours.items() if wanted.get(slot) != held.entry]:
            self._drop(slot)
        for slot, entry in wanted.items():
            if slot not in self.neighbours:
                newcomer = self.peer is not None and entry not in before
                self._links.add(entry, now, newcomer=newcomer, copies=self.copies)
        self._links.shape(roster)
        if self.peer is not None:
            self.peer.rescale(self.copies)
        self._damp(now)  # of links that are gone, at once
        self._changed(now)

    def alone(self, now: float) -> None:
        """Lets go of all links."""
        for slot in list(self.neighbours):
            self._drop(slot)
        self._damp(now)
        self._changed(now)

    def receive(self, slot: int, topic: str, body: bytes, now: float) -> None:
        """Takes what a member said about a link.

        Args:
            slot: of the member.
            topic: what about.
            body: what it said.
            now: [s].
        """
        if topic == TOPIC and self._cuts is not None:
            self._cuts.receive(slot, body, self._roster, now)
        self._links.receive(slot, topic, body, now)

    def service(self, now: float) -> None:
        """Says again what was not answered, and keeps budgets and damping at what is agreed.

        Args:
            now: [s].
        """
        self._links.service(now)
        if self._cuts is not None:
            self._cuts.service(self.peer, now, coupled=all(held.coupled for held in self.neighbours.values()))
        self._damp(now)

    # -- moving ------------------------------------------------------------------------------------------------------

    def step(self, now: float, T: float) -> None:
        """Hears the neighbours, moves, and tells them; the first one only makes the copy.

        Args:
            now: end of the step [s].
            T: its length [s].
        """
        if self.peer is None:
            # It moves from the next step on: beginning may take a second, and a sample of this step were as old.
            self._start(now)
            return
        peer, hand = self.peer, self._hand
        assert hand is not None
        waits = self._mode == "self-paced"
        self._owed += T
        if self._owed > self._options.max_step:  # a wait that no step may cover: the copy stands still for the rest
            self.stood += self._owed - self._options.max_step
            self._owed = self._options.max_step
        if waits:
            self._receive(peer, now)
        ready = not waits or peer.ready
        self._stands &= not ready
        if not ready and not self._stands and now - self._stepped < _MOST_WAIT:
            # Two must not wait for each other for ever.
            if now - self._announced >= _TELL_AGAIN and self._last is not None:
                self._announced = now
                self._plane.send(now, self._last.sample, self._length)
            return
        self._stands, self._stepped = not ready, now  # who keeps others waiting is not waited for until it goes on
        if self._last is None:
            self._began, self._first = now, peer.steps
        elif self._mode == "constant":
            # A common index goes on with everybody's clock: steps that were left out are not taken later.
            passed = round((now - self._began) / self._session.period(self.slot))
            peer.steps = max(peer.steps, self._first + passed)
        length, self._owed = self._owed, 0.0
        self._announced, self._length = now, length
        hand.before(self._scripted(now), length)
        if not waits:  # as late as can be: what comes after this waits for the next step
            self._receive(peer, now)
        sample = peer.move(now, length)
        self._plane.stepped(now)
        self._plane.send(now, sample, length, peer.mean)  # as early as can be; what follows is for this copy alone
        hand.after()
        report = self._last = peer.account()
        self.totals.add(report, peer.neighbours, length)
        self._links.notice()
        if self._recorder is not None:
            self._recorder.step(self, report, now, length)

    def _scripted(self, now: float) -> float:
        """Time of what the file says of hands; stands at 0 until everybody is there and coupled, for as long as wanted.

        Copies that hands take apart before they are coupled, and hold there, lack the energy to meet.
        """
        if self._acts is None:
            there = len(self._roster.members) == self._session.slots
            coupled = all(held.coupled for held in self.neighbours.values())
            if (there and coupled) or now - self._began >= self._options.wait_for_peers:
                self._acts = now
        return 0.0 if self._acts is None else now - self._acts

    def listen(self, now: float) -> None:
        """Reads what arrived, ahead of the step that will use it.

        Args:
            now: [s].
        """
        self._plane.poll(now)

    def _receive(self, peer: Peer, now: float) -> None:
        """Reads what arrived; a neighbour that is heard first gets its spring."""
        self._plane.poll(now)
        for slot, neighbour in self.neighbours.items():
            law = neighbour.law
            if law is not None:
                law.offset = neighbour.link.ahead
            if not neighbour.connected and neighbour.received:
                neighbour.connected = True
                if law is not None:
                    law.copies = self.copies
                self._align(neighbour)
                neighbour.begin()
                peer.connect(slot, neighbour.source, strength=neighbour.strength, weight=neighbour.weight)
                self._changed(now)

    def _start(self, now: float) -> None:
        """Begins at rest where the session's file says: what neighbours say might be a lie.

        From there the links' guards bring the copy to where the others are, with the session's allowance.
        """
        scenario, model = self._replica.scenario, self._replica.model(self.copies)
        hand = self._hand = self._make_hand(self.slot, model)
        place = self._replica.begins(self.slot)
        extra = self.extra_damping
        extra[0] = per_user(scenario.synchronisation.extra_damping, self._session.slots, "extra_damping")[self.slot]
        self.peer = Peer(
            index=self.slot,
            model=model,
            links={},
            strength=[],
            weight=[],
            local_damping=self.damping,
            extra_damping=extra,
            ports=hand.ports,
            position=place,
            velocity=np.zeros_like(place),
            allowance=self._options.allowance if self.copies > 1 else 0.0,
            surface=hand.surface,
            tools=hand.tools,
            contact=hand.contact,
            cuts=scenario.cutting is None or scenario.cutting.may(self.slot + 1),
            tolerance=scenario.solver.tolerance,
            iterations=scenario.solver.iterations,
        )
        if isinstance(hand, AttachedHand):
            hand.attach(self.peer.state.position)
        self._began = self._stepped = now
        self._changed(now)

    def _align(self, neighbour: Neighbour) -> None:
        """Counts a neighbour's steps from where they are when it is heard first: nobody began at the same time."""
        assembly, peer = neighbour.link.assembly, self.peer
        if isinstance(assembly, IndexedAssembly) and peer is not None:
            assembly.shift = assembly.newest - peer.steps

    def _drop(self, slot: int) -> None:
        """Lets a link go."""
        self._links.drop(slot)
        self.totals.link_age.pop(slot, None)
        if self.peer is not None:
            self.peer.disconnect(slot)

    # -- what is agreed ----------------------------------------------------------------------------------------------

    def give_damping(self, fraction: float, now: float) -> None:
        """Takes so much of the damping that the rule needs, and trusts every link, to show what becomes of that.

        Args:
            fraction: 1: the rule and its guards; below, nothing is passive. A law that needs no damping keeps on.
            now: [s].
        """
        if fraction != self.damping_fraction and self._law is None:
            self.damping_fraction = fraction
            if self._recorder is not None:
                self._recorder.event("damping", now, fraction=fraction)
            self._damp(now)

    def _damp(self, now: float) -> None:
        """Keeps the damping at what the budgets in force need, by the rule."""
        needed = self._links.damp(self.damping_fraction)
        if (needed != self.damping).any():
            self.damping = needed
            if self.peer is not None:
                self.peer.set_local_damping(needed)
            self._changed(now)

    def _changed(self, now: float) -> None:
        if self._recorder is not None and self.peer is not None:
            self._recorder.setup(self, now)

    # -- what is seen ------------------------------------------------------------------------------------------------

    def status(self, now: float, links: list[LinkStatus] | None = None) -> Status:
        """What this member says about itself.

        Args:
            now: [s].
            links: what it says of its links, if that was worked out before.
        """
        if links is None:
            links = [self.link_status(slot) for slot in self.neighbours]
        peer, totals, report = self.peer, self.totals, self._last
        if peer is None or report is None:
            return Status(slot=self.slot, epoch=self._roster.epoch, links=links)
        needed = sum(link_damping(held.strength, held.damped) for held in self.neighbours.values())
        model = peer.model
        return Status(
            slot=self.slot,
            epoch=self._roster.epoch,
            time=now - self._began,
            steps=peer.steps,
            nominal_period=self._session.period(self.slot),
            force=force_felt(report, None if self._hand is None else self._hand.tools),
            position=model.to_nodes(peer.state.position).mean(axis=0).tolist(),
            supplied=totals.supplied,
            lost=totals.lost,
            linked=totals.linked,
            rescaled=totals.rescaled,
            energy=totals.energy,
            depth=totals.depth,
            initial=totals.initial,
            initial_energies=self.initial_energies,
            residual=totals.residual,
            damping=float(self.damping.max()),
            law="spring" if self._law is None else self._law.law.name,
            held=0.0 if self._links.memory is None else self._links.memory.held,
            drag=predicted_drag(
                self.damping, self.neighbours, totals.link_age, self._session.period(self.slot), self._law
            ),
            braked=totals.braked,
            moved=totals.moved,
            damping_margin=float(self.damping.sum() / needed - 1.0) if needed > 0.0 else None,
            links=links,
            unsent=self._plane.unsent,
            alarms=totals.alarms,
            closure=totals.closure,
            closure_factor=totals.closure_factor,
            closure_alarms=totals.closure_alarms,
            cut_energy=totals.cut,
            cuts=0 if peer.cuts is None else int(np.count_nonzero(peer.cuts.by)),
            cut_set="" if peer.cuts is None else digest_of(peer.cuts.by),
        )

    def link_status(self, slot: int) -> LinkStatus:
        """What is known of a link.

        Args:
            slot: of a neighbour.
        """
        position = None if self.peer is None else without_debris(self.peer.cuts, self.peer.state.position)
        return self._links.status(slot, position, self.totals.link_work.get(slot, 0.0))
