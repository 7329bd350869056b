"""One end of a link as a copy holds it: keys, samples, guard, budget, and what is said of it."""

import math
from dataclasses import dataclass
from typing import Self, final

import numpy as np

from cotouch.arrays import Bool, Float
from cotouch.control import ControlPlane
from cotouch.members import _keys
from cotouch.members._file import SessionFile
from cotouch.members._live_law import PATIENCE
from cotouch.members._messages import Entry, LinkStatus
from cotouch.members._shared_model import SharedModel
from cotouch.peer import CopyMemory, GuardLedger, LawLink, LinkGuard, LinkState
from cotouch.samples import (
    LOWEST_RATE,
    Assembly,
    BudgetAgreement,
    CodedLink,
    Entropy,
    IndexedAssembly,
    LinkAges,
    SampleLink,
    SendRate,
)

STATES = {int(state): state.name.lower() for state in LinkState}
# Steps that may come late by so many periods without a budget being raised for it.
_SLACK = 2.0
# What was bad in the window is forgotten with it; so much longer, as a share of it, less must do before it is less.
_PATIENCE = 0.2
# A path that loses so many samples in a row, at the slowest that they come, does not only lose some; see `LinkAges`.
_OUTAGE = 10.0
# With a law, so many datagrams go to a neighbour in a step, in the mean, but never fewer samples than this [1/s].
_DATAGRAMS, _OFTEN = 1, 50.0


