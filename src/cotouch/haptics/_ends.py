"""A virtual spring whose two ends live in two processes, and the energy that each end may use.

The device's servo holds one end, the peer's step the other; what each knows of the other is old, by how much nobody can
promise. One account for both, as where device and body share a process, cannot be kept so: two that draw on what they
believe is there draw it twice. So each end has a *tank* of its own, and books into it its own port's work, exactly:

* the device's end `-F·Δq` for a force held between two measured places, less what encoder and levers may hide;
* the proxy's end `-τᵀŵ T`, what the spring of the implicit step really did.

An end moves its set position only as far as its tank goes (PSPM, `cotouch.mechanics.modulate`). What one gives to
the other it takes out of its own tank first, and publishes **the sum of all that it gave since the start**. These sums
only rise. So whatever is lost, late, read twice or never:

    received by i, as i knows it  ≤  given to i, in truth          (an old sum is a smaller one)

and adding up both tanks, with all their port work, X the work that left the coupling at a port,

    X_device + X_proxy  =  initial energies - tanks - lost - (given and not yet received)  ≤  initial energies + debts

which is two-port passivity, ∫τᵀq̇ dt + Σ τᵀŵ T ≤ d², without a word about delays. A stale sum costs liveliness, never
passivity. That is the sum of `cotouch.peer.LinkGuard`, and for the same reason.

**Debts.** The proxy's end never has one: an implicit step takes at most what its spring holds. The device's end decides
on a force while the one before still acts, and each may take more than the spring had, by `½k‖Δq‖² + b‖v‖‖Δq‖`
(`modulation_bound`). It therefore keeps back what the acting force's spring holds, and owes at most two such ticks.

**Who has what the other lacks.** Each end says whether it cannot follow for want of energy, what its tank holds, and
how much it has received; the other then evens the tanks out, in some milliseconds. An *initial energy* starts both:
without any energy no held force does work that could be saved.
"""

from math import exp, inf, isfinite
from typing import Literal, NamedTuple, final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._port import MotorPort, Rest, Wall, less, plus
from cotouch.haptics._safety import ZERO, Vector, dot, scaled, size
from cotouch.mechanics import credit, modulate, modulation_bound

Law = Literal["pspm", "virtual"]
# In which tanks even out [s]: quicker than a hand, slower than what one end knows of the other on a loaded machine.
_EVEN = 0.01


@final
class EndOptions(NamedTuple):
    """The coupling, the same for both ends.

    Attributes:
        stiffness: k [N/m].
        damping: b [Ns/m], at each end.
        cap: most that a tank keeps beyond its springs [J].
        reserve: debt up to which the damping stays on [J].
        initial_energy: what each tank starts with; counts once in d² [J]. 5 mJ: a stretch of 4.5 mm at 500 N/m.
        law: "pspm", or "virtual" for a spring that is not shortened (`_virtual.py`); the following are its own.
        friction: viscous, that the device itself has for certain [Ns/m].
        coulomb: dry friction that it has for certain [N].
        ages: largest age of the proxy's place at the device plus that of the device's at the proxy, each when it is
            used for the last time [s]. 10 ms: a peer at 500 Hz or more on the same machine.
        weight: d of the age rule, > 0: more lets the device pay for old places, less the proxy.
        most: force at which the spring saturates [N].
    """

    stiffness: float = 500.0
    damping: float = 2.0
    cap: float = 0.1
    reserve: float = 1e-3
    initial_energy: float = 5e-3
    law: Law = "pspm"
    friction: float = 0.0
    coulomb: float = 0.0
    ages: float = 0.01
    weight: float = 1.0
    most: float = inf


def checked(options: EndOptions, spec: DeviceSpec) -> EndOptions:
    """Options that fit a device.

    Args:
        options: of the coupling.
        spec: limits of the device.

    Raises:
        DeviceError: a number is negative or not finite, or the spring is stiffer than the device renders well.
    """
    for name, value in options._asdict().items():
        if name not in {"law", "most"} and not (isfinite(value) and value >= 0.0):
            raise DeviceError(f"the coupling's {name} is {value:g}; it must be finite and at least 0")
    if options.stiffness > spec.stiffness:
        raise DeviceError(
            f"the coupling's stiffness is {options.stiffness:g} N/m; {spec.name} renders at most {spec.stiffness:g} N/m"
        )
    return options


