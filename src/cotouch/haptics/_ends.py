"""Both ends of a coupling, as a servo and a peer's step hold them; what they do is a law's (`cotouch.mechanics`).

Each end is a row of numbers with a tank of its own; see `coupling/_end.py` for what it may use, and why that
is two-port passive whatever the mailboxes between them do. The servo's end decides on a force while the one before
still acts, which is a latency of one tick.
"""

from math import inf, isfinite
from typing import NamedTuple, final

from cotouch.coupling import END, EnergyMessage, HeldForce, book_end, end_row, hear, message_of
from cotouch.device import DeviceSpec, installed_coupling
from cotouch.errors import DeviceError
from cotouch.haptics._port import MotorPort, Rest, Wall, less, plus
from cotouch.haptics._safety import ZERO, Vector, dot, multiple, norm

# Over which a servo measures the tip's velocity [s]: an encoder of 0.05 mm then tells 5 mm/s apart.
WINDOW = 0.01
# From a decision until its force acts [ticks].
_LATENCY = 1


@final
class EndOptions(NamedTuple):
    """Options of a coupling, the same for both ends.

    Attributes:
        stiffness: k [N/m].
        damping: b [Ns/m], at each end.
        cap: most that a tank keeps beyond its springs [J].
        reserve: debt up to which the damping stays on [J].
        initial_energy: what each tank starts with; counts once in d² [J]. 5 mJ: a stretch of 4.5 mm at 500 N/m.
        law: name of the coupling, see `cotouch.mechanics.couplings`; of the following some have an effect with some.
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
    law: str = "pspm"
    friction: float = 0.0
    coulomb: float = 0.0
    ages: float = 0.01
    weight: float = 1.0
    most: float = inf


def checked(options: EndOptions, spec: DeviceSpec) -> EndOptions:
    """Checks that options fit a device, and returns them.

    Args:
        options: of the coupling.
        spec: limits of the device.

    Raises:
        DeviceError: there is no such law, a number is negative or not finite, or the spring is stiffer than the device
            renders well.
    """
    installed_coupling(options.law)
    for name, value in options._asdict().items():
        if name not in {"law", "most"} and not (isfinite(value) and value >= 0.0):
            raise DeviceError(f"the coupling's {name} is {value:g}; it must be finite and at least 0")
    if options.stiffness > spec.stiffness:
        raise DeviceError(
            f"the coupling's stiffness is {options.stiffness:g} N/m; {spec.name} renders at most {spec.stiffness:g} N/m"
        )
    return options


class _End:
    """One end: its row, and the law's function for it."""

    def __init__(self, options: EndOptions, *, proxy: bool) -> None:
        self.options = options
        self._rows = end_row(
            stiffness=options.stiffness,
            damping=options.damping,
            cap=options.cap,
            reserve=options.reserve,
            initial=options.initial_energy,
            friction=options.friction,
            ages=options.ages,
            weight=options.weight,
            most=options.most,
            latency=0 if proxy else _LATENCY,
        )[None, :]
        self._row = self._rows[0]
        self._law = installed_coupling(options.law)
        self._half = self._law.half(proxy=proxy)

    def _run(
        self, place: Vector, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float
    ) -> tuple[float, float, Vector, Vector]:
        """What the law lets act: spring, damper, stretch and push.

        Args:
            place: of this end [m].
            desired: of the other, as known [m]; None: nothing is known.
            rate: of the device [m/s].
            message: of the other end.
            T: length of the tick or step [s].
        """
        row = self._row
        hear(row, message)
        gap = ZERO if desired is None else less(desired, place)
        known = desired is not None and isfinite(norm(gap)) and isfinite(norm(rate))
        row[END.T : END.acting] = (T, known, *(gap if known else ZERO), *(rate if isfinite(norm(rate)) else ZERO))
        self._half(row)
        spring, brake, x, y, z, a, b, c = row[END.spring : END.held].tolist()
        return spring, brake, (x, y, z), (a, b, c)

    def number(self, field: int) -> float:
        """One of the row."""
        return self._row.item(field)

    @property
    def fraction(self) -> float:
        """How far the set position followed the desired one in the last tick or step."""
        return self.number(END.fraction)

    @property
    def message(self) -> EnergyMessage:
        """For the other end."""
        return message_of(self._row)


