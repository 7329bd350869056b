"""How the place that a hand draws to moves: smoothly, however seldom or suddenly somebody says where to."""

import math
from collections.abc import Sequence
from typing import final

import numpy as np

# Waves that a wandering place is the sum of, along each axis.
_WAVES = 3
_SLOWEST, _FASTEST = 0.04, 0.22  # [Hz]


@final
class Mover:
    """A place that follows a goal as a critically damped mass would, no faster than it may.

    Attributes:
        place: [m].
        rate: [m/s].
    """

    def __init__(self, axes: int) -> None:
        """Starts at rest, at 0.

        Args:
            axes: how many coordinates a place has.
        """
        self.place = [0.0] * axes
        self.rate = [0.0] * axes

    def put(self, place: Sequence[float]) -> None:
        """Puts it somewhere, at rest."""
        self.place = list(place)
        self.rate = [0.0] * len(self.place)

    def move(self, goal: Sequence[float], T: float, *, speed: float, sharpness: float) -> None:
        """Goes on for T, exactly as the equation of motion says if the goal stands still meanwhile.

        Args:
            goal: [m].
            T: [s].
            speed: that it never exceeds [m/s].
            sharpness: ω; it is about 2/ω late [1/s].
        """
        decay = math.exp(-sharpness * T)
        place, rate, square = self.place, self.rate, 0.0
        moves: list[float] = []
        for axis, aim in enumerate(goal):
            gap = place[axis] - aim
            push = (rate[axis] + sharpness * gap) * T
            move = (gap + push) * decay - gap
            rate[axis] = (rate[axis] - sharpness * push) * decay
            moves.append(move)
            square += move * move
        most = speed * T
        if square > most * most:
            share = most / math.sqrt(square)
            moves = [share * move for move in moves]
            self.rate = [move / T for move in moves]
        self.place = [here + move for here, move in zip(place, moves, strict=True)]


@final
class Wander:
    """A slow, smooth motion that never repeats itself soon, the same for the same seed."""

    def __init__(self, axes: int, *, reach: float, seed: int) -> None:
        """Chooses the waves.

        Args:
            axes: how many coordinates.
            reach: greatest distance along each axis [m].
            seed: of frequencies and phases.
        """
        rng = np.random.default_rng([2010, seed])
        turn = 2.0 * math.pi
        self._waves = [
            [(turn * float(rng.uniform(_SLOWEST, _FASTEST)), float(rng.uniform(0.0, turn))) for _ in range(_WAVES)]
            for _ in range(axes)
        ]
        self._reach = reach / _WAVES

    def at(self, time: float) -> list[float]:
        """Where it is, from its middle, (axes,) [m].

        Args:
            time: [s].
        """
        return [self._reach * sum(math.sin(f * time + p) for f, p in waves) for waves in self._waves]
