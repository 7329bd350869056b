"""Weight, planes and friction live: what falls, rests and is lifted, as members come and go; books and an audit."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.members.attack import SPRING, play
from tests.members.lie import Lie
from tests.session.heavy import FAR, LIFT, SLICK, WEIGHT, session
from tests.session.world import Person, World

from cotouch.errors import ScenarioError
from cotouch.members import SessionFile, SharedModel
from cotouch.recording import Recording, audit, read_recording, recordings_dataset


def low(person: Person) -> float:
    """Height of the lowest node [m]."""
    return float(person.position[:, 2].min())


def load(*people: Person) -> float:
    """What the table carries [N]."""
    reports = [person.steps.last for person in people]
    return sum(report.world_force[2] for report in reports if report is not None)


def recordings(world: World) -> list[Recording]:
    for person in (*world.people, *world.gone):
        assert person.session_recorder is not None
        person.session_recorder.close()
    return [read_recording(path) for path in world.recordings]


def test_falls_and_bounces_as_closed_forms_say() -> None:
    """From 20 mm, on springs without loss; each step of the fall is exact."""
    height, begin = 0.02, [[[0.0, 0.0, 0.02]] * 27] * 3
    text = session(world=SLICK, more="", hands=f"[initial]\nposition = {begin}")
    world = World(text, tick=5e-4)
    ann = world.join("Ann", moves=False)
    world.until(lambda: ann.member.replica is not None and ann.copy.peer is not None, 2.0)
    peer, heights, times = ann.copy.peer, [], []
    assert peer is not None
    for _ in range(600):
        world.run(world.tick)
        times.append(peer.integrated)
        heights.append(float(ann.position[:, 2].mean()))
    fall = np.sqrt(2.0 * height / 9.81)
    falling = [(t, z) for t, z in zip(times, heights, strict=True) if t < 0.95 * fall]
    assert max(abs(z - height + 0.5 * 9.81 * t**2) for t, z in falling) <= 1e-12
    bounced = np.array(heights)[np.array(times) > 1.2 * fall].max()
    assert bounced == pytest.approx(height, rel=0.05)  # the rest of it rings in the block
    world.check()


def test_what_falls_from_rest_is_judged_by_the_energy_that_its_weight_gives(tmp_path: Path) -> None:
    """Until it meets something the sum of its energies is rounding alone."""
    world = World(session(world=FAR), folder=tmp_path, tick=2e-3)
    ann = world.join("Ann", moves=False)
    world.until(lambda: ann.member.replica is not None and ann.copy.peer is not None, 2.0)
    world.run(0.4)
    totals = ann.copy.totals
    assert totals.in_play > 0.3 * WEIGHT * 0.5 * 9.81 * 0.4**2
    assert totals.residual <= 1e-12
    assert totals.alarms == 0
    (recording,) = recordings(world)
    result = audit([recording])
    assert result.in_play >= totals.in_play * (1.0 - 1e-9)
    assert not result.findings, result.verdict


@pytest.mark.parametrize(("law", "near", "creep"), [("spring", 1e-5, 1e-6), ("paid", 0.02, 2e-5)])
def test_rests_without_creep_whoever_comes_and_goes(law: str, near: float, creep: float) -> None:
    world = World(session(law=law), tick=2e-3)
    ann, _ = (world.join(name, moves=False) for name in ("Ann", "Ben"))
    world.until(world.all_coupled, 12.0)
    world.run(1.0)
    place = ann.position
    assert load(*world.people) == pytest.approx(WEIGHT, rel=near)
    cleo = world.join("Cleo", moves=False)
    world.until(lambda: len(world.people[0].states()) == 2 and world.all_coupled(), 12.0)
    world.run(1.0)
    assert load(*world.people) == pytest.approx(WEIGHT, rel=near)
    world.leave(cleo)
    world.run(1.0)
    assert np.abs(ann.position - place).max() <= creep
    world.check()
    for person in world.people:
        peer, totals = person.copy.peer, person.copy.totals
        assert peer is not None
        # What friction and shape hold beyond the least there was has to be paid for; that is next to nothing.
        assert 1.0 / 3.0 <= peer.stiffness_scale <= 0.5
        assert totals.residual <= 1e-10
        assert totals.closure_alarms <= 0.01 * totals.steps


@pytest.fixture(scope="module")
def lifted(tmp_path_factory: pytest.TempPathFactory) -> World:
    """Ann and Ben lift it, Cleo comes late and leaves while it hangs between them; then they go on holding."""
    world = World(session(hands=LIFT, rate=250), folder=tmp_path_factory.mktemp("lifted"), tick=2e-3)
    ann, _ = (world.join(name) for name in ("Ann", "Ben"))
    world.until(lambda: ann.member.replica is not None and ann.copy.peer is not None and low(ann) > 0.02, 12.0)
    cleo = world.join("Cleo", moves=False)
    world.until(lambda: len(ann.states()) == 2 and world.all_coupled(), 12.0)
    world.run(0.5)
    world.lifts = [low(person) for person in world.people]  # type: ignore[attr-defined]
    world.leave(cleo)
    world.run(0.7)
    return world


def test_two_people_lift_a_block_and_a_third_comes_and_goes(lifted: World) -> None:
    assert min(lifted.lifts) > 0.02  # type: ignore[attr-defined]
    assert all(low(person) > 0.02 for person in lifted.people)
    assert load(*lifted.people) == 0.0
    lifted.check()
    for person in lifted.people:
        assert person.copy.totals.residual <= 1e-10
        assert person.copy.totals.closure_alarms < 20


def test_what_hangs_gets_heavier_only_as_it_is_paid_for(lifted: World) -> None:
    """The leaver's share of the weight is not there until losses pay, or the block is put down."""
    for person in lifted.people:
        peer = person.copy.peer
        assert peer is not None
        assert 1.0 / 3.0 <= peer.stiffness_scale <= 0.5
        assert person.copy.totals.rescaled <= person.copy.totals.lost