class EnergyMessage(NamedTuple):
    """What one end tells the other with every message.

    Attributes:
        given: to the other since the start; with a virtual coupling what it put in, less what it took out [J].
        received: of what the other gave, as known here [J].
        tank: what is there now [J].
        starved: whether it cannot follow for want of energy.
    """

    given: float = 0.0
    received: float = 0.0
    tank: float = 0.0
    starved: bool = False


@final
class EnergyTank:
    """Energy of one end.

    Attributes:
        energy: what is there, springs included; negative: a debt [J].
        given: since the start [J].
        received: likewise [J].
        lost: what it could not keep [J].
        work: of this end's port on what is outside, so far [J].
        starved: as in `Word`.
        lowest: the deepest debt so far, <= 0 [J].
    """

    def __init__(self, initial_energy: float) -> None:
        """Starts with the initial energy [J]."""
        self.energy = initial_energy
        self.given = self.received = self.lost = self.work = self.lowest = 0.0
        self.starved = False

    @property
    def message(self) -> EnergyMessage:
        """For the other end."""
        return EnergyMessage(self.given, self.received, self.energy, self.starved)

    def book(self, work: float, charge: float = 0.0) -> None:
        """Takes out what the port did, and what it may have done unseen [J].

        Args:
            work: done on the outside by this port [J].
            charge: what encoder and levers may have hidden [J].
        """
        self.work += work
        self.lost += charge
        self.energy -= work + charge
        self.lowest = min(self.lowest, self.energy)

    def receive(self, message: EnergyMessage, free: float, T: float) -> None:
        """Takes what the other gave; gives it what evens the tanks out, if it lacks it.

        Args:
            message: its last, however old; what is no number is not believed.
            free: what may be given at most [J].
            T: since the last time [s].
        """
        if not (isfinite(message.given) and isfinite(message.tank) and isfinite(message.received)):
            return
        gift = credit(message.given, self.received)
        self.received += gift
        self.energy += gift
        if message.starved:
            theirs = message.tank + max(0.0, self.given - message.received)
            spare = min(0.5 * (self.energy - theirs) * (1.0 - exp(-T / _EVEN)), free + gift)
            if spare > 0.0:
                self.energy -= spare
                self.given += spare

    def discard(self, excess: float) -> None:
        """Loses what is beyond the cap [J]."""
        self.energy -= excess
        self.lost += excess


