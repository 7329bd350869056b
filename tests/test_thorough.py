"""What is left out of the short run is what is named, and every test keeps a case where it can."""

from pathlib import Path

from tests import thorough
from tests.thorough import QUICK, examples, split, unknown

ROOM = "simulation/test_rigid.py::test_both_engines_move_it_alike_and_balance_it"


def test_what_is_named_is_there():
    for name in QUICK:
        file, *_, test = name.split("::")
        assert f"def {test}(" in (Path(__file__).parent / file).read_text(), name


def test_a_case_that_is_not_there_is_told():
    assert unknown([f"tests/{ROOM}[hand]", f"tests/{ROOM}[tool]"]) == []
    assert unknown([f"tests/{ROOM}[tool]"]) == [f"{ROOM}[hand]"]
    assert unknown(["tests/simulation/test_rigid.py::test_another"]) == [ROOM], "the test has another name now"
    assert unknown(["tests/simulation/test_world_of_another_file.py::test_one"]) == []


def test_names_are_taken_apart():
    assert split("tests/a/test_b.py::TestC::test_d[x[0]-y]") == ("a/test_b.py::TestC::test_d", "x[0]-y")
    assert split("tests/a/test_b.py::test_d") == ("a/test_b.py::test_d", "")


def test_examples_are_fewer_unless_all_are_wanted(monkeypatch):
    monkeypatch.delenv(thorough.VARIABLE, raising=False)
    assert [examples(count) for count in (5, 30, 800)] == [5, 8, 100]
    monkeypatch.setenv(thorough.VARIABLE, "1")
    assert [examples(count) for count in (5, 30, 800)] == [5, 30, 800]
