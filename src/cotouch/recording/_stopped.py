"""Steps after which nodes had lost their last element and stopped: how fast these moved before that.

Such a node rests from then on (`mechanics/_closed/_debris.py`). Its velocity is not recorded any more, but follows
from the step itself, which began with the one that the step before ended with.
"""

from typing import TYPE_CHECKING

import numpy as np

from cotouch.arrays import Bool, Float, Long
from cotouch.body import Body, cut_away
from cotouch.recording._closing import reopened

if TYPE_CHECKING:
    from cotouch.recording._recording import Recording

# Each leaves of what is missing the share by which the closure changes velocities.
_TURNS = 40


def stopped_rows(body: Body, when: Float, index: Float) -> Bool | None:
    """Which nodes each step stopped, (steps, nodes); None: none did.

    Args:
        body: what was cut.
        when: after which step each element was, infinite where it was not, (elements,).
        index: number of each step, (steps,).
    """
    steps = np.isin(index, when)
    if not steps.any():
        return None
    last = cut_away(body, when)
    stopped = steps[:, None] & (last <= index[:, None])
    return stopped if stopped.any() else None


def before_stop(recording: "Recording", chosen: Long, v: Float, mean: Float, stopped: Bool, share: float) -> Float:
    """Velocities after the closure, before debris stopped, (steps, rows, axes) [m/s]; NaN where nothing can be said.

    Args:
        recording: of the copy.
        chosen: which of its states.
        v: as recorded, likewise.
        mean: v̂, likewise.
        stopped: of `stopped_rows`.
        share: of the body that the copy carried.
    """
    rows = recording.states["state_row"]
    steps = np.flatnonzero(stopped.any(axis=1))
    one = chosen[steps]
    follows = (rows[one] - rows[one - 1] == 1) & recording.consecutive[rows[one]]
    old = recording.header.body.field(recording.states["velocity"][one - 1])
    wanted, gone = 2.0 * mean[steps] - old, stopped[steps][:, :, None]
    moving = np.where(gone, wanted, v[steps])
    for _ in range(_TURNS):
        found, _ = reopened(recording, rows[one], moving, share)
        moving = np.where(gone, moving + (wanted - found), moving)
    result = v.copy()
    result[steps] = np.where(follows[:, None, None], moving, np.nan)
    return result
