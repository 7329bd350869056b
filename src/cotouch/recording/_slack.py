"""What inequality (7) has to spare in a session, from the recordings of all who took part in it."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from cotouch.arrays import Float
from cotouch.recording._links import grid_of, link_ledger, linked, so_far
from cotouch.recording._motion import motions
from cotouch.recording._recording import Recording


class Slack(NamedTuple):
    """Over the steps of the user who took most of them.

    Attributes:
        time: ends of these steps, the begin of the first before them, in the time that all share [s].
        energy: lost so far in the damping B_i less what the age of samples added [J].
    """

    time: Float
    energy: Float


def slack_of(recordings: Sequence[Recording], offsets: Sequence[float]) -> Slack | None:
    """None where recordings do not say it: of a neighbour there is none, or not every state was kept.

    Args:
        recordings: of different users of one session.
        offsets: shared time less each user's own [s].

    Raises:
        RecordingError: they do not belong together.
    """
    there = {recording.user for recording in recordings}
    for recording in recordings:
        whole = recording.finite == recording.steps and recording.states["state_row"].size == recording.steps
        if not whole or not there.issuperset(recording.neighbours):
            return None
    moved = motions(recordings, offsets)
    grid = grid_of(moved)
    energy = np.zeros(grid.size)
    for motion in moved:
        energy += so_far(motion, motion.known["local_loss"], grid)
    for i, one in enumerate(moved):
        for two in moved[i + 1 :]:
            if linked(one.recording, two.recording):
                nobodys = np.zeros(one.end.size), np.zeros(two.end.size)
                energy -= link_ledger(one, two, grid, nobodys).made
    most = max(moved, key=lambda motion: motion.end.size)
    time = np.concatenate([most.begin[:1], most.end])
    return Slack(time, energy[np.searchsorted(grid, time)])
