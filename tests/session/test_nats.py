"""Whole sessions of users behind NATs of this kernel: `cotouch host` in public, `cotouch join` behind each NAT."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from tests.live.emulator.yard import PUBLIC
from tests.live.test_nats import Yard, obstacle, yard
from tests.session.session_api import api, calmest, judged, worst_force
from tests.session.test_networks import FORCE, hand

from cotouch.peer import LinkState
from cotouch.recording import Recording, read_recording

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
[synchronisation]
law = "spring"
""" + hand(2.0)
CYCLE = 5.0  # the hand goes, and rests, and comes back, and rests [s]
MOVED = 0.09  # of 100 mm that the hand goes [m]
NEAR = 5e-3  # at rest [m]


@dataclass
class Behind:
    """The yard as a stage knows networks: members behind the NATs, host and spectator in public."""

    running: Yard

    @property
    def holders(self) -> list[int]:
        return [*self.running.users, self.running.public, self.running.public]

    def address(self, user: int) -> str:
        return PUBLIC[user - 2]


def missing(recordings: list[Recording], begin: float) -> list[str]:
    """What recordings lack of having moved as one through the cycle of the hand that begins then."""
    lacks = []
    for recording in recordings:
        end, phase = recording.columns["time"], recording.columns["link_state"]
        during = (end >= begin) & (end <= begin + CYCLE)
        coupled = (phase[during] == LinkState.COUPLED).mean() if phase.shape[1:] == (1,) and during.any() else 0.0
        places = recording.states["position"][during[recording.states["state_row"]], 0, 0]
        moved = np.ptp(places) if places.size else 0.0
        if end[0] > begin or coupled <= 0.8 or moved <= MOVED:
            lacks.append(
                f"{recording.name}, from {begin - end[0]:.1f} s on: coupled {coupled:.0%}, moved {moved:.3f} m"
            )
    if not lacks and (apart := calmest(recordings, begin, begin + CYCLE)) >= NEAR:
        lacks.append(f"never nearer than {apart:.4f} m")
    return lacks


def paths(recording: Recording) -> list[str]:
    """How the neighbour was reached, one after the other."""
    return [str(event.fields["reason"]) for event in recording.events if event.kind == "path"]


@pytest.mark.parametrize(("ports", "path_state"), [("kept", "direct"), ("random", "relayed")])
def test_two_behind_nats_feel_each_other(tmp_path: Path, ports: str, path_state: str) -> None:
    """Where ports are kept they punch; where each destination sees another one, the host relays.

    A machine that stands still gives their link an age budget, and with it a damping, that Ann's hand hardly moves
    them against until it has come down; so the test waits for a whole cycle of the hand that both go through.
    """
    names = ["Ann", "Ben"]
    lacks = ["a cycle"]
    begin = 0.0
    with yard(ports) as running, api(Behind(running), tmp_path, TWO, names) as played:
        for name in names:
            played.join(name)

        def felt() -> bool:
            nonlocal lacks, begin
            now = [read_recording(played.recordings[name][-1]) for name in names]
            begin = min(recording.columns["time"][-1] for recording in now) - CYCLE
            lacks = missing(now, begin)
            lacks += [f"{one.name} has ways {paths(one)}" for one in now if paths(one)[-1:] != [path_state]]
            return not lacks

        for name in names:
            played.wait(played.recordings[name][-1].exists, f"{name} does not move")
        played.wait(played.coupled(*names, links=1), "not coupled")  # the host hands on what watchers do not see
        played.wait(felt, lambda: f"did not move as one through a cycle of the hand: {lacks}")
        said = {name: played.stop(name) for name in names}
    recordings = judged(played, said, FORCE)
    assert not missing(recordings, begin)
    for recording in recordings:
        assert worst_force(recording) > 0.5  # Ben has no hand: what moves him is what he feels of Ann
    assert {link["path_state"] for one in said.values() for link in one["status"]["links"]} == {
        path_state
    }  # of who stopped first
