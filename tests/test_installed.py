"""Link laws and contact laws of other packages are found by their entry points, in every process."""

import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import IMPORTS

from cotouch.body import is_solid_model, solid_models
from cotouch.device import installed_coupling
from cotouch.errors import BodyError, DeviceError, NetworkError, ScenarioError
from cotouch.haptics import driver
from cotouch.installed import installed, installed_names
from cotouch.laws import Law, law_named, laws
from cotouch.mechanics import CONTACT_LAWS, contact_law_named
from cotouch.scenario import Scenario

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
        ("ends = ends:LAW", "ends", 'the law "ends" cannot be loaded: that is all$'),
        ("silent = silent:LAW", "silent", 'the law "silent" cannot be loaded: AssertionError$'),
    ],
)
def test_what_is_wrong_with_a_law_is_a_sentence(install: Install, entry: str, asked: str, words: str) -> None:
    folder = install(f"[cotouch.laws]\n{entry}\n")
    (folder / "ends.py").write_text("raise SystemExit('that is all')", encoding="utf-8")
    (folder / "silent.py").write_text("assert False", encoding="utf-8")
    with pytest.raises(NetworkError, match=words):
        law_named(asked)


def packed(folder: Path, name: str, entries: str) -> None:
    """Another package."""
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(entries, encoding="utf-8")


def test_a_name_that_two_packages_bring_is_refused_unless_it_is_the_same_thing(install: Install) -> None:
    """Whichever came first on the path was taken without a word: a law, or a driver for somebody's device."""
    entries = "[cotouch.laws]\nahead = my_law:{}\n[cotouch.devices]\nhaply = my_law:AHEAD\n"
    folder = install(entries.format("AHEAD"))
    packed(folder, "renamed", "[cotouch.laws]\nahead = my_law:AHEAD\n")
    assert law_named("ahead").name == "ahead"
    packed(folder, "theirs", entries.format("copy"))
    with pytest.raises(NetworkError, match='the law "ahead" is brought by the packages mine and theirs; uninstall all'):
        installed("cotouch.laws", "ahead", Law, what="law", error=NetworkError)
    with pytest.raises(DeviceError, match='the driver "haply" is brought by the packages cotouch and mine'):
        driver("haply")


def contact_of(name: str, **parameters: float) -> object:
    pair = {"users": ["a", "b"], "spring": [[0, 1], [1, 0]], "delay": [[0, 0.1], [0.1, 0]]}
    return Scenario.make(network=pair, contact={"law": name, "parameters": parameters}).contact.made()


def test_a_contact_law_is_tried_with_the_parameters_that_it_is_given(install: Install) -> None:
    folder = install("[cotouch.contact_laws]\nsoft = my_contact:Soft\n")
    page = folder / "my_contact.py"
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace("3.0 * modulus * depth**2", "3.0 * modulus**law.share * depth**2"), encoding="utf-8")
    assert str(contact_of("soft", share=1.0)) == "Soft(share=1.0)"
    with pytest.raises(ScenarioError, match=r'"soft" breaks the interface with Soft\(share=2.0\): pressure is not the'):
        contact_of("soft", share=2.0)


def test_a_package_cannot_take_a_name_of_cotouch_s_own(install: Install) -> None:
    """It was installed for nothing: cotouch's own ran in its place, and nobody said so."""
    install(
        "[cotouch.laws]\nwave = my_law:AHEAD\n[cotouch.couplings]\npspm = my_law:AHEAD\n"
        "[cotouch.materials]\nneo-hookean = my_law:AHEAD\n[cotouch.contact_laws]\nfoundation = my_contact:Soft\n"
    )
    assert law_named("paid").name == "paid"
    for named, name, what, error in (
        (law_named, "wave", "law", NetworkError),
        (installed_coupling, "pspm", "coupling", DeviceError),
        (is_solid_model, "neo-hookean", "material", BodyError),
        (contact_of, "foundation", "contact law", ScenarioError),
    ):
        with pytest.raises(error, match=f'the {what} "{name}" is cotouch\'s own, but the package mine brings one'):
            named(name)


def test_a_material_that_its_module_does_not_register_is_a_sentence(install: Install) -> None:
    install("[cotouch.materials]\nfoam = my_law:AHEAD\n")
    assert solid_models()[-2:] == ("foam", "rigid")
    with pytest.raises(BodyError, match='the material "foam" has an entry point, but its module registers none'):
        is_solid_model("foam")


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
