"""What one device, its servo and its hand are, checked once."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import acos, atan2, cos, degrees, hypot, inf, isfinite, pi, sin
from typing import final

from cotouch.device._checks import Triple, need, triple
from cotouch.device._coupling_model import Coupling
from cotouch.device._tables import CARTESIAN, PHANTOM
from cotouch.errors import DeviceError

# van Beek et al., Sci. Rep. 5:18004 (2015), one typical trial.
HAND_MASS, HAND_DAMPING, HAND_STIFFNESS = 0.554, 6.45, 135.0
GRAVITY = 9.80665
# Of a PHANToM's force and torque, what its motors can do for a moment, by what they can do all the time.
_PEAK = 8.5 / 1.4


@final
@dataclass(frozen=True, kw_only=True)
class CartesianPlant:
    """A device that moves alike in all directions.

    Attributes:
        mass: apparent at the tip, > 0 [kg].
        viscous: friction, >= 0 [Ns/m].
        coulomb: friction, >= 0 [N].

    Raises:
        DeviceError: a number is out of range.
    """

    mass: float = 0.06
    viscous: float = 0.0125
    coulomb: float = 0.0

    kind = CARTESIAN

    def __post_init__(self) -> None:
        need("mass", self.mass, above=True, unit="kg")
        need("viscous", self.viscous, unit="Ns/m")
        need("coulomb", self.coulomb, unit="N")


@final
@dataclass(frozen=True, kw_only=True)
class PhantomPlant:
    """A PHANToM 1.5 [Çavuşoğlu, Feygin & Tendick 2002].

    Masses, inertias and lengths are the published ones. Inertias of the links `be` and `df` are about their joints'
    axes, as the published mass matrix uses them. Friction and torque are nominal: what its motors can do all the time,
    0.0286 Nm behind ratios of 13.3 and 11.2, is 1.4 N at the tip, and at their peak as much more as 8.5 N is.

    Attributes:
        viscous: friction of every joint, >= 0 [Nm s/rad].
        coulomb: friction of every joint, >= 0 [Nm].
        torque: largest of each joint, > 0; by default the peak [Nm].
        gravity: whether it pulls; False: compensated.

    Raises:
        DeviceError: a number is out of range.
    """

    viscous: float = 5e-4
    coulomb: float = 0.01
    torque: Triple = (_PEAK * 0.0286 * 13.3, _PEAK * 0.0286 * 11.2, _PEAK * 0.0286 * 11.2)
    gravity: bool = False

    kind = PHANTOM

    def __post_init__(self) -> None:
        need("viscous", self.viscous, unit="Nm s/rad")
        need("coulomb", self.coulomb, unit="Nm")
        for value in self.torque:
            need("torque", value, above=True, unit="Nm")

    def inertia(self) -> tuple[float, ...]:
        """The seven numbers of the mass matrix, as `Plants.inertia` [kg m²]."""
        a_yy, a_zz, a_xx = 0.001843e-4, 0.4864e-4, 0.4864e-4
        c_yy, c_zz, c_xx = 0.959e-4, 0.0051e-4, 0.959e-4
        be_yy, be_zz, be_xx = 10.06e-4, 0.591e-4, 11.09e-4
        df_yy, df_zz, df_xx = 0.629e-4, 6.246e-4, 7.11e-4
        base_yy = 11.87e-4
        m_a, m_c = _MASS["a"], _MASS["c"]
        l1, l2, l3 = _LENGTH["l1"], _LENGTH["l2"], _LENGTH["l3"]
        masses = 4 * l1**2 * m_a + l2**2 * m_a + l1**2 * m_c + 4 * l3**2 * m_c
        inertias = 4 * (a_yy + a_zz + be_yy + be_zz + c_yy + c_zz + df_yy + df_zz)
        return (
            (inertias + 8 * base_yy + masses) / 8,
            (4 * (be_yy - be_zz + c_yy - c_zz) + l1**2 * (4 * m_a + m_c)) / 8,
            (4 * (a_yy - a_zz + df_yy - df_zz) - l2**2 * m_a - 4 * l3**2 * m_c) / 8,
            l1 * (l2 * m_a + l3 * m_c),
            be_xx + c_xx + l1**2 * m_a + l1**2 * m_c / 4,
            a_xx + df_xx + l2**2 * m_a / 4 + l3**2 * m_c,
            l1 * (l2 * m_a + l3 * m_c) / 2,
        )

    def lengths(self) -> tuple[float, float]:
        """l1 and l2 [m]."""
        return _LENGTH["l1"], _LENGTH["l2"]

    def weight(self) -> tuple[float, float]:
        """Moments of gravity about joints 2 and 3, as `Plants.gravity`; 0 where it is compensated [Nm]."""
        if not self.gravity:
            return 0.0, 0.0
        l1, l2, l3, l5, l6 = (_LENGTH[name] for name in ("l1", "l2", "l3", "l5", "l6"))
        half = GRAVITY / 2
        return (
            half * (2 * l1 * _MASS["a"] + 2 * l5 * _MASS["be"] + l1 * _MASS["c"]),
            half * (l2 * _MASS["a"] + 2 * l3 * _MASS["c"] - 2 * l6 * _MASS["df"]),
        )

    def joints(self, tip: Triple) -> Triple:
        """Joint angles at which the tip is there, the elbow as at the origin [rad].

        Raises:
            DeviceError: the tip or a joint does not reach so far.
        """
        l1, l2 = self.lengths()
        out, up = hypot(l1 - tip[0], tip[1]), tip[2] - l2
        bend = (out * out + up * up - l1 * l1 - l2 * l2) / (2 * l1 * l2)
        if abs(bend) <= 1.0:
            elbow = -acos(bend)
            q2 = atan2(up, out) - atan2(l2 * sin(elbow), l1 + l2 * cos(elbow))
            q = atan2(-tip[1], l1 - tip[0]), q2, q2 + elbow + pi / 2
            if all(
                low <= degrees(angle) <= high for (low, high), angle in zip(_LIMITS, (*q, q[2] - q[1]), strict=True)
            ):
                return q
        raise DeviceError(f"position is {tip}; a PHANToM's tip cannot reach it")


_MASS = {"a": 0.0202, "c": 0.0249, "be": 0.2359, "df": 0.1906}
_LENGTH = {"l1": 0.215, "l2": 0.170, "l3": 0.0325, "l5": -0.0368, "l6": 0.0527}
# Of the joints 1, 2, 3 and of the angle between 2 and 3 [degrees].
_LIMITS = ((-90.0, 90.0), (-124.0, 119.0), (-29.0, 214.0), (-65.0, 55.0))


@final
@dataclass(frozen=True, kw_only=True)
class ServoModel:
    """Sensor, clock and actuator.

    Attributes:
        period: time between ticks, or several used in turn, each > 0 [s].
        window: over which velocity is measured, >= 0; less than a period: since the last tick [s]. With the law
            `host_force` it is always since the last sample.
        resolution: of the encoders, >= 0 [m], of a joint [rad]; 0: exact.
        force: largest, > 0 [N].
        substep: longest step of the integrator, > 0 [s].

    Raises:
        DeviceError: a number is out of range.
    """

    period: float | tuple[float, ...] = 1e-3
    window: float = 0.02
    resolution: float = 0.0
    force: float = inf
    substep: float = 1e-4

    def __post_init__(self) -> None:
        if not self.periods():
            raise DeviceError("period is empty; it must be one time or several")
        for value in self.periods():
            need("period", value, above=True, unit="s")
        need("window", self.window, unit="s", most=1e4 * min(self.periods()))
        need("resolution", self.resolution)
        need("substep", self.substep, above=True, unit="s")
        if not self.force > 0.0:
            raise DeviceError(f"force is {self.force:g} N; it must be above 0")

    def periods(self) -> tuple[float, ...]:
        """All of them [s]."""
        return self.period if isinstance(self.period, tuple) else (self.period,)

    def span(self) -> float:
        """Shortest time over which velocity is measured [s]."""
        return max(self.window, min(self.periods()))


@final
@dataclass(frozen=True, kw_only=True)
class SimulatedHand:
    """A hand on the tip: mass, and spring and damper to an equilibrium point [van Beek et al. 2015].

    Attributes:
        path: where the equilibrium goes: a place, or waypoints `(time, x, y, z)` with straight lines between [s, m].
        amplitude: of a sine added to the path [m].
        frequency: of the sine, >= 0 [Hz].
        phase: of the sine [rad].
        grip: factor on stiffness and damping, ¼ to 4 [Hasser & Cutkosky 2002].
        mass: >= 0 [kg].
        stiffness: >= 0 [N/m].
        damping: >= 0 [Ns/m].
        begin: takes hold [s].
        release: lets go; None: never [s].
        blend: over which the equilibrium comes to its path after taking hold, > 0 [s].
        reaction: delay of the will, 0.1 to 0.2 in people, > 0 [s].
        correction: how fast the will corrects the tip's error, >= 0 [1/s]; 0: not at all.
        reach: farthest that it goes for this, >= 0 [m].
        waypoints: the path as times and places [s, m].

    Raises:
        DeviceError: a number is out of range, or the path is none.
    """

    path: Sequence[float] | Sequence[Sequence[float]] = (0.0, 0.0, 0.0)
    amplitude: Sequence[float] = (0.0, 0.0, 0.0)
    frequency: float = 0.0
    phase: float = 0.0
    grip: float = 1.0
    mass: float = HAND_MASS
    stiffness: float = HAND_STIFFNESS
    damping: float = HAND_DAMPING
    begin: float = 0.0
    release: float | None = None
    blend: float = 0.3
    reaction: float = 0.15
    correction: float = 0.0
    reach: float = 0.05
    waypoints: tuple[tuple[float, Triple], ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        for name, unit in (("mass", "kg"), ("stiffness", "N/m"), ("damping", "Ns/m"), ("frequency", "Hz")):
            need(f"hand's {name}", float(getattr(self, name)), unit=unit)
        need("hand's grip", self.grip, least=0.25, most=4.0)
        need("hand's phase", self.phase, least=-inf, unit="rad")
        need("hand's begin", self.begin, unit="s")
        if self.release is not None:
            need("hand's release", self.release, least=self.begin, above=True, unit="s")
        need("hand's blend", self.blend, above=True, unit="s")
        need("hand's reaction", self.reaction, above=True, unit="s")
        need("hand's correction", self.correction, unit="1/s")
        need("hand's reach", self.reach, unit="m")
        triple("hand's amplitude", self.amplitude)
        object.__setattr__(self, "waypoints", _waypoints(self.path))

    @property
    def wave(self) -> Triple:
        """Amplitude of the sine in three axes [m]."""
        return triple("hand's amplitude", self.amplitude)


def _waypoints(path: Sequence[float] | Sequence[Sequence[float]]) -> tuple[tuple[float, Triple], ...]:
    if path and isinstance(path[0], Sequence):
        rows: list[tuple[float, Triple]] = []
        for row in path:
            values = list(row) if isinstance(row, Sequence) else []
            if len(values) < 2 or not isfinite(float(values[0])):
                raise DeviceError(f"hand's path has the waypoint {row!r}; it must be a time and one to three numbers")
            rows.append((float(values[0]), triple("hand's waypoint", values[1:])))
        times = [time for time, _ in rows]
        if any(later <= earlier for earlier, later in pairwise(times)):
            raise DeviceError(f"hand's path has the times {times}; they must increase")
        return tuple(rows)
    flat = [entry for entry in path if not isinstance(entry, Sequence)]
    return ((0.0, triple("hand's path", flat)),)


@final
@dataclass(frozen=True, kw_only=True)
class DeviceModel:
    """One simulated device with all that belongs to it.

    Attributes:
        plant: how it moves.
        servo: sensor, clock, actuator.
        coupling: to the proxy.
        hand: that holds it; None: nobody.
        position: where the tip starts, at rest [m]. A PHANToM has its joints at 0 at the origin.

    Raises:
        DeviceError: the position is none, or out of the device's reach.
    """

    plant: CartesianPlant | PhantomPlant = field(default_factory=CartesianPlant)
    servo: ServoModel = field(default_factory=ServoModel)
    coupling: Coupling = field(default_factory=Coupling)
    hand: SimulatedHand | None = None
    position: Sequence[float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if isinstance(self.plant, PhantomPlant):
            self.plant.joints(self.start)
        else:
            triple("position", self.position)

    @property
    def start(self) -> Triple:
        """Where the tip starts [m]."""
        return triple("position", self.position)

    @property
    def coordinate(self) -> Triple:
        """Where the device's own coordinates start [m or rad]."""
        return self.plant.joints(self.start) if isinstance(self.plant, PhantomPlant) else self.start
