"""The link law of a session, and its parameters at every end: the same for both ends, so they follow from its file."""

from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.laws import FORCE, Facts, Law, law_named
from cotouch.mechanics import Operator
from cotouch.members._file import SessionFile
from cotouch.peer import CopyMemory, LawLink, Link

# What ages differ by on a path that nobody has measured yet [s].
_SPREAD = 0.03
# Over so long an end begins to pull at a newcomer: it has what it takes to come, and nobody's hand is torn along [s].
PATIENCE = 2.0


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class LiveLaw:
    """Makes the ends of links with a law.

    Attributes:
        law: of all links.
        session: whose file says the rest.
        mass: of a row of the whole body, in the mean [kg].
        lightest: likewise of the lightest row [kg].
        rows: of the body's model.
        size: rows and axes of a state, multiplied.
    """

    law: Law
    session: SessionFile
    mass: float
    lightest: float
    rows: int
    size: int

    @classmethod
    def of(cls, session: SessionFile, operator: Operator, size: int) -> "LiveLaw | None":
        """The session's; None: guarded springs.

        Args:
            session: what was asked for.
            operator: of the body.
            size: rows and axes of a state, multiplied.
        """
        name = session.law
        if name == "spring":
            return None
        known = operator.weight[0] > 0.0  # links do not know of tools
        masses = operator.mass[known] / operator.weight[0, known]
        mass, lightest, rows = float(masses.mean()), float(masses.min()), int(known.sum())
        return cls(law=law_named(name), session=session, mass=mass, lightest=lightest, rows=rows, size=size)

    def memory(self) -> CopyMemory:
        """For all links of one copy."""
        return CopyMemory(self.law, self.size)

    def parameters(self, slot: int, other: int, *, tree: bool = False) -> Float:
        """Of the end at a slot.

        Args:
            slot: of this end.
            other: of the other end.
            tree: whether the links of those who are there make one.
        """
        session, network = self.session, self.session.scenario.network
        _, given = session.scenario.law
        longest = max(session.period(user) for user in range(session.slots))
        age = 0.5 * float(network.delay[slot, other] + network.delay[other, slot]) + longest
        most = max(1, session.slots - 1)  # as many as there may be: links come and go, parameters stay
        facts = Facts(
            spring=float(network.spring[slot, other]),
            age=age,
            age_back=age,
            spread=_SPREAD,
            period=longest,
            mass=self.mass,
            lightest=self.lightest,
            degree=most,
            degree_back=most,
            tree=tree,
            rows=self.rows,
        )
        return np.array(self.law.values(facts, {**given, FORCE: session.options.force_limit}))

    def link(
        self, source: Link, memory: CopyMemory, *, slot: int, other: int, copies: int, newcomer: bool = False
    ) -> LawLink:
        """An end that believes a neighbour no more than the session's power limit.

        Args:
            source: of samples.
            memory: of the copy.
            slot: of this end.
            other: of the other end.
            copies: N.
            newcomer: whether the one at the other end has just come to where this one is.
        """
        return LawLink(
            source,
            law=self.law,
            parameters=self.parameters(slot, other),
            memory=memory,
            side=int(slot > other),
            copies=copies,
            power=self.session.options.power_limit,
            patience=PATIENCE if newcomer else 0.0,
        )
