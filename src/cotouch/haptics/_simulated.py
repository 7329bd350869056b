"""The simulated devices on a real clock: what a device is when there is none."""

import math
import time
from collections.abc import Callable
from dataclasses import replace
from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.device import (
    PRESETS,
    CartesianPlant,
    Coupling,
    DeviceModel,
    DeviceSpec,
    PhantomPlant,
    ServoModel,
    SimulatedDevice,
    SimulatedHand,
)
from cotouch.errors import DeviceError
from cotouch.haptics._device import DeviceReading, Flag
from cotouch.haptics._registry import Driver
from cotouch.haptics._safety import ZERO, multiple, norm, saturate
from cotouch.haptics._wrist import ROUND, Wrist

VARIANTS = ("phantom", "cartesian", "touch")
# A clock that stood for so long moves the device by no more, so that a cycle stays short [s].
_LONGEST = 0.05
# The hand goes round: so far to the sides, and down to where things are touched [m].
_SWEEP = (0.01, 0.012, 0.03)
_MOST_TURN = 3.0


def simulated_model(
    variant: str = "phantom", *, hand: bool = True, sweep: float = 1.0, viscous: float | None = None
) -> DeviceModel:
    """A device with the hand that leads it.

    Args:
        variant: "phantom" (PHANToM 1.5 with its own dynamics, friction and encoders), "touch" (a mass with the
            friction of a 3D Systems Touch) or "cartesian" (a light mass).
        hand: whether a hand holds it and goes round; else it is free.
        sweep: how far the hand goes, as a factor, 0 to 3.
        viscous: friction of a mass, 0 to 20; None: 0.0125; a PHANToM has that of its joints [Ns/m].

    Raises:
        DeviceError: there is no such variant, a number is out of range, or friction is given for a PHANToM.
    """
    if variant not in VARIANTS:
        raise DeviceError(f'variant is "{variant}"; it must be one of {", ".join(VARIANTS)}')
    if not 0.0 <= sweep <= 3.0:
        raise DeviceError(f"sweep is {sweep:g}; it must be from 0 to 3")
    if viscous is not None and not 0.0 <= viscous <= 20.0:
        raise DeviceError(f"viscous is {viscous:g} Ns/m; it must be from 0 to 20 Ns/m")
    if viscous is not None and variant == "phantom":
        raise DeviceError(
            f"viscous is {viscous:g} Ns/m, but a PHANToM has joints instead; leave it out, or use another variant"
        )
    usual = CartesianPlant()
    viscous = usual.viscous if viscous is None else viscous
    plant = PhantomPlant() if variant == "phantom" else CartesianPlant(viscous=viscous)
    spec = _spec(variant)
    resolution = spec.resolution
    if isinstance(plant, PhantomPlant):
        resolution /= plant.lengths()[0]
    elif variant == "touch":
        plant = CartesianPlant(mass=spec.mass, viscous=viscous, coulomb=spec.friction)
    x, y, z = (sweep * far for far in _SWEEP)
    led = SimulatedHand(path=(0.0, 0.0, 0.0), amplitude=(x, y, -z), frequency=1.0 / ROUND) if hand else None
    return DeviceModel(
        plant=plant,
        servo=ServoModel(resolution=resolution, force=spec.force),
        coupling=Coupling(law="host_force"),
        hand=led,
    )


def with_wrist(spec: DeviceSpec) -> DeviceSpec:
    """Limits of the same device if it rendered torques as a sigma.7 does."""
    return replace(
        spec,
        name=f"{spec.name} with a wrist",
        degrees_of_freedom=6,
        actuated=6,
        torque=0.2,
        continuous_torque=0.2,
        turning_stiffness=1.0,
        turning_damping=0.07,
    )


def _spec(variant: str) -> DeviceSpec:
    return PRESETS["phantom" if variant == "cartesian" else variant]


