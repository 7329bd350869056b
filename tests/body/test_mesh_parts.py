"""Named parts of a mesh of tetrahedra with a stiffness and a damping of their own."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.sparse.linalg import spsolve
from tests.mechanics.materials import boxes

from cotouch.body import Body, body_from_tetrahedra
from cotouch.errors import BodyError
from cotouch.scenario import Scenario

SHAPE, H = (7, 3, 3), 0.01
SOFT, FIRM, CUT = 1e4, 7e4, 0.02  # the first two of six cubes are soft


def bar(model: str, **options: Any) -> Body:
    points, corners = boxes(SHAPE, H)
    sets = {"soft": np.flatnonzero(points[:, 0] <= CUT + 1e-9), "firm": np.flatnonzero(points[:, 0] >= CUT - 1e-9)}
    parts = {"soft": {"young": SOFT, "rayleigh_stiffness": 1e-3}, "firm": {"young": FIRM}}
    made: dict[str, Any] = {"poisson": 0.0, "rayleigh_stiffness": 3e-3, "parts": parts, "sets": sets, **options}
    return body_from_tetrahedra((points, corners), unit="m", model=model, **made)


def stiffness_along(body: Body, matrix: Any) -> float:
    """Force that pulls the two ends apart by 1 m, its rows as those of linear elasticity [N/m]."""
    dense, x = np.asarray(matrix.todense()), np.zeros(3 * body.nodes)
    ends = (np.isclose(body.rest[:, 0], 0.0), np.isclose(body.rest[:, 0], (SHAPE[0] - 1) * H))
    held = np.zeros((body.nodes, 3), dtype=bool)
    held[ends[0] | ends[1], 0] = True
    held[ends[0], 1:] = True  # without Poisson's ratio a bar does not get thinner
    fixed = held.ravel()
    x[3 * np.flatnonzero(ends[1])] = 1.0
    x[~fixed] = np.linalg.solve(dense[np.ix_(~fixed, ~fixed)], -(dense @ x)[~fixed])
    return float((dense @ x)[3 * np.flatnonzero(ends[1])].sum())


@pytest.mark.parametrize("model", ["elastic", "corotated", "st-venant-kirchhoff"])
def test_two_parts_in_a_row_are_two_springs_in_series(model: str) -> None:
    body, area = bar(model), (2 * H) ** 2
    series = 1.0 / (CUT / (SOFT * area) + 0.04 / (FIRM * area))
    assert stiffness_along(body, body.stiffness) == pytest.approx(series, rel=1e-9)
    # K with β E in place of E.
    dampers = 1.0 / (CUT / (1e-3 * SOFT * area) + 0.04 / (3e-3 * FIRM * area))
    assert stiffness_along(body, body.damping) == pytest.approx(dampers, rel=1e-9)
    if body.material is not None and model != "elastic":
        assert sorted(set(np.asarray(body.material.young).tolist())) == [SOFT, FIRM]
        assert sorted(set(np.asarray(body.material.viscosity).tolist())) == [1e-3, 3e-3]


def test_springs_of_two_parts_are_in_series_as_well() -> None:
    body, area = bar("springs"), (2 * H) ** 2
    x, ends = np.zeros(body.nodes), [np.isclose(body.rest[:, 0], end) for end in (0.0, 6 * H)]
    x[ends[1]] = 1.0
    free = ~(ends[0] | ends[1])
    k = body.stiffness.tocsr()
    x[free] = spsolve(k[free][:, free].tocsc(), -(k @ x)[free])
    assert (k @ x)[ends[1]].sum() == pytest.approx(1.0 / (CUT / (SOFT * area) + 0.04 / (FIRM * area)), rel=1e-9)


def test_one_part_that_is_the_whole_changes_nothing() -> None:
    points, corners = boxes(SHAPE, H)
    sets = {"all": np.arange(points.shape[0])}
    one = body_from_tetrahedra((points, corners), unit="m", young=SOFT, rayleigh_stiffness=1e-3)
    two = body_from_tetrahedra(
        (points, corners), unit="m", sets=sets, parts={"all": {"young": SOFT, "rayleigh_stiffness": 1e-3}}
    )
    for name in ("stiffness", "damping"):
        assert abs(getattr(one, name) - getattr(two, name)).max() <= 1e-12 * abs(getattr(one, name)).max()


@pytest.mark.parametrize(
    ("parts", "said"),
    [
        ({"bone": {"young": 1.0}}, 'parts names "bone"; the sets of arrays are "firm", "line", "soft"'),
        ({"line": {"young": 1.0}}, 'parts names "line", but that set of arrays holds no whole tetrahedron'),
        ({"soft": {"yuong": 1.0}}, 'parts."soft" has "yuong"; it may have young, poisson, rayleigh_stiffness'),
        ({"soft": {"young": -1.0}}, 'parts."soft".young is -1.0; it must be a finite number above 0 Pa'),
        ({"soft": {"poisson": 0.5}}, 'parts."soft".poisson is 0.5; it must be above -1 and below 0.5'),
    ],
)
def test_mistakes_are_sentences(parts: dict[str, Any], said: str) -> None:
    points, _ = boxes(SHAPE, H)
    sets = {"soft": np.flatnonzero(points[:, 0] <= CUT + 1e-9), "firm": np.arange(60), "line": np.arange(2)}
    with pytest.raises(BodyError) as caught:
        bar("elastic", parts=parts, sets=sets)
    assert said in str(caught.value)
    with pytest.raises(
        BodyError, match=r'^parts\."soft"\.poisson is 0\.0; with model "neo-hookean" it must be above 0'
    ):
        bar("neo-hookean", poisson=0.3, parts={"soft": {"poisson": 0.0}})
    with pytest.raises(BodyError, match='model "rigid" has no Young'):
        bar("rigid")


def test_physical_groups_of_a_file_are_parts_of_a_scenario(tmp_path: Path) -> None:
    points, corners = boxes(SHAPE, H)
    nodes = "\n".join(f"{k + 1} {x} {y} {z}" for k, (x, y, z) in enumerate(points))
    group = 1 + (points[corners].mean(axis=1)[:, 0] > CUT)
    inside = "\n".join(
        f"{k + 1} 4 2 {g} {g} {' '.join(str(n + 1) for n in one)}"
        for k, (g, one) in enumerate(zip(group, corners, strict=True))
    )
    path = tmp_path / "bar.msh"
    path.write_text(
        f'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 "soft"\n3 2 "firm"\n$EndPhysicalNames\n'
        f"$Nodes\n{len(points)}\n{nodes}\n$EndNodes\n$Elements\n{len(corners)}\n{inside}\n$EndElements\n"
    )
    made = Scenario.make(
        network={"users": ["Ann"], "spring": [[0]], "delay": [[0]]},
        steps={"duration": 0.1},
        body={
            "file": str(path),
            "unit": "m",
            "poisson": 0.0,
            "young": FIRM,
            "parts": {"soft": {"young": SOFT}},
        },
    )
    body, area = made.build_body(), (2 * H) ** 2
    series = 1.0 / (CUT / (SOFT * area) + 0.04 / (FIRM * area))
    assert stiffness_along(body, body.stiffness) == pytest.approx(series, rel=1e-9)
