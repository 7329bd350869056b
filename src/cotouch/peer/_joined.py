"""A copy's links as its steps go through them."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple, final

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
        raise NetworkError("links with a law and links without one, or with weights that couple rows, cannot be mixed")
    links = Links(
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


@final
class JoinedLinks:
    """A copy's links, which come and go between its steps.

    Attributes:
        neighbours: users they go to.
        sources: of each link's samples.
        kernel: the links for the kernels.
        ends: the links, one by one.
        guarded: those with a guard, beside it.
        laws: the laws of those that have one.
        work: what each did on the copy in the last step, (links,) [J].
    """

    def __init__(
        self,
        model: Model,
        position: Float,
        links: Mapping[int, Link],
        strength: Sequence[float],
        weight: Sequence[int],
    ) -> None:
        """Joins the first ones, relaxed.

        Args:
            model: the body.
            position: of the copy, (rows, width) [m].
            links: for each neighbour, how its samples are chosen.
            strength: spring of each link [N/m for the identity weight].
            weight: index of each link's weight.

        Raises:
            NetworkError: see `joined`.
        """
        self._model = model
        self._hold(position, tuple(links), tuple(links.values()), strength, weight, {})

    def connect(self, position: Float, neighbour: int, link: Link, *, strength: float, weight: int) -> None:
        """Adds one, relaxed; see `Peer.connect`.

        Args:
            position: of the copy, (rows, width) [m].
            neighbour: index of the user.
            link: how its samples are chosen.
            strength: of the spring [N/m for the identity weight].
            weight: index among the model's.

        Raises:
            NetworkError: there is no such weight, or the link does not go with the others.
        """
        weights = self._model.operator.weight.shape[0]
        if not (0 <= weight < weights and 0.0 <= strength < np.inf):
            raise NetworkError(
                f"a link has strength {strength:g} and weight {weight}; it takes a finite strength >= 0 and a weight "
                f"from 0 to {weights - 1}"
            )
        self._hold(
            position,
            (*self.neighbours, neighbour),
            (*self.sources, link),
            (*(end.spring for end in self.ends), strength),
            (*(end.weight for end in self.ends), weight),
            self._held(),
        )

    def disconnect(self, position: Float, neighbour: int) -> None:
        """Lets one go; nothing, where there is none.

        Args:
            position: of the copy, (rows, width) [m].
            neighbour: index of the user.
        """
        if neighbour not in self.neighbours:
            return
        kept = [(other, end) for other, end in zip(self.neighbours, self.ends, strict=True) if other != neighbour]
        self._hold(
            position,
            tuple(other for other, _ in kept),
            tuple(end.source for _, end in kept),
            [end.spring for _, end in kept],
            [end.weight for _, end in kept],
            self._held(),
        )

    def share(self, spare: float) -> None:
        """Lets guards that cannot follow have what other links, and the copy's own damping, can spare.

        Args:
            spare: of the damping [J].
        """
        starved = [guard for guard, _ in self.guarded if guard.starved]
        if starved:
            spare += sum(guard.donate() for guard, _ in self.guarded)
            for guard in starved:
                guard.help(spare / len(starved))

    def _held(self) -> dict[int, Float]:
        """Set positions, by neighbour."""
        return {other: end.place.copy() for other, end in zip(self.neighbours, self.ends, strict=True)}

    def _hold(
        self,
        position: Float,
        neighbours: tuple[int, ...],
        sources: tuple[Link, ...],
        strength: Sequence[float],
        weight: Sequence[int],
        held: Mapping[int, Float],
    ) -> None:
        """Takes these and no others."""
        self.kernel, self.ends = joined(self._model, position, neighbours, sources, strength, weight, held)
        self.neighbours, self.sources, self.work = neighbours, sources, np.zeros(len(sources))
        self.guarded = [(end.guard, end) for end in self.ends if end.guard is not None]
        self.laws = [end.law for end in self.ends if end.law is not None]
