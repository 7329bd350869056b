"""Random examples are the same on every run, whatever else is imported."""

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st


def drawn() -> list[tuple[int, float]]:
    found: list[tuple[int, float]] = []

    @settings(max_examples=100)
    @given(st.integers(), st.floats(allow_nan=False))
    def draw(integer: int, number: float) -> None:
        found.append((integer, number))

    draw()
    return found


def test_numbers_of_what_is_imported_are_not_among_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = drawn()
    path = tmp_path / "numbers_of_its_own.py"
    path.write_text(f"NUMBERS = {[*range(70001, 70101), *(0.1 + one for one in range(100))]}\n")
    spec = spec_from_file_location("numbers_of_its_own", path)
    assert spec is not None
    monkeypatch.setitem(sys.modules, "numbers_of_its_own", module_from_spec(spec))
    assert drawn() == before
