"""Recordings of a session with a cut path, a crash and a return, on a virtual clock: no book of them may be bent."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.session.chain import chain
from tests.session.world import World

from cotouch.peer import LinkState
from cotouch.recording import ADVANCED, EXCHANGE, GUARDS, Recording, audit, read_recording
from cotouch.samples import PathLaw

SESSION = chain(
    rate=125, path="[[0, 0], [1, 0.05], [3, 0.05], [5, -0.05], [8, -0.05], [9, 0.05], [13, 0.05], [14, -0.05]]"
)


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> list[Recording]:
    """Ann, Ben, Cleo, and Cleo again."""
    world = World(SESSION, folder=tmp_path_factory.mktemp("session"), tick=1e-3)
    ann, ben, cleo = (world.join(name, moves=name == "Ann") for name in ("Ann", "Ben", "Cleo"))
    world.until(world.all_coupled, 12.0)
    world.paths(ann, ben, PathLaw(down=True))
    world.run(2.0)
    world.paths(ann, ben, PathLaw(delay=0.005))
    world.run(1.0)
    world.kill(cleo)
    world.run(12.0)  # she is taken for gone, and the copies get heavier and stiffer
    world.join("Cleo", moves=False)
    world.run(3.0)
    world.check()
    for person in world.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    return [read_recording(path) for path in world.recordings]


def bent(
    recordings: list[Recording], who: int, name: str, change, *, fraction: float = 0.5, other: int = 1
) -> list[Recording]:
    """With one column of one of them changed, after a share of the steps."""
    one = recordings[who]
    values = np.array(one.columns[name], dtype=float)
    half = int(fraction * one.steps)
    link = one.neighbours.index(other)
    values[half:, link] = change(values[half:, link], one.columns["link_state"][half:, link])
    return [*recordings[:who], replace(one, columns={**one.columns, name: values}), *recordings[who + 1 :]]


def test_all_of_it_holds(recordings: list[Recording]) -> None:
    result = audit(recordings)
    assert result.holds, result.verdict
    assert [recording.name for recording in recordings] == ["Ann", "Ben", "Cleo", "Cleo"]
    # Both of Cleo's lives are linked to both others.
    assert [ledger.ends for ledger in result.links] == [(0, 1), (0, 2), (0, 2), (1, 2), (1, 2)]
    assert all(ledger.work[0] != 0.0 for ledger in result.links)
    guarded = [recording.columns["link_state"] == LinkState.GUARDED for recording in recordings]
    assert all(phase.any() for phase in guarded)
    fractions = recordings[0].columns["stiffness_scale"]
    assert fractions[-1] == fractions.min() < fractions.max()  # K rose when she was gone, as far as losses paid
    assert max(abs(ledger.residual) for ledger in result.users) < 1e-12


@pytest.mark.parametrize("name", GUARDS)
def test_each_book_of_a_guard_counts(recordings: list[Recording], name: str) -> None:
    result = audit(bent(recordings, 0, name, lambda values, phase: values + 1e-3))
    assert {finding.place for finding in result.findings} == {"guard"}
    assert abs(result.findings[0].energy) == pytest.approx(1e-3, rel=1e-6)


def test_what_a_guarded_end_moves_unpaid_is_found(recordings: list[Recording]) -> None:
    """Tank and payments are lowered alike, so that the tank's own balance stays."""
    less = bent(recordings, 1, "paid", lambda values, phase: 0.5 * values, fraction=0.0, other=0)
    gave = recordings[1].columns["paid"] - less[1].columns["paid"]
    discarded = np.array(recordings[1].columns["discarded"]) + gave
    forged = replace(less[1], columns={**less[1].columns, "discarded": discarded})
    words = [finding.words for finding in audit([recordings[0], forged, *recordings[2:]]).findings]
    assert words
    assert all("without paying" in text for text in words)


def test_what_no_damping_took_is_not_credited(recordings: list[Recording]) -> None:
    more = bent(recordings, 0, "credited", lambda values, phase: values + 1e3 * (values - values[0]))
    got = more[0].columns["credited"] - recordings[0].columns["credited"]
    discarded = np.array(recordings[0].columns["discarded"]) + got
    forged = replace(more[0], columns={**more[0].columns, "discarded": discarded})
    words = [finding.words for finding in audit([forged, *recordings[1:]]).findings]
    assert words
    assert all("credited" in text for text in words)


