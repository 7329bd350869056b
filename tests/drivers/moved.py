"""A recording with the places of a tool."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from cotouch.drivers._recorded import RecordedHand


class Moved(NamedTuple):
    """A recording with the places of a tool."""

    path: Path
    time: np.ndarray
    place: np.ndarray

    def device(self) -> RecordedHand:
        return RecordedHand(self.path, tool=2)
