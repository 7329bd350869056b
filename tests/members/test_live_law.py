"""Sessions whose links a law holds that is passive by itself, instead of guarded springs."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.members.liar import Liar
from tests.members.lie import Lie
from tests.session.chain import chain
from tests.session.world import Person, World

from cotouch.errors import ScenarioError, SessionError
from cotouch.laboratory import impedance
from cotouch.laws import PAID, Facts, laws
from cotouch.members import LiveLaw, SessionFile, SharedModel, law_felt
from cotouch.network import Network
from cotouch.peer import CopyMemory, FreshestLink, LawLink, Message, Sample
from cotouch.recording import Recording, audit, read_recording
from cotouch.samples import HEAD_BYTES, Arrival, Assembly, Chunk, Heading, PathLaw, Refusal, SampleCodec

LAWS = laws()

POINT = """
[session]
users = {users}
spring = 50.0
[body]
kind = "point"
mass = 1.0
[steps]
rate = 200
[synchronisation]
law = {law}
"""
HAND = """
[[hands]]
user = {user}
path = {path}
stiffness = 300.0
damping = 6.5
"""


def text(law: str = '"paid"', users: int = 2, hands: str = "") -> str:
    return POINT.format(law=law, users=users) + hands


def carried(user: int = 1) -> str:
    return HAND.format(user=user, path="[[0, 0], [1.5, 0], [2.5, 0.1], [3.5, 0.1], [5.5, 0.0]]")


def made(world: World) -> float:
    """What all links together made so far, of those here or gone."""
    return sum(
        person.copy.totals.linked for person in (*world.people, *world.gone) if person.member.replica is not None
    )


def seeds(world: World) -> float:
    everybody = (*world.people, *world.gone)
    return sum(person.copy.initial_energies for person in everybody if person.member.replica is not None)


def watched(world: World, seconds: float) -> None:
    """Runs on; at no time is more made than seeds, and no step's energy is unexplained."""
    for _ in range(round(seconds / 0.05)):
        world.run(0.05)
        assert made(world) <= seeds(world) + 1e-9
    world.check()


LIVE = [law.name for law in LAWS.values() if law.live]


@pytest.mark.parametrize("law", LIVE)
def test_two_carry_an_object(law: str) -> None:
    world = World(text(f'"{law}"', hands=carried()), law=PathLaw(delay=0.02, jitter=0.01, loss=0.05), tick=2.5e-3)
    ann, ben = world.join("Ann"), world.join("Ben")
    world.until(world.all_coupled, 3.0)
    watched(world, 4.0 - world.now)
    places = [float(person.position[0, 0]) for person in (ann, ben)]
    assert min(places) > 0.06
    assert world.apart() < (0.04 if law == "tdpa" else 0.01)  # whose set position lags where energy is short
    status = ann.copy.status(world.now)
    assert status.law == law == status.links[0].law
    assert status.links[0].state == "coupled"
    assert status.links[0].given > 0.0 < status.links[0].taken
    assert float(ann.copy.damping[0]) == LAWS[law].drag  # nothing of the rule
    watched(world, 0.5)


def test_who_begins_together_needs_no_allowance() -> None:
    """Nobody is anywhere yet; what links could give hands beyond their seeds would be nobody's."""
    world = World(text(hands=carried() + carried(2).replace("0.1", "-0.1")), law=PathLaw(delay=0.05), tick=2.5e-3)
    ann, ben = world.join("Ann"), world.join("Ben")
    watched(world, 4.0)
    assert ann.copy.totals.advanced == ben.copy.totals.advanced == 0.0
    assert made(world) < 2.5e-3


