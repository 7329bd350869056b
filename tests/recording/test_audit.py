"""The audit finds nothing where there is nothing, and every joule that was put in by hand, where it was put in."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.recording.driven import Driven, pulled
from tests.recording.inside import align, findings_of, motions
from tests.simulation.stepped import Stepped

from cotouch.body import lattice, point
from cotouch.errors import RecordingError
from cotouch.peer import LinkState, Peer, Sample, StepReport
from cotouch.recording import Audit, audit, read_recording
from cotouch.scenario import Scenario
from cotouch.simulation import prepare

THREE = np.array([[0.0, 0.02, 0.05], [0.03, 0.0, np.inf], [0.01, np.inf, 0.0]])
STRONG = {0: pulled(amplitude=0.3, stiffness=200.0)}


def audited(driven: Driven) -> Audit:
    return audit([read_recording(path) for path in driven.run()])


def mean_rates(driven: Driven, user: int) -> np.ndarray:
    """v̂ of a point at every step, from the states that the test kept."""
    x = np.array([0.0, *(float(x[0, 0]) for x, _ in driven.states[user])])
    return np.diff(x) / driven.periods[user]


@pytest.mark.parametrize(
    "options",
    [
        {},
        {"clocks": (1234.5, 77.0), "with_used": True},
        {"delay": THREE, "periods": (0.002, 0.005, 0.01), "hands": STRONG},
        {"body": lattice((3, 2, 2), ground="all", ground_stiffness=5.0)},
        {"body": lattice((2, 2, 2)).as_full()},
        {"body": lattice((3, 2, 2)).truncated(modes=8, contacts=[0])},
        {"body": point(mass=3.0), "hands": {0: pulled(), 1: pulled(amplitude=-0.2)}, "with_used": True},
    ],
    ids=["point", "clocks", "three", "lattice", "full", "truncated", "two hands"],
)
def test_an_honest_session_holds(tmp_path: Path, options: dict[str, Any]) -> None:
    driven = Driven(tmp_path, **options)
    result = audited(driven)
    assert result.holds, result.verdict
    assert result.verdict.startswith("Holds: every step's energy")
    assert result.findings == ()
    assert result.complete
    assert result.margin >= -result.tolerance
    for user, ledger in enumerate(result.users):
        reports = driven.reports[user]
        assert ledger.supplied == pytest.approx(sum(r.supplied for r in reports), abs=1e-12)
        assert ledger.local_loss == pytest.approx(sum(r.local_loss for r in reports), abs=1e-12)
        assert ledger.link_work == pytest.approx(sum(float(r.link_work.sum()) for r in reports), abs=1e-12)
        assert abs(ledger.residual) < 1e-12
    for ledger in result.links:
        assert ledger.strict
        assert ledger.whole
        assert ledger.unknown < 0.15  # only those before the first sample
        assert ledger.excess <= result.tolerance


def test_a_links_books_are_those_of_the_formula(tmp_path: Path) -> None:
    """W on both ends and the spring, by sums over what the test itself kept."""
    driven = Driven(tmp_path, hands=STRONG)
    result = audited(driven)
    (ledger,) = result.links
    works = [sum(float(r.link_work[0]) for r in driven.reports[user]) for user in range(2)]
    assert ledger.work == pytest.approx(works, abs=1e-12)
    ends = [float(driven.states[user][-1][0][0, 0]) for user in range(2)]
    assert ledger.spring == pytest.approx(0.5 * driven.spring * (ends[0] - ends[1]) ** 2, abs=1e-12)
    assert ledger.by_state == pytest.approx({"coupled": sum(works) + ledger.spring}, abs=1e-12)
    lost = sum(r.local_loss for reports in driven.reports for r in reports)
    assert ledger.dissipated == pytest.approx(lost, abs=1e-12)
    most = [max(float(r.age[0]) for r in driven.reports[user]) for user in range(2)]
    assert ledger.age == pytest.approx(most, abs=1e-12)
    assert result.users[0].asked == pytest.approx(0.5 * driven.spring * sum(most), abs=1e-9)


def test_a_force_recorded_as_half_is_found_at_the_hand(tmp_path: Path) -> None:
    missing: list[float] = []

    def half(user: int, report: StepReport) -> StepReport:
        return replace(report, force=0.5 * report.force) if user == 0 and report.sample.index >= 100 else report

    driven = Driven(tmp_path, hands=STRONG, change=half)
    result = audited(driven)
    rates = mean_rates(driven, 0)
    missing += [0.5 * float(r.force[0, 0]) * rates[k] * 0.004 for k, r in enumerate(driven.reports[0]) if k >= 100]
    assert not result.holds
    first = result.findings[0]
    assert (first.place, first.user, first.step) == ("hands", 0, 100)
    worst = np.cumsum(missing)[np.argmax(np.abs(np.cumsum(missing)))]
    assert first.energy == pytest.approx(-worst, rel=1e-9)
    assert [finding.place for finding in result.findings] == ["hands"]
    assert "Ann" in first.words


def test_one_joule_that_came_between_two_steps_is_found(tmp_path: Path) -> None:
    def kick(peer: Peer, now: float) -> None:
        if peer.index == 1 and peer.steps == 49:
            v = float(peer.state.velocity[0, 0])
            # ½ (m/N) ((v + Δ)² - v²) = 1 J for m/N = ½ kg
            peer.state.velocity[:] = np.sqrt(v * v + 4.0)

    result = audited(Driven(tmp_path, disturb=kick))
    first = result.findings[0]
    assert (first.place, first.user, first.step) == ("between steps", 1, 49)
    assert first.energy == pytest.approx(1.0, rel=1e-9)
    assert first.time == pytest.approx(0.5)
    assert "Ben" in result.verdict


def test_a_joule_in_the_recorded_state_alone_is_found_too(tmp_path: Path) -> None:
    """The peer did right, but what stands in the file is another position: nothing fits any more."""
    recorded = Driven(tmp_path, hands=STRONG)

    def forge(user: int, report: StepReport) -> StepReport:
        if user == 1 and report.sample.index == 30:
            return replace(report, sample=replace(report.sample, position=report.sample.position + 0.01))
        return report

    recorded.change = forge
    result = audited(recorded)
    assert not result.holds
    assert {finding.user for finding in result.findings} >= {1}
    assert 30 in {finding.step for finding in result.findings if finding.user == 1}


def test_a_sample_that_its_sender_never_sent_is_found_at_the_link(tmp_path: Path) -> None:
    def forge(receiver: int, sample: Sample) -> Sample:
        return replace(sample, position=sample.position + 0.5) if receiver == 0 and 20 <= sample.index < 30 else sample

    driven = Driven(tmp_path, deliver=forge)
    result = audited(driven)
    first = result.findings[0]
    assert (first.place, first.user, first.link) == ("link", 0, (0, 1))
    rates = mean_rates(driven, 0)
    # The spring pulled towards a place half a metre further, so long as those samples were used.
    indices = [round((r.sample.stamp + 0.002 - float(r.age[0]) - 0.005) / 0.01) for r in driven.reports[0]]
    forged = [-60.0 * 0.5 * rates[k] * 0.004 for k, index in enumerate(indices) if 20 <= index < 30]
    worst = np.cumsum(forged)[np.argmax(np.abs(np.cumsum(forged)))]
    assert first.energy == pytest.approx(worst, rel=1e-6)
    assert "Ben recorded" in first.words


def test_too_little_damping_and_a_hand_that_takes_are_found(tmp_path: Path) -> None:
    driven = Driven(tmp_path, damping=(0.0, 0.0), seconds=2.0)
    result = audited(driven)
    assert not result.holds
    places = {finding.place: finding for finding in result.findings}
    assert set(places) == {"link", "network"}
    assert places["link"].link == (0, 1)
    assert places["link"].energy == pytest.approx(result.links[0].by_state["coupled"], rel=1e-6)
    supplied = sum(sum(r.supplied for r in reports) for reports in driven.reports)
    assert supplied < 0.0
    assert places["network"].energy >= -supplied * (1 - 1e-9)
    assert any("requires" in note for note in result.notes)
    for ledger in result.users:
        assert abs(ledger.residual) < 1e-9  # nobody's own ledger is wrong


def test_enough_damping_takes_what_the_ages_make(tmp_path: Path) -> None:
    """The bound as it is asked for, with everybody's hands, over many sessions: the links are never beyond it."""
    rng = np.random.default_rng(0)
    for k in range(6):
        folder = tmp_path / str(k)
        folder.mkdir()
        hands = {user: pulled(amplitude=rng.normal(0.0, 0.3), stiffness=rng.uniform(20.0, 900.0)) for user in range(3)}
        driven = Driven(folder, delay=THREE, periods=tuple(rng.choice([0.004, 0.01, 0.016], 3)), hands=hands)
        result = audited(driven)
        assert result.holds, result.verdict
        assert all(ledger.excess <= result.tolerance for ledger in result.links)


