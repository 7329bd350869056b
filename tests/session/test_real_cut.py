"""A blade that is told where to cut, in processes that hear of each other through sockets only."""

import numpy as np

from cotouch.members import SessionFile
from cotouch.observers import MoveHand
from cotouch.session import DemoSessionApi, play

SESSION = """
[network]
users = ["Ann", "Ben"]
spring = [[0, 60], [60, 0]]
delay = [[0, 0], [0, 0]]
[session]
[body]
kind = "lattice"
shape = [4, 3, 3]
spacing = 0.03
mass = 0.3
stiffness = 60.0
damping = 0.3
model = "cells"
ground = "x-"
ground_stiffness = 80.0
[cutting]
users = [1]
[steps]
rate = 50
"""


def test_one_cuts_and_both_have_the_same_cut() -> None:
    found: list[np.ndarray] = []
    cut = MoveHand(slot=0, mode="cut", at=(0.045, -0.03, 0.09), edge=(0.0, 0.12, 0.0), to=(0.045, -0.03, -0.03))

    def each(api: DemoSessionApi, _: float) -> None:
        views = api.views()
        cuts = [views[slot].cut for slot in (0, 1) if slot in views]
        if len(cuts) < 2 or any(one is None for one in cuts):
            return
        if api.overview().statuses.get(0) is not None and not np.any(cuts[0]):
            assert api.do(cut) == "Ann cuts there"
        whole = [one for one in cuts if one is not None and np.count_nonzero(one) == 4]
        if len(whole) == 2:
            found[:] = [one.copy() for one in whole]

    outcome = play(SessionFile.from_toml(SESSION), seconds=60.0, each=each, stopped=lambda: bool(found))
    assert len(found) == 2
    assert np.array_equal(found[0], found[1])
    assert set(found[0].tolist()) == {0, 1}  # Ann's, in both
    assert not [one for one in outcome.complaints if "ledger" in one]
    assert outcome.residual < 1e-9