@final
class DeviceEnd(_End):
    """The servo's end of a coupling: measured positions in, forces out.

    Attributes:
        options: of the coupling.
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
        super().__init__(options, proxy=False)
        self.place: Vector | None = None
        self._port, self._wall = MotorPort(resolution=resolution, lever=lever), Wall(radius, wall)
        slope = max(options.stiffness, wall) + options.damping / WINDOW
        # What acts a tick late swings twice as far.
        self._rest = Rest(resolution, (1 + _LATENCY) * slope if self._law.rests else 0.0)
        self._coming = 0.0  # energy of the springs behind the force that acts next

    @property
    def start(self) -> float:
        """What the motors may give that nobody gave them: the initial energy, of a pool both [J]."""
        return (2.0 if self._law.pools else 1.0) * self.options.initial_energy

    @property
    def due(self) -> float:
        """What the motors may have given of what others brought: the proxy's end, and friction [J]."""
        energy, work, lost = (self.number(field) for field in (END.energy, END.work, END.lost))
        return energy + work + lost - self.options.initial_energy

    @property
    def paid(self) -> float:
        """What the device's own friction took, by measured places [J]."""
        return self.number(END.paid)

    def measure(self, place: Vector, commanded: Vector, said: Vector | None = None, T: float = 0.0) -> None:
        """Books the tick that has passed.

        Args:
            place: of the tip [m].
            commanded: force that acts from here on: what the last `decide` led to, as far as the chain left it [N].
            said: what the device says that its motors do; None: nothing. Where the two differ, the one that costs more
                energy is booked [N].
            T: since the last time; 0: unknown, and friction is not counted [s].
        """
        self.place = self._rest.place(place, T)
        did = self._port.measure(place, commanded, said)
        if did is not None:
            # An encoder may have seen more motion than there was.
            sure = max(0.0, did.moved - self._port.resolution)
            paid = self.options.friction * sure * sure / T if T > 0.0 else 0.0
            book_end(self._rows, 0, did.work, paid, did.charge)
        self._row[END.acting] = self._coming

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
        energy = self.number(END.energy)
        wall = self._wall.pull(place, min(energy - self.number(END.acting), 0.5 * energy))
        self._row[END.kept] = self._wall.energy
        spring, brake, stretch, push = self._run(place, desired, rate, message, T)
        self._coming = self._wall.energy + self.number(END.held)
        if self.number(END.energy) < -self.options.reserve:
            return ZERO
        return plus(plus(wall, plus(multiple(-brake, rate), push)), multiple(spring, stretch))

    def bound(self, speed: float, period: float, force: float) -> float:
        """What can at most have come out of the motors beyond all that was given and the initial energy [J].

        Args:
            speed: highest of the tip between two measurements [m/s].
            period: longest between them [s].
            force: largest [N].
        """
        options = self.options
        return (1 + _LATENCY) * self._law.bound(
            HeldForce(
                stiffness=options.stiffness + self._wall.stiffness,
                damping=options.damping,
                period=period,
                speed=speed + self._rest.drift,
                reserve=options.reserve,
                force=force,
                resolution=self._port.resolution,
            )
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


class ProxyEnd(_End):
    """The peer's end of a coupling, for an implicit step as `cotouch.mechanics` takes it.

    Attributes:
        options: of the coupling.
    """

    def __init__(self, options: EndOptions) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
        """
        super().__init__(options, proxy=True)

    @property
    def energy(self) -> float:
        """In the tank, springs included [J]."""
        return self.number(END.energy)

    @property
    def work(self) -> float:
        """On the proxy so far [J]."""
        return self.number(END.work)

    def pull(self, place: Vector, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float) -> Pull:
        """What pulls the proxy in the coming step.

        Args:
            place: of the proxy [m].
            desired: place of the device, as known [m]; None: nothing is known.
            rate: of the device [m/s].
            message: of the device's end.
            T: length of the step [s].
        """
        spring, brake, stretch, push = self._run(place, desired, rate, message, T)
        return Pull(spring, brake, plus(place, stretch), push)

    def settle(self, force: Vector, moved: Vector) -> None:
        """Books the step.

        Args:
            force: mean of what pulled the proxy [N].
            moved: by the proxy [m].
        """
        self.book(dot(force, moved))

    def book(self, work: float) -> None:
        """Books the work of a step.

        Args:
            work: done on the proxy [J].
        """
        book_end(self._rows, 0, work, 0.0, 0.0)
