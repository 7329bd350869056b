"""What products can do, as far as is published or in common use; all numbers are nominal."""

from dataclasses import dataclass
from typing import final

from cotouch.errors import DeviceError


@final
@dataclass(frozen=True, kw_only=True)
class DeviceSpec:
    """Limits of a device, SI.

    Attributes:
        name: of the product.
        force: largest force [N].
        continuous_force: that it can hold for long [N].
        workspace: radius of a ball inside the workspace [m].
        stiffness: largest that is rendered well [N/m].
        damping: largest that is rendered well [Ns/m].
        resolution: of the tip's place [m].
        rate: of its servo [Hz].
        degrees_of_freedom: measured.
        actuated: degrees of freedom that have motors.
        mass: apparent at the tip [kg]; assumed where nobody published it.
        friction: Coulomb, at the tip [N]; likewise.
        source: where the numbers come from.
        torque: largest torque; 0: it renders none [Nm].
        continuous_torque: that it can hold for long [Nm].
        turning_stiffness: largest of turning that is rendered well [Nm/rad].
        turning_damping: likewise [Nms/rad].
        turning_resolution: of the handle's orientation [rad].
    """

    name: str
    force: float
    continuous_force: float
    workspace: float
    stiffness: float
    damping: float
    resolution: float
    rate: float
    degrees_of_freedom: int
    actuated: int
    mass: float
    friction: float
    source: str
    torque: float = 0.0
    continuous_torque: float = 0.0
    turning_stiffness: float = 0.0
    turning_damping: float = 0.0
    turning_resolution: float = 0.0


_CHAI3D = "force, workspace, stiffness, damping: CHAI3D; the rest assumed"

PRESETS: dict[str, DeviceSpec] = {
    "omega": DeviceSpec(
        name="Force Dimension omega.3",
        force=12.0,
        continuous_force=12.0,
        workspace=0.075,
        stiffness=5000.0,
        damping=30.0,
        resolution=1e-5,
        rate=1000.0,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.2,
        friction=0.1,
        source=_CHAI3D,
    ),
    "delta": DeviceSpec(
        name="Force Dimension delta.3",
        force=20.0,
        continuous_force=20.0,
        workspace=0.15,
        stiffness=5000.0,
        damping=30.0,
        resolution=2e-5,
        rate=1000.0,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.25,
        friction=0.15,
        source=_CHAI3D,
    ),
    "touch": DeviceSpec(
        name="3D Systems Touch",
        force=3.3,
        continuous_force=0.88,
        workspace=0.075,
        stiffness=400.0,
        damping=4.0,
        resolution=5.5e-5,
        rate=1000.0,
        degrees_of_freedom=6,
        actuated=3,
        mass=0.045,
        friction=0.26,
        source="force, workspace, stiffness, damping: CHAI3D; the rest assumed",
    ),
    "falcon": DeviceSpec(
        name="Novint Falcon",
        force=8.0,
        continuous_force=8.0,
        workspace=0.04,
        stiffness=3000.0,
        damping=20.0,
        resolution=6e-5,
        rate=1000.0,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.15,
        friction=0.2,
        source=_CHAI3D,
    ),
    "inverse3": DeviceSpec(
        name="Haply Inverse3",
        force=10.0,
        continuous_force=2.0,
        workspace=0.1,
        stiffness=2000.0,
        damping=10.0,
        resolution=1e-5,
        rate=4000.0,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.15,
        friction=0.1,
        source="rate of the service loop: Haply; continuous force: the lower of the caps in use; the rest assumed",
    ),
    "phantom": DeviceSpec(
        name="PHANToM 1.5",
        force=8.5,
        continuous_force=1.4,
        workspace=0.1,
        stiffness=3500.0,
        damping=5.0,
        resolution=3e-5,
        rate=1000.0,
        degrees_of_freedom=3,
        actuated=3,
        mass=0.05,
        friction=0.04,
        source="resolution, mass: Çavuşoğlu, Feygin & Tendick 2002; the rest assumed, forces nominal",
    ),
}
"""Specifications by short name; every one is nominal."""


def preset(name: str) -> DeviceSpec:
    """The nominal specification of a common product.

    Args:
        name: one of `PRESETS`.

    Raises:
        DeviceError: no such product.
    """
    if name not in PRESETS:
        raise DeviceError(f'device is "{name}"; it must be one of {", ".join(PRESETS)}')
    return PRESETS[name]
