"""What is wrong with a surface is mended and said, or refused."""

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.body.inside import Shells, repaired
from tests.body.shapes import box, joined, sphere, volume

from cotouch.errors import BodyError
from cotouch.meshfile import Mesh

SPHERE = sphere(2)


def mended(points: np.ndarray, faces: np.ndarray) -> Shells:
    return repaired(Mesh(points=points, elements=faces), "x.stl")


def is_closed(shells: Shells) -> bool:
    """Every edge is passed as often one way as the other."""
    ends = np.concatenate([shells.triangles[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    count = shells.vertices.shape[0]
    net = np.zeros((count, count))
    np.add.at(net, tuple(ends.T), 1.0)
    return bool(np.array_equal(net, net.T))


def test_a_good_surface_stays_as_it_is():
    shells = mended(*SPHERE)
    assert shells.notes == ()
    assert shells.triangles.shape == SPHERE[1].shape
    assert shells.volume == pytest.approx(volume(*SPHERE), rel=1e-12)


@given(st.sets(st.integers(0, len(SPHERE[1]) - 1)))
def test_flipped_faces_are_turned_round(flipped: set[int]):
    points, faces = SPHERE[0], SPHERE[1].copy()
    chosen = sorted(flipped)
    faces[chosen] = faces[chosen][:, ::-1]
    shells = mended(points, faces)
    assert is_closed(shells)
    assert shells.volume == pytest.approx(volume(*SPHERE), rel=1e-12)
    if 0 < len(chosen) < len(faces):
        what = f"{len(chosen)} triangle{'s' * (len(chosen) > 1)} of {len(faces)} flipped, so that all face outwards"
        assert shells.notes[0].startswith(what)


def test_inside_out_is_turned():
    shells = mended(SPHERE[0], SPHERE[1][:, ::-1])
    assert shells.notes == ("The surface was inside out and has been flipped.",)
    assert shells.volume == pytest.approx(volume(*SPHERE))


@given(st.sets(st.integers(0, len(SPHERE[1]) - 1), min_size=1, max_size=8))
def test_holes_are_filled(missing: set[int]):
    faces = np.delete(SPHERE[1], sorted(missing), axis=0)
    shells = mended(SPHERE[0], faces)
    assert is_closed(shells)
    assert shells.volume == pytest.approx(volume(*SPHERE), rel=0.1)
    assert re.match(r"\d holes? filled, [\d.]+ % of the surface\.", shells.notes[0])


def test_holes_are_counted():
    far = [
        int(np.argmax(SPHERE[0][SPHERE[1]].mean(axis=1) @ side)) for side in ([1, 0, 0.1], [-1, 0, 0.1], [0, 1, 0.1])
    ]
    assert mended(SPHERE[0], np.delete(SPHERE[1], far, axis=0)).notes[0].startswith("3 holes filled, ")
    assert mended(SPHERE[0], np.delete(SPHERE[1], far[:1], axis=0)).notes[0].startswith("1 hole filled, ")


def test_points_of_their_own_for_every_triangle_are_merged():
    soup = SPHERE[0][SPHERE[1]].reshape(-1, 3)
    noise = 1e-8 * np.random.default_rng(0).uniform(-1, 1, soup.shape)
    shells = mended(soup + noise, np.arange(len(soup)).reshape(-1, 3))
    assert shells.vertices.shape == SPHERE[0].shape
    assert is_closed(shells)


def test_a_crowd_in_one_place_is_one_point():
    points, faces = sphere(4)
    shells = mended(*joined(box(), (1e-8 * points, faces)))
    assert shells.vertices.shape == (8, 3)
    assert shells.notes == (f"{len(faces)} degenerate triangles left out.",)


def test_degenerate_and_repeated_triangles_go():
    points, faces = SPHERE
    extra = np.concatenate([faces, [[0, 0, 1], [3, 4, 4], [5, 5, 5]], faces[:2], faces[2:3, ::-1]])
    shells = mended(points, extra)
    assert shells.triangles.shape == faces.shape
    assert shells.notes == ("3 degenerate triangles left out.", "3 triangles that repeated another left out.")


def test_a_cavity_stays_hollow_and_a_part_inside_out_does_not():
    outer, inner, beside = box((4, 4, 4)), box((1, 1, 1), (1, 1, 1)), box((2, 2, 2), (5, 0, 0))
    hollow = (inner[0], inner[1][:, ::-1])
    shells = mended(*joined(outer, hollow))
    assert (shells.volume, shells.notes) == (pytest.approx(63.0), ("1 cavity kept hollow.",))
    shells = mended(*joined(outer, (beside[0], beside[1][:, ::-1])))
    assert shells.volume == pytest.approx(72.0)
    assert shells.notes == ("12 triangles of 24 flipped, so that all face outwards.",)
    all_wrong = joined((outer[0], outer[1][:, ::-1]), inner)
    assert mended(*all_wrong).notes == ("The surface was inside out and has been flipped.", "1 cavity kept hollow.")


def test_specks_are_left_out():
    shells = mended(*joined(box(), box((0.05, 0.05, 0.05), (3, 0, 0)), box((0.02, 0.02, 0.02), (0, 9, 0))))
    assert shells.notes == ("2 specks left out, each below 0.1 % of the largest part.",)
    assert shells.vertices.max() == 1.0


def mobius() -> tuple[np.ndarray, np.ndarray]:
    angle = np.linspace(0.0, 2.0 * np.pi, 20, endpoint=False)
    rim = [
        np.stack(
            [
                np.cos(angle) * (2 + s * np.cos(angle / 2)),
                np.sin(angle) * (2 + s * np.cos(angle / 2)),
                s * np.sin(angle / 2),
            ],
            axis=1,
        )
        for s in (-0.5, 0.5)
    ]
    faces = []
    for i in range(20):
        j = (i + 1) % 20
        a, b, c, d = (i, j, 20 + i, 20 + j) if j else (i, 20, 20 + i, 0)  # joined after half a turn
        faces += [[a, b, c], [b, d, c]]
    return np.concatenate(rim), np.array(faces)


@pytest.mark.parametrize(
    ("points", "faces", "message"),
    [
        (*mobius(), "x.stl has only one side, like a Möbius band"),
        (box()[0], box()[1][:6], "x.stl is open: closing it would add"),
        (np.eye(3), [[0, 1, 2]], "x.stl is open: closing it would add 100 %"),
        (np.eye(3), [[0, 1, 2], [0, 2, 1], [1, 1, 2]], "x.stl is open"),
        (np.ones((3, 3)), [[0, 1, 2]], "all points of x.stl are the same"),
        ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], "no triangle of x.stl has an area"),
        (box()[0] * [1, 1, 0], box()[1], "x.stl is open"),
        (
            [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]],
            [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
            "encloses no volume",
        ),
        (
            box()[0] * np.where(np.arange(24).reshape(8, 3) == 4, np.nan, 1),
            box()[1],
            "every coordinate must be a finite",
        ),
        (box()[0], box()[1] + 1, "triangles of x.stl name point 8; it has points 0 to 7"),
        (box()[0], box()[1] - 1, "triangles of x.stl name point -1; it has points 0 to 7"),
    ],
)
def test_refused(points: np.ndarray, faces: np.ndarray, message: str):
    with pytest.raises(BodyError, match=re.escape(message)):
        mended(np.array(points, dtype=float), np.array(faces))
