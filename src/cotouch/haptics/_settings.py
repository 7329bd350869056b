"""What the processes around a device are told when they start: one line of JSON."""

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._coupling import CouplingChoice
from cotouch.haptics._ends import EndOptions
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._registry import DeviceChoice, Option

# A servo that is told nothing else runs at the device's rate, but not above this [Hz].
MOST_RATE = 1000.0


@final
@dataclass(frozen=True, kw_only=True)
class ServoSettings:
    """How a device is to be driven.

    Attributes:
        device: which one.
        folder: private one of the mailboxes.
        coupling: what was said of it.
        limits: safety limits other than the default, by name; see `SafetyLimits`.
        rate: of the servo; None: the device's, at most 1 kHz [Hz].
        allow_motion: whether the device may move by itself to calibrate.
        real_time: priority under SCHED_FIFO where it is permitted; None: do not ask.
    """

    device: DeviceChoice
    folder: Path
    coupling: CouplingChoice = field(default_factory=CouplingChoice)
    limits: dict[str, float] = field(default_factory=dict[str, float])
    rate: float | None = None
    allow_motion: bool = False
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

    def safety(self, spec: DeviceSpec) -> SafetyLimits:
        """The limits, for a device.

        Raises:
            DeviceError: one of them is beyond what is safe.
        """
        return SafetyLimits.of(spec, **self.limits)

    def period(self, spec: DeviceSpec) -> float:
        """Of the servo [s].

        Raises:
            DeviceError: the rate is out of range.
        """
        rate = min(spec.rate, MOST_RATE) if self.rate is None else self.rate
        if not 100.0 <= rate <= 4000.0:
            raise DeviceError(f"the servo's rate is {rate:g} Hz; it must be from 100 to 4000 Hz")
        return 1.0 / rate


def spec_from(values: dict[str, Any]) -> DeviceSpec:
    """A device's limits from what was said of them."""
    return DeviceSpec(**values)
