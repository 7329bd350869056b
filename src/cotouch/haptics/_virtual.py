"""A virtual coupling whose two ends live in two processes: a spring and dampers, and an account that watches them.

**The law.** The device holds `-k (q - y) - b v`, the proxy is pulled by `k (q - ŷ) - (b + drag) ŵ`: one spring, whose
ends each know the other's place as it was, and a damper at each end. Nothing shortens the spring but its saturation:
its slope never exceeds k, and its force never what the servo may hold.

**Where it is passive.** What a sampled spring makes has to be paid by friction that is really there
(`cotouch.mechanics.virtual_coupling_limit`). The device pays from its own

    friction  ≥  ½ k · 3T  +  ½ b (1 + spread)  +  ½ k ages · weight

T a tick of the servo: a force is decided on while the one before acts, so it is used until two ticks after its place
was measured, and what that makes is three halves of k T. The velocity is a mean over the window, so a place counts in
it at most `spread = 1 + T / window` times. `ages` is how old the proxy's place may be when the device stops using it,
plus the device's at the proxy; the proxy pays its share with `drag = ½ k ages / weight`, which is felt. Encoders put
the tip up to `unseen` beside its place and falsify the force by `(k + 2b / window) unseen`; dry friction has to be no
less. A stiffness beyond either is refused. What friction a device has nobody but its owner can say; the default is
none, so that none is assumed.

**What if it is not so**: ages beyond those declared, ticks that are late, a chain that shortens the force of one end
only, less friction than was said. Then a period may make energy; how much is known, because both ends book their ports'
exact work X. With `paid` what the declared friction took, by measured places, each end knows what there is:

    at the device   initial energy + paid - X_device - (X_proxy as it was told)
    at the proxy    initial energy + (paid - X_device as it was told) - X_proxy

and shortens its spring where that is less than the spring's energy. Sums here rise and fall, so an old one may promise
too much; the proxy therefore never takes more than the initial energy beyond what the device is known to have heard of.
So, whatever the rates, the clocks and the mailboxes do,

    X_device + X_proxy - paid  ≤  2 initial energies + what two ticks of a held force can make

which is two-port passivity of coupling and device together. The passivity observer holds the motors' work to the same
account and switches them off where it is not kept.
"""

from collections import deque
from math import inf, isfinite
from typing import final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._ends import DeviceEnd, EndOptions, EnergyMessage, ProxyEnd, Pull
from cotouch.haptics._port import MotorPort, Wall, less, plus
from cotouch.haptics._safety import ZERO, Vector, dot, scaled, size
from cotouch.mechanics import modulate, unseen_place, virtual_coupling_limit

# Over which a servo measures the tip's velocity [s]: an encoder of 0.05 mm then tells 5 mm/s apart.
WINDOW = 0.01
# Ticks that a place of the device is held and waited for: a force is decided on while the one before still acts.
_HELD = 3.0
# So many words are kept until the device has heard them.
_MESSAGES = 256


def drag_of(options: EndOptions) -> float:
    """Damping of the proxy to the ground, its share for old places [Ns/m]."""
    return 0.5 * options.stiffness * options.ages / options.weight


def virtual_limit(options: EndOptions, *, period: float, resolution: float) -> float:
    """The stiffest spring that a device's own friction pays for [N/m]; 0 or negative: none.

    Args:
        options: of the coupling, whose stiffness does not matter.
        period: of the servo, > 0 [s].
        resolution: of the tip's place, >= 0 [m].

    Raises:
        DeviceError: a number is out of range.
    """
    return virtual_coupling_limit(
        device_damping=options.friction,
        period=_HELD * period,
        damping=options.damping,
        ages=options.ages,
        weight=options.weight,
        spread=1.0 + period / WINDOW,
        unseen=unseen_place(resolution),
        dry=options.coulomb,
        shortest=WINDOW,
    )


def checked_virtual(options: EndOptions, spec: DeviceSpec, *, period: float) -> EndOptions:
    """A virtual coupling that is passive on a device.

    Args:
        options: of the coupling.
        spec: of the device, for messages.
        period: of the servo, > 0 [s].

    Raises:
        DeviceError: the device's own friction cannot pay for it.
    """
    limit = virtual_limit(options, period=period, resolution=0.0)
    coarse = virtual_limit(options, period=period, resolution=spec.resolution)
    if options.friction == 0.0:
        raise DeviceError(
            f"the friction of {spec.name} is 0 Ns/m, and a virtual coupling lives on it; say what it really has, as "
            "friction=0.5, or use coupling=pspm"
        )
    if limit <= 0.0:
        most = 2.0 * options.friction / (2.0 + period / WINDOW)
        raise DeviceError(
            f"the virtual coupling's damping is {options.damping:g} Ns/m; {spec.name} with a friction of "
            f"{options.friction:g} Ns/m pays for less than {most:.3g} Ns/m, so lower it or use coupling=pspm"
        )
    if options.stiffness > limit:
        raise DeviceError(
            f"the virtual coupling's stiffness is {options.stiffness:g} N/m; {spec.name} with a friction of "
            f"{options.friction:g} Ns/m, ticks of {1e3 * period:g} ms and places {1e3 * options.ages:g} ms old is "
            f"passive up to {limit:.4g} N/m, so lower it or use coupling=pspm"
        )
    if options.stiffness > coarse:
        upto = f"up to {coarse:.4g} N/m" if coarse > 0.0 else "with none"
        raise DeviceError(
            f"the virtual coupling's stiffness is {options.stiffness:g} N/m; {spec.name} knows its place to "
            f"{1e3 * spec.resolution:g} mm and with a dry friction of {options.coulomb:g} N is passive {upto}, so "
            "lower it, say what dry friction it really has, as coulomb=0.1, or use coupling=pspm"
        )
    return options


