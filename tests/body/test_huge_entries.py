"""Entries near the largest number are judged like any others, without a warning of overflow."""

import warnings

import numpy as np
import pytest
import scipy.sparse as sp

from cotouch import BodyError
from cotouch.body._checks import plausible
from cotouch.mechanics import relief_on


def test_minors_of_huge_entries_are_compared_without_overflow() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plausible("stiffness", sp.csr_array(1e300 * np.array([[2.0, -1.0], [-1.0, 2.0]])))
        with pytest.raises(BodyError, match="positive semidefinite"):
            plausible("stiffness", sp.csr_array(1e300 * np.array([[1.0, -2.0], [-2.0, 1.0]])))


def test_a_relief_too_fine_to_count_is_refused_without_a_warning() -> None:
    place = np.eye(3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(BodyError, match="points on this skin"):
            relief_on(place, np.array([[0, 1, 2]]), lambda where, _: where[:, 0], spacing=1e-300, most=2_000_000)
