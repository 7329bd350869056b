"""A body that several hold and one cuts, on a virtual clock: everybody comes to the same cuts, and no liar goes far."""

import base64
import hashlib
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

import numpy as np
import pytest
from tests.members.inside import TOPIC, SharedCuts, Statement
from tests.session.world import Person, World, entropy

from cotouch.members import Entry, Former, NameOwner, Roster, SessionFile, SharedModel, read_message, write_message
from cotouch.recording import audit, read_recording
from cotouch.samples import Identity, PathLaw

SESSION = """
[session]
users = 3
spring = 60.0
[body]
kind = "lattice"
shape = [6, 3, 3]
neighbours = 18
model = "spring-network"
stiffness = 60.0
damping = 0.06
mass = 0.3
ground = "x-"
ground_stiffness = 100.0
[cutting]
tear = 0.25
users = [1, 3]
[steps]
rate = 100
[synchronisation]
law = "spring"
[[hands]]
user = 1
at = [0.05, 0.01, 0.01]
path = [[0, 0, 0, 0], [1, 0.09, 0, 0]]
stiffness = 60.0
damping = 1.0
"""


def cuts_of(person: Person) -> np.ndarray:
    peer = person.copy.peer
    assert peer is not None
    assert peer.cuts is not None
    return peer.cuts.by


def statement(identity: Identity, slot: int, session: bytes, what: np.ndarray) -> Statement:
    """As its author signs it, true or not.

    Args:
        identity: of the author.
        slot: of its user.
        session: bytes that name the session.
        what: elements, (cut_count,).
    """
    author, elements = identity.public.hex(), base64.b64encode(np.packbits(what).tobytes()).decode()
    about = hashlib.sha256(b"cotouch cuts 1\0" + session).digest() + f"{author} {slot} {elements}".encode()
    return Statement(author=author, slot=slot, elements=elements, signature=identity.sign(about).hex())


def claim(person: Person, what: np.ndarray, **changes: object) -> bytes:
    """What a member may sign, true or not."""
    session = person.world.session.digest + b"secret"
    said = statement(person.identity, person.copy.slot, session, what)
    return write_message(said.model_copy(update=changes))


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> World:
    world = World(SESSION, folder=tmp_path_factory.mktemp("cuts"), tick=2.5e-3, law=PathLaw(delay=0.02, loss=0.2))
    ann, ben = world.join("Ann"), world.join("Ben", moves=False)
    world.until(world.all_coupled, 12.0)
    world.run(8.0)
    assert np.count_nonzero(cuts_of(ann)) > 5
    assert np.count_nonzero(cuts_of(ben)) > 5
    world.join("Cleo", moves=False)
    world.run(4.0)
    return world


class TestAgreement:
    def test_everybody_has_the_same_cuts_and_knows_whose_they_are(self, world: World) -> None:
        ann, *others = (cuts_of(person) for person in world.people)
        assert len(others) == 2
        for cut in (ann, *others):  # where two copies tore alike, who was first depends on who is asked
            assert np.array_equal(cut > 0, ann > 0)
            assert 1 in cut
            assert 2 not in cut  # who may not
        said = {person.copy.status(world.now).cut_set for person in world.people}
        assert len(said) == 1
        assert said != {""}

    def test_energy_is_exact(self, world: World) -> None:
        world.check()
        ann = world.people[0]
        assert ann.copy.totals.cut > 0.0
        assert ann.copy.totals.lost >= ann.copy.totals.cut


