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
plus the device's at the proxy; the proxy pays its share with `drag = ½ k ages / weight`, which is felt. A stiffness
beyond that is refused. What friction a device has nobody but its owner can say; the default is none, so that none is
assumed.

**What if it is not so**: ages beyond those declared, ticks that are late, a chain that shortens the force of one end
only, less friction than was said. Then a period may make energy; how much is known, because both ends book their ports'
exact work X. With `paid` what the declared friction took, by measured places, each end knows what there is:

    at the device   seed + paid - X_device - (X_proxy as it was told)
    at the proxy    seed + (paid - X_device as it was told) - X_proxy

and shortens its spring where that is less than the spring's energy. Sums here rise and fall, so an old one may promise
too much; the proxy therefore never takes more than the seed beyond what the device is known to have heard of. So,
whatever the rates, the clocks and the boards do,

    X_device + X_proxy - paid  ≤  2 seeds + what two ticks of a held force can make

which is two-port passivity of coupling and device together. The passivity observer holds the motors' work to the same
account and switches them off where it is not kept.
"""

from collections import deque
from math import inf, isfinite
from typing import final

from cotouch.device import DeviceSpec
from cotouch.errors import DeviceError
from cotouch.haptics._ends import DeviceEnd, EndOptions, ProxyEnd, Pull, Word
from cotouch.haptics._port import MotorPort, Wall, less, plus
from cotouch.haptics._safety import ZERO, Vector, dot, scaled, size
from cotouch.mechanics import modulate, virtual_coupling_limit

# Over which a servo measures the tip's velocity [s]: an encoder of 0.05 mm then tells 5 mm/s apart.
WINDOW = 0.01
# Ticks that a place of the device is held and waited for: a force is decided on while the one before still acts.
_HELD = 3.0
# So many words are kept until the device has heard them.
_WORDS = 256


def drag_of(options: EndOptions) -> float:
    """Damping of the proxy to the ground, its share for old places [Ns/m]."""
    return 0.5 * options.stiffness * options.ages / options.weight


def virtual_limit(options: EndOptions, *, period: float) -> float:
    """The stiffest spring that a device's own friction pays for [N/m]; 0 or negative: none.

    Args:
        options: of the coupling, whose stiffness does not matter.
        period: of the servo, > 0 [s].

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
    limit = virtual_limit(options, period=period)
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
    return options


@final
class Account:
    """What one end knows of the energy.

    Attributes:
        seed: with which it starts [J].
        heard: what the other end has put in, by its last word [J].
        given: always 0; nothing is given away, ends only say what they put in [J].
        work: of this end's port on what is outside, so far [J].
        paid: by the device's friction so far [J].
        charge: what may have been unseen so far [J].
        wanting: whether the spring was shortened for want of energy.
        lowest: the deepest debt so far, <= 0 [J].
    """

    def __init__(self, seed: float) -> None:
        """Starts with the seed [J]."""
        self.seed = seed
        self.heard = self.given = self.work = self.paid = self.charge = self.lowest = 0.0
        self.wanting = False

    @property
    def energy(self) -> float:
        """That there is, by what was heard last; negative: a debt [J]."""
        return self.seed + self.heard + self.paid - self.work - self.charge

    @property
    def received(self) -> float:
        """What the motors may give: what the other end put in, and what friction paid [J]."""
        return self.heard + self.paid

    @property
    def word(self) -> Word:
        """For the other end: what this one put in, and what it knows of the other."""
        return Word(self.paid - self.work - self.charge, self.heard, self.energy, self.wanting)

    def book(self, work: float, paid: float = 0.0, charge: float = 0.0) -> None:
        """Takes in what the port did, what friction took, and what may have been unseen [J]."""
        self.work += work
        self.paid += paid
        self.charge += charge
        self.lowest = min(self.lowest, self.energy)

    def hear(self, word: Word) -> None:
        """Takes what the other end put in, as it says; what is no number is not believed."""
        if isfinite(word.given) and isfinite(word.received):
            self.heard = word.given


