"""How the orientation that a hand leads to turns, in quaternions xyzw."""

from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.body import turn_vectors
from cotouch.hands._motion import Mover
from cotouch.haptics import UNTURNED, Quaternion, back, product, turn_of, vector_of


def nearest_to(matrix: Float) -> Quaternion:
    """Of the rotation that is nearest to a matrix, (3, 3)."""
    return turn_of(turn_vectors(matrix[None])[0].tolist())


def turned(a: Quaternion, vectors: Float) -> Float:
    """Vectors, turned.

    Args:
        a: how.
        vectors: (V, 3).
    """
    x, y, z, w = a
    axis = np.array([x, y, z])
    across = 2.0 * np.cross(axis, vectors)
    result: Float = vectors + w * across + np.cross(axis, across)
    return result


@final
class Turner:
    """An orientation that follows a goal the shortest way, as a `Mover` follows a place.

    Attributes:
        turn: from the start.
    """

    def __init__(self) -> None:
        """Starts at rest, not turned."""
        self.turn = UNTURNED
        self._mover = Mover(3)

    def put(self, turn: Quaternion) -> None:
        """Turns it so, at rest."""
        self.turn = turn
        self._mover.put([0.0, 0.0, 0.0])

    def move(self, goal: Quaternion, T: float, *, speed: float, sharpness: float, rush: float) -> None:
        """Goes on for T.

        Args:
            goal: how it is to be turned.
            T: [s].
            speed: that it does not go on to exceed [rad/s].
            sharpness: as of `Mover.move` [1/s].
            rush: greatest angular acceleration [rad/s²].
        """
        here, mover = self.turn, self._mover
        # From step to step: a rotation vector from the start would leap where that is half a turn.
        mover.place = [0.0, 0.0, 0.0]
        way = vector_of(product(goal, back(here)))
        mover.move(way, T, speed=speed, sharpness=sharpness, rush=rush)
        self.turn = product(turn_of(mover.place), here)
