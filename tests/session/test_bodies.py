"""Several bodies live: two dice on a table, two members and one who comes later; books and an audit."""

from pathlib import Path

import numpy as np
import pytest
from tests.session.world import World

from cotouch.recording import audit, read_recording

STACK = """
[session]
users = 3
spring = 25.0
wait_for_peers = 1.5
[[bodies]]
name = "die"
kind = "box"
size = [0.05, 0.05, 0.05]
mass = 0.1
resolution = 1
at = [0.0, 0.0, 0.025]
step = [0.01, 0.0, 0.05]
copies = 2
[between]
friction = 0.4
damping = 20.0
[world]
gravity = [0, 0, -9.81]
[[world.planes]]
friction = 0.5
damping = 20.0
[steps]
rate = 250
[synchronisation]
law = "spring"
[[hands]]
user = 2
body = "die 2"
at = [0.035, 0.0, 0.075]
path = [[0, 0, 0, 0], [2, 0.01, 0, 0], [3, 0.03, 0, 0], [9, 0.03, 0, 0]]
stiffness = 100
"""


def crushed() -> str:
    """Three dice in a row, at 55 steps a second, and strong hands that force them through each other at random."""
    rng = np.random.default_rng(13)
    text = STACK.replace("[0.01, 0.0, 0.05]", "[0.06, 0.003, 0.0]").replace("copies = 2", "copies = 3")
    text = text.replace("250", "55").replace("damping = 20.0\n[world]", "damping = 5.0\nstiffness = 1e6\n[world]")
    text = text[: text.index("[[hands]]")]
    for k, mean in enumerate((0.04, 0.0, -0.04)):
        path = rng.normal((mean, 0.0, 0.02), (0.05, 0.02, 0.02), (8, 3)).round(3)
        rows = [[0.15 * j, *place] for j, place in enumerate([[0.0] * 3, *path.tolist()])]
        text += f'[[hands]]\nuser = {1 + k % 2}\nbody = "die {k + 1}"\nat = [{0.06 * k}, {0.003 * k}, 0.025]\n'
        text += f"path = {rows}\nstiffness = 3000\n"
    return text


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> World:
    world = World(STACK, folder=tmp_path_factory.mktemp("played"), tick=2e-3)
    for name in ("Ann", "Ben"):
        world.join(name, moves=False)
    world.until(world.all_coupled, 12.0)
    world.run(0.5)
    world.join("Cleo", moves=False)
    world.until(lambda: len(world.people[0].states()) == 2 and world.all_coupled(), 12.0)
    world.run(1.0)
    return world


def test_they_stand_and_what_is_pushed_slides(played: World) -> None:
    played.check()
    place = played.people[0].position
    assert np.abs(place[:4]).max() <= 2e-3
    for person in played.people:
        assert person.copy.totals.residual <= 1e-10


def test_an_audit_works_out_anew_what_bodies_did(played: World) -> None:
    for person in played.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    found = [read_recording(path) for path in played.recordings]
    result = audit(found)
    assert result.holds, result.verdict
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
        assert abs(ledger.residual) <= 1e-11 * result.in_play
    material = found[0].header.body.material
    assert material is not None
    assert material.between is not None
    assert material.between.friction == 0.4
    assert material.same(found[1].header.body.material)


def test_an_audit_finds_what_was_forced_through_others_in_balance(tmp_path: Path) -> None:
    """Points lie in two others at once: what these hold is the same at the end of a step as where the next begins."""
    world = World(crushed(), folder=tmp_path, tick=2e-3)
    for name in ("Ann", "Ben"):
        world.join(name)
    world.until(world.all_coupled, 12.0)
    world.run(1.5)
    for person in world.people:
        assert person.copy.totals.residual <= 1e-10
        assert person.session_recorder is not None
        person.session_recorder.close()
    result = audit([read_recording(path) for path in world.recordings])
    assert result.holds, result.verdict
    assert result.in_play > 1.0
    for ledger in result.users:
        assert abs(ledger.residual) <= 1e-11 * result.in_play