@pytest.mark.parametrize("rate", [50, 100])
def test_all_comes_to_rest_between_stiff_hands_at_low_rates(rate: int) -> None:
    """Nobody holds Cleo's copy; the springs of the two other hands move it, once a step."""
    hands = "".join(HAND.format(user=user, path=f"[[0, 0], [3, {place}]]") for user, place in ((1, 0.05), (2, 0.02)))
    words = text(users=3, hands=hands.replace("300.0", "1800.0")).replace("rate = 200", f"rate = {rate}")
    world = World(words, law=PathLaw(delay=0.02, jitter=0.01, loss=0.05), tick=2e-3)
    ann, ben, cleo = (world.join(name, moves=name != "Cleo") for name in ("Ann", "Ben", "Cleo"))
    watched(world, 6.0)
    fastest = 0.0
    for _ in range(10):
        watched(world, 0.05)
        fastest = max(fastest, *(float(np.abs(one.copy.peer.state.velocity).max()) for one in (ann, ben, cleo)))
    assert (
        fastest < 0.03
    )  # m/s; 0.1 at 50 and 0.8 at 100 steps a second, where the springs were taken at a step's start
    assert world.apart() < 1e-3


def test_clocks_may_differ() -> None:
    """Whatever the members' clocks show: ages come from echoes, and only differences of them count."""
    apart: dict[float, float] = {}
    for offset in (0.0, -1e6):
        world = World(text(hands=carried()), law=PathLaw(delay=0.03), tick=2.5e-3)
        ann, ben = world.join("Ann"), world.join("Ben")
        _shift(ben, offset)
        apart[offset] = 0.0
        while world.now < 4.0:
            world.run(0.05)
            if world.now > 1.5:
                apart[offset] = max(apart[offset], world.apart())
        world.check()
        (link,) = ann.copy.neighbours.values()
        assert abs(link.link.ahead + offset) < 0.01
        assert ben.copy.totals.linked != 0.0
    assert max(apart.values()) < 0.03  # of 100 mm; without the offset they go their own ways


def _shift(person: Person, offset: float) -> None:
    """A member whose clock shows another time than the world's."""

    poll, step, service = person.samples.poll, person.member.step, person.member.service

    def shifted() -> list[Arrival]:
        return [Arrival(one.payload, one.source, one.time + offset) for one in poll()]

    person.samples.poll = shifted  # pyright: ignore[reportAttributeAccessIssue]
    person.member.step = lambda now, T: step(now + offset, T)  # pyright: ignore[reportAttributeAccessIssue]
    person.member.service = lambda now: service(now + offset)  # pyright: ignore[reportAttributeAccessIssue]


@pytest.mark.parametrize("seed", range(6))
def test_nothing_is_made_whatever_becomes_of_the_network_and_its_members(seed: int, tmp_path: Path) -> None:
    """Random paths, rates and hands; an outage, a crash, a return. Recordings say the same, worked out anew."""
    rng = np.random.default_rng((18, seed))
    users = int(rng.integers(2, 4))
    law = ("paid", *LIVE)[seed]
    hands = "".join(
        HAND.format(user=user, path=[[float(t), float(rng.uniform(-0.1, 0.1))] for t in range(8)])
        for user in range(1, users + 1)
    )
    words = text(f'"{law}"', users, hands).replace("rate = 200", f"rate = {int(rng.choice([80, 150, 300]))}")

    def path() -> PathLaw:
        return PathLaw(
            delay=float(rng.uniform(0.0, 0.1)),
            jitter=float(rng.choice([0.0, 0.03])),
            loss=float(rng.choice([0.0, 0.1, 0.5])),
            duplication=0.1,
            reordering=0.2,
            hold=0.03,
        )

    world = World(words, seed=seed, law=path(), tick=2.5e-3, folder=tmp_path)
    people = [world.join(name, moves=bool(rng.random() < 0.7)) for name in ("Ann", "Ben", "Cleo")[:users]]
    watched(world, 1.5)
    world.paths(people[0], people[1], PathLaw(down=True), both=bool(rng.random() < 0.5))
    watched(world, 0.8)
    world.paths(people[0], people[1], path())
    watched(world, 0.7)
    world.kill(people[-1])
    watched(world, float(rng.choice([0.3, 2.0])))
    world.join(people[-1].name)
    watched(world, 1.5)
    for person in world.people:
        assert person.copy.totals.linked != 0.0
        assert person.session_recorder is not None
        person.session_recorder.close()
    result = audit([read_recording(path) for path in world.recordings])
    assert result.holds, result.verdict


