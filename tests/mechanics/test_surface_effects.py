"""What a skin does besides pushing: it draws a tool that is near, and a relief on it is felt."""

import warnings
from collections.abc import Callable
from math import pi, sqrt

import numpy as np
import numpy.typing as npt
import pytest
from scipy.special import jv
from tests.mechanics.inside import Foundation
from tests.mechanics.pressing import Pressed, areas, flat, plate

from cotouch.errors import BodyError
from cotouch.mechanics import AWAY, DRIVE, TOUCH_LOSS, TOUCHING, Relief, Stiffening, press_skin, relief_on

Float = npt.NDArray[np.float64]
R, K = 0.01, 1000.0
FORCE, RANGE = 0.5, 0.001
HEIGHT, WAVE = 2e-4, 0.004


def pressed(
    place: Float,
    corner: npt.NDArray[np.int32],
    middle: npt.ArrayLike,
    law: Foundation | Stiffening | None = None,
    area: Float | None = None,
    *,
    relief: Relief | None = None,
    snap: tuple[float, float] = (0.0, 0.0),
) -> tuple[float, Float]:
    return press_skin(
        Foundation() if law is None else law,
        place,
        corner,
        np.array(middle, dtype=np.float64),
        stiffness=K,
        radius=R,
        area=area,
        relief=relief,
        snap=snap,
    )


def ridges(height: float, wave: float = WAVE) -> Callable[[Float, Float], Float]:
    return lambda place, _normal: 0.5 * height * (1.0 + np.sin(2.0 * pi * place[:, 0] / wave))


# -- snap --------------------------------------------------------------------------------------------------------------


def drawn_by_a_flat(height: float) -> float:
    """Closed form of the pull at a height of the ball's middle above its radius: `2 π z σ S(z²)` [N]."""
    half = 0.5 * RANGE * (2.0 * R + RANGE)

    def shape(square: float) -> float:
        beyond = np.clip((square - R * R) / half, 0.0, 2.0)
        return float(1.0 - 0.5 * beyond**2 if beyond < 1.0 else 0.5 * (2.0 - beyond) ** 2)

    z = np.linspace(R, R + RANGE, 20001)
    most = max(x * shape(x * x) for x in z)
    return FORCE * (R + height) * shape((R + height) ** 2) / most


@pytest.mark.parametrize("cells", [1, 4, 23])
def test_a_flat_draws_as_the_closed_form_says(cells: int) -> None:
    skin = flat(cells, seed=cells)
    for height in (1e-6, 0.2 * RANGE, 0.5 * RANGE, 0.9 * RANGE):
        _, force = pressed(*skin, (0.001, 0.002, R + height), snap=(FORCE, RANGE))
        np.testing.assert_allclose(force.sum(axis=0), [0.0, 0.0, drawn_by_a_flat(height)], atol=1e-9 * FORCE)
    energy, force = pressed(*skin, (0.001, 0.002, R + 1.0001 * RANGE), snap=(FORCE, RANGE))
    assert (energy, float(np.abs(force).max())) == (0.0, 0.0)


def test_the_greatest_pull_is_the_pull_off_force() -> None:
    skin, low = flat(4), 0.95 * R
    pulls = [
        pressed(*skin, (0.0, 0.0, z), Stiffening(), snap=(FORCE, RANGE))[1][:, 2].sum()
        for z in np.linspace(low, R + RANGE, 500)
    ]
    assert max(pulls) == pytest.approx(FORCE, rel=1e-4)
    assert np.abs(np.diff(pulls)).max() < 0.02 * FORCE  # no steps


# -- relief ------------------------------------------------------------------------------------------------------------


def test_forces_are_the_gradient_of_the_energy() -> None:
    """Of relief, snap and pressure together, on a skin that is not flat."""
    rng = np.random.default_rng(3)
    rest, corner = flat(8, size=0.04)
    relief = relief_on(rest, corner, ridges(HEIGHT), spacing=WAVE / 8.0, most=10**6)
    place = rest.copy()
    place[:, 2] = 3e-4 * rng.normal(size=place.shape[0])
    middle, area = np.array([0.001, 0.002, 0.0095]), 1.1 * areas(place, corner)
    way, aside = rng.normal(size=place.shape), rng.normal(size=3)

    def at(h: float, **what: object) -> tuple[float, Float]:
        return pressed(place + h * way, corner, middle + h * aside, area=area, **what)  # pyright: ignore[reportArgumentType]

    both = {"relief": relief, "snap": (FORCE, RANGE)}
    h, (_, force), (_, bare) = 1e-7, at(0.0, **both), at(0.0)
    slope = (at(h, **both)[0] - at(-h, **both)[0]) / (2.0 * h)
    size = float(np.abs(force * way).sum())
    assert abs(slope - float(force.sum(axis=0) @ aside - (force * way).sum())) <= 1e-6 * size
    assert np.linalg.norm(force - bare) > 0.1 * np.linalg.norm(bare)


