"""What an animation is made of, checked: sizes, indices and finite numbers."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Array, Float, Int, Single, extents
from cotouch.errors import BodyError, InputError, NetworkError


def keep_frozen(thing: object, **values: object) -> None:
    """Sets attributes of a frozen dataclass; arrays become read-only.

    Args:
        thing: the dataclass.
        **values: of its attributes, by name.
    """
    for name, value in values.items():
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
        object.__setattr__(thing, name, value)


def numbers_of(
    name: str,
    values: npt.ArrayLike | None,
    error: type[InputError],
    *,
    finite: bool = True,
    kind: npt.DTypeLike = np.float64,
) -> Array:
    """An array of numbers.

    Args:
        name: what messages call it.
        values: what was given.
        error: raised where it is wrong.
        finite: whether all must be finite.
        kind: of the numbers.
    """
    try:
        array: Array = np.array(values, dtype=kind, order="C")
    except (TypeError, ValueError, OverflowError) as reason:
        raise error(f"{name} are not an array of numbers ({reason})") from reason
    if finite and not np.isfinite(array).all():
        where = [int(index) for index in np.argwhere(~np.isfinite(array))[0]]
        raise error(f"{name} are {array[tuple(where)]} at index {where}; every number must be finite")
    return array


def indices_of(name: str, values: npt.ArrayLike, dimensions: int, error: type[InputError]) -> Int:
    """Whole numbers.

    Args:
        name: what messages call it.
        values: what was given.
        dimensions: of the array.
        error: raised where it is wrong.
    """
    numbers = numbers_of(name, values, error)
    if numbers.ndim != dimensions:
        raise error(f"{name} are {extents(numbers.shape)}; they must have {dimensions} dimensions")
    whole = numbers.astype(np.int32)
    if not np.array_equal(whole, numbers):
        raise error(f"{name} must be whole numbers, indices from 0")
    return whole


def corners_of(name: str, values: npt.ArrayLike | None, width: int, count: int) -> Int:
    """Rows of indices of vertices, (rows, width).

    Args:
        name: what messages call it.
        values: what was given.
        width: entries of a row.
        count: how many there must be.
    """
    if values is None or np.size(values) == 0:
        return np.zeros((0, width), dtype=np.int32)
    table = indices_of(f"{name}s", values, 2, BodyError)
    if table.shape[1] != width:
        raise BodyError(f"{name}s are {extents(table.shape)}; they must be rows of {width}")
    if table.min() < 0 or table.max() >= count:
        wrong = int(table.min() if table.min() < 0 else table.max())
        raise BodyError(f"{a_word(name)} names vertex {wrong}; this animation has vertices 0 to {count - 1}")
    return table


def field_of(name: str, values: npt.ArrayLike | None, frames: int, users: int) -> Single:
    """(F, U, V, 3) in single precision.

    Args:
        name: what messages call it.
        values: what was given.
        frames: F.
        users: U.
    """
    array = numbers_of(name, values, BodyError, kind=np.float32)
    if array.ndim != 4 or array.shape[:2] != (frames, users) or not 1 <= array.shape[3] <= 3 or array.shape[2] == 0:
        raise BodyError(
            f"{name} are {extents(array.shape)}; they must be {frames} frames x {users} users x vertices x axes"
        )
    return padded(array)


def track_of(name: str, values: npt.ArrayLike, count: int) -> Float:
    """(F, count, 3).

    Args:
        name: what messages call it.
        values: what was given.
        count: how many there must be.
    """
    array = numbers_of(name, values, InputError)
    if array.ndim != 3 or array.shape[1] != count or not 1 <= array.shape[2] <= 3:
        raise InputError(f"{name} are {extents(array.shape)}; they must be frames x {count} x axes")
    return padded(array)


def padded(array: Array) -> Array:
    """With zeros for the axes that are missing."""
    missing = 3 - array.shape[-1] if array.ndim else 0
    return np.pad(array, [(0, 0)] * (array.ndim - 1) + [(0, missing)]) if missing > 0 else array


def a_word(name: str) -> str:
    """With its article."""
    return f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def pairs_of(links: Sequence[tuple[int, int]], users: int) -> tuple[tuple[int, int], ...]:
    """Links as pairs of users.

    Args:
        links: two users each, from 0.
        users: how many there are.
    """
    pairs = tuple((int(a), int(b)) for a, b in links)
    for a, b in pairs:
        if not (0 <= a < users and 0 <= b < users) or a == b:
            raise NetworkError(
                f"a link joins user indices {a} and {b}; it must join two different ones of 0 to {users - 1}"
            )
    return pairs
