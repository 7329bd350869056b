"""Couplings of other packages are found by their entry points, in this process and in a fresh one."""

import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from tests.conftest import IMPORTS

from cotouch.coupling import device_couplings
from cotouch.device import Coupling, installed_coupling
from cotouch.errors import DeviceError, ScenarioError
from cotouch.scenario import Scenario

PAGE = Path(__file__).parents[2] / "docs" / "extending.md"
Install = Callable[..., Path]


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Install]:
    """Installs the coupling of the documents, as pip would, for this test."""

    def made(name: str = "slipping", value: str = "my_coupling:SLIPPING") -> Path:
        code = re.search(r'```python title="my_coupling.py"\n(.*?)```', PAGE.read_text(encoding="utf-8"), re.DOTALL)
        assert code is not None
        # Whoever is installed need not register itself.
        text = (
            code[1].replace("register_coupling(DeviceCoupling(", "(DeviceCoupling(").replace("register_coupling,", "")
        )
        (tmp_path / "my_coupling.py").write_text(text, encoding="utf-8")
        info = tmp_path / "my_coupling-1.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text("Metadata-Version: 2.1\nName: my-coupling\nVersion: 1.0\n", encoding="utf-8")
        (info / "entry_points.txt").write_text(f"[cotouch.couplings]\n{name} = {value}\n", encoding="utf-8")
        monkeypatch.syspath_prepend(tmp_path)
        monkeypatch.setattr("cotouch.coupling._law._KNOWN", device_couplings())
        monkeypatch.delitem(sys.modules, "my_coupling", raising=False)
        return tmp_path

    yield made
    sys.modules.pop("my_coupling", None)


def test_an_installed_coupling_is_known_by_its_name(install: Install) -> None:
    install()
    assert "slipping" not in device_couplings()
    assert installed_coupling("slipping").name == "slipping"
    assert Coupling(law="slipping", stiffness=200.0).end is device_couplings()["slipping"]


def test_a_scenario_and_a_fresh_process_find_it(install: Install) -> None:
    folder = install()
    table = {"user": 1, "at": [0.0, 0.0, 0.0], "device": {"coupling": "slipping"}}
    pair = {"users": ["a", "b"], "spring": [[0, 1], [1, 0]], "delay": [[0, 0.1], [0.1, 0]]}
    body = {"kind": "lattice", "shape": [2, 2, 2], "mass": 1.0, "stiffness": 10.0}
    scenario = Scenario.make(network=pair, body=body, steps={"duration": 0.1}, tools=[table])
    assert scenario.tools[0].device is not None
    assert scenario.tools[0].device.coupling == "slipping"
    program = "from cotouch.device import installed_coupling; print(installed_coupling('slipping').name)"
    found = {**os.environ, "PYTHONPATH": os.pathsep.join((IMPORTS, str(folder)))}
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=found, check=True)
    assert done.stdout == "slipping\n"


@pytest.mark.parametrize(
    ("name", "value", "asked", "words"),
    [
        ("slipping", "my_coupling:SLIPPING", "stiff", 'coupling is "stiff"; it must be one of pspm, virtual, slipping'),
        ("other", "my_coupling:SLIPPING", "other", 'the coupling "other" calls itself "slipping"'),
        ("slips", "my_coupling:SLIPS", "slips", 'the coupling "slips" is a float; it must be'),
        ("none", "no_such_module:THING", "none", 'the coupling "none" cannot be loaded: No module'),
    ],
)
def test_what_is_wrong_is_a_sentence(install: Install, name: str, value: str, asked: str, words: str) -> None:
    install(name, value)
    with pytest.raises(DeviceError, match=re.escape(words)):
        installed_coupling(asked)
    with pytest.raises(ScenarioError, match=re.escape(words.split(";", maxsplit=1)[0])):
        Scenario.make(
            network={"users": ["a", "b"], "spring": [[0, 1], [1, 0]], "delay": [[0, 0.1], [0.1, 0]]},
            steps={"duration": 0.1},
            tools=[{"user": 1, "at": [0.0, 0.0, 0.0], "device": {"coupling": asked}}],
        )


def test_a_coupling_that_holds_more_than_there_is_is_refused_before_anything_hangs_on_it(install: Install) -> None:
    """It ran: a damper below 0 gave a hand 6e99 J, and one that was no number ended the member's process."""
    folder = install()
    page = folder / "my_coupling.py"
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace("hold_gap(end, fraction,", "hold_gap(end, 1.0,"), encoding="utf-8")
    with pytest.raises(DeviceError, match='the coupling "slipping" breaks the interface: its spring holds more energy'):
        installed_coupling("slipping")
    assert "slipping" not in device_couplings()
