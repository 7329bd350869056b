"""Imports point down; nothing below the worlds reads a clock or draws ambient entropy; nothing warns."""

import ast
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest
from importlinter.cli import lint_imports
from tests.architecture.modules import NAMES, PACKAGE, ROOMS, ROOT, loaded, parsed

# Rooms that may know the outside world (two only its files), and the package itself, which only forwards names.
WORLDS = tuple(
    f"cotouch.{room}"
    for room in (
        "simulation",
        "planning",
        "study",
        "laboratory",
        "session",
        "observers",
        "samples",
        "control",
        "traversal",
        "recording",
        "mailbox",
        "interrupt",
        "compiled",  # waits for other processes that compile the same, which nothing that is computed depends on
        "translation",  # numbers functions as no other process does, likewise
        "pacing",
        "processes",
        "files",
        "meshfile",
        "haptics",
        "drivers",
        "web",
        "cli",
        "__main__",
    )
)
AMBIENT = {"time", "random", "secrets", "datetime", "asyncio", "socket", "threading", "os", "uuid"}
PURE = [room for room in ROOMS if not room.startswith(WORLDS)]


# Who tests a room from outside with what it does not show: what a liar says, mostly.
INSIDERS = {
    "test_compiled.py": {"coupling"},
    "test_document_blocks.py": {"mechanics"},
    "mechanics/test_cut_skin.py": {"recording"},
    "planning/test_task.py": {"network"},
    "drivers/test_coming_back.py": {"haptics"},
    "drivers/test_processes.py": {"haptics"},
    "session/test_cuts.py": {"members"},
}


@cache
def imports_of_test(path: Path) -> list[ast.AST]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return [node for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]


