"""Devices of vendors, each behind the interface of `cotouch.haptics`; a vendor's library is loaded when asked for.

`cotouch.haptics.make_device` makes a device of each, by name.
"""

from cotouch.drivers._registered import FORCE_DIMENSION, GAMEPAD, HAPLY, RECORDED, TOUCH

__all__ = ["FORCE_DIMENSION", "GAMEPAD", "HAPLY", "RECORDED", "TOUCH"]
