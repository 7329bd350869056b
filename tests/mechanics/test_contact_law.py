"""What every contact law must do: conformance over the registry, and what the sum over a skin must come to."""

from math import pi, sqrt
from typing import Any, NamedTuple, cast

import numpy as np
import numpy.typing as npt
import pytest
from tests.mechanics.inside import Foundation
from tests.mechanics.inside import press as press_point
from tests.mechanics.pressing import areas, flat

from cotouch.errors import ScenarioError
from cotouch.installed import installed_names
from cotouch.kernels import inner, kernel, upper
from cotouch.mechanics import CONTACT_LAWS, Stiffening, conform_contact_law, contact_law_named, press_skin

Float = npt.NDArray[np.float64]
R, K = 0.01, 1000.0
for name in installed_names("cotouch.contact_laws"):  # the suite is that of whoever brings a law, too
    contact_law_named(name)
EVERY = [kind() for kind in CONTACT_LAWS]


def press(
    law: Any, place: Float, corner: npt.NDArray[np.int32], middle: npt.ArrayLike, area: Float | None = None
) -> tuple[float, Float]:
    """Energy of the ball, and the forces on the skin's vertices, (V, 3)."""
    return press_skin(law, place, corner, np.array(middle, dtype=np.float64), stiffness=K, radius=R, area=area)


