"""The PHANToM's mass matrix against its bodies, its motion against Lagrange's equations, its energy against zero."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from tests.device.support import BOOK, check_ledger

from cotouch.device import (
    PRESETS,
    Coupling,
    DeviceModel,
    PhantomPlant,
    ServoModel,
    SimulatedHand,
    advance,
    assemble,
    sure_force,
)

L1, L2, L3, L5, L6 = 0.215, 0.170, 0.0325, -0.0368, 0.0527
MASS = {"a": 0.0202, "c": 0.0249, "be": 0.2359, "df": 0.1906}
NUMBERS = PhantomPlant().inertia()
EARTH = 9.80665
angles = st.tuples(
    st.floats(np.radians(-90), np.radians(90)),
    st.floats(np.radians(-124), np.radians(119)),
    st.floats(np.radians(-65), np.radians(55)),
).map(lambda q: np.array([q[0], q[1], np.clip(q[1] + q[2], np.radians(-29), np.radians(214))]))


def mass_matrix(q, numbers=NUMBERS):
    i = numbers
    M = np.zeros((3, 3))
    M[0, 0] = i[0] + i[1] * np.cos(2 * q[1]) + i[2] * np.cos(2 * q[2]) + i[3] * np.cos(q[1]) * np.sin(q[2])
    M[1, 1], M[2, 2] = i[4], i[5]
    M[1, 2] = M[2, 1] = -i[6] * np.sin(q[1] - q[2])
    return M


def slopes(q, numbers=NUMBERS):
    """∂M_ij/∂q_k, (3, 3, 3), last index k; by hand."""
    i = numbers
    D = np.zeros((3, 3, 3))
    D[0, 0, 1] = -2 * i[1] * np.sin(2 * q[1]) - i[3] * np.sin(q[1]) * np.sin(q[2])
    D[0, 0, 2] = -2 * i[2] * np.sin(2 * q[2]) + i[3] * np.cos(q[1]) * np.cos(q[2])
    D[1, 2, 1] = D[2, 1, 1] = -i[6] * np.cos(q[1] - q[2])
    D[1, 2, 2] = D[2, 1, 2] = i[6] * np.cos(q[1] - q[2])
    return D


def coriolis(q, v, numbers=NUMBERS, wrong=0.0):
    """`C(q, v) v` by Christoffel symbols; `wrong` turns the sign of one of joint 2's terms."""
    D = slopes(q, numbers)
    gamma = 0.5 * (D + np.swapaxes(D, 1, 2) - np.transpose(D, (2, 0, 1)))
    force = np.einsum("ijk,j,k->i", gamma, v, v)
    force[1] -= 2 * wrong * gamma[1, 0, 0] * v[0] ** 2
    return force


def gravity(q):
    return np.array(
        [
            0.0,
            EARTH / 2 * (2 * L1 * MASS["a"] + 2 * L5 * MASS["be"] + L1 * MASS["c"]) * np.cos(q[1]),
            EARTH / 2 * (L2 * MASS["a"] + 2 * L3 * MASS["c"] - 2 * L6 * MASS["df"]) * np.sin(q[2]),
        ]
    )


def tip(q):
    r = L1 * np.cos(q[1]) + L2 * np.sin(q[2])
    return np.array([L1 - r * np.cos(q[0]), -r * np.sin(q[0]), L2 - L2 * np.cos(q[2]) + L1 * np.sin(q[1])])


def jacobian(q, of=tip, step=1e-6):
    return np.array([(of(q + step * e) - of(q - step * e)) / (2 * step) for e in np.eye(3)]).T


def placed(model, q, v, numbers=NUMBERS):
    """Tables with the joints at q, moving at v, the ledger opened there."""
    devices, state = assemble([model])
    state.coordinate[0, :3] = q
    state.measured[0, :3] = q
    state.momentum[0, :3] = mass_matrix(q, numbers) @ v
    state.tip[0, :3] = tip(q)
    state.sample[0, :3] = state.desired[0, :3] = state.set_position[0, :3] = state.equilibrium[0, :3] = tip(q)
    advance(devices, state, 0, 0.0)
    state.ledger[0, BOOK["initial"]] += state.ledger[0, BOOK["residual"]]
    advance(devices, state, 0, 0.0)
    return devices, state


def velocity(state, numbers=NUMBERS):
    return np.linalg.solve(mass_matrix(state.coordinate[0], numbers), state.momentum[0, :3])


