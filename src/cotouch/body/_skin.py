"""The surface that a body carries: where contact happens and what a viewer draws."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import final

import numpy as np
import numpy.typing as npt
import scipy.sparse as sp

from cotouch.arrays import Float, Int, extents
from cotouch.errors import BodyError

# What the sum of a vertex's weights may be off by: they come from a division or from a file.
_SUM = 1e-9


@final
@dataclass(frozen=True, eq=False, kw_only=True)
class Skin:
    """A triangulated surface whose vertices follow the nodes of a body: `s = s_rest + W (x - x_d)`.

    A force at a skin point goes to the nodes by the transpose, so that it does the same work there.

    Args:
        vertices: at rest, (V, 3) [m].
        triangles: indices of vertices, counter-clockwise seen from outside, (F, 3).
        nodes: which nodes carry each vertex, (V, k) with k at most 8. Unused places repeat a node with weight 0.
        weights: how much of each, (V, k); every row sums to one.

    Raises:
        BodyError: an array has the wrong shape, an index is out of range, or weights do not sum to one.

    Examples:
        >>> skin = Skin(vertices=[[0.5, 0, 0]], triangles=[], nodes=[[0, 1]], weights=[[0.5, 0.5]])
        >>> skin.carried([[0, 0, 0], [0, 0, 1]]).tolist()
        [[0.0, 0.0, 0.5]]
    """

    vertices: Float
    triangles: Int
    nodes: Int
    weights: Float

    def __init__(
        self, *, vertices: npt.ArrayLike, triangles: npt.ArrayLike, nodes: npt.ArrayLike, weights: npt.ArrayLike
    ) -> None:
        places = _table("skin vertices", vertices, np.float64, width=3)
        corners = _table("skin triangles", triangles, np.int32, width=3)
        carriers = _table("skin nodes", nodes, np.int32, width=None)
        parts = _table("skin weights", weights, np.float64, width=None)
        if not np.isfinite(places).all():
            bad = int(np.flatnonzero(~np.isfinite(places).all(axis=1))[0])
            raise BodyError(f"skin vertex {bad} is {places[bad].tolist()}; every coordinate must be a finite number")
        if carriers.shape != parts.shape or carriers.shape[0] != places.shape[0] or not 1 <= carriers.shape[1] <= 8:
            raise BodyError(
                f"skin nodes are {extents(carriers.shape)} and skin weights {extents(parts.shape)}; both must be "
                f"{places.shape[0]} x k with k from 1 to 8"
            )
        if corners.size and (corners.min() < 0 or corners.max() >= places.shape[0]):
            wrong = int(corners.min() if corners.min() < 0 else corners.max())
            raise BodyError(f"a skin triangle names vertex {wrong}; this skin has vertices 0 to {places.shape[0] - 1}")
        sums = parts.sum(axis=1)
        off = np.flatnonzero(~(np.abs(sums - 1.0) <= _SUM))
        if off.size:
            raise BodyError(f"the weights of skin vertex {off[0]} sum to {sums[off[0]]:.9g}; they must sum to 1")
        for name, array in (("vertices", places), ("triangles", corners), ("nodes", carriers), ("weights", parts)):
            array.setflags(write=False)
            object.__setattr__(self, name, array)

    def check(self, body_nodes: int) -> None:
        """Refuses a skin that names nodes which a body of `body_nodes` nodes does not have.

        Raises:
            BodyError: it does.
        """
        if self.nodes.size and (self.nodes.min() < 0 or self.nodes.max() >= body_nodes):
            wrong = int(self.nodes.min() if self.nodes.min() < 0 else self.nodes.max())
            raise BodyError(f"the skin hangs on node index {wrong}; this body has nodes 0 to {body_nodes - 1}")

    @cached_property
    def pattern(self) -> tuple[Int, Int, Float]:
        """W as CSR parts: row pointer, node indices, weights; for `scipy.sparse.csr_array` or a kernel."""
        count, width = self.nodes.shape
        pointer = np.arange(0, count * width + 1, width, dtype=np.int32)
        return pointer, self.nodes.ravel(), self.weights.ravel()

    def interpolation(self, body_nodes: int) -> sp.csr_array:
        """W, (V, nodes)."""
        pointer, columns, values = self.pattern
        return sp.csr_array((values, columns, pointer), shape=(self.vertices.shape[0], body_nodes))

    def carried(self, displacement: npt.ArrayLike) -> Float:
        """Displacement of the skin, (V, 3), from that of the nodes, (n, 3)."""
        field = np.asarray(displacement, dtype=np.float64)
        return np.einsum("vk,vkd->vd", self.weights, field[self.nodes])

    def spread(self, forces: npt.ArrayLike, body_nodes: int) -> Float:
        """Forces at the nodes, (n, 3), that do the same work as forces at the skin's vertices, (V, 3).

        Args:
            forces: (V, 3) [N].
            body_nodes: n.
        """
        return np.asarray(self.interpolation(body_nodes).T @ np.asarray(forces, dtype=np.float64))


def _table(
    name: str, values: npt.ArrayLike, kind: type[np.float64 | np.int32], *, width: int | None
) -> npt.NDArray[np.generic]:
    try:
        given = np.asarray(values)
        array = np.array(given, dtype=kind, order="C")
    except (TypeError, ValueError, OverflowError) as error:
        raise BodyError(f"{name} are not an array of numbers ({error}); give one row each") from error
    if array.size == 0:
        array = array.reshape(0, width or 1)
    if array.ndim != 2 or (width is not None and array.shape[1] != width):
        raise BodyError(f"{name} are {extents(array.shape)}; they must be rows of {width or 'k'}")
    if kind is np.int32 and not np.array_equal(array, given.reshape(array.shape)):
        raise BodyError(f"{name} must be whole numbers, indices from 0")
    return array


def joined_skins(skins: Sequence[Skin]) -> Skin:
    """Several skins as one.

    Args:
        skins: one after the other.
    """
    width = max(skin.nodes.shape[1] for skin in skins)
    first = np.cumsum([0, *(skin.vertices.shape[0] for skin in skins)])
    spare = [((0, 0), (0, width - skin.nodes.shape[1])) for skin in skins]
    return Skin(
        vertices=np.concatenate([skin.vertices for skin in skins]),
        triangles=np.concatenate([skin.triangles + n for skin, n in zip(skins, first, strict=False)]),
        nodes=np.concatenate([np.pad(skin.nodes, s, mode="edge") for skin, s in zip(skins, spare, strict=True)]),
        weights=np.concatenate([np.pad(skin.weights, s) for skin, s in zip(skins, spare, strict=True)]),
    )