def test_an_audit_works_weight_and_table_out_anew(lifted: World) -> None:
    found = recordings(lifted)
    result = audit(found)
    assert result.holds, result.verdict
    assert result.complete
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
        assert abs(ledger.residual) <= 1e-11 * result.in_play
    run = recordings_dataset(found)
    assert float(np.nanmax(run["world_stored"])) > 0.0


def test_a_recording_that_begins_on_the_table_holds(lifted: World) -> None:
    """How far friction is stretched there is not known, so the ledger's word is taken until it is lifted."""
    late = [recording.first_steps(recording.steps) for recording in recordings(lifted)[:2]]
    parts = [_from(recording, 40) for recording in late]
    result = audit(parts)
    assert not [finding for finding in result.findings if finding.user is not None], result.verdict


def _from(recording: Recording, first: int) -> Recording:
    columns = {name: values[first:] for name, values in recording.columns.items()}
    rows = recording.states["state_row"]
    keep = rows >= first
    states = {name: values[keep] for name, values in recording.states.items()}
    states["state_row"] = rows[keep] - first
    return replace(recording, columns=columns, states=states)


@pytest.mark.parametrize("number", [0, 2], ids=["stiffness", "friction"])
def test_an_audit_finds_another_table(lifted: World, number: int) -> None:
    one = recordings(lifted)[0]
    material = one.header.body.material
    assert material is not None
    laws = material.world["law"].copy()
    laws[0, number] *= 1.01
    other = type(material)(material.body, {**material.world, "law": laws})
    header = replace(one.header, body=replace(one.header.body, material=other))
    assert "damping" in {finding.place for finding in audit([replace(one, header=header)]).findings}


def test_who_begins_in_the_table_is_told() -> None:
    text = session(world="[[world.planes]]\npoint = [0, 0, 0.03]\n")
    with pytest.raises(ScenarioError, match=r"^a test: world.planes\[1\]: the copy of user 1 begins 0.03 m deep in it"):
        SharedModel.build(SessionFile.from_toml(text, source="a test"))


LIES = {
    "pulls it about": Lie(law="noise", size=0.2, state=2, seed=2),
    "energy that nobody had": Lie(law="noise", size=0.2, given=1.5e9, state=1, received=True, seed=2),
}


@pytest.mark.parametrize("what", LIES)
def test_a_liar_gains_nothing_more_of_what_weighs(what: str) -> None:
    limits = (
        "force_limit = 5.0\npower_limit = 0.5\ntank = 0.01\ninitial_energy = 1e-3\nallowance = 0.05\n"
        "age_limit = 1.0\nwindow = 1.0"
    )
    text = session(users=4, hands=LIFT, more=limits, rate=100)
    outcome = play(LIES[what], text=text.replace("spring = 25.0", f"spring = {SPRING}"), seconds=2.5)
    assert outcome.held, outcome.broken
    assert max(outcome.gain, outcome.work, outcome.received, outcome.damping) <= 1.0


def test_the_example_is_a_session() -> None:
    path = Path(__file__).parents[2] / "examples" / "block-between-two-hands.toml"
    shared = SharedModel.build(SessionFile.read(path))
    assert len(shared.shapes) == 1
