"""Every module of the package, as it is now."""

import ast
from functools import cache
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from types import ModuleType

import cotouch

PACKAGE = Path(str(cotouch.__file__)).parent
ROOT = PACKAGE.parent.parent


def _names() -> list[str]:
    found = walk_packages([str(PACKAGE)], "cotouch.")
    return ["cotouch", *sorted(module.name for module in found)]


NAMES = _names()


def loaded(name: str) -> ModuleType:
    return import_module(name)


@cache
def parsed(name: str) -> ast.Module:
    path = PACKAGE.joinpath(*name.split(".")[1:])
    path = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    return ast.parse(path.read_text(encoding="utf-8"))