def test_unix_times_that_are_apart_are_corrected(tmp_path: Path) -> None:
    right = audited(Driven(tmp_path, hands=STRONG))
    (tmp_path / "b").mkdir()
    apart = Driven(tmp_path / "b", hands=STRONG, unix_error=(0.0, 0.4), clocks=(5.0, 900.0))
    recordings = [read_recording(path) for path in apart.run()]
    offsets, corrected = align(recordings)
    assert corrected
    # The ways take 50 and 30 ms, and samples wait for a step: half the difference is what cannot be known.
    assert offsets[1] - offsets[0] == pytest.approx(-895.0, abs=0.02)
    wrong = audit(recordings)
    assert wrong.holds
    assert any("aligned by the ages" in note for note in wrong.notes)
    assert wrong.links[0].spring == pytest.approx(right.links[0].spring, rel=0.5)
    assert wrong.links[0].work == pytest.approx(right.links[0].work, rel=1e-9)


@pytest.mark.parametrize("age", [-3.0, -1e6])
def test_one_age_that_cannot_be_sets_no_clock(tmp_path: Path, age: float) -> None:
    driven = Driven(tmp_path, hands=STRONG)
    recordings = [read_recording(path) for path in driven.run()]
    right, _ = align(recordings)
    ages = recordings[0].columns["age"] = recordings[0].columns["age"].copy()
    ages[60, 0] = age
    assert align(recordings) == (right, False)
    result = audit(recordings)
    assert result.holds, result.verdict
    assert result.notes == (f"Ann used a sample of Ben at an age of {age:.3g} s, which cannot be",)
    for early in (-3e-5, -1e-3):  # two clocks are not read at once, and a step goes on reading for a little
        ages[60, 0] = early
        assert not audit(recordings).notes
    ages[60, 0] = -1.5e-3
    assert audit(recordings).notes
    # Where all of them cannot be, it is the clocks.
    ages -= 0.4
    offsets, corrected = align(recordings)
    assert corrected
    assert offsets[1] - offsets[0] == pytest.approx(-0.2, abs=0.02)


