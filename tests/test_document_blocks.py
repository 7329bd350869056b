"""Every block of Python, TOML and console in the documents runs, or is at least one that could be run."""

import json
import re
import socket
import sys
import tomllib
from collections.abc import Callable, Generator
from contextlib import contextmanager, nullcontext
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
import typer
from tests.blocks import PAGES, ROOT, Block, blocks_of, commands_of
from tests.cli.commands import here
from tests.mechanics.inside import LAWS
from tests.recording.driven import Driven
from tests.web.fake_session_api import FakeSessionApi

from cotouch.body import solid_laws
from cotouch.cli import app
from cotouch.coupling import device_couplings
from cotouch.haptics import Driver, driver
from cotouch.laboratory import Study
from cotouch.laws import laws
from cotouch.mechanics import CONTACT_LAWS
from cotouch.members import SessionFile
from cotouch.scenario import Scenario

matplotlib.use("Agg")
# Commands that run here as they stand.
RUN = {"simulate", "certify", "plan", "--version", "replay", "audit", "export", "devices list"}
# And those that read three users' recordings.
READ_BACK = {"replay", "audit", "export"}
# Commands that are read as the command line reads them, to the last option, and why they do not run here.
READ = {
    "demo": "opens a session and a page, and stays; cli/test_session_commands.py runs it",
    "host": "opens a session and waits for people; cli/test_documented_commands.py runs it",
    "join": "needs a session of somebody else's; likewise",
    "measure": "likewise",
    "devices check": "moves a device that is plugged in",
}
SHELL = {"source"}
GROUPS = ("cotouch.devices", "cotouch.laws", "cotouch.contact_laws", "cotouch.couplings", "cotouch.materials")
Names = dict[str, Any]


@contextmanager
def recorded(folder: Path) -> Generator[None]:
    """Files of three users' session, as whoever reads on audits has them; the pages write their own later."""
    delay = np.array([[0.0, 0.02, 0.05], [0.03, 0.0, 0.04], [0.01, 0.02, 0.0]])
    party = Driven(folder, delay=delay, periods=(0.004, 0.005, 0.01))
    files = [path.rename(folder / f"{party.rename(user)}.mcap") for user, path in enumerate(party.run())]
    try:
        yield
    finally:
        for file in files:
            file.unlink()


def peer_at_work(folder: Path) -> Names:
    """What the page on recordings takes for granted: a peer, and a step that it took."""
    driven = Driven(folder)
    peer = driven.peer(0)
    return {"peer": peer, "now": 0.0, "T": 0.004, "report": peer.step(0.0, 0.004)}


def some_stage(folder: Path) -> Names:
    """What the page on the page takes for granted."""
    return {"stage": FakeSessionApi("1d")}


def measured_network(folder: Path) -> Names:
    """What `cotouch measure` would have left."""
    (folder / "network.toml").write_bytes((ROOT / "examples" / "five-users.toml").read_bytes())
    return {}


# What a reader of these pages already has.
GIVEN: dict[str, Callable[[Path], Names]] = {
    "page.md": some_stage,
    "recording.md": peer_at_work,
    "session.md": measured_network,
}


TWO = {"users": ["Ann", "Ben"], "delay": [[0, 0.02], [0.02, 0]], "spring": [[0, 50], [50, 0]]}


def free_port() -> int:
    with socket.socket() as held:
        held.bind(("127.0.0.1", 0))
        return int(held.getsockname()[1])


@cache
def command_line() -> Any:
    return typer.main.get_command(app)


def read_command(words: list[str]) -> None:
    """Lets the command line read a command without doing it; raises what is wrong with it."""
    command, name, *words = command_line(), *[word.replace("…", "INVITATION") for word in words]
    while hasattr(command, "commands"):
        name, *words = words
        assert name in command.commands, f"there is no command {name}"
        command = command.commands[name]
    command.make_context(name, words)


def command_of(words: list[str]) -> str:
    """A command with its subcommand."""
    return " ".join(words[1:3]) if words[1] == "devices" else words[1]


