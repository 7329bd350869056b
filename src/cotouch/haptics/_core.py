"""One cycle of the servo, without a clock, a device or another process: readings and orders in, forces out."""

from collections import deque
from collections.abc import Sequence
from math import inf, isfinite
from typing import NamedTuple, final

from cotouch.arrays import Float
from cotouch.device import DeviceSpec
from cotouch.haptics._device import DeviceReading, Flag
from cotouch.haptics._ends import WINDOW, DeviceEnd, EndOptions, checked
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._port import less
from cotouch.haptics._safety import ZERO, Cause, Observation, SafetyChain, Vector, scaled, size
from cotouch.haptics._virtual import checked_virtual
from cotouch.mechanics import EnergyMessage

# The safety chain's speed is that over this [s]: shorter, and one step of an encoder looks quick; longer, and a device
# that is flung away has been so for long.
_QUICK = 0.004
# A button held down for so long, with the device slow, re-arms [s, m/s].
_REARM, _SLOW = 1.0, 0.1
# Slack of the passivity observer for rounding [J].
_SLACK = 1e-6
# Longest arm that the charge for turning forces assumes where a workspace is unknown [m].
_LEVER = 0.1
# By how much the square of an orientation's length may be off one.
_UNIT = 2e-3


Quaternion = tuple[float, float, float, float]


class Order(NamedTuple):
    """What the peer's process says.

    Attributes:
        time: when, on the clock that both share [s].
        step: of the peer.
        place: of the proxy, in the device's frame [m]; None: there is none to follow.
        message: of the proxy's end.
        enable: whether force is wanted.
        rearm: rises by one each time that somebody re-arms.
        coupling: number of the coupling that is meant; rises by one with each.
        options: of that coupling; None: those that the servo began with.
    """

    time: float
    step: int = 0
    place: Vector | None = None
    message: EnergyMessage = EnergyMessage()
    enable: bool = False
    rearm: int = 0
    coupling: int = 0
    options: EndOptions | None = None


_NONE = Order(time=-inf)
# How far ahead of the clock a stamp may be: clocks of two cores may differ by microseconds [s].
_AHEAD = 1e-3


def silent_for(said: float, came: float, now: float) -> float:
    """For how long nothing has been heard of another process [s].

    Its stamp alone is not believed: one ahead of the clock, or infinite, would keep an order fresh long after its
    sender hangs. So what counts is when it came, too, and a stamp from the future is silence.

    Args:
        said: its stamp on what it said last [s].
        came: when that was first seen here; -inf: never [s].
        now: [s].

    Returns:
        >= 0; inf if the stamp is none.
    """
    if not said <= now + _AHEAD:
        return inf
    return max(0.0, now - said, now - came)


class ServoReport(NamedTuple):
    """What the servo says of a cycle.

    Attributes:
        time: of the reading [s].
        tick: so many so far.
        place: of the tip, as the coupling takes it [m].
        rate: its velocity, over 10 ms [m/s].
        force: for the motors from the next exchange on [N].
        wanted: by the coupling and the wall, before the safety chain [N].
        message: of the device's end.
        work: of the motors so far, as measured [J].
        excess: of it beyond what may [J]; <= 0.
        causes: why force was removed.
        buttons: bit n is button n.
        flags: of the device.
        coupling: number of the coupling, as the last order had it.
        orientation: of the handle, quaternion xyzw; None: the device does not say.
    """

    time: float
    tick: int
    place: Vector
    rate: Vector
    force: Vector
    wanted: Vector
    message: EnergyMessage
    work: float
    excess: float
    causes: Cause
    buttons: int
    flags: Flag
    coupling: int = 0
    orientation: Quaternion | None = None


