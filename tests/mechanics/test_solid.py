"""What is told of a material of one's own that is none."""

import re
import sys
from pathlib import Path
from typing import Any, cast

import pytest
from tests.blocks import blocks_of
from tests.mechanics.inside import LAWS, SOLID_LAWS

from cotouch.body import is_solid_model, solid_laws
from cotouch.errors import BodyError
from cotouch.kernels import inner, matrix3
from cotouch.mechanics import register_solid

PAGE = Path(__file__).parents[2] / "docs" / "extending.md"
NONE = "it cannot be evaluated: "


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The material of the documents, installed as pip would."""
    (block,) = [block for block in blocks_of(PAGE) if block.title == "my_material.py"]
    (tmp_path / "my_material.py").write_text(block.text, encoding="utf-8")
    info = tmp_path / "mine-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text("[cotouch.materials]\nmodified-kirchhoff = my_material:MODIFIED\n")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("cotouch.body._material._SOLIDS", dict.fromkeys(solid_laws(), 0.0))
    monkeypatch.delitem(sys.modules, "my_material", raising=False)
    return tmp_path / "my_material.py"


def test_an_installed_material_is_known_by_its_name(written: Path) -> None:
    assert len(written.read_text(encoding="utf-8").splitlines()) < 60
    before = set(LAWS)
    assert is_solid_model("modified-kirchhoff")
    assert not is_solid_model("modified")
    for law in set(LAWS) - before:
        del LAWS[law]
    sys.modules.pop("my_material")


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("2.0 * mu", "mu", "the stress does not do the work of the energy"),
        ("2.0 * mu", "-2.0 * mu", "the stress does not do the work of the energy"),
        ("[2] - 1.0", "[2]", "energy or stress is not 0 at rest"),
        ("0.5 * lam * growth", "0.25 * lam * growth", "the stress does not do the work of the energy"),
        ("lam * grow", "(lam + mu) * grow", "near rest the energy is not"),
        ("lam * grow", "0.0 + -lam * grow", f"{NONE}four numbers at once have no unary minus"),
        ("return f[0]", "return f[0] ** 1.5", f"{NONE}four numbers at once take whole powers only"),
        ("return mu", "return 0.0 if growth > 1.0 else mu", f"{NONE}it branches on what may be four numbers"),
        ("matrix3.cofactor", "matrix3.cofacor", f"{NONE}module 'cotouch.kernels.matrix3' has no attribute"),
        ("h, h1, memory, e)", "h, h1)", f"{NONE}stress() takes 5 positional arguments"),
        ("e1, e1", "e1, e1[0]", NONE),
    ],
)
def test_what_a_material_gets_wrong_is_one_sentence(written: Path, right: str, wrong: str, said: str) -> None:
    text = written.read_text(encoding="utf-8")
    assert right in text
    written.write_text(text.replace(right, wrong), encoding="utf-8")
    with pytest.raises(BodyError) as caught:
        is_solid_model("modified-kirchhoff")
    assert f'material "modified-kirchhoff" breaks the interface: {said}' in str(caught.value)
    assert "\n" not in str(caught.value)


@inner
def _linear(law: Any, lam: float, mu: float, h: Any, h1: Any, memory: Any, e: Any) -> Any:
    strain = matrix3.symmetric(matrix3.mixture(0.5, h, 0.5, h1))
    return matrix3.diagonal(matrix3.scaled(2.0 * mu, strain), lam * (strain[0] + strain[4] + strain[8]))


@inner
def _linear_energy(law: Any, lam: float, mu: float, h1: Any, memory: Any, e: Any, sweeps: int) -> float:
    strain = matrix3.symmetric(h1)
    return mu * matrix3.contraction(strain, strain) + 0.5 * lam * (strain[0] + strain[4] + strain[8]) ** 2


@inner
def _stops(law: Any, lam: float, mu: float, h1: Any, memory: Any, e: Any, sweeps: int) -> float:
    assert lam > 0.0
    return 0.0


@pytest.mark.parametrize(
    ("stress", "energy", "said"),
    [
        (cast("Any", _linear).py_func, _linear_energy, "its stress is not compiled; write `@inner` above it"),
        (_linear, cast("Any", _linear_energy).py_func, "its energy is not compiled; write `@inner` above it"),
        (_linear, _stops, "its energy raises an error or asserts (test_solid.py, line "),
    ],
)
def test_what_a_step_could_not_call_is_refused(stress: Any, energy: Any, said: str) -> None:
    with pytest.raises(BodyError, match=f'^material "linear" breaks the interface: {re.escape(said)}'):
        register_solid("linear", stress=stress, energy=energy)


def test_a_material_may_have_any_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("cotouch.body._material._SOLIDS", dict.fromkeys(solid_laws(), 0.0))
    own = SOLID_LAWS["st-venant-kirchhoff"]
    made = register_solid("kirchhoff 2.b", stress=own.stress, energy=own.energy)
    assert "kirchhoff 2.b" in solid_laws()
    del LAWS[made.kind], SOLID_LAWS["kirchhoff 2.b"]


def test_a_material_that_feels_rotation_is_refused() -> None:
    with pytest.raises(
        BodyError, match=r'^material "linear" breaks the interface: the energy changes as the body turns'
    ):
        register_solid("linear", stress=_linear, energy=_linear_energy)
    assert "linear" not in solid_laws()
