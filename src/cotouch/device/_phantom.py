"""PHANToM 1.5: three joints, and an integrator whose energy balance is exact.

Mass matrix and gravity are those of [Çavuşoğlu, Feygin & Tendick 2002]. Nothing is written for the Coriolis and
centrifugal terms: they are what the change of the mass matrix makes of Hamilton's equations for `H = ½ pᵀ M(θ)⁻¹ p`.
With W = M⁻¹ and W̄ its mean over the step's two ends, the step is

    θ⁺ - θ = h W̄ p̂,    p⁺ - p = h (τ - ∇̄ψ),    ψ(θ) = ¼ (p⁺ᵀ W(θ) p⁺ + pᵀ W(θ) p)

∇̄ψ is the gradient at the middle, corrected along Δθ so that ∇̄ψ·Δθ = ψ(θ⁺) - ψ(θ) [Gonzalez 1996]. Then
`H⁺ - H = τ·Δθ` exactly, at second order and symmetric in time. The hand's pull at the tip and gravity share the one
correction, so their work is exact too.

Tip in the frame of the package, θ = 0 at the origin, with `r = l1 cos θ2 + l2 sin θ3`:

    x = l1 - r cos θ1,    y = -r sin θ1,    z = l2 - l2 cos θ3 + l1 sin θ2
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from math import cos, inf, sin

from cotouch.device._hand import LANES, add_to_ledger, book_hand, book_motors, correct, equilibrium_after
from cotouch.device._tables import COULOMB_LOSS, Devices, DeviceState, Grasps, Plants
from cotouch.kernels import at, inner, kernel, part, put, store

# An iteration gains two to three digits at 10 kHz; this many are for a long step with a firm hand.
_ITERATIONS = 60
_SETTLED = 4e-16
# From here on an iteration that gains nothing is the last.
_PATIENCE = 6
# Sweeps over two joints that share friction; they contract by M23² / (M22 M33), at worst about a half.
_SWEEPS = 60

Four = tuple[float, float, float, float]
Seven = tuple[float, float, float, float, float, float, float]


@inner
def coefficients(devices: Devices, state: DeviceState, d: int) -> Seven:
    """The numbers of the mass matrix as in `Plants.inertia`, a holding hand's point mass at the tip included.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    plants = devices.plants
    m = at(devices.grasps.mass, d) if at(state.holding, d) != 0 else 0.0
    l1, l2 = at(plants.length, (d, 0)), at(plants.length, (d, 1))
    return (
        at(plants.inertia, (d, 0)) + 0.5 * m * (l1 * l1 + l2 * l2),
        at(plants.inertia, (d, 1)) + 0.5 * m * l1 * l1,
        at(plants.inertia, (d, 2)) - 0.5 * m * l2 * l2,
        at(plants.inertia, (d, 3)) + 2.0 * m * l1 * l2,
        at(plants.inertia, (d, 4)) + m * l1 * l1,
        at(plants.inertia, (d, 5)) + m * l2 * l2,
        at(plants.inertia, (d, 6)) + m * l1 * l2,
    )


@inner
def mass_matrix(c: Seven, q2: float, q3: float) -> Four:
    """M11, M22, M33, M23 [kg m²]; the rest is zero.

    Args:
        c: the numbers of the mass matrix; see `coefficients`.
        q2: second joint [rad].
        q3: third joint [rad].
    """
    s2, c2, s3, c3 = sin(q2), cos(q2), sin(q3), cos(q3)
    m11 = c[0] + c[1] * (1.0 - 2.0 * s2 * s2) + c[2] * (1.0 - 2.0 * s3 * s3) + c[3] * c2 * s3
    return m11, c[4], c[5], -c[6] * (s2 * c3 - c2 * s3)


@inner
def inverse(m: Four) -> Four:
    """Of a matrix with entries 11, 22, 33, 23."""
    scale = 1.0 / (m[1] * m[2] - m[3] * m[3])
    return 1.0 / m[0], scale * m[2], scale * m[1], -scale * m[3]


@inner
def form(w: Four, p1: float, p2: float, p3: float) -> float:
    """`pᵀ W p`.

    Args:
        w: W11, W22, W33, W23.
        p1: first component.
        p2: second.
        p3: third.
    """
    return w[0] * p1 * p1 + w[1] * p2 * p2 + w[2] * p3 * p3 + 2.0 * w[3] * p2 * p3


