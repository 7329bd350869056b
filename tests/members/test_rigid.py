"""Rigid bodies live: two hold a box at points of their own, a third comes and goes, and an audit agrees."""

import numpy as np
import pytest
from tests.members.test_shared_model import built, same_body
from tests.session.world import World

from cotouch.recording import audit, read_recording, recordings_dataset

HAND = """
[[hands]]
user = {user}
at = [{x}, 0.011, 0.02]
stiffness = 200
damping = 4
path = [[0, 0, 0, 0], [0.3, 0, 0, 0], [1.0, 0, {way}, 0.06], [9, 0, {way}, 0.06]]
"""


def session(size: str = "[0.1, 0.06, 0.04]") -> str:
    """A box on a table; one hand at each end turns and lifts it."""
    return f"""
[session]
users = 3
spring = 25.0
wait_for_peers = 1.5
[body]
kind = "box"
size = {size}
mass = 0.3
centre = [0, 0, 0.02]
[world]
gravity = [0, 0, -9.81]
[[world.planes]]
stiffness = 1e6
damping = 5.0
friction = 0.5
kinetic_friction = 0.4
[steps]
rate = 250
[synchronisation]
law = "spring"
{HAND.format(user=1, x=-0.043, way=-0.03)}{HAND.format(user=2, x=0.043, way=0.03)}"""


@pytest.fixture(scope="module")
def held(tmp_path_factory: pytest.TempPathFactory) -> World:
    world = World(session(), folder=tmp_path_factory.mktemp("rigid"), tick=2e-3)
    ann, _ = (world.join(name) for name in ("Ann", "Ben"))
    world.until(lambda: ann.member.replica is not None and ann.copy.peer is not None, 12.0)
    cleo = world.join("Cleo", moves=False)
    world.until(lambda: len(ann.states()) == 2 and world.all_coupled(), 12.0)
    world.run(1.5)
    world.leave(cleo)
    world.run(0.7)
    world.check()
    for person in (*world.people, *world.gone):
        assert person.session_recorder is not None
        person.session_recorder.close()
    return world


def test_it_is_turned_and_lifted_and_stays_what_it_was(held: World) -> None:
    rest = held.replica.body.rest
    for person in held.people:
        place = rest + person.position
        lengths = [np.linalg.norm(x[:, None] - x[None], axis=2)[np.triu_indices(4, 1)] for x in (place, rest)]
        assert np.abs(lengths[0] / lengths[1] - 1.0).max() <= 1e-3
        assert place[:, 2].mean() > 0.04
        edge = place[0] - place[2] + place[1] - place[3]  # along x at rest
        assert np.degrees(np.arctan2(edge[1], edge[0])) > 15.0
        assert person.copy.totals.residual <= 1e-12
        assert person.copy.totals.closure_alarms == 0


def test_an_audit_works_its_energy_out_anew(held: World) -> None:
    found = [read_recording(path) for path in held.recordings]
    result = audit(found)
    assert result.holds, result.verdict
    assert result.complete
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
    run = recordings_dataset(found)
    assert float(np.nanmax(run["closure_factor"])) <= 1e-3


def test_who_built_another_box_is_told_apart() -> None:
    assert same_body(built(session()), built(session()))
    assert not same_body(built(session()), built(session("[0.1, 0.06, 0.0401]")))
