"""What both laws of the coupling share at the device: the work of a held force, and the workspace's wall."""

from math import inf
from typing import NamedTuple, final

import numpy as np

from cotouch.coupling import REST_DRIFT, REST_FIELDS, modulate, place_at_rest, rest_fraction
from cotouch.haptics._safety import ZERO, Vector, dot, multiple, norm


class Did(NamedTuple):
    """What the motors did in a tick.

    Attributes:
        work: of the force that was told or that the device says, whichever costs more [J].
        charge: what encoder and levers may hide beside it [J].
        moved: how far the tip moved [m].
    """

    work: float
    charge: float
    moved: float


@final
class MotorPort:
    """Books forces that were held from one measured place to the next.

    Attributes:
        place: of the tip, as measured last; None: never [m].
    """

    def __init__(self, *, resolution: float, lever: float) -> None:
        """Has seen nothing.

        Args:
            resolution: of the tip's place [m].
            lever: shortest arm of the device, over which a held torque's force may turn unseen, > 0 [m].
        """
        self.place: Vector | None = None
        self.resolution = resolution
        self._lever = lever
        self._commanded, self._said, self._changed = ZERO, ZERO, 0.0

    def measure(self, place: Vector, commanded: Vector, said: Vector | None) -> Did | None:
        """Books the tick that has passed.

        Args:
            place: of the tip [m].
            commanded: force that acts from here on [N].
            said: what the device says that its motors do; None: nothing [N].

        Returns:
            None for the first.
        """
        did: Did | None = None
        if self.place is not None:
            moved = less(place, self.place)
            turned = 0.5 * norm(self._commanded) * dot(moved, moved) / self._lever
            work = max(dot(self._commanded, moved), dot(self._said, moved))
            did = Did(work, 0.5 * self.resolution * self._changed + turned, norm(moved))
        self._changed = sum(abs(a - b) for a, b in zip(commanded, self._commanded, strict=True))
        self.place, self._commanded = place, commanded
        self._said = commanded if said is None else said
        return did


@final
class Rest:
    """The tip's place as a law takes it; see `cotouch.mechanics.place_at_rest`.

    Attributes:
        drift: how much faster that place may move than the measured one [m/s].
    """

    def __init__(self, resolution: float, stiffness: float) -> None:
        """Moves.

        Args:
            resolution: of the tip's place [m].
            stiffness: of what pulls at it [N/m].
        """
        self._resolution, self._fraction = resolution, rest_fraction(stiffness, resolution)
        self.drift = REST_DRIFT * resolution * 3.0**0.5 if self._fraction < 1.0 else 0.0
        self._memory = np.zeros((3, REST_FIELDS))

    def place(self, measured: Vector, T: float) -> Vector:
        """The next.

        Args:
            measured: place of the tip [m].
            T: since the last one [s].
        """
        x, y, z = (
            place_at_rest(self._memory, row, one, self._resolution, self._fraction, T)
            for row, one in enumerate(measured)
        )
        return x, y, z


@final
class Wall:
    """A spring that leads back into the workspace, as far as there is energy for it.

    Attributes:
        energy: in the spring [J].
    """

    def __init__(self, radius: float, stiffness: float) -> None:
        """Holds nothing.

        Args:
            radius: beyond which it leads back [m].
            stiffness: [N/m].
        """
        self.stiffness = stiffness
        self.energy = 0.0
        self._radius = radius

    def pull(self, place: Vector, available: float) -> Vector:
        """Its force on the hand [N].

        Args:
            place: of the tip [m].
            available: energy that it may hold [J].
        """
        self.energy = 0.0
        out = norm(place)
        if out <= self._radius or self.stiffness <= 0.0:
            return ZERO
        deep = out - self._radius
        potential = 0.5 * self.stiffness * deep * deep
        part, _, _ = modulate(potential, available, inf)
        self.energy = part * part * potential
        return multiple(-part * self.stiffness * deep / out, place)


def plus(a: Vector, b: Vector) -> Vector:
    """Sum.

    Args:
        a: one, 3 numbers.
        b: the other, 3 numbers.
    """
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def less(a: Vector, b: Vector) -> Vector:
    """Difference.

    Args:
        a: one, 3 numbers.
        b: the other, 3 numbers.
    """
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
