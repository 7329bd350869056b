"""One simulated device as an object."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import final

from cotouch.coupling import EnergyMessage, hear, message_of
from cotouch.device._advance import advance
from cotouch.device._assemble import assemble
from cotouch.device._checks import need, triple
from cotouch.device._models import DeviceModel
from cotouch.device._tables import DEVICE_LEDGER, SATURATED, Float
from cotouch.errors import DeviceError


@final
@dataclass(frozen=True, kw_only=True)
class DeviceSample:
    """What a device says after a cycle.

    Attributes:
        time: of the measurement [s].
        position: of the tip as measured, (3,) [m].
        velocity: as measured, over the servo's window, (3,) [m/s].
        force: that the motors hold now, (3,) [N].
        message: for the proxy's end of a coupling.
        limited: whether force or torque has been limited since the sample before.
        finite: whether the motion is within the range of floating point.
    """

    time: float
    position: Float
    velocity: Float
    force: Float
    message: EnergyMessage
    limited: bool
    finite: bool


@final
class SimulatedDevice:
    """A device with its servo and perhaps a hand, moved by the same kernels as in a batch.

    `command` hands over what the proxy's side says, `advance` moves the device on; with the law `host_force`,
    `exchange` is one cycle of both. The clock is the caller's.
    """

    def __init__(self, model: DeviceModel) -> None:
        self.model = model
        self._devices, self._state = assemble([model])

    @property
    def time(self) -> float:
        """Where the device is in time [s]."""
        return float(self._state.time[0])

    @property
    def position(self) -> Float:
        """True place of the tip, (3,) [m]."""
        return self._state.tip[0, :3].copy()

    @property
    def ledger(self) -> dict[str, float]:
        """Energies by name, as `DEVICE_LEDGER`: cumulative work and losses, stored now [J]."""
        return dict(zip(DEVICE_LEDGER, self._state.ledger[0].tolist(), strict=True))

    def command(
        self,
        *,
        desired: Sequence[float] | Float | None = None,
        force: Sequence[float] | Float | None = None,
        message: EnergyMessage | None = None,
    ) -> None:
        """Takes over what the proxy's side says; what is None stays.

        Args:
            desired: the proxy's place [m].
            force: for the law `host_force` [N].
            message: of the proxy's end of a coupling, however old.

        Raises:
            DeviceError: a number is not finite.
        """
        if desired is not None:
            self._state.desired[0, :3] = triple("desired", list(desired))
        if force is not None:
            self._state.host_force[0, :3] = triple("force", list(force))
        if message is not None:
            hear(self._state.ends[0], message)

    def advance(self, until: float) -> DeviceSample:
        """Moves on to a time; all ticks up to then and at it happen.

        Args:
            until: not before `time` [s].

        Raises:
            DeviceError: it is before, or no number.
        """
        need("until", until, least=self.time, unit="s")
        state = self._state
        before = state.ledger[0, SATURATED]
        finite = bool(advance(self._devices, state, 0, until))
        return DeviceSample(
            time=float(state.sample_time[0]),
            position=state.sample[0, :3].copy(),
            velocity=state.sample_velocity[0, :3].copy(),
            force=state.force[0, :3].copy(),
            message=message_of(state.ends[0]),
            limited=bool(state.ledger[0, SATURATED] > before),
            finite=finite,
        )

    def exchange(self, force: Sequence[float] | Float) -> DeviceSample:
        """One cycle: holds a force for the servo's next period, then measures.

        Args:
            force: at the tip [N].

        Raises:
            DeviceError: the law is not `host_force`, or the force is not finite.
        """
        if self.model.coupling.law != "host_force":
            raise DeviceError(f'law is "{self.model.coupling.law}"; to exchange forces it must be "host_force"')
        self.command(force=force)
        periods = self.model.servo.periods()
        return self.advance(self.time + periods[int(self._state.ticks[0]) % len(periods)])
