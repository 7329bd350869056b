"""What an account pays for coarse encoders, and begins with."""

import pytest
from tests.coupling.inside import most_toll

from cotouch.coupling import encoder_toll, opening_energy


def test_a_toll_is_what_a_step_charges_by_its_length() -> None:
    """A step changes the force by the spring's and the damper's share, and back; each change costs half a step."""
    k, b, window, step = 700.0, 3.0, 0.02, 5e-5
    jump = k * step + b * step / window
    assert encoder_toll(stiffness=k, damping=b, window=window, resolution=step) == pytest.approx(jump)
    assert 2 * jump * 0.5 * step / step == pytest.approx(jump)
    assert encoder_toll(stiffness=k, damping=b, window=window, resolution=0.0) == 0.0


def test_an_account_begins_with_no_more_than_it_keeps() -> None:
    assert opening_energy(toll=0.0, stiffness=5000.0, cap=0.1) == 0.005
    assert opening_energy(toll=0.0, stiffness=5000.0, cap=0.001) == 0.001
    assert opening_energy(toll=0.1, stiffness=1000.0, cap=1.0) == pytest.approx(0.03)
    assert opening_energy(toll=10.0, stiffness=0.0, cap=0.1) == 0.1


def test_two_ends_hold_a_firm_grip_with_what_they_begin_with() -> None:
    """Springs of `½ F²/k` at both ends and behind the tick before, less what the hand brings."""
    k, force = 800.0, 5.0
    spring = 0.5 * force**2 / k
    assert 2 * opening_energy(toll=0.0, stiffness=k, cap=0.1) + spring == pytest.approx(3 * spring)


def test_more_damping_pays_for_more_up_to_a_limit() -> None:
    limits = [most_toll(b) for b in (0.0, 2.0, 5.0, 100.0)]
    assert limits == pytest.approx([0.02, 0.06, 0.12, 0.135])
