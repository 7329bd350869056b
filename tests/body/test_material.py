"""Materials: what builders make of them, and what they refuse."""

from typing import Any

import numpy as np
import pytest
from tests.body.shapes import box
from tests.mechanics.materials import Alone, boxes, energy_at, rotation

from cotouch.body import Body, Material, body_from_surface, body_from_tetrahedra, lattice
from cotouch.errors import BodyError, UnsupportedError

TETRAHEDRON = [[0.0, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"model": "jelly"}, 'model is "jelly"; it must be one of linear, floating'),
        ({"viscosity": -1.0}, "viscosity is -1.0; it must be a finite number of at least 0 s"),
        ({"gravity": (0.0, np.nan, 0.0)}, "it must be three finite numbers"),
        ({"elements": np.array([[0, 1, 2]])}, 'elements is 1 x 3; model "corotated" needs rows of 4 nodes'),
        ({"elements": np.array([[0, 1, 2, 4]])}, "elements names node index 4; this body has nodes 0 to 3"),
        ({"elements": np.array([[0, 2, 1, 3]])}, "tetrahedron 1 is turned inside out (volume -0.000167 m³)"),
        ({"poisson": 0.5}, "poisson is 0.5"),
        ({"model": "neo-hookean", "poisson": 0.0}, 'with model "neo-hookean" it must be above 0 and below 0.5'),
        ({"young": 0.0}, "young is 0.0; it must be more than 0 Pa"),
        ({"model": "spring-network", "elements": np.array([[0, 1]]), "stiffness": np.array([-1.0])}, "stiffness holds"),
    ],
)
def test_a_wrong_material_is_one_sentence(options: dict[str, Any], message: str) -> None:
    made = {"model": "corotated", "elements": np.array([[0, 1, 2, 3]]), "young": 1e4, "poisson": 0.3, **options}
    with pytest.raises(BodyError) as caught:
        Body(mass=np.eye(4), rest=TETRAHEDRON, material=Material(**made))
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_tetrahedra_of_either_turn_are_taken() -> None:
    points, elements = boxes((2, 2, 2))
    body = body_from_tetrahedra((points, elements), unit="m", model="neo-hookean", rayleigh_stiffness=1e-3)
    material = body.material
    assert material is not None
    assert material.viscosity == 1e-3
    edges = body.rest[material.elements[:, 1:]] - body.rest[material.elements[:, :1]]
    assert np.linalg.det(edges).sum() / 6.0 == pytest.approx(1e-6)
    assert body.form == "full"  # K is that of linear elasticity


@pytest.mark.parametrize("model", ["cells", "spring-network"])
def test_a_stretched_bar_has_the_stiffness_that_was_asked_for(model: Any) -> None:
    bar = body_from_surface(box((0.08, 0.02, 0.02)), unit="m", resolution=8, model=model, young=1e4)
    material = bar.material
    assert material is not None
    assert material.model == model
    strain = 1e-3
    stretched = np.stack([strain * bar.rest[:, 0], *(np.zeros(bar.nodes),) * 2], axis=1)
    energy = 0.5 * float((stretched * (bar.stiffness @ stretched)).sum())
    # Held sideways: a lattice of edges has E, one with diagonals (as scalar springs) k (1 + 4) / h = 5 · 0.4 E.
    expected = 0.5 * 1e4 * (1.0 if model == "cells" else 2.0) * strain**2 * 0.08 * 0.02 * 0.02
    assert energy == pytest.approx(expected, rel=1e-9)


def test_a_network_of_cells_is_isotropic() -> None:
    """Its springs resist stretch along an edge and along a diagonal with C11, C12, C44 of λ = μ."""
    bar = body_from_surface(box((0.04, 0.04, 0.04)), unit="m", resolution=4, model="spring-network", young=1e4)
    material = bar.material
    assert material is not None
    edge = bar.rest[material.elements[:, 1]] - bar.rest[material.elements[:, 0]]
    unit = edge / np.linalg.norm(edge, axis=1)[:, None]

    def density(strain: Any) -> float:
        stretch = np.einsum("ei,ij,ej->e", unit, np.array(strain), edge)
        return float(0.5 * (material.stiffness * stretch**2).sum()) / 0.04**3

    modulus = 0.4e4  # λ = μ = k / h
    assert density(np.diag([1.0, 0.0, 0.0])) == pytest.approx(1.5 * modulus)  # ½ (λ + 2 μ)
    assert density(np.eye(3)) == pytest.approx(7.5 * modulus)  # ½ (9 λ + 6 μ)
    assert density([[0.0, 0.5, 0.0], [0.5, 0.0, 0.0], [0.0, 0.0, 0.0]]) == pytest.approx(0.5 * modulus)  # ½ μ


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"model": "spring-network"}, 'stiffness is not given; model "spring-network" of tetrahedra needs that'),
        ({"model": "cells"}, 'model is "cells"; it must be one of springs, elastic, spring-network'),
        ({"model": "corotated", "stiffness": 5.0}, 'stiffness is 5.0, but model is "corotated"'),
        ({"model": "corotated", "frame": "floating"}, 'frame is "floating", but model "corotated" turns by itself'),
        ({"frame": "loose"}, 'frame is "loose"; it must be "fixed" or "floating"'),
    ],
)
def test_a_builder_refuses(options: dict[str, Any], message: str) -> None:
    with pytest.raises(BodyError) as caught:
        body_from_tetrahedra(boxes((2, 2, 2)), unit="m", **options)
    assert message in str(caught.value)


def test_a_material_has_no_modes() -> None:
    with pytest.raises(UnsupportedError, match="only a linear body has modes"):
        lattice((3, 3, 3), frame="floating").truncated(modes=8)


@pytest.mark.parametrize("build", ["surface", "tetrahedra"])
def test_a_mesh_turns_unless_it_is_told_not_to(build: str) -> None:
    """By 90° it costs nothing; fixed in its frame, or confined to modes, it is the linear body."""

    def made(**options: Any) -> Body:
        if build == "surface":
            return body_from_surface(box((0.04, 0.02, 0.02)), unit="m", resolution=4, **options)
        return body_from_tetrahedra(boxes((3, 2, 2)), unit="m", **options)

    turning, fixed = made(), made(frame="fixed")
    assert turning.material is not None
    assert turning.material.model == "floating"
    assert fixed.material is turning.linearised.material is None
    assert (turning.stiffness != fixed.stiffness).nnz == 0
    copy = Alone(turning)
    about = turning.rest - turning.rest.mean(axis=0)
    turned = copy.rows(about @ rotation((0.0, 0.0, 1.0), 0.5 * np.pi).T - about)
    still = np.zeros_like(turned)
    energy, _ = energy_at(copy.force, copy.model.unturned(), turned, turned, still, 60, copy.model.lanes)
    linear = 0.5 * float((turned[:, :3] * turning.apply(turning.stiffness, turned[:, :3])).sum())
    assert energy <= 1e-12 * linear
    assert turning.truncated(modes=8).truncation is not None
    with pytest.raises(BodyError, match='frame is "floating", but model "spring-network" turns by itself'):
        made(model="spring-network", stiffness=10.0, frame="floating")


def test_a_linear_body_without_weight_has_no_material() -> None:
    assert lattice((3, 3, 3)).material is None
    heavy = lattice((3, 3, 3)).with_gravity((0.0, 0.0, -9.81)).material
    assert heavy is not None
    assert (heavy.model, heavy.gravity) == ("linear", (0.0, 0.0, -9.81))
