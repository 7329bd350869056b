"""Link laws and contact laws of other packages are found by their entry points, in every process."""

import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import IMPORTS

from cotouch.errors import NetworkError, ScenarioError
from cotouch.installed import installed_names
from cotouch.laws import law_named, laws
from cotouch.mechanics import CONTACT_LAWS, contact_law_named

DOCS = Path(__file__).parents[1] / "docs"
PAGES = {"my_law": DOCS / "laws.md", "my_contact": DOCS / "extending.md"}
Install = Callable[[str], Path]


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Installs the laws of the documents, as pip would, for this test; takes their entry points."""

    def made(entries: str) -> Path:
        for name, page in PAGES.items():
            code = re.search(rf'```python title="{name}.py"\n(.*?)```', page.read_text(encoding="utf-8"), re.DOTALL)
            assert code is not None
            (tmp_path / f"{name}.py").write_text(code[1], encoding="utf-8")
            monkeypatch.delitem(sys.modules, name, raising=False)
        info = tmp_path / "mine-1.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1.0\n", encoding="utf-8")
        (info / "entry_points.txt").write_text(entries, encoding="utf-8")
        monkeypatch.syspath_prepend(tmp_path)
        monkeypatch.setattr("cotouch.laws._law._KNOWN", {name: laws()[name] for name in ("paid", "wave")})
        return tmp_path

    before = dict(CONTACT_LAWS)
    yield made
    for law in CONTACT_LAWS.keys() - before.keys():
        del CONTACT_LAWS[law]
    for name in PAGES:
        sys.modules.pop(name, None)


def test_a_command_finds_them(install: Install) -> None:
    folder = install("[cotouch.laws]\nahead = my_law:AHEAD\n[cotouch.contact_laws]\nsoft = my_contact:Soft\n")
    assert installed_names("cotouch.laws") == ["ahead"]
    (folder / "press.toml").write_text(
        """
        [network]
        users = ["a", "b"]
        spring = [[0, 50], [50, 0]]
        delay = [[0, 0.01], [0.01, 0]]
        [body]
        kind = "lattice"
        shape = [2, 2, 2]
        [steps]
        duration = 0.05
        [[tools]]
        user = 1
        at = [0.005, 0.005, 0.02]
        [contact]
        law = "soft"
        parameters = { share = 2.0 }
        """,
        encoding="utf-8",
    )
    program = (
        "from cotouch.scenario import Scenario; s = Scenario.read('press.toml').replace(synchronisation__law='ahead');"
        "print(s.law[0], s.contact.made())"
    )
    path = {"PYTHONPATH": f"{IMPORTS}:{folder}"}
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=folder, env=path, capture_output=True, text=True, check=True
    )
    assert done.stdout == "ahead Soft(share=2.0)\n"


@pytest.mark.parametrize(
    ("entry", "asked", "words"),
    [
        ("ahead = my_law:AHEAD", "behind", 'law is "behind"; it must be one of paid, wave, ahead$'),
        ("other = my_law:AHEAD", "other", 'the law "other" calls itself "ahead"; its entry point must have this name'),
        ("copied = my_law:copy", "copied", 'the law "copied" is a .*; it must be a cotouch.laws.Law'),
        ("none = no_such_module:LAW", "none", 'the law "none" cannot be loaded: No module'),
    ],
)
def test_what_is_wrong_with_a_law_is_a_sentence(install: Install, entry: str, asked: str, words: str) -> None:
    install(f"[cotouch.laws]\n{entry}\n")
    with pytest.raises(NetworkError, match=words):
        law_named(asked)


@pytest.mark.parametrize(
    ("entry", "asked", "words"),
    [
        ("soft = my_contact:Soft", "hard", 'contact.law is "hard"; it must be one of foundation, soft, stiffening'),
        ("softer = my_contact:Soft", "softer", 'the contact law "softer" is the class Soft; its entry point must'),
        ("pressed = my_contact:press", "pressed", 'the contact law "pressed" is a .*; it must be a class'),
        ("none = no_such_module:LAW", "none", 'the contact law "none" cannot be loaded: No module'),
    ],
)
def test_what_is_wrong_with_a_contact_law_is_a_sentence(install: Install, entry: str, asked: str, words: str) -> None:
    install(f"[cotouch.contact_laws]\n{entry}\n")
    with pytest.raises(ScenarioError, match=words):
        contact_law_named(asked)