def test_what_is_kept_less_often_is_taken_as_booked(tmp_path: Path) -> None:
    driven = Driven(tmp_path, options={"every": 5}, hands=STRONG)
    result = audited(driven)
    assert result.holds
    assert not result.complete
    assert result.verdict.startswith("Holds, as far as recorded")
    assert result.users[0].worked_out == 50
    assert not result.links[0].strict


@pytest.mark.parametrize("every", [1, 8])
def test_a_body_that_turns_far_within_long_steps_holds(tmp_path: Path, every: int) -> None:
    """What its cells hold follows from where their corners are, so an audit need not have seen them turn."""
    body = lattice((4, 3, 3), model="cells", mass=0.05, stiffness=4.0, spacing=0.02, damping=0.001)
    hard = {0: pulled(amplitude=0.4, stiffness=30.0)}
    driven = Driven(
        tmp_path, body=body, periods=(0.03, 0.03), spring=0.2, seconds=3.0, hands=hard, options={"every": every}
    )
    result = audited(driven)
    assert max(report.closure_factor for report in driven.reports[0]) > 0.05
    assert result.holds, result.verdict


def test_a_body_that_is_pulled_inside_out_holds(tmp_path: Path) -> None:
    body = lattice((4, 3, 3), model="cells", mass=0.012, stiffness=100.0, spacing=0.01)
    hard = {0: pulled(amplitude=0.5, stiffness=900.0)}
    driven = Driven(
        tmp_path, body=body, periods=(0.013, 0.028), spring=2.0, seconds=3.0, hands=hard, options={"every": 8}
    )
    result = audited(driven)
    assert result.holds, result.verdict


