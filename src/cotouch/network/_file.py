"""The `[network]` table of a TOML file, up to the arguments of the constructor."""

import tomllib
from collections.abc import Mapping
from pathlib import Path

from cotouch.errors import NetworkError
from cotouch.units import user_index

_REQUIRED = ("users", "spring", "delay")
_OPTIONAL = ("links", "weight")


def read_table(path: Path) -> Mapping[str, object]:
    """The `[network]` table of the TOML file at `path`, unchecked inside.

    Raises:
        NetworkError: the file cannot be read, is not TOML, or has no such table.
    """
    try:
        tables = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise NetworkError(f"{path}: there is no such file") from None
    except OSError as error:
        raise NetworkError(f"{path}: the file cannot be read ({error.strerror})") from None
    except UnicodeDecodeError:
        raise NetworkError(f"{path}: the file is not UTF-8 text; it must be TOML") from None
    except tomllib.TOMLDecodeError as error:
        raise NetworkError(f"{path}: the file is not TOML ({error})") from None
    table = tables.get("network")
    if not isinstance(table, dict):
        raise NetworkError(f"{path}: there is no table [network]; it must hold {', '.join(_REQUIRED)}")
    return table


def arguments(table: Mapping[str, object], source: str) -> dict[str, object]:
    """Arguments of the constructor from a table, with links counted from 0.

    Raises:
        NetworkError: a key is unknown or missing, or `links` is not a list of pairs of whole numbers.
    """
    for key in table:
        if key not in _REQUIRED + _OPTIONAL:
            raise NetworkError(
                f'{source}: [network] has no key "{key}"; its keys are {", ".join(_REQUIRED + _OPTIONAL)}'
            )
    for key in _REQUIRED:
        if key not in table:
            raise NetworkError(f'{source}: [network] lacks the key "{key}"; it must hold {", ".join(_REQUIRED)}')
    if not isinstance(table["users"], list | tuple):
        raise NetworkError(f"{source}: users is {table['users']!r}; it must be a list of names, one for each user")
    found = dict(table)
    if "links" in found:
        found["links"] = _links(found["links"], source)
    return found


def _links(links: object, source: str) -> list[tuple[int, int]]:
    if not isinstance(links, list | tuple):
        raise NetworkError(
            f"{source}: links is {links!r}; it must be a list of pairs of user numbers, such as [[1, 2]]"
        )
    pairs: list[tuple[int, int]] = []
    for link in links:
        match link:
            case [int(i), int(j)] if not isinstance(i, bool) and not isinstance(j, bool):
                pairs.append((user_index(i), user_index(j)))
            case _:
                raise NetworkError(f"{source}: links: {link!r} is not a link; a link is a pair of user numbers from 1")
    return pairs