@kernel
def at_depth(law: Any, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    """A law for tests."""
    return press_point(law, stiffness, radius, depth)


@pytest.mark.parametrize("law", EVERY)
def test_every_law_keeps_the_interface(law: Any) -> None:
    assert conform_contact_law(law) == []


class Cubic(NamedTuple):
    """A new law in a few lines: `ψ = k w³ / R³`, and one that says another pressure than its energy's."""

    lie: float = 1.0


class Broken(NamedTuple):
    """What laws get wrong, one at a time."""

    slip: int = 0


@inner
def broken(law: Broken, stiffness: float, radius: float, depth: float) -> Any:
    share = stiffness / radius**3
    if law.slip == 1:
        return share * depth**3, 3.0 * share * depth**2
    if law.slip == 2:
        return share * depth**2.5, 2.5 * share * depth**1.5, 6.0 * share * depth**0.5
    if law.slip == 3:
        energy = share * depth**3 if depth > 0.001 else share * depth * depth * depth
        return energy, 3.0 * share * depth**2, 6.0 * share * depth
    if law.slip == 4:
        return -share * depth**3, -3.0 * share * depth**2, 6.0 * share * depth
    if law.slip == 5:
        return share * (1.0 + depth), share + 0.0 * depth, 0.0 * depth
    if law.slip == 6:
        return share * depth**3, 3.0 * share * depth**2, 5.0 * share * depth
    return law.slop, law.slop, law.slop  # pyright: ignore[reportAttributeAccessIssue, reportUnknownMemberType, reportUnknownVariableType]


@pytest.mark.parametrize(
    ("slip", "said"),
    [
        (1, "it returns 2 values; it must return energy, pressure and slope"),
        (2, "it cannot be evaluated: four numbers at once take whole powers only, not 2.5"),
        (3, "it cannot be evaluated: it branches on what may be four numbers at once"),
        (4, "energy, pressure or slope is negative or no number"),
        (5, "energy or pressure does not vanish at the tool's surface"),
        (6, "slope is below the derivative of pressure"),
        (7, "it cannot be evaluated: 'Broken' object has no attribute 'slop'"),
    ],
)
def test_what_a_law_gets_wrong_is_one_sentence(slip: int, said: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONTACT_LAWS, Broken, broken)
    assert said in conform_contact_law(Broken(slip))


@inner
def cubic(law: Cubic, stiffness: float, radius: float, depth: float) -> tuple[float, float, float]:
    share = stiffness / radius**3
    return share * depth**3, 3.0 * law.lie * share * depth**2, 6.0 * share * depth


@inner
def _refusing(law: Broken, stiffness: float, radius: float, depth: float) -> Any:
    if law.slip < 0:
        raise ValueError
    return 0.0, 0.0, 0.0


@inner
def _wrong_in_the_middle(law: Broken, stiffness: float, radius: float, depth: float) -> Any:
    share = stiffness / radius**3
    beyond = upper(depth - 0.45 * radius, 0.0)
    return share * depth**3, 3.0 * share * (depth**2 + beyond * depth), 6.0 * share * depth * (1.0 + beyond)


class Lacking(NamedTuple):
    """Nobody could name it in a scenario without saying all numbers."""

    firm: float
    soft: float = 1.0


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (cast("Any", cubic).py_func, "its function is not compiled; write `@inner` above it"),
        (_refusing, "it raises an error or asserts (test_contact_law.py, line "),
        (_wrong_in_the_middle, "pressure is not the derivative of energy"),
    ],
)
def test_a_law_that_a_step_could_not_call_is_one_sentence(
    function: Any, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(CONTACT_LAWS, Broken, function)
    assert any(entry.startswith(said) for entry in conform_contact_law(Broken()))


def test_each_number_of_a_law_has_a_default(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONTACT_LAWS, Lacking, cubic)
    with pytest.raises(ScenarioError, match=r'^contact law "lacking" has no default for firm; each number needs one$'):
        contact_law_named("lacking")


@pytest.mark.parametrize("lie", [1.0, 1.1])
def test_a_new_law_is_one_file_and_a_wrong_one_is_told(lie: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONTACT_LAWS, Cubic, cubic)
    assert bool(conform_contact_law(Cubic(lie))) == (lie != 1.0)
    energies = [press(Cubic(lie), *flat(cells, seed=cells), (0.001, 0.002, 0.008))[0] for cells in (2, 5, 13)]
    np.testing.assert_allclose(energies, energies[0], rtol=1e-12)  # exact for polynomials of the third degree


def on_a_flat(law: Any, height: float) -> float:
    """Force of the whole plane in closed form [N]."""
    share = 1.0 - (height / R) ** 2
    if isinstance(law, Foundation):
        modulus = 0.1 * K / (pi * R * R) / (0.25 * 0.9 * (1.0 - 0.81) ** 2)
        return modulus * pi * height * R * R * share**2 / 4.0
    return 2.0 * pi * height * at_depth(law, K, R, 0.5 * R * share)[0]


@pytest.mark.parametrize("law", [Foundation(), Stiffening()])
@pytest.mark.parametrize(("height", "within"), [(0.0099, 1e-12), (0.009, 1e-8), (0.005, 1e-4)])
def test_a_flat_pushes_as_the_closed_form_says(law: Any, height: float, within: float) -> None:
    for cells in (1, 4, 23):
        _, force = press(law, *flat(cells, seed=cells), (0.0013, -0.002, height))
        assert -force[:, 2].sum() == pytest.approx(on_a_flat(law, height), rel=within)
    assert on_a_flat(law, 0.9 * R) == pytest.approx(0.1 * K * R)  # what `stiffness` means


@pytest.mark.parametrize("law", EVERY)
def test_a_flat_pushes_alike_where_its_triangles_meet(law: Any) -> None:
    """The ball's foot in a corner or on a side, and a disc that touches a side, or would but for rounding."""
    corner = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]], dtype=np.int32)
    place = np.array([[0.0, 0.0, 0.0], [0.03, 0.0, 0.0], [0.0, 0.03, 0.0], [-0.03, 0.0, 0.0], [0.0, -0.03, 0.0]])
    height, edge = 0.0075, R * sqrt(1.0 - 0.75**2)
    energy, force = press(law, place, corner, (0.0062, 0.0071, height))
    beyond = [edge + sign * gap for gap in (1e-17, 1e-13, 1e-10, 1e-8) for sign in (1.0, -1.0)]
    for x, y in [(0.0, 0.0), (0.009, 0.0), (1e-18, -1e-18), *((0.01, y) for y in beyond)]:
        there, push = press(law, place, corner, (x, y, height))
        assert there == pytest.approx(energy, rel=1e-7)
        np.testing.assert_allclose(push.sum(axis=0), force.sum(axis=0), atol=1e-6 * np.linalg.norm(force.sum(axis=0)))


