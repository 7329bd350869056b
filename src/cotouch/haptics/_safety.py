"""The last things between a force and the motors: each can only shorten it, so all limits hold together.

A stage gives a share in [0, 1] of the force that it is shown. What comes out is the product of the shares times what
came in: its direction is kept, no stage undoes another, and the energy ledger needs to know only the force that is
    left.
"""

from enum import IntFlag
from math import inf, isfinite, sqrt
from typing import NamedTuple, final

from cotouch.haptics._limits import SafetyLimits

Vector = tuple[float, float, float]
ZERO: Vector = (0.0, 0.0, 0.0)
# From nothing to all that is left of the heat budget [s]; so long the force takes to come down to what may stay.
_COOLING = 1.0
# A loop that stood still for longer may find that its device, or whoever watches, has taken the force away; so it gives
# it back by the ramp. Two cycles of a peer at 100 Hz, and what a watchdog in a device allows [s].
STOOD = 0.02


@final
class Cause(IntFlag):
    """Why there is less force than requested.

    Attributes:
        SATURATED: it was beyond the largest.
        SLEW: it rose too quickly.
        RAMP: it is coming back from nothing.
        HOT: the motors have been given much for long.
        QUIET: the peer has said nothing for a while, and the force fades.
        SILENT: the peer is gone.
        LATE: the device was late, or this loop stood still for so long that others may have taken the force away.
        OFF: nobody enabled it.
        DEVICE: the device itself has switched its motors off.
        FAST: it was faster than a hand; latched until re-armed.
        ACTIVE: more energy came out of the motors than may; latched until re-armed.
        FAULT: something was no number, or the device failed; for good.
        PARENT: whoever watches this loop is gone; for good.
        PEER: the peer's process is gone; for good.
        UNWATCHED: whoever watches this loop stands still.
        STOPPED: this loop was told to end.
    """

    SATURATED = 1
    SLEW = 2
    RAMP = 4
    HOT = 8
    QUIET = 16
    SILENT = 32
    LATE = 64
    OFF = 128
    DEVICE = 256
    FAST = 512
    ACTIVE = 1024
    FAULT = 2048
    PARENT = 4096
    PEER = 8192
    UNWATCHED = 16384
    STOPPED = 32768


NO_CAUSE = Cause(0)
LATCHED = Cause.FAST | Cause.ACTIVE
FOR_GOOD = Cause.FAULT | Cause.PARENT | Cause.PEER | Cause.STOPPED
# After which force comes back from nothing.
_REMOVED = Cause.SILENT | Cause.LATE | Cause.OFF | Cause.DEVICE | LATCHED | FOR_GOOD
_SENTENCES = {
    Cause.FAULT: "the device failed or returned no valid numbers",
    Cause.PARENT: "the program that watches over the device is gone",
    Cause.PEER: "the peer's program is gone",
    Cause.STOPPED: "the device was let go",
    Cause.ACTIVE: "the motors gave more energy than allowed; re-arm to continue",
    Cause.FAST: "the device moved faster than any hand; re-arm to continue",
    Cause.DEVICE: "the device has switched its motors off, by its own button or for lack of commands",
    Cause.OFF: "force is not enabled",
    Cause.UNWATCHED: "the program that watches over the device has stopped",
    Cause.SILENT: "the peer has been silent for too long",
    Cause.LATE: "the device or its loop was late",
    Cause.QUIET: "the peer is late",
    Cause.HOT: "the motors are at the limit of what they can sustain",
    Cause.RAMP: "the force is coming back",
    Cause.SATURATED: "the force was beyond its limit",
    Cause.SLEW: "the force rose too quickly",
}


def spoken(cause: Cause) -> str:
    """The most severe of several causes in words; empty if there is none."""
    return next((text for one, text in _SENTENCES.items() if cause & one), "")


def reasons(cause: Cause) -> list[str]:
    """All of several causes in words, the most severe first."""
    return [text for one, text in _SENTENCES.items() if cause & one]


def norm(vector: Vector) -> float:
    """Euclidean norm."""
    return sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2])


def dot(a: Vector, b: Vector) -> float:
    """Inner product.

    Args:
        a: one, 3 numbers.
        b: the other, 3 numbers.
    """
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def multiple(fraction: float, vector: Vector) -> Vector:
    """A multiple; a share of 0 gives 0 whatever the vector is.

    Args:
        fraction: the factor.
        vector: 3 numbers.
    """
    return (fraction * vector[0], fraction * vector[1], fraction * vector[2]) if fraction else ZERO


def saturate(length: float, most: float) -> float:
    """Fraction of a force of this length that is within a limit [N].

    Args:
        length: of the force, >= 0 [N].
        most: the limit [N].
    """
    return 1.0 if length <= most else most / length


def silence(age: float, fade_after: float, zero_after: float) -> float:
    """Fraction of a force that is left at this age of its source: all, fading, none [s].

    Args:
        age: of the reason [s].
        fade_after: age from which the force fades [s].
        zero_after: age from which there is none [s].
    """
    if not age < zero_after:
        return 0.0
    return 1.0 if age <= fade_after else (zero_after - age) / (zero_after - fade_after)


