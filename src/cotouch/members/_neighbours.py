"""The links of one copy: taken up and let go as the roster says, and kept at what their ends agree on."""

from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.control import ControlPlane
from cotouch.members import _keys
from cotouch.members._file import SessionFile
from cotouch.members._messages import Entry, LinkStatus, Roster
from cotouch.members._neighbour import STATES, Neighbour
from cotouch.members._paths import Paths
from cotouch.members._shared_model import SharedModel
from cotouch.members._step_recorder import StepRecorder
from cotouch.network import link_damping
from cotouch.peer import CopyMemory
from cotouch.samples import Entropy, SamplePlane
from cotouch.scenario import makes_tree

BUDGET = "link.budget"
# Links that are tended at once, between two steps.
_AT_ONCE = 8


@final
class Neighbours:
    """Whom one copy is linked to.

    Attributes:
        by_slot: the ends of the links here.
        memory: what the law's ends share; None: springs, or no link yet.
        given: energy that the links were given once, so far [J].
    """

    def __init__(
        self,
        *,
        session: SessionFile,
        replica: SharedModel,
        slot: int,
        control: ControlPlane,
        paths: Paths,
        plane: SamplePlane,
        entropy: Entropy,
        secret: bytes,
        recorder: StepRecorder | None,
    ) -> None:
        """Begins with nobody; see `Member` for the arguments.

        Args:
            session: what was asked for.
            replica: the body as built here.
            slot: of this copy's user.
            control: the control plane.
            paths: looks for ways to neighbours.
            plane: carries their samples.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
            recorder: is told of events.
        """
        self.by_slot: dict[int, Neighbour] = {}
        self.memory: CopyMemory | None = None
        self.given = 0.0
        self._session, self._replica, self._slot = session, replica, slot
        self._control, self._paths, self._plane = control, paths, plane
        self._entropy, self._secret = entropy, secret
        self._recorder = recorder
        self._numbers: dict[int, int] = {}  # that datagrams to this copy bear, by slot
        self._turn = 0

    def add(self, entry: Entry, now: float, *, newcomer: bool, copies: int) -> None:
        """Prepares a link; its spring comes when the neighbour is heard.

        Args:
            entry: who is at the other end.
            now: [s].
            newcomer: whether it has just come to where this copy is.
            copies: members that share the object.
        """
        slot, law = entry.slot, self._replica.law
        number = int.from_bytes(self._entropy(4), "big")
        while number in self._numbers.values():
            number = (number + 1) % (1 << 32)
        self._numbers[slot] = number
        if law is not None and (self.memory is None or not self.by_slot):
            self.memory = law.memory()
        self.by_slot[slot] = made = Neighbour.make(
            entry,
            session=self._session,
            replica=self._replica,
            slot=self._slot,
            control=self._control,
            number=number,
            entropy=self._entropy,
            secret=self._secret,
            newcomer=newcomer,
            memory=self.memory,
            copies=copies,
            now=now,
        )
        self.given += self._session.options.initial_energy if made.law is None else made.law.initial_energy
        self._plane.connect(slot, made.link)
        self._paths.introduce(slot, bytes.fromhex(entry.key))

    def shape(self, roster: Roster) -> None:
        """Tells laws whether all links of the session make a tree, in which they tell of more than their own hand.

        Ends that have heard of a change at different times do no harm: each pays for what it does.

        Args:
            roster: the newest.
        """
        law = self._replica.law
        if law is None:
            return
        tree = makes_tree((entry.slot for entry in roster.members), roster.links)
        for slot, neighbour in self.by_slot.items():
            if neighbour.law is not None:
                neighbour.law.set_parameters(law.parameters(self._slot, slot, tree=tree))

    def drop(self, slot: int) -> None:
        """Lets a link go."""
        del self.by_slot[slot]
        del self._numbers[slot]
        self._plane.disconnect(slot)

    def receive(self, slot: int, topic: str, body: bytes, now: float) -> None:
        """Takes what a member said about a link.

        Args:
            slot: of the member.
            topic: what about.
            body: what it said.
            now: [s].
        """
        neighbour = self.by_slot.get(slot)
        if neighbour is None:
            return
        if topic == _keys.TOPIC:
            neighbour.keys.receive(body)
        elif topic == BUDGET:
            neighbour.budget.receive(now, body)

    def service(self, now: float) -> None:
        """Says again what was not answered, and keeps budgets at what is agreed.

        Args:
            now: [s].
        """
        for slot, neighbour in self._turns():
            neighbour.keys.service(now, asked=neighbour.link.asked)
            if neighbour.guard is None:
                neighbour.silent = neighbour.link.ages.silent(now)
            if not neighbour.connected or neighbour.guard is None:
                continue
            neighbour.budget.propose(now, neighbour.link.ages)
            neighbour.budget.advance(now)
            body = neighbour.budget.message(now)
            if body is not None:
                self._control.send(BUDGET, body, to=bytes.fromhex(neighbour.entry.key))
            beyond = neighbour.budget.beyond
            if neighbour.beyond != (beyond is not None):
                neighbour.beyond = beyond is not None
                if beyond is not None and self._recorder is not None:
                    limit = self._session.options.age_limit
                    self._recorder.event("beyond", now, slot=slot, asked=beyond, granted=limit)

    def damp(self, fraction: float) -> Float:
        """Takes over the budgets in force; the damping they need, (weights,) [Ns/m] [Lee & Huang 2010, theorem 1].

        Args:
            fraction: of it that is given; below 1 every link is trusted, and nothing is passive.
        """
        needed = np.zeros(1 + len(self._replica.scenario.network.weights))
        if self._replica.law is not None:
            needed[0] = self._replica.law.law.drag
        for neighbour in self.by_slot.values():
            guard = neighbour.guard
            if guard is None:
                continue
            guard.budget, guard.total = neighbour.budget.budget, neighbour.budget.total
            needed[neighbour.weight] += link_damping(neighbour.strength, neighbour.damped)
            coded = neighbour.link.coded
            if coded is not None and coded.encoder.account is not None:
                coded.encoder.account.window = guard.total  # the other end's budget is no more than both
            guard.bypassed = fraction < 1.0
        needed *= fraction
        return needed

    def notice(self) -> None:
        """Counts and tells what the guards noted."""
        for slot, neighbour in self.by_slot.items():
            if neighbour.guard is None:
                continue
            events = neighbour.guard.events
            while events:
                event = events.popleft()
                state = STATES[event.state]
                neighbour.guarded += state == "guarded"
                if self._recorder is not None:
                    self._recorder.event(state, event.time, slot=slot, reason=event.reason)

    def status(self, slot: int, position: Float | None, work: float) -> LinkStatus:
        """What is known of a link.

        Args:
            slot: of a neighbour.
            position: of the copy, (rows, width) [m]; None: it is not there yet.
            work: that the link did on it [J].
        """
        path_state = self._paths.path_state(slot).name.lower()
        return self.by_slot[slot].status(position, path_state=path_state, work=work)

    def _turns(self) -> list[tuple[int, Neighbour]]:
        """Whose turn it is to be tended: everybody's, or so many one after the other."""
        held = list(self.by_slot.items())
        if len(held) <= _AT_ONCE:
            return held
        first = self._turn % len(held)
        self._turn = first + _AT_ONCE
        return (held + held)[first : first + _AT_ONCE]