class TestLies:
    def told(self, world: World, by: Person, body: bytes) -> None:
        by.control.send(TOPIC, body)
        world.run(0.3)

    def refused(self, world: World) -> int:
        shared = world.people[0].copy._cuts
        assert shared is not None
        return shared.refused

    def test_what_is_no_statement_of_this_body_or_of_its_author_changes_nothing(self, world: World) -> None:
        ann, ben, cleo = world.people
        before, size = cuts_of(ann).copy(), cuts_of(ann).size
        whole = np.ones(size, dtype=np.bool_)
        longer = base64.b64encode(bytes(size)).decode()
        beyond = np.packbits(whole)
        beyond[-1] |= (1 << (-size % 8)) - 1
        lies = {
            "of one who may not cut": (ben, claim(ben, whole)),
            "of another body": (cleo, claim(cleo, np.ones(size + 64, dtype=np.bool_))),
            "longer than signed": (cleo, claim(cleo, whole, elements=longer)),
            "ids out of range": (cleo, claim(cleo, whole, elements=base64.b64encode(beyond.tobytes()).decode())),
            "another's signature": (ben, claim(cleo, whole, author=ann.identity.public.hex(), slot=0)),
            "another's slot": (cleo, claim(cleo, whole, slot=0)),
            "a stranger": (cleo, claim(cleo, whole, author="ab" * 32)),
            "nothing": (cleo, b"{}"),
            "no text": (cleo, b"\xff"),
        }
        assert size % 8 != 0
        for name, (who, body) in lies.items():
            refused = self.refused(world)
            self.told(world, who, body)
            assert self.refused(world) > refused, name
            assert np.array_equal(cuts_of(ann), before), name

    def test_who_claims_all_is_believed_slowly(self, world: World) -> None:
        ann, _, cleo = world.people
        size, before = cuts_of(ann).size, np.count_nonzero(cuts_of(ann))
        whole = np.ones(size, dtype=np.bool_)
        self.told(world, cleo, claim(cleo, whole))
        once = np.count_nonzero(cuts_of(ann))
        assert before < once < size
        world.run(2.0)
        assert once < np.count_nonzero(cuts_of(ann)) < size
        assert np.array_equal(cuts_of(ann) == 1, cuts_of(world.people[1]) == 1)
        world.check()

    def test_cut_to_pieces_all_goes_on(self, world: World) -> None:
        ann, ben, cleo = world.people
        self.told(world, cleo, claim(cleo, np.ones(cuts_of(ann).size, dtype=np.bool_)))
        world.until(lambda: np.all(cuts_of(ann) > 0) and np.all(cuts_of(ben) > 0), 12.0)
        world.run(1.0)
        world.check()
        assert 0.0 < world.apart() < 0.05
        # What nothing holds any more is not the object, so copies of that are not apart.
        assert {link.difference for link in ann.copy.status(world.now).links} == {0.0}


# -- without a session -------------------------------------------------------------------------------------------------


class Said:
    """A control plane that keeps what is said, for one key."""

    def __init__(self, seed: int) -> None:
        self.identity = Identity.make(entropy(seed))
        self.bodies: list[bytes] = []

    def send(self, topic: str, body: bytes) -> None:
        assert topic == TOPIC
        self.bodies.append(body)


class Copied:
    """A copy that takes what it is told."""

    def __init__(self, size: int) -> None:
        self.cuts = self
        self.own, self.told, self.tears = np.zeros(size, dtype=np.bool_), np.zeros(size, dtype=np.int32), False

    def hear(self, by: np.ndarray) -> None:
        self.told = np.where(by != 0, by, self.told)


