"""Balls and grasps beside a tool that is a rigid body, live: by file and pointer, in recordings and their audit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from tests.session.test_rigid_tools import SOFT
from tests.session.world import World

from cotouch.observers import MailboxFolder, Pointer
from cotouch.recording import audit, read_recording

BESIDE = f"""{SOFT.replace("path = [0, 0, 0]", "path = [[0, 0, 0, 0, 0, 0, 0], [0.3, 0, 0, -0.002, 0, 0, 0]]")}
[[tools]]
user = 2
at = [0.045, 0.015, 0.01]
radius = 0.008
friction = 0.5
[tools.hand]
path = [[0, 0, 0, 0], [0.3, -0.012, 0, 0]]
[[tools]]
user = 2
kind = "grasp"
at = [0.0, 0.0, 0.02]
radius = 0.002
stiffness = 100
damping = 0.5
[tools.hand]
path = [[0, 0, 0, 0], [0.3, -0.01, 0, 0]]
"""


def test_a_plate_balls_and_a_grasp_at_once(tmp_path: Path) -> None:
    """Ann's plate presses, and she pokes the block by pointer; Ben's ball and grasp are those of the file."""
    (tmp_path / "mail").mkdir()
    (tmp_path / "kept").mkdir()
    world = World(BESIDE, tick=2e-3, mailboxes=MailboxFolder(tmp_path / "mail"), folder=tmp_path / "kept")
    ann, ben = (world.join(name) for name in world.session.scenario.network.users)
    world.until(world.all_coupled, 12.0)
    world.run(0.6)
    ours, theirs = ann.copy.peer, ben.copy.peer
    assert ours is not None
    assert theirs is not None
    assert theirs.tools is not None
    assert ours.tools is not None
    pushed, held = theirs.tools.touch_force[0, 0], theirs.tools.touch_force[1, 0]
    assert pushed > 0.1
    assert held > 0.05
    assert theirs.tools.held[1] == 1
    assert np.abs(ours.ports.force[:4].sum(axis=0)).max() > 0.05  # the plate presses
    assert world.commands is not None
    for number in range(1, 30):
        place = (0.015, -0.01 + min(number, 20) * 5e-4, 0.01)
        world.commands.point("user 1", Pointer(number=number, mode="ball", node=-1, target=place, radius=0.006))
        world.run(0.02)
    assert np.linalg.norm(ours.tools.touch_force[0]) > 0.05
    world.commands.hand("user 1", "free")  # and the ball goes
    world.run(0.6)
    assert ours.tools.mode[0] == 0
    world.check()
    for person in (ann, ben):
        assert person.copy.totals.residual <= 1e-12
        assert person.session_recorder is not None
        person.session_recorder.close()
    found = [read_recording(path) for path in world.recordings]
    result = audit(found)
    assert result.holds, result.verdict
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
    bent = {**found[1].columns, "touch_force": found[1].columns["touch_force"] * 1.01}
    assert not audit([found[0], replace(found[1], columns=bent)]).holds
