"""What a matrix of a body must be, checked once, with an error that says which entry or eigenvalue is wrong."""

from dataclasses import dataclass
from typing import Literal, TypeAlias, cast, final

import numpy as np
import numpy.typing as npt
import scipy.linalg as la
import scipy.sparse as sp
from scipy.sparse.linalg import SuperLU, splu

from cotouch.arrays import Float, extents
from cotouch.errors import BodyError

Matrix: TypeAlias = npt.ArrayLike | sp.sparray | sp.spmatrix

# A negative eigenvalue this small beside the largest one is the round-off of whoever assembled the matrix.
_ROUND_OFF = 1e-10
# Up to here a dense eigenvalue solve takes well under a second.
_DENSE_ROWS = 800
# Up to here a dense array is read faster than SciPy builds its sparse ones.
_SMALL_ROWS = 64

Form = Literal["node", "full"]


@final
@dataclass(frozen=True, eq=False)
class SumOfSquares:
    """A matrix that its builder knows to be positive semidefinite, because it is a sum of such: one for each element.

    Only conditions that cost one pass are then tested. Factorising the stiffness of 20,000 nodes in three dimensions,
    which is what proves it for a matrix of unknown descent, takes two minutes and six gigabytes.
    """

    matrix: sp.csr_array


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
    small = _small(matrix, sizes)
    if small is not None:
        return small
    try:
        given = matrix if sp.issparse(matrix) else np.atleast_2d(np.asarray(matrix))
        real = not np.iscomplexobj(given)
        csr = sp.csr_array(given, dtype=np.float64 if real else np.complex128, copy=True)  # tidied in place below
    except (TypeError, ValueError) as error:
        raise BodyError(f"{name} is not a matrix of real numbers ({error}); give a dense or sparse one") from error
    if not real:
        raise BodyError(f"{name} has complex entries; every entry must be a real number")
    allowed = " or ".join(f"{rows} x {rows}" for rows in sizes)
    if csr.ndim != 2 or csr.shape[0] != csr.shape[1] or csr.shape[0] not in sizes:
        raise BodyError(f"{name} is {extents(csr.shape)}; for this body it must be {allowed}")
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


def _small(matrix: Matrix, sizes: dict[int, Form]) -> sp.csr_array | None:
    """A small dense matrix with nothing to refuse or to even out; None sends any other the long way."""
    if not isinstance(matrix, np.ndarray | list):
        return None
    try:
        given = np.atleast_2d(np.asarray(cast("npt.ArrayLike", matrix)))
    except ValueError:
        return None
    rows = int(given.shape[0])
    if given.dtype.kind not in "fiu" or given.shape != (rows, rows) or rows not in sizes or rows > _SMALL_ROWS:
        return None
    values = given.astype(np.float64)
    if not np.isfinite(values).all() or not np.array_equal(values, values.T):
        return None
    i, j = np.nonzero(values)
    pointer = np.searchsorted(i, np.arange(rows + 1))
    return sp.csr_array((values[i, j], j.astype(np.int32), pointer.astype(np.int32)), shape=(rows, rows))


def _is_diagonal(matrix: sp.csr_array, own: Float) -> bool:
    """Whether a matrix without stored zeros has no entries but those of its diagonal `own`."""
    return matrix.nnz == np.count_nonzero(own)


def diagonal(name: str, matrix: sp.csr_array) -> None:
    """Refuses a matrix that is not diagonal with entries >= 0 (what binds a node to the ground binds nothing else).

    Args:
        name: what messages call it.
        matrix: sparse, square.
    """
    own = matrix.diagonal()
    if _is_diagonal(matrix, own) and np.all(own >= 0.0):
        return
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


def plausible(name: str, matrix: sp.csr_array) -> None:
    """Refuses a symmetric matrix that cannot be positive semidefinite, from its 1 x 1 and 2 x 2 minors.

    Args:
        name: what messages call it.
        matrix: sparse, square.

    Raises:
        BodyError: a minor is negative.
    """
    own = matrix.diagonal()
    coo = matrix.tocoo()
    slack = _ROUND_OFF * float(np.abs(own).max(initial=0.0))
    root = np.sqrt(np.abs(own) + slack)  # whose products stay finite where those of the entries would not
    bad = np.flatnonzero((own < -slack)[coo.row] | (np.abs(coo.data) > root[coo.row] * root[coo.col]))
    if bad.size:
        i, j = int(coo.row[bad[0]]), int(coo.col[bad[0]])
        raise BodyError(
            f"{name}[{i}, {j}] is {coo.data[bad[0]]:.6g} between diagonal entries {own[i]:.6g} and {own[j]:.6g}; "
            f"{name} must be positive semidefinite (no eigenvalue < 0)"
        )


