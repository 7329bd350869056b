"""The command as a user runs it: a process of its own."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from tests.cli.commands import FIVE_USERS, cotouch, here

from cotouch.errors import ScenarioError
from cotouch.scenario import Scenario

SMALL = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.05], [0.02, 0]]
[steps]
duration = 0.5
[[hands]]
user = 1
path = 0.1
"""


@pytest.fixture
def small(tmp_path: Path) -> Path:
    path = tmp_path / "small.toml"
    path.write_text(SMALL)
    return path


def test_help_names_every_command_and_loads_nothing_heavy() -> None:
    done = cotouch("--help")
    assert done.returncode == 0
    for command in ("simulate", "certify", "plan", "body", "reproduce", "replay", "audit", "export"):
        assert command in done.stdout
    heavy = "('numba', 'numpy', 'xarray', 'pydantic', 'rich', 'trimesh', 'meshio', 'skfem')"
    code = f"import sys, cotouch.cli; print([name for name in {heavy} if name in sys.modules])"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert loaded.stdout.strip() == "[]"


def test_simulate_prints_one_json_object_and_nothing_else() -> None:
    done = cotouch("simulate", FIVE_USERS, "--json")
    assert done.returncode == 0, done.stderr
    figures = json.loads(done.stdout)
    assert figures["steps"] == 24_000
    assert figures["duration_s"] == 24.0
    assert figures["energy_residual"] < 1e-10
    assert figures["passivity_margin_j"] >= -1e-12
    assert set(figures["settling_time_s"]) == {"position", "force"}
    assert 1.0 < figures["settling_time_s"]["position"] < 6.0
    assert len(figures["final"]["position"]) == 5
    assert len(figures["final"]["force"]) == 5
    assert figures["final"]["force_sum"] == 0.0
    assert abs(figures["hold"]["force_sum"]) < 1e-4


def test_simulate_writes_result_and_figures(small: Path, tmp_path: Path) -> None:
    done = here("simulate", small, "--out", tmp_path / "run.nc", "--figures", tmp_path / "figures")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "run.nc").read_bytes()[1:4] == b"HDF"
    names = {path.stem for path in (tmp_path / "figures").iterdir()}
    assert {"positions", "forces", "energies", "ages"} <= names
    for word in ("Ann", "Ben", "residual", "passive", "run.nc"):
        assert word in done.stdout


def test_simulate_says_what_tools_felt_and_writes_an_animation(tmp_path: Path) -> None:
    scenario = FIVE_USERS.parent / "squeeze.toml"
    page = tmp_path / "squeeze.html"
    done = cotouch("simulate", scenario, "--animation", page)
    assert done.returncode == 0, done.stderr
    for word in ("touch, omega 1000 Hz", "touch, delta 1000 Hz", "devices", "passive: gave at most", "squeeze.html"):
        assert word in done.stdout
    assert page.read_text(encoding="utf-8").startswith("<!")
    done = cotouch("simulate", scenario, "--json", "--animation", page)
    found = json.loads(done.stdout)
    assert found["files"] == [str(page)]
    assert [tool["user"] for tool in found["tools"]] == [1, 2]
    assert all(tool["coupling"]["passive"] for tool in found["tools"])
    assert found["device_residual"] < 1e-10


