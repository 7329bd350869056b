"""A recording with the places of a tool."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from cotouch.drivers import RECORDED
from cotouch.haptics import Device


class Moved(NamedTuple):
    """A recording with the places of a tool."""

    path: Path
    time: np.ndarray
    place: np.ndarray

    def device(self) -> Device:
        return RECORDED.make(path=str(self.path), tool=2)
