"""Damping of every user as coefficients of the identity and of the weights of the springs.

An array `beta` of shape (N, 1 + number of weights) in Ns/m stands for

    B_i = beta[i, 0] I + sum_w beta[i, 1 + w] network.weights[w].
"""

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.network._checks import numbers, one_user
from cotouch.network._network import Network


def coefficients(network: Network, damping: npt.ArrayLike) -> Float:
    """Damping as (N, 1 + number of weights), from that form or from (N,) where one weight (or none) serves all links.

    Args:
        network: of the users.
        damping: of the users, in either form [Ns/m].

    Raises:
        NetworkError: another shape, an entry that is negative or not finite, or (N,) where links have different
            weights.
    """
    values = numbers("damping", damping)
    columns = 1 + len(network.weights)
    if values.shape == (network.size,):
        used = {int(network.weight_of[i, j]) for i, j in network.links}
        if len(used) > 1:
            raise NetworkError(
                f"damping has one number for each user, but the links have {len(used)} different weights; give it as "
                f"({network.size}, {columns})"
            )
        spread = np.zeros((network.size, columns))
        spread[:, 1 + (used.pop() if used else -1)] = values
        values = spread
    if values.shape != (network.size, columns):
        raise NetworkError(
            f"damping has shape {values.shape}; it must be ({network.size}, {columns}): users by identity and weights"
        )
    for i, w in np.argwhere(~(np.isfinite(values) & (values >= 0))):
        raise NetworkError(
            f"damping of {one_user(network.users, int(i))} is {values[i, w]:g} Ns/m; it must be finite and at least 0"
        )
    return values


def damping_matrices(network: Network, damping: npt.ArrayLike, *, rows: int | None = None) -> Float:
    """`B_i` as matrices (N, rows, rows) in Ns/m; `rows` is that of the weights, or 1, unless given.

    Args:
        network: of the users.
        damping: of the users, (N,) or by weights [Ns/m].
        rows: of the matrices.
    """
    beta = coefficients(network, damping)
    rows = rows if rows is not None else (network.weight_rows or 1)
    if network.weight_rows not in (None, rows):
        raise NetworkError(f"rows is {rows}; it must be {network.weight_rows}, as the weights of the springs have")
    units = np.stack([np.eye(rows), *network.weights])
    return np.einsum("iw,wpq->ipq", beta, units)


def link_matrices(network: Network) -> Float:
    """`K_ij` of every link as matrices (links, r, r) in N/m, with r = 1 where no spring has a weight."""
    rows = network.weight_rows or 1
    units = np.stack([np.eye(rows), *network.weights])
    ends = np.array(network.links, dtype=np.int64).reshape(-1, 2)
    strength = network.spring[ends[:, 0], ends[:, 1]]
    return strength[:, None, None] * units[network.weight_of[ends[:, 0], ends[:, 1]] + 1]


def single_weight(network: Network, beta: Float) -> int | None:
    """The one column of `beta` that all links and damping use, so that the problem is scalar; None if there is none.

    Args:
        network: of the users.
        beta: damping, (N, 1 + number of weights) [Ns/m].
    """
    used = {int(network.weight_of[i, j]) + 1 for i, j in network.links}
    used |= {int(w) for w in np.flatnonzero(beta.any(axis=0))}
    return (used.pop() if used else 0) if len(used) <= 1 else None


def inverse_roots(matrices: Float) -> Float:
    """`B^(-1/2)` of SPD matrices (n, r, r); inf on the diagonal of those that are 0."""
    size, vectors = np.linalg.eigh(matrices)
    with np.errstate(divide="ignore"):
        root = 1.0 / np.sqrt(np.maximum(size, 0.0))
    if not np.isfinite(root).all():
        root = np.where(np.isfinite(root).all(axis=1, keepdims=True), root, 0.0)
        inverse = (vectors * root[:, None, :]) @ vectors.transpose(0, 2, 1)
        inverse[~root.any(axis=1)] = np.diag(np.full(int(matrices.shape[-1]), np.inf))
        return inverse
    return (vectors * root[:, None, :]) @ vectors.transpose(0, 2, 1)