def slew(force: Vector, before: Vector, most: float) -> float:
    """Largest fraction of a force to which the slew limit lets the last one change at once.

    Letting go is never limited, or a force would outlast its energy: what counts is how far the new force is from all
    those that lie between none and the one before.

    Args:
        force: wanted [N].
        before: held until now [N].
        most: farthest [N].
    """
    length = norm(force)
    if length <= most:
        return 1.0
    was = norm(before)
    along = dot(force, before) / length  # of the force before, along the new one
    if along <= 0.0 or was == 0.0:
        return most / length
    aside = sqrt(max(0.0, was * was - along * along))  # its distance from the new one's line
    if aside * length <= 1e-9 * was * length:
        return min(1.0, (was + most) / length)
    # While the nearest of those is not the force before itself, the distance grows as the sine of the angle.
    turned = most * was / aside  # length at which it is `most`
    if turned * along <= was * was:
        return min(1.0, turned / length)
    return min(1.0, (along + sqrt(max(0.0, most * most - aside * aside))) / length)


@final
class Heat:
    """Heat of the motors: the squared force, forgotten with a time constant; never more than may persist."""

    def __init__(self, continuous: float, time: float) -> None:
        """Cold.

        Args:
            continuous: force that may stay [N]; infinite: no limit.
            time: constant [s].
        """
        self._most, self._time = continuous * continuous, time
        self.square = 0.0

    @property
    def limit(self) -> float:
        """Largest force now [N]: more than may stay as long as there is room, and coming down to it smoothly."""
        if self._most == inf:
            return inf
        return sqrt(self._most + max(0.0, self._most - self.square) * (self._time / _COOLING))

    def hold(self, force: float, T: float) -> None:
        """Books that so much force was held for so long [N, s].

        Args:
            force: its size [N].
            T: how long [s].
        """
        fraction = T / (self._time + T)
        self.square += fraction * (force * force - self.square)


class Observation(NamedTuple):
    """What the safety chain uses in a cycle.

    Attributes:
        now: [s].
        T: since the cycle before [s].
        age: of what the peer said last [s].
        stale: age of what the device said last [s].
        speed: of the tip [m/s].
        excess: energy that came out of the motors beyond what may [J]; <= 0 as it should be.
        enabled: whether force is wanted.
        follows: whether the device says that its motors follow.
        unwatched: for how long nothing is heard of whoever watches over the loop [s].
    """

    now: float
    T: float
    age: float
    stale: float
    speed: float
    excess: float
    enabled: bool
    follows: bool
    unwatched: float = 0.0


@final
class SafetyChain:
    """All stages in sequence.

    Attributes:
        causes: why the last force was less than asked for.
        latched: what keeps the motors off until `rearm`.
        broken: what keeps them off for good.
    """

    def __init__(self, limits: SafetyLimits) -> None:
        """Off.

        Args:
            limits: of the device.
        """
        self.limits = limits
        self.causes = Cause.OFF
        self.latched = NO_CAUSE
        self.broken = NO_CAUSE
        self._heat = Heat(limits.continuous, limits.heat)
        self._before = ZERO
        self._back: float | None = None  # since when force is coming back

    def rearm(self) -> None:
        """Lets go of what is latched; force comes back by the ramp."""
        self.latched = NO_CAUSE

    def restart(self) -> None:
        """Lets the force come back by the ramp; what is latched or broken stays so."""
        self._back, self._before = None, ZERO

    def fail(self, cause: Cause) -> None:
        """Takes the force away for good."""
        self.broken |= cause

    def limit(self, wanted: Vector, seen: Observation) -> float:
        """Share of a force that may go to the motors.

        Args:
            wanted: [N].
            seen: in this cycle.

        Returns:
            In [0, 1]; 0 if anything is no number.
        """
        limits, T = self.limits, seen.T
        self._heat.hold(norm(self._before), T)
        length = norm(wanted)
        if not (isfinite(length) and isfinite(seen.speed)):
            self.fail(Cause.FAULT)
        if seen.speed > limits.speed:
            self.latched |= Cause.FAST
        if seen.excess > 0.0:
            self.latched |= Cause.ACTIVE
        causes = self.latched | self.broken
        if not seen.enabled:
            causes |= Cause.OFF
        elif not seen.follows:
            causes |= Cause.DEVICE
        if not (seen.stale < limits.zero_after and min(STOOD, limits.zero_after) >= T):
            causes |= Cause.LATE
        fraction = silence(seen.age, limits.fade_after, limits.zero_after)
        if fraction < 1.0:
            causes |= Cause.SILENT if fraction == 0.0 else Cause.QUIET
        watched = silence(seen.unwatched, limits.fade_after, limits.zero_after)
        if watched < 1.0:
            causes |= Cause.UNWATCHED
        if causes & _REMOVED or watched == 0.0:
            self.restart()
            self.causes = causes
            return 0.0
        fraction *= watched
        fraction *= silence(seen.stale, limits.fade_after, limits.zero_after)
        self._back = seen.now if self._back is None else self._back
        back = min(1.0, (seen.now - self._back) / limits.ramp)
        fraction *= back
        if back < 1.0:
            causes |= Cause.RAMP
        kept = fraction * length
        most = min(limits.force, self._heat.limit)
        if kept > most:
            causes |= Cause.SATURATED if limits.force <= self._heat.limit else Cause.HOT
            fraction *= saturate(kept, most)
        force = multiple(fraction, wanted)
        rise = slew(force, self._before, limits.force * min(1.0, T / limits.rise))
        if rise < 1.0:
            causes |= Cause.SLEW
            fraction *= rise
            force = multiple(rise, force)
        self._before, self.causes = force, causes
        return fraction
