"""What an account pays for coarse encoders, and begins with."""

import pytest

from cotouch.mechanics import encoder_toll, most_toll, opening_energy


def test_a_toll_is_what_a_step_charges_by_its_length() -> None:
    """A step changes the force by the spring's and the damper's share, and back; each change costs half a step."""
    k, b, window, step = 700.0, 3.0, 0.02, 5e-5
    jump = k * step + b * step / window
    assert encoder_toll(stiffness=k, damping=b, window=window, resolution=step) == pytest.approx(jump)
    assert 2 * jump * 0.5 * step / step == pytest.approx(jump)
    assert encoder_toll(stiffness=k, damping=b, window=window, resolution=0.0) == 0.0


def test_an_account_begins_with_no_more_than_it_keeps() -> None:
    assert opening_energy(0.0, 0.1) == 0.0
    assert opening_energy(0.1, 1.0) == pytest.approx(0.03)
    assert opening_energy(10.0, 0.1) == 0.1


def test_more_damping_pays_for_more_up_to_a_limit() -> None:
    limits = [most_toll(b) for b in (0.0, 2.0, 5.0, 100.0)]
    assert limits == pytest.approx([0.02, 0.06, 0.12, 0.135])