@final
class DeviceEnd:
    """The end that a servo holds: measured places in, forces out.

    Attributes:
        tank: its energy.
        fraction: how far the set position followed the desired position in the last tick.
        place: of the tip as the law takes it: with less of its flicker at rest; None: never measured [m].
    """

    def __init__(
        self, options: EndOptions, *, resolution: float, lever: float, radius: float = inf, wall: float = 0.0
    ) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
            resolution: of the tip's place [m].
            lever: shortest arm of the device, over which a held torque's force may turn unseen, > 0 [m].
            radius: beyond which the wall's spring leads back [m].
            wall: its stiffness [N/m].
        """
        self.options = options
        self.tank = EnergyTank(options.initial_energy)
        self.fraction = 0.0
        self.place: Vector | None = None
        self._port, self._wall = MotorPort(resolution=resolution, lever=lever), Wall(radius, wall)
        self._rest = Rest(resolution, max(options.stiffness, wall))
        self._acting = self._coming = 0.0  # energy of the springs behind the force that acts, and behind the next

    @property
    def start(self) -> float:
        """What the motors may give that nobody gave them: the initial energy [J]."""
        return self.options.initial_energy

    def measure(self, place: Vector, commanded: Vector, said: Vector | None = None, T: float = 0.0) -> None:
        """Books the tick that has passed.

        Args:
            place: of the tip [m].
            commanded: force that acts from here on: what the last `decide` led to, as far as the chain left it [N].
            said: what the device says that its motors do; None: nothing. Where the two differ, the one that costs more
                energy is booked [N].
            T: since the last time [s].
        """
        self.place = self._rest.place(place, T)
        did = self._port.measure(place, commanded, said)
        if did is not None:
            self.tank.book(did.work, did.charge)
        self._acting = self._coming

    def decide(self, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float) -> Vector:
        """The force that the coupling wants.

        Args:
            desired: the proxy's place, as known [m]; None: nothing is known, or it is no longer to be followed.
            rate: of the tip as the law takes it [m/s].
            message: of the other end.
            T: length of a tick [s].

        Returns:
            On the hand [N]; to be applied from the next `measure` on, whole or shortened.
        """
        place = self.place
        assert place is not None, "measure first"
        options, tank = self.options, self.tank
        tank.receive(message, max(0.0, tank.energy - self._acting), T)
        # Half, so that two ticks with little energy share it instead of taking turns.
        available = min(tank.energy - self._acting, 0.5 * tank.energy)
        force = scaled(-options.damping, rate)
        force = plus(force, self._wall.pull(place, available))
        springs = self._wall.energy
        tank.starved = False
        self.fraction = 0.0
        gap = None if desired is None else less(desired, place)
        potential = 0.0 if gap is None else 0.5 * options.stiffness * dot(gap, gap)
        fraction, _, excess = modulate(potential, available - springs, options.cap)
        if gap is not None:
            self.fraction = fraction
            springs += fraction * fraction * potential if fraction > 0.0 else 0.0
            force = plus(force, scaled(options.stiffness * fraction, gap))
            tank.starved = fraction < 1.0
        tank.discard(excess)
        self._coming = springs
        return ZERO if tank.energy < -options.reserve else force

    def bound(self, speed: float, period: float, force: float) -> float:
        """What can at most have come out of the motors beyond all that was given and the initial energy [J].

        Args:
            speed: highest of the tip between two measurements [m/s].
            period: longest between them [s].
            force: largest [N].
        """
        options = self.options
        return 2.0 * modulation_bound(
            stiffness=options.stiffness + self._wall.stiffness,
            damping=options.damping,
            period=period,
            speed=speed + self._rest.drift,
            reserve=options.reserve,
            force=force,
            resolution=self._port.resolution,
            axes=3,
        )


class Pull(NamedTuple):
    """What pulls a proxy in a step: `τ = k (target - ŷ) - b ŵ + push`.

    Attributes:
        stiffness: k [N/m].
        damping: b [Ns/m].
        target: set position [m].
        push: the damper's pull towards the device's velocity [N].
    """

    stiffness: float
    damping: float
    target: Vector
    push: Vector


@final
class ProxyEnd:
    """The end that a peer's step holds; the step is implicit, as `cotouch.mechanics` takes it.

    Attributes:
        tank: its energy.
        fraction: how far the set position followed the device in the last step.
    """

    def __init__(self, options: EndOptions) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
        """
        self.options = options
        self.tank = EnergyTank(options.initial_energy)
        self.fraction = 0.0

    def pull(self, place: Vector, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float) -> Pull:
        """What pulls the proxy in the coming step.

        Args:
            place: of the proxy [m].
            desired: place of the device, as known [m]; None: nothing is known.
            rate: of the device [m/s].
            message: of the device's end.
            T: length of the step [s].
        """
        options, tank = self.options, self.tank
        tank.receive(message, max(0.0, tank.energy), T)
        available = max(0.0, tank.energy)
        if desired is None or not isfinite(size(desired)) or not isfinite(size(rate)):
            tank.starved, self.fraction = False, 0.0
            tank.discard(max(0.0, available - options.cap))
            return Pull(0.0, options.damping, place, ZERO)
        # The pull towards a velocity gives at most ¼ b ‖v‖² T; it is set aside first.
        cost = 0.25 * options.damping * T * dot(rate, rate)
        part = 1.0 if cost <= available else (available / cost) ** 0.5
        left = max(0.0, available - part * part * cost)
        gap = less(desired, place)
        self.fraction, _, excess = modulate(0.5 * options.stiffness * dot(gap, gap), left, options.cap)
        tank.starved = self.fraction < 1.0
        tank.discard(excess)
        target = plus(place, scaled(self.fraction, gap))
        return Pull(options.stiffness, options.damping, target, scaled(part * options.damping, rate))

    def settle(self, force: Vector, moved: Vector) -> None:
        """Books the step.

        Args:
            force: mean of what pulled the proxy [N].
            moved: by the proxy [m].
        """
        self.tank.book(dot(force, moved))
