"""What the processes around a device are told when they start: one line of JSON."""

import json
from dataclasses import asdict, dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any, final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._coupling import CouplingChoice
from cotouch.haptics._ends import EndOptions
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._registry import DeviceChoice, Option
from cotouch.haptics._turning import ARM, at_arm

# A servo runs at the device's rate, but not above this [Hz].
MOST_RATE = 1000.0
# What is said of them counts for torques as well; a speed is that at the arm.
_ALIKE = frozenset({"rise", "ramp", "fade_after", "zero_after", "speed", "heat"})


@final
@dataclass(frozen=True, kw_only=True)
class ServoSettings:
    """How to drive a device.

    Attributes:
        device: which one.
        folder: private one of the mailboxes.
        coupling: what was said of it.
        limits: safety limits other than the default, by name; see `SafetyLimits`; and `torque` [Nm].
        real_time: priority under SCHED_FIFO where it is permitted; None: do not ask.
    """

    device: DeviceChoice
    folder: Path
    coupling: CouplingChoice = field(default_factory=CouplingChoice)
    limits: dict[str, float] = field(default_factory=dict[str, float])
    real_time: int | None = 20

    def line(self) -> str:
        """As one line."""
        return json.dumps(asdict(self) | {"folder": str(self.folder)}) + "\n"

    @classmethod
    def read(cls, line: str) -> "ServoSettings":
        """From one line."""
        values: dict[str, Any] = json.loads(line)
        device: dict[str, Any] = values.pop("device")
        options: dict[str, Option] = device["options"]
        return cls(
            device=DeviceChoice(device["name"], options),
            folder=Path(values.pop("folder")),
            coupling=CouplingChoice(**values.pop("coupling")),
            **values,
        )

    def end_options(self, spec: DeviceSpec) -> EndOptions:
        """The coupling, for a device.

        Raises:
            DeviceError: a safety limit or the rate is out of range, or the coupling does not fit the device.
        """
        return self.coupling.options(spec, period=self.period(spec), force=self.safety(spec).force)

    def turning_options(self, spec: DeviceSpec) -> EndOptions | None:
        """The coupling of turning, for a device; None for one that renders no torque.

        Raises:
            DeviceError: as of `end_options`.
        """
        limits = self.turning_safety(spec)
        torque = 0.0 if limits is None else ARM * limits.force
        return self.coupling.turning(spec, period=self.period(spec), torque=torque)

    def safety(self, spec: DeviceSpec) -> SafetyLimits:
        """The limits, for a device.

        Raises:
            DeviceError: one of them is beyond what is safe.
        """
        return SafetyLimits.of(spec, **{name: value for name, value in self.limits.items() if name != "torque"})

    def turning_safety(self, spec: DeviceSpec) -> SafetyLimits | None:
        """The limits of torques, as of forces at the arm; None for a device that renders none.

        Raises:
            DeviceError: one of them is beyond what is safe.
        """
        torque = self.limits.get("torque")
        if spec.torque <= 0.0:
            if torque is not None:
                raise DeviceError(f"the safety limit torque is {torque} Nm, but {spec.name} renders no torque")
            return None
        alike = {name: value for name, value in self.limits.items() if name in _ALIKE}
        if torque is None:
            return SafetyLimits.of(at_arm(spec), **alike)
        if not (isfinite(torque) and 0.0 <= torque <= spec.torque):
            raise DeviceError(
                f"the safety limit torque is {torque:g} Nm; for this device it must be at least 0 and at most "
                f"{spec.torque:g}"
            )
        return SafetyLimits.of(at_arm(spec), force=torque / ARM, **alike)

    def period(self, spec: DeviceSpec) -> float:
        """Of the servo [s].

        Raises:
            DeviceError: the rate is out of range.
        """
        rate = min(spec.rate, MOST_RATE)
        if not 100.0 <= rate <= 4000.0:
            raise DeviceError(f"the servo's rate is {rate:g} Hz; it must be from 100 to 4000 Hz")
        return 1.0 / rate