def test_certify_designs_and_checks() -> None:
    done = here("certify", FIVE_USERS, "--json")
    assert done.returncode == 0, done.stderr
    found = {(entry["basis"], entry["method"]): entry for entry in json.loads(done.stdout)["certificates"]}
    rule = found["index", "rule"]
    assert rule["damping"] == pytest.approx([36.5, 9.0, 3.625, 41.25, 3.375])
    assert found["index", "minimax"]["largest"] < rule["largest"]
    assert found["index", "exact"]["sum"] < rule["sum"]
    assert found["index", "exact"]["modes"] == ["constant"]
    assert "freshest" in found["age", "rule"]["modes"]
    assert all(entry["holds"] for entry in found.values())
    checked = here("certify", FIVE_USERS, "--json", "--damping", "20")
    assert not any(entry["holds"] for entry in json.loads(checked.stdout)["certificates"])
    table = here("certify", FIVE_USERS)
    assert "minimax" in table.stdout
    assert "36.5" in table.stdout
    assert "This is for links of law spring" in table.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("simulate", "nowhere.toml"), "nowhere.toml"),
        (("certify", "nowhere.toml"), "nowhere.toml"),
        (("certify", FIVE_USERS, "--damping", "1,2"), "one for each of the 5 users"),
        (("certify", FIVE_USERS, "--period", "-1"), "period"),
        (("simulate", FIVE_USERS, "--out", "/nowhere/run.nc"), "does not exist"),
        (("simulate", FIVE_USERS, "--animation", "/nowhere/run.html"), "does not exist"),
        (("simulate",), "Missing argument"),
        (("fly",), "fly"),
    ],
)
def test_what_the_user_got_wrong_is_said_with_exit_code_2(arguments: tuple[str | Path, ...], words: str) -> None:
    done = here(*arguments)
    assert done.returncode == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert not done.stdout


def test_a_bad_scenario_is_one_sentence(small: Path) -> None:
    small.write_text(SMALL + "\n[steps2]\n")
    done = here("simulate", small)
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "steps2" in done.stderr


