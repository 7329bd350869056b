"""The shared object and builders for it."""

from cotouch.body._body import Body
from cotouch.body._builders import Ground, chain, lattice, point
from cotouch.body._checks import Matrix, SumOfSquares
from cotouch.body._ground import Box, Held, NodeSet, Plane
from cotouch.body._meshes import MOST_ELEMENTS, MOST_NODES, MOST_TRIANGLES, body_from_surface, body_from_tetrahedra
from cotouch.body._origin import Origin
from cotouch.body._reading import SURFACES, UNITS, VOLUMES
from cotouch.body._skin import Skin
from cotouch.body._statics import lowest_modes
from cotouch.body._truncation import Truncation

__all__ = [
    "MOST_ELEMENTS",
    "MOST_NODES",
    "MOST_TRIANGLES",
    "SURFACES",
    "UNITS",
    "VOLUMES",
    "Body",
    "Box",
    "Ground",
    "Held",
    "Matrix",
    "NodeSet",
    "Origin",
    "Plane",
    "Skin",
    "SumOfSquares",
    "Truncation",
    "body_from_surface",
    "body_from_tetrahedra",
    "chain",
    "lattice",
    "lowest_modes",
    "point",
]
