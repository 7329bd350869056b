"""The order of rows in which entries lie only across two halves."""

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp
from scipy.sparse import csgraph

Int = npt.NDArray[np.int32]


def halves_of(matrices: list[sp.csr_array]) -> tuple[Int | None, int]:
    """The order that puts rows into two halves with entries only across, and where the second starts; or (None, 0).

    Lattices, chains and trees have such halves. They are found in the graph that has every row twice, once for each
    half, and an edge across for every entry: there the two of a row are connected exactly if a cycle is odd.
    """
    pattern = sp.csr_array(sum((abs(m) for m in matrices[1:]), start=abs(matrices[0])))
    pattern = sp.csr_array(pattern - sp.diags_array(pattern.diagonal()))
    pattern.eliminate_zeros()
    if pattern.nnz == 0:
        return None, 0
    rows = pattern.shape[0]
    labels = csgraph.connected_components(sp.block_array([[None, pattern], [pattern, None]]), directed=False)[1]
    first, second = labels[:rows], labels[rows:]
    if np.any(first == second):
        return None, 0
    return np.argsort(first > second, kind="stable").astype(np.int32), int(np.count_nonzero(first < second))