def test_a_kick_is_found_between_kept_states(tmp_path: Path) -> None:
    def kick(peer: Peer, now: float) -> None:
        if peer.index == 0 and peer.steps == 103:
            peer.state.velocity[:] += 1.0

    result = audited(Driven(tmp_path, options={"every": 5}, hands=STRONG, disturb=kick))
    assert (result.findings[0].place, result.findings[0].user) == ("between steps", 0)
    assert result.findings[0].step == 105


def test_an_error_of_what_is_stored_counts_once_however_long_it_stays(tmp_path: Path) -> None:
    """It is a level: friction that was worked out a rounding off stays so until it slips, in a thousand steps."""
    (motion, _) = motions([read_recording(path) for path in Driven(tmp_path).run()], [0.0, 0.0])
    stays = np.where(np.arange(motion.end.size) < 20, 0.0, 1e-3)
    stays[60:70] = -2e-3
    off = replace(motion, difference={**motion.difference, "stored": stays})
    assert not findings_of(off, 3.5e-3, 0.0, {0: "Ann", 1: "Ben"})
    (found,) = findings_of(off, 1.5e-3, 0.0, {0: "Ann", 1: "Ben"})
    assert (found.place, found.step) == ("state", 20)
    assert found.energy == pytest.approx(-2e-3)
    assert found.words == "the energy of position and velocity at Ann is 0.002 J less than the ledger says"


