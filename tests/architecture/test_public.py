"""What is public exists, is documented, and is either abstract or final."""

import ast
import inspect
import re
from enum import Enum
from functools import cache
from types import FunctionType
from typing import get_origin, is_typeddict

import pytest
from tests.architecture.modules import FOLDERS, NAMES, PACKAGES, ROOMS, loaded, parsed


def own_classes(name: str) -> list[type]:
    return [entry for entry in vars(loaded(name)).values() if inspect.isclass(entry) and entry.__module__ == name]


@cache
def all_classes() -> list[type]:
    return [cls for name in NAMES for cls in own_classes(name)]


def written_doc(thing: object) -> str:
    """The docstring that somebody wrote; dataclasses and named tuples make up one of their own."""
    doc = inspect.getdoc(thing) or ""
    return "" if inspect.isclass(thing) and doc.startswith(f"{thing.__name__}(") else doc


@pytest.mark.parametrize("room", ROOMS)
def test_every_module_says_what_it_is(room: str):
    assert [name for name in ROOMS[room] if not ast.get_docstring(parsed(name))] == []


@pytest.mark.parametrize("name", PACKAGES)
def test_every_room_says_what_it_exports(name: str):
    exported = loaded(name).__all__
    assert len(exported) == len(set(exported))
    assert [entry for entry in exported if entry.startswith("_") and entry != "__version__"] == []


@pytest.mark.parametrize("name", PACKAGES)
def test_every_exported_name_exists_and_is_documented(name: str):
    module = loaded(name)
    for exported in module.__all__:
        thing = getattr(module, exported)
        if callable(thing) and get_origin(thing) is None:  # not a constant, not an alias of a type
            assert written_doc(thing), f"{name}.{exported} has no docstring"


def test_nothing_shares_its_name_with_anything_else():
    """What two rooms show under one name is one thing, and no two classes are called the same."""
    shown: dict[str, list[tuple[str, object]]] = {}
    for room in (name for name in PACKAGES if name != "cotouch"):
        for exported in loaded(room).__all__:
            shown.setdefault(exported, []).append((room, getattr(loaded(room), exported)))
    assert {name: [room for room, _ in found] for name, found in shown.items() if len(found) > 1} == {}
    homes: dict[str, set[str]] = {}
    for cls in all_classes():
        if not cls.__name__.startswith("_"):
            homes.setdefault(cls.__name__, set()).add(cls.__module__)
    assert {name: found for name, found in homes.items() if len(found) > 1} == {}


def test_folders_inside_rooms_show_nothing():
    """The room does, and the room's files import from each other's, so that each name has one way to it."""
    assert [name for name in FOLDERS if len(parsed(name).body) != 1] == []


@pytest.mark.parametrize("name", PACKAGES)
def test_every_room_is_a_list_of_names(name: str):
    """A room's `__init__` holds no code of its own: what it shows is imported from its private modules."""
    if name in {"cotouch", "cotouch.cli"}:  # one forwards names lazily; the other is the entry point
        return
    for node in parsed(name).body:
        assert isinstance(node, ast.Expr | ast.Import | ast.ImportFrom | ast.Assign), f"{name}, line {node.lineno}"


@pytest.mark.parametrize("room", ROOMS)
def test_every_class_is_abstract_or_final(room: str):
    """Errors form a tree and are exempt; so is the plumbing that numba wants subclassed."""
    for cls in (cls for name in ROOMS[room] for cls in own_classes(name)):
        if issubclass(cls, BaseException) or cls.__module__ == "cotouch.kernels._vector":
            continue
        final = vars(cls).get("__final__", False) or is_record(cls)
        subclasses = [other for other in all_classes() if cls in other.__bases__]
        if final:
            assert not subclasses, cls
        else:
            # A protocol, an abstract class, or a base of tables that only its subclasses fill.
            base = inspect.isabstract(cls) or getattr(cls, "_is_protocol", False) or subclasses
            assert base, f"mark {cls} @final"


@pytest.mark.parametrize("room", ROOMS)
def test_every_class_is_documented(room: str):
    for cls in (cls for name in ROOMS[room] for cls in own_classes(name)):
        if cls.__name__.startswith("_"):
            continue
        assert written_doc(cls), cls
        for name, member in vars(cls).items():
            function = member.fget if isinstance(member, property) else member
            function = getattr(function, "__func__", getattr(function, "func", function))
            if isinstance(function, FunctionType) and not name.startswith("_") and not is_made_up(function, cls):
                assert function.__doc__, f"{cls.__qualname__}.{name} has no docstring"


def is_record(cls: type) -> bool:
    """A named tuple, which kernels take and numba needs plain, or a dictionary whose keys are said."""
    return is_typeddict(cls) or (issubclass(cls, tuple) and hasattr(cls, "_fields"))


def is_made_up(function: FunctionType, cls: type) -> bool:
    """Written by a decorator or a base rather than in the class's file."""
    return function.__module__ != cls.__module__ or issubclass(cls, Enum)


def test_the_error_tree_is_drawn_as_it_is():
    """The drawing at the top of errors.py and the classes."""
    module = loaded("cotouch.errors")
    drawing = re.findall(r"^([ │]*(?:[├└]── )?)([A-Z]\w*Error)\b(.*)$", module.__doc__ or "", re.MULTILINE)
    path: list[str] = []
    drawn: dict[str, str | None] = {}
    for indent, name, _ in drawing:
        depth = len(indent) // 4 - 1  # the drawing itself is indented
        del path[depth:]
        drawn[name] = path[-1] if path else None
        path.append(name)
    assert drawn["CotouchError"] is None
    classes = {cls.__name__: cls for cls in own_classes("cotouch.errors")}
    assert set(drawn) == set(classes)
    for name, parent in drawn.items():
        assert classes[name].__bases__[0].__name__ == (parent or "Exception")
    also = {name: re.findall(r"\(also an? (\w+)\)", rest) for _, name, rest in drawing}
    for name, others in also.items():
        assert [base.__name__ for base in classes[name].__bases__[1:]] == others


def test_no_other_room_has_errors_of_its_own():
    # A KeyboardInterrupt is no error, whatever it carries.
    errors = [cls for cls in all_classes() if issubclass(cls, Exception) and not issubclass(cls, Warning)]
    strays = [cls for cls in errors if cls.__module__ != "cotouch.errors"]
    assert strays == []