def read_toml(block: Block) -> None:
    """Takes a part of a file for what its page says it is."""
    if "[[session.devices]]" in block.text:
        SessionFile.from_toml((ROOT / "examples/live.toml").read_text(encoding="utf-8") + block.text)
    elif "entry-points" in block.text:
        assert any(f'[project.entry-points."{group}"]' in block.text for group in GROUPS)
    elif block.text.startswith(("[channel]", "[contact]", "[world]")):
        tables = tomllib.loads(block.text)
        assert Scenario.make(network=TWO, **tables).model_fields_set == {"network", *tables}
    elif block.text.startswith("[cutting]"):
        tables = tomllib.loads(block.text)
        body = {"kind": "lattice", "shape": [3, 3, 3], "neighbours": 18, "model": "spring-network"}
        assert Scenario.make(network=TWO, body=body, **tables).cutting is not None
    elif "law = {" in block.text:  # two ways of saying it
        for line in block.text.splitlines()[1:]:
            table = tomllib.loads(line.split("#")[0])
            assert Scenario.make(network=TWO, synchronisation=table).synchronisation.law is not None
    elif "in a session's file" in block.text:
        file = SessionFile.from_toml("session.users = 2\nbody.mass = 1.0\n" + block.text)
        assert file.scenario.synchronisation.law_given[0] == tomllib.loads(block.text)["synchronisation"]["law"]
    elif "laws = [" in block.text:  # a study
        networks = ROOT / "examples"
        tables = tomllib.loads(block.text.replace('"networks/', f'"{networks}/networks/'))
        assert len(Study.make(**tables).laws) == len(tables["laws"])
    else:
        raise AssertionError(f"nobody knows what this is a part of:\n{block.text}")


def sooner(words: list[str]) -> list[str]:
    """A search may take 2 s here: what it finds is no part of what a page promises."""
    if words[0] == "plan" and "--time-limit" not in words:
        words = [*words, "--time-limit", "2"]
    return [
        (f"{min(2.0, float(word))}" if before == "--time-limit" else word) for before, word in pairwise(["", *words])
    ]


