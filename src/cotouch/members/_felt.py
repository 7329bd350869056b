"""What the law of a session's links makes of it: energy on its way or left over, and the drag that hands feel.

Hands put in what the law takes of the motion, ‖v̂‖² times its drag: by the damping B_i of all copies, and by links that
take more than they give. Whoever moves all N copies evenly together feels of springs
`Σ_i B_i + Σ_links K (T_ij + T_ji)`.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics import Tools
from cotouch.members._live_law import LiveLaw
from cotouch.members._messages import Status
from cotouch.members._neighbour import Neighbour
from cotouch.peer import StepReport

# Below 5 mm/s over the ten seconds that copies remember, nothing is measured [m²/s].
_LEAST = 10.0 * 0.005**2


@final
@dataclass(frozen=True, kw_only=True)
class LawFelt:
    """What is felt of a link law.

    Attributes:
        law: its name.
        on_the_way: what ends gave to others that these did not take yet; None: the law exchanges no energy [J].
        measured: drag of the last seconds, over the identity weight: of a point the drag that its hand feels, of other
            bodies that at each node; None: the copies hardly moved [Ns/m].
        predicted: likewise of copies that move evenly together, with the ages of now; None: nobody can say, as while
            only one end of a link is coupled.
    """

    law: str
    on_the_way: float | None
    measured: float | None
    predicted: float | None


def law_felt(known: Sequence[Status]) -> LawFelt | None:
    """What members together report of their law; None before any of them moves.

    Args:
        known: their last words.
    """
    moving = [status for status in known if status.steps]
    if not moving:
        return None
    law = moving[0].law
    taken = {(status.slot, link.slot): link.taken for status in moving for link in status.links}
    on_the_way = sum(
        max(link.given - taken[link.slot, status.slot], 0.0)
        for status in moving
        for link in status.links
        if (link.slot, status.slot) in taken
    )
    moved = sum(status.moved for status in moving) / len(moving)
    parts = [status.drag for status in moving if status.drag is not None]
    coupled = {(status.slot, link.slot) for status in moving for link in status.links if link.state == "coupled"}
    # Where one end of a spring counts its age and the other does not, the difference of their clocks is left.
    known_by_both = law != "spring" or coupled == {(there, here) for here, there in coupled}
    return LawFelt(
        law=law,
        on_the_way=None if law == "spring" else on_the_way,
        measured=sum(status.braked for status in moving) / moved if moved > _LEAST else None,
        predicted=sum(parts) if len(parts) == len(moving) and known_by_both else None,
    )


def margin_of(known: Sequence[Status]) -> float:
    """What hands could still take out of a session: what they put in, and what else there was [J].

    Below 0 they got out what nobody had put in. A body that fell below where it began has given its weight's work.

    Args:
        known: the last words of all members.
    """
    return sum(status.supplied + status.initial + status.initial_energies + status.depth for status in known)


def predicted_drag(
    damping: Float,
    neighbours: Mapping[int, Neighbour],
    link_age: Mapping[int, float],
    period: float,
    law: LiveLaw | None,
) -> float | None:
    """One copy's part of the drag; None where nobody can say [Ns/m].

    Args:
        damping: B_i, over the weights.
        neighbours: by slot.
        link_age: of their samples at the end of a step, by the clocks as they are [s].
        period: of the steps; forces act at mid-step in the mean [s].
        law: of the links; None: springs.
    """
    if law is not None:
        return float(damping[0]) if law.law.dragless else None
    if any(neighbour.weight for neighbour in neighbours.values()):
        return None
    # Each end counts the clocks' difference the other way round, so that of the sum nothing is left of it.
    return float(damping[0]) + sum(
        neighbour.strength * (link_age[slot] - 0.5 * period - neighbour.link.ahead)
        for slot, neighbour in neighbours.items()
        if neighbour.coupled and slot in link_age
    )


def force_felt(report: StepReport, tools: Tools | None) -> float:
    """Of the hands on a copy and on the proxies, as a whole [N].

    Args:
        report: of the step.
        tools: the proxies; None: none.
    """
    force = report.force.sum(axis=0)
    if tools is not None:
        force = force + tools.drive_force.sum(axis=0)[: force.size]
    return float(np.linalg.norm(force))
