"""Bodies with a material live: they keep their size as they turn, every member's books balance, an audit agrees."""

from dataclasses import replace

import numpy as np
import pytest
from tests.members.attack import SPRING, play
from tests.members.lie import Lie
from tests.session.turned import session, turning, volumes
from tests.session.world import World

from cotouch.body import lattice
from cotouch.mechanics import CLOSURE_ALARM
from cotouch.recording import Recording, audit, read_recording, recordings_dataset

QUARTER = turning(0.5 * np.pi, 1.0)
# With a table that it never meets, it moves by the machine code of what does.
FLOATING = 'frame = "floating"\n[world]\nplanes = [{point = [0.0, 0.0, -10.0]}]'
CELLS = 'model = "cells"'


@pytest.fixture(scope="module", params=[FLOATING, CELLS], ids=["floating", "cells"])
def turned(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> World:
    """Ann turns it by a quarter, Ben and Cleo follow; Cleo leaves when that is half done."""
    world = World(session(request.param, hands=QUARTER), folder=tmp_path_factory.mktemp("turned"), tick=2e-3)
    _, _, cleo = (world.join(name, moves=name == "Ann") for name in ("Ann", "Ben", "Cleo"))
    world.until(world.all_coupled, 12.0)
    world.run(0.6)
    world.leave(cleo)
    world.run(1.8)
    world.check()
    for person in world.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    return world


def recordings(world: World) -> list[Recording]:
    return [read_recording(path) for path in world.recordings]


def test_a_quarter_turn_keeps_the_volume_on_every_member(turned: World) -> None:
    rest = turned.replica.body.rest
    for person, volume in zip(turned.people, volumes((p.position for p in turned.people), rest), strict=True):
        edge = np.subtract(*(rest + person.position)[[18, 0]])  # along x at rest
        assert np.degrees(np.arctan2(edge[1], edge[0])) == pytest.approx(90.0, abs=1.0)
        assert volume == pytest.approx(1.0, abs=1e-3)


def test_its_books_are_within_round_off_and_tell_of_their_closing(turned: World) -> None:
    for person in turned.people:
        status = person.copy.status(turned.now)
        assert status.residual <= 1e-13
        assert status.alarms == status.closure_alarms == 0
        assert 0.0 < status.closure_factor <= CLOSURE_ALARM
        assert status.closure == person.copy.totals.closure != 0.0
        own = status.initial + status.supplied + status.linked + status.rescaled - status.lost
        assert own == pytest.approx(status.energy, abs=1e-13)


def test_a_dataset_has_the_closure_of_every_step(turned: World) -> None:
    run = recordings_dataset(recordings(turned))
    for n, person in enumerate(turned.people):
        assert float(np.nansum(run["closure"][n])) == pytest.approx(person.copy.totals.closure)
        assert float(run["closure_factor"][n].max()) == person.copy.totals.closure_factor


def test_an_audit_works_its_energy_out_anew(turned: World) -> None:
    result = audit(recordings(turned))
    assert result.holds, result.verdict
    assert result.complete
    assert not result.notes
    for ledger, person in zip(result.users, turned.people, strict=False):
        assert ledger.worked_out == ledger.steps
        assert abs(ledger.residual) <= 1e-12 * result.in_play
        assert ledger.closure == pytest.approx(person.copy.totals.closure)


def test_an_audit_finds_what_does_not_fit_its_material(turned: World) -> None:
    """Springs that were softer than is recorded, a closure that was less, and one that did more."""
    one, *others = recordings(turned)
    body = one.header.body
    assert body.material is not None
    said = body.material.body
    softer = type(body.material)(
        lattice((3, 3, 3), spacing=0.01, mass=0.1, stiffness=50.0, damping=0.02, model="cells")
        if body.material.material.model == "cells"
        else lattice((3, 3, 3), spacing=0.01, mass=0.1, stiffness=50.0, damping=0.02, frame="floating")
    )
    assert softer.body.nodes == said.nodes
    header = replace(one.header, body=replace(body, material=softer))
    found = audit([replace(one, header=header)])
    assert "state" in {finding.place for finding in found.findings}
    with pytest.raises(Exception, match="of a different body"):
        audit([replace(one, header=header), *others])
    for name in ("closure", "closure_factor"):
        bent = {**one.columns, name: 2.0 * one.columns[name]}
        assert not audit([replace(one, columns=bent), *others]).holds, name


LIES = {
    "a place far away, before the others came": Lie(
        first=True, since=0.0, law="noise", size=9.9, pattern=1, state=2, seed=2
    ),
    "energy that nobody had": Lie(law="noise", size=0.2, given=1.5e9, state=1, received=True, seed=2),
}


@pytest.mark.parametrize("what", LIES)
def test_a_liar_gains_nothing_more_than_with_a_linear_body(what: str) -> None:
    limits = (
        "force_limit = 5.0\npower_limit = 0.5\ntank = 0.01\ninitial_energy = 1e-3\nallowance = 0.05\n"
        "age_limit = 1.0\nwindow = 1.0"
    )
    text = session(FLOATING, users=4, hands=turning(0.4, 1.0), more=limits)
    text = text.replace("rate = 250", "rate = 50").replace("spring = 20.0", f"spring = {SPRING}")
    outcome = play(LIES[what], text=text, seconds=2.5)
    assert outcome.held, outcome.broken
    assert max(outcome.gain, outcome.work, outcome.received, outcome.damping) <= 1.0
