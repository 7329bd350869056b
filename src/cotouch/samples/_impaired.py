"""A transport with a worse network on top, to try a network on one machine."""

import heapq
from collections.abc import Callable, Hashable, Mapping
from typing import final

import numpy as np

from cotouch.samples._emulated_path import EmulatedPath, PathLaw
from cotouch.samples._transport import MOST_BYTES, Arrival, Traffic, Transport

# What a path with a queue of its own could hold at most; beyond it the oldest is lost.
_MOST_WAITING = 100_000


@final
class ImpairedTransport:
    """Delays, loses and duplicates what is sent, by a law for each neighbour; see `Transport`.

    What is due leaves at the next call. Delays are exact for whoever polls once `due` has come, else longer by up to
    the time between two calls.
    """

    def __init__(
        self,
        transport: Transport,
        laws: Mapping[int, PathLaw],
        *,
        clock: Callable[[], float],
        seed: int = 0,
    ) -> None:
        """Puts laws on top of a transport.

        Args:
            transport: that carries the datagrams; closed with this one.
            laws: of the direction to each neighbour; others are left alone.
            clock: the transport's [s].
            seed: of all fates.
        """
        self._transport = transport
        self._clock = clock
        self._seed = seed
        self._paths: dict[int, EmulatedPath] = {}
        self._waiting: list[tuple[float, int, int, bytes]] = []
        self._count = 0
        for neighbour, law in laws.items():
            self.set(neighbour, law)

    def set(self, neighbour: int, law: PathLaw) -> None:
        """Changes the law of the direction to a neighbour; what is on its way keeps its time.

        Args:
            neighbour: slot of the neighbour.
            law: delay, jitter, loss and order of the path.
        """
        if neighbour in self._paths:
            self._paths[neighbour].law = law
        else:
            self._paths[neighbour] = EmulatedPath(law, np.random.default_rng([self._seed, neighbour]))

    @property
    def due(self) -> float:
        """When the next datagram is to leave; inf: none waits [s]."""
        return self._waiting[0][0] if self._waiting else float("inf")

    def law(self, neighbour: int) -> PathLaw:
        """The law of the direction to a neighbour."""
        path = self._paths.get(neighbour)
        return PathLaw() if path is None else path.law

    @property
    def traffic(self) -> Traffic:
        """What went through the transport below."""
        return self._transport.traffic

    def send(self, neighbour: int, payload: bytes) -> bool:
        """Takes a datagram on its way; True also if it is going to be lost there.

        Args:
            neighbour: slot of the neighbour.
            payload: the datagram.
        """
        path = self._paths.get(neighbour)
        if path is None or len(payload) > MOST_BYTES:
            return self._transport.send(neighbour, payload)
        now = self._clock()
        for time in path.arrivals(now, len(payload)):
            self._count += 1
            if len(self._waiting) < _MOST_WAITING:
                heapq.heappush(self._waiting, (time, self._count, neighbour, payload))
        self._leave(now)
        return True

    def capacity(self, neighbour: int) -> float:
        """Datagrams per second that the way to a neighbour is to be given at most."""
        return self._transport.capacity(neighbour)

    def poll(self) -> list[Arrival]:
        """Everything that arrived since the last call."""
        self._leave(self._clock())
        return self._transport.poll()

    def follow(self, neighbour: int, source: Hashable) -> None:
        """From now on the neighbour is there.

        Args:
            neighbour: slot of the neighbour.
            source: where it came from.
        """
        self._transport.follow(neighbour, source)

    def forget(self, neighbour: int) -> None:
        """The neighbour left; what is on its way to it is lost."""
        self._waiting = [entry for entry in self._waiting if entry[2] != neighbour]
        heapq.heapify(self._waiting)
        self._transport.forget(neighbour)

    def close(self) -> None:
        """Closes the transport below."""
        self._waiting.clear()
        self._transport.close()

    def _leave(self, now: float) -> None:
        waiting = self._waiting
        while waiting and waiting[0][0] <= now:
            _, _, neighbour, payload = heapq.heappop(waiting)
            self._transport.send(neighbour, payload)
