"""The kernels' tables from checked models."""

from collections.abc import Sequence
from math import inf

import numpy as np

from cotouch.arrays import Long
from cotouch.coupling import END, REST_FIELDS, rest_fraction
from cotouch.device._models import CartesianPlant, DeviceModel, PhantomPlant, SimulatedHand
from cotouch.device._phantom import phantom_potential
from cotouch.device._tables import (
    DEVICE_LEDGER,
    INITIAL,
    PHANTOM,
    POTENTIAL,
    RECALL,
    TANK,
    Devices,
    DeviceState,
    Float,
    Grasps,
    Plants,
    Servos,
)


def assemble(models: Sequence[DeviceModel]) -> tuple[Devices, DeviceState]:
    """Tables of all devices, and where they start: at rest, nothing sent, the desired position where the tip is.

    Args:
        models: one for each device; may be empty.
    """
    devices = Devices(_plants(models), _servos(models), _grasps(models))
    return devices, _start(models, devices)


def _column(values: Sequence[float]) -> Float:
    return np.array(values, dtype=np.float64)


def _integers(values: Sequence[int]) -> Long:
    return np.array(values, dtype=np.int64)


def _rows(values: Sequence[Sequence[float]], width: int = 4) -> Float:
    """Rows padded by zeros to the width."""
    table = np.zeros((len(values), width))
    for row, entries in zip(table, values, strict=True):
        row[: len(entries)] = entries
    return table


def _plants(models: Sequence[DeviceModel]) -> Plants:
    plants = [model.plant for model in models]
    return Plants(
        kind=_integers([plant.kind for plant in plants]),
        mass=_column([plant.mass if isinstance(plant, CartesianPlant) else 0.0 for plant in plants]),
        viscous=_rows([[plant.viscous] * 3 for plant in plants]),
        coulomb=_rows([[plant.coulomb] * 3 for plant in plants]),
        inertia=_rows([plant.inertia() if isinstance(plant, PhantomPlant) else () for plant in plants], 8),
        length=_rows([plant.lengths() if isinstance(plant, PhantomPlant) else () for plant in plants], 2),
        gravity=_rows([plant.weight() if isinstance(plant, PhantomPlant) else () for plant in plants], 2),
        substep=_column([model.servo.substep for model in models]),
    )


def _servos(models: Sequence[DeviceModel]) -> Servos:
    servos, couplings = [model.servo for model in models], [model.coupling for model in models]
    # Periods are used in turn, so that all devices fit one table when the lists are repeated to a common length.
    length = int(np.lcm.reduce([len(servo.periods()) for servo in servos])) if servos else 1
    period = np.array([servo.periods() * (length // len(servo.periods())) for servo in servos], dtype=np.float64)
    unlimited = (inf, inf, inf)
    return Servos(
        period=period.reshape(len(servos), length),
        window=_column([servo.window for servo in servos]),
        resolution=_rows([[servo.resolution] * 3 for servo in servos]),
        force=_column([servo.force for servo in servos]),
        torque=_rows([m.plant.torque if isinstance(m.plant, PhantomPlant) else unlimited for m in models]),
        law=_integers([coupling.kind for coupling in couplings]),
        address=_integers([0 if c.end is None else c.end.address(proxy=False) for c in couplings]),
        stiffness=_column([coupling.stiffness for coupling in couplings]),
        damping=_column([coupling.damping for coupling in couplings]),
        lag=_integers([coupling.lag for coupling in couplings]),
        latency=_integers([coupling.latency for coupling in couplings]),
        declared=_rows([[coupling.assumed_damping] * 3 for coupling in couplings]),
        rest=_rows([[_rest(model)] * 3 for model in models]),
    )


def _rest(model: DeviceModel) -> float:
    """Of all coordinates; a joint moves the tip by no more than its angle times the arms."""
    if model.coupling.end is None or not model.coupling.end.rests:
        return 1.0
    arm = sum(model.plant.lengths()) if isinstance(model.plant, PhantomPlant) else 1.0
    slope = model.coupling.stiffness + model.coupling.damping / model.servo.span()
    # What acts a tick late swings twice as far.
    return rest_fraction((1 + model.coupling.latency) * slope, arm * model.servo.resolution)


def _grasps(models: Sequence[DeviceModel]) -> Grasps:
    nobody = SimulatedHand(mass=0.0, stiffness=0.0, damping=0.0)
    hands = [model.hand or nobody for model in models]
    held = [model.hand is not None for model in models]
    points = [point for hand in hands for point in hand.waypoints]
    return Grasps(
        mass=_column([hand.mass for hand in hands]),
        stiffness=_column([hand.grip * hand.stiffness for hand in hands]),
        damping=_column([hand.grip * hand.damping for hand in hands]),
        begin=_column([hand.begin if real else inf for hand, real in zip(hands, held, strict=True)]),
        release=_column([inf if hand.release is None else hand.release for hand in hands]),
        blend=_column([hand.blend for hand in hands]),
        reaction=_column([hand.reaction for hand in hands]),
        correction=_column([hand.correction for hand in hands]),
        reach=_column([hand.reach for hand in hands]),
        path_first=_integers([0, *np.cumsum([len(hand.waypoints) for hand in hands], dtype=np.int64).tolist()]),
        path_time=_column([time for time, _ in points]),
        path_value=_rows([place for _, place in points]),
        amplitude=_rows([hand.wave for hand in hands]),
        frequency=_column([hand.frequency for hand in hands]),
        phase=_column([hand.phase for hand in hands]),
    )


def _start(models: Sequence[DeviceModel], devices: Devices) -> DeviceState:
    count = len(models)
    place = _rows([model.start for model in models])
    coordinate = _rows([model.coordinate for model in models])
    ratio = devices.servos.window / devices.servos.period.min(axis=1, initial=inf)
    lag = int(devices.servos.lag.max(initial=0))
    length = max(int(np.ceil(ratio.max(initial=0.0))), lag) + 3
    ledger = np.zeros((count, len(DEVICE_LEDGER)))
    ledger[:, TANK] = [model.coupling.initial_energy for model in models]
    for d, kind in enumerate(devices.plants.kind):
        if kind == PHANTOM:
            ledger[d, INITIAL] = ledger[d, POTENTIAL] = phantom_potential(devices.plants, d, *coordinate[d, 1:3])

    def vectors() -> Float:
        return np.zeros((count, 4))

    def numbers() -> Float:
        return np.zeros(count)

    def integers() -> Long:
        return np.zeros(count, dtype=np.int64)

    return DeviceState(
        desired=place.copy(),
        host_force=vectors(),
        ends=np.array([model.coupling.row() for model in models]).reshape(count, END.length),
        sample=place.copy(),
        place=place.copy(),
        sample_velocity=vectors(),
        sample_time=numbers(),
        force=vectors(),
        ledger=ledger,
        time=numbers(),
        next_tick=numbers(),
        ticks=integers(),
        coordinate=coordinate,
        momentum=vectors(),
        tip=place.copy(),
        coming=vectors(),
        effort=vectors(),
        effort_before=vectors(),
        measured=coordinate.copy(),
        set_position=place.copy(),
        resting=np.zeros((4 * count, REST_FIELDS)),
        history=np.zeros((count, length, 4)),
        history_time=np.zeros((count, length)),
        oldest=integers(),
        holding=integers(),
        equilibrium=place.copy(),
        offset=vectors(),
        grasped=numbers(),
        corrected=vectors(),
        urge=vectors(),
        recall=np.zeros((count, RECALL, 4)),
        recalled=integers(),
        cursor=devices.grasps.path_first[:-1].copy(),
    )
