"""Bodies from files in scenarios: read relative to the scenario, simulated, truncated."""

import re
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest
from scipy.sparse.linalg import spsolve
from tests.body.shapes import block

from cotouch.body import Body
from cotouch.errors import BodyError, InputError, ScenarioError, UnsupportedError
from cotouch.mechanics import model
from cotouch.scenario import FileTable, Scenario
from cotouch.simulation import prepare, run_batch, run_peers, simulate, summary

TOML = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 2], [2, 0]]
delay = [[0, 0.02], [0.01, 0]]
[body]
file = "beam.vtu"
unit = "cm"
young = 2e4
ground = {plane = {point = [0, 0, 0], normal = [1, 0, 0]}}
ground_stiffness = 2e3
rayleigh_mass = 4.0
rayleigh_stiffness = 1e-3
frame = "fixed"
[steps]
duration = 1.0
period = 0.002
[[hands]]
user = 1
at = [0.3, 0.05, 0.1]
kind = "force"
path = [0.0, 0.0, -0.2]
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    points, elements = block((4, 2, 2), (30, 10, 10))
    mark = (points[:, 0] == 0.0).astype(np.int32)
    meshio.Mesh(points, [("tetra", elements)], point_data={"clamp": mark}).write(tmp_path / "beam.vtu")
    (tmp_path / "scenario.toml").write_text(TOML)
    return tmp_path


def changed(folder: Path, **options: Any) -> Scenario:
    scenario = Scenario.read(folder / "scenario.toml")
    return scenario.replace(**{f"body__{name}": value for name, value in options.items()})


def test_a_file_is_relative_to_the_scenario_and_read_once(folder: Path):
    scenario = Scenario.read(folder / "scenario.toml")
    body = scenario.build_body()
    assert body.rest.max() == pytest.approx(0.3)
    assert scenario.build_body() is body
    assert body.origin is not None
    assert body.origin.held.size == 9


def test_every_way_to_say_the_ground_is_the_same(folder: Path):
    ways: list[Any] = [{"set": "clamp"}, {"box": {"low": [-1, -1, -1], "high": [0.01, 1, 1]}}, "x-", list(range(1, 10))]
    held = [changed(folder, ground=way).build_body().stiffness_ext for way in ways]
    assert all(abs(one - held[0]).max() == 0.0 for one in held)


def test_a_run_balances_and_a_hand_holds_the_nearest_node(folder: Path):
    scenario = Scenario.read(folder / "scenario.toml")
    run = simulate(scenario)
    assert run.attrs["energy_residual"] < 1e-10
    assert run.sizes["node"] == 45
    ready = prepare(scenario)
    node = ready.scenario.hands[0].node
    assert np.allclose(ready.body.rest[node - 1], [0.3, 0.05, 0.1])
    assert ready.body is scenario.build_body()
    assert summary(run, scenario.build_body())["energy_residual"] < 1e-10


