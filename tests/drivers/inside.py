"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.drivers._dhd import count
from cotouch.drivers._dhd_systems import SPECS, SYSTEMS
from cotouch.drivers._force_dimension import ForceDimension
from cotouch.drivers._gamepad import Gamepad
from cotouch.drivers._inverse import Inverse3
from cotouch.drivers._inverse_aside import halt, holders, present
from cotouch.drivers._inverse_frame import Grip, grip_of, read_event, read_state
from cotouch.drivers._inverse_session import deviations
from cotouch.drivers._library import _versioned as versioned
from cotouch.drivers._recorded import RecordedHand
from cotouch.drivers._rotation import quaternion_of
from cotouch.drivers._touch import _ALIVE as alive
from cotouch.drivers._touch import Touch
from cotouch.drivers._touch import _quaternion as quaternion

__all__ = [
    "SPECS",
    "SYSTEMS",
    "ForceDimension",
    "Gamepad",
    "Grip",
    "Inverse3",
    "RecordedHand",
    "Touch",
    "alive",
    "count",
    "deviations",
    "grip_of",
    "halt",
    "holders",
    "present",
    "quaternion",
    "quaternion_of",
    "read_event",
    "read_state",
    "versioned",
]
