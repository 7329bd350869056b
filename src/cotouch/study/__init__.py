"""The paper's experiment, its theorem and its errata, recomputed and reported on one page."""

from cotouch.study._confirm import confirmed
from cotouch.study._data import five_users
from cotouch.study._reproduce import Reproduction, reproduce

__all__ = ["Reproduction", "confirmed", "five_users", "reproduce"]
