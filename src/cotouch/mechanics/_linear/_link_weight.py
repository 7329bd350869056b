"""A link weight in the rows of a body."""

from collections.abc import Sequence

import numpy as np
import scipy.sparse as sp

from cotouch.body import Body, Matrix
from cotouch.errors import BodyError


def fit_weights(body: Body, weights: Sequence[Matrix]) -> tuple[list[sp.csr_array], bool]:
    """Weights in rows of the body, and whether any needs the full form.

    Args:
        body: the body.
        weights: n x n, nd x nd or d x d.

    Raises:
        BodyError: one is of another size.
    """
    fitted = [_fitted(body, index, weight) for index, weight in enumerate(weights, start=1)]
    return [matrix for matrix, _ in fitted], any(full for _, full in fitted)


def _fitted(body: Body, index: int, weight: Matrix) -> tuple[sp.csr_array, bool]:
    """Of one, with its number for messages."""
    csr = sp.csr_array(weight if sp.issparse(weight) else np.atleast_2d(np.asarray(weight, dtype=np.float64)))
    n, d = body.nodes, body.dimension
    size = csr.shape[0] if csr.shape[0] == csr.shape[1] else 0
    if size == n * d and d > 1 and size != n:
        return csr, True
    if size == n and not (n == d and d > 1):
        return (sp.csr_array(sp.kron(csr, sp.eye_array(d))) if body.form == "full" else csr), False
    if size == d and n != d:
        return sp.csr_array(sp.kron(sp.eye_array(n), csr)), True
    wanted = " or ".join(dict.fromkeys(f"{s} x {s}" for s in ((n * d,) if n == d else (n, d, n * d))))
    raise BodyError(f"link weight {index} is {csr.shape[0]} x {csr.shape[1]}; for this body it must be {wanted}")
