"""One end of a link as a copy holds it: keys, samples, guard, budget, and what is said of it."""

import math
from dataclasses import dataclass
from typing import Self, final

import numpy as np
import numpy.typing as npt

from cotouch.live import (
    LOWEST_RATE,
    Assembly,
    BudgetAgreement,
    ControlPlane,
    Entropy,
    IndexedAssembly,
    LinkAges,
    SampleLink,
    SendRate,
)
from cotouch.peer import COUPLED, READY, LinkGuard
from cotouch.session import _keys
from cotouch.session._file import SessionFile
from cotouch.session._messages import Entry, LinkStatus
from cotouch.session._replica import Replica

Float = npt.NDArray[np.float64]

STATES = {COUPLED: "coupled", READY: "ready"}
# Steps that may come late by so many periods without a budget being raised for it.
_SLACK = 2.0
# What was bad in the window is forgotten with it; so much longer, as a share of it, less must do before it is less.
_PATIENCE = 0.2
# A path that loses so many samples in a row, at the slowest that they come, does not only lose some; see `LinkAges`.
_OUTAGE = 10.0


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
        guard: what keeps this end passive.
        budget: how both ends agree on ages.
        connected: whether the spring is there, because the neighbour's state is known.
        guarded: how often it was guarded since it was coupled first.
    """

    entry: Entry
    strength: float
    weight: int
    keys: _keys.KeyExchange
    link: SampleLink
    guard: LinkGuard
    budget: BudgetAgreement
    connected: bool = False
    guarded: int = 0

    @property
    def heard(self) -> bool:
        """Whether the neighbour's whole state is known."""
        assembly = self.link.assembly
        return assembly.newest >= 0 if isinstance(assembly, IndexedAssembly) else assembly.complete

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
        replica: Replica,
        seat: int,
        control: ControlPlane,
        number: int,
        entropy: Entropy,
        secret: bytes,
        now: float,
    ) -> Self:
        """Prepares this end as the session's file says; nothing is said yet.

        Args:
            entry: who is at the other end.
            session: what was asked for.
            replica: the body as built here.
            seat: of this end.
            control: carries the keys' agreement.
            number: by which this end finds the link.
            entropy: gives so many bytes that nobody can guess.
            secret: that only the invited know.
            now: [s].
        """
        network, options, layout = replica.scenario.network, session.options, replica.layout
        still = np.zeros((layout.rows, layout.width))
        assembly: Assembly | IndexedAssembly = (
            Assembly(layout, sender=entry.seat, initial=still)
            if replica.scenario.synchronisation.mode == "freshest"
            else IndexedAssembly(
                layout, sender=entry.seat, initial=still, delay=_index_delay(session, replica, seat, entry.seat)
            )
        )
        slowest = max(1.0 / LOWEST_RATE, _send_period(session, entry.seat), session.period(seat))
        ages = LinkAges(window=options.window, outage=_OUTAGE * slowest)
        link = SampleLink(assembly, rate=SendRate(highest=1.0 / _send_period(session, seat)), ages=ages)
        keys = _keys.KeyExchange(
            control,
            link.seal,
            other=bytes.fromhex(entry.key),
            session=session.digest,
            connection=number,
            entropy=entropy,
            secret=secret,
        )
        guard = LinkGuard(
            assembly,
            seed=options.seed,
            cap=max(options.tank, options.seed),
            force=options.force_limit,
            power=options.power_limit,
            rounding=replica.rounding,
            epoch=1 + entropy(1)[0] % 255,
        )
        link.guard = guard
        return cls(
            entry=entry,
            strength=float(network.spring[seat, entry.seat]),
            weight=int(network.weight_of[seat, entry.seat]) + 1,
            keys=keys,
            link=link,
            guard=guard,
            budget=BudgetAgreement(
                life=max(1, int(1e9 * now)),
                quantile=options.quantile,
                margin=options.margin,
                slack=_SLACK * session.period(seat),
                patience=_PATIENCE * options.window,
            ),
        )

    def status(self, position: Float | None, *, way: str, work: float) -> LinkStatus:
        """What is known of the link.

        Args:
            position: of this end's copy, as the model's rows [m]; None before it moves.
            way: how the neighbour is reached.
            work: of the link on the copy since the start [J].
        """
        seat, link = self.entry.seat, self.link
        if not self.keys.agreed:
            return LinkStatus(seat=seat, state="keys", way=way)
        if not self.connected or position is None:
            return LinkStatus(seat=seat, state="waiting", way=way)
        books = self.guard.books
        apart = np.linalg.norm(position - link.assembly.state, axis=1)
        return LinkStatus(
            seat=seat,
            state=STATES.get(books.state, "guarded"),
            way=way,
            age=link.ages.age,
            ages=link.ages.worst_sum,
            budget=self.guard.total if np.isfinite(self.guard.budget) else None,
            path=link.ages.shortest_path,
            loss=link.rate.loss,
            rate=link.rate.rate,
            force=float(np.sqrt(max(0.0, 2.0 * books.potential * self.strength))),
            work=work,
            difference=float(apart.max()),
            guarded=self.guarded,
        )


def _send_period(session: SessionFile, seat: int) -> float:
    """Least time between samples of a user [s]."""
    rate = session.options.send_rate
    return 1.0 / rate if rate else session.period(seat)


def _index_delay(session: SessionFile, replica: Replica, seat: int, other: int) -> int:
    """N_ij of a neighbour, from the file: as given, or what covers the delay that it says."""
    given = replica.scenario.synchronisation.index_delay
    if given is not None:
        return max(1, given[seat][other])
    delay = float(replica.scenario.network.delay[seat, other])
    return 1 + math.ceil(delay / session.period(seat))