def without(recording: Recording, lacking: np.ndarray) -> Recording:
    """As if the disk had been too slow for some of its steps.

    Args:
        recording: whole.
        lacking: which steps, (steps,).
    """
    kept, rows = ~lacking, recording.states["state_row"]
    states = {name: values[kept[rows]] for name, values in recording.states.items()}
    states["state_row"] = (np.cumsum(kept) - 1)[states["state_row"]]
    return replace(recording, columns={name: values[kept] for name, values in recording.columns.items()}, states=states)


def test_an_audit_accuses_nobody_of_what_is_not_recorded(tmp_path: Path) -> None:
    """What Ann gave while her disk was too slow, she gave; what she never gave is still found."""
    world = World(text(hands=carried()), law=PathLaw(delay=0.02), tick=2.5e-3, folder=tmp_path)
    ann, ben = world.join("Ann"), world.join("Ben")
    world.run(4.0)
    world.leave(ben)
    world.run(0.5)
    assert ann.session_recorder is not None
    ann.session_recorder.close()
    whole = [read_recording(path) for path in world.recordings]
    assert audit(whole).holds
    assert audit(whole).complete
    linked = np.isfinite(whole[0].columns["sent"][:, 0])
    last, steps = int(np.flatnonzero(linked)[-1]), np.arange(linked.size)
    gaps = {
        "in the middle": (steps > last // 2) & (steps < last // 2 + 100),
        "from then on": steps > last // 2,
        "while the link went": (steps > last // 2) & (steps < last + 20),
        "while it was there": linked | (steps < 1),
    }
    taken = whole[1].columns["received"]
    liar = replace(whole[1], columns={**whole[1].columns, "received": taken + 0.1 * np.nanmax(taken)})
    words = "had not given"
    assert any(words in finding.words for finding in audit([whole[0], liar]).findings)
    for what, lacking in gaps.items():
        judged = audit([without(whole[0], lacking), whole[1]])
        assert not judged.complete, what
        assert not any(words in finding.words for finding in judged.findings), what
        found = audit([without(whole[0], lacking), liar]).findings
        assert any(words in finding.words for finding in found) == (what != "while it was there"), what


def test_a_newcomer_comes_to_where_an_object_is_held_deformed() -> None:
    """What it takes to deform its copy is of the allowance; then the copies hold together."""
    world = World(chain(users=2, rate=200, law="paid"), law=PathLaw(delay=0.02), tick=2.5e-3)
    ann = world.join("Ann")
    watched(world, 3.0)
    assert float(ann.position[1, 0]) > 0.05
    ben = world.join("Ben", moves=False)
    watched(world, 5.0)
    assert 0.0 < ben.copy.totals.advanced <= 1.0
    assert float(ben.position[1, 0]) > 0.1  # as Ann's
    assert world.apart() < 0.035


def test_a_hand_feels_what_is_predicted_and_nearly_nothing_of_paid(tmp_path: Path) -> None:
    """A hand that moves evenly, on a path of 25 ± 10 ms with 5 % loss: its work for its way is the drag [Ns/m]."""
    work = {}
    for law in ("spring", "paid"):
        hands = HAND.format(user=1, path="[[0, 0], [1, 0], [13, 0.6]]")
        path, folder = PathLaw(delay=0.015, jitter=0.02, loss=0.05), tmp_path / law
        folder.mkdir()
        world = World(text(f'"{law}"', hands=hands), law=path, tick=2.5e-3, folder=folder)
        ann = world.join("Ann")
        world.join("Ben", moves=False)
        world.run(7.0)
        before, since, damping = ann.copy.totals.supplied, world.now, [float(p.copy.damping[0]) for p in world.people]
        world.run(4.5)
        work[law] = (ann.copy.totals.supplied - before) / (0.05**2 * (world.now - since))
        if law == "spring":
            still = SessionFile.from_toml(text('"spring"')).scenario
            told = still.replace(
                network=Network(users=["Ann", "Ben"], spring=50.0 * (1 - np.eye(2)), delay=0.015 * (1 - np.eye(2))),
                channel={"jitter": {"kind": "uniform", "scale": 0.02}, "loss": 0.05},
                synchronisation={"law": "spring", "damping": damping},
            )
            predicted = impedance(told, 1, frequencies=[0.2], measured=False).attrs["predicted_drag"]
        said = law_felt([person.copy.status(world.now) for person in world.people])
        assert said is not None
        assert said.law == law
        assert said.measured == pytest.approx(work[law], abs=0.03 * work["spring"])
        assert said.predicted == pytest.approx(predicted if law == "spring" else 0.0, rel=0.05)
        assert (said.on_the_way is None) == (law == "spring")
        for person in world.people:
            assert person.session_recorder is not None
            person.session_recorder.close()
        found = audit([read_recording(path) for path in world.recordings]).law
        assert found.name == law
        assert found.drag == pytest.approx(work[law], abs=0.1 * work["spring"])  # with the time to speed up
        assert found.on_the_way == (None if law == "spring" else pytest.approx(said.on_the_way, abs=1e-3))
    assert work["spring"] == pytest.approx(predicted, rel=0.05)
    assert abs(work["paid"]) < 0.05 * work["spring"]


def test_an_audit_finds_a_law_that_makes_energy(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the neighbour gave counts twice at one end; the ledger of each step does not see it."""
    believed = LawLink._believed

    def twice(end: LawLink, scalars: np.ndarray, T: float) -> np.ndarray:
        told = believed(end, scalars, T)
        told[end._energies] *= 2.0
        return told

    monkeypatch.setattr(LawLink, "_believed", twice)
    world = World(text(hands=carried()), law=PathLaw(delay=0.02), tick=2.5e-3, folder=tmp_path)
    world.join("Ann")
    world.join("Ben")
    world.run(4.0)
    for person in world.people:
        assert person.copy.totals.residual < 1e-10
        assert person.session_recorder is not None
        person.session_recorder.close()
    result = audit([read_recording(path) for path in world.recordings])
    assert any("links did more than they were paid for" in finding.words for finding in result.findings)


# -- who lies ----------------------------------------------------------------------------------------------------------

FORCE, POWER, ALLOWANCE = 5.0, 0.5, 0.05
LIED_TO = f"""
[session]
users = 3
force_limit = {FORCE}
power_limit = {POWER}
allowance = {ALLOWANCE}
[body]
kind = "point"
mass = 1.0
[steps]
rate = 100
[synchronisation]
law = "paid"
""" + HAND.format(user=1, path="[[0, 0], [1, 0.05], [2, 0.0], [3, 0.05], [4, 0.0]]")


def _rich(told: Message, n: int) -> Message:
    """Energy that nobody had, for a hand that pushes as hard as can be said, to and fro."""
    fields, scalars = told[0].copy(), told[1].copy()
    fields[1:4] = 1e11 * (-1.0) ** (n // 20)
    scalars[[0, 4]] += 1e9 * n  # E_out and given
    return fields, scalars


def _stiff(told: Message, n: int) -> Message:
    """A hand so stiff that no step could hold it, in a new epoch each time."""
    fields, scalars = told[0].copy(), told[1].copy()
    fields[1] = 1e3
    scalars[1:4] = 1e9, 1e9, n
    scalars[4] += 0.1 * n
    return fields, scalars


def _strong(told: Message, n: int) -> Message:
    """A hand that pushes with what limits do not allow, and steps could."""
    fields, scalars = told[0].copy(), told[1].copy()
    fields[1:4], scalars[1:3] = 0.0, 0.0
    fields[1] = 60.0 * (-1.0) ** (n // 8)
    scalars[4] += 1e3 * n
    return fields, scalars


def _waves(told: Message, n: int) -> Message:
    """Waves without end."""
    fields, scalars = told[0].copy(), told[1].copy()
    fields[0] += 1e6 * n
    scalars[0] += 1e9 * n
    return fields, scalars


LIES: dict[str, tuple[Lie, Callable[[Message, int], Message]]] = {
    "rich": (Lie(since=1.5), _rich),
    "stiff": (Lie(since=1.5), _stiff),
    "strong": (Lie(since=1.5), _strong),
    "waves": (Lie(since=1.5), _waves),
    "the future": (Lie(since=1.5, drift=5.0, echo="random", law="noise", size=9.0), _rich),
    "the past": (Lie(since=0.0, first=True, drift=-20.0, age=1e9, law="swing", rate=5.0, size=9.0), _rich),
    "another place": (Lie(since=1.5, law="place", size=9.9, seed=1), lambda told, n: told),
}


def lied_to(what: str) -> list[str]:
    """What two honest members suffered beyond what limits allow, in sentences."""
    lie, change = LIES[what]
    world = World(LIED_TO, tick=5e-3, seed=3)
    names = ("Zoe", "Ann", "Ben") if lie.first else ("Ann", "Ben", "Zoe")
    people = {}
    for name in names:
        people[name] = world.join(name, moves=name == "Ann")
        if name == "Zoe":
            liar = Liar(people[name], lie)
            liar.message = lambda told, liar=liar: change(told, liar.sent)
        world.run(0.1)
    honest, broken, begun, speed = [people["Ann"], people["Ben"]], list[str](), world.now, None
    sent = liar.sent
    while world.now < 4.0:
        world.run(0.01)
        liar.check()
        gained = allowed = 0.0
        for person in honest:
            if person.member.replica is None or person.copy.peer is None:
                continue
            copy, totals = person.copy, person.copy.totals
            if totals.alarms or not np.isfinite(copy.peer.state.velocity).all():
                return [*broken, f"the ledger of {person.name} is off"]
            gained += totals.linked
            allowed += copy.initial_energies
            for held in copy.neighbours.values():
                if held.entry.name != "Zoe" or held.law is None:
                    continue
                most = POWER * (0.1 + world.now - begun + 0.3)
                allowed += held.law.received
                if held.law.received > most:
                    broken.append(f"{person.name} took {held.law.received:.3g} J of the liar; {most:.3g} J it may")
        if gained > allowed + 1e-9:
            broken.append(f"links did {gained:.3g} J on honest copies; {allowed:.3g} J they may")
        # Nobody holds Ben's copy: what it is pushed with is its acceleration. Brakes and b* only hold back.
        peer = people["Ben"].copy.peer if people["Ben"].member.replica is not None else None
        if peer is not None and peer.steps:
            now = (peer.integrated, peer.state.velocity[0].copy())
            if speed is not None and now[0] > speed[0]:
                push = float(np.linalg.norm(now[1] - speed[1])) / (now[0] - speed[0]) / 3.0
                fastest = max(float(np.linalg.norm(now[1])), float(np.linalg.norm(speed[1])))
                most = 2.0 * FORCE + 11.0 * fastest
                if push > 1.02 * most and people["Ben"].copy.copies == 3:
                    broken.append(f"Ben's copy was pushed with {push:.3g} N; {most:.3g} N two links may")
            speed = now
        if not liar.lying:
            broken.clear()
        if broken:
            break
    assert broken or liar.sent > sent + 50
    return broken


@pytest.mark.parametrize("law", LIVE)
def test_whatever_is_heard_a_neighbour_pushes_no_harder_than_the_limit(law: str) -> None:
    session = SessionFile.from_toml(text(f'"{law}"'))
    live, rng = SharedModel.build(session).law, np.random.default_rng(4)
    assert live is not None
    for slot in (0, 1):
        end = live.link(FreshestLink(_told(live, rng, 0)), live.memory(), slot=slot, other=1 - slot, copies=2)
        x, push, target = (np.zeros((1, live.size)) for _ in range(3))
        end.attach(spring=50.0, place=(0, 1), weight=np.ones(1), target=target, push=push)
        hardest = 0.0
        for n in range(1, 200):
            end.before(_told(live, rng, n), 0.03, 0.005, x, 0.0 * x)
            hardest = max(hardest, end.force)
            end.after(0.0 * x)
        limit = session.options.force_limit
        assert 0.9 * limit < hardest <= limit * (1.0 + 1e-9)


@pytest.mark.parametrize("law", LIVE)
def test_whatever_is_heard_a_push_is_a_number(law: str) -> None:
    """Numbers that nobody honest says, in a sample that stays the newest: T < 0, and no time passes at its end."""
    live = SharedModel.build(SessionFile.from_toml(text(f'"{law}"'))).law
    assert live is not None
    x, push, target = (np.zeros((1, live.size)) for _ in range(3))
    for said in (-1.0, 0.0, 1e12, -1e12):
        end = live.link(
            FreshestLink(_told(live, np.random.default_rng(4), 0)), live.memory(), slot=0, other=1, copies=2
        )
        end.attach(spring=50.0, place=(0, 1), weight=np.ones(1), target=target, push=push)
        T = 2.0**-8  # so that ages and times are exact
        for n in range(1, 40):
            told = _told(live, np.random.default_rng(n // 4), n // 4)
            assert told.message is not None
            told.message[1][:] = np.where(told.message[1] == 1e3 * (n // 4), told.message[1], said)
            gains = end.before(told, 2.0**-5 + (n % 4) * T, T, x, 0.0 * x)
            assert np.isfinite([*gains, end.force]).all()
            end.after(0.0 * x)
            assert all(np.isfinite(part).all() for part in end.message)


def _told(live: LiveLaw, rng: np.random.Generator, n: int) -> Sample:
    """A lie of great energies, fields and places."""
    fields = np.zeros((len(live.law.sends), live.size))
    fields[:, 0] = 1e3 * rng.standard_normal(len(live.law.sends))
    scalars = rng.uniform(0.0, 10.0, len(live.law.sends_scalars))
    for name in live.law.energies:
        scalars[live.law.sends_scalars.index(name)] = 1e3 * n
    place = np.zeros((1, live.size))
    place[0, 0] = 9.0 * (-1.0) ** n
    return Sample(sender=1, index=n, stamp=0.0, position=place, message=(fields, scalars))


@pytest.mark.parametrize("what", LIES)
def test_who_lies_gains_no_more_than_limits_allow(what: str) -> None:
    assert not lied_to(what)


def _gullible(end: LawLink, scalars: np.ndarray, T: float) -> np.ndarray:
    del T
    said = [float(scalars[at]) for at in end._energies]
    end.received = sum(said)
    return scalars


def _unbounded(made: Callable[..., np.ndarray]) -> Callable[..., np.ndarray]:
    def parameters(law: LiveLaw, slot: int, other: int, *, tree: bool = False) -> np.ndarray:
        found = made(law, slot, other, tree=tree)
        found[[known.name for known in law.law.parameters].index("force")] = np.inf
        return found

    return parameters


@pytest.mark.parametrize("part", ["power", "force"])
def test_each_limit_is_needed(part: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if part == "power":
        monkeypatch.setattr(LawLink, "_believed", _gullible)
    else:
        monkeypatch.setattr(LiveLaw, "parameters", _unbounded(LiveLaw.parameters))
    assert lied_to({"power": "rich", "force": "strong"}[part])


# -- trees -------------------------------------------------------------------------------------------------------------

STAR = """
[network]
users = ["Ann", "Ben", "Cleo", "Dan"]
spring = [[0, 50, 50, 50], [50, 0, 50, 50], [50, 50, 0, 50], [50, 50, 50, 0]]
delay = [[0, 0.02, 0.02, 0.02], [0.02, 0, 0.02, 0.02], [0.02, 0.02, 0, 0.02], [0.02, 0.02, 0.02, 0]]
links = [[1, 2], [1, 3], [1, 4]]
[body]
mass = 1.0
[steps]
rate = 200
"""
RELAY = [known.name for known in LAWS["paid"].parameters].index("relay")


def _relays(world: World) -> list[float]:
    ends = [end.law for person in world.people for end in person.copy.neighbours.values()]
    return [float(end._parameters[RELAY]) for end in ends if end is not None]


def _star(more: str = "") -> World:
    """Two of four hold still, a third one carries, and all are linked to Ann, who has no hand."""
    still = "".join(HAND.format(user=user, path="[0]") for user in (2, 3))
    return World(STAR + more + still + carried(4), law=PathLaw(delay=0.02, jitter=0.005), tick=2.5e-3)


def test_in_a_star_hands_are_told_on_and_where_somebody_leaves_that_ends() -> None:
    world = _star()
    assert world.session.law == "paid"
    people = [world.join(name) for name in ("Ann", "Ben", "Cleo", "Dan")]
    world.until(world.all_coupled, 5.0)
    assert _relays(world) == [1.0] * 6
    places: list[float] = []
    for _ in range(60):
        watched(world, 0.05)
        places.append(float(np.ptp([float(person.position[0, 0]) for person in people])))
    assert max(places) < 0.06  # 99 mm, if nobody tells of others' hands, and 86 mm with springs
    world.leave(people[3])
    watched(world, 0.5)
    assert _relays(world) == [1.0] * 4  # three in a row
    world.leave(people[2])
    watched(world, 0.5)
    assert _relays(world) == [0.0] * 2  # two know each other's hands


def test_what_a_liar_makes_up_is_not_told_on() -> None:
    """Whoever hears of more than hands can do tells the others nothing of it, and of honest hands all."""
    facts, kind = Facts(spring=50.0, age=0.02, age_back=0.02, degree=2, degree_back=1, tree=True), LAWS["paid"]
    for scale, heard in ((1.0, True), (1e7, False)):
        memory = CopyMemory(kind, 1)
        ends = [
            LawLink(
                FreshestLink(Sample(sender=n, index=-1, stamp=0.0, position=np.zeros((1, 1)))),
                law=kind,
                parameters=np.array(kind.values(facts, {"force": 5.0})),
                memory=memory,
                side=0,
                copies=3,
                power=1.0,
            )
            for n in (1, 2)
        ]
        for nth, end in enumerate(ends):
            end.attach(spring=50.0, place=(nth, 2), weight=np.ones(1), target=np.zeros((1, 1)), push=np.zeros((1, 1)))
        fields, numbers = np.zeros((len(kind.sends), 1)), np.zeros(len(kind.sends_scalars))
        fields[kind.sends.index("w")] = 2.0 * scale
        numbers[kind.sends_scalars.index("hands")] = numbers[kind.sends_scalars.index("T")] = 1.0
        for k in range(5):
            lie = Sample(sender=1, index=k, stamp=k * 1e-3, position=np.zeros((1, 1)), message=(fields, numbers))
            for end, said in zip(ends, (lie, ends[1].source.choose(k)), strict=True):
                end.before(said, 0.02, 1e-3, np.zeros((1, 1)), np.zeros((1, 1)))
                assert end.force <= 5.0 + 1e-9
            for end in ends:
                end.after(np.zeros((1, 1)))
        told = float(ends[1].message[0][kind.sends.index("w"), 0])
        assert (told != 0.0) == heard


# -- what is refused ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            ('"paid"', '"once"'),
            r'law is "once"; a live session needs "spring", or a law .*"paid", "pspm", "tank", "tdpa", "wave"',
        ),
        (('"paid"', '"paid"\nmode = "constant"'), 'mode is "constant"; with law "paid" it must be "freshest"'),
        (
            ("users = 2", 'users = 2\nencoding = "float32"'),
            'encoding is "float32"; with law "paid" it must be "float64"',
        ),
        (('"paid"', '{kind = "paid", force = 3.0}'), "law.force is given; in a live session, set session.force_limit"),
        (
            ('"paid"', '"paid"\ndamping = "rule"'),
            'damping is "rule", which only law "spring" uses in a live session; with law "paid"',
        ),
        (
            ("users = 2", "users = 2\ntank = 0.1"),
            'session.tank is 0.1, which applies only to guarded links of law "spring"',
        ),
    ],
)
def test_what_a_law_cannot_do_live_is_refused(change: tuple[str, str], words: str) -> None:
    with pytest.raises(ScenarioError, match=words):
        SessionFile.from_toml(text().replace(*change))


def test_who_has_another_law_of_that_name_is_told_so() -> None:
    world = World(text(), tick=2.5e-3)
    world.join("Ann")
    ben = world.join("Ben")
    control: Any = ben.control
    send = control.send

    def otherwise(topic: str, body: bytes, *, to: bytes | None = None) -> None:
        if topic == "join":
            body = json.dumps(json.loads(body) | {"law": "paid 0123456789abcdef"}).encode()
        send(topic, body, to=to)

    control.send = otherwise
    with pytest.raises(
        SessionError, match='links of this session use law "paid", and this machine has a different one'
    ):
        world.run(3.0)


def test_what_a_law_says_is_bounded_on_arrival() -> None:
    replica = SharedModel.build(SessionFile.from_toml(text()))
    codec, layout = SampleCodec(replica.layout), replica.layout
    law = PAID
    heading = Heading(epoch=0, sender=1, step=3, stamp=1.0, T=0.01)
    state = np.zeros((layout.rows, layout.width))
    written = codec.write(state)
    assert not isinstance(written, Refusal)
    fields = np.random.default_rng(0).standard_normal((len(law.sends), layout.rows, layout.width))
    fields[:, :, layout.axes :] = 0.0
    coarse = [nth for nth, name in enumerate(law.sends) if name not in law.sums]
    fields[coarse] = fields[coarse].astype(np.float32)  # what is no sum travels so
    scalars = np.arange(float(len(law.sends_scalars)))
    message = fields.reshape(len(law.sends), -1), scalars
    told = codec.told(message)
    assert not isinstance(told, Refusal)
    datagram = codec.datagram(heading, 0, written.bodies[0], told[0])
    chunk = codec.read(datagram, epoch=0, sender=1)
    assert isinstance(chunk, Chunk)
    assert chunk.scalars is not None
    assert chunk.fields is not None
    np.testing.assert_array_equal(chunk.scalars, scalars)
    np.testing.assert_array_equal(chunk.fields, fields[:, :, : layout.axes])
    held = Assembly(layout, sender=1, initial=state)
    assert held.take(chunk) is None
    sample = held.choose(0)
    assert sample.message is not None
    np.testing.assert_array_equal(sample.message[0], message[0])
    border = len(datagram) - 4 * len(coarse) * layout.rows * layout.axes
    places = [(at, np.float64) for at in range(HEAD_BYTES, border, 8)]
    places += [(at, np.float32) for at in range(border, len(datagram), 4)]
    for at, kind in places:
        for value in (np.nan, np.inf, 2e12, -2e12):
            bent = datagram[:at] + kind(value).tobytes() + datagram[at + kind(0).nbytes :]
            assert codec.read(bent, epoch=0, sender=1) in {Refusal.LAW, Refusal.STATE}
    assert codec.read(datagram[:-8], epoch=0, sender=1) is Refusal.SIZE
    assert codec.read(datagram + bytes(8), epoch=0, sender=1) is Refusal.SIZE
    for bad in (None, (message[0] * np.nan, scalars), (message[0], scalars * 1e13)):
        assert codec.told(bad) is Refusal.LAW
