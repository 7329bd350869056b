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

    def move(self, goal: Sequence[float], T: float, *, speed: float, sharpness: float, rush: float) -> None:
        """Goes on for T, exactly as the equation of motion says where speed and acceleration allow it.

        Args:
            goal: [m].
            T: [s].
            speed: that it does not go on to exceed [m/s].
            sharpness: ω; it is about 2/ω late [1/s].
            rush: greatest acceleration [m/s²].
        """
        decay = math.exp(-sharpness * T)
        gaps = [here - aim for here, aim in zip(self.place, goal, strict=True)]
        pushes = [(r + sharpness * g) * T for g, r in zip(gaps, self.rate, strict=True)]
        free = [((g + p) * decay - g) / T for g, p in zip(gaps, pushes, strict=True)]  # mean rate of the step
        # No faster than it can brake before the goal, with half of what it may.
        slow = _shortened(free, min(speed, math.sqrt(rush * _length(gaps))))
        wanted = [s - r for s, r in zip(slow, self.rate, strict=True)]
        change = _shortened(wanted, rush * T)
        if slow is free and change is wanted:
            self.rate = [(r - sharpness * p) * decay for r, p in zip(self.rate, pushes, strict=True)]
        else:
            free = self.rate = [r + c for r, c in zip(self.rate, change, strict=True)]
        self.place = [here + r * T for here, r in zip(self.place, free, strict=True)]


def _length(vector: Sequence[float]) -> float:
    return math.sqrt(sum(x * x for x in vector))


def _shortened(vector: list[float], most: float) -> list[float]:
    length = _length(vector)
    return vector if length <= most else [most / length * x for x in vector]


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
