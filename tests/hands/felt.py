"""A simulated device that renders torques, its servo's core, and a link to it, on one virtual clock."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from cotouch.coupling import EnergyMessage
from cotouch.device import PRESETS
from cotouch.haptics import (
    ARM,
    CouplingChoice,
    EndOptions,
    Order,
    SafetyLimits,
    ServoCore,
    ServoReport,
    SimulatedOnClock,
    at_arm,
    simulated_model,
)


@dataclass
class Felt:
    """A device whose servo ticks at 1 kHz between the steps of a peer; mailboxes may be late, or not read."""

    turn: float = 0.0
    hand: bool = True
    sweep: float = 0.0
    own: int = 0  # ticks for each read
    said: CouplingChoice = field(default_factory=CouplingChoice)
    late: int = 0
    loss: float = 0.0
    seed: int = 0
    reports: list[ServoReport] = field(default_factory=list)
    orders: list[Order] = field(default_factory=list)
    ticks: int = 0

    def __post_init__(self) -> None:
        self.now = 0.0
        model = simulated_model("cartesian", hand=self.hand, sweep=self.sweep)
        spec = SimulatedOnClock(model, PRESETS["phantom"], turn=self.turn, wrist=True, clock=lambda: self.now)
        self.device, self.spec = spec, spec.spec
        self.device.open()
        self.device.calibrate(allow_motion=False)
        self.device.enable_force()
        self.core = ServoCore(self.spec, SafetyLimits.of(self.spec), EndOptions())
        self.number, self.options = 0, EndOptions()
        self.turning: EndOptions | None = None
        self.force, self.torque = np.zeros(3), np.zeros(3)
        self.rng = np.random.default_rng(self.seed)

    def couple(self, below: CouplingChoice) -> EndOptions:
        self.options, self.number, self.turning = (
            self.said.over(below).options(self.spec, period=1e-3, force=4.0),
            1,
            None,
        )
        return self.options

    def couple_turning(self, below: CouplingChoice) -> EndOptions | None:
        torque = ARM * SafetyLimits.of(at_arm(self.spec)).force
        self.turning = self.said.over(below).turning(self.spec, period=1e-3, torque=torque)
        return self.turning

    def read(self) -> ServoReport | None:
        for _ in range(self.own):
            self.tick()
        known = [one for one in self.reports[: len(self.reports) - self.late] if one.coupling == self.number]
        return known[-1] if known else None

    def order(self, place: Any, message: EnergyMessage, **turned: Any) -> None:
        self.orders.append(
            Order(
                time=self.now, place=place, message=message, enable=True, coupling=self.number, options=self.options,
                turning=self.turning, **turned,
            )
        )  # fmt: skip

    def tick(self) -> ServoReport:
        """One millisecond of the servo."""
        self.now += 1e-3
        if self.orders and self.rng.random() >= self.loss:
            self.core.receive(self.orders[max(0, len(self.orders) - 1 - self.late)])
        reading = self.device.exchange(self.force, self.torque)
        report = self.core.cycle(reading, self.now)
        self.force, self.torque = np.array(report.force), np.array(report.torque)
        self.reports.append(report)
        return report