@final
class Account:
    """What one end knows of the energy.

    Attributes:
        initial_energy: with which it starts [J].
        acknowledged: what the other end has put in, by its last word [J].
        given: always 0; nothing is given away, ends only say what they put in [J].
        work: of this end's port on what is outside, so far [J].
        paid: by the device's friction so far [J].
        charge: what may have been unseen so far [J].
        starved: whether the spring was shortened for want of energy.
        lowest: the deepest debt so far, <= 0 [J].
    """

    def __init__(self, initial_energy: float) -> None:
        """Starts with the initial energy [J]."""
        self.initial_energy = initial_energy
        self.other_given = self.given = self.work = self.paid = self.charge = self.lowest = 0.0
        self.starved = False

    @property
    def energy(self) -> float:
        """That there is, by what was heard last; negative: a debt [J]."""
        return self.initial_energy + self.other_given + self.paid - self.work - self.charge

    @property
    def received(self) -> float:
        """What the motors may give: what the other end put in, and what friction paid [J]."""
        return self.other_given + self.paid

    @property
    def message(self) -> EnergyMessage:
        """For the other end: what this one put in, and what it knows of the other."""
        return EnergyMessage(self.paid - self.work - self.charge, self.other_given, self.energy, self.starved)

    def book(self, work: float, paid: float = 0.0, charge: float = 0.0) -> None:
        """Takes in what the port did, what friction took, and what may have been unseen [J].

        Args:
            work: done on the outside by this port [J].
            paid: what friction took [J].
            charge: what encoder and levers may have hidden [J].
        """
        self.work += work
        self.paid += paid
        self.charge += charge
        self.lowest = min(self.lowest, self.energy)

    def receive(self, message: EnergyMessage) -> None:
        """Takes what the other end put in, as it says; what is no number is not believed."""
        if isfinite(message.given) and isfinite(message.received):
            self.other_given = message.given


@final
class VirtualDeviceEnd:
    """The end that a servo holds: as `DeviceEnd`.

    Attributes:
        options: of the coupling.
        tank: its account.
        fraction: how far the set position followed the desired position in the last tick.
        place: of the tip; None: never measured [m].
    """

    def __init__(
        self,
        options: EndOptions,
        *,
        resolution: float,
        lever: float,
        radius: float = inf,
        wall: float = 0.0,
    ) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
            resolution: of the tip's place [m].
            lever: shortest arm of the device, as for `DeviceEnd` [m].
            radius: beyond which the wall's spring leads back [m].
            wall: its stiffness [N/m].
        """
        self.options = options
        self.tank = Account(options.initial_energy)
        self.fraction = 0.0
        self._port, self._wall = MotorPort(resolution=resolution, lever=lever), Wall(radius, wall)

    @property
    def place(self) -> Vector | None:
        """Of the tip, as measured; None: never [m]."""
        return self._port.place

    @property
    def start(self) -> float:
        """What the motors may give on their own: both initial energies, as the proxy's end may be ahead [J]."""
        return 2.0 * self.options.initial_energy

    def measure(self, place: Vector, commanded: Vector, said: Vector | None = None, T: float = 0.0) -> None:
        """Books the tick that has passed.

        Args:
            place: of the tip [m].
            commanded: force that acts from here on [N].
            said: what the device says that its motors do; None: nothing [N].
            T: since the last time; 0: unknown, and friction is not counted [s].
        """
        did = self._port.measure(place, commanded, said)
        if did is not None:
            # An encoder may have seen more motion than there was.
            sure = max(0.0, did.moved - self._port.resolution)
            paid = self.options.friction * sure * sure / T if T > 0.0 else 0.0
            self.tank.book(did.work, paid, did.charge)

    def decide(self, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float) -> Vector:
        """The force that the coupling wants; as `DeviceEnd.decide`.

        Args:
            desired: desired place of the spring's end [m]; None: none is known.
            rate: velocity of the device [m/s].
            message: what the other end said last.
            T: length of the step or tick [s].
        """
        del T
        place = self._port.place
        assert place is not None, "measure first"
        options, tank = self.options, self.tank
        tank.receive(message)
        available = tank.energy
        force = scaled(-options.damping, rate)
        force = plus(force, self._wall.pull(place, available))
        springs = self._wall.energy
        tank.starved, self.fraction = False, 0.0
        if desired is not None:
            gap = saturated(less(desired, place), options)
            self.fraction, _, _ = modulate(0.5 * options.stiffness * dot(gap, gap), available - springs, inf)
            tank.starved = self.fraction < 1.0
            force = plus(force, scaled(options.stiffness * self.fraction, gap))
        return ZERO if tank.energy < -options.reserve else force

    def bound(self, speed: float, period: float, force: float) -> float:
        """What two ticks of held forces can take beyond what there is [J]; as `DeviceEnd.bound`.

        Args:
            speed: of the device [m/s].
            period: of the servo [s].
            force: that is held [N].
        """
        options = self.options
        pull = force if force > 0.0 else options.most
        unseen = 1.5 * self._port.resolution * pull * 3.0**0.5
        return 2.0 * ((pull + options.damping * speed) * speed * period + options.reserve + unseen)


