"""Frames of devices, and what makes them ours: x forward, y left, z up; metres."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import DeviceError


@final
@dataclass(frozen=True)
class DeviceFrame:
    """How a device's axes lie in cotouch's frame.

    Attributes:
        rows: our x, y and z in the device's axes, as signed numbers of axes: (2, -1, 3) says that our x is its second
            axis, our y its first turned round, our z its third.
        unit: of its lengths [m].

    Raises:
        DeviceError: the axes are no right-handed frame, or the unit is not above 0.
    """

    rows: tuple[int, int, int]
    unit: float = 1.0

    def __post_init__(self) -> None:
        if sorted(abs(row) for row in self.rows) != [1, 2, 3] or np.linalg.det(self.matrix) < 0.0:
            raise DeviceError(
                f"axes are {self.rows}; they must be 1, 2 and 3 with signs that leave the frame right-handed"
            )
        if not 0.0 < self.unit < float("inf"):
            raise DeviceError(f"unit is {self.unit:g} m; it must be finite and above 0")

    @property
    def matrix(self) -> Float:
        """Turns the device's directions into ours, (3, 3); its determinant is +1."""
        turned = np.zeros((3, 3))
        for row, axis in enumerate(self.rows):
            turned[row, abs(axis) - 1] = 1.0 if axis > 0 else -1.0
        return turned

    def place(self, theirs: Sequence[float] | Float) -> Float:
        """A place or a velocity of the device, (3,), in ours [m or m/s]."""
        return self.unit * self.direction(theirs)

    def direction(self, theirs: Sequence[float] | Float) -> Float:
        """A force or a direction of the device, (3,), in ours; its unit stays."""
        return np.array([theirs[axis - 1] if axis > 0 else -theirs[-axis - 1] for axis in self.rows], dtype=np.float64)

    def back(self, ours: Sequence[float] | Float) -> Float:
        """A force or a direction of ours, (3,), in the device's; its unit stays."""
        theirs = np.zeros(3)
        for value, axis in zip(ours, self.rows, strict=True):
            theirs[abs(axis) - 1] = value if axis > 0 else -value
        return theirs

    def orientation(self, theirs: Sequence[float] | Float) -> Float:
        """A quaternion xyzw that turns in the device's axes, (4,), as one that turns in ours."""
        x, y, z, w = theirs
        return np.array([*self.direction((x, y, z)), w])


OURS = DeviceFrame((1, 2, 3))
"""x forward, y left, z up; m."""
HAPLY_FRAME = DeviceFrame((2, -1, 3))
"""Inverse Service: x right, y forward, z up; m."""
OPENHAPTICS_FRAME = DeviceFrame((-3, -1, 2), 1e-3)
"""x right, y up, z towards the user; mm."""
FORCE_DIMENSION_FRAME = DeviceFrame((-1, -2, 3))
"""x towards the operator, y right, z up; m."""
OPENXR_FRAME = DeviceFrame((-3, -1, 2))
"""x right, y up, z backward; m."""
FRAMES = {
    "ours": OURS,
    "haply": HAPLY_FRAME,
    "openhaptics": OPENHAPTICS_FRAME,
    "force_dimension": FORCE_DIMENSION_FRAME,
    "openxr": OPENXR_FRAME,
}
"""All frames by name."""
