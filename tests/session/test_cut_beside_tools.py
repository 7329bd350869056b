"""A blade beside a tool that is a rigid body, live: by the file, by command, in recordings and their audit."""

from pathlib import Path

import numpy as np
from tests.session.test_cuts import cuts_of
from tests.session.test_rigid_tools import TOOL
from tests.session.world import World

from cotouch.observers import MailboxFolder
from cotouch.recording import audit, read_recording

DOWN = "[[0, 0, 0, 0, 0, 0, 0], [0.3, 0, 0, -0.002, 0, 0, 0]]"
PRESSED = f"""
[session]
users = 2
spring = 30.0
[body]
kind = "lattice"
shape = [4, 4, 3]
spacing = 0.01
model = "cells"
mass = 0.3
stiffness = 200.0
damping = 0.4
ground = "z-"
ground_stiffness = 1e4
[between]
friction = 0.8
damping = 20.0
[cutting]
toughness = 5.0
[steps]
rate = 250
[synchronisation]
law = "spring"
{TOOL.format(size="[0.05, 0.05, 0.02]", at="[0.015, 0.015, 0.0305]", path=DOWN)}
[[tools]]
user = 2
kind = "blade"
at = [0.005, -0.01, -0.005]
axis = [0, 0, 0.04]
thickness = 0.001
[tools.hand]
path = [[0, 0, 0, 0], [1.0, 0, 0, 0], [1.5, 0, 0.06, 0]]
stiffness = 500
damping = 20
"""


def test_blades_cut_what_a_plate_presses(tmp_path: Path) -> None:
    """Ben's by his file, Ann's by command while she presses: all cuts are in both copies and in the audit."""
    (tmp_path / "mail").mkdir()
    (tmp_path / "kept").mkdir()
    world = World(PRESSED, tick=4e-3, mailboxes=MailboxFolder(tmp_path / "mail"), folder=tmp_path / "kept")
    ann, ben = (world.join(name) for name in world.session.scenario.network.users)
    world.until(world.all_coupled, 12.0)
    world.run(2.5)
    assert np.count_nonzero(cuts_of(ann) == 2) >= 4
    pressed = ann.copy.peer
    assert pressed is not None
    assert np.abs(pressed.ports.force[:4].sum(axis=0)).max() > 0.05
    assert world.commands is not None
    for to in ((0.025, 0.06, -0.005), (0.025, 0.06, -0.005)):
        world.commands.hand("user 1", "cut", at=(0.025, -0.02, -0.005), to=to, edge=(0.0, 0.0, 0.04))
        world.run(1.0)
    world.commands.hand("user 1", "script")
    world.run(1.0)
    assert np.count_nonzero(cuts_of(ben) == 1) >= 4
    assert np.array_equal(cuts_of(ann), cuts_of(ben))
    world.check()
    for person in (ann, ben):
        assert person.copy.totals.residual <= 1e-12
        assert person.copy.totals.cut > 0.0
        assert person.session_recorder is not None
        person.session_recorder.close()
    result = audit([read_recording(path) for path in world.recordings])
    assert result.holds, result.verdict
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