@inner
def mass_slopes(c: Seven, q2: float, q3: float, u1: float, u2: float, u3: float) -> tuple[float, float]:
    """`∂(uᵀ M u)/∂θ2` and `/∂θ3` with u fixed.

    Args:
        c: the numbers of the mass matrix; see `coefficients`.
        q2: second joint [rad].
        q3: third joint [rad].
        u1: first component of u.
        u2: second.
        u3: third.
    """
    s2, c2, s3, c3 = sin(q2), cos(q2), sin(q3), cos(q3)
    cross = 2.0 * u2 * u3 * c[6] * (c2 * c3 + s2 * s3)
    return (
        u1 * u1 * (-4.0 * c[1] * s2 * c2 - c[3] * s2 * s3) - cross,
        u1 * u1 * (-4.0 * c[2] * s3 * c3 + c[3] * c2 * c3) + cross,
    )


@inner
def phantom_tip(plants: Plants, d: int, q1: float, q2: float, q3: float) -> tuple[float, float, float]:
    """Place of the tip [m].

    Args:
        plants: constants of all devices.
        d: number of the device.
        q1: first joint [rad].
        q2: second joint [rad].
        q3: third joint [rad].
    """
    l1, l2 = at(plants.length, (d, 0)), at(plants.length, (d, 1))
    r = l1 * cos(q2) + l2 * sin(q3)
    return l1 - r * cos(q1), -r * sin(q1), l2 - l2 * cos(q3) + l1 * sin(q2)


@inner
def joint_torques(
    plants: Plants, d: int, q1: float, q2: float, q3: float, fx: float, fy: float, fz: float
) -> tuple[float, float, float]:
    """`Jᵀ f`: the joints' torques of a force at the tip [Nm].

    Args:
        plants: constants of all devices.
        d: number of the device.
        q1: first joint [rad].
        q2: second joint [rad].
        q3: third joint [rad].
        fx: force forward [N].
        fy: force to the left [N].
        fz: force up [N].
    """
    l1, l2 = at(plants.length, (d, 0)), at(plants.length, (d, 1))
    s1, c1, s2, c2, s3, c3 = sin(q1), cos(q1), sin(q2), cos(q2), sin(q3), cos(q3)
    r = l1 * c2 + l2 * s3
    outward = -c1 * fx - s1 * fy
    return r * (s1 * fx - c1 * fy), l1 * (c2 * fz - s2 * outward), l2 * (s3 * fz + c3 * outward)


@kernel
def phantom_potential(plants: Plants, d: int, q2: float, q3: float) -> float:
    """Energy of gravity [J].

    Args:
        plants: constants of all devices.
        d: number of the device.
        q2: second joint [rad].
        q3: third joint [rad].
    """
    return at(plants.gravity, (d, 0)) * sin(q2) - at(plants.gravity, (d, 1)) * cos(q3)


