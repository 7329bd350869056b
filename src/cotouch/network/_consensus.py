"""How fast the first-order consensus model mixes [Lee & Huang 2010, section IV]."""

import math
from dataclasses import dataclass
from typing import final

import numpy as np

from cotouch.arrays import Float, Long
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import check
from cotouch.network._lags import Convention, Rounding, consensus_lags, cycle_period
from cotouch.network._loop import Loop, loop_of
from cotouch.network._network import Network
from cotouch.network._resonance import slowest

# Largest lifted matrix for the dense fallback: below ten seconds.
_DENSE_ROWS = 3000


@final
@dataclass(frozen=True)
class Mixing:
    """How fast information spreads.

    Attributes:
        value: second largest |eigenvalue| of the lifted J, 0 to 1; smaller is faster; exactly 1 when periodic.
        cycle_period: gcd of the delays of all cycles in time units; above 1, users echo each other forever and
            never agree.
        time_constant_s: seconds in which what is left to agree on falls by e; inf when periodic, 0 when `value` is 0.
    """

    value: float
    cycle_period: int
    time_constant_s: float


def mixing(
    network: Network, *, time_unit: float, convention: Convention = "equation", rounding: Rounding = "exact"
) -> Mixing:
    """Mixing of the consensus model `p_i(k+1) = sum_j W_ij p_j(k+1-N_ij)`, `W_ij = K_ij / sum_j K_ij`.

    J has the eigenvalues z with `det(I - W_ij z^-N_ij) = 0` [Lee & Huang 2010, section IV]. In `s = log z` over the
    time unit these are the roots of a loop with delays. One as slow as the slowest can only lie where the delays of all
    links nearly resonate; in those few windows of frequency the argument principle counts the roots and Newton finds as
    many, so none is missed, and a finer time unit costs little.

    Args:
        network: connected, at least 2 users. Of springs with weights the strengths count.
        time_unit: seconds of one step of the model.
        convention: "equation" (lag `N_ij`, at least 1) or "matrix" (lag `N_ij + 1`): the printed equation and the
            printed J differ by that step.
        rounding: "exact" refuses delays that are not whole numbers of time units; "nearest" and "up" round them.

    Raises:
        NetworkError: not connected, fewer than 2 users, or a delay that the time unit or the convention does not allow.
        UnsupportedError: too large and too ill-conditioned for the polynomial, which no ordinary network is.
    """
    if network.size < 2:
        raise NetworkError("the network has 1 user; mixing needs at least 2")
    if not network.is_connected():
        raise NetworkError(
            f"the links leave {len(network.components())} separate groups of users, which never agree; link them"
        )
    lags = consensus_lags(network, time_unit=time_unit, convention=convention, rounding=rounding)
    period = cycle_period(lags)
    if period > 1:
        return Mixing(value=1.0, cycle_period=period, time_constant_s=math.inf)
    value = _second_modulus(network, lags, time_unit)
    return Mixing(value=value, cycle_period=period, time_constant_s=-time_unit / math.log(value) if value > 0 else 0.0)


def lifted_matrix(weights: Float, lags: Long) -> Float:
    """The chain as one square matrix, keeping of each user only the history that others still need.

    Args:
        weights: (N, N) row-stochastic.
        lags: (N, N) in steps, at least 1 where `weights` is not 0.

    Returns:
        (n, n) with n the sum over users of their longest outgoing lag. Its eigenvalues are those of the printed J but
        for zeros.
    """
    history = np.maximum(lags.max(axis=0), 1)
    first = np.concatenate([[0], np.cumsum(history)])
    matrix = np.zeros((int(first[-1]), int(first[-1])))
    for i in range(len(lags)):
        for j in np.flatnonzero(lags[i]):
            matrix[first[i], first[j] + lags[i, j] - 1] += weights[i, j]
        for age in range(1, int(history[i])):
            matrix[first[i] + age, first[i] + age - 1] = 1.0
    return matrix


def _second_modulus(network: Network, lags: Long, time_unit: float) -> float:
    """Second largest |eigenvalue| of an aperiodic chain."""
    loop = consensus_loop(network, lags, time_unit)
    root, certain, _ = slowest(loop, math.pi / time_unit, np.zeros(0, dtype=np.complex128))
    check()
    if certain:
        return math.exp(root.real * time_unit)
    rows = int(lags.max(axis=0).sum())
    if rows > _DENSE_ROWS:
        raise UnsupportedError(
            f"the lifted matrix has {rows} rows and eigenvalues too close to tell apart; choose a larger time unit"
        )
    spring = network.linked_spring()
    matrix = lifted_matrix(spring / spring.sum(axis=1, keepdims=True), lags)
    return float(np.sort(np.abs(np.linalg.eigvals(matrix)))[-2])


def consensus_loop(network: Network, lags: Long, time_unit: float) -> Loop:
    """The consensus model as a loop without masses, whose delays are the lags times the time unit.

    Args:
        network: of the users.
        lags: (N, N) in time units.
        time_unit: [s].
    """
    nothing = np.zeros(network.size)
    loop = loop_of(network, mass=nothing, drag=nothing, ground=nothing)
    return loop._replace(
        to_first=lags[loop.first, loop.second] * time_unit, to_second=lags[loop.second, loop.first] * time_unit
    )