class TestStatements:
    replica = SharedModel.build(SessionFile.from_toml(SESSION))
    size = replica.body.cut_count
    key: ClassVar = {name: Said(seed).identity.public.hex() for seed, name in enumerate(("Ann", "Ben", "Cleo"))}

    def roster(self, *, here: dict[str, int], had: dict[str, tuple[int, ...]]) -> Roster:
        members = [Entry(slot=slot, name=name, key=self.key[name]) for name, slot in here.items()]
        return Roster(members=members, names=[NameOwner(name=n, key=self.key[n], slots=s) for n, s in had.items()])

    def shared(self, seed: int, slot: int) -> tuple[SharedCuts, Said]:
        said = Said(seed)
        return SharedCuts(said, self.replica, b"session", slot), said  # pyright: ignore[reportArgumentType]

    def statement(self, seed: int, slot: int, first: int, last: int) -> bytes:
        cut = np.zeros(self.size, dtype=np.bool_)
        cut[first:last] = True
        return write_message(statement(Said(seed).identity, slot, b"session", cut))

    def believed(self, shared: SharedCuts, now: float) -> int:
        copied = Copied(self.size)
        shared.service(copied, now, coupled=True)  # pyright: ignore[reportArgumentType]
        return int(np.count_nonzero(copied.told))

    def test_who_has_left_cut_only_where_it_was(self) -> None:
        """Ben, whom the session does not let cut, leaves, and says by a friend that he was Cleo's predecessor."""
        shared, _ = self.shared(0, 0)
        roster = self.roster(here={"Ann": 0, "Cleo": 2}, had={"Ann": (0,), "Ben": (1,), "Cleo": (2,)})
        for slot in (0, 1, 2, 3):
            shared.receive(2, self.statement(1, slot, 0, 60), roster, 1.0)
        assert self.believed(shared, 1.0) == 0
        assert shared.refused == 4
        shared.receive(2, self.statement(2, 2, 0, 20), roster, 1.0)
        assert self.believed(shared, 1.0) == 20

    def test_what_somebody_cut_who_was_sent_away_is_told_to_those_who_come_later(self) -> None:
        """Or the newcomer's copy would hold together where all others are cut, for ever."""
        shared, _ = self.shared(0, 0)
        roster = self.roster(here={"Ann": 0}, had={"Ann": (0,)})
        gone = Former(key=self.key["Cleo"], slots=(2,))
        shared.receive(0, self.statement(2, 2, 0, 20), roster, 1.0)
        assert self.believed(shared, 1.0) == 0
        shared.receive(0, self.statement(2, 2, 0, 20), roster.model_copy(update={"former": [gone]}), 2.0)
        assert self.believed(shared, 2.0) == 20

    def test_who_was_in_two_slots_is_believed_no_faster(self) -> None:
        shared, _ = self.shared(1, 1)
        roster = self.roster(here={"Ben": 1}, had={"Ben": (1,), "Cleo": (0, 2)})
        most, size = max(64, self.size // 4), self.size
        shared.receive(1, self.statement(2, 0, 0, size // 2), roster, 1.0)
        shared.receive(1, self.statement(2, 2, size // 2, size), roster, 1.0)
        assert size // 2 > 64
        assert self.believed(shared, 1.0) == most

    def test_who_is_started_again_learns_what_it_cut_before_and_says_it_with_the_rest(self) -> None:
        again, said = self.shared(0, 0)
        roster = self.roster(here={"Ann": 0, "Ben": 1}, had={"Ann": (0,), "Ben": (1,)})
        again.receive(1, self.statement(0, 0, 0, 10), roster, 1.0)
        copied = Copied(self.size)
        again.service(copied, 1.0, coupled=True)  # pyright: ignore[reportArgumentType]
        assert np.array_equal(np.flatnonzero(copied.told), np.arange(10))
        copied.own[20:30] = True
        again.service(copied, 2.0, coupled=True)  # pyright: ignore[reportArgumentType]
        newest = read_message(Statement, said.bodies[-1])
        assert newest is not None
        bits = np.unpackbits(np.frombuffer(base64.b64decode(newest.elements), dtype=np.uint8))
        assert np.array_equal(np.flatnonzero(bits), [*range(10), *range(20, 30)])


def test_an_audit_works_the_energy_out_anew(world: World) -> None:
    for person in world.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    recordings = [read_recording(Path(path)) for path in world.recordings]
    found = audit(recordings)
    assert not found.findings
    booked = sum(float(recording.columns["cut"].sum()) for recording in recordings)
    assert booked > 0.0
    assert sum(user.cut for user in found.users) == pytest.approx(booked, rel=1e-9)
    # Forgotten cuts are found.
    ann = recordings[0]
    bare = replace(ann, events=tuple(event for event in ann.events if event.kind != "cut"))
    assert audit([bare, *recordings[1:]]).findings
