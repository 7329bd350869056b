"""Devices that render torques: axes and units, limits, and no torque is left by whatever fails."""

import time
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from tests.drivers.driving import TWIST, acts, fails, is_sentence, push, ready
from tests.drivers.inside import ForceDimension, Touch, quaternion_of
from tests.drivers.standin import Board, Fault
from tests.stalls import Stalls

from cotouch.haptics import FORCE_DIMENSION_FRAME, OPENHAPTICS_FRAME, Flag

AXES = {"sigma.7": FORCE_DIMENSION_FRAME, "Premium 6DOF": OPENHAPTICS_FRAME}
Device6 = ForceDimension | Touch
OFF = np.zeros(3)


@pytest.fixture
def board(running: Callable[..., AbstractContextManager[Board]]) -> Generator[Board]:
    with running(system=104, wrist=True) as board:
        yield board
        assert board.get("violations") == 0, board.said


@pytest.fixture(params=list(AXES))
def device(request: pytest.FixtureRequest, board: Board, built: Path) -> Generator[Device6]:
    made = ForceDimension(library=str(built)) if request.param == "sigma.7" else Touch(library=str(built))
    yield made
    made.close()


def of(device: Device6) -> str:
    return "sigma.7" if isinstance(device, ForceDimension) else "Premium 6DOF"


def test_torque_goes_out_along_the_axes_of_forces(board: Board, device: Device6):
    ready(device)
    reading = push(device, 5)
    frame = AXES[of(device)]
    np.testing.assert_allclose(board.get("torque"), frame.back(TWIST), rtol=1e-12)
    np.testing.assert_allclose(board.get("twist"), frame.back(TWIST), rtol=1e-12)
    np.testing.assert_allclose(reading.torque, TWIST, rtol=1e-12)


def test_a_turn_is_seen_along_the_axes_of_torques(board: Board, device: Device6):
    ready(device)
    seen = Rotation.from_quat(push(device, 20).orientation)
    matrix = AXES[of(device)].matrix
    theirs = matrix @ Rotation.from_quat(board.get("turned")).as_matrix() @ matrix.T
    assert seen.magnitude() > 0.02
    # It moves meanwhile; with any axis swapped or mirrored it would be off by as much as it is turned.
    assert (Rotation.from_matrix(theirs) * seen.inv()).magnitude() < 0.3 * seen.magnitude()


def test_limits_of_torque(board: Board, device: Device6):
    ready(device)
    spec = device.spec
    # Those of CHAI3D; of the library where they are less: its stub says 515 and 40 mNm.
    assert (spec.torque, spec.continuous_torque) == ((0.2, 0.2) if of(device) == "sigma.7" else (0.17, 0.04))
    reading = push(device, 5, OFF, twist=10.0 * TWIST)
    assert reading.flags & Flag.LIMITED
    assert np.linalg.norm(board.get("twist")) == pytest.approx(spec.torque)
    np.testing.assert_allclose(reading.torque, spec.torque * TWIST / np.linalg.norm(TWIST))
    assert board.get("max_torque") == (0.2 if of(device) == "sigma.7" else 0.0)


def test_torque_alone_is_taken_away_as_force_is(board: Board, device: Device6, stalls: Stalls):
    ready(device)
    acts(device, board, "twist", OFF)
    for take in (device.stop, lambda: device.enable_force(False)):
        began = time.monotonic()
        take()
        reading = push(device, 5, OFF)
        assert not np.any(reading.torque)
        assert not any(board.get("torque"))
        stalls.within(began, board.gone_after(began))
        device.enable_force()
        acts(device, board, "twist", OFF)
    began = time.monotonic()
    time.sleep(0.15)  # the servo hangs: the firmware or the library's tick knows
    stalls.within(began, board.gone_after(began))


@pytest.mark.parametrize(
    ("fault", "value", "words"),
    [
        (Fault.UNPLUGGED, 0.0, ""),
        (Fault.FROZEN, 0.0, "repeats one position"),
        (Fault.SLOW, 0.09, ""),
        (Fault.SAFETY, 0x0203, ""),
    ],
    ids=["unplugged", "frozen", "slow", "safety"],
)
def test_no_torque_is_left_by_what_fails(
    board: Board, device: Device6, fault: Fault, value: float, words: str, stalls: Stalls
):
    if fault is Fault.SLOW and isinstance(device, Touch):
        pytest.skip("a slow library is silent, which is another test")
    try:
        why, zero = fails(device, board, fault, value)
        assert words in why
        assert is_sentence(why)
        stalls.within(board.get("struck"), zero)
    finally:
        device.close()


def test_an_orientation_that_stands_still_while_the_handle_turns_is_a_fault(board: Board, built: Path, stalls: Stalls):
    device = ForceDimension(library=str(built))
    why, zero = fails(device, board, Fault.STUCK)
    assert "repeats one orientation" in why
    stalls.within(board.get("struck"), zero)
    device.close()


def test_an_orientation_that_is_no_number_is_handed_on(board: Board, device: Device6):
    ready(device)
    board.inject(Fault.BENT)
    reading = push(device, 3)
    assert reading.orientation is not None
    assert np.isnan(reading.orientation).all()


@pytest.mark.parametrize("matrix", [np.full(9, np.nan), np.full(9, -np.inf)])
def test_what_is_no_rotation_is_no_number(matrix: np.ndarray):
    assert np.isnan(quaternion_of(matrix.tolist())).all()
