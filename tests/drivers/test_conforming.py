"""Every driver passes the suite of all devices against its stand-in, and breaks none of the vendor's rules."""

import pytest
from tests.haptics.conformance import MOVING, STAND_INS, assert_conforms
from tests.stalls import Stalls

from cotouch.haptics import device_names


@pytest.mark.parametrize("name", STAND_INS)
def test_every_device_conforms(name: str, request: pytest.FixtureRequest, stalls: Stalls):
    with STAND_INS[name](request) as make:
        assert_conforms(make, stalls, allow_motion=name in MOVING)


def test_every_driver_of_this_package_has_a_stand_in():
    assert {name.partition(":")[0] for name in STAND_INS} == set(device_names())
