"""Delays as whole numbers of time units, and the period of the cycles they make."""

import math
from typing import Literal, TypeAlias

import numpy as np

from cotouch.arrays import Long
from cotouch.errors import NetworkError
from cotouch.network._checks import one_user
from cotouch.network._network import Network

Convention: TypeAlias = Literal["equation", "matrix"]
Rounding: TypeAlias = Literal["exact", "nearest", "up"]

# How far a delay may be from a whole number of time units, relative to itself: decimal fractions, not real differences.
_WHOLE = 1e-6


def consensus_lags(network: Network, *, time_unit: float, convention: Convention, rounding: Rounding) -> Long:
    """Lags (N, N) of the consensus model in time units, 0 where users are not linked.

    Args:
        network: its links count, its springs do not.
        time_unit: seconds of one step of the model, above 0.
        convention: "equation": the lag is `N_ij` (at least 1), as in the printed equation; "matrix": `N_ij + 1` (`N_ij`
            at least 0), as in the printed J [Lee & Huang 2010, section IV].
        rounding: how a delay becomes `N_ij`: "exact" refuses delays that are not whole numbers of time units, "nearest"
            and "up" round.

    Raises:
        NetworkError: the time unit is not positive, a delay is not whole, or a lag would be 0.
    """
    if not (math.isfinite(time_unit) and time_unit > 0):
        raise NetworkError(f"time_unit is {time_unit:g} s; it must be finite and above 0")
    if convention not in ("equation", "matrix"):
        raise NetworkError(f'convention is "{convention}"; it must be "equation" or "matrix"')
    if rounding not in ("exact", "nearest", "up"):
        raise NetworkError(f'rounding is "{rounding}"; it must be "exact", "nearest" or "up"')
    extra = 1 if convention == "matrix" else 0
    lags = np.zeros((network.size, network.size), dtype=np.int64)
    for a, b in network.links:
        for i, j in ((a, b), (b, a)):
            units = float(network.delay[i, j]) / time_unit
            whole = math.ceil(units - _WHOLE) if rounding == "up" else math.floor(units + 0.5)
            entry = f"delay from {one_user(network.users, j)} to {one_user(network.users, i)}"
            if rounding == "exact" and abs(units - whole) > _WHOLE * max(units, 1.0):
                raise NetworkError(
                    f"{entry} is {network.delay[i, j]:g} s, {units:.6g} time units of {time_unit:g} s; choose a time "
                    'unit that divides it, or rounding "nearest" or "up"'
                )
            if whole + extra < 1:
                raise NetworkError(
                    f"{entry} is {network.delay[i, j]:g} s, which is 0 time units of {time_unit:g} s; the equation "
                    'convention needs at least 1: choose a smaller time unit, rounding "up" or the matrix convention'
                )
            lags[i, j] = whole + extra
    return lags


def cycle_period(lags: Long) -> int:
    """Greatest common divisor of the total lags of all directed cycles of a connected network.

    Exact: with the distance of every user along any tree of arcs, it is the gcd of `distance + lag - distance` over all
    arcs. 1 means that the chain mixes; more means that it returns in step forever.

    Args:
        lags: (N, N), entry [i][j] the lag from j to i, 0 where there is no arc.

    Returns:
        The period; 0 when there are no arcs.
    """
    distance = {0: 0}
    queue = [0]
    for j in queue:
        for i in map(int, np.flatnonzero(lags[:, j])):
            if i not in distance:
                distance[i] = distance[j] + int(lags[i, j])
                queue.append(i)
    return math.gcd(*(distance[int(j)] + int(lags[i, j]) - distance[int(i)] for i, j in np.argwhere(lags)))
