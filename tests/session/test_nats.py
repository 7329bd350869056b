"""Whole sessions of users behind NATs of this kernel: `cotouch host` in public, `cotouch join` behind each NAT."""

import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from tests.live.emulator.yard import PUBLIC
from tests.live.test_nats import Yard, obstacle, yard
from tests.session.stage import calmest, judged, stage, worst_force
from tests.session.test_networks import FORCE, hand

from cotouch.recording import LinkPhase

no_nats = obstacle()
pytestmark = [pytest.mark.slow, pytest.mark.skipif(no_nats is not None, reason=f"no NATs here: {no_nats}")]

TWO = """
title = "Two users"
[network]
users = ["Ann", "Ben"]
spring = [[0, 60], [60, 0]]
delay = [[0, 0.01], [0.01, 0]]
[body]
mass = 1.0
[steps]
rate = 200
""" + hand(1.0)
NEAR = 5e-3  # at rest, of 100 mm that the hand goes [m]


@dataclass
class Behind:
    """The yard as a stage knows networks: members behind the NATs, host and spectator in public."""

    running: Yard

    @property
    def holders(self) -> list[int]:
        return [*self.running.users, self.running.public, self.running.public]

    def address(self, user: int) -> str:
        return PUBLIC[user - 2]


@pytest.mark.parametrize(("ports", "way"), [("kept", "direct"), ("random", "relayed")])
def test_two_behind_nats_feel_each_other(tmp_path: Path, ports: str, way: str) -> None:
    """Where ports are kept they punch; where each destination sees another one, the host relays."""
    names = ["Ann", "Ben"]
    with yard(ports) as running, stage(Behind(running), tmp_path, TWO, names) as played:
        for name in names:
            played.join(name)

        played.wait(played.coupled(*names, links=1), "not coupled")  # the host hands on what watchers do not see
        since = time.monotonic()
        time.sleep(4.5)  # the hand goes, and rests, and comes back
        said = {name: played.stop(name) for name in names}
    recordings = judged(played, said, FORCE)
    for recording in recordings:
        then = recording.columns["end"] > since
        assert (recording.columns["phase"][then] == LinkPhase.COUPLED).mean() > 0.8
        assert np.ptp(recording.states["x"][then[recording.states["state_row"]], 0, 0]) > 0.09
        assert worst_force(recording) > 0.5  # Ben has no hand: what moves him is what he feels of Ann
    assert {link["way"] for one in said.values() for link in one["status"]["links"]} == {way}  # of who stopped first
    assert calmest(recordings, since, since + 4.2) < NEAR
