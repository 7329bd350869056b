"""From the tables of tools to the arrays that the engines work on."""

from collections.abc import Sequence
from math import inf

import numpy as np

from cotouch.arrays import Float
from cotouch.body import Body
from cotouch.coupling import (
    END,
    checked_toll,
    checked_virtual_coupling,
    device_couplings,
    encoder_toll,
    opening_energy,
    unseen_place,
)
from cotouch.device import (
    PRESETS,
    CartesianPlant,
    Coupling,
    DeviceModel,
    PhantomPlant,
    ServoModel,
    SimulatedHand,
    assemble,
    couplings,
    sure_force,
)
from cotouch.errors import BodyError, DeviceError, ScenarioError
from cotouch.interaction import Hands, Touching
from cotouch.mechanics import BLADE, GRASP, TOUCH_LEDGER, TOUCHING, Model, Ports, contact_by, surface_of, tools
from cotouch.scenario._penetration import resolve_penetration
from cotouch.scenario._tool_tables import DEFAULT_RATE, ContactTable, SimulatedDeviceTable, ToolHand, ToolTable

_KINDS = {"touch": TOUCHING, "grasp": GRASP, "blade": BLADE}
# Ticks from a coupling's decision until its force acts: as a real servo, which decides while the force before acts.
_LATENCY = 1


def touching_of(
    tables: list[ToolTable],
    users: int,
    body: Body,
    model: Model,
    lengths: Float,
    *,
    start: Float,
    contact: ContactTable | None = None,
    numbers: Sequence[int] | None = None,
) -> tuple[Touching | None, list[int]]:
    """The tools of a scenario, ordered by user, and which tool each table became; None without tools.

    Args:
        tables: of the scenario.
        users: how many there are.
        body: the shared object.
        model: the same for the kernels.
        lengths: of the body's steps, which a virtual coupling must be passive at, (users, steps); 0: none [s].
        start: displacements of all copies at the start, (users, n, d) [m].
        contact: how they touch; None: as by default.
        numbers: which of [[tools]] each is, from 1; None: there are no others.

    Raises:
        ScenarioError: a tool names a user that is not there or starts inside the body, or a device or hand is wrong.
        BodyError: the body has not three axes.
    """
    if not tables:
        return None, []
    if body.dimension != 3:
        raise BodyError(f"tools touch bodies of 3 axes, but this one has {body.dimension}{_remedy(body.dimension)}")
    contact = contact or ContactTable()
    law = contact.made()
    numbers = range(1, len(tables) + 1) if numbers is None else numbers
    for number, table in zip(numbers, tables, strict=True):
        if table.kind == "touch" and (body.skin is None or not body.skin.triangles.size):
            raise ScenarioError(
                f'tools[{number}].kind is "touch", which needs a skin, but the body has none (a point, a chain); take '
                '"grasp", or hold it with hands'
            )
        if table.user > users:
            raise ScenarioError(f"tools[{number}].user is {table.user}; the network has users 1 to {users}")
        if table.kind == "touch" and table.begin == 0.0:
            raised = 0.0 if contact.texture is None else contact.texture.top()
            _refuse_inside(f"tools[{number}]", table, body, start[table.user - 1], raised)
    surface = surface_of(model)
    touches = [table.radius for table in tables if table.kind == "touch"]
    if touches and contact.texture is not None:
        surface = surface._replace(relief=contact.texture.relief(surface, min(touches)))
    order = sorted(range(len(tables)), key=lambda index: tables[index].user)
    chosen = [tables[index] for index in order]
    count = len(chosen)
    own = tools(count)
    joined = couplings(count)
    models: list[DeviceModel] = []
    for t, table in enumerate(chosen):
        own.mass[t], own.radius[t], own.friction[t] = table.mass, table.radius, table.friction
        own.kinetic[t] = table.friction if table.kinetic_friction is None else table.kinetic_friction
        own.viscosity[t] = contact.viscosity
        own.place[t, :3] = table.at
        own.axis[t, :3] = table.axis or 0.0
        if table.kind == "blade":
            own.radius[t] = 0.5 * (table.thickness or 0.0)
        if table.kind == "touch":
            own.stiffness[t], own.loss[t] = table.stiffness, table.damping
            if contact.snap is not None:
                own.snap[t], own.snap_range[t] = contact.snap.force, contact.snap.range
        elif table.kind == "grasp":
            own.grip_stiffness[t], own.grip_damping[t] = table.stiffness, table.damping
        if table.device is None:
            continue
        where = f"tools[{numbers[order[t]]}]"
        try:
            device = device_model(table.device, table.hand, lengths[table.user - 1])
        except DeviceError as error:
            raise ScenarioError(f"{where}.device: {error}") from None
        if table.hand is not None and isinstance(device.plant, PhantomPlant):
            _reachable(device.plant, table.hand, where)
        joined.device[t] = len(models)
        joined.origin[t, :3] = table.at
        joined.stiffness[t], joined.damping[t] = device.coupling.stiffness, device.coupling.damping
        joined.unsure[t] = _unsure(device, lengths[table.user - 1])
        if device.coupling.end is not None:
            joined.ends[t], joined.address[t] = device.coupling.row(proxy=True), device.coupling.end.address(proxy=True)
        models.append(device)
    devices, states = assemble(models)
    for t in np.flatnonzero(joined.device >= 0):
        d = int(joined.device[t])
        joined.most[t] = states.ends[d, END.most] = joined.ends[t, END.most] = sure_force(devices, d)
    owner = np.array([table.user - 1 for table in chosen])
    first = np.searchsorted(owner, np.arange(users + 1)).astype(np.int32)
    hands, most = _drives(chosen), int(np.diff(first).max())
    return (
        Touching(
            surface=surface,
            tools=own,
            contact=contact_by(law, model, surface, tools=most),
            first=first,
            kind=np.array([_KINDS[table.kind] for table in chosen], dtype=np.int32),
            begin=np.array([table.begin for table in chosen]),
            release=np.array([inf if table.release is None else table.release for table in chosen]),
            hands=hands,
            cursor=hands.path_first[:-1].copy(),
            drive=Ports(
                row=np.zeros(count, dtype=np.int32),
                shape=np.zeros((0, 0)),
                stiffness=own.drive_stiffness,
                damping=own.drive_damping,
                start=own.drive_start,
                end=own.drive_end,
                push=own.push,
                force=own.drive_force,
            ),
            devices=devices,
            states=states,
            couplings=joined,
            ledger=np.zeros(TOUCH_LEDGER),
        ),
        [order.index(index) for index in range(count)],
    )