def test_ridges_are_felt_as_the_closed_form_says() -> None:
    """To first order in the height: the energy of the foundation's pressure on `A/2 sin k x`, with Sonine's integrals.

    `E = κ A/2 π/R³ (2 R² a² J2(k a)/k² - 8 a³ J3(k a)/k³) sin k x`, a the radius of the disc that the ball cuts off.
    """
    rest, corner = flat(6, size=0.04)
    high, z, k = 2e-7, 0.985 * R, 2.0 * pi / WAVE
    relief = relief_on(rest, corner, ridges(high), spacing=WAVE / 24.0, most=10**6)
    a = sqrt(R * R - z * z)
    modulus = 0.1 * K / (pi * R * R) / (0.25 * 0.9 * (1.0 - 0.81) ** 2)
    bessel = 2.0 * (R * a / k) ** 2 * jv(2, k * a) - 8.0 * (a / k) ** 3 * jv(3, k * a)
    expected = k * modulus * 0.5 * high * pi / R**3 * bessel
    x = np.arange(16) * WAVE / 16.0
    felt = [-pressed(rest, corner, (at, 0.001, z), relief=relief)[1][:, 0].sum() for at in x]
    wave = 2.0 * np.exp(-1j * k * x) @ felt / 16.0  # of the force on the tool along x: -dE/dx
    assert wave.real == pytest.approx(-expected, rel=0.01)
    assert abs(wave.imag) < 0.01 * abs(expected)
    assert np.abs(np.array(felt) - wave.real * np.cos(k * x)).max() < 0.02 * abs(expected)


@pytest.mark.parametrize("law", [Foundation(), Stiffening()])
def test_a_relief_only_pushes_and_is_as_high_as_it_says(law: Foundation | Stiffening) -> None:
    rest, corner = flat(6, size=0.04)
    relief = relief_on(rest, corner, ridges(HEIGHT), spacing=WAVE / 8.0, most=10**6)
    for height in (-0.03 * R, 0.0, 0.2 * HEIGHT, 0.9 * HEIGHT):
        for x in np.linspace(0.0, WAVE, 9):
            energy, force = pressed(rest, corner, (x, 0.001, R + height), law, relief=relief)
            assert force[:, 2].max() <= 0.0
            assert energy >= 0.0
    assert pressed(rest, corner, (0.25 * WAVE, 0.001, R + 0.9 * HEIGHT), law, relief=relief)[0] > 0.0
    assert pressed(rest, corner, (0.25 * WAVE, 0.001, R + HEIGHT), law, relief=relief)[0] == 0.0
    # All of one height: as a flat that lies higher, but for the law's scale.
    level = relief_on(rest, corner, lambda place, _: np.full(len(place), HEIGHT), spacing=3e-4, most=10**6)
    raised = pressed(rest, corner, (0.0, 0.001, 0.99 * R + HEIGHT), law, relief=level)[1][:, 2].sum()
    assert raised == pytest.approx(pressed(rest, corner, (0.0, 0.001, 0.99 * R), law)[1][:, 2].sum(), rel=0.05)


def test_a_relief_is_felt_without_steps_and_alike_on_finer_points() -> None:
    rest, corner = flat(6, size=0.04)
    fine, coarse = (relief_on(rest, corner, ridges(HEIGHT), spacing=WAVE / n, most=10**6) for n in (32, 8))
    x = np.linspace(0.0, WAVE, 401)
    felt = [
        np.array([pressed(rest, corner, (at, 0.001, 0.985 * R), relief=on)[1][:, [0, 2]].sum(axis=0) for at in x])
        for on in (coarse, fine)
    ]
    size = np.ptp(felt[1], axis=0)
    assert (np.abs(felt[0] - felt[1]).max(axis=0) < 0.03 * size).all()
    steps = [np.abs(np.diff(felt[0][::every], axis=0)).max(axis=0) for every in (1, 2)]
    assert (steps[0] < 0.55 * steps[1]).all()


@pytest.mark.parametrize(("spacing", "count"), [(0.08 * sqrt(2.0) / 800.0001, r"1\.28e\+06"), (1e-300, "countless")])
def test_too_many_points_are_refused(spacing: float, count: str) -> None:
    """With a sentence that says how far apart they may be: as far as it says, there are not too many."""
    skin = flat(1, uneven=0.0)
    words = rf"the relief needs {count} points on this skin; at most 1e\+06 are possible, which are 0\.00016 m apart"
    with pytest.raises(BodyError, match=words):
        relief_on(*skin, ridges(HEIGHT), spacing=spacing, most=10**6)
    assert relief_on(*skin, ridges(HEIGHT), spacing=0.00017, most=10**6).height.size < 10**6


# -- steps -------------------------------------------------------------------------------------------------------------

TOP = 0.01


def lead(copy: Pressed, places: list[tuple[float, float, float, int]], stiffness: float = 3000.0) -> list[Float]:
    """Leads the tool by a stiff hand from place to place in so many steps; the forces on it."""
    forces, at = [], np.array(places[0][:3])
    for *goal, steps in places:
        for n in range(steps):
            start = at + (np.array(goal) - at) * n / steps
            copy.lead(start, at + (np.array(goal) - at) * (n + 1) / steps, stiffness=stiffness)
            copy.step(1e-3)
            forces.append(copy.force)
        at = np.array(goal)
    return forces