@pytest.fixture(scope="module")
def exchange(tmp_path_factory: pytest.TempPathFactory) -> list[Recording]:
    """Ann's hand goes away while nothing passes; Ben has next to no energy of his own to follow, and gets hers."""
    text = """
[session]
users = 2
spring = 60.0
initial_energy = 1e-6
[body]
mass = 0.5
damping = 0.2
[steps]
rate = 250
[synchronisation]
law = "spring"
[[hands]]
user = 1
path = [[0, 0], [2, 0.0], [3, 0.1]]
stiffness = 40.0
damping = 1.0
"""
    world = World(text, folder=tmp_path_factory.mktemp("exchange"), tick=1e-3)
    ann, ben = world.join("Ann"), world.join("Ben", moves=False)
    world.until(world.all_coupled, 3.0)
    world.paths(ann, ben, PathLaw(down=True))
    world.run(2.0)
    world.paths(ann, ben, PathLaw(delay=0.005))
    world.run(3.0)
    assert world.all_coupled()
    world.check()
    for person in world.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    return [read_recording(path) for path in world.recordings]


def forged(one: Recording, link: int, energy: float, *names: str, since: float = 0.7) -> Recording:
    """So much more in some ledger of a link, at once."""
    more = np.zeros((one.steps, len(one.neighbours)))
    more[int(since * one.steps) :, link] = energy
    return replace(one, columns={**one.columns, **{name: one.columns[name] + more for name in names}})


def test_what_one_end_took_the_other_gave(exchange: list[Recording]) -> None:
    """What is forged balances at the one who took it: only both recordings together show it."""
    ann, ben = exchange
    assert audit(exchange).holds
    gave, got = float(np.nanmax(ann.columns["sent"])), float(np.nanmax(ben.columns["received"]))
    assert gave == got > 0.01
    one = forged(ben, 0, 1.0, "received", "taken", "discarded")
    (finding,) = audit([ann, one]).findings
    assert (finding.place, finding.user, finding.link) == ("guard", 1, (1, 0))
    assert finding.energy == pytest.approx(1.0, rel=1e-9)
    assert finding.step == ben.columns["index"][int(0.7 * ben.steps)]
    assert finding.words == "Ben took 1 J from Ann that Ann had not given"
    assert audit([one]).holds
    # Ann says that she gave it, and has it from nowhere else; but not, if she did so later.
    for since, users in ((0.6, []), (0.8, [1])):
        two = forged(ann, 0, 1.0, "sent", "given", since=since)
        discarded = two.columns["discarded"] - (two.columns["sent"] - ann.columns["sent"])
        two = replace(two, columns={**two.columns, "discarded": discarded})
        assert [f.user for f in audit([two, one]).findings] == users
    # An old recording, which does not say, is judged by what it says.
    old = [replace(r, columns={n: v for n, v in r.columns.items() if n not in EXCHANGE}) for r in exchange]
    assert audit(old).holds
    assert audit([old[0], one]).holds


@pytest.mark.parametrize(("early", "accused"), [(0.9e-3, []), (2e-3, [1])])
def test_a_step_may_use_what_comes_while_it_still_reads(
    exchange: list[Recording], early: float, accused: list[int]
) -> None:
    """A process that stands still after it read the clock reads what its neighbour sent meanwhile."""
    ann, ben = exchange
    got, gave = ben.columns["received"][:, 0], ann.columns["sent"][:, 0]
    steps = np.flatnonzero(np.diff(got) > 1e-6 * np.nanmax(got)) + 1
    before = ann.columns["time"][np.searchsorted(gave, got[steps]) - 1]  # she had not given it yet
    after = float(np.min(ben.columns["time"][steps] - before)) + ben.header.offset - ann.header.offset
    late = replace(ann, columns={**ann.columns, "time": ann.columns["time"] + after + early})
    assert [f.user for f in audit([late, ben]).findings if "had not given" in f.words] == accused


def test_a_recording_that_was_cut_off_accuses_nobody(exchange: list[Recording]) -> None:
    """What the other gave after its last batch is not known."""
    ann, ben = exchange
    cut = ann.first_steps(int(0.2 * ann.steps))
    assert float(np.nanmax(cut.columns["sent"])) == 0.0
    assert [f.user for f in audit([cut, ben]).findings if "had not given" in f.words] == [1]
    assert not [f for f in audit([replace(cut, broken="cut off"), ben]).findings if "had not given" in f.words]