@final
class VirtualDeviceEnd:
    """The end that a servo holds: as `DeviceEnd`.

    Attributes:
        options: of the coupling.
        purse: its account.
        share: how far the set position followed the wish in the last tick.
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
        self.purse = Account(options.seed)
        self.share = 0.0
        self._port, self._wall = MotorPort(resolution=resolution, lever=lever), Wall(radius, wall)

    @property
    def start(self) -> float:
        """What the motors may give that nobody gave them: both seeds, because the proxy's end may be ahead [J]."""
        return 2.0 * self.options.seed

    def measure(self, place: Vector, told: Vector, said: Vector | None = None, T: float = 0.0) -> None:
        """Books the tick that has passed.

        Args:
            place: of the tip [m].
            told: force that acts from here on [N].
            said: what the device says that its motors do; None: nothing [N].
            T: since the last time; 0: unknown, and friction is not counted [s].
        """
        did = self._port.measure(place, told, said)
        if did is not None:
            # An encoder may have seen more motion than there was.
            sure = max(0.0, did.moved - self._port.resolution)
            paid = self.options.friction * sure * sure / T if T > 0.0 else 0.0
            self.purse.book(did.work, paid, did.charge)

    def decide(self, wish: Vector | None, rate: Vector, word: Word, T: float) -> Vector:
        """The force that the coupling wants; as `DeviceEnd.decide`."""
        del T
        place = self._port.place
        assert place is not None, "measure first"
        options, purse = self.options, self.purse
        purse.hear(word)
        available = purse.energy
        force = scaled(-options.damping, rate)
        force = plus(force, self._wall.pull(place, available))
        springs = self._wall.energy
        purse.wanting, self.share = False, 0.0
        if wish is not None:
            gap = saturated(less(wish, place), options)
            self.share, _, _ = modulate(0.5 * options.stiffness * dot(gap, gap), available - springs, inf)
            purse.wanting = self.share < 1.0
            force = plus(force, scaled(options.stiffness * self.share, gap))
        return ZERO if purse.energy < -options.reserve else force

    def bound(self, speed: float, period: float, force: float) -> float:
        """What two ticks of held forces can take beyond what there is [J]; as `DeviceEnd.bound`."""
        options = self.options
        pull = force if force > 0.0 else options.most
        unseen = 1.5 * self._port.resolution * pull * 3.0**0.5
        return 2.0 * ((pull + options.damping * speed) * speed * period + options.reserve + unseen)


@final
class VirtualProxyEnd:
    """The end that a peer's step holds: as `ProxyEnd`.

    Attributes:
        options: of the coupling.
        purse: its account.
        share: how far the set position followed the device in the last step.
    """

    def __init__(self, options: EndOptions) -> None:
        """Relaxed.

        Args:
            options: of the coupling.
        """
        self.options = options
        self.purse = Account(options.seed)
        self.share = 0.0
        self._drag = drag_of(options)
        # What this end had put in, at each of its words that the device may not have heard; the most of older ones.
        self._unheard, self._older = deque[float]([0.0]), -inf

    def pull(self, place: Vector, wish: Vector | None, rate: Vector, word: Word, T: float) -> Pull:
        """What pulls the proxy in the coming step; as `ProxyEnd.pull`."""
        del rate, T
        options, purse = self.options, self.purse
        damping = options.damping + self._drag
        purse.hear(word)
        self._acknowledge(word.received)
        if wish is None or not isfinite(size(wish)):
            purse.wanting, self.share = False, 0.0
            return Pull(0.0, damping, place, ZERO)
        # Of what this end put in, the device may still count on the most that it was told since it last heard.
        allowed = purse.seed + purse.word.given - max(self._older, *self._unheard)
        gap = saturated(less(wish, place), options)
        potential = 0.5 * options.stiffness * dot(gap, gap)
        self.share, _, _ = modulate(potential, max(0.0, min(purse.energy, allowed)), inf)
        purse.wanting = self.share < 1.0
        return Pull(options.stiffness, damping, plus(place, scaled(self.share, gap)), ZERO)

    def settle(self, force: Vector, moved: Vector) -> None:
        """Books the step; as `ProxyEnd.settle`."""
        self.purse.book(dot(force, moved))
        self._unheard.append(self.purse.word.given)
        if len(self._unheard) > _WORDS:
            self._older = max(self._older, self._unheard.popleft())

    def _acknowledge(self, heard: float) -> None:
        """Forgets what was told before the word that the device has heard."""
        if heard in self._unheard:
            self._older = -inf
            while self._unheard[0] != heard:
                self._unheard.popleft()


def saturated(gap: Vector, options: EndOptions) -> Vector:
    """A gap shortened to what the motors can do: its spring is the slope of a convex energy, no steeper than k."""
    pull = options.stiffness * size(gap)
    return gap if pull <= options.most else scaled(options.most / pull, gap)


def device_end(
    options: EndOptions, *, resolution: float, lever: float, radius: float = inf, wall: float = 0.0
) -> DeviceEnd | VirtualDeviceEnd:
    """The device's end, by the law of the options; arguments as for `DeviceEnd`."""
    kind = DeviceEnd if options.law == "pspm" else VirtualDeviceEnd
    return kind(options, resolution=resolution, lever=lever, radius=radius, wall=wall)


def proxy_end(options: EndOptions) -> ProxyEnd | VirtualProxyEnd:
    """The proxy's end, by the law of the options."""
    return ProxyEnd(options) if options.law == "pspm" else VirtualProxyEnd(options)
