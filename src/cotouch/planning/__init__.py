"""Which links to use, and how stiff to make them."""

from cotouch.planning._springs import Tuned, tune_springs

__all__ = ["Tuned", "tune_springs"]