@final
@dataclass(eq=False)
class Neighbour:
    """One end of a link.

    Attributes:
        entry: who is at the other end.
        strength: of the spring [N/m for the weight].
        weight: index of the spring's weight among the model's.
        keys: how it gets its keys.
        link: its samples.
        guard: what keeps this end passive; None: its law does.
        law: what the link does; None: a guarded spring.
        budget: how both ends agree on ages.
        known: rows of the model that the link knows of: no tool's.
        connected: whether the spring is there, because the neighbour's state is known.
        silent: whether nothing has been heard for as long as makes an outage; of a link without a guard.
        guarded: how often it was guarded since it was coupled first.
        beyond: whether more damping is asked for than the session's limit gives; as last noticed.
    """

    entry: Entry
    strength: float
    weight: int
    keys: _keys.KeyExchange
    link: SampleLink
    guard: LinkGuard | None
    law: LawLink | None
    budget: BudgetAgreement
    known: Bool | slice
    connected: bool = False
    silent: bool = False
    guarded: int = 0
    beyond: bool = False

    @property
    def received(self) -> bool:
        """Whether the neighbour's whole state is known."""
        assembly = self.link.assembly
        return assembly.newest >= 0 if isinstance(assembly, IndexedAssembly) else assembly.complete

    @property
    def source(self) -> LinkGuard | LawLink:
        """For the peer."""
        source = self.law or self.guard
        assert source is not None
        return source

    @property
    def coupled(self) -> bool:
        """Whether it does all that it is for."""
        return self.connected and not self.silent if self.guard is None else self.guard.state == LinkState.COUPLED

    @property
    def total(self) -> float:
        """Sum of both budgets, as far as damping covers it; 0 where none is needed [s]."""
        return 0.0 if self.guard is None else self.guard.total

    @property
    def damped(self) -> float:
        """Time for which this end damps: both budgets, and what pays for the errors of a perceptual codec [s]."""
        coded = self.link.coded
        extra = 0.0 if coded is None or coded.encoder.account is None else 2.0 * coded.age
        return self.total + extra

    def begin(self) -> None:
        """Begins the account of a perceptual codec, now that the spring is there."""
        coded = self.link.coded
        if coded is not None and coded.encoder.account is not None:
            coded.encoder.account.begin()

    @property
    def ledger(self) -> GuardLedger | None:
        """Of the guard."""
        return None if self.guard is None else self.guard.ledger

    @property
    def force(self) -> float:
        """Of the spring, or of what the law pushes with, on the copy [N]."""
        if self.law is not None:
            return self.law.force
        ledger = self.ledger
        return 0.0 if ledger is None else float(np.sqrt(max(0.0, 2.0 * ledger.potential * self.strength)))

    @property
    def used(self) -> int:
        """Index of the sample that the last step used; -2 where it was put together of several, -3 unsaid."""
        assembly = self.link.assembly
        if isinstance(assembly, IndexedAssembly):
            return -3
        return assembly.newest if min(assembly.indices) == assembly.newest else -2

    @classmethod
    def make(
        cls,
        entry: Entry,
        *,
        session: SessionFile,
        replica: SharedModel,
        slot: int,
        control: ControlPlane,
        number: int,
        entropy: Entropy,
        secret: bytes,
        newcomer: bool,
        memory: CopyMemory | None,
        copies: int,
        now: float,
    ) -> Self:
        """Prepares this end as the session's file says; nothing is said yet.

        Args:
            entry: who is at the other end.
            session: what was asked for.
            replica: the body as built here.
            slot: of this end.
            control: carries the keys' agreement.
            number: by which this end finds the link.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
            newcomer: whether the one at the other end has just come to where this one is.
            memory: what the law's ends of the copy share; None: springs.
            copies: N.
            now: [s].
        """
        network, options, layout = replica.scenario.network, session.options, replica.layout
        still = np.zeros((layout.rows, layout.width))
        assembly: Assembly | IndexedAssembly = (
            Assembly(layout, sender=entry.slot, initial=still)
            if replica.scenario.synchronisation.mode == "freshest"
            else IndexedAssembly(
                layout, sender=entry.slot, initial=still, delay=_index_delay(session, replica, slot, entry.slot)
            )
        )
        slowest = max(1.0 / LOWEST_RATE, _send_period(session, entry.slot), session.period(slot))
        weight, asked = int(network.weight_of[slot, entry.slot]) + 1, replica.scenario.channel.codec
        # What goes on from a sample that is lost is lost, too.
        lost = 0.0 if asked is None else asked.hold * session.period(entry.slot)
        ages = LinkAges(window=options.window, outage=_OUTAGE * slowest + lost)
        link = SampleLink(assembly, rate=SendRate(highest=_highest(session, replica, slot)), ages=ages)
        if asked is not None:
            diagonal = replica.model(1).operator.weight[weight]
            link.coded = CodedLink(layout, diagonal, sender=entry.slot)
        keys = _keys.KeyExchange(
            control,
            link.seal,
            other=bytes.fromhex(entry.key),
            session=session.digest,
            connection=number,
            entropy=entropy,
            secret=secret,
        )
        if replica.law is not None and memory is not None:
            link.law = replica.law.link(assembly, memory, slot=slot, other=entry.slot, copies=copies, newcomer=newcomer)
        else:
            link.guard = LinkGuard(
                assembly,
                initial_energy=options.initial_energy,
                cap=max(options.tank, options.initial_energy),
                force=options.force_limit,
                power=options.power_limit,
                rounding=replica.rounding,
                patience=PATIENCE if newcomer else 0.0,
                epoch=1 + entropy(1)[0] % 255,
            )
        return cls(
            entry=entry,
            strength=float(network.spring[slot, entry.slot]),
            weight=weight,
            keys=keys,
            link=link,
            guard=link.guard,
            law=link.law,
            budget=BudgetAgreement(
                life=max(1, int(1e9 * now)),
                quantile=options.quantile,
                margin=options.margin,
                slack=_SLACK * session.period(slot),
                patience=_PATIENCE * options.window,
                limit=options.age_limit,
            ),
            known=replica.model(1).operator.weight[0] > 0.0 if replica.body.tools else slice(None),
        )

    def status(self, position: Float | None, *, path_state: str, work: float) -> LinkStatus:
        """What is known of the link.

        Args:
            position: of this end's copy, as the model's rows, NaN for what is debris [m]; None before it moves.
            path_state: how the neighbour is reached.
            work: of the link on the copy since the start [J].
        """
        slot, link = self.entry.slot, self.link
        if not self.keys.agreed:
            return LinkStatus(slot=slot, state="keys", path_state=path_state)
        if not self.connected or position is None:
            return LinkStatus(slot=slot, state="waiting", path_state=path_state)
        ledger, law = self.ledger, self.law
        apart = np.linalg.norm((position - link.assembly.state)[self.known], axis=1)
        return LinkStatus(
            slot=slot,
            law="spring" if law is None else law.law.name,
            given=0.0 if law is None else law.sent,
            taken=0.0 if law is None else law.received,
            state=("coupled" if self.coupled else "waiting") if ledger is None else STATES[ledger.state],
            path_state=path_state,
            age=link.ages.age,
            age_sum=link.ages.worst_sum,
            budget=self.guard.total if self.guard is not None and np.isfinite(self.guard.budget) else None,
            round_trip=link.ages.shortest_path,
            loss=link.rate.loss,
            rate=link.rate.rate,
            datagram_rate=link.sent.datagrams,
            byte_rate=link.sent.size,
            saved=link.sent.saved,
            force=self.force,
            work=work,
            difference=float(np.fmax.reduce(apart, initial=0.0)),
            guarded=self.guarded,
            asked=self.budget.beyond,
        )


def _highest(session: SessionFile, replica: SharedModel, slot: int) -> float:
    """Most samples that a user sends a neighbour [1/s].

    What a law says of a large body takes many datagrams. Unless the file says how often, it goes less often then: sums
    make up for what is left out.
    """
    highest = 1.0 / _send_period(session, slot)
    if replica.law is None or session.options.send_rate:
        return highest
    return min(highest, max(highest * _DATAGRAMS / replica.layout.chunks, _OFTEN))


def _send_period(session: SessionFile, slot: int) -> float:
    """Least time between samples of a user [s]."""
    rate = session.options.send_rate
    return 1.0 / rate if rate else session.period(slot)


def _index_delay(session: SessionFile, replica: SharedModel, slot: int, other: int) -> int:
    """N_ij of a neighbour, from the file: as given, or what covers the delay that it says."""
    given = replica.scenario.synchronisation.index_delay
    if given is not None:
        return max(1, given[slot][other])
    delay = float(replica.scenario.network.delay[slot, other])
    return 1 + math.ceil(delay / session.period(slot))