def test_a_recording_that_is_cut_off_is_judged_as_far_as_it_goes(tmp_path: Path) -> None:
    driven = Driven(tmp_path, options={"interval": 0.1}, hands=STRONG)
    one, two = driven.run()
    data = two.read_bytes()
    two.write_bytes(data[: len(data) // 2])
    result = audit([read_recording(one), read_recording(two)])
    assert result.holds, result.verdict
    assert not result.complete
    assert not result.links[0].whole
    assert any("cut off after step" in note for note in result.notes)


def test_one_recording_alone_is_audited_for_itself(tmp_path: Path) -> None:
    path = Driven(tmp_path, hands=STRONG).run()[0]
    result = audit([read_recording(path)])
    assert result.holds
    assert result.links == ()
    assert any("no recording of user 2" in note for note in result.notes)


def test_what_one_user_got_out_is_held_against_nobody_where_another_is_not_recorded(tmp_path: Path) -> None:
    """A hand that brakes takes out what the other put in; only both recordings together can say that."""
    held = {0: pulled(amplitude=0.2, stiffness=200.0), 1: pulled(amplitude=0.0, stiffness=0.0, damping=40.0)}
    both = [read_recording(path) for path in Driven(tmp_path, hands=held).run()]
    assert audit(both).holds
    alone = audit(both[1:])
    assert alone.margin < -1e-3
    assert alone.holds, alone.verdict
    assert any("is not known" in note for note in alone.notes)


def test_phases_of_a_link_share_what_it_made(tmp_path: Path) -> None:
    """While it is guarded, the spring is not held against it; sums over phases are the whole all the same."""
    plain = audited(Driven(tmp_path, hands=STRONG))
    (tmp_path / "b").mkdir()

    def phase(user: int, now: float) -> list[int]:
        return [LinkState.GUARDED if 0.3 <= now < 0.6 else LinkState.COUPLED]

    result = audited(Driven(tmp_path / "b", hands=STRONG, link_state=phase))
    assert set(result.links[0].by_state) == {"coupled", "guarded"}
    assert sum(result.links[0].by_state.values()) == pytest.approx(plain.links[0].by_state["coupled"], abs=1e-12)
    assert result.links[0].unknown > plain.links[0].unknown + 0.2
    assert result.holds


def test_somebody_joins_and_every_copy_gets_lighter(tmp_path: Path) -> None:
    driven = Driven(tmp_path, hands=STRONG)

    def join(peer: Peer, now: float) -> None:
        if now >= 0.5 and peer.stiffness_scale > 0.4:
            recorder = driven.recorders[peer.index]
            recorder.setup(
                now,
                copies=3,
                neighbours=peer.neighbours,
                strength=[driven.spring],
                local_damping=[driven.local(peer.index)],
                extra_damping=[0.1],
                ports=[0],
            )
            peer.rescale(3)

    driven.disturb = join
    result = audited(driven)
    assert result.holds, result.verdict
    for user, ledger in enumerate(result.users):
        at = round(0.5 / driven.periods[user]) - 1  # the state before the step that ends at 0.5 s
        x, v = (float(values[0, 0]) for values in driven.states[user][at - 1])
        energy = 0.5 * 1.0 * v * v + 0.5 * 4.0 * x * x
        assert ledger.members == pytest.approx((1 / 3 - 1 / 2) * energy, rel=1e-9)
        assert abs(ledger.residual) < 1e-12


def with_tools(folder: Path) -> list[Path]:
    """A small solid between two users with tools, one of them with a device, peer by peer."""
    scenario = Scenario.make(
        network={"users": ["Ann", "Ben"], "spring": [[0, 60], [60, 0]], "delay": [[0, 0.02], [0.02, 0]]},
        body={"kind": "lattice", "shape": [3, 3, 3], "ground": "z-", "ground_stiffness": 200.0},
        synchronisation={"law": "spring"},  # as what records it says
        steps={"duration": 0.4, "period": 0.004},
        tools=[
            {"user": 1, "at": [0.0, 0.0, 0.08], "hand": {"path": [0.0, 0.0, -0.04], "stiffness": 80.0}},
            {"user": 2, "kind": "grasp", "at": [0.05, 0.0, 0.0], "hand": {"path": [0.02, 0.0, 0.0]}},
        ],
    )
    return recorded_world(scenario, folder)


def recorded_world(scenario: Scenario, folder: Path) -> list[Path]:
    assert scenario.network.size == 1 or scenario.law[0] == "spring", "links of other laws are not springs"
    from cotouch.recording import RecordedBody, Recorder, RecordHeader

    prepared = prepare(scenario)
    world = Stepped(prepared)
    recorders: list[Recorder] = []
    for i, peer in enumerate(world.peers):
        header = RecordHeader(
            user=i,
            name=scenario.network.users[i],
            monotonic=0.0,
            unix=1e9,
            body=RecordedBody.of(prepared.model),
            configuration={"scenario": scenario.as_json()},
        )
        recorder = Recorder(folder / f"{i}.mcap", header, buffers=64, every=1)
        tools = peer.tools
        recorder.setup(
            0.0,
            copies=len(world.peers),
            neighbours=peer.neighbours,
            strength=[float(scenario.network.spring[i, j]) for j in peer.neighbours],
            local_damping=prepared.local_damping[i],
            extra_damping=prepared.extra_damping[i],
            ports=None,
            tool_mass=[] if tools is None else tools.mass,
        )
        recorders.append(recorder)

    def recorded(peer: Peer, report: StepReport, now: float, T: float) -> None:
        recorders[peer.index].step(report, end=now, T=T, state=peer.state, tools=peer.tools)
        if report.cut_elements and peer.cuts is not None:
            cut = list(report.cut_elements)
            by = peer.cuts.by[cut].tolist()
            recorders[peer.index].event("cut", now, step=report.sample.index, elements=cut, by=by)

    world.run(recorded)
    for recorder in recorders:
        assert recorder.close().failure is None
    return [folder / f"{i}.mcap" for i in range(len(recorders))]


def test_tools_are_audited_too(tmp_path: Path) -> None:
    recordings = [read_recording(path) for path in with_tools(tmp_path)]
    result = audit(recordings)
    assert result.holds, result.verdict
    assert max(float(r.columns["touch_stored"].max()) for r in recordings) > 1e-6
    for recording, ledger in zip(recordings, result.users, strict=True):
        assert ledger.supplied == pytest.approx(float(recording.columns["drive_work"].sum()), rel=1e-6)
        assert ledger.supplied > 1e-8
        assert abs(ledger.residual) < 1e-12
    # One proxy that is faster than what acts on it.
    columns = dict(recordings[0].columns)
    columns["tool_velocity"] = np.array(columns["tool_velocity"])
    columns["tool_velocity"][50] += 0.1
    forged = audit([replace(recordings[0], columns=columns), recordings[1]])
    assert not forged.holds
    assert {finding.place for finding in forged.findings} <= {"proxies", "step"}
    assert {finding.user for finding in forged.findings} == {0}


def test_a_copy_that_leaves_floating_point_is_no_copy_that_holds(tmp_path: Path) -> None:
    def burst(peer: Peer, now: float) -> None:
        if peer.index == 1 and peer.steps == 60:
            peer.state.velocity[:] = np.inf

    with np.errstate(all="ignore"):
        result = audited(Driven(tmp_path, disturb=burst))
    first = result.findings[0]
    assert (first.place, first.energy) == ("state", np.inf)
    assert {(finding.user, finding.step) for finding in result.findings if finding.place == "state"} >= {(1, 60)}
    assert not result.holds


def test_recordings_that_do_not_belong_together_are_refused(tmp_path: Path) -> None:
    one, two = (read_recording(path) for path in Driven(tmp_path).run())
    with pytest.raises(RecordingError, match="no recording was given"):
        audit([])
    with pytest.raises(RecordingError, match="both of user 1"):
        audit([one, one])
    other = replace(two, header=replace(two.header, session="elsewhere"))
    with pytest.raises(RecordingError, match="from session 'elsewhere'"):
        audit([one, other])
    (tmp_path / "b").mkdir()
    heavy = read_recording(Driven(tmp_path / "b", body=point(mass=9.0)).run()[1])
    with pytest.raises(RecordingError, match="of a different body"):
        audit([one, heavy])
    with pytest.raises(RecordingError, match="no event of kind setup"):
        audit([replace(one, events=())])


def test_the_numbers_count_users_from_one(tmp_path: Path) -> None:
    numbers = audited(Driven(tmp_path, damping=(0.0, 0.0), seconds=2.0)).numbers()
    assert [user["user"] for user in numbers["users"]] == [1, 2]
    assert numbers["links"][0]["link"] == [1, 2]
    assert numbers["holds"] is False
    assert numbers["findings"][0]["place"] == "link"


@pytest.mark.parametrize("whole", [True, False])
def test_what_one_user_got_out_is_not_held_against_anybody_once_another_is_cut_off(tmp_path: Path, whole: bool) -> None:
    """What that one's hand put in after its recording ended is in no file."""
    options = {"hands": {0: pulled(amplitude=0.3, stiffness=200.0), 1: brake}, "seconds": 2.0}
    first, second = (read_recording(path) for path in Driven(tmp_path, **options).run())
    assert audit([first, second]).holds
    early = first.first_steps(first.steps // 4)
    result = audit([replace(early, broken=None if whole else "it ends before its index"), second])
    assert result.holds, result.verdict
    end = float(early.time[-1] - first.time[0] + first.columns["period"][0])
    assert any(f"steps are missing from {end:.2f} s on" in note for note in result.notes)
    assert result.margin_time <= end + 1e-9
    assert result.numbers()["holds"]


def brake(peer: Peer, now: float, T: float) -> None:
    """A hand that only takes: a damper to a place that does not move."""
    peer.ports.damping[:] = 20.0
