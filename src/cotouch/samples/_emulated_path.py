"""What a path does to datagrams, one at a time; for tests and emulated networks. The generator is handed in."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.errors import SessionError


@final
@dataclass(frozen=True, kw_only=True)
class PathLaw:
    """The law of one direction of a path.

    Attributes:
        delay: of every datagram [s].
        jitter: further delay, uniform between 0 and this [s].
        loss: probability that a datagram is lost, by itself.
        duplication: probability that it arrives a second time, with its own jitter.
        reordering: probability that it is held back by `hold`.
        hold: [s].
        enter: probability, at every datagram, that a burst of losses begins.
        leave: probability, at every datagram, that it ends.
        rate: of the slowest wire [B/s].
        queue: longest wait for that wire; what would wait longer is dropped [s].
        down: whether nothing goes through.
        further: delay of a datagram on top [s], from when it is sent after the first [s], and how many were sent before
            it: as it was measured on another path, say.
    """

    delay: float = 0.0
    jitter: float = 0.0
    loss: float = 0.0
    duplication: float = 0.0
    reordering: float = 0.0
    hold: float = 0.0
    enter: float = 0.0
    leave: float = 1.0
    rate: float = float("inf")
    queue: float = float("inf")
    down: bool = False
    further: Callable[[float, int], float] | None = None

    def __post_init__(self) -> None:
        for name in ("loss", "duplication", "reordering", "enter", "leave"):
            if not 0.0 <= getattr(self, name) <= 1.0:
                raise SessionError(f"{name} is {getattr(self, name)}; a probability is between 0 and 1")
        for name in ("delay", "jitter", "hold", "queue"):
            if not getattr(self, name) >= 0.0:
                raise SessionError(f"{name} is {getattr(self, name)} s; it must not be negative")
        if not self.rate > 0.0:
            raise SessionError(f"rate is {self.rate} B/s; it must be positive")


@final
class EmulatedPath:
    """One direction of a path with its memory: its burst, its first datagram, and how long its wire is occupied.

    Attributes:
        law: may be changed at any time.
    """

    def __init__(self, law: PathLaw, rng: np.random.Generator) -> None:
        self.law = law
        self._rng = rng
        self._burst = False
        self._first: float | None = None
        self._sent = 0
        self._free = -float("inf")

    def arrivals(self, now: float, size: int) -> tuple[float, ...]:
        """When a datagram sent now arrives: never, once, or twice.

        Args:
            now: [s].
            size: of the datagram [B].
        """
        law, rng = self.law, self._rng
        if self._first is None:
            self._first = now
        number, self._sent = self._sent, self._sent + 1
        if law.down:
            return ()
        if law.enter > 0.0:
            self._burst = rng.random() >= law.leave if self._burst else rng.random() < law.enter
            if self._burst:
                return ()
        if law.loss > 0.0 and rng.random() < law.loss:
            return ()
        out = max(now, self._free)
        if out - now > law.queue:
            return ()
        out += size / law.rate
        self._free = out
        out += law.delay
        if law.further is not None:
            out += law.further(now - self._first, number)
        first = out + (law.jitter * rng.random() if law.jitter > 0.0 else 0.0)
        if law.reordering > 0.0 and rng.random() < law.reordering:
            first += law.hold
        if law.duplication > 0.0 and rng.random() < law.duplication:
            return first, out + law.jitter * rng.random()
        return (first,)