def private_imports(nodes: Iterable[ast.AST]) -> Iterator[tuple[str, str, str]]:
    """Room, module and name of everything that is imported from a room other than by what it shows."""
    for node in nodes:
        entries: list[tuple[str, str]] = []
        if isinstance(node, ast.Import):
            entries = [(alias.name, "") for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            entries = [(node.module, alias.name) for alias in node.names]
        for module, name in entries:
            package, _, rest = module.partition(".")
            room = rest.partition(".")[0]
            hidden = f"{rest}.{name}".removesuffix(".").split(".")[1:]
            if package == "cotouch" and room and any(part.startswith("_") and part != "__version__" for part in hidden):
                yield room, module, name


def of_other_tests(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """Rooms whose tests' `inside.py` is imported, which hands on what is private there."""
    for node in nodes:
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            package, _, rest = node.module.partition(".")
            if package == "tests" and rest.endswith(".inside"):
                yield rest.removesuffix(".inside")


def exists(layer: str) -> bool:
    path = PACKAGE.joinpath(*layer.split(".")[1:])
    return (path / "__init__.py").exists() or path.with_suffix(".py").exists()


def test_floors_hold(tmp_path: Path, capsys: pytest.CaptureFixture[str]):
    """The contracts of pyproject.toml, for all rooms that are built."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    lines = ["[importlinter]", "root_package = cotouch", "include_external_packages = True"]
    for index, contract in enumerate(settings["contracts"]):
        lines += [f"[importlinter:contract:{index}]", f"name = {contract['name']}", f"type = {contract['type']}"]
        for key, value in contract.items():
            if key == "layers":
                rows = [" | ".join(part for part in row.split(" | ") if exists(part)) for row in value]
                lines += ["layers ="] + [f"    {row}" for row in rows if row]
            elif key == "source_modules":
                lines += [f"{key} ="] + [f"    {name}" for name in value if exists(name)]
            elif isinstance(value, list):
                lines += [f"{key} ="] + [f"    {entry}" for entry in value]
            elif key not in {"name", "type"}:
                lines.append(f"{key} = {value}")
    config = tmp_path / "contracts.ini"
    config.write_text("\n".join(lines), encoding="utf-8")
    code = lint_imports(config_filename=str(config), no_cache=True)
    report = capsys.readouterr().out
    assert code == 0, report
    assert f"{len(settings['contracts'])} kept, 0 broken" in report


def test_every_room_has_a_floor():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    floors = next(contract for contract in settings["contracts"] if contract["type"] == "layers")
    placed = {part for row in floors["layers"] for part in row.split(" | ")}
    rooms = {name for name in NAMES if name.count(".") == 1}
    assert rooms <= placed


@pytest.mark.parametrize("room", PURE)
def test_no_clock_entropy_or_environment_below_the_worlds(room: str):
    """Also inside functions, where the linter's graph may not look for external modules."""
    for name, node in ((module, node) for module in ROOMS[room] for node in ast.walk(parsed(module))):
        if isinstance(node, ast.Import):
            assert not {alias.name.split(".")[0] for alias in node.names} & AMBIENT, name
        elif isinstance(node, ast.ImportFrom):
            assert (node.module or "").split(".")[0] not in AMBIENT, name
            assert node.level == 0, name
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Attribute) and node.value.attr == "random":
            # np.random.rand and its kind draw from a hidden state; generators handed in, or made of a seed, are fine.
            assert node.attr in {"Generator", "SeedSequence", "BitGenerator", "default_rng"}, name
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "default_rng":
            assert node.args, name


@pytest.mark.parametrize("room", ROOMS)
def test_no_room_reaches_into_another(room: str) -> None:
    """Nor does a room's own list of names forward what is private elsewhere."""
    found = [(name, *entry) for name in ROOMS[room] for entry in private_imports(ast.walk(parsed(name)))]
    assert [entry for entry in found if f"cotouch.{entry[1]}" != room] == []


def test_tests_see_of_other_rooms_what_they_show() -> None:
    insiders: dict[str, set[str]] = {}
    needless: list[tuple[str, str, str]] = []
    for path in sorted((ROOT / "tests").rglob("*.py")):
        place, nodes = path.relative_to(ROOT / "tests"), imports_of_test(path)
        for room in of_other_tests(nodes):
            if place.parts[0] != room:
                insiders.setdefault(place.as_posix(), set()).add(room)
        for room, module, entry in private_imports(nodes):
            if place.parts[0] != room:
                insiders.setdefault(place.as_posix(), set()).add(room)
            if not entry.startswith("_") and module.count(".") > 1 and entry in loaded(f"cotouch.{room}").__all__:
                needless.append((place.as_posix(), module, entry))
    assert insiders == INSIDERS, "a test imports what another room does not show; or less than is listed here does"
    assert needless == [], "the room itself shows this"


def test_every_room_has_tests_of_its_name() -> None:
    """One goes from a room to its tests without looking; those of `live` and `architecture` are of several rooms."""
    tests = {path.relative_to(ROOT / "tests").parts[0] for path in (ROOT / "tests").rglob("test_*.py")}
    rooms = {name.removeprefix("cotouch.") for name in ROOMS if name != "cotouch"}
    modules = {room for room in rooms if (PACKAGE / f"{room}.py").exists()}
    assert sorted(rooms - modules - tests) == []
    folders = {name for name in tests if not name.endswith(".py")}
    assert sorted(folders - rooms) == ["architecture", "live"]


def test_one_file_of_a_rooms_tests_imports_what_is_private_there() -> None:
    """So one sees at once how much of the inside is tested, and whoever renames some of it edits one list."""
    found: dict[str, set[str]] = {}
    for path in (ROOT / "tests").rglob("*.py"):
        if any(private_imports(imports_of_test(path))):
            place = path.relative_to(ROOT / "tests")
            found.setdefault(place.parts[0], set()).add(place.as_posix())
    assert {room: sorted(files) for room, files in found.items() if len(files) > 1} == {}


def test_every_module_imports_without_a_warning():
    program = f"import importlib\nfor name in {NAMES!r}:\n    importlib.import_module(name)"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", program], capture_output=True, text=True, timeout=120, check=False
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_the_package_itself_loads_nothing_heavy():
    """`cotouch --help` must be quick."""
    program = (
        "import sys, cotouch; print(sorted({'numpy', 'scipy', 'numba', 'xarray', 'matplotlib'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"


def test_a_member_loads_nothing_heavy_that_it_does_not_need():
    """Every user waits for it."""
    heavy = {"scipy.optimize", "scipy.spatial", "scipy.stats", "xarray", "pandas", "matplotlib", "h5py"}
    program = f"import sys, cotouch.session; print(sorted({heavy!r} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.strip() == "[]"


def test_no_file_is_longer_than_one_reads() -> None:
    longest = {str(path.relative_to(ROOT)): len(path.read_text().splitlines()) for path in PACKAGE.rglob("*.py")}
    assert {name: lines for name, lines in longest.items() if lines > 400} == {}


def test_scenarios_are_tables_and_no_kernels():
    """What is compiled is in rooms below: tables can be read without it."""
    compiled = {"kernel", "part", "block", "inner", "outlined", "subroutine", "by_address"}
    for file in sorted((PACKAGE / "scenario").glob("*.py")):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                assert not {ast.unparse(one) for one in node.decorator_list} & compiled, (file.name, node.name)
