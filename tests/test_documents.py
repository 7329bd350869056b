"""What documents name exists: files, tests, links, floors; and every block of code in them runs."""

import ast
import re
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from pkgutil import resolve_name
from typing import Any, get_type_hints

import pytest
import typer

from cotouch.members import SessionFile

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "src" / "cotouch"
NOTES = sorted(PACKAGE.rglob("DESIGN.md"))
PAGES = [
    *(ROOT / name for name in ("ARCHITECTURE.md", "CONTRIBUTING.md", "README.md", "page/README.md")),
    *sorted((ROOT / "docs").rglob("*.md")),
    *NOTES,
]
ENDINGS = "py|md|toml|ts|css|pv|yml|cff|json|lock"
FILE = re.compile(rf"`([\w./-]+\.(?:{ENDINGS}))((?:::\w+)*)`")
LINK = re.compile(r"\]\(([^)\s]+)\)")
MENTIONED = re.compile(r"`((?:cotouch|make|python) [^`\n]*)`")
SAID_ABOVE = re.compile(r"^# {2,}((?:cotouch|make|python) .*)$", re.MULTILINE)
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))
OPTIONS = frozenset(get_type_hints(SessionFile)["options"].model_fields)
GROUPS = frozenset(
    f"cotouch.{kind}" for kind in ("contact_laws", "couplings", "devices", "materials")
)  # of entry points
# Names of other people's software.
ELSEWHERE = frozenset({"HD_OUTPUT_DOF", "HD_CURRENT_TORQUE", "defer_build"})


def name(path: Path) -> str:
    return str(path.relative_to(ROOT))


@cache
def prose(page: Path) -> str:
    """The text of a page without its blocks of code."""
    return re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)


@cache
def defined(file: Path) -> frozenset[str]:
    """Tests of a file: `test_x`, `TestY` and `TestY::test_x`."""
    found = set[str]()
    for node in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            found.add(node.name)
        if isinstance(node, ast.ClassDef):
            found |= {f"{node.name}::{entry.name}" for entry in node.body if isinstance(entry, ast.FunctionDef)}
    return frozenset(found)


def headings(page: Path) -> set[str]:
    """Anchors of a page, as GitHub and the site make them."""
    titles = re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in titles}


def wrong_files(page: Path, text: str) -> list[str]:
    """Files and tests in backticks that are not there.

    A name counts from the page's own folder, from the root, or from the package.
    """
    wrong = list[str]()
    for path, test in FILE.findall(text):
        places = [place / path for place in (page.parent, ROOT, PACKAGE)]
        file = next((place for place in places if place.is_file()), None)
        if file is None or (test and test.removeprefix("::") not in defined(file)):
            wrong.append(path + test)
    return wrong


@pytest.mark.parametrize("page", [ROOT / "ARCHITECTURE.md", ROOT / "docs" / "formulas.md", *NOTES], ids=name)
def test_files_and_tests_that_are_named_exist(page: Path):
    assert FILE.search(prose(page))
    assert wrong_files(page, prose(page)) == []


def test_what_does_not_exist_is_found():
    page = PACKAGE / "peer" / "DESIGN.md"
    text = "`_guard.py` `peer/_gone.py` `tests/peer/test_guard.py::test_gone` `tests/peer/test_guard.py`"
    assert wrong_files(page, text) == ["peer/_gone.py", "tests/peer/test_guard.py::test_gone"]


@cache
def words() -> frozenset[str]:
    """Every identifier of the sources."""
    kinds = {"src": "*.py", "tests": "*.py", "benchmarks": "*.py", "page/src": "*.ts"}
    texts = (file.read_text(encoding="utf-8") for folder, kind in kinds.items() for file in (ROOT / folder).rglob(kind))
    return frozenset(word for text in texts for word in re.findall(r"\w+", text))


def exists(dotted: str) -> bool:
    """Whether the package has a name such as `cotouch.laws.End`."""
    try:
        return resolve_name(dotted) is not None
    except (ImportError, AttributeError):
        return False


def wrong_names(text: str) -> list[str]:
    """Names in backticks that no source has, that the package does not export, or that are no option of a session."""
    names = re.findall(r"(?<!\$)`([A-Za-z_][\w.]*)`", text)
    gone = [name for name in names if "_" in name and not set(name.split(".")) - {""} <= words() | ELSEWHERE]
    gone += [name for name in re.findall(r"`(cotouch(?:\.\w+)+)", text) if not (name in GROUPS or exists(name))]
    return gone + [name for name in names if re.fullmatch(r"session\.(?!py)\w+", name) and name[8:] not in OPTIONS]


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_names_that_are_given_exist(page: Path):
    assert wrong_names(prose(page)) == []


def test_every_option_of_a_session_has_its_row():
    table = prose(ROOT / "docs" / "session.md").partition("## Options of [session]")[2].partition("\n## ")[0]
    assert set(re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)) == OPTIONS - {"devices"}


def test_a_name_that_is_gone_is_found():
    text = "`stiffness_scale` `" + "stiffness" + "_portion` `session.margin` `session.gather` `$T_w$` "
    text += "`cotouch.laws.laws()` `cotouch.laws.lost(1)`"
    assert wrong_names(text) == ["stiffness" + "_portion", "cotouch.laws.lost", "session.gather"]


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_lead_somewhere(page: Path):
    for link in LINK.findall(prose(page)):
        if link.startswith(("http://", "https://", "reference/")):  # the reference is made with the site
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        assert target.exists(), f"{link} is not there"
        if anchor and target.suffix == ".md":
            assert anchor in headings(target), f"{link} has no such heading"


