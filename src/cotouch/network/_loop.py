"""The characteristic matrix of a delayed loop.

`G(s) = diag(m_i s² + b_i s + k_i) - K_ij e^(-s d_ij)` serves two models: the closed loop of all copies, and with
`m = b = 0, k_i = sum_j K_ij` the first-order consensus, whose eigenvalues are `e^(s h)` for time unit h.
"""

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.interrupt import flag
from cotouch.network._network import Network


class Loop(NamedTuple):
    """One loop, link by link.

    Attributes:
        mass: m_i, (N,).
        drag: b_i, (N,).
        rigid: k_i, (N,), the springs of the links included.
        first: one end i of each link, (E,).
        second: the other end j, (E,).
        spring: K_ij, (E,).
        to_first: d_ij in s, the delay from j to i, (E,).
        to_second: d_ji in s, (E,).
        stop: searches end, uncertain, once this is raised, (1,); see `cotouch.interrupt`.
    """

    mass: Float
    drag: Float
    rigid: Float
    first: Long
    second: Long
    spring: Float
    to_first: Float
    to_second: Float
    stop: Long


def loop_of(network: Network, *, mass: Float, drag: Float, ground: Float) -> Loop:
    """The loop that the links of a network close.

    Args:
        network: springs count as scalars.
        mass: (N,).
        drag: (N,).
        ground: (N,), to which the springs of the links are added.
    """
    pairs = np.array(network.links, dtype=np.int64).reshape(-1, 2)
    first, second = np.ascontiguousarray(pairs[:, 0]), np.ascontiguousarray(pairs[:, 1])
    return Loop(
        mass=mass,
        drag=drag,
        rigid=ground + network.linked_spring().sum(axis=1),
        first=first,
        second=second,
        spring=network.spring[first, second],
        to_first=network.delay[first, second],
        to_second=network.delay[second, first],
        stop=flag(),
    )


def characteristic(loop: Loop, s: complex) -> Complex:
    """G(s), (N, N).

    Args:
        loop: the loop.
        s: where, 1/s.
    """
    matrix = np.diag((loop.mass * s + loop.drag) * s + loop.rigid).astype(np.complex128)
    matrix[loop.first, loop.second] = -loop.spring * np.exp(-s * loop.to_first)
    matrix[loop.second, loop.first] = -loop.spring * np.exp(-s * loop.to_second)
    return matrix
