"""Several bodies of which one is torn along the faces of its elements, live: cuts, books and an audit."""

from dataclasses import replace

import numpy as np
import pytest
from tests.session.world import Person, World

from cotouch.errors import RecordingError
from cotouch.recording import Recording, audit, read_recording, recordings_dataset

TORN = """
[session]
users = 3
spring = 20.0
wait_for_peers = 1.5
[[bodies]]
name = "low"
kind = "lattice"
shape = [4, 3, 3]
model = "cells"
stiffness = 80.0
damping = 0.1
mass = 0.05
at = [0.015, 0.01, 0.0101]
[[bodies]]
name = "high"
kind = "lattice"
shape = [4, 3, 3]
model = "cells"
stiffness = 80.0
damping = 0.1
mass = 0.05
at = [0.015, 0.01, 0.031]
[between]
friction = 0.3
damping = 2.0
stiffness = 1e6
[world]
gravity = [0, 0, -9.81]
[[world.planes]]
friction = 0.5
damping = 20.0
[cutting]
tear = 0.3
faces = true
users = [1]
[steps]
rate = 250
[[hands]]
user = 1
body = "high"
at = [0.03, 0.02, 0.04]
path = [[0, 0, 0, 0], [0.5, 0, 0, 0], [0.65, 0.06, 0, 0.02]]
stiffness = 400
damping = 1
"""


def cuts_of(person: Person) -> np.ndarray:
    peer = person.copy.peer
    assert peer is not None
    assert peer.cuts is not None
    return peer.cuts.by


@pytest.fixture(scope="module")
def torn(tmp_path_factory: pytest.TempPathFactory) -> World:
    world = World(TORN, folder=tmp_path_factory.mktemp("torn"), tick=4e-3)
    world.join("Ann")
    world.join("Ben", moves=False)
    world.until(world.all_coupled, 12.0)
    world.until(lambda: all(np.any(cuts_of(person)) for person in world.people), 4.0)
    world.run(0.5)
    world.join("Cleo", moves=False)
    world.until(lambda: len(world.people[0].states()) == 2 and world.all_coupled(), 12.0)
    world.run(1.0)
    return world


@pytest.fixture(scope="module")
def recorded(torn: World) -> list[Recording]:
    for person in torn.people:
        assert person.session_recorder is not None
        person.session_recorder.close()
    return [read_recording(path) for path in torn.recordings]


def test_all_have_the_same_cut_of_the_body_that_was_torn(torn: World) -> None:
    ann, *others = (cuts_of(person) for person in torn.people)
    assert len(others) == 2
    assert np.any(ann)
    assert np.flatnonzero(ann).min() >= ann.size // 2  # of the upper body
    for other in others:
        assert np.array_equal(ann, other)


def test_books_hold(torn: World) -> None:
    for person in torn.people:
        totals = person.copy.totals
        assert totals.alarms == 0
        assert abs(totals.total_residual) <= 1e-12 * totals.in_play


def test_an_audit_works_out_anew_what_each_body_was_closed_by(recorded: list[Recording]) -> None:
    result = audit(recorded)
    assert result.holds, result.verdict
    assert sum(float(recording.columns["cut"].sum()) for recording in recorded) > 0.0
    for recording, ledger in zip(recorded, result.users, strict=True):
        assert ledger.worked_out == recording.states["state_row"].size
        assert abs(ledger.residual) <= result.tolerance


def test_what_closed_each_body_is_exported_by_name(recorded: list[Recording]) -> None:
    run = recordings_dataset(recorded)
    assert run["body_factor"].dims == ("user", "step", "body")
    assert run["body_centre"].dims == ("user", "step", "body", "space")
    assert {run["body_factor"].attrs["units"], run["body_centre"].attrs["units"]} == {"1", "m/s"}
    for user, recording in enumerate(sorted(recorded, key=lambda one: one.user)):
        steps, closing = slice(1, 1 + recording.steps), recording.columns["closing"]
        assert np.array_equal(run["body_factor"].values[user, steps], closing[:, :, 0])
        assert np.array_equal(run["body_centre"].values[user, steps], closing[:, :, 1:])
        lost = recording.columns["world_loss"].sum()
        assert run["world_loss"].values[user, recording.steps] == pytest.approx(lost, abs=1e-15)
    assert run["world_loss"].attrs["units"] == "J"
    assert not [name for name in run.dims if str(name).startswith("closing")]


def test_an_audit_finds_closings_that_were_not(recorded: list[Recording]) -> None:
    ben = recorded[1]
    closing = ben.columns["closing"]
    whole, centres = np.array(closing), np.array(closing)
    whole[:, :, 0] = 1.0
    moves = (centres[:, :, 1:] != 0.0).any(axis=2)
    centres[moves, 1:] += 0.05  # what is said of the centre is not believed
    others = (recorded[0], recorded[2])
    assert audit([replace(ben, columns={**ben.columns, "closing": whole}), *others]).findings
    assert audit([replace(ben, columns={**ben.columns, "closing": centres}), *others]).holds
    for wrong in (closing[:, :1], np.full_like(closing, np.nan)):
        with pytest.raises(RecordingError, match="does not say how the steps of its 2 bodies were closed"):
            audit([replace(ben, columns={**ben.columns, "closing": wrong}), *others])
