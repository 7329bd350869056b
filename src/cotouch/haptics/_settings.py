"""What the processes around a device are told when they start: one line of JSON."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any, final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._ends import EndOptions, Law
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._registry import DeviceChoice, Option
from cotouch.haptics._virtual import virtual_limit

# A servo that is told nothing else runs at the device's rate, but not above this [Hz].
MOST_RATE = 1000.0
# What a choice may say of the coupling, beside the options of its driver.
COUPLING: Mapping[str, str] = {
    "coupling": "pspm, or virtual for a plain spring and damper where the device's own friction allows it",
    "stiffness": "of the coupling [N/m]",
    "damping": "of the coupling [Ns/m]",
    "friction": "viscous, that the device itself has for certain; with coupling=virtual [Ns/m]",
    "ages": "of the places that both ends know of each other, together; with coupling=virtual, 0.01 [s]",
    "weight": "more lets the device pay for old places, less the proxy; with coupling=virtual, 1",
}
_LAWS: Mapping[str, Law] = {"pspm": "pspm", "virtual": "virtual"}
_OF_VIRTUAL = ("friction", "ages", "weight")


@final
@dataclass(frozen=True, kw_only=True)
class ServoSettings:
    """How a device is to be driven.

    Attributes:
        device: which one.
        folder: private one of the boards.
        stiffness: of the coupling; None: 500 N/m, or what the device renders well, or is passive with a virtual
            coupling, if that is less [N/m].
        damping: of the coupling; None: 2 Ns/m, or what the device renders well if that is less; none with a virtual
            coupling [Ns/m].
        law: of the coupling; see `EndOptions`.
        friction: of the device itself, for a virtual coupling [Ns/m].
        ages: of places, likewise [s].
        weight: of the age rule, likewise.
        limits: safety limits other than the default, by name; see `SafetyLimits`.
        rate: of the servo; None: the device's, at most 1 kHz [Hz].
        allow_motion: whether the device may move by itself to calibrate.
        real_time: priority under SCHED_FIFO where it is permitted; None: do not ask.
    """

    device: DeviceChoice
    folder: Path
    stiffness: float | None = None
    damping: float | None = None
    law: Law = "pspm"
    friction: float = EndOptions().friction
    ages: float = EndOptions().ages
    weight: float = EndOptions().weight
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
        return cls(device=DeviceChoice(device["name"], options), folder=Path(values.pop("folder")), **values)

    def end_options(self, spec: DeviceSpec) -> EndOptions:
        """The coupling, for a device.

        Raises:
            DeviceError: a safety limit or the rate is out of range, or an option of a virtual coupling.
        """
        usual = EndOptions()
        stiffness = min(usual.stiffness, spec.stiffness)
        if self.law == "pspm":
            return usual._replace(
                stiffness=stiffness if self.stiffness is None else self.stiffness,
                damping=min(usual.damping, spec.damping) if self.damping is None else self.damping,
            )
        options = usual._replace(
            law=self.law,
            stiffness=stiffness,
            damping=0.0 if self.damping is None else self.damping,
            friction=self.friction,
            ages=self.ages,
            weight=self.weight,
            most=self.safety(spec).force,
        )
        if self.stiffness is None:
            limit = virtual_limit(options, period=self.period(spec))
            return options._replace(stiffness=min(stiffness, limit) if limit > 0.0 else stiffness)
        return options._replace(stiffness=self.stiffness)

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


def coupling_of(choice: DeviceChoice) -> tuple[DeviceChoice, dict[str, Any]]:
    """Takes what a choice says of the coupling out of it.

    Args:
        choice: such as `haply:coupling=virtual,friction=0.8`.

    Returns:
        What is left for the driver, and what was said, by the names of `ServoSettings`.

    Raises:
        DeviceError: it is no coupling that there is, no number, or has no effect with this law.
    """
    options = {key: value for key, value in choice.options.items() if key not in COUPLING}
    said = {key: value for key, value in choice.options.items() if key in COUPLING}
    law = said.pop("coupling", "pspm")
    if law not in _LAWS:
        raise DeviceError(f'coupling is "{law}"; it must be one of {", ".join(_LAWS)}')
    found: dict[str, Any] = {"law": law}
    for name, value in said.items():
        if isinstance(value, str | bool) or not (isfinite(value) and value >= 0.0):
            raise DeviceError(f"the coupling's {name} is {value}; it must be a number of at least 0")
        if law == "pspm" and name in _OF_VIRTUAL:
            raise DeviceError(f"{name} is given, but with coupling=pspm it has no effect; leave it out")
        found[name] = float(value)
    return DeviceChoice(choice.name, options), found


def spec_from(values: dict[str, Any]) -> DeviceSpec:
    """A device's limits from what was said of them."""
    return DeviceSpec(**values)
