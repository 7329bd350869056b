"""Entries near the largest number are judged like any others, without a warning of overflow.

What makes a body faster than can be computed is refused: it stood still under any force, without a word.
"""

import warnings

import numpy as np
import pytest
import scipy.sparse as sp
from tests.body.inside import plausible

from cotouch import BodyError, lattice, point


def test_minors_of_huge_entries_are_compared_without_overflow() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plausible("stiffness", sp.csr_array(1e300 * np.array([[2.0, -1.0], [-1.0, 2.0]])))
        with pytest.raises(BodyError, match="positive semidefinite"):
            plausible("stiffness", sp.csr_array(1e300 * np.array([[1.0, -2.0], [-2.0, 1.0]])))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"stiffness": 1e300}, r"a stiffness of 2e\+300 N/m to the others and would oscillate at 2.83e\+150 rad/s"),
        ({"stiffness": 1e17}, "at most 1e\\+08 can be computed: give less stiffness or more mass"),
        ({"damping": 1e300}, r"a damping of 2e\+300 Ns/m to the others and would stop within 1.25e-301 s"),
        ({"damping": 1e13}, "at least 1e-12 can be computed: give less damping or more mass"),
    ],
)
def test_bodies_too_stiff_or_damped_to_be_computed_are_refused(options: dict[str, float], message: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(BodyError, match=rf"^node 1 of 0\.25 kg has .*{message}"):
            lattice((2, 2), **options)


def test_masses_whose_energies_are_no_numbers_are_refused() -> None:
    point(mass=1e30)
    with pytest.raises(BodyError, match=r"node 1 has a mass of 1e\+300 kg; at most 1e\+30 kg can be computed"):
        point(mass=1e300)


def test_what_is_held_by_the_ground_may_be_as_stiff_as_numbers_go() -> None:
    lattice((2, 2), stiffness=1e14, damping=1e10, ground="all", ground_stiffness=1e300, ground_damping=1e300)