@inner
def phantom_kinetic(devices: Devices, state: DeviceState, d: int) -> float:
    """Kinetic energy, the hand's included [J].

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    c = coefficients(devices, state, d)
    w = inverse(mass_matrix(c, at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2))))
    return 0.5 * form(w, at(state.momentum, (d, 0)), at(state.momentum, (d, 1)), at(state.momentum, (d, 2)))


@inner
def _shrink(value: float, by: float) -> float:
    if value > by:
        return value - by
    if value < -by:
        return value + by
    return 0.0


@inner
def store_tip(plants: Plants, state: DeviceState, d: int) -> None:
    """Brings the tip to where the joints are.

    Args:
        plants: constants of all devices.
        state: of all devices; changed in place.
        d: number of the device.
    """
    x, y, z = phantom_tip(
        plants, d, at(state.coordinate, (d, 0)), at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2))
    )
    put(state.tip, (d, 0), x)
    put(state.tip, (d, 1), y)
    put(state.tip, (d, 2), z)


@inner
def _stop(c: Seven, state: DeviceState, d: int, held: tuple[bool, bool, bool]) -> None:
    """Joints that friction held for a whole step have stopped; what they had is booked as friction."""
    q2, q3 = at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2))
    p1, p2, p3 = at(state.momentum, (d, 0)), at(state.momentum, (d, 1)), at(state.momentum, (d, 2))
    w = inverse(mass_matrix(c, q2, q3))
    before = form(w, p1, p2, p3)
    if held[0]:
        p1 = 0.0
    if held[1] and held[2]:
        p2, p3 = 0.0, 0.0
    elif held[1]:
        p2 = -w[3] * p3 / w[1]
    elif held[2]:
        p3 = -w[3] * p2 / w[2]
    put(state.momentum, (d, 0), p1)
    put(state.momentum, (d, 1), p2)
    put(state.momentum, (d, 2), p3)
    add_to_ledger(state, d, COULOMB_LOSS, 0.5 * (before - form(w, p1, p2, p3)))


@part
def phantom_step(devices: Devices, state: DeviceState, d: int, h: float) -> None:
    """A PHANToM for a time h; the step of the module's text, solved by fixed-point iteration on the mean velocity.

    Args:
        devices: all devices.
        state: of all devices; changed in place.
        d: number of the device.
        h: length of the step [s].
    """
    plants, grasps = devices.plants, devices.grasps
    c = coefficients(devices, state, d)
    q1, q2, q3 = at(state.coordinate, (d, 0)), at(state.coordinate, (d, 1)), at(state.coordinate, (d, 2))
    p1, p2, p3 = at(state.momentum, (d, 0)), at(state.momentum, (d, 1)), at(state.momentum, (d, 2))
    e1, e2, e3 = at(state.effort, (d, 0)), at(state.effort, (d, 1)), at(state.effort, (d, 2))
    b1, b2, b3 = at(plants.viscous, (d, 0)), at(plants.viscous, (d, 1)), at(plants.viscous, (d, 2))
    f1, f2, f3 = at(plants.coulomb, (d, 0)), at(plants.coulomb, (d, 1)), at(plants.coulomb, (d, 2))
    g2, g3 = at(plants.gravity, (d, 0)), at(plants.gravity, (d, 1))
    # The hand's mean pull is `rest - give Δx`.
    give, rest, shift = 0.0, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    if at(state.holding, d) != 0:
        give = 0.5 * at(grasps.stiffness, d) + at(grasps.damping, d) / h
        rest, shift = _rest(grasps, state, d, h)
    half = 0.5 * h
    w = inverse(mass_matrix(c, q2, q3))
    w1, w2, w3 = w[0] * p1, w[1] * p2 + w[3] * p3, w[3] * p2 + w[2] * p3
    x, y, z = 0.0, 0.0, 0.0
    m = mass_matrix(c, q2, q3)
    before = inf
    for iteration in range(_ITERATIONS):
        d1, d2, d3 = h * w1, h * w2, h * w3
        c2, c3 = q2 + 0.5 * d2, q3 + 0.5 * d3
        # p⁺ from W̄ p̂ = ω̂, W̄ being the mean of both ends.
        v = inverse(mass_matrix(c, q2 + d2, q3 + d3))
        m = inverse((0.5 * (w[0] + v[0]), 0.5 * (w[1] + v[1]), 0.5 * (w[2] + v[2]), 0.5 * (w[3] + v[3])))
        r1, r2, r3 = 2.0 * m[0] * w1 - p1, 2.0 * (m[1] * w2 + m[3] * w3) - p2, 2.0 * (m[3] * w2 + m[2] * w3) - p3
        # Gradient at the middle.
        u = inverse(mass_matrix(c, c2, c3))
        k2, k3 = mass_slopes(c, c2, c3, u[0] * p1, u[1] * p2 + u[3] * p3, u[3] * p2 + u[2] * p3)
        n2, n3 = mass_slopes(c, c2, c3, u[0] * r1, u[1] * r2 + u[3] * r3, u[3] * r2 + u[2] * r3)
        x, y, z = _tip_motion(plants, d, q1 + 0.5 * d1, c2, c3, d1, d2, d3)
        fx, fy, fz = rest[0] - give * x, rest[1] - give * y, rest[2] - give * z
        t1, t2, t3 = joint_torques(plants, d, q1 + 0.5 * d1, c2, c3, fx, fy, fz)
        s1 = -t1
        s2 = g2 * cos(c2) - 0.25 * (k2 + n2) - t2
        s3 = g3 * sin(c3) - 0.25 * (k3 + n3) - t3
        # Its correction along the step, so that energy is what it should be.
        length = d1 * d1 + d2 * d2 + d3 * d3
        if length > 0.0:
            change = (v[0] - w[0], v[1] - w[1], v[2] - w[2], v[3] - w[3])
            exact = 0.25 * (form(change, p1, p2, p3) + form(change, r1, r2, r3)) - fx * x - fy * y - fz * z
            exact += 2.0 * (g2 * cos(c2) * sin(0.5 * d2) + g3 * sin(c3) * sin(0.5 * d3))
            along = (exact - s1 * d1 - s2 * d2 - s3 * d3) / length
            s1, s2, s3 = s1 + along * d1, s2 + along * d2, s3 + along * d3
        # (M̄ + ½h b) ω̂ + ½h f sign(ω̂) = p + ½h (τ - ∇̄ψ)
        o1 = _shrink(p1 + half * (e1 - s1), half * f1) / (m[0] + half * b1)
        o2, o3 = w2, w3
        for _ in range(_SWEEPS):
            l2, l3 = o2, o3
            o2 = _shrink(p2 + half * (e2 - s2) - m[3] * o3, half * f2) / (m[1] + half * b2)
            o3 = _shrink(p3 + half * (e3 - s3) - m[3] * o2, half * f3) / (m[2] + half * b3)
            if o2 == l2 and o3 == l3:
                break
        step = abs(o1 - w1) + abs(o2 - w2) + abs(o3 - w3)
        size = abs(o1) + abs(o2) + abs(o3)
        w1, w2, w3 = o1, o2, o3
        if step <= _SETTLED * size or (iteration > _PATIENCE and step >= before):
            break
        before = step
    d1, d2, d3 = h * w1, h * w2, h * w3
    x, y, z = _tip_motion(plants, d, q1 + 0.5 * d1, q2 + 0.5 * d2, q3 + 0.5 * d3, d1, d2, d3)
    put(state.coordinate, (d, 0), q1 + d1)
    put(state.coordinate, (d, 1), q2 + d2)
    put(state.coordinate, (d, 2), q3 + d3)
    put(state.momentum, (d, 0), 2.0 * m[0] * w1 - p1)
    put(state.momentum, (d, 1), 2.0 * (m[1] * w2 + m[3] * w3) - p2)
    put(state.momentum, (d, 2), 2.0 * (m[3] * w2 + m[2] * w3) - p3)
    store_tip(plants, state, d)
    book_motors(state, d, e1 * d1 + e2 * d2 + e3 * d3, h * (b1 * w1 * w1 + b2 * w2 * w2 + b3 * w3 * w3))
    add_to_ledger(state, d, COULOMB_LOSS, h * (f1 * abs(w1) + f2 * abs(w2) + f3 * abs(w3)))
    held = (f1 > 0.0 and w1 == 0.0, f2 > 0.0 and w2 == 0.0, f3 > 0.0 and w3 == 0.0)
    if held[0] or held[1] or held[2]:
        _stop(c, state, d, held)
    if at(state.holding, d) != 0:
        pulled = (rest[0] - give * x) * shift[0] + (rest[1] - give * y) * shift[1] + (rest[2] - give * z) * shift[2]
        slip = (shift[0] - x) ** 2 + (shift[1] - y) ** 2 + (shift[2] - z) ** 2
        book_hand(grasps, state, d, h, pulled, slip)


@inner
def _rest(
    grasps: Grasps, state: DeviceState, d: int, h: float
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """The hand's mean pull on a tip that stands still, and how far its far end goes in this step."""
    stiffness, damping = at(grasps.stiffness, d), at(grasps.damping, d)
    a1, a2, a3 = at(state.equilibrium, (d, 0)), at(state.equilibrium, (d, 1)), at(state.equilibrium, (d, 2))
    correct(grasps, state, d, h)
    store(state.equilibrium, d, equilibrium_after(grasps, state, d, at(state.time, d) + h), LANES)
    i1, i2, i3 = (
        at(state.equilibrium, (d, 0)) - a1,
        at(state.equilibrium, (d, 1)) - a2,
        at(state.equilibrium, (d, 2)) - a3,
    )
    rest = (
        stiffness * (a1 + 0.5 * i1 - at(state.tip, (d, 0))) + damping / h * i1,
        stiffness * (a2 + 0.5 * i2 - at(state.tip, (d, 1))) + damping / h * i2,
        stiffness * (a3 + 0.5 * i3 - at(state.tip, (d, 2))) + damping / h * i3,
    )
    return rest, (i1, i2, i3)


@inner
def _tip_motion(
    plants: Plants, d: int, m1: float, m2: float, m3: float, d1: float, d2: float, d3: float
) -> tuple[float, float, float]:
    """How far the tip goes while the joints go by d1, d2, d3 around m1, m2, m3; without cancellation, however short."""
    l1, l2 = at(plants.length, (d, 0)), at(plants.length, (d, 1))
    h1, h2, h3 = sin(0.5 * d1), sin(0.5 * d2), sin(0.5 * d3)
    n1, n2, n3 = cos(0.5 * d1), cos(0.5 * d2), cos(0.5 * d3)
    r = l1 * cos(m2) * n2 + l2 * sin(m3) * n3  # mean of both ends
    longer = 2.0 * (l2 * cos(m3) * h3 - l1 * sin(m2) * h2)
    s1, c1 = sin(m1), cos(m1)
    return (
        2.0 * r * s1 * h1 - longer * c1 * n1,
        -2.0 * r * c1 * h1 - longer * s1 * n1,
        2.0 * (l2 * sin(m3) * h3 + l1 * cos(m2) * h2),
    )
