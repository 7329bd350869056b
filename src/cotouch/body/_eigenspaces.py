"""Shapes that are the same on every machine, whatever its linear algebra makes of equal eigenvalues."""

from itertools import pairwise

import numpy as np
import scipy.sparse as sp

from cotouch.arrays import Float


def canonical(values: Float, shapes: Float, mass: "sp.csr_array | Float", closeness: Float | float) -> Float:
    """The basis of each eigenspace that depends on nothing but the space.

    The sign of a shape, and the shapes of equal eigenvalues altogether, are a matter of round-off, so they differ from
    one processor to the next. Here fixed vectors are projected onto each space and orthonormalised in their order.

    Args:
        values: (count,) eigenvalues, ascending.
        shapes: (rows, count) of them, `ΦᵀMΦ = 1`.
        mass: M.
        closeness: (count - 1,) or one: eigenvalues of which neighbours differ by no more than this are one.

    Returns:
        (rows, count), `ΦᵀMΦ = 1`; any orthogonal mixture of the shapes of equal eigenvalues gives the same.
    """
    edges = [0, *(np.flatnonzero(np.diff(values) > closeness) + 1).tolist(), values.size]
    # No pattern that shapes of a regular body could be blind to, and the same from every version of every library.
    chirp = np.arange(1.0, shapes.shape[0] + 1.0) ** 2
    result = np.empty_like(shapes)
    weighted = mass @ shapes
    for begin, end in pairwise(edges):
        of_fixed = weighted[:, begin:end].T @ np.sin(chirp[:, None] * np.arange(1.0, end - begin + 1.0))
        turn, triangle = np.linalg.qr(of_fixed)
        result[:, begin:end] = shapes[:, begin:end] @ (turn * np.where(np.diag(triangle) < 0.0, -1.0, 1.0))
    return result