def magnetic() -> Pressed:
    copy = plate()
    copy.tools.snap[:], copy.tools.snap_range[:] = FORCE, RANGE
    copy.tools.place[0, 2] = TOP + R + 0.0015
    copy.begin()
    return copy


FAR, NEAR = (0.02, 0.021, TOP + R + 0.0015), (0.02, 0.021, TOP + R - 0.0002)


def test_a_tool_is_drawn_and_leaves_at_the_pull_off_force() -> None:
    """What the skin gave is what it takes back, to rounding; and the skin feels what the tool feels."""
    copy = magnetic()
    forces = lead(copy, [(*FAR, 1), (*NEAR, 300)])
    assert -copy.tools.well[0] > 0.4 * FORCE * RANGE
    assert copy.tools.touching[0] == 1
    forces = np.array(lead(copy, [(*NEAR, 1), (*FAR, 1500)]))
    assert -forces[:, 2].min() == pytest.approx(FORCE, rel=0.002)
    assert copy.tools.stored[0] == copy.tools.owed[0] == 0.0
    assert copy.lost <= 1e-12 * FORCE * RANGE
    assert copy.residual <= 1e-14 * copy.in_play
    held = -(copy.body.stiffness_ext @ copy.copy.position)[:, 2].sum()
    assert abs(held) < 0.01 * FORCE


def test_what_is_drawn_sticks_by_the_pressure_alone() -> None:
    """The skin draws as much as it presses, so nothing holds the tool down, and friction holds it aside."""
    copy = magnetic()
    copy.tools.friction[:] = copy.tools.kinetic[:] = 0.5
    level = (0.02, 0.021, TOP + R - 0.00065)
    lead(copy, [(*FAR, 1), (*level, 100)])
    aside = (0.021, *level[1:])
    lead(copy, [(*level, 300), (*aside, 200), (*aside, 300)], 150.0)
    assert abs(copy.force[2]) < 0.05 * FORCE
    series = 1.0 / (1.0 / 150.0 + 1.0 / 1000.0)  # the springs of hand and friction
    assert copy.force[0] == pytest.approx(-0.001 * series, rel=0.01)
    assert copy.tools.slipping[0] == 0
    assert copy.residual <= 1e-13 * copy.in_play


def test_a_tool_that_is_taken_away_in_range_gives_no_energy() -> None:
    """It owes what would have pulled it off, pays from its motion, and is drawn again only then."""
    copy = magnetic()
    start, farther, wells = copy.energy, (*FAR[:2], FAR[2] + 0.001), []
    for _ in range(3):
        copy.tools.mode[:] = TOUCHING
        lead(copy, [(*farther, 1), (*NEAR, 100)])
        wells.append(-float(copy.tools.well[0]))
        copy.tools.mode[:] = AWAY
        lead(copy, [(*NEAR, 1), (*farther, 100)])
        assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
        assert copy.energy - copy.totals[DRIVE] <= start + 1e-12 * FORCE * RANGE
        assert copy.tools.owed[0] == 0.0
    assert min(wells) > 0.2 * FORCE * RANGE
    assert copy.residual <= 1e-13 * copy.in_play


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_sliding_over_ridges_swings_at_speed_over_wavelength(friction: float) -> None:
    """With friction, the drag's mean is its share of the pressure's: what ridges hold back they give back."""
    copy, speed = plate(), 0.02
    copy.tools.radius[:], copy.tools.friction[:], copy.tools.kinetic[:] = 0.004, friction, friction
    copy.surface = copy.surface._replace(
        relief=relief_on(copy.surface.rest[:, :3], copy.surface.corner, ridges(HEIGHT), spacing=5e-4, most=10**6)
    )
    down = (0.02, 0.0271, TOP + 0.0038)
    lead(copy, [(0.02, 0.0271, TOP + 0.0045, 1), (*down, 100)], 2e4)
    slid = np.array(lead(copy, [(*down, 1), (0.02 + speed, *down[1:], 1000)], 2e4))[201:]
    wave = np.abs(np.fft.rfft(slid - slid.mean(axis=0), axis=0))
    lines = np.fft.rfftfreq(len(slid), 1e-3)[wave.argmax(axis=0)]
    assert lines[0] == lines[2] == pytest.approx(speed / WAVE)
    assert slid[:, 2].min() > 0.0
    assert np.ptp(slid[:, 2]) > 0.1 * slid[:, 2].mean()
    assert -slid[:, 0].mean() == pytest.approx(friction * slid[:, 2].mean(), rel=0.03, abs=0.003 * slid[:, 2].mean())
    assert copy.touch_ledger[TOUCH_LOSS] >= 0.0
    assert copy.residual <= 1e-13 * copy.in_play


def test_a_relief_too_fine_to_count_is_refused_without_a_warning() -> None:
    place = np.eye(3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(BodyError, match="points on this skin"):
            relief_on(place, np.array([[0, 1, 2]]), lambda where, _: where[:, 0], spacing=1e-300, most=2_000_000)