FREE = Coupling(law="host_force")


def kinetic_of_bodies(q, v):
    """Kinetic energy of the links as rigid bodies: their centres' motion and their turning, nothing of the formula.

    Links a and c have their centres in the middle of their bars; c hangs l3 behind joint 3. The counterweighted bodies
    be and df turn with joints 2 and 3; their inertias are about the joints.
    """

    def centre(out, up):
        def place(q):
            r, height = out(q), up(q)
            return np.array([r * np.sin(q[0]), height, r * np.cos(q[0])])

        return place

    a = centre(lambda q: L1 * np.cos(q[1]) + L2 / 2 * np.sin(q[2]), lambda q: L1 * np.sin(q[1]) - L2 / 2 * np.cos(q[2]))
    c = centre(lambda q: L1 / 2 * np.cos(q[1]) + L3 * np.sin(q[2]), lambda q: L1 / 2 * np.sin(q[1]) - L3 * np.cos(q[2]))
    energy = sum(0.5 * MASS[n] * np.sum((jacobian(q, of) @ v) ** 2) for n, of in (("a", a), ("c", c)))
    inertias = {
        "a": (0.4864, 0.001843, 0.4864),
        "c": (0.959, 0.959, 0.0051),
        "be": (11.09, 10.06, 0.591),
        "df": (7.11, 0.629, 6.246),
    }
    for name, joint in (("a", 2), ("df", 2), ("c", 1), ("be", 1)):
        # The body's own axes: x along the joint, y and z turned by the joint's angle.
        spin = np.array([v[joint], v[0] * np.cos(q[joint]), v[0] * np.sin(q[joint])])
        energy += 0.5e-4 * np.sum(np.array(inertias[name]) * spin**2)
    return energy + 0.5 * 11.87e-4 * v[0] ** 2


@given(q=angles, seed=st.integers(0, 10**6))
def test_mass_matrix_is_that_of_its_bodies(q, seed):
    v = np.random.default_rng(seed).normal(size=3)
    M = mass_matrix(q)
    assert np.linalg.eigvalsh(M).min() > 1e-4
    assert 0.5 * v @ M @ v == pytest.approx(kinetic_of_bodies(q, v), rel=1e-7)
    _, state = placed(DeviceModel(plant=PhantomPlant(viscous=0.0, coulomb=0.0), coupling=FREE), q, v)
    assert state.ledger[0, BOOK["kinetic"]] == pytest.approx(0.5 * v @ M @ v, rel=1e-12)


@given(q=angles)
def test_a_holding_hand_is_a_point_mass_at_the_tip(q):
    v = np.array([1.0, -2.0, 3.0])
    hand = SimulatedHand(stiffness=0.0, damping=0.0, path=tuple(tip(q)))
    devices, state = assemble([DeviceModel(plant=PhantomPlant(viscous=0.0, coulomb=0.0), coupling=FREE, hand=hand)])
    state.coordinate[0, :3] = q
    J = jacobian(q)
    M = mass_matrix(q) + 0.554 * J.T @ J
    state.momentum[0, :3] = M @ v
    advance(devices, state, 0, 0.0)
    assert state.ledger[0, BOOK["kinetic"]] == pytest.approx(0.5 * v @ M @ v, rel=1e-6)


@given(seed=st.integers(0, 10**6))
def test_joints_are_found_for_a_place_of_the_tip(seed):
    place = np.random.default_rng(seed).uniform(-0.05, 0.05, 3)
    q = np.array(PhantomPlant().joints(tuple(place)))
    np.testing.assert_allclose(tip(q), place, atol=1e-12)
    model = DeviceModel(plant=PhantomPlant(gravity=True), position=tuple(place), coupling=FREE)
    devices, state = assemble([model])
    advance(devices, state, 0, 0.0)
    np.testing.assert_allclose(state.coordinate[0, :3], q)
    np.testing.assert_allclose(state.sample[0, :3], place, atol=1e-12)
    assert state.ledger[0, BOOK["residual"]] == 0.0


def test_joints_are_0_at_the_origin():
    assert PhantomPlant().joints((0.0, 0.0, 0.0)) == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


def test_apparent_mass_at_the_tip_is_the_published_one():
    """0.030 to 0.077 kg in the middle of the workspace, by direction."""
    J = jacobian(np.zeros(3))
    masses = 1.0 / np.linalg.eigvalsh(J @ np.linalg.solve(mass_matrix(np.zeros(3)), J.T))
    assert masses.min() == pytest.approx(0.030, rel=0.1)
    assert masses.max() == pytest.approx(0.077, rel=0.01)


