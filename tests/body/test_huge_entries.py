"""Entries near the largest number are judged like any others, without a warning of overflow."""

import warnings

import numpy as np
import pytest
import scipy.sparse as sp

from cotouch import BodyError
from cotouch.body._checks import plausible


def test_minors_of_huge_entries_are_compared_without_overflow() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plausible("stiffness", sp.csr_array(1e300 * np.array([[2.0, -1.0], [-1.0, 2.0]])))
        with pytest.raises(BodyError, match="positive semidefinite"):
            plausible("stiffness", sp.csr_array(1e300 * np.array([[1.0, -2.0], [-2.0, 1.0]])))