@final
class SimulatedOnClock:
    """A `SimulatedDevice` that moves in real time; a `Device`.

    Force acts from one exchange to the next, as a device holds what it was told last.

    Attributes:
        spec: of the product that it stands for.
        device: the device behind; None before `open`. Its ledger knows what the motors really did.
        wrist: its handle, if torques turn that; None before `open`, or where the hand alone turns it.
    """

    def __init__(
        self,
        model: DeviceModel,
        spec: DeviceSpec,
        *,
        turn: float = 0.0,
        wrist: bool = False,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Prepares it.

        Args:
            model: with the law `commanded`.
            spec: that it says.
            turn: how far its hand turns the handle to and fro about the upright; 0: it does not measure that, without
                a wrist [rad].
            wrist: whether it renders torques.
            clock: monotonic time [s].

        Raises:
            DeviceError: turn is out of range.
        """
        if not 0.0 <= turn <= _MOST_TURN:
            raise DeviceError(f"turn is {turn:g} rad; it must be from 0 to {_MOST_TURN:g} rad")
        self._turn, self._has_wrist = turn, wrist
        self.spec = with_wrist(spec) if wrist else spec
        self.wrist: Wrist | None = None
        self.device: SimulatedDevice | None = None
        self._model, self._clock = model, clock
        self._behind = 0.0  # the clock's time less the device's
        self._on = self._calibrated = False

    def open(self) -> None:
        """Starts its time; compiles if this machine never did."""
        self.device = SimulatedDevice(self._model)
        self.device.advance(0.0)
        self.wrist = Wrist(turn=self._turn, hand=self._model.hand is not None) if self._has_wrist else None
        self._behind = self._clock()

    def calibrate(self, *, allow_motion: bool) -> None:  # noqa: ARG002
        """Its places are always absolute."""
        self._opened()
        self._calibrated = True

    def enable_force(self, on: bool = True) -> None:
        """Lets the motors follow, or not."""
        self._opened().command(force=(0.0, 0.0, 0.0))
        self._on = on

    def exchange(self, force: Float, torque: Float | None = None) -> DeviceReading:
        """Moves on to now under the force and torque of before, measures, and holds the new ones.

        Args:
            force: on the hand [N].
            torque: on the hand about the tip [Nm].
        """
        device = self._opened()
        now = self._clock()
        ahead = now - self._behind - device.time
        if ahead > _LONGEST:
            self._behind += ahead - _LONGEST
        if not self._on:
            device.command(force=(0.0, 0.0, 0.0))
        sample = device.advance(max(device.time, now - self._behind))
        if not sample.finite:
            raise DeviceError(
                "the simulated device exceeded the floating-point range; its hand or force was too strong"
            )
        wanted = np.asarray(force, dtype=np.float64)
        norm = float(np.linalg.norm(wanted))
        if not math.isfinite(norm):
            raise DeviceError(f"force is {wanted.tolist()} N; it must be finite")
        device.command(force=wanted if self._on else (0.0, 0.0, 0.0))
        held = device.advance(device.time)  # no time passes; the motors take what of the force their torques allow
        turned = self._turned(device.time, torque)
        flags = Flag.CALIBRATED if self._calibrated else Flag(0)
        if self._on:
            flags |= Flag.FORCE_ON | (Flag.LIMITED if held.limited else Flag(0))
        return DeviceReading(
            time=now,
            position=sample.position,
            velocity=sample.velocity,
            force=held.force,
            flags=flags | Flag.HELD if self._model.hand is not None else flags,
            orientation=turned,
            torque=None if self.wrist is None else np.array(self.wrist.torque),
        )

    def stop(self) -> None:
        """Takes the force away; the device has none from the next look at it on."""
        self._on = False

    def close(self) -> None:
        """Stops, and lets go of it."""
        self.stop()
        self.device = None

    def _turned(self, t: float, torque: Float | None) -> Float | None:
        """Its orientation now; from here on it holds the new torque."""
        wrist = self.wrist
        if wrist is None:
            return np.array(Wrist(turn=self._turn, hand=True).hand_turn(t)) if self._turn else None
        if not self._on:
            wrist.torque = ZERO
        wrist.advance(t)
        x, y, z = (0.0, 0.0, 0.0) if torque is None or not self._on else torque.tolist()
        far = norm((x, y, z))
        if not math.isfinite(far):
            raise DeviceError(f"torque is {[x, y, z]} Nm; it must be finite")
        wrist.torque = multiple(saturate(far, self.spec.torque), (x, y, z))
        return np.array(wrist.orientation)

    def _opened(self) -> SimulatedDevice:
        if self.device is None:
            raise DeviceError("the simulated device is not open; open it first")
        return self.device


def _halt(**options: str | float | bool) -> None:
    """Nothing: a simulated device stands still together with the process that drives it, and moves nobody meanwhile."""
    del options


def _make(
    *,
    variant: str = "phantom",
    hand: bool = True,
    sweep: float = 1.0,
    viscous: float | None = None,
    turn: float = 0.0,
    wrist: bool = False,
) -> SimulatedOnClock:
    friction = None if viscous is None else float(viscous)
    model = simulated_model(variant, hand=hand, sweep=float(sweep), viscous=friction)
    return SimulatedOnClock(model, _spec(variant), turn=float(turn), wrist=wrist is True)


SIMULATED = Driver(
    name="simulated",
    summary="a simulated PHANToM 1.5, Touch or light mass, with a hand that moves in circles",
    make=_make,
    spec=PRESETS["phantom"],
    variants=VARIANTS,
    options={
        "hand": "whether a hand holds it: true or false",
        "sweep": "how far the hand moves, a factor from 0 to 3",
        "viscous": "friction of a Touch or light mass, 0 to 20 Ns/m",
        "turn": "how far the hand turns its handle to and fro, 0 to 3 rad",
        "wrist": "whether it renders torques: true or false",
    },
    halt=_halt,
    watchdog="It runs in the process that drives it, and ends with it.",
    tested="itself",
)
"""The driver of the simulated devices."""
