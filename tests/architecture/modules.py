"""Every module of the package, as it is now."""

import ast
from functools import cache
from importlib import import_module
from itertools import groupby
from pathlib import Path
from types import ModuleType

import cotouch

PACKAGE = Path(str(cotouch.__file__)).parent
ROOT = PACKAGE.parent.parent


def _names() -> list[str]:
    found = (path.relative_to(PACKAGE.parent).with_suffix("") for path in PACKAGE.rglob("*.py"))
    return sorted(".".join(path.parts).removesuffix(".__init__") for path in found)


NAMES = _names()


def room_of(name: str) -> str:
    """The room of a module; of the package itself `cotouch`."""
    return ".".join(name.split(".")[:2])


# A test for each room and not for each module: whoever shares the tests collects them all, and loads nothing for it.
ROOMS = {room: list(names) for room, names in groupby(NAMES, room_of)}
PACKAGES = [name for name in NAMES if PACKAGE.joinpath(*name.split(".")[1:]).is_dir() and name.count(".") <= 1]
# Large rooms keep their files in folders. What these hold is private, whoever lists it.
FOLDERS = [name for name in NAMES if PACKAGE.joinpath(*name.split(".")[1:]).is_dir() and name.count(".") > 1]


def loaded(name: str) -> ModuleType:
    return import_module(name)


@cache
def parsed(name: str) -> ast.Module:
    path = PACKAGE.joinpath(*name.split(".")[1:])
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return ast.parse(path.read_text(encoding="utf-8"))
