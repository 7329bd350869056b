"""Peers of a scenario, with a look at each after every step."""

from collections.abc import Callable

from tests.simulation.inside import World

from cotouch.peer import Peer, Sample, StepReport
from cotouch.simulation import Prepared


class Stepped:
    """Runs a scenario peer by peer.

    Attributes:
        peers: as they are now.
    """

    def __init__(self, prepared: Prepared) -> None:
        self._world = World(prepared)
        self.peers: list[Peer] = self._world.peers

    def run(self, after: Callable[[Peer, StepReport, float, float], None]) -> None:
        """To the end; after every step: whose, its report, its end [s] and its length [s]."""
        world = self._world
        step = world._step

        def looked_at(peer: Peer, now: float, T: float) -> Sample:
            sample = step(peer, now, T)
            after(peer, world.reports[peer.index][-1], now, T)
            return sample

        world._step = looked_at  # type: ignore[method-assign]
        world.run()
