"""A copy's links as its steps go through them."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.mechanics import WEIGHTS, Links, Model
from cotouch.peer._guard import LinkGuard
from cotouch.peer._law_link import LawLink
from cotouch.peer._links import Link


class LinkEnd(NamedTuple):
    """One link of a copy.

    Attributes:
        source: which sample a step uses.
        guard: None without one.
        law: what the link does; None for a spring.
        place: where it pulls to, (rows, width) [m].
        spring: K [N/m for the identity weight].
        weight: index of its weight among the model's.
        diagonal: of the weight, the same in any number of copies; None where it couples rows.
    """

    source: Link
    guard: LinkGuard | None
    law: LawLink | None
    place: Float
    spring: float
    weight: int
    diagonal: Float | None


def joined(
    model: Model,
    position: Float,
    neighbours: Sequence[int],
    sources: Sequence[Link],
    strength: Sequence[float],
    weight: Sequence[int],
    held: Mapping[int, Float],
) -> tuple[Links, list[LinkEnd]]:
    """The links for the kernels, and one by one; the place after theirs is for the copy's own sample.

    Args:
        model: the body.
        position: of the copy; where what is new starts, (rows, width) [m].
        neighbours: user of each link.
        sources: of each link's samples.
        strength: spring of each link [N/m for the identity weight].
        weight: index of each link's weight.
        held: where links that there were before pull to, by neighbour.

    Raises:
        NetworkError: only some of the links have a law, or one with a law has a weight that couples rows.
    """
    count, operator = len(sources), model.operator
    samples = np.zeros((count + 1, *position.shape))
    for at, other in enumerate(neighbours):
        samples[at] = held.get(other, position)
    mixed = [bool(np.any(mix)) for mix in operator.mix[WEIGHTS:]]
    laws = [source for source in sources if isinstance(source, LawLink)]
    if laws and (len(laws) < count or any(mixed[w] for w in weight)):
        raise NetworkError("links with a law and links without one, or with weights that couple rows, do not mix")
    links = Links(
        first=0,
        last=count,
        strength=np.array(strength, dtype=np.float64),
        weight=np.asarray(weight, dtype=np.int32),
        slot=np.arange(count, dtype=np.int64),
        samples=samples,
        brake=np.zeros(len(laws)),
        push=np.zeros((len(laws), *position.shape)),
    )
    ends = [
        LinkEnd(
            source=source,
            guard=source if isinstance(source, LinkGuard) else None,
            law=source if isinstance(source, LawLink) else None,
            place=samples[at],
            spring=float(strength[at]),
            weight=int(weight[at]),
            diagonal=None if mixed[weight[at]] else operator.weight[weight[at]],
        )
        for at, source in enumerate(sources)
    ]
    for at, end in enumerate(ends):
        if end.guard is not None:
            end.guard.attach(end.spring)
        if end.law is not None and end.diagonal is not None:
            place = (at, count)
            end.law.attach(spring=end.spring, place=place, weight=end.diagonal, target=end.place, push=links.push[at])
    return links, ends
