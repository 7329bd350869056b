"""All devices as plain arrays: what they are, and where they are. Row d of every array is device d.

A *coordinate* is what a device's encoders measure and its motors act on: the tip's place of a Cartesian device [m], the
three joint angles of a PHANToM [rad]. An *effort* is the force that does work on it [N, Nm]. Places, velocities and
forces of the tip are in the frame of the package: x forward, y left, z up. All are padded to four columns.
"""

from typing import NamedTuple

from cotouch.arrays import Float, Long
from cotouch.passing import by_address

# Kinds of plant.
CARTESIAN, PHANTOM = range(2)
# Laws of the servo: a coupling of `cotouch.mechanics`; a plain sampled spring-damper to the desired position; the
# force that the body's step tells.
COUPLED, SPRING, HOST_FORCE = range(3)

# What a device books. Work and losses are cumulative, energies are of now [J]. The first nine are physics: true motion.
(
    WORK,  # of the motors, ∫τᵀq̇ dt
    HUMAN,  # of the hand's will: on the far end of its spring and damper, and what it took along when it let go
    HAND_LOSS,  # in the hand's damper, and in the impact of taking hold
    VISCOUS_LOSS,
    COULOMB_LOSS,
    KINETIC,  # of device and hand
    HAND_ENERGY,  # of the hand's spring
    POTENTIAL,  # of gravity
    RESIDUAL,  # now - initial - work - human + losses: 0
    INITIAL,
    # The rest is what the servo knows: the measured motion.
    MEASURED_WORK,
    CHARGED,  # for the resolution of the encoder
    DECLARED,  # credited for the device's own damping
    TANK,  # of the coupling's end at the device, its spring included
    SPRING_ENERGY,
    LOWEST,  # the deepest debt of that end, <= 0
    SATURATED,  # ticks at which force or torque was limited
    FASTEST,  # highest measured speed between two ticks [m/s]
    LONGEST,  # longest period between two ticks [s]
) = range(19)
DEVICE_LEDGER = (
    "work",
    "human",
    "hand_loss",
    "viscous_loss",
    "coulomb_loss",
    "kinetic",
    "hand_energy",
    "potential",
    "residual",
    "initial",
    "measured_work",
    "charged",
    "declared",
    "tank",
    "spring_energy",
    "lowest",
    "saturated",
    "fastest",
    "longest",
)


@by_address
class Plants(NamedTuple):
    """How devices move.

    Attributes:
        kind: CARTESIAN or PHANTOM, (devices,).
        mass: of a Cartesian device, (devices,) [kg].
        viscous: (devices, 4) [Ns/m]; of a joint [Nm s/rad]. A Cartesian device's is entry 0 in all directions.
        coulomb: (devices, 4) [N]; of a joint [Nm].
        inertia: of a PHANToM: `M11 = i0 + i1 cos 2θ2 + i2 cos 2θ3 + i3 cos θ2 sin θ3`, `M22 = i4`, `M33 = i5`,
            `M23 = -i6 sin(θ2 - θ3)`, (devices, 8) [kg m²].
        length: l1, l2 of a PHANToM, (devices, 2) [m].
        gravity: U = g0 sin θ2 - g1 cos θ3, (devices, 2) [Nm]; 0 where compensated.
        substep: longest step of the integrator, (devices,) [s].
    """

    kind: Long
    mass: Float
    viscous: Float
    coulomb: Float
    inertia: Float
    length: Float
    gravity: Float
    substep: Float


@by_address
class Servos(NamedTuple):
    """Sensor, clock, actuator and law.

    Attributes:
        period: times between ticks, used in turn and again from the first, (devices, periods) [s].
        window: over which velocity is measured, (devices,) [s].
        resolution: of each coordinate, (devices, 4) [m or rad]; 0: exact.
        force: largest force, (devices,) [N].
        torque: largest effort of each coordinate, (devices, 4) [N or Nm].
        law: COUPLED, SPRING or HOST_FORCE, (devices,).
        address: of the coupling's function for this end, in this process, (devices,).
        stiffness: k, (devices,) [N/m].
        damping: b, (devices,) [Ns/m].
        lag: ticks by which the law SPRING sees the place late, (devices,).
        latency: ticks from a coupling's decision until its force acts, (devices,).
        declared: the device's own damping that a coupling may count on, (devices, 4) [Ns/m or Nm s/rad].
        rest: with which fraction of a coordinate's motion a coupling goes on at rest, (devices, 4).
    """

    period: Float
    window: Float
    resolution: Float
    force: Float
    torque: Float
    law: Long
    address: Long
    stiffness: Float
    damping: Float
    lag: Long
    latency: Long
    declared: Float
    rest: Float


