"""Tables of measured round trips, and the delays that follow from them."""

import csv
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from cotouch.arrays import Bool, Float
from cotouch.errors import NetworkError
from cotouch.files import read_text

_MOST_USERS = 2000


def read_round_trips(path: str | Path, pick: Sequence[str] = ()) -> tuple[tuple[str, ...], Float]:
    """A table of round trips in ms: the first row and column are names, an empty field was not measured.

    Args:
        path: of a CSV file.
        pick: names of the users between whom fields are read; others may hold anything. Empty: all are read.

    Returns:
        The names, and round trips in s, (N, N), row from, column to, NaN where not measured or not picked.

    Raises:
        NetworkError: the file cannot be read, or something in it is wrong; the message names the place.
    """
    source = Path(path)
    text = read_text(source, "table of round trips", NetworkError)
    rows = [row for row in csv.reader(text.splitlines(), skipinitialspace=True) if row]
    if len(rows) < 2:
        raise NetworkError(
            f"{source} has no round trips; its first row and column must be names, its fields times in ms"
        )
    names = [name.strip() for name in rows[0][1:]]
    if len(names) > _MOST_USERS:
        raise NetworkError(f"{source} names {len(names)} users; it may name at most {_MOST_USERS}")
    if [row[0].strip() for row in rows[1:]] != names:
        raise NetworkError(f"{source}: the first row and the first column must hold the same names in the same order")
    for name in names:
        if not name or names.count(name) > 1:
            raise NetworkError(
                f'{source}: the name "{name}" is empty or occurs twice; every user needs a different name'
            )
    table = np.full((len(names), len(names)), math.nan)
    for i, row in enumerate(rows[1:]):
        if len(row) != len(names) + 1:
            raise NetworkError(
                f'{source}: the row of "{names[i]}" has {len(row) - 1} fields; it must have {len(names)}'
            )
        for j, field in enumerate(row[1:]):
            if not field.strip() or i == j or (pick and not {names[i], names[j]} <= set(pick)):
                continue
            try:
                value = float(field)
            except ValueError:
                value = math.nan
            if not (math.isfinite(value) and value >= 0):
                raise NetworkError(
                    f'{source}: the round trip from "{names[i]}" to "{names[j]}" is "{field.strip()}"; it must be a '
                    "number of ms, at least 0, or empty"
                )
            table[i, j] = 1e-3 * value
    return tuple(names), table


def delays_of_round_trips(
    paths: Sequence[str | Path], pick: Sequence[str], quantile: float
) -> tuple[list[str], Float, Bool]:
    """Half of the round trip as the delay of each direction.

    Args:
        paths: tables as `read_round_trips` takes them, with the same names: measured at different times, say.
        pick: names of the users to take; none takes all.
        quantile: of what was measured of one pair, both ways and in all tables.

    Returns:
        Names, delays in s, (N, N), and which of them were measured, one way or the other.

    Raises:
        NetworkError: a table is wrong, tables or picks name others, or a value is out of its range.
    """
    if not paths:
        raise NetworkError("no table of round trips is given")
    if not 0 <= quantile <= 1:
        raise NetworkError(f"quantile is {quantile:g}; it must be between 0 and 1")
    tables = [read_round_trips(path, pick) for path in paths]
    names = tables[0][0]
    for path, (others, _) in zip(paths, tables, strict=True):
        if others != names:
            raise NetworkError(f"{path} names other users than {paths[0]}; tables must name the same in the same order")
    chosen = list(names)
    if pick:
        chosen = list(pick)
        for name in chosen:
            if name not in names:
                raise NetworkError(f'pick holds "{name}", which {paths[0]} does not name')
            if chosen.count(name) > 1:
                raise NetworkError(f'pick holds "{name}" twice; name each user once')
    at = np.array([names.index(name) for name in chosen])
    trips = np.stack([table[np.ix_(at, at)] for _, table in tables])
    both = np.concatenate([trips, trips.transpose(0, 2, 1)])
    measured = (~np.isnan(both)).any(axis=0) & ~np.eye(len(chosen), dtype=np.bool_)
    delay = np.zeros_like(trips[0])
    for i, j in np.argwhere(measured):
        delay[i, j] = 0.5 * np.nanquantile(both[:, i, j], quantile)
    return chosen, delay, measured
