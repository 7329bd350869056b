"""The `[network]` table of a TOML file, up to the arguments of the constructor."""

from collections.abc import Mapping
from pathlib import Path
from typing import cast

from cotouch.errors import NetworkError
from cotouch.files import read_toml, table_of
from cotouch.units import user_index

_REQUIRED = ("users", "spring", "delay")
_OPTIONAL = ("links", "weight")


def read_table(path: Path) -> Mapping[str, object]:
    """The `[network]` table of the TOML file at `path`, unchecked inside.

    Raises:
        NetworkError: the file cannot be read, is not TOML, or has no such table.
    """
    table = table_of(read_toml(path, "network", NetworkError).get("network"))
    if table is None:
        raise NetworkError(f"{path}: there is no table [network]; it must hold {', '.join(_REQUIRED)}")
    return table


def arguments(given: object, source: str) -> dict[str, object]:
    """Arguments of the constructor from a table, with links counted from 0.

    Args:
        given: the table as read.
        source: what messages call the file.

    Raises:
        NetworkError: a key is unknown or missing, or `links` is not a list of pairs of whole numbers.
    """
    if not isinstance(given, Mapping):
        raise NetworkError(f"{source}: network is {given!r}; it must be a table with {', '.join(_REQUIRED)}")
    table = cast("Mapping[str, object]", given)
    for key in table:
        if key not in _REQUIRED + _OPTIONAL:
            raise NetworkError(
                f'{source}: [network] has no key "{key}"; its keys are {", ".join(_REQUIRED + _OPTIONAL)}'
            )
    for key in _REQUIRED:
        if key not in table:
            raise NetworkError(f'{source}: [network] lacks the key "{key}"; it must hold {", ".join(_REQUIRED)}')
    users = table["users"]
    if not isinstance(users, list | tuple):
        raise NetworkError(f"{source}: users is {users!r}; it must be a list of names, one for each user")
    found = dict(table)
    if "links" in found:
        found["links"] = _links(found["links"], source, len(cast("list[object]", users)))
    return found


def _links(links: object, source: str, users: int) -> list[tuple[int, int]]:
    if not isinstance(links, list | tuple):
        raise NetworkError(
            f"{source}: links is {links!r}; it must be a list of pairs of user numbers, such as [[1, 2]]"
        )
    pairs: list[tuple[int, int]] = []
    for link in cast("list[object]", links):
        match link:
            case [int(i), int(j)] if not isinstance(i, bool) and not isinstance(j, bool):
                for end in (i, j):
                    if not 1 <= end <= users:
                        raise NetworkError(
                            f"{source}: links: [{i}, {j}] names user {end}; users are numbered 1 to {users}"
                        )
                pairs.append((user_index(i), user_index(j)))
            case _:
                raise NetworkError(f"{source}: links: {link!r} is not a link; a link is a pair of user numbers from 1")
    return pairs
