"""One cycle of the servo, without a clock, a device or another process: readings and orders in, forces out."""

from collections.abc import Sequence
from math import inf, isfinite
from typing import NamedTuple, final

from cotouch.arrays import Float
from cotouch.coupling import EnergyMessage
from cotouch.device import DeviceSpec
from cotouch.haptics._device import DeviceReading, Flag
from cotouch.haptics._ends import DeviceEnd, EndOptions, checked
from cotouch.haptics._limits import SafetyLimits
from cotouch.haptics._measured import MeasuredMotion
from cotouch.haptics._quaternions import Quaternion, quaternion
from cotouch.haptics._safety import NO_CAUSE, ZERO, Cause, Observation, SafetyChain, Vector, multiple, norm
from cotouch.haptics._turning import TurningEnd, at_arm
from cotouch.haptics._virtual import checked_virtual

# A button held down for so long, with the device slow, re-arms [s, m/s].
_REARM, _SLOW = 1.0, 0.1
# Longest arm that the charge for turning forces assumes where a workspace is unknown [m].
_LEVER = 0.1


class Order(NamedTuple):
    """A message from the peer's process.

    Attributes:
        time: when, on the clock that both share [s].
        step: of the peer.
        place: of the proxy, in the device's frame [m]; None: there is none to follow.
        message: of the proxy's end.
        enable: whether force is wanted.
        rearm: rises by one each time that somebody re-arms.
        coupling: number of the coupling that is meant; rises by one with each.
        options: of that coupling; None: those that the servo began with.
        turning: of its coupling of turning, as for places at the arm (`_turning.py`); None: no torque is wanted.
        orientation: of the proxy, in the device's frame, quaternion xyzw; None: there is none to follow.
        twist: of the proxy's end of turning.
    """

    time: float
    step: int = 0
    place: Vector | None = None
    message: EnergyMessage = EnergyMessage()
    enable: bool = False
    rearm: int = 0
    coupling: int = 0
    options: EndOptions | None = None
    turning: EndOptions | None = None
    orientation: Quaternion | None = None
    twist: EnergyMessage = EnergyMessage()


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
    """What the servo reports about a cycle.

    Attributes:
        time: of the reading [s].
        tick: so many so far.
        place: of the tip, as the coupling takes it [m].
        rate: its velocity, over 10 ms [m/s].
        force: for the motors from the next exchange on [N].
        wanted: by the coupling and the wall, before the safety chain [N].
        message: of the device's end.
        work: of the motors so far, as measured, of torques too [J].
        excess: of it beyond what may, of forces or of torques, whichever is more [J]; <= 0.
        causes: why force was removed.
        buttons: bit n is button n.
        flags: of the device.
        coupling: number of the coupling, as the last order had it.
        orientation: of the handle, quaternion xyzw, as the coupling takes it; None: the device does not say.
        torque: for the motors from the next exchange on [Nm].
        spin: angular velocity over 10 ms; of a device that renders torques [rad/s].
        twist: of the device's end of turning.
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
    torque: Vector = ZERO
    spin: Vector = ZERO
    twist: EnergyMessage = EnergyMessage()


@final
class ServoCore:
    """Coupling, wall, safety chain and passivity observer of one device.

    Each cycle: `exchange` the force of the last report with the device, then `cycle` with what came back.

    Attributes:
        end: the device's end of the coupling.
        turning: that of turning; None: no torque is wanted.
        chain: the safety chain. Torque has one of its own with its own limits, heat and slew, which sees the same and
            takes over whatever is latched or broken: force and torque go together.
        coupling: number of the coupling.
    """

    def __init__(
        self,
        spec: DeviceSpec,
        limits: SafetyLimits,
        options: EndOptions,
        *,
        turning_limits: SafetyLimits | None = None,
        period: float = 1e-3,
    ) -> None:
        """Off.

        Args:
            spec: of the device.
            limits: of the safety chain.
            options: of the coupling.
            turning_limits: of the safety chain for torques, as forces at the arm; None: the default for the device.
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
        self.turning: TurningEnd | None = None
        self._turning_chain: SafetyChain | None = None
        if spec.torque > 0.0:
            self._turning_chain = SafetyChain(turning_limits or SafetyLimits.of(at_arm(spec)))
        self._force = ZERO
        self._begun: float | None = None
        self._last = self._fresh = self._measured = 0.0
        self._seen = MeasuredMotion(limits.force)
        self._tick = 0
        self._pressed: float | None = None
        self._armed: int | None = None

    @property
    def order(self) -> Order:
        """The newest."""
        return self._order

    @property
    def observed_bound(self) -> float:
        """What sampling alone may have made of the motion so far, at most [J]; part of the d² of two-port passivity."""
        return self._seen.bound

    def receive(self, order: Order) -> None:
        """Takes the newest order.

        Raises:
            DeviceError: it brings a coupling that does not fit the device.
        """
        self._order, self._came = order, None
        if order.coupling > self.coupling and order.options is not None:
            self._couple(order)
        if self._armed is not None and order.rearm > self._armed:
            self.chain.rearm()
        self._armed = order.rearm if self._armed is None else max(self._armed, order.rearm)

    def _made(self, options: EndOptions) -> DeviceEnd:
        spec, limits = self._spec, self._limits
        lever = spec.workspace if isfinite(spec.workspace) and spec.workspace > 0.0 else _LEVER
        if checked(options, spec).law == "virtual":
            checked_virtual(options, spec, period=self._period)
        return DeviceEnd(options, resolution=spec.resolution, lever=lever, radius=limits.radius, wall=limits.wall)

    def _couple(self, order: Order) -> None:
        """Begins anew with another coupling: relaxed, with a ledger of its own, and with the ramp."""
        assert order.options is not None
        self.end, self.coupling = self._made(order.options), order.coupling
        self.chain.restart()
        self._force = ZERO
        self._seen.restart()
        self.turning = None
        if self._turning_chain is not None:
            self._turning_chain.restart()
            if order.turning is not None:
                arc, most = at_arm(self._spec), self._turning_chain.limits.force
                self.turning = TurningEnd(checked(order.turning, arc), resolution=arc.resolution, most=most)

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
        if not isfinite(norm(place)):
            self.chain.fail(Cause.FAULT)
            place = self._seen.place or ZERO
        said = _vector(reading.force)
        self._seen.observe(place, T, self._force, self.end)
        since = max(T, reading.time - self._measured)  # a place that stood still has moved for longer
        self.end.measure(place, self._force, said if isfinite(norm(said)) else None, since)
        self._measured = max(reading.time, self._measured)
        taken = self.end.place or place
        quick, rate = self._seen.quick(reading.time, taken, place), self._seen.rate
        if first or not reading.flags & Flag.STALE:
            self._fresh = now
        self._buttons(reading.buttons, norm(rate), now)
        order = self._order
        self._came = now if self._came is None else self._came
        gone = silent_for(order.time, self._came, now)
        desired = order.place if gone < self._limits.zero_after else None
        if desired is not None and not isfinite(norm(desired)):
            self.chain.fail(Cause.FAULT)
            desired = None
        wanted = self.end.decide(desired, rate, order.message, T)
        orientation = quaternion(reading.orientation)
        turning = self.turning
        quick = max(quick, self._turn(reading, orientation, T, since, followed=desired is not None))
        excess, work = self._seen.excess(self.end), self._seen.work
        if turning is not None:
            excess, work = max(excess, turning.seen.excess(turning.end)), work + turning.seen.work
        seen = Observation(
            now=now,
            T=T,
            age=gone,
            stale=now - self._fresh,
            speed=max(quick, _finite(norm(_vector(reading.velocity)))),
            excess=excess,
            enabled=order.enable,
            follows=bool(reading.flags & Flag.FORCE_ON),
            unwatched=unwatched,
        )
        fraction = self.chain.limit(wanted, seen)
        self._force = multiple(fraction, wanted)
        causes = self.chain.causes | self._limit_torque(seen)
        return ServoReport(
            time=reading.time,
            tick=self._tick,
            place=taken,
            rate=rate,
            force=self._force,
            wanted=wanted if isfinite(norm(wanted)) else ZERO,
            message=self.end.message,
            work=work,
            excess=excess,
            causes=causes,
            buttons=reading.buttons,
            flags=reading.flags,
            coupling=self.coupling,
            orientation=orientation if turning is None else turning.orientation,
            torque=ZERO if turning is None else turning.torque,
            spin=ZERO if turning is None else turning.spin,
            twist=EnergyMessage() if turning is None else turning.end.message,
        )

    def _turn(
        self, reading: DeviceReading, orientation: Quaternion | None, T: float, since: float, *, followed: bool
    ) -> float:
        """Takes how the handle is turned, and what the coupling wants of that; how quick it was [m/s at the arm]."""
        turning, order = self.turning, self._order
        if turning is None:
            return 0.0
        goal = quaternion(order.orientation) if followed else None
        if orientation is None or (followed and order.orientation is not None and goal is None):
            self.chain.fail(Cause.FAULT)
            turning.wanted = ZERO
            return 0.0
        said = None if reading.torque is None else _vector(reading.torque)
        said = said if said is not None and isfinite(norm(said)) else None
        quick = turning.measure(orientation, reading.time, said, T, since)
        turning.decide(goal, order.twist, T)
        if not isfinite(norm(turning.wanted)):
            self.chain.fail(Cause.FAULT)
        return quick

    def _limit_torque(self, seen: Observation) -> Cause:
        """Holds the torque to its limits; why there is less than was asked for."""
        turning, chain = self.turning, self._turning_chain
        if turning is None or chain is None:
            return NO_CAUSE
        chain.latched, chain.broken = self.chain.latched, self.chain.broken
        turning.force = multiple(chain.limit(turning.wanted, seen), turning.wanted)
        return chain.causes

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


def _finite(value: float) -> float:
    return value if isfinite(value) else 0.0
