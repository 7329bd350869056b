"""Drivers with one line that is wrong, to see that a test would notice."""

import importlib
import importlib.util
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

import cotouch

PACKAGE = "cotouch.drivers"


class Drivers:
    """Classes of the drivers as they are now, or with a wrong line."""

    def __init__(self) -> None:
        self.ForceDimension = importlib.import_module(f"{PACKAGE}._force_dimension").ForceDimension
        self.Touch = importlib.import_module(f"{PACKAGE}._touch").Touch


@contextmanager
def mutated(module: str, line: str, wrong: str) -> Generator[Drivers]:
    """Drivers in which a piece of a module's text, which is there once, is another one."""
    name = f"{PACKAGE}.{module}"
    spec = importlib.util.find_spec(name)
    assert spec is not None
    assert spec.origin is not None
    source = Path(spec.origin).read_text()
    assert source.count(line) == 1, f"{module} has {line!r} {source.count(line)} times"
    before = {key: kept for key, kept in sys.modules.items() if key == PACKAGE or key.startswith(PACKAGE + ".")}
    for key in before:
        del sys.modules[key]
    try:
        importlib.import_module(PACKAGE)
        for key in [key for key in sys.modules if key.startswith(PACKAGE + ".")]:
            del sys.modules[key]
        mutant = ModuleType(name)
        mutant.__file__ = spec.origin
        sys.modules[name] = mutant
        exec(compile(source.replace(line, wrong), spec.origin, "exec"), mutant.__dict__)
        yield Drivers()
    finally:
        for key in [key for key in sys.modules if key == PACKAGE or key.startswith(PACKAGE + ".")]:
            del sys.modules[key]
        sys.modules.update(before)
        cotouch.drivers = before.get(PACKAGE)  # type: ignore[attr-defined]
