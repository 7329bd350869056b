"""The agreement, proved in the symbolic model: ProVerif reads docs/agreement.pv, and finds attacks on what is less."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

MODEL = Path(__file__).parents[2] / "docs" / "agreement.pv"
PROVERIF = shutil.which("proverif")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(PROVERIF is None, reason="no proverif here; opam install proverif brings it"),
]

GOALS = (
    "secret of the initiator",
    "secret of the responder",
    "responder authenticated",
    "initiator authenticated",
    "no unknown key share",
    "cannot be done",
)


def proved(model: str, folder: Path) -> dict[str, bool]:
    assert PROVERIF is not None
    file = folder / "model.pv"
    file.write_text(model)
    done = subprocess.run([PROVERIF, str(file)], capture_output=True, text=True, timeout=300, check=False)
    results = re.findall(r"^RESULT (?!\(even).* (is true|is false|cannot be proved)\.$", done.stdout, re.MULTILINE)
    assert len(results) == len(GOALS), done.stdout[-2000:]
    return {goal: result == "is true" for goal, result in zip(GOALS, results, strict=True)}


def test_all_goals_are_proved(tmp_path: Path):
    assert proved(MODEL.read_text(), tmp_path) == dict.fromkeys(GOALS[:-1], True) | {"cannot be done": False}


LESS = {
    "reply unsigned": ({"if signed(signature, other) = (reply, said) then": ""}, GOALS[0]),
    # Either alone is enough: who could not read the reply makes no proof.
    "hello and confirm unsigned": (
        {
            "if signed(signature, other) = (hello, said_hello) then": "",
            "if signed(closing, other) = (confirm, said) then": "",
        },
        GOALS[1],
    ),
    "no session": ({"hash((hash(name), ": "hash(("}, GOALS[4]),
    "no partner": (
        {
            "hash((hash(name), pk(own), other))": "hash((hash(name), pk(own)))",
            "hash((hash(name), other, pk(own)))": "hash((hash(name), other))",
        },
        GOALS[4],
    ),
    "nothing ephemeral": ({"derive(exp(theirs, ": "derive(exp(g, "}, GOALS[0]),
}


@pytest.mark.parametrize("what", LESS)
def test_less_is_not_enough(what: str, tmp_path: Path):
    model, (changes, lost) = MODEL.read_text(), LESS[what]
    for present, instead in changes.items():
        assert present in model
        model = model.replace(present, instead)
    assert not proved(model, tmp_path)[lost]