@by_address
class Grasps(NamedTuple):
    """The hands that hold the tips: mass, spring and damper to an equilibrium point on a path.

    Attributes:
        mass: moves with the tip, (devices,) [kg].
        stiffness: (devices,) [N/m].
        damping: (devices,) [Ns/m].
        begin: the hand takes hold, (devices,) [s].
        release: and lets go, (devices,) [s].
        blend: over which the offset of taking hold fades, (devices,) [s].
        reaction: after which the will corrects an error, (devices,) [s].
        correction: how fast it does, (devices,) [1/s].
        reach: farthest correction, (devices,) [m].
        path_first: first waypoint, (devices + 1,).
        path_time: (waypoints,) [s].
        path_value: (waypoints, 4) [m].
        amplitude: of a sine added to the path, (devices, 4) [m].
        frequency: (devices,) [Hz].
        phase: (devices,) [rad].
    """

    mass: Float
    stiffness: Float
    damping: Float
    begin: Float
    release: Float
    blend: Float
    reaction: Float
    correction: Float
    reach: Float
    path_first: Long
    path_time: Float
    path_value: Float
    amplitude: Float
    frequency: Float
    phase: Float


@by_address
class Devices(NamedTuple):
    """What the devices are; nothing in it changes in a run."""

    plants: Plants
    servos: Servos
    grasps: Grasps


@by_address
class DeviceState(NamedTuple):
    """Where the devices are, and what they exchange with the proxies' side.

    Attributes:
        desired: in: the proxy's place, as last told, (devices, 4) [m].
        host_force: in: force that the law HOST_FORCE holds, (devices, 4) [N].
        ends: the coupling's end at each device, (devices, END.length); what the other end said is an input.
        sample: out: the tip's place as last measured, (devices, 4) [m].
        place: out: the same as the law takes it: a coupling may, with less of its flicker at rest, (devices, 4) [m].
        sample_velocity: out: the velocity of that place, (devices, 4) [m/s].
        sample_time: out: when, (devices,) [s].
        force: out: force at the tip that the motors hold, (devices, 4) [N].
        ledger: out: (devices, len(DEVICE_LEDGER)).
        time: (devices,) [s].
        next_tick: (devices,) [s].
        ticks: how many there were, (devices,).
        coordinate: (devices, 4).
        momentum: conjugate to the coordinate, the hand's share included, (devices, 4).
        tip: true place, (devices, 4) [m].
        coming: force that was decided on and acts from the next tick, with a latency, (devices, 4) [N].
        effort: held by the motors, (devices, 4).
        effort_before: held before the last tick, (devices, 4).
        measured: coordinate as last measured, (devices, 4).
        set_position: ȳ, (devices, 4) [m].
        resting: what `place_at_rest` keeps for each coordinate, (4 devices, REST_FIELDS).
        history: last places, (devices, length, 4) [m].
        history_time: (devices, length) [s].
        oldest: tick of the oldest sample in the window, (devices,).
        holding: whether the hand holds, (devices,).
        equilibrium: far end of the hand's spring, (devices, 4) [m].
        offset: of the equilibrium from its path when the hand took hold, (devices, 4) [m].
        grasped: when that was, (devices,) [s].
        corrected: what the will has added, (devices, 4) [m].
        urge: how fast it is adding, (devices, 4) [m/s].
        recall: errors that the person has not reacted to yet, (devices, RECALL, 4) [m].
        recalled: how many were kept, (devices,).
        cursor: waypoint, (devices,).
    """

    desired: Float
    host_force: Float
    ends: Float
    sample: Float
    place: Float
    sample_velocity: Float
    sample_time: Float
    force: Float
    ledger: Float
    time: Float
    next_tick: Float
    ticks: Long
    coordinate: Float
    momentum: Float
    tip: Float
    coming: Float
    effort: Float
    effort_before: Float
    measured: Float
    set_position: Float
    resting: Float
    history: Float
    history_time: Float
    oldest: Long
    holding: Long
    equilibrium: Float
    offset: Float
    grasped: Float
    corrected: Float
    urge: Float
    recall: Float
    recalled: Long
    cursor: Long


# A reaction time is kept as this many errors.
RECALL = 64