def device_model(table: SimulatedDeviceTable, hand: ToolHand | None, lengths: Float) -> DeviceModel:
    """A device as `cotouch.device` wants it.

    Args:
        table: the device.
        hand: on it, if any.
        lengths: of the body's steps [s].

    Raises:
        DeviceError: a number is out of range, or a virtual coupling is not passive.
    """
    product = None if table.preset is None else PRESETS[table.preset]
    rate = table.rate or (DEFAULT_RATE if product is None else product.rate)
    phantom = table.sort() == "phantom"
    plant: CartesianPlant | PhantomPlant
    if phantom:
        given = {name: getattr(table, name) for name in ("viscous", "coulomb") if getattr(table, name) is not None}
        plant = PhantomPlant(**given)
    else:
        plant = CartesianPlant(
            mass=_first(table.mass, product and product.mass, 0.06),
            viscous=_first(table.viscous, None, 0.0125),
            coulomb=_first(table.coulomb, product and product.friction, 0.0),
        )
    # What a PHANToM's encoders tell apart at the tip they do at the end of its upper arm, about.
    lever = plant.lengths()[0] if isinstance(plant, PhantomPlant) else 1.0
    servo = ServoModel(
        period=tuple(table.periods) if table.periods else 1.0 / rate,
        window=table.window,
        resolution=_first(table.resolution, product and product.resolution / lever, 0.0),
        force=_first(table.force, product and product.force, inf),
    )
    stiffness = table.stiffness
    law = device_couplings().get(table.coupling)
    pays = law is None or "friction" in law.parameters  # the device's own friction, for what sampling makes
    toll = ages = 0.0
    if pays:
        # A PHANToM's joints damp its tip by at least their own damping over the square of its longest lever.
        longest = sum(plant.lengths()) if isinstance(plant, PhantomPlant) else 1.0
        unseen = _unseen(plant, servo)
        known, longest_tick = lengths[lengths > 0.0], max(servo.periods())
        # With host force the body's step is the tick; else a force is used until two ticks after its place was
        # measured, the proxy's place is told once a step, and the device's is a tick old in it.
        alone = law is None
        ages = 0.0 if alone else float(known.max()) + longest_tick
        spread = float((known[1:] / known[:-1]).max(initial=1.0)) if alone else 1.0 + longest_tick / servo.span()
        stiffness = checked_virtual_coupling(
            stiffness=stiffness,
            device_damping=plant.viscous / longest**2,
            period=float(known.max()) if alone else (1.0 + 2.0 * _LATENCY) * longest_tick,
            damping=table.damping,
            ages=ages,
            spread=spread,
            unseen=unseen,
            dry=plant.coulomb / longest,
            shortest=float(known.min()) if alone else servo.span(),
            lower=table.clip_stiffness,
        )
    else:
        step = lever * servo.resolution
        stiffness = checked_toll(
            stiffness=stiffness,
            damping=table.damping,
            window=servo.span(),
            resolution=step,
            lower=table.clip_stiffness,
            hint=", or set clip_stiffness",
        )
        toll = encoder_toll(stiffness=stiffness, damping=table.damping, window=servo.span(), resolution=step)
    return DeviceModel(
        plant=plant,
        servo=servo,
        coupling=Coupling(
            law=table.coupling,
            stiffness=stiffness,
            damping=table.damping,
            cap=table.cap,
            reserve=table.reserve,
            initial_energy=opening_energy(toll=toll, stiffness=stiffness, cap=table.cap),
            assumed_damping=plant.viscous if pays else table.assumed_damping,
            ages=ages,
            latency=_LATENCY,
        ),
        hand=None if hand is None else SimulatedHand(**hand.model_dump()),
    )


