"""Modes of a body for the planner: against its eigenvalues, and the closed loop of whole bodies."""

import numpy as np
import pytest
import scipy.linalg as la
from tests.planning.support import five_users

from cotouch import plan
from cotouch.body import Body, chain, point
from cotouch.errors import UnsupportedError
from cotouch.planning import modes_of


def test_a_point_is_its_own_mode():
    assert {name: part.tolist() for name, part in modes_of(point(mass=2.0, damping=0.3, stiffness=4.0)).items()} == {
        "mass": [2.0],
        "damping": [0.3],
        "stiffness": [4.0],
    }


def test_what_turns_counts_as_what_it_is_at_rest():
    turning, fixed = (chain(4, mass=0.8, stiffness=50.0, dimension=3, frame=frame) for frame in ("floating", "fixed"))
    for name, part in modes_of(fixed).items():
        np.testing.assert_array_equal(modes_of(turning.with_gravity((0.0, 0.0, -9.81)))[name], part)


def test_modes_are_the_eigenvalues_and_equal_ones_count_once():
    body = chain(4, mass=0.8, stiffness=50.0, dimension=3)
    modes = modes_of(body)
    stiffness, mass = body.stiffness.toarray(), body.mass.toarray()
    expected = np.unique(np.round(la.eigh(stiffness, mass, eigvals_only=True), 9))
    np.testing.assert_allclose(np.sort(modes["stiffness"] / modes["mass"]), expected, atol=1e-9)
    assert modes["stiffness"].min() == 0.0, "a free body rests anywhere"
    np.testing.assert_allclose(modes["mass"], 0.2)


def test_the_slowest_mode_of_a_body_counts():
    body = chain(3, mass=1.5, stiffness=20.0)
    modes = modes_of(body)
    found = plan(five_users(), links=6, objective="decay", **modes)
    single = [
        plan(five_users().with_links(None), links=6, objective="decay", require=found.best.links, mass=m, stiffness=k)
        for m, k in zip(modes["mass"], modes["stiffness"], strict=True)
    ]
    assert found.best.value == pytest.approx(max(one.best.value for one in single), rel=1e-9)


def test_a_body_without_modes_says_what_to_do():
    body = Body(mass=np.diag([1.0, 2.0]), rest=[0.0, 1.0], stiffness_int=np.array([[1.0, -1.0], [-1.0, 1.0]]))
    with pytest.raises(UnsupportedError, match=r"no independent modes.*mass, damping and stiffness"):
        modes_of(body)
