"""Vendors' devices, each behind the interface of `cotouch.haptics`; a vendor's library is loaded on demand."""

from cotouch.drivers._haply import HAPLY
from cotouch.drivers._registered import FORCE_DIMENSION, GAMEPAD, RECORDED, TOUCH

__all__ = ["FORCE_DIMENSION", "GAMEPAD", "HAPLY", "RECORDED", "TOUCH"]