@final
class VirtualProxyEnd:
    """The end that a peer's step holds: as `ProxyEnd`.

    Attributes:
        options: of the coupling.
        tank: its account.
        fraction: how far the set position followed the device in the last step.
    """

    def __init__(self, options: EndOptions) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
        """
        self.options = options
        self.tank = Account(options.initial_energy)
        self.fraction = 0.0
        self._drag = drag_of(options)
        # What this end had put in, at each of its words that the device may not have heard; the most of older ones.
        self._unacknowledged, self._older = deque[float]([0.0]), -inf

    def pull(self, place: Vector, desired: Vector | None, rate: Vector, message: EnergyMessage, T: float) -> Pull:
        """What pulls the proxy in the coming step; as `ProxyEnd.pull`.

        Args:
            place: of the proxy [m].
            desired: desired place of the spring's end [m]; None: none is known.
            rate: velocity of the device [m/s].
            message: what the other end said last.
            T: length of the step or tick [s].
        """
        del rate, T
        options, tank = self.options, self.tank
        damping = options.damping + self._drag
        tank.receive(message)
        self._acknowledge(message.received)
        if desired is None or not isfinite(size(desired)):
            tank.starved, self.fraction = False, 0.0
            return Pull(0.0, damping, place, ZERO)
        # Of what this end put in, the device may still count on the most that it was told since it last heard.
        allowed = tank.initial_energy + tank.message.given - max(self._older, *self._unacknowledged)
        gap = saturated(less(desired, place), options)
        potential = 0.5 * options.stiffness * dot(gap, gap)
        self.fraction, _, _ = modulate(potential, max(0.0, min(tank.energy, allowed)), inf)
        tank.starved = self.fraction < 1.0
        return Pull(options.stiffness, damping, plus(place, scaled(self.fraction, gap)), ZERO)

    def settle(self, force: Vector, moved: Vector) -> None:
        """Books the step; as `ProxyEnd.settle`.

        Args:
            force: mean force on the proxy in the step [N].
            moved: how far the proxy went [m].
        """
        self.tank.book(dot(force, moved))
        self._unacknowledged.append(self.tank.message.given)
        if len(self._unacknowledged) > _MESSAGES:
            self._older = max(self._older, self._unacknowledged.popleft())

    def _acknowledge(self, acknowledged: float) -> None:
        """Forgets what was told before the word that the device has heard."""
        if acknowledged in self._unacknowledged:
            self._older = -inf
            while self._unacknowledged[0] != acknowledged:
                self._unacknowledged.popleft()


def saturated(gap: Vector, options: EndOptions) -> Vector:
    """A gap shortened to what the motors can do: its spring is the slope of a convex energy, no steeper than k.

    Args:
        gap: from one end of the spring to the other [m].
        options: of the coupling.
    """
    pull = options.stiffness * size(gap)
    return gap if pull <= options.most else scaled(options.most / pull, gap)


def device_end(
    options: EndOptions, *, resolution: float, lever: float, radius: float = inf, wall: float = 0.0
) -> DeviceEnd | VirtualDeviceEnd:
    """The device's end, by the law of the options; arguments as for `DeviceEnd`.

    Args:
        options: of the coupling.
        resolution: of the device's places [m].
        lever: shortest arm of the device, > 0 [m].
        radius: beyond which the wall's spring leads back [m].
        wall: its stiffness [N/m].
    """
    kind = DeviceEnd if options.law == "pspm" else VirtualDeviceEnd
    return kind(options, resolution=resolution, lever=lever, radius=radius, wall=wall)


def proxy_end(options: EndOptions) -> ProxyEnd | VirtualProxyEnd:
    """The proxy's end, by the law of the options."""
    return ProxyEnd(options) if options.law == "pspm" else VirtualProxyEnd(options)