@pytest.mark.parametrize("law", EVERY)
def test_sliding_over_rows_of_vertices_is_not_felt(law: Any) -> None:
    """Where a contact at each local minimum of distance jumps by 44 %: the same force at every place."""
    place, corner = flat(9)
    forces = [press(law, place, corner, (x, 0.3 * x, 0.0075))[1].sum(axis=0) for x in np.linspace(-0.01, 0.01, 101)]
    size = -forces[0][2]
    np.testing.assert_allclose(forces, np.broadcast_to([0.0, 0.0, -size], (101, 3)), atol=1e-12 * size)


@pytest.mark.parametrize(("law", "within"), [(Foundation(), 1e-9), (Stiffening(), 1e-6)])
def test_the_force_is_the_gradient(law: Any, within: float) -> None:
    rng = np.random.default_rng(3)
    place, corner = flat(8, size=0.04)
    place[:, 2] = 1e-3 * rng.normal(size=place.shape[0])
    middle, area = np.array([0.001, 0.002, 0.0085]), 1.1 * areas(place, corner)
    way, aside = rng.normal(size=place.shape), rng.normal(size=3)
    _, force = press(law, place, corner, middle, area)

    def energy(h: float) -> float:
        return press(law, place + h * way, corner, middle + h * aside, area)[0]

    h = 1e-6
    slope = (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h))) / (12.0 * h)
    exact = float(force.sum(axis=0) @ aside - (force * way).sum())
    assert abs(slope - exact) <= within * float(np.abs(force * way).sum())


@pytest.mark.parametrize("law", EVERY)
@pytest.mark.parametrize("beside", [0.0, 0.1, 0.3])
def test_what_a_ball_reaches_beside_its_foot_pushes_by_its_own_energy(law: Any, beside: float) -> None:
    """A wall that ends below the middle: at the foot, in the air, a law may be all but singular, which is not felt."""
    place, corner = np.array([[0.0, -0.03, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, -0.05]]), np.array([[0, 1, 2]], np.int32)
    h = 3e-6
    for height in (0.8, 0.9, 0.94):
        above = [press(law, place, corner, (beside * R, 0.001, height * R + n * h)) for n in (-2, -1, 0, 1, 2)]
        energy, force = [one[0] for one in above], above[2][1][:, 2].sum()
        slope = (8.0 * (energy[3] - energy[1]) - (energy[4] - energy[0])) / (12.0 * h)
        assert slope == pytest.approx(force, rel=1e-5)


@pytest.mark.parametrize("law", EVERY)
def test_a_bump_is_felt_alike_on_ever_finer_meshes(law: Any) -> None:
    def pressed(cells: int) -> Float:
        place, corner = flat(cells, size=0.04, uneven=0.2, seed=cells)
        place[:, 2] = -((place[:, 0] - 0.003) ** 2 + place[:, 1] ** 2) / (2.0 * 0.03)
        return -press(law, place, corner, (0.002, 0.001, 0.0086))[1].sum(axis=0)

    finest = pressed(96)
    apart = [np.linalg.norm(pressed(cells) - finest) / np.linalg.norm(finest) for cells in (6, 12, 24)]
    assert apart[2] < 0.03
    assert apart[0] > 3.5 * apart[1] > 3.5**2 * apart[2]  # to second order, as flat triangles are


@pytest.mark.parametrize("law", EVERY)
def test_forces_are_those_of_a_smooth_ball(law: Any) -> None:
    """They turn the skin about the ball's middle as little as a ball without friction can."""
    rng = np.random.default_rng(5)
    place, corner = flat(7, size=0.03)
    place[:, 2] = 5e-4 * rng.normal(size=place.shape[0])
    middle = np.array([0.002, -0.001, 0.008])
    _, force = press(law, place, corner, middle)
    torque = np.cross(place - middle, force).sum(axis=0)
    assert np.linalg.norm(torque) <= 1e-12 * R * np.abs(force).sum()
    assert sqrt(float((force.sum(axis=0) ** 2).sum())) > 0.1


def test_a_stiffening_flat_pushes_more_than_any_device() -> None:
    place, corner = flat(4)
    forces = [-press(Stiffening(), place, corner, (0.0, 0.0, h * R))[1][:, 2].sum() for h in (0.8, 0.6, 0.4, 0.25)]
    assert sorted(forces) == forces
    assert forces[-1] > 4.0 * K * R