@given(q=angles)
def test_a_force_at_the_tip_becomes_torques_by_the_jacobian(q):
    plant = PhantomPlant(viscous=0.0, coulomb=0.0, torque=(10.0, 10.0, 10.0))
    devices, state = placed(DeviceModel(plant=plant, coupling=FREE), q, np.zeros(3))
    force = np.array([0.3, -0.7, 0.5])
    state.host_force[0, :3] = force
    advance(devices, state, 0, 1e-4)
    np.testing.assert_allclose(state.effort[0, :3], jacobian(q).T @ force, atol=1e-9)


@given(q=angles)
def test_what_its_motors_can_do_everywhere(q):
    plant = PhantomPlant()
    devices, _ = assemble([DeviceModel(plant=plant), DeviceModel(servo=ServoModel(force=3.0)), DeviceModel()])
    most = sure_force(devices, 0)
    largest = most * np.linalg.norm(jacobian(q), axis=0)  # of each torque, in the direction worst for it
    assert np.all(largest <= np.array(plant.torque) * (1.0 + 1e-8))
    stretched = most * np.linalg.norm(jacobian(np.array([0.0, 0.0, np.pi / 2])), axis=0)
    assert np.max(stretched / np.array(plant.torque)) == pytest.approx(1.0, rel=1e-8)
    assert (sure_force(devices, 1), sure_force(devices, 2)) == (3.0, np.inf)


def reference(q, v, until, *, weigh=False, wrong=0.0):
    def motion(_, y):
        q, v = y[:3], y[3:]
        load = coriolis(q, v, wrong=wrong) + (gravity(q) if weigh else 0.0)
        return np.concatenate([v, np.linalg.solve(mass_matrix(q), -load)])

    done = solve_ivp(motion, (0.0, until), np.concatenate([q, v]), method="DOP853", rtol=1e-12, atol=1e-13)
    return done.y[:3, -1], done.y[3:, -1]


Q0, V0 = np.array([0.3, -0.2, 0.4]), np.array([3.0, -2.0, 2.5])


@pytest.mark.parametrize("weigh", [False, True])
def test_motion_is_lagranges_with_coriolis_by_christoffel_symbols(weigh):
    """Second order in the step, towards an independent integration."""
    q, v = reference(Q0, V0, 0.5, weigh=weigh)
    errors = []
    for substep in (4e-4, 2e-4, 1e-4):
        plant = PhantomPlant(viscous=0.0, coulomb=0.0, gravity=weigh)
        model = DeviceModel(plant=plant, coupling=FREE, servo=ServoModel(substep=substep))
        devices, state = placed(model, Q0, V0)
        advance(devices, state, 0, 0.5)
        errors.append(np.abs(np.concatenate([state.coordinate[0, :3] - q, velocity(state) - v])).max())
    assert errors[-1] < 1e-5
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2.0, atol=0.1)


def test_a_wrong_sign_shows_as_energy():
    """The public port's kind of error, in the reference: what no test of balance alone could miss."""
    before = 0.5 * V0 @ mass_matrix(Q0) @ V0
    for wrong, least, most in ((0.0, 0.0, 1e-10), (1.0, 0.01, np.inf)):
        q, v = reference(Q0, V0, 2.0, wrong=wrong)
        drift = abs(0.5 * v @ mass_matrix(q) @ v / before - 1.0)
        assert least <= drift <= most


@pytest.mark.parametrize("weigh", [False, True])
@pytest.mark.parametrize("substep", [1e-4, 1e-3])
def test_energy_does_not_drift(weigh, substep):
    plant = PhantomPlant(viscous=0.0, coulomb=0.0, gravity=weigh)
    devices, state = placed(DeviceModel(plant=plant, coupling=FREE, servo=ServoModel(substep=substep)), Q0, V0)
    first = state.ledger[0, BOOK["kinetic"]]
    for k in range(1, 21):
        assert advance(devices, state, 0, 0.1 * k)
        assert abs(state.ledger[0, BOOK["residual"]]) < 1e-12 * first
    assert state.coordinate[0, :3] != pytest.approx(Q0, abs=0.1)


