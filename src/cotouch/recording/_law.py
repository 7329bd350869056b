"""What a session's link law made of it, from the recordings of its users."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cotouch.recording._columns import EXCHANGE
from cotouch.recording._guards import lives
from cotouch.recording._motion import Motion

# Slower than 1 mm/s in the mean, nothing is felt [m²/s²].
_LEAST = 1e-6


class LawLedger(NamedTuple):
    """What is to be said of the law.

    Attributes:
        name: of the law.
        on_the_way: what ends gave to others that these did not take, to the end; None: the law exchanges no energy, or
            somebody is not recorded [J].
        drag: what the law took of the motion, by the damping B_i of all copies and by links that took more than they
            gave, over ∫‖v̂‖² in the identity weight: of a point the drag that whoever moved it felt, of other bodies
            that at each node. None: the copies hardly moved, or somebody is not recorded [Ns/m].
    """

    name: str
    on_the_way: float | None
    drag: float | None

    def numbers(self) -> dict[str, object]:
        """For JSON."""
        return {"name": self.name, "on_the_way_j": self.on_the_way, "felt_drag_ns_m": self.drag}


def law_ledger(moved: Sequence[Motion]) -> LawLedger:
    """Works it out.

    Args:
        moved: what all recordings say.
    """
    recordings = [motion.recording for motion in moved]
    name = recordings[0].setups[-1].law
    users = {recording.user for recording in recordings}
    if not all(set(recording.neighbours) <= users for recording in recordings):
        return LawLedger(name, None, None)
    return LawLedger(name, _on_the_way(moved) if name != "spring" else None, _drag(moved, len(users)))


def _on_the_way(moved: Sequence[Motion]) -> float | None:
    total = 0.0
    for motion in moved:
        columns = motion.recording.columns
        if not set(EXCHANGE) <= set(columns):
            return None
        for life in lives(motion.recording):
            column = motion.recording.neighbours.index(life.user)
            total += float(columns["sent"][life.steps, column][-1] - columns["received"][life.steps, column][-1])
    return max(total, 0.0)


def _drag(moved: Sequence[Motion], users: int) -> float | None:
    taken = square = longest = 0.0
    for motion in moved:
        T = motion.recording.columns["period"]
        known = np.isfinite(motion.speed)
        if not known.any():
            return None
        # Of states that are not recorded, the speed is taken to be that of the others.
        square += float((T * motion.speed)[known].sum() * T.sum() / T[known].sum()) / users
        taken += float(motion.known["local_loss"].sum() - motion.link.sum())
        longest = max(longest, float(T.sum()))
    return taken / square if square > _LEAST * longest else None