def _refuse_inside(where: str, table: ToolTable, body: Body, displacement: Float, raised: float) -> None:
    """Refuses a tool that begins within the body.

    Args:
        where: how the file names it.
        table: of the tool.
        body: the shared object.
        displacement: of its nodes in the user's copy, (n, 3) [m].
        raised: height of the texture [m].
    """
    middle, axis, reach = np.array(table.at), np.array(table.axis or [0.0] * 3), table.radius + raised
    balls = 2 + int(4.0 * np.linalg.norm(axis) / table.radius) if axis.any() else 1  # as it touches with
    ways = np.linspace(-1.0, 1.0, balls) if balls > 1 else np.zeros(1)
    found = [resolve_penetration(body, displacement, middle + way * axis, reach, table.user - 1) for way in ways]
    reached = [one for one in found if one is not None]
    if not reached:
        return
    depth, place = max(reached, key=lambda one: one[0])
    to = f"move it to [{', '.join(f'{x:.4g}' for x in place + 0.0)}] or farther, or make it a grasp"
    raise ScenarioError(
        f"{where}.at is {table.at}; a tool that touches starts outside, but with its radius of {table.radius:g} m"
        f"{' and the texture' * (raised > 0.0)} this one is {depth:.3g} m deep in the body; "
        f"{to if balls == 1 else 'move or turn it'}"
    )


def _unseen(plant: CartesianPlant | PhantomPlant, servo: ServoModel) -> float:
    """Farthest that a tip may be from where its encoders have it: half a step on each axis or joint [m]."""
    if isinstance(plant, PhantomPlant):
        return servo.resolution * sum(plant.lengths())  # joint 1 turns both arms, the others their own
    return unseen_place(servo.resolution)


def _unsure(device: DeviceModel, lengths: Float) -> float:
    """By how much encoders may falsify the force of a virtual coupling; of others 0 [N]."""
    if device.coupling.law != "host_force":
        return 0.0
    shortest = float(lengths[lengths > 0.0].min())
    return (device.coupling.stiffness + 2.0 * device.coupling.damping / shortest) * _unseen(device.plant, device.servo)


def _remedy(axes: int) -> str:
    """How to give a body more axes, in the words of a scenario."""
    return "; give a point the rest place [0, 0, 0], a chain dimension = 3, a lattice a shape of 3 numbers" * (axes < 3)


def _reachable(plant: PhantomPlant, hand: ToolHand, where: str) -> None:
    """Refuses a hand that leads a PHANToM's tip to where it does not reach.

    Raises:
        ScenarioError: it does.
    """
    rows = [row[1:] for row in hand.path if isinstance(row, list)] or [[float(x) for x in hand.path]]  # pyright: ignore[reportArgumentType]
    for row in rows:
        for sign in (-1.0, 0.0, 1.0):
            x, y, z = (float(p + sign * a) for p, a in zip(row, hand.amplitude, strict=True))
            try:
                plant.joints((x, y, z))
            except DeviceError:
                raise ScenarioError(
                    f"{where}.hand.path leads to [{x:g}, {y:g}, {z:g}] m from where the tool starts; a PHANToM's tip "
                    "cannot reach that far; shorten the path"
                ) from None


def _first(*values: float | None) -> float:
    """The first that is given."""
    return next(value for value in values if value is not None)


def _drives(tables: list[ToolTable]) -> Hands:
    """What moves tools without a device: paths in the body's frame; of no stiffness where a device does it."""
    nobody = ToolHand(stiffness=0.0, damping=0.0)
    hands = [table.hand if table.hand is not None and table.device is None else nobody for table in tables]
    times: list[Float] = []
    values: list[Float] = []
    for table, hand in zip(tables, hands, strict=True):
        rows = np.array(hand.path, dtype=np.float64)
        rows = np.concatenate([[0.0], rows])[None, :] if rows.ndim == 1 else rows
        place = np.zeros((rows.shape[0], 4))
        place[:, :3] = rows[:, 1:] + np.array(table.at)
        times.append(rows[:, 0])
        values.append(place)
    count = len(tables)
    amplitude = np.zeros((count, 4))
    amplitude[:, :3] = [hand.amplitude for hand in hands]
    return Hands(
        first=np.zeros(1, dtype=np.int32),
        row=np.zeros(count, dtype=np.int32),
        shape=np.zeros((0, 0)),
        stiffness=np.array([hand.grip * hand.stiffness for hand in hands]),
        damping=np.array([hand.grip * hand.damping for hand in hands]),
        begin=np.array([hand.begin for hand in hands]),
        release=np.array([inf if hand.release is None else hand.release for hand in hands]),
        forced=np.zeros(count, dtype=np.bool_),
        path_first=np.concatenate([[0], np.cumsum([line.size for line in times])]).astype(np.int32),
        path_time=np.ascontiguousarray(np.concatenate(times)),
        path_value=np.ascontiguousarray(np.concatenate(values)),
        amplitude=amplitude,
        frequency=np.array([hand.frequency for hand in hands]),
        phase=np.array([hand.phase for hand in hands]),
    )