@pytest.fixture(scope="module")
def shapes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example shapes, as the script makes them."""
    folder = tmp_path_factory.mktemp("shapes")
    script = Path(__file__).parents[2] / "examples" / "make_shapes.py"
    subprocess.run([sys.executable, str(script), str(folder)], check=True, capture_output=True, timeout=120)
    return folder


def test_body_says_what_it_understood(shapes: Path, tmp_path: Path) -> None:
    done = here("body", shapes / "gear.stl", "--unit", "mm", "--ground", "z-", "--figures", tmp_path / "new")
    assert done.returncode == 0, done.stderr
    for word in ("gear.stl", "0.07678 × 0.07678 × 0.012 m", "0.03951 kg", "ground at", "Hz", "body.png"):
        assert word in done.stdout
    assert [path.name for path in (tmp_path / "new").iterdir()] == ["body.png"]
    assert (tmp_path / "new" / "body.png").read_bytes()[:4] == b"\x89PNG"


def test_body_in_numbers(shapes: Path) -> None:
    options = ["--unit", "m", "--ground", "set:clamp", "--ground-stiffness", "1e6", "--young", "1e6", "--modes", "10"]
    done = here("body", shapes / "beam.vtu", *options, "--json")
    assert done.returncode == 0, done.stderr
    numbers = json.loads(done.stdout)
    assert (numbers["nodes"], numbers["elements"], numbers["held_nodes"]) == (425, 1536, 25)
    assert numbers["mass_kg"] == pytest.approx(0.32)
    assert numbers["free_rigid_motions"] == 0
    assert numbers["notes"] == []
    # Euler and Bernoulli's cantilever: 5.22 Hz; linear tetrahedra are too stiff, shear makes it softer.
    assert numbers["frequencies_hz"][0] == pytest.approx(5.22, rel=0.15)
    assert len(numbers["frequencies_hz"]) == 6
    assert (
        numbers["truncation"]["compliance_error"]
        < 1e-9
        < 0.1
        < numbers["truncation"]["compliance_error_without_residual"]
    )


def test_body_lists_those_of_a_scenario() -> None:
    tower = Path(__file__).parents[2] / "examples" / "tower.toml"
    told = json.loads(here("body", tower, "--json").stdout)
    assert [one["name"] for one in told["bodies"]] == [f"block {k + 1}" for k in range(5)]
    assert told["nodes"] == 20
    assert told["bodies"][4]["middle_m"] == pytest.approx([0.0, 0.0, 0.225])
    assert told["bodies"][4]["size_m"] == pytest.approx([0.05] * 3)
    assert told["bodies"][4]["mass_kg"] == pytest.approx(0.1)
    table = here("body", tower)
    assert "tower.toml: 5 bodies, 20 nodes" in table.stdout
    refused = here("body", tower, "--young", "3")
    assert refused.returncode == 2
    assert "--young is 3.0, but" in refused.stderr


def test_body_says_what_was_repaired(shapes: Path, tmp_path: Path) -> None:
    """Nine of ten triangles of a face, half of them turned round: mended, and said."""
    content = bytearray((shapes / "kidney.stl").read_bytes())
    count = int.from_bytes(content[80:84], "little")
    for k in range(0, count, 3):
        at = 84 + 50 * k + 12
        content[at : at + 24] = content[at + 12 : at + 24] + content[at : at + 12]
    content[80:84] = (count - 1).to_bytes(4, "little")
    (tmp_path / "bad.stl").write_bytes(content[:-50])
    done = here("body", tmp_path / "bad.stl", "--unit", "mm", "--json")
    assert done.returncode == 0, done.stderr
    notes = json.loads(done.stdout)["notes"]
    assert notes[0].startswith("1 hole filled")
    assert "flipped" in notes[1]
    assert "Nothing holds it" in notes[-1]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["liver.stl"], "the unit of "),
        (["liver.stl", "--unit", "km"], "unit is 'km'"),
        (["liver.stl", "--unit", "mm", "--young", "0"], "young is 0.0"),
        (["liver.stl", "--unit", "mm", "--most", "1000"], "triangles but the limit is 1000"),
        (["beam.vtu", "--unit", "m", "--most", "1000"], "has 1536 elements but the limit is 1000"),
        (["beam.vtu", "--unit", "m", "--resolution", "9"], "resolution is for surfaces"),
        (["beam.vtu", "--unit", "m", "--ground", "set:foot"], 'the sets of this mesh are: "clamp"'),
        (["beam.vtu", "--unit", "m", "--ground", "plane:1,2"], '--ground is "plane:1,2"; it must be none, all'),
        (["beam.vtu", "--unit", "m", "--ground", "box:9,9,9/10,10,10"], "the ground's box holds no node"),
        (["beam.vtu", "--unit", "m", "--ground", "plane:9,0,0/1,0,0/0.1"], "the plane holds no node"),
        (["nothing.stl", "--unit", "m"], "cannot be read: No such file"),
        (["text.stl", "--unit", "m"], "cannot be read as STL: it contains no mesh"),
        (["text.vtk", "--unit", "m"], "cannot be read as VTK: "),
        (["text.docx", "--unit", "m"], "it must end in .stl"),
    ],
)
def test_body_refuses_with_one_sentence_and_leaves_nothing(
    shapes: Path, tmp_path: Path, options: list[str], message: str
) -> None:
    for suffix in ("stl", "vtk", "docx"):
        (tmp_path / f"text.{suffix}").write_text("no mesh\n")
    name, *rest = options
    path = tmp_path / name if name.startswith(("text", "nothing")) else shapes / name
    done = here("body", path, *rest, "--figures", tmp_path / "figures")
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    assert message in done.stderr
    assert not (tmp_path / "figures").exists()


def test_simulate_says_who_steps_more_slowly_than_asked(tmp_path: Path) -> None:
    path = tmp_path / "rates.toml"
    tables = (
        '[network]\nusers = ["a", "b"]\nspring = [[0, 50], [50, 0]]\ndelay = [[0, 0.03], [0.03, 0]]\n'
        "[steps]\nduration = 1.0\nrate = [1000, 100]\n[synchronisation]\n"
    )
    path.write_text(tables + 'mode = "self-paced"\n', encoding="utf-8")
    said = " ".join(here("simulate", path).stdout.split())
    assert "user 1 takes 100 steps a second instead of 1000, because it waits for the others" in said, said
    found = json.loads(here("simulate", path, "--json").stdout)
    assert found["rate_hz"]["asked"] == pytest.approx([1000.0, 100.0])
    assert found["rate_hz"]["taken"][1] == pytest.approx(100.0, rel=0.05)
    assert found["behind_s"][0] > found["behind_s"][1] == 0.0

    path.write_text(tables, encoding="utf-8")
    assert "instead of" not in here("simulate", path).stdout

    path.write_text(tables + 'mode = "constant"\n', encoding="utf-8")
    with pytest.raises(ScenarioError, match=r'steps\.rate is \[1000\.0, 100\.0\], but in mode "constant"'):
        Scenario.read(path)
