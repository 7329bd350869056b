"""A device that a test leads, in place of the link to one."""

from dataclasses import dataclass, field

import numpy as np

from cotouch.coupling import EnergyMessage
from cotouch.device import PRESETS, DeviceSpec
from cotouch.haptics import Cause, CouplingChoice, EndOptions, Flag, ServoReport


@dataclass
class Led:
    """A device that goes where it is told, and never lets its energy out."""

    said: CouplingChoice = field(default_factory=CouplingChoice)
    spec: DeviceSpec = PRESETS["omega"]
    below: CouplingChoice | None = None
    place: np.ndarray = field(default_factory=lambda: np.array([0.01, -0.02, 0.03]))
    orders: list = field(default_factory=list)
    given: float = 0.0
    rate: tuple[float, float, float] = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] | None = None

    def couple(self, below: CouplingChoice) -> EndOptions:
        self.below = below
        return self.said.over(below).options(self.spec, period=1e-3, force=6.0)

    def read(self) -> ServoReport | None:
        self.given += 1e-3  # what a hand that moves puts in
        place = tuple(self.place.tolist())
        nothing = (0.0, 0.0, 0.0)
        word = EnergyMessage(given=self.given)
        return ServoReport(
            0.0, 1, place, self.rate, nothing, nothing, word, 0.0, 0.0, Cause(0), 0, Flag(0), 0, self.orientation
        )

    def order(self, place, word, *, enable=True) -> None:
        self.orders.append((place, word))
