"""Where files lie that come with the package."""

from pathlib import Path

import pytest

from cotouch.errors import ScenarioError
from cotouch.files import shipped


def test_in_the_sources() -> None:
    assert shipped("study", "five-users.toml", ScenarioError).parent.name == "examples"


def test_beside_the_package_first(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    installed = tmp_path / "study" / "five-users.toml"
    installed.parent.mkdir()
    installed.write_text("")
    monkeypatch.setattr("cotouch.files._shipped.files", lambda _: tmp_path)
    assert shipped("study", "five-users.toml", ScenarioError) == installed


def test_nowhere() -> None:
    with pytest.raises(ScenarioError, match=r"six-users\.toml is neither beside cotouch.study nor in the examples"):
        shipped("study", "six-users.toml", ScenarioError)