class TestTruncated:
    def settled(self, scenario: Scenario) -> np.ndarray:
        """Where the tip comes to rest under the force, both users pushing alike so that the links carry nothing."""
        hands = [scenario.hands[0], scenario.hands[0].model_copy(update={"user": 2})]
        run = simulate(scenario.replace(steps__duration=8.0, record__every=100, hands=hands))
        assert run.attrs["energy_residual"] < 1e-10
        node = int(run["node"].values.tolist().index(scenario.placed().hands[0].node))
        return run["position"].values[0, -1, node]

    def test_comes_to_rest_where_the_whole_body_does(self, folder: Path):
        """Six modes bend too little under a point force; with the residual the tip is right."""
        whole = changed(folder, frame="fixed")
        start = whole.build_body().rest[whole.placed().hands[0].node - 1]
        exact = self.settled(whole) - start
        kept = self.settled(changed(folder, modes=6)) - start
        body, node = whole.build_body(), whole.placed().hands[0].node - 1
        load = np.zeros((body.nodes, 3))
        load[node, 2] = -0.2
        rest = spsolve(body.stiffness.tocsc() / 2, load.ravel()).reshape(-1, 3)[node]  # each copy is half of the body
        assert np.linalg.norm(exact - rest) < 1e-3 * np.linalg.norm(rest)
        assert np.linalg.norm(kept - exact) < 1e-3 * np.linalg.norm(exact)
        alone = body.truncated(modes=6).truncation
        assert alone is not None
        missing = body.truncated(modes=6, contacts=[node]).truncation
        assert missing is not None
        assert missing.error < 1e-9 < 0.01 < missing.error_without

    def test_one_peer_and_many_agree(self, folder: Path):
        ready = prepare(changed(folder, modes=6))
        assert ready.model.basis == "modal"
        assert ready.model.operator_rows == 9
        together, alone = run_batch(ready), run_peers(ready)
        for user in range(2):
            assert np.array_equal(alone.position[user][-1], together.position[user])

    def test_all_modes_are_the_body_itself(self):
        """With equal masses the mass-weighted links are the identity, and nothing is left out."""
        tables: dict[str, Any] = {
            "network": {"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.01], [0.01, 0]]},
            "steps": {"duration": 0.5, "period": 0.001},
            "synchronisation": {"law": "spring"},
            "hands": [{"user": 1, "node": 3, "path": 0.1}],
        }
        from cotouch.body import chain

        body = chain(6, mass=0.5, stiffness=80.0, damping=0.2, ground="x-", ground_stiffness=30.0)
        commuting = Body(
            mass=body.mass,
            rest=body.rest,
            stiffness_int=body.stiffness_int,
            stiffness_ext=body.stiffness_ext,
            damping_int=0.01 * body.stiffness_int,
            damping_ext=0.01 * body.stiffness_ext,
        )
        whole = simulate(Scenario.make(body=commuting, solver={"basis": "nodal", "tolerance": 1e-13}, **tables))
        cut = simulate(Scenario.make(body=commuting.truncated(modes=6, contacts=[2]), **tables))
        assert np.allclose(whole["position"], cut["position"], rtol=0.0, atol=1e-10)
        assert np.allclose(whole["stored"], cut["stored"], rtol=1e-8, atol=1e-12)

    def test_projection_and_back(self, folder: Path):
        body = changed(folder).build_body().truncated(modes=5, contacts=[7])
        ready = model(body, copies=2)
        assert ready.modes is not None
        rows = np.random.default_rng(0).normal(size=(ready.operator_rows, 1))
        assert np.allclose(ready.to_rows(ready.to_nodes(rows)), rows, atol=1e-9)

    def test_what_it_cannot_do(self, folder: Path):
        body = changed(folder).build_body().truncated(modes=5)
        with pytest.raises(UnsupportedError, match='basis is "nodal", but the body is truncated to a few shapes'):
            model(body, basis="nodal")
        with pytest.raises(UnsupportedError, match="the links have weights of their own, but the body is truncated"):
            model(body, weights=[np.eye(3)])


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("young = -1.0", "body.young is -1.0; it must be greater than 0"),
        ("unit = 'km'", "body.unit is 'km'; it must be 'm', 'mm', 'cm' or 'in'"),
        ("resolution = 5", 'resolution is for surfaces, but file is "'),
        ("colour = 3", "body.colour is not an option that cotouch knows"),
        (
            "ground = {plane = {point = [0, 0], normal = [0, 0, 1]}}",
            "body.ground.plane.point is [0, 0]; it must have at least 3 entries",
        ),
        ("ground = {}", "body.ground: it must have exactly one of plane, box and set"),
        ("ground = 3", "body.ground is 3; it must be a string"),
        ("ground = {set = 'foot'}", 'the ground is the set "foot"; the sets of this mesh are: "clamp"'),
        ("file = 'beam.docx'", 'beam.docx"; it must end in .stl, .obj'),
        ("file = 'gone.vtu'", "gone.vtu cannot be read: No such file"),
        ("file = 3", "body.file is 3; it must be a string"),
        (
            "kind = 'jelly'",
            'body.kind is \'jelly\'; it must be "point", "chain", "lattice", "box", "cylinder", "sphere", '
            '"matrices" or "file"',
        ),
        ("modes = 200", "modes is 200; it must be from 1 to 135"),
    ],
)
def test_what_is_wrong_is_one_sentence(folder: Path, line: str, message: str):
    name = line.split(" = ", maxsplit=1)[0]
    lines = [entry for entry in TOML.splitlines() if not (entry.startswith(f"{name} = "))]
    lines.insert(lines.index("[body]") + 1, line)
    (folder / "wrong.toml").write_text("\n".join(lines))
    with pytest.raises(InputError, match=re.escape(message)) as caught:
        prepare(Scenario.read(folder / "wrong.toml"))
    assert "\n" not in str(caught.value)


def test_a_body_that_is_a_list_is_one_sentence(folder: Path):
    (folder / "wrong.toml").write_text(TOML.replace("[body]", "[[body]]"))
    message = "body is a list; it must be one table, [body]; several bodies are [[bodies]]"
    with pytest.raises(InputError, match=re.escape(message)):
        Scenario.read(folder / "wrong.toml")


@pytest.mark.parametrize(
    ("hand", "message"),
    [
        ({"at": [0.1, 0.2], "user": 1}, "hands[1].at is [0.1, 0.2]; it must be 3 coordinates [m]"),
        ({"at": [0.1, 0.2, 0.3], "node": 4, "user": 1}, "node and at are given; give only one of them"),
        ({"node": 99, "user": 1}, "hands[1].node is 99; the body has nodes 1 to 45"),
    ],
)
def test_hands(folder: Path, hand: dict[str, Any], message: str):
    with pytest.raises(ScenarioError, match=re.escape(message)):
        prepare(changed(folder, modes=8).replace(hands=[{"path": [0.0, 0.0, 0.0], **hand}]))


def test_a_unit_is_asked_for():
    with pytest.raises(BodyError, match=r"the unit of a\.stl is not given"):
        FileTable.make(source="x", file="a.stl").build()


def test_the_example_runs(tmp_path: Path):
    """Three users hold a liver: read, truncated, simulated, with a balanced ledger."""
    from examples.make_shapes import main

    main(tmp_path / "shapes")
    text = (Path(__file__).parents[2] / "examples" / "liver.toml").read_text(encoding="utf-8")
    (tmp_path / "liver.toml").write_text(text, encoding="utf-8")
    scenario = Scenario.read(tmp_path / "liver.toml").replace(steps__duration=0.3)
    run = simulate(scenario)
    assert run.attrs["energy_residual"] < 1e-10
    assert run.attrs["passivity_margin"] > -1e-10
    body = scenario.build_body()
    assert body.truncation is not None
    assert (body.truncation.modes, body.truncation.shapes.shape[1]) == (40, 46)
    assert body.truncation.error < 1e-9 < 0.3 < body.truncation.error_without
