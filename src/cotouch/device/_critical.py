"""The known answer of haptics: how stiff a sampled wall may be before a device rings against it."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import inf

from cotouch.device._advance import advance
from cotouch.device._assemble import assemble
from cotouch.device._checks import need
from cotouch.device._coupling_model import Coupling
from cotouch.device._models import CartesianPlant, DeviceModel, ServoModel, SimulatedHand
from cotouch.device._tables import KINETIC, Devices, DeviceState
from cotouch.errors import DeviceError
from cotouch.kernels import at, kernel

# How far the wall is from where the device starts [m]; the loop is linear, so it does not matter.
_KICK = 1e-3
# Times m / b that are looked at: the envelope's decay without the wall is then e^-8 in energy.
_SPANS = 8.0
_RUNAWAY = 1e6


@kernel
def peak_kinetic(devices: Devices, state: DeviceState, d: int, until: float, step: float, stop: float) -> float:
    """Largest kinetic energy until then, looked at every `step`; ends early above `stop` [J].

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
        until: time [s].
        step: between two looks [s].
        stop: energy above which it ends [J].
    """
    start = at(state.time, d)
    count = round((until - start) / step)
    peak = 0.0
    for k in range(1, count + 1):
        fine = advance(devices, state, d, start + k * step)
        peak = max(peak, at(state.ledger, (d, KINETIC)))
        if not fine or peak > stop:
            return inf
    return peak


def rings(model: DeviceModel, span: float, step: float) -> bool:
    """Whether the oscillation of a device that is let go beside its wall grows.

    Args:
        model: with the law `spring`.
        span: to watch [s]; the largest kinetic energy of its second quarter is held against that of its last.
        step: between looks [s].
    """
    devices, state = assemble([model])
    state.desired[0, 0] += _KICK
    stop = _RUNAWAY * model.coupling.stiffness * _KICK**2
    peaks = [peak_kinetic(devices, state, 0, 0.25 * quarter * span, step, stop) for quarter in (1, 2, 3, 4)]
    return not peaks[3] < peaks[1]


def critical_stiffness(
    plant: CartesianPlant,
    hand: SimulatedHand | None = None,
    *,
    period: float = 1e-3,
    lag: int = 0,
    precision: float = 1e-3,
) -> float:
    """The stiffness at which a device begins to ring against a sampled spring wall, found by simulation [N/m].

    For a mass m with friction b it is close to 2b / period, with one sample of lag 2b / (3 period) [Colgate & Schenkel
    1997; Diolaiti et al. 2006].

    Args:
        plant: with viscous friction, or a hand that has some.
        hand: that holds the device and stands still; None: nobody.
        period: of the servo, > 0 [s].
        lag: samples by which the wall sees the device late, 0 to 8.
        precision: relative, of the answer, > 0.

    Raises:
        DeviceError: nothing damps the device, or an argument is out of range.
    """
    need("precision", precision, above=True, most=0.5)
    damping = plant.viscous + (hand.grip * hand.damping if hand else 0.0)
    mass = plant.mass + (hand.mass if hand else 0.0)
    if not damping > 0.0:
        raise DeviceError("viscous is 0 Ns/m and no hand damps the device; no wall is then soft enough")
    span = _SPANS * mass / damping

    def unstable(stiffness: float) -> bool:
        coupling = Coupling(law="spring", stiffness=stiffness, damping=0.0, lag=lag)
        servo = ServoModel(period=period, window=0.0, substep=min(1e-4, 0.1 * period))
        return rings(DeviceModel(plant=plant, servo=servo, coupling=coupling, hand=hand), span, period)

    low = 0.1 * damping / period
    high = 2.0 * low
    while not unstable(high):
        low, high = high, 2.0 * high
    while high > low * (1.0 + precision):
        middle = (low * high) ** 0.5
        low, high = (low, middle) if unstable(middle) else (middle, high)
    return (low * high) ** 0.5