@pytest.mark.parametrize(
    ("names", "words"),
    [
        (("received",), "exchanged more"),
        (("sent",), "exchanged more"),
        (("taken", "discarded"), "took more from the copy"),
    ],
)
def test_what_tanks_take_comes_from_somewhere(recordings: list[Recording], names: tuple[str, ...], words: str) -> None:
    one = forged(recordings[0], recordings[0].neighbours.index(1), 1.0, *names)
    assert any(words in finding.words for finding in audit([one]).findings)


def test_an_allowance_is_counted_and_cannot_be_stretched(recordings: list[Recording]) -> None:
    """Cleo comes where the object is held, and comes again: twice her links got what it took."""
    result = audit(recordings)
    got = [float(recording.columns[ADVANCED].sum()) for recording in recordings]
    assert got[0] == 0.0  # Ann was alone
    assert got[3] > 1e-3
    assert result.initial == pytest.approx(sum(got) + 10 * 1e-3)  # ends of links: 3, 3, 2 and 2
    for value, words in ((2.0, "more of the newcomer's allowance"), (-1.0, "more of the newcomer's allowance")):
        column = np.array(recordings[3].columns[ADVANCED])
        column[column.size // 2] += value
        one = replace(recordings[3], columns={**recordings[3].columns, ADVANCED: column})
        result = audit([*recordings[:3], one])
        assert any(words in finding.words for finding in result.findings)
        assert result.initial < 2.0
    less = {**recordings[3].columns, ADVANCED: np.zeros(recordings[3].steps)}
    findings = audit([*recordings[:3], replace(recordings[3], columns=less)]).findings
    assert any("took more from the copy" in finding.words for finding in findings)


def test_books_that_are_not_finite_hide_nothing(recordings: list[Recording]) -> None:
    for name in GUARDS:
        result = audit(bent(recordings, 0, name, lambda values, phase: values * np.nan))
        assert "not finite" in result.findings[0].words


def test_a_share_that_rises_unpaid_is_found(recordings: list[Recording]) -> None:
    one = recordings[0]
    without = replace(one, columns={n: values for n, values in one.columns.items() if n != "stiffness_scale"})
    assert {f.user for f in audit([without, *recordings[1:]]).findings} == {0}


TOUCHED = """
[session]
users = 2
spring = 60.0
[body]
kind = "lattice"
shape = [4, 3, 3]
spacing = 0.03
mass = 0.5
damping = 1.0
stiffness = 80.0
ground = "x-"
ground_stiffness = 80.0
[steps]
rate = 250
[contact]
law = "stiffening"
snap = {force = 0.2, range = 0.002}
texture = {heights = [[0, 0.0002], [0.0005, 0.0001]], size = [0.02, 0.02], projection = "z"}
[[tools]]
user = 1
at = [0.06, 0.03, 0.08]
radius = 0.015
friction = 0.5
kinetic_friction = 0.3
hand = {path = [[0, 0, 0, 0], [1, 0, 0, -0.03], [2, -0.02, 0.01, -0.03], [3, 0, 0, 0.02]], stiffness = 80.0}
[[tools]]
user = 2
at = [0.09, 0.03, -0.02]
radius = 0.015
axis = [0.0, 0.01, 0.0]
hand = {path = [[0, 0, 0, 0], [1.5, 0, 0, 0.03]], stiffness = 80.0}
"""


def test_a_session_that_touches_by_a_law_keeps_an_exact_ledger(tmp_path: Path) -> None:
    """Two members and their tools; one comes late, so the other's share of the body changes while it touches."""
    world = World(TOUCHED, folder=tmp_path, tick=1e-3)
    ann = world.join("Ann")
    world.run(1.5)
    assert ann.copy.peer is not None
    tools = ann.copy.peer.tools
    assert tools is not None
    assert tools.touching[0] == 1
    world.join("Ben")
    world.until(world.all_coupled, 12.0)
    world.run(4.0)
    world.check()
    for person in world.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    recordings = [read_recording(path) for path in world.recordings]
    result = audit(recordings)
    assert result.holds, result.verdict
    for recording, ledger in zip(recordings, result.users, strict=True):
        assert float(np.abs(recording.columns["touch_stored"]).max()) > 1e-6  # a well holds less than nothing
        assert float(recording.columns["touch_loss"].min()) >= 0.0
        assert abs(ledger.residual) < 1e-12
    columns = dict(recordings[0].columns)  # a contact that gave more than it had
    columns["touch_work"] = columns["touch_work"] + 1e-5 * (np.arange(recordings[0].steps) == 300)
    forged = audit([replace(recordings[0], columns=columns), recordings[1]])
    assert not forged.holds
    assert "contacts" in {finding.place for finding in forged.findings}
