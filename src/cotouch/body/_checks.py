"""What a matrix of a body must be, checked once, with an error that says which entry or eigenvalue is wrong."""

from typing import Literal, TypeAlias

import numpy as np
import numpy.typing as npt
import scipy.linalg as la
import scipy.sparse as sp

from cotouch.errors import BodyError

Matrix: TypeAlias = npt.ArrayLike | sp.sparray | sp.spmatrix

# A negative eigenvalue this small beside the largest one is the round-off of whoever assembled the matrix.
_ROUND_OFF = 1e-10
# Up to here a dense eigenvalue solve takes well under a second.
_DENSE_ROWS = 800

Form = Literal["node", "full"]


def square(name: str, matrix: Matrix, *, sizes: dict[int, Form]) -> sp.csr_array:
    """Reads a symmetric matrix whose size is one of `sizes`.

    Args:
        name: what messages call the matrix.
        matrix: dense or sparse, (rows, rows).
        sizes: allowed numbers of rows, and the form that each means.

    Returns:
        The matrix as float64 CSR with exact symmetry, without stored zeros.

    Raises:
        BodyError: wrong shape, not finite, or not symmetric.
    """
    try:
        csr = sp.csr_array(matrix if sp.issparse(matrix) else np.atleast_2d(np.asarray(matrix)), dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise BodyError(f"{name} is not a matrix of real numbers ({error}); give a dense or sparse one") from error
    allowed = " or ".join(f"{rows} x {rows}" for rows in sizes)
    if csr.ndim != 2 or csr.shape[0] != csr.shape[1] or csr.shape[0] not in sizes:
        shape = " x ".join(str(extent) for extent in csr.shape)
        raise BodyError(f"{name} is {shape}; for this body it must be {allowed}")
    csr.sum_duplicates()
    csr.eliminate_zeros()
    coo = csr.tocoo()
    bad = np.flatnonzero(~np.isfinite(coo.data))
    if bad.size:
        at = bad[0]
        raise BodyError(f"{name}[{coo.row[at]}, {coo.col[at]}] is {coo.data[at]}; every entry must be a finite number")
    skew = (csr - csr.T).tocoo()
    if skew.nnz:
        at = int(np.argmax(np.abs(skew.data)))
        i, j = int(skew.row[at]), int(skew.col[at])
        if abs(skew.data[at]) > _ROUND_OFF * np.abs(csr.data).max():
            raise BodyError(
                f"{name} is not symmetric: {name}[{i}, {j}] = {csr[i, j]:.9g} but {name}[{j}, {i}] = {csr[j, i]:.9g}; "
                "they must be equal"
            )
    return sp.csr_array((csr + csr.T) / 2)


def diagonal(name: str, matrix: sp.csr_array) -> None:
    """Refuses a matrix that is not diagonal with entries >= 0 (what binds a node to the ground binds nothing else)."""
    coo = matrix.tocoo()
    off = np.flatnonzero((coo.row != coo.col) & (coo.data != 0.0))
    if off.size:
        at = off[0]
        raise BodyError(
            f"{name}[{coo.row[at]}, {coo.col[at]}] is {coo.data[at]:.9g}; {name} binds nodes to the ground, "
            "so it must be diagonal"
        )
    low = np.flatnonzero(coo.data < 0.0)
    if low.size:
        at = low[0]
        raise BodyError(f"{name}[{coo.row[at]}, {coo.row[at]}] is {coo.data[at]:.9g}; it must be 0 or more")


def positive(name: str, matrix: sp.csr_array, *, strictly: bool) -> None:
    """Refuses a symmetric matrix that is not positive (semi)definite, naming its smallest eigenvalue.

    Raises:
        BodyError: the smallest eigenvalue is negative, or zero where `strictly`.
    """
    diagonal_values = matrix.diagonal()
    outer = np.asarray(abs(matrix).sum(axis=1)).ravel() - np.abs(diagonal_values)
    gershgorin = diagonal_values - outer
    size = float(np.abs(diagonal_values).max(initial=0.0))
    # Gershgorin's circles settle every lattice and chain at once; only other matrices need an eigenvalue.
    if gershgorin.min(initial=np.inf) > (_ROUND_OFF * size if strictly else -_ROUND_OFF * size):
        return
    smallest = _smallest_eigenvalue(matrix)
    if smallest > _ROUND_OFF * size if strictly else smallest >= -_ROUND_OFF * max(size, 1e-300):
        return
    wanted = "positive definite (every eigenvalue > 0)" if strictly else "positive semidefinite (no eigenvalue < 0)"
    raise BodyError(f"the smallest eigenvalue of {name} is {smallest:.6g}; {name} must be {wanted}")


def _smallest_eigenvalue(matrix: sp.csr_array) -> float:
    rows = matrix.shape[0]
    if rows <= _DENSE_ROWS:
        return float(la.eigvalsh(matrix.toarray(), subset_by_index=[0, 0])[0])
    from scipy.sparse.linalg import eigsh

    start = np.cos(np.arange(rows) * 1.618)  # any fixed vector; a random one would make messages differ between runs
    top = float(eigsh(matrix, k=1, which="LA", v0=start, tol=1e-3, return_eigenvectors=False)[0])
    flipped = top * sp.eye_array(rows, format="csr") - matrix
    return top - float(eigsh(flipped, k=1, which="LA", v0=start, tol=1e-12, return_eigenvectors=False)[0])