def run_block(block: Block, names: Names) -> None:
    if block.title:
        Path(block.title).write_text(block.text, encoding="utf-8")
    if block.kind == "python":
        text = block.text.replace("8765", str(free_port()))
        exec(compile(text, block.title or "block", "exec"), names)
    elif block.kind == "toml" and not block.title:
        read_toml(block)
    for words in commands_of(block.text) if block.kind == "console" else []:
        if words[0] == "npm":
            scripts = json.loads((ROOT / "page" / "package.json").read_text(encoding="utf-8"))["scripts"]
            assert words[1:] == ["ci"] or (words[1] == "run" and words[2] in scripts), " ".join(words)
        elif words[0] == "make":
            assert re.search(rf"^{words[1]}:", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
        elif words[0] not in SHELL and "--animation" in words:  # it draws for long, on purpose
            read_command(words)
        elif words[0] not in SHELL and command_of(words) in RUN:
            with recorded(Path.cwd()) if words[1] in READ_BACK else nullcontext():
                done = here(*sooner(words[1:]))
            assert done.returncode == 0, done.stderr
        elif words[0] not in SHELL:
            assert command_of(words) in READ, f"nobody says why {' '.join(words)} does not run here"
            read_command(words)


@contextmanager
def desk_in(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[None]:
    """An empty folder with the examples beside it, from which modules are imported. What a page adds goes again."""
    contacts, forces, modules = dict(CONTACT_LAWS), dict(LAWS), dict(sys.modules)
    (folder / "examples").symlink_to(ROOT / "examples")
    monkeypatch.setattr("cotouch.coupling._law._KNOWN", device_couplings())
    monkeypatch.setattr("cotouch.laws._law._KNOWN", laws())
    monkeypatch.setattr("cotouch.body._material._SOLIDS", dict.fromkeys(solid_laws(), 0.0))
    monkeypatch.chdir(folder)
    monkeypatch.syspath_prepend(str(folder))
    try:
        yield
    finally:
        for registry, before in ((CONTACT_LAWS, contacts), (LAWS, forces)):
            for law in registry.keys() - before.keys():
                del registry[law]
        # Else whoever imports a module of that name from another folder gets this one, which registers nothing.
        for name in sys.modules.keys() - modules.keys():
            if Path(getattr(sys.modules[name], "__file__", None) or ROOT).is_relative_to(folder):
                del sys.modules[name]


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[Path]:
    """A desk for one page."""
    with desk_in(tmp_path, monkeypatch):
        yield tmp_path


@pytest.mark.parametrize(
    "page", [page for page in PAGES if blocks_of(page)], ids=lambda page: str(page.relative_to(ROOT))
)
def test_every_block_runs(page: Path, desk: Path):
    """In the order of the page, all with the same names; so a block may use what an earlier one made."""
    names: Names = {"__name__": page.stem, **GIVEN.get(page.name, lambda folder: {})(desk)}
    for block in blocks_of(page):
        run_block(block, names)
    assert all(finding.passed for finding in names.get("findings", []))


def test_what_a_page_adds_is_one_short_file_for_each_kind():
    """It runs there; with the entry point that makes it known, two files are new or changed."""
    added = {
        block.title: (block.text, len(block.text.splitlines()))
        for page in ("laws.md", "extending.md")
        for block in blocks_of(ROOT / "docs" / page)
        if block.kind == "python" and block.title
    }
    kinds = ("law", "material", "contact", "coupling", "devices")
    assert sorted(added) == sorted(f"my_{kind}.py" for kind in kinds)
    assert {title: lines for title, (_, lines) in added.items() if lines >= 60} == {}
    for title, (text, _) in added.items():  # of cotouch alone, and of nothing that is private there
        assert not re.search(r"^\s*(?:from|import) (?:my_|tests|cotouch\.\S*\b_)", text, re.MULTILINE), title


def test_what_a_page_adds_goes_again(tmp_path: Path):
    for said in (1, 2):
        folder = tmp_path / str(said)
        folder.mkdir()
        with pytest.MonkeyPatch.context() as patch, desk_in(folder, patch):
            run_block(Block("python", "of_a_page.py", f"said = {said}\n"), {})
            names: Names = {}
            run_block(Block("python", "", "import of_a_page\nsaid = of_a_page.said\n"), names)
        assert names["said"] == said


def test_no_page_hides_code_in_a_block_of_another_kind():
    for page in PAGES:
        for block in blocks_of(page):
            assert block.kind in {"python", "toml", "console", "math", "text"}, f"{page.name}: {block.kind}"
            if block.kind == "text":
                assert not re.search(r"^(?:cotouch (?!join ──)|import |from \S+ import)", block.text, re.MULTILINE)


def test_a_table_with_a_slip_in_it_is_still_taken_for_one(tmp_path: Path):
    page = tmp_path / "page.md"
    page.write_text("As follows:\n\n    [[session.devices]]\n    scale = fit\n\nand so on\n", encoding="utf-8")
    assert [block.kind for block in blocks_of(page)] == ["toml"]


def test_the_device_of_the_page_is_one_that_the_command_line_finds(desk: Path):
    for block in blocks_of(ROOT / "docs" / "extending.md")[:1]:
        run_block(block, {"__name__": "x"})
    assert isinstance(driver("my_devices/PUCK"), Driver)


@pytest.mark.parametrize(
    "block",
    [
        Block("python", "", "import cotouch\ncotouch.simulat\n"),
        Block("toml", "", '[[session.devices]]\ncoupling = "sticky"\n'),
        Block("toml", "", "[network]\n"),
        Block("console", "", "cotouch join INVITATION --nome Ann\n"),
        Block("console", "", "cotouch devices chek haply\n"),
        Block("console", "", "cotouch simulate gone.toml\n"),
        Block("console", "", "cotouch audit gone.mcap\n"),
        Block("console", "", "cotouch body gone.stl\n"),
        Block("toml", "", 'title = "Laws"\nlaws = ["wafe"]\nnetworks = [{name = "n", delay = 0.1}]\n'),
        Block("console", "", "make nothing\n"),
        Block("console", "", "npm run nothing\n"),
        Block("console", "", "cotouch replay gone.mcap\n"),
    ],
    ids=lambda block: block.text.split("\n")[0],
)
def test_a_block_that_does_not_run_is_found(block: Block, desk: Path):
    with pytest.raises(Exception, match=r"\w"):
        run_block(block, {})
