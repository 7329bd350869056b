"""What users, springs, delays, weights and links must be, checked once, with errors that name the entry."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Long, extents, has_truth
from cotouch.errors import NetworkError, printable
from cotouch.network._types import Pair
from cotouch.units import user_number

# A difference this small beside the larger of two numbers is the round-off of whoever computed them.
_ROUND_OFF = 1e-12


class Springs(NamedTuple):
    """Springs in the stored form: `K_ij = strength[i, j] * weights[weight_of[i, j]]`, -1 being the identity."""

    strength: Float
    weights: tuple[Float, ...]
    weight_of: Long


def one_user(users: Sequence[str], i: int) -> str:
    """A user as messages say it: `user 2 ("Ann")`, or `user 2` where the name is the number.

    Args:
        users: names.
        i: index.
    """
    number = str(user_number(i))
    return f"user {number}" if users[i] == number else f'user {number} ("{users[i]}")'


def two_users(users: Sequence[str], i: int, j: int) -> str:
    """A pair as messages say it.

    Args:
        users: names.
        i: index of one.
        j: of the other.
    """
    return f"{one_user(users, i)} and {one_user(users, j)}"


def check_users(users: Iterable[str]) -> tuple[str, ...]:
    """Names of the users: at least one, none empty, no two alike."""
    if isinstance(users, str):
        raise NetworkError(f'users is the string "{users}"; it must be a list of names, one for each user')
    try:
        names = tuple(users)
    except TypeError:
        raise NetworkError(f"users is {users!r}; it must be a list of names, one for each user") from None
    if not names:
        raise NetworkError("users is empty; a network has at least one user")
    for i, name in enumerate(names):
        if not isinstance(name, str) or not name.strip():  # pyright: ignore[reportUnnecessaryIsInstance]
            raise NetworkError(f"users: the name of user {user_number(i)} is {name!r}; it must be a non-empty string")
        if printable(name) != name:
            raise NetworkError(
                f"users: the name of user {user_number(i)} is {name!r}; it must be one line of printable characters"
            )
        if name in names[:i]:
            first = user_number(names.index(name))
            raise NetworkError(
                f'users: "{name}" names both user {first} and user {user_number(i)}; every name must be different'
            )
    return names


def check_delay(users: tuple[str, ...], delay: npt.ArrayLike) -> Float:
    """Delays in seconds, (N, N), entry [i][j] from j to i: finite, at least 0, and 0 on the diagonal.

    Args:
        users: names.
        delay: what was given.
    """
    matrix = numbers("delay", delay)
    size = len(users)
    if matrix.shape != (size, size):
        raise NetworkError(
            f"delay is {extents(matrix.shape)}; for {size} user{'s' * (size != 1)} it must be {size} x {size}"
        )
    for i, j in np.argwhere(~(np.isfinite(matrix) & (matrix >= 0))):
        raise NetworkError(
            f"delay from {one_user(users, j)} to {one_user(users, i)} is {matrix[i, j]:g} s; "
            "it must be finite and at least 0"
        )
    for i in map(int, np.flatnonzero(np.diag(matrix))):
        raise NetworkError(
            f"delay from {one_user(users, i)} to itself is {matrix[i, i]:g} s; the diagonal of delay must be 0"
        )
    return matrix


def check_springs(users: tuple[str, ...], spring: npt.ArrayLike, weight: npt.ArrayLike | None) -> Springs:
    """Springs in N/m as (N, N) strengths with at most one common `weight`, or as (N, N, r, r) matrices.

    Args:
        users: names.
        spring: what was given.
        weight: common to all springs; None: the identity.
    """
    matrix = numbers("spring", spring)
    size = len(users)
    if matrix.shape == (size, size):
        strength = _scalar_springs(users, matrix)
        weights: tuple[Float, ...] = ()
        weight_of = np.full((size, size), -1, dtype=np.int64)
        if weight is not None:
            unit = numbers("weight", weight)
            if unit.ndim != 2 or unit.shape[0] != unit.shape[1] or unit.shape[0] == 0:
                raise NetworkError(f"weight is {extents(unit.shape)}; it must be a square matrix")
            unit = _spd("weight", unit)
            if not np.array_equal(unit, np.eye(len(unit))):
                weights = (unit,)
                weight_of[strength > 0] = 0
        return Springs(strength, weights, weight_of)
    if matrix.ndim == 4 and matrix.shape[:2] == (size, size) and matrix.shape[2] == matrix.shape[3] > 0:
        if weight is not None:
            raise NetworkError("weight is given together with a matrix for every spring; give only one of them")
        return _matrix_springs(users, matrix)
    raise NetworkError(
        f"spring is {extents(matrix.shape)}; for {size} user{'s' * (size != 1)} it must be {size} x {size}, or "
        f"{size} x {size} x r x r with one r x r matrix for every pair"
    )


def check_links(users: tuple[str, ...], strength: Float, links: Iterable[Sequence[int]] | None) -> tuple[Pair, ...]:
    """Links as sorted pairs of indices; None means every pair with a spring.

    Args:
        users: names.
        strength: of the springs, (N, N) [N/m].
        links: what was given, pairs of indices.
    """
    if links is None:
        return tuple((int(i), int(j)) for i, j in np.argwhere(np.triu(strength) > 0))
    chosen: set[Pair] = set()
    for link in links:
        i, j = _pair(users, link)
        if (i, j) in chosen:
            raise NetworkError(f"links: the link between {two_users(users, i, j)} is given twice; give each link once")
        if strength[i, j] <= 0:
            raise NetworkError(
                f"links: {two_users(users, i, j)} are linked but their spring is 0 N/m; "
                "give them a spring or drop the link"
            )
        chosen.add((i, j))
    return tuple(sorted(chosen))


def _pair(users: tuple[str, ...], link: Sequence[int]) -> Pair:
    try:
        i, j = (int(end) for end in link if int(end) == end)
    except (TypeError, ValueError):
        raise NetworkError(f"links: {link!r} is not a link; a link is a pair of users") from None
    for end in (i, j):
        if not 0 <= end < len(users):
            raise NetworkError(
                f"links: ({i}, {j}) holds the index {end}; users have the indices 0 to {len(users) - 1}, which "
                f"files number 1 to {len(users)}"
            )
    if i == j:
        raise NetworkError(f"links: {one_user(users, i)} is linked to itself; a link joins two different users")
    return (i, j) if i < j else (j, i)


def _scalar_springs(users: tuple[str, ...], matrix: Float) -> Float:
    for i, j in np.argwhere(~(np.isfinite(matrix) & (matrix >= 0))):
        raise NetworkError(
            f"spring between {two_users(users, i, j)} is {matrix[i, j]:g} N/m; it must be finite and at least 0"
        )
    for i in map(int, np.flatnonzero(np.diag(matrix))):
        raise NetworkError(
            f"spring between {one_user(users, i)} and itself is {matrix[i, i]:g} N/m; the diagonal of spring must be 0"
        )
    for i, j in np.argwhere(np.abs(matrix - matrix.T) > _ROUND_OFF * np.maximum(matrix, matrix.T)):
        raise NetworkError(
            f"spring is not symmetric: {two_users(users, i, j)} have {matrix[i, j]:.9g} N/m one way and "
            f"{matrix[j, i]:.9g} N/m the other; K_ij and K_ji must be equal"
        )
    return matrix / 2 + matrix.T / 2


def _matrix_springs(users: tuple[str, ...], blocks: Float) -> Springs:
    """Splits every matrix into its mean eigenvalue and a unit matrix, and keeps each unit matrix once."""
    size, rows = blocks.shape[0], blocks.shape[2]
    strength = np.zeros((size, size))
    weight_of = np.full((size, size), -1, dtype=np.int64)
    units: list[Float] = []
    for i in range(size):
        if np.any(blocks[i, i]):
            raise NetworkError(
                f"spring between {one_user(users, i)} and itself is not 0; the diagonal of spring must be 0"
            )
        for j in range(i + 1, size):
            name = f"spring between {two_users(users, i, j)}"
            if not np.all(np.isfinite(blocks[[i, j], [j, i]])):
                raise NetworkError(f"{name} has an entry that is not finite; every entry must be a finite number")
            scale = np.abs(blocks[[i, j], [j, i]]).max()
            if scale == 0:
                continue
            unequal = np.argwhere(np.abs(blocks[i, j] - blocks[j, i]) > _ROUND_OFF * scale)
            for p, q in unequal:
                raise NetworkError(
                    f"spring is not symmetric: {two_users(users, i, j)} have matrices that differ at [{p}, {q}], "
                    f"{blocks[i, j, p, q]:.9g} N/m one way and {blocks[j, i, p, q]:.9g} N/m the other; "
                    "K_ij and K_ji must be equal"
                )
            block = _spd(name, blocks[i, j])
            strength[i, j] = strength[j, i] = np.trace(block) / rows
            weight_of[i, j] = weight_of[j, i] = _unit_index(block / strength[i, j], units)
    return Springs(strength, tuple(units), weight_of)


def _unit_index(unit: Float, units: list[Float]) -> int:
    if np.allclose(unit, np.eye(len(unit)), rtol=0, atol=_ROUND_OFF):
        return -1
    for index, known in enumerate(units):
        if np.allclose(unit, known, rtol=0, atol=_ROUND_OFF):
            return index
    units.append(unit)
    return len(units) - 1


def _spd(name: str, matrix: Float) -> Float:
    if not np.all(np.isfinite(matrix)):
        raise NetworkError(f"{name} has an entry that is not finite; every entry must be a finite number")
    for p, q in np.argwhere(np.abs(matrix - matrix.T) > _ROUND_OFF * np.abs(matrix).max()):
        raise NetworkError(
            f"{name} is not a symmetric matrix: entry [{p}, {q}] is {matrix[p, q]:.9g} but [{q}, {p}] is "
            f"{matrix[q, p]:.9g}; they must be equal"
        )
    smallest, largest = np.linalg.eigvalsh(matrix)[[0, -1]]
    if smallest <= _ROUND_OFF * abs(largest):
        raise NetworkError(
            f"{name} is not positive definite: its smallest eigenvalue is {smallest:.6g}; "
            "every eigenvalue must be above 0"
        )
    return matrix / 2 + matrix.T / 2


def numbers(name: str, values: npt.ArrayLike) -> Float:
    """A copy of real numbers, [row for each user]; what Python would count as some, such as true, is refused.

    Args:
        name: of what they are, for the message.
        values: anything.

    Raises:
        NetworkError: they are no array of real numbers.
    """
    try:
        found = np.array(values)
    except (TypeError, ValueError):
        found = np.empty(0, dtype=object)
    if found.dtype.kind not in "iuf" or has_truth(values):
        raise NetworkError(f"{name} is not an array of real numbers; give one row of numbers for each user")
    return found.astype(np.float64)