@given(seed=st.integers(0, 10**6), grip=st.sampled_from([0.25, 1.0, 4.0]), coulomb=st.sampled_from([0.0, 0.01]))
def test_books_close_with_everything_at_work(seed, grip, coulomb):
    rng = np.random.default_rng(seed)
    hand = SimulatedHand(
        path=[(0.1 * n, *rng.uniform(-0.08, 0.08, 3)) for n in range(6)],
        amplitude=tuple(rng.uniform(0.0, 0.02, 3)),
        frequency=float(rng.uniform(0.5, 6.0)),
        grip=grip,
        begin=float(rng.choice([0.0, 0.1])),
        release=0.4,
        correction=2.0,
    )
    model = DeviceModel(
        plant=PhantomPlant(gravity=bool(rng.integers(2)), coulomb=coulomb),
        servo=ServoModel(resolution=1e-4, force=8.0, period=tuple(rng.uniform(5e-4, 2e-3, 3))),
        coupling=Coupling(stiffness=800.0, damping=1.0),
        hand=hand,
    )
    devices, state = placed(model, rng.uniform(-0.3, 0.3, 3), rng.normal(0.0, 1.0, 3))
    check_ledger(devices, state, rng, within=1e-11)


def test_friction_stops_every_joint_for_good():
    plant = PhantomPlant(viscous=0.0, coulomb=0.01)
    devices, state = placed(DeviceModel(plant=plant, coupling=FREE), Q0, np.array([2.0, 1.0, -1.0]))
    advance(devices, state, 0, 1.0)
    np.testing.assert_array_equal(state.momentum[0], 0.0)
    assert state.ledger[0, BOOK["coulomb_loss"]] == pytest.approx(state.ledger[0, BOOK["initial"]], rel=1e-12)
    before = state.coordinate.copy()
    state.host_force[0, :3] = [0.01, 0.0, 0.01]  # less than friction holds
    advance(devices, state, 0, 2.0)
    np.testing.assert_array_equal(state.coordinate, before)
    np.testing.assert_array_equal(state.momentum[0], 0.0)


def test_one_joint_may_be_held_while_others_move():
    plant = PhantomPlant(viscous=0.0, coulomb=0.01)
    devices, state = placed(DeviceModel(plant=plant, coupling=FREE), np.zeros(3), np.zeros(3))
    state.host_force[0, :3] = [0.0, 0.3, 0.0]  # turns joint 1 alone
    advance(devices, state, 0, 0.05)
    assert abs(state.coordinate[0, 0]) > 0.01
    np.testing.assert_array_equal(state.coordinate[0, 1:3], 0.0)
    assert abs(state.ledger[0, BOOK["residual"]]) < 1e-13


def test_torque_limits_shorten_the_force_and_keep_its_direction():
    devices, state = placed(DeviceModel(plant=PhantomPlant(), coupling=FREE), np.zeros(3), np.zeros(3))
    force = np.array([30.0, 40.0, 50.0])
    state.host_force[0, :3] = force
    advance(devices, state, 0, 1e-4)
    got = state.force[0, :3]
    np.testing.assert_allclose(np.cross(got, force), 0.0, atol=1e-12)
    assert 0.0 < np.linalg.norm(got) < np.linalg.norm(force)
    torque = np.array(PhantomPlant().torque)
    assert np.max(np.abs(state.effort[0, :3]) / torque) == pytest.approx(1.0, rel=1e-12)
    assert state.ledger[0, BOOK["saturated"]] >= 1.0


@pytest.mark.parametrize("towards", [*np.eye(3), *-np.eye(3), np.ones(3) / np.sqrt(3.0)])
def test_its_motors_can_do_what_its_preset_says_they_do(towards):
    """8.5 N in the middle of the workspace; and all the time, at the torque that motors have so, 1.4 N."""
    spec = PRESETS["phantom"]
    devices, state = placed(
        DeviceModel(plant=PhantomPlant(), coupling=FREE, servo=ServoModel(force=spec.force)), np.zeros(3), np.zeros(3)
    )
    state.host_force[0, :3] = 100.0 * towards
    advance(devices, state, 0, 1e-4)
    np.testing.assert_allclose(state.force[0, :3], spec.force * towards, atol=1e-9)
    continuous = 0.0286 * np.array([13.3, 11.2, 11.2])
    assert np.all(np.abs(jacobian(np.zeros(3)).T @ towards) * spec.continuous_force <= continuous)
    assert np.array(PhantomPlant().torque) == pytest.approx(continuous * spec.force / spec.continuous_force)