@pytest.mark.parametrize("page", NOTES, ids=name)
def test_every_decision_names_its_test(page: Path):
    parts = re.split(r"^## ", page.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]
    assert parts
    assert [part.splitlines()[0] for part in parts if "*Test:*" not in part] == []


def test_every_note_is_listed():
    """On the map, or in the note of its room."""
    lists = [ROOT / "ARCHITECTURE.md", *PACKAGE.glob("*/DESIGN.md")]
    listed = {(page.parent / link).resolve() for page in lists for link in LINK.findall(prose(page))}
    assert set(NOTES) <= listed


def test_the_map_of_floors_is_the_contract():
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    contract = next(contract for contract in settings["contracts"] if contract["type"] == "layers")
    floors = [{room.strip().removeprefix("cotouch.") for room in row.split("|")} for row in contract["layers"]]
    table = prose(ROOT / "ARCHITECTURE.md").partition("## Floors")[2].partition("\n## ")[0]
    drawn = [set(re.findall(r"`(\w+)`", row.split("|")[1])) for row in re.findall(r"^\| `.*$", table, re.MULTILINE)]
    assert drawn == [floor for floor in floors if floor != {"__main__"}]


def test_the_site_shows_every_page():
    listed = re.findall(r"^ +- .*: ([\w-]+\.md)$", (ROOT / "mkdocs.yml").read_text(encoding="utf-8"), re.MULTILINE)
    made = {"benchmarks.md"}  # by docs/site.py
    assert sorted(set(listed) - made) == sorted(page.name for page in (ROOT / "docs").glob("*.md"))


def test_what_is_cited_is_this_version():
    cited = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"\nversion: {project['version']}\n" in cited
    assert f"\nlicense: {project['license']}\n" in cited


def test_architecture_stays_two_pages():
    assert len((ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").splitlines()) <= 120


def options_of(command: Any, name: str) -> Iterator[tuple[str, str]]:
    """Every option of a command and those below it that are to be seen, with the command's name."""
    for below, entry in getattr(command, "commands", {}).items():
        yield from options_of(entry, f"{name} {below}")
    for parameter in command.params:
        if not getattr(parameter, "hidden", False):
            yield from ((name, option) for option in parameter.opts if option.startswith("--"))


def test_every_option_of_the_command_line_is_in_a_document():
    from cotouch.cli import app

    # The other form of a switch counts too, and of a mesh's options there is a table.
    text = " ".join(page.read_text(encoding="utf-8") for page in PAGES).replace("--no-", "--")
    body = re.findall(r"^\| (`[\w`, ]+) \|", (ROOT / "docs" / "scenario.md").read_text(encoding="utf-8"), re.MULTILINE)
    keys = {f"--{key.replace('_', '-')}" for row in body for key in re.findall(r"`(\w+)`", row)}
    missing = [
        f"{command} {option}"
        for command, option in options_of(typer.main.get_command(app), "cotouch")
        if not re.search(rf"{option}(?![\w-])", text) and not (command == "cotouch body" and option in keys)
    ]
    assert not missing


def wrong_command(text: str) -> str | None:
    """What is not there of a command that a text names in passing, with `|` or `\\|` between choices; None: nothing."""
    from cotouch.cli import app

    first, name, *words = text.replace("\\|", "|").split()
    if first == "make":
        return None if re.search(rf"^{name}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE) else name
    if first == "python":
        path = words[0].replace(".", "/") if name == "-m" else name.removesuffix(".py")
        places = (ROOT / f"{path}.py", ROOT / path / "__main__.py")
        return None if any(place.is_file() for place in places) else path
    command: Any = typer.main.get_command(app)
    for choice in name.split("|"):
        if choice not in command.commands:
            return choice
    command = command.commands[name]
    if hasattr(command, "commands") and words:
        missing = [choice for choice in words[0].split("|") if choice not in command.commands]
        if missing:
            return missing[0]
        command = command.commands[words[0].split("|")[0]]
    known = {option for parameter in command.params for option in (*parameter.opts, *parameter.secondary_opts)}
    return next((option for option in re.findall(r"(?<![\w-])--[a-z][\w-]*", text) if option not in known), None)


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_commands_that_are_named_in_passing_exist(page: Path):
    found = MENTIONED.findall(page.read_text(encoding="utf-8"))
    assert [(text, wrong) for text in found if (wrong := wrong_command(text)) is not None] == []


@pytest.mark.parametrize("example", EXAMPLES, ids=name)
def test_commands_that_an_example_says_exist(example: Path):
    text = example.read_text(encoding="utf-8")
    found = MENTIONED.findall(text) + SAID_ABOVE.findall(text)
    assert [(text, wrong) for text in found if (wrong := wrong_command(text)) is not None] == []


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("make shapes", "shapes"),
        ("python examples/gone.py", "examples/gone"),
        ("python -m tests.web.gone FOLDER", "tests/web/gone"),
        ("cotouch fell SCENARIO", "fell"),
        ("cotouch devices list|chek", "chek"),
        ("cotouch plan NETWORK --links E [--goal decay\\|feel]", "--goal"),
        ("cotouch replay FILE --impair loss=0.3", "--impair"),
    ],
)
def test_a_command_that_does_not_exist_is_found(text: str, wrong: str):
    assert wrong_command(text) == wrong


def test_the_readme_activates_the_environment_before_it_names_what_is_in_it():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    activated = text.index("source .venv/bin/activate")
    for command in ("`cotouch ", "    cotouch ", "`python ", "    python "):
        assert text.find(command) == -1 or text.find(command) > activated, command
