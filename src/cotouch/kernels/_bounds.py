"""Whether a compiled function keeps to its arrays: machine code does not check indices, so Python runs it once.

A function that somebody else wrote for a kernel is run as it is written, on small arrays, with everything compiled that
it calls likewise. That finds an index that machine code would follow into other people's memory.
"""

import traceback
from collections.abc import Callable, Iterable
from types import CellType, CodeType, FunctionType, ModuleType
from typing import TypeVar, final

import numpy as np

from cotouch.arrays import Array
from cotouch.kernels import _vector
from cotouch.kernels._four_numbers import AS_WRITTEN
from cotouch.kernels._vector import at, put

R = TypeVar("R")


def beyond(functions: Iterable[Callable[..., object]], calls: Iterable[tuple[object, ...]]) -> str | None:
    """Where one of some functions leaves an array, in a sentence; None: nowhere.

    Args:
        functions: called one after the other.
        calls: arguments of each call.
    """
    known = _known()
    plain = [_rebuilt(function, function, known) for function in functions]
    for arguments in calls:
        for function in plain:
            try:
                with np.errstate(all="ignore"):
                    function(*arguments)
            except IndexError as error:
                frames = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename != __file__]
                return f"{error} ({frames[-1].filename.rpartition('/')[2]}, line {frames[-1].lineno})"
            except Exception:  # noqa: BLE001, S112 - machine code divides by zero, and knows what Python does not
                continue
    return None


def as_written(function: Callable[..., R]) -> Callable[..., R]:
    """A function as Python runs it, with everything compiled that it calls.

    Args:
        function: compiled, or not.
    """
    return _rebuilt(function, getattr(function, "py_func", function), _known())


def written_here(function: object) -> bool:
    """Whether a function or class is cotouch's own, whose indices its tests look after."""
    return getattr(function, "__module__", "").partition(".")[0] == "cotouch"


def _known() -> dict[int, object]:
    """What stands in for machine code that Python has no body of."""
    numbers = {id(getattr(_vector, name)): stand for name, stand in AS_WRITTEN.items()}
    return {id(at): _at, id(put): _put, **numbers}


def _at(array: Array, index: int | tuple[int, ...]) -> object:
    return array.reshape(-1)[index] if np.ndim(index) == 0 and array.ndim > 1 else array[index]


def _put(array: Array, index: int | tuple[int, ...], value: float) -> None:
    if np.ndim(index) == 0:
        array = array.reshape(-1)
    array[index] = value


@final
class _Module:
    """A module whose compiled functions run as they are written."""

    def __init__(self, module: ModuleType, known: dict[int, object]) -> None:
        self._module, self._known = module, known

    def __getattr__(self, name: str) -> object:
        return _plain(getattr(self._module, name), self._known)


def _plain(thing: object, known: dict[int, object]) -> object:
    """A compiled function as it is written, with all that it calls; anything else as it is."""
    if id(thing) in known:
        return known[id(thing)]
    if isinstance(thing, ModuleType):
        return _Module(thing, known)
    function = getattr(thing, "py_func", None)
    return _rebuilt(thing, function, known) if isinstance(function, FunctionType) else thing


def _rebuilt(thing: object, function: FunctionType, known: dict[int, object]) -> FunctionType:
    """A function that runs as it is written, as does all that it calls."""
    names = dict(function.__globals__)
    cells = tuple(CellType() for _ in function.__closure__ or ())
    made = known[id(thing)] = FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells)
    made.__kwdefaults__ = function.__kwdefaults__
    for cell, given in zip(cells, function.__closure__ or (), strict=True):
        cell.cell_contents = _plain(given.cell_contents, known)
    for name in _names_of(function.__code__) & names.keys():
        names[name] = _plain(names[name], known)
    return made


def _names_of(code: CodeType) -> set[str]:
    """Names that a function and those within it ask for."""
    return set(code.co_names).union(*(_names_of(part) for part in code.co_consts if isinstance(part, CodeType)))
