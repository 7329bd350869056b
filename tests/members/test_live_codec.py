"""Sessions whose members say in one byte what goes on: links stay what their laws promise, and recordings tell it."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.members.test_live_law import LIVE, carried, made, seeds, text
from tests.session.world import World

from cotouch.members import Admission, Join, Roster, read_message
from cotouch.recording import Recording, audit, read_recording
from cotouch.samples import PathLaw, Refusal

CODEC = "[channel]\ncodec = {deadband = 0.1, quantum = 1e-5, hold = 4}\n"
PATH = PathLaw(delay=0.02, jitter=0.01, loss=0.05)


def world_of(law: str, folder: Path | None = None) -> World:
    world = World(text(f'"{law}"', hands=carried()) + CODEC, law=PATH, tick=2.5e-3, folder=folder)
    for name in ("Ann", "Ben"):
        world.join(name)
    world.until(world.all_coupled, 6.0)
    return world


def carry(world: World, seconds: float) -> None:
    for _ in range(round(seconds / 0.05)):
        world.run(0.05)
        assert made(world) <= seeds(world) + 1e-9
    world.check()


@pytest.mark.parametrize("law", LIVE)
def test_two_carry_an_object_and_say_less(law: str) -> None:
    world = world_of(law)
    carry(world, 3.5 - world.now)
    ann, ben = world.people
    assert min(float(person.position[0, 0]) for person in (ann, ben)) > 0.03
    assert world.apart() < (0.08 if law == "tdpa" else 0.015)  # whose set position lags where energy is short
    statuses = [person.copy.status(world.now) for person in world.people]
    for person, status in zip(world.people, statuses, strict=True):
        (link,) = person.copy.neighbours.values()
        coded = link.link.coded
        assert coded is not None
        assert coded.encoder.unchanged > 0.3 * coded.encoder.contents
        assert set(link.link.refused) <= {Refusal.REPLAYED, Refusal.STALE, Refusal.BASELESS, Refusal.EPOCH_OF_KEYS}
        assert 50.0 < status.links[0].datagram_rate < 230.0
        assert 0.02 < status.links[0].saved < 0.8
        assert float(person.copy.damping[0]) == world.replica.law.law.drag  # none for the codec


@pytest.fixture(scope="module")
def carried_by_springs(tmp_path_factory: pytest.TempPathFactory) -> tuple[World, list[Recording]]:
    world = world_of("spring", tmp_path_factory.mktemp("springs"))
    carry(world, 2.5)
    for person in world.people:
        (link,) = person.copy.neighbours.values()
        coded = link.link.coded
        assert coded is not None
        assert coded.encoder.account is not None
        # Both budgets, and as much again as twice the option says: for what is received and for what is sent.
        assert float(person.copy.damping[0]) == pytest.approx(25.0 * (link.total + 2.0 * 1e-3))
        assert coded.encoder.account.window == link.total > 0.0
    for person in list(world.people):
        world.leave(person)
    return world, [read_recording(path) for path in world.recordings]


def test_springs_pay_for_what_is_off_and_the_audit_finds_it_so(
    carried_by_springs: tuple[World, list[Recording]],
) -> None:
    """Every sample is put together anew from what its sender recorded, to the last bit; so is what errors cost."""
    _, recordings = carried_by_springs
    for recording in recordings:
        said = recording.columns["said"]
        assert (said == 255).sum() > 10
        assert ((said > 0) & (said < 255)).sum() > 50
        # What is not coupled on both sides is said in full numbers.
        own = recording.columns["link_state"][:, 0]
        assert not (said[:, 0][own != 2] > 0.0).any()
    found = audit(recordings)
    assert found.findings == ()
    assert found.complete
    assert found.links[0].unknown < 0.3


def test_an_audit_sees_who_said_other_than_it_may(carried_by_springs: tuple[World, list[Recording]]) -> None:
    _, (ann, ben) = carried_by_springs

    def places(recording: Recording) -> set[str]:
        return {finding.place for finding in audit([ann, recording]).findings}

    said = ben.columns["said"]
    goes_on = (said > 0.0) & (said < 255.0)
    assert "link" in places(replace(ben, columns={**ben.columns, "said": np.where(goes_on, 0.0, said)}))
    # As if all that was said in full had gone on: further off than its damping pays for.
    count = np.arange(len(said))[:, None] % 200 + 1.0
    lying = np.where((said >= 0.0) & (count < 200.0), count, said)
    assert "codec" in places(replace(ben, columns={**ben.columns, "said": lying}))


def asked(world: World) -> Join:
    """What somebody says first who comes."""
    said: list[bytes] = []
    world.join("Ann").control.send = lambda topic, body, *, to=None: said.append(body) if topic == "join" else None
    world.run(0.1)
    request = read_message(Join, said[0])
    assert request is not None
    return request


def test_a_session_names_its_codec() -> None:
    """Who has another one has another session, and is not let in to this one."""
    worlds = [World(text() + words) for words in ("", CODEC, CODEC.replace("0.1", "0.2"))]
    assert len({world.session.digest for world in worlds}) == 3
    for host in worlds:
        admission = Admission(host.session, fingerprint=host.replica.fingerprint)
        for guest in worlds:
            why = admission.unfit(asked(guest), "a" * 64, Roster())
            assert (why is None) if guest is host else ("has a different one" in str(why))
