"""Which links to use."""

from cotouch.planning._figures import knee, networks, ranks

__all__ = ["knee", "networks", "ranks"]