def positive(name: str, matrix: sp.csr_array, *, strictly: bool) -> None:
    """Refuses a symmetric matrix that is not positive (semi)definite, naming its smallest eigenvalue.

    Args:
        name: what messages call it.
        matrix: sparse, square.
        strictly: whether zero is refused, too.

    Raises:
        BodyError: the smallest eigenvalue is negative, or zero where `strictly`.
    """
    own = matrix.diagonal()
    if _is_diagonal(matrix, own) and np.all(own > 0.0 if strictly else own >= 0.0):
        return
    margin = own - (np.asarray(abs(matrix).sum(axis=1)).ravel() - np.abs(own))
    # Gershgorin's circles settle every lattice and chain at once; only other matrices need an eigenvalue.
    if np.all(margin > _ROUND_OFF * own if strictly else margin >= -_ROUND_OFF * own):
        return
    floor = (1.0 if strictly else -1.0) * _ROUND_OFF * float(np.abs(own).max())
    if matrix.shape[0] <= _DENSE_ROWS:
        smallest = float(la.eigvalsh(matrix.toarray(), subset_by_index=[0, 0])[0])
        if smallest > floor if strictly else smallest >= floor:
            return
    elif _factor(matrix, floor) is not None:
        return
    else:
        smallest = _smallest_eigenvalue(matrix, float(margin.min()), floor)
    wanted = "positive definite (every eigenvalue > 0)" if strictly else "positive semidefinite (no eigenvalue < 0)"
    raise BodyError(f"the smallest eigenvalue of {name} is {smallest:.6g}; {name} must be {wanted}")


def _factor(matrix: sp.csr_array, shift: float) -> SuperLU | None:
    """The LU factors of `matrix - shift I` where that is positive definite, else None.

    Without pivoting U is D Lᵀ, so by Sylvester's law all of its diagonal is positive just where the matrix is. Unlike
    Lanczos iterations, this also decides matrices whose eigenvalues crowd at zero, as those of plates and beams do.
    """
    shifted = sp.csc_array(matrix - shift * sp.eye_array(matrix.shape[0]))
    try:
        factors = splu(shifted, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:  # a pivot is exactly zero
        return None
    unpivoted = np.array_equal(factors.perm_r, factors.perm_c)
    return factors if unpivoted and np.all(factors.U.diagonal() > 0.0) else None


def _smallest_eigenvalue(matrix: sp.csr_array, below: float, above: float) -> float:
    """The smallest eigenvalue, known to lie from `below` to `above`: bisection, then inverse iteration."""
    below -= 1e-3 * abs(below) + abs(above)  # so that nothing lies on it
    factors = _factor(matrix, below)
    assert factors is not None
    resolution = abs(above)
    while above - below > max(1e-3 * max(abs(below), abs(above)), resolution):
        # The bracket may span many powers of ten below zero; there its ends are halved in proportion.
        middle = -float(np.sqrt(below * above)) if above < 0.0 else 0.5 * (below + above)
        found = _factor(matrix, middle)
        if found is None:
            above = middle
        else:
            below, factors = middle, found
    vector = np.cos(np.arange(matrix.shape[0]) * 1.618)  # any fixed vector; a random one would change the message
    for _ in range(100):
        vector = factors.solve(vector)
        vector /= la.norm(vector)
    return float(vector @ (matrix @ vector))


# Nothing is farther away or larger [m]; squares and differences of it are still numbers.
FARTHEST = 1e9


def one_number(name: str, value: object) -> float:
    """A value that must be one real number, whichever.

    Args:
        name: of the value, for the message.
        value: anything.

    Raises:
        BodyError: it is not.
    """
    if isinstance(value, bool | str | complex | np.complexfloating) or np.ndim(value) != 0:  # pyright: ignore[reportArgumentType]
        raise BodyError(f"{name} is {value!r}; it must be one number")
    try:
        return float(value)  # pyright: ignore[reportArgumentType]
    except (TypeError, ValueError):
        raise BodyError(f"{name} is {value!r}; it must be one number") from None


def at_least_zero(**values: float) -> None:
    """Refuses what is no finite number of at least 0.

    Args:
        values: numbers, by the names that messages call them.

    Raises:
        BodyError: one is not.
    """
    for name, value in values.items():
        if not (np.isfinite(one_number(name, value)) and value >= 0.0):
            raise BodyError(f"{name} is {value}; it must be a finite number of at least 0")
