"""What a device without motors can do."""

import math

from cotouch.device import DeviceSpec

PASSIVE = DeviceSpec(
    name="gamepad",
    force=0.0,
    continuous_force=0.0,
    workspace=0.1,
    stiffness=1000.0,
    damping=10.0,
    resolution=0.1 / 128,
    rate=250.0,
    degrees_of_freedom=3,
    actuated=0,
    mass=0.0,
    friction=0.0,
    source="ours; the position is where the sticks lead a point, the rate that of common pads",
)
"""A gamepad has no motors that push a hand; rumble is none. Any spring is rendered equally well, namely not at all."""
UNSAID = (math.nan, math.nan, math.nan)
"""Force of such a device: nobody knows what its hand would have held against, so the servo books what it told."""
