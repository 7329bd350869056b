"""The shared object and builders for it."""

from cotouch.body._body import Body
from cotouch.body._builders import Ground, chain, lattice, point
from cotouch.body._checks import Matrix

__all__ = ["Body", "Ground", "Matrix", "chain", "lattice", "point"]
