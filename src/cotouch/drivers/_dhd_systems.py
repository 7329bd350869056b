"""Products of Force Dimension by what dhdGetSystemType says, and what their SDK can make each do, nominally."""

from dataclasses import replace
from typing import NamedTuple, final

from cotouch.device import PRESETS, DeviceSpec

Triple = tuple[float, float, float]


@final
class System(NamedTuple):
    """One product.

    Attributes:
        family: omega, delta, sigma, lambda or falcon.
        product: its name.
        middle: of its workspace, in the vendor's axes [m].
        gripper: whether it has one in place of a button.
    """

    family: str
    product: str
    middle: Triple = (0.0, 0.0, 0.0)
    gripper: bool = False


# The middle of a sigma.7's workspace is 1 cm from its origin towards the user, and 2 cm to the side (CHAI3D).
_SIGMA_RIGHT: Triple = (0.01, -0.02, 0.0)
_SIGMA_LEFT: Triple = (0.01, 0.02, 0.0)
_RIGHT = System("sigma", "sigma.7", _SIGMA_RIGHT, gripper=True)
_LEFT = System("sigma", "sigma.7 left", _SIGMA_LEFT, gripper=True)
_LAMBDA, _LAMBDA_LEFT = System("lambda", "lambda.7", gripper=True), System("lambda", "lambda.7 left", gripper=True)

SYSTEMS: dict[int, System] = {
    33: System("omega", "omega.3"),
    110: System("omega", "omega.3"),
    34: System("omega", "omega.6"),
    36: System("omega", "omega.6 left"),
    35: System("omega", "omega.7", gripper=True),
    37: System("omega", "omega.7 left", gripper=True),
    63: System("delta", "delta.3"),
    111: System("delta", "delta.3"),
    64: System("delta", "delta.6"),
    206: System("sigma", "sigma.3"),
    133: System("sigma", "sigma.3"),
    115: System("sigma", "sigma.6"),
    116: System("sigma", "sigma.6 left"),
    **dict.fromkeys((104, 102, 209), _RIGHT),
    **dict.fromkeys((105, 103), _LEFT),
    106: System("sigma", "sigma.6 with pen"),
    107: System("sigma", "sigma.6 with pen, left"),
    203: System("lambda", "lambda.3"),
    131: System("lambda", "lambda.6"),
    132: System("lambda", "lambda.6 left"),
    **dict.fromkeys((108, 112, 114, *range(117, 131, 2), 210), _LAMBDA),
    **dict.fromkeys((109, 113, *range(118, 131, 2), 211), _LAMBDA_LEFT),
    60: System("falcon", "Falcon"),
}
"""Those of dhdc.h (3.17), and those that CHAI3D knows besides: revisions of the same products."""
UNKNOWN = System("omega", "device of unknown kind")

_SIGMA = "force, stiffness, damping: CHAI3D (sigma.7), which is less than the vendor says; the rest assumed"
_OF_LAMBDA = "force, damping, workspace: CHAI3D (lambda.7); stiffness that of the sigma; the rest assumed"
SPECS: dict[str, DeviceSpec] = {
    "omega": PRESETS["omega"],
    "delta": PRESETS["delta"],
    "falcon": PRESETS["falcon"],
    "sigma": replace(PRESETS["omega"], name="Force Dimension sigma", stiffness=4000.0, source=_SIGMA),
    "lambda": replace(
        PRESETS["omega"], name="Force Dimension lambda", stiffness=4000.0, workspace=0.1125, source=_OF_LAMBDA
    ),
}
"""By family; every one is nominal."""


def with_wrist(spec: DeviceSpec, family: str) -> DeviceSpec:
    """Limits of a device with motors in its wrist: those of CHAI3D but for the damping of a delta.6; the rest assumed.

    Args:
        spec: of the family.
        family: of `SPECS`.
    """
    return replace(
        spec,
        degrees_of_freedom=6,
        actuated=6,
        torque=0.2,
        continuous_torque=0.2,
        turning_stiffness=1.0,
        turning_damping=0.07,
        turning_resolution=7e-4 if family == "delta" else 2.3e-4,
    )
