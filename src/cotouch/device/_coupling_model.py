"""What the servo of a simulated device does with its proxy's place, checked once."""

from dataclasses import dataclass
from math import inf
from typing import final

from cotouch.arrays import Float
from cotouch.coupling import DeviceCoupling, device_couplings, end_row
from cotouch.device._checks import need
from cotouch.device._installed import installed_coupling
from cotouch.device._tables import COUPLED, HOST_FORCE, SPRING
from cotouch.errors import DeviceError

# What a servo does beside the couplings of `cotouch.mechanics`.
_OTHERS = {"spring": SPRING, "host_force": HOST_FORCE}


@final
@dataclass(frozen=True, kw_only=True)
class Coupling:
    """What the servo does with the proxy's place.

    PSPM is passive at any stiffness but for the energy of one tick at full speed, ½k (speed·period)²
    (`cotouch.mechanics.modulation_bound`); a stiffness that a device cannot render makes this noticeable.

    Attributes:
        law: a coupling of `cotouch.mechanics.device_couplings`, as `pspm`; `spring`, a plain sampled spring and damper
            to the desired position, passive under a condition only (`cotouch.mechanics.virtual_coupling_limit`);
            `host_force`, the force that the body's step computes.
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        cap: most energy that the tank keeps, >= 0 [J].
        reserve: debt up to which damping stays on, >= 0 [J].
        initial_energy: what the tank begins with, >= 0; counts once in the bound of passivity [J].
        assumed_damping: of the device itself, that a coupling may count on, >= 0 [Ns/m or Nm s/rad]. It makes device
            and coupling passive together, instead of the coupling alone.
        ages: largest of the places that both ends know of each other, together, >= 0 [s]; what counts on it is a law's.
        weight: more lets the device pay for old places, less the proxy, > 0; likewise.
        most: force at which the spring saturates, > 0 [N]; likewise.
        latency: ticks from a coupling's decision until its force acts, 0 or 1; 1 as a real servo.
        lag: ticks by which the law `spring` sees the tip late, 0 to 8.

    Raises:
        DeviceError: a number is out of range, or there is no such law.
    """

    law: str = "pspm"
    stiffness: float = 1000.0
    damping: float = 2.0
    cap: float = 0.1
    reserve: float = 1e-3
    initial_energy: float = 0.0
    assumed_damping: float = 0.0
    ages: float = 0.0
    weight: float = 1.0
    most: float = inf
    latency: int = 0
    lag: int = 0

    def __post_init__(self) -> None:
        if self.law not in _OTHERS:
            installed_coupling(self.law, what="law", others=_OTHERS)
        for name, value, unit in (
            ("stiffness", self.stiffness, "N/m"),
            ("damping", self.damping, "Ns/m"),
            ("cap", self.cap, "J"),
            ("reserve", self.reserve, "J"),
            ("initial energy", self.initial_energy, "J"),
            ("assumed damping", self.assumed_damping, ""),
            ("ages", self.ages, "s"),
        ):
            need(name, value, unit=unit)
        need("weight", self.weight, above=True)
        if not self.most > 0.0:
            raise DeviceError(f"most is {self.most:g} N; it must be above 0")
        need("latency", self.latency, most=1)
        need("lag", self.lag, most=8)

    @property
    def kind(self) -> int:
        """The servo's law, as its tables have it."""
        return _OTHERS.get(self.law, COUPLED)

    @property
    def end(self) -> DeviceCoupling | None:
        """What both ends do; None: this is none of `cotouch.mechanics`."""
        return device_couplings().get(self.law)

    def row(self, *, proxy: bool = False) -> Float:
        """An end at the start, (END.length,).

        Args:
            proxy: which of both; only a servo acts with a latency.
        """
        return end_row(
            stiffness=self.stiffness,
            damping=self.damping,
            cap=self.cap,
            reserve=self.reserve,
            initial=self.initial_energy,
            friction=self.assumed_damping,
            ages=self.ages,
            weight=self.weight,
            most=self.most,
            latency=0 if proxy else self.latency,
        )
