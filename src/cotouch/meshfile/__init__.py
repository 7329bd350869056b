"""Mesh files, read by a process of their own: what a file does to its reader, it does there."""

from cotouch.meshfile._mesh import SURFACES, VOLUMES, Mesh
from cotouch.meshfile._read import is_surface, read_surface, read_tetrahedra

__all__ = ["SURFACES", "VOLUMES", "Mesh", "is_surface", "read_surface", "read_tetrahedra"]