@final
class ServoCore:
    """Coupling, wall, safety chain and passivity observer of one device.

    Each cycle: `exchange` the force of the last report with the device, then `cycle` with what came back.

    Attributes:
        end: the device's end of the coupling.
        chain: the safety chain.
        coupling: number of the coupling.
    """

    def __init__(self, spec: DeviceSpec, limits: SafetyLimits, options: EndOptions, *, period: float = 1e-3) -> None:
        """Off.

        Args:
            spec: of the device.
            limits: of the safety chain.
            options: of the coupling.
            period: of the servo, by which a virtual coupling is judged [s].

        Raises:
            DeviceError: the coupling does not fit the device.
        """
        self._spec, self._limits, self._period = spec, limits, period
        self.coupling = 0
        self.end = self._made(options)
        self.chain = SafetyChain(limits)
        self._order = _NONE
        self._came: float | None = -inf  # when the order was there first; None: since the last cycle
        self._force = ZERO
        self._begun: float | None = None
        self._last = self._fresh = self._measured = 0.0
        self._rate = ZERO
        self._tick = 0
        self._path = deque[tuple[float, Vector, Vector]]()
        self._place: Vector | None = None
        self._farthest = self._longest = self._bound = 0.0
        self._out = 0.0  # work of the motors by the observer's own ledger [J]
        self._acted = ZERO
        self._pressed: float | None = None
        self._armed: int | None = None

    @property
    def order(self) -> Order:
        """The newest."""
        return self._order

    @property
    def observed_bound(self) -> float:
        """What sampling alone may have made of the motion so far, at most [J]; part of the d² of two-port passivity."""
        return self._bound

    def receive(self, order: Order) -> None:
        """Takes the newest order.

        Raises:
            DeviceError: it brings a coupling that does not fit the device.
        """
        self._order, self._came = order, None
        if order.coupling > self.coupling and order.options is not None:
            self._couple(order.options, order.coupling)
        if self._armed is not None and order.rearm > self._armed:
            self.chain.rearm()
        self._armed = order.rearm if self._armed is None else max(self._armed, order.rearm)

    def _made(self, options: EndOptions) -> DeviceEnd:
        spec, limits = self._spec, self._limits
        lever = spec.workspace if isfinite(spec.workspace) and spec.workspace > 0.0 else _LEVER
        if checked(options, spec).law == "virtual":
            checked_virtual(options, spec, period=self._period)
        return DeviceEnd(options, resolution=spec.resolution, lever=lever, radius=limits.radius, wall=limits.wall)

    def _couple(self, options: EndOptions, number: int) -> None:
        """Begins anew with another coupling: relaxed, with a ledger of its own, and with the ramp."""
        self.end, self.coupling = self._made(options), number
        self.chain.restart()
        self._force = self._acted = ZERO
        self._place = None
        self._farthest = self._longest = self._bound = self._out = 0.0

    def cycle(self, reading: DeviceReading, now: float, unwatched: float = 0.0) -> ServoReport:
        """One cycle.

        Args:
            reading: what the device gave in exchange for the force of the last report.
            now: on the clock of the peer's orders [s].
            unwatched: for how long nothing is heard of whoever watches over this loop [s].
        """
        first = self._begun is None
        T = 0.0 if first else max(0.0, now - self._last)
        self._begun = now if self._begun is None else self._begun
        self._last = now
        self._tick += 1
        place = _vector(reading.position)
        if not isfinite(size(place)):
            self.chain.fail(Cause.FAULT)
            place = self._place or ZERO
        said = _vector(reading.force)
        self._observe(place, T)
        since = max(T, reading.time - self._measured)  # a place that stood still has moved for longer
        self.end.measure(place, self._force, said if isfinite(size(said)) else None, since)
        self._place, self._measured = place, max(reading.time, self._measured)
        taken = self.end.place or place
        rate, quick = self._rates(reading.time, taken, place)
        if first or not reading.flags & Flag.STALE:
            self._fresh = now
        self._buttons(reading.buttons, size(rate), now)
        order = self._order
        self._came = now if self._came is None else self._came
        gone = silent_for(order.time, self._came, now)
        desired = order.place if gone < self._limits.zero_after else None
        if desired is not None and not isfinite(size(desired)):
            self.chain.fail(Cause.FAULT)
            desired = None
        wanted = self.end.decide(desired, rate, order.message, T)
        excess = self._excess()
        fraction = self.chain.limit(
            wanted,
            Observation(
                now=now,
                T=T,
                age=gone,
                stale=now - self._fresh,
                speed=max(quick, _finite(size(_vector(reading.velocity)))),
                excess=excess,
                enabled=order.enable,
                follows=bool(reading.flags & Flag.FORCE_ON),
                unwatched=unwatched,
            ),
        )
        self._force = scaled(fraction, wanted)
        return ServoReport(
            time=reading.time,
            tick=self._tick,
            place=taken,
            rate=rate,
            force=self._force,
            wanted=wanted if isfinite(size(wanted)) else ZERO,
            message=self.end.message,
            work=self._out,
            excess=excess,
            causes=self.chain.causes,
            buttons=reading.buttons,
            flags=reading.flags,
            coupling=self.coupling,
            orientation=_orientation(reading.orientation),
        )

    def _observe(self, place: Vector, T: float) -> None:
        """The observer's ledger: nothing but forces that were told and measured places."""
        if self._place is not None:
            before = self._place
            moved = less(place, before)
            self._out += sum(f * m for f, m in zip(self._acted, moved, strict=True))
            far = size(moved)
            if T > 0.0 and (far > self._farthest or self._longest < T):
                self._farthest, self._longest = max(self._farthest, far), max(self._longest, T)
                self._bound = max(self._bound, self.end.bound(far / T, T, self._limits.force))
        self._acted = self._force

    def _excess(self) -> float:
        """Work of the motors beyond what the peer gave, the initial energy and the bound of sampling [J]."""
        return self._out - (self.end.due + self.end.start + self._bound + _SLACK)

    def _rates(self, time: float, taken: Vector, place: Vector) -> tuple[Vector, float]:
        """Velocity over the window as the law takes it, and the quickest of the last moments as measured [m/s].

        Times are those of the measurements: a loop that is late takes nothing for quick.
        """
        path = self._path
        if path and time <= path[-1][0]:
            return self._rate, 0.0
        path.append((time, taken, place))
        while len(path) > 2 and path[1][0] <= time - WINDOW:
            path.popleft()
        if len(path) < 2:
            return ZERO, 0.0
        then, start, _ = path[0]
        self._rate = scaled(1.0 / (time - then), less(taken, start))
        quick = 0.0
        for recent, _, there in reversed(path):
            if time - recent >= _QUICK:
                quick = size(less(place, there)) / (time - recent)
                break
        return self._rate, quick

    def _buttons(self, buttons: int, speed: float, now: float) -> None:
        """Whoever holds the device re-arms it by holding its first button."""
        if not buttons & 1 or speed > _SLOW or not self.chain.latched:
            self._pressed = None
        elif self._pressed is None:
            self._pressed = now
        elif now - self._pressed >= _REARM:
            self.chain.rearm()
            self._pressed = None


def _vector(array: Sequence[float] | Float) -> Vector:
    x, y, z = array
    return float(x), float(y), float(z)


def _orientation(given: Float | None) -> Quaternion | None:
    """As it is handed on: a unit quaternion, or none."""
    if given is None:
        return None
    x, y, z, w = (float(value) for value in given)
    return (x, y, z, w) if abs(x * x + y * y + z * z + w * w - 1.0) < _UNIT else None


def _finite(value: float) -> float:
    return value if isfinite(value) else 0.0
