"""The cache of compiled kernels knows all of their sources."""

import importlib
import os
import re
import sys
from pathlib import Path
from shutil import copytree, ignore_patterns
from typing import Any

import pytest

import cotouch
from cotouch import compiled as machine
from cotouch.mechanics import settle, step
from cotouch.network import rightmost

PACKAGE = Path(str(cotouch.__file__)).parent


@pytest.mark.parametrize("compiled", [step, settle, rightmost])
def test_the_cache_is_stamped_with_the_newest_source(compiled: object):
    stamp = compiled._cache._cache_file._source_stamp  # pyright: ignore[reportAttributeAccessIssue]
    assert stamp == machine._STAMP


def test_every_file_with_a_kernel_counts():
    counted = {path for room in machine._ROOMS for path in (machine._PACKAGE / room).glob("_*.py")}
    with_kernels = {
        path
        for path in PACKAGE.rglob("*.py")
        if re.search(r"^@(block|inner|kernel|part|intrinsic|routine)\b", path.read_text(), re.MULTILINE)
    }
    assert len(with_kernels) >= 3
    assert with_kernels <= counted


@pytest.mark.parametrize(
    "name", ["mechanics/_operator.py", "mechanics/_vector.py", "simulation/_engine.py", "network/_loop.py"]
)
def test_an_edit_of_any_file_changes_the_stamp(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    copy = copytree(PACKAGE, tmp_path / "cotouch", ignore=ignore_patterns("__pycache__"))
    monkeypatch.setattr(machine, "_PACKAGE", copy)
    before = machine._newest_source()
    assert machine._newest_source() == before

    path = copy / name
    os.utime(path, (before[0] + 10.0, before[0] + 10.0))
    touched = machine._newest_source()
    assert touched == (before[0] + 10.0, before[1])

    path.write_text(path.read_text() + "\n")
    os.utime(path, (0.0, 0.0))  # an older file put in its place still changes the total size
    assert machine._newest_source() != before


def test_kernels_keep_their_names_and_documentation():
    assert step.__name__ == "step"
    assert step.__doc__ is not None
    assert step.__doc__.startswith("Advances one copy by T")


def test_cold_is_what_neither_memory_nor_disk_holds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "doubling.py"
    path.write_text("from cotouch.compiled import routine\n\n\n@routine\ndef double(x):\n    return 2.0 * x\n")
    monkeypatch.syspath_prepend(tmp_path)

    def fresh() -> Any:
        sys.modules.pop("doubling", None)
        return importlib.import_module("doubling").double

    assert machine.cold(fresh())
    once = fresh()
    assert once(2.0) == 4.0
    assert not machine.cold(once)
    assert not machine.cold(fresh()), "the disk holds it"
    monkeypatch.setattr(machine, "_STAMP", (0.0, 0))
    assert machine.cold(fresh()), "some source has changed"
    assert not machine.cold(len)
