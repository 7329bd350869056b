"""Meshes that stood still around a recorded body, as arrays."""

from collections.abc import Mapping, Sequence

import numpy as np

from cotouch.arrays import Array
from cotouch.mechanics import Solid

NAMES = ("vertices", "triangles", "ends")


def solid_arrays(solids: Sequence[Solid]) -> dict[str, Array]:
    """Some solids by name: vertices and triangles of all, and where those of each end, (solids, 2); none: nothing.

    Args:
        solids: one after the other.
    """
    if not solids:
        return {}
    sizes = [(solid.vertices.shape[0], solid.triangles.shape[0]) for solid in solids]
    places = np.concatenate([solid.vertices for solid in solids])
    corners = np.concatenate([solid.triangles for solid in solids])
    return dict(zip(NAMES, (places, corners, np.cumsum(sizes, axis=0)), strict=True))


def solids_of_arrays(arrays: Mapping[str, Array]) -> list[Solid]:
    """The inverse of `solid_arrays`.

    Args:
        arrays: by name; nothing of them is believed.

    Raises:
        BodyError: one is no closed surface.
        ValueError: they are of no solids.
    """
    if "ends" not in arrays:
        return []
    places, corners, ends = (np.asarray(arrays[name]) for name in NAMES)
    begins = np.concatenate([[[0, 0]], ends[:-1]])
    if ends.ndim != 2 or ends.shape[1] != 2 or (ends < begins).any() or begins.size > 2 * _MOST:
        raise ValueError(f"solids end at {ends.tolist()[:3]}")
    return [Solid(places[v:w], corners[f:g]) for (v, f), (w, g) in zip(begins, ends, strict=True)]


# A recording has no more solids.
_MOST = 100
