"""Steps at whose end a jammed tool and what it touches lost half of their motion: no reason to accuse anybody."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.recording.inside import RecordedMaterial, before_stop, begun
from tests.recording.test_audit import recorded_world

from cotouch.errors import RecordingError
from cotouch.recording import Recording, audit, read_recording, recordings_dataset
from cotouch.scenario import Scenario

PAIR: dict[str, Any] = {"users": ["Ann", "Ben"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.02], [0.03, 0]]}
BLOCK: dict[str, Any] = {"kind": "lattice", "shape": [4, 4, 3], "spacing": 0.02, "mass": 0.1}
GROUND = {"ground": "z-", "ground_stiffness": 200.0}
DIE = {"kind": "box", "size": [0.06, 0.06, 0.04], "resolution": 1, "mass": 0.1}
CELLS = {**BLOCK, "model": "cells", "stiffness": 100.0, "damping": 0.02}
BODIES: dict[str, dict[str, Any]] = {
    "linear": {"body": {**BLOCK, **GROUND}},
    "cells": {"body": {**CELLS, **GROUND}},
    **{
        name: {
            "bodies": [
                {**CELLS, "name": "low", "at": [0.03, 0.03, 0.02]},
                {**DIE, "name": "beside", "at": [x, 0.03, 0.03]},
            ],
            "between": {"stiffness": 1e7},
        }
        for name, x in (("touching", 0.0905), ("apart", 0.2), ("far apart", 2.0))
    },
}
# A hand that strikes with all its might, and another that lets a second ball follow it.
STRIKE: dict[str, Any] = {"stiffness": 2e4, "damping": 10.0}
TOOLS: list[dict[str, Any]] = [
    {
        "user": 1,
        "at": place,
        "radius": 0.006,
        "mass": 0.03,
        "stiffness": 2000.0,
        "hand": {**STRIKE, "path": [[0, 0, 0, 0], [0.02, 0.01, 0, -0.09], [1.0, 0.01, 0, -0.09]]},
    }
    for place in ([0.021, 0.031, 0.055], [0.041, 0.022, 0.075])
]
# Balls that nothing comes near to.
AWAY: list[dict[str, Any]] = [
    {
        "user": 1,
        "at": [x, 0.03, 0.15],
        "radius": 0.006,
        "mass": 0.03,
        "stiffness": 2000.0,
        "hand": {"stiffness": 50.0, "damping": 0.1, "path": [[0, 0, 0, 0], [1.0, 0, 0, 0.5]]},
    }
    for x in (0.1, 0.2)
]


def played(folder: Path, name: str, **changes: Any) -> list[Recording]:
    """What is recorded of somebody who strikes at some bodies."""
    usual = {"network": PAIR, "steps": {"duration": 0.16, "period": [0.008, 0.004]}, "tools": AWAY + TOOLS}
    scenario = Scenario.make(synchronisation={"law": "spring"}, **{**usual, **BODIES[name], **changes})
    return [read_recording(path) for path in recorded_world(scenario, folder)]


@pytest.fixture(scope="module", params=list(BODIES))
def honest(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> list[Recording]:
    return played(Path(tmp_path_factory.mktemp("jammed")), request.param)


def jammed(recording: Recording) -> list[int]:
    """Steps in which something lost motion."""
    return np.flatnonzero(np.isfinite(recording.columns["jammed"]).any(axis=(1, 2))).tolist()


@pytest.mark.parametrize("every", [1, 4])
def test_nobody_is_accused(honest: list[Recording], every: int) -> None:
    """Whether all states are recorded or some."""
    ann, ben = honest
    assert "jammed" not in ben.columns
    told = ann.columns["jammed"]
    assert len(jammed(ann)) >= 3
    lost = np.isfinite(told).all(axis=2)
    assert lost[jammed(ann), 0].all()  # the block
    assert lost[:, -2:].any(axis=0).all()  # each of the balls
    kept = ann.states["state_row"] % every == 0
    sparse = replace(ann, states={name: values[kept] for name, values in ann.states.items()})
    result = audit([sparse, ben])
    assert result.holds, result.verdict
    assert result.users[0].touch_loss > 1e-2


def test_only_what_touches_loses_motion(honest: list[Recording], request: pytest.FixtureRequest) -> None:
    """Guesses that were given up had the block meet a die, over 2 m, and balls elsewhere."""
    name = request.node.callspec.params["honest"]
    lost = np.isfinite(honest[0].columns["jammed"]).all(axis=2)
    bodies = len(BODIES[name].get("bodies", [0]))
    assert lost.shape[1] == bodies + 4
    assert not lost[:, bodies : bodies + 2].any()
    if name == "touching":
        assert np.array_equal(lost[:, 0], lost[:, 1])
    elif "apart" in name:
        assert not lost[:, 1].any()
        states = honest[0].states
        block = int(np.prod(BLOCK["shape"]))
        for field in ("position", "velocity"):
            assert np.abs(states[field][:, block:]).max() < 1e-100


def test_what_nothing_comes_near_to_goes_as_if_alone(
    honest: list[Recording], request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    """Where steps that are not jammed are not shortened either, which shortens the way of all tools."""
    name = request.node.callspec.params["honest"]
    if name in {"cells", "apart", "far apart"}:
        alone = played(tmp_path, name, tools=AWAY)[0].columns["tool_position"]
        assert honest[0].columns["tool_position"][:, : len(AWAY)] == pytest.approx(alone, abs=1e-12)


def test_a_die_that_only_a_guess_had_the_block_meet_falls_freely(tmp_path: Path) -> None:
    network = {"users": ["Ann"], "spring": [[0]], "delay": [[0]]}
    steps = {"duration": 0.16, "period": 0.008}
    ann = played(tmp_path, "touching", network=network, steps=steps, world={"gravity": [0.0, 0.0, -1.0]})[0]
    assert len(jammed(ann)) == 1
    time = np.cumsum(ann.columns["period"])[ann.states["state_row"]]
    die = ann.header.body.field(ann.states["position"])[:, int(np.prod(BLOCK["shape"])) :]
    assert np.abs(die[..., 2] + 0.5 * time[:, None] ** 2).max() <= 1e-14
    assert np.abs(die[..., :2]).max() <= 1e-14


def claimed(recording: Recording, name: str, change: Callable[[Any], Any], step: int) -> Recording:
    """With another number in one step."""
    where = recording.columns if name in recording.columns else recording.states
    values = np.array(where[name])
    values[step] = change(values[step])
    if name in recording.columns:
        return replace(recording, columns={**recording.columns, name: values})
    return replace(recording, states={**recording.states, name: values})


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("touch_work", lambda work: work + 4e-5),
        ("touch_loss", lambda loss: loss - 4e-5),
        ("touch_stored", lambda energy: energy + 4e-5),
        ("tool_velocity", lambda rate: 1.001 * rate),
        ("velocity", lambda rate: 1.001 * rate),
        ("jammed", lambda about: np.nan * about),
        ("jammed", lambda about: 0.0 * about),
    ],
)
def test_who_claims_energy_in_such_a_step_is_found(
    honest: list[Recording], name: str, change: Callable[[Any], Any]
) -> None:
    ann, ben = honest
    step = max(jammed(ann), key=lambda k: float(ann.columns["kinetic"][k]))
    result = audit([claimed(ann, name, change, step), ben])
    assert not result.holds
    assert {finding.user for finding in result.findings} <= {0, None}


def test_where_the_centre_is_nobody_says(honest: list[Recording]) -> None:
    """It follows from the state, so who says another cannot make one motion of another."""
    ann, ben = honest
    step = jammed(ann)[0]
    assert audit([claimed(ann, "jammed", lambda about: about + 1.0, step), ben]).holds


def test_a_step_that_was_not_jammed_is_not_by_saying_so(honest: list[Recording]) -> None:
    ann, ben = honest
    moving = np.where(np.isin(np.arange(ann.steps), jammed(ann)), 0.0, ann.columns["kinetic"])
    result = audit([claimed(ann, "jammed", np.ones_like, int(np.argmax(moving))), ben])
    assert not result.holds


def test_what_is_said_of_one_axis_alone_says_nothing(honest: list[Recording]) -> None:
    ann, ben = honest
    moving = np.where(np.isin(np.arange(ann.steps), jammed(ann)), 0.0, ann.columns["kinetic"])
    some = claimed(ann, "jammed", lambda about: np.where(np.arange(3) == 2, 1.0, about), int(np.argmax(moving)))
    assert audit([some, ben]).holds


def test_what_does_not_fit_is_refused(honest: list[Recording]) -> None:
    ann, ben = honest
    short = replace(ann, columns={**ann.columns, "jammed": ann.columns["jammed"][:, 1:]})
    with pytest.raises(RecordingError, match="bodies and 4 tools jammed"):
        audit([short, ben])


def test_steps_begin_where_the_last_ended(honest: list[Recording], monkeypatch: pytest.MonkeyPatch) -> None:
    """To the bit: which of two triangles is nearer, and what friction loses there, rounding may decide."""
    given: list[tuple[Any, ...]] = []
    outside = RecordedMaterial.outside

    def noted(self: RecordedMaterial, *args: Any, **more: Any) -> Any:
        given.append((*args[:2], more["follows"]))
        return outside(self, *args, **more)

    monkeypatch.setattr(RecordedMaterial, "outside", noted)
    audit(honest)
    several = honest[0].header.body.material is not None and bool(honest[0].header.body.material.between)
    assert len(given) == (2 if several else 0)
    for start, after, follows in given:
        assert follows[1:].all()
        assert np.array_equal(start[1:], after[:-1])


def test_who_loses_debris_in_such_a_step_is_not_accused(tmp_path: Path) -> None:
    """What all moved like on the whole is not in the state then, as the debris has stopped."""
    blade = {
        "user": 2,
        "kind": "blade",
        "at": [-0.01, 0.03, 0.07],
        "axis": [0.08, 0, 0],
        "thickness": 0.05,
        "hand": {"path": [[0, 0, 0, 0], [0.16, 0, 0, -0.07]], "stiffness": 500, "damping": 20},
    }
    scenario = Scenario.make(
        network=PAIR,
        steps={"duration": 0.16, "period": [0.008, 0.004]},
        synchronisation={"law": "spring"},
        tools=[*TOOLS, blade],
        **BODIES["cells"],
    )
    recordings = [read_recording(path) for path in recorded_world(scenario, tmp_path)]
    ann = recordings[0]
    assert {event.fields["step"] for event in ann.events if event.kind == "cut"} & set(jammed(ann))
    result = audit(recordings)
    assert result.holds, result.verdict


def test_only_rounding_is_taken_for_the_place_where_the_last_step_ended() -> None:
    rng = np.random.default_rng(0)
    ends = rng.normal(size=(5, 7, 3))
    middle = 0.5 * (ends + np.concatenate([ends[:1], ends[:-1]]))
    assert np.array_equal(begun(ends, middle)[1:], ends[:-1])
    moved = middle.copy()
    moved[3, 2, 1] += 1e-12
    assert np.array_equal(begun(ends, moved)[[1, 2, 4]], ends[[0, 1, 3]])
    assert begun(ends, moved)[3, 2, 1] == pytest.approx(ends[2, 2, 1] + 2e-12, abs=1e-14)


def test_how_fast_went_what_stopped_follows_from_the_step_itself(honest: list[Recording]) -> None:
    """Of any nodes, whatever closed the step; of states that are kept less often, or after a gap, nothing is said."""
    ann, _ = honest
    body, rows = ann.header.body, ann.states["state_row"]
    if body.material is None:  # nothing of it can be cut
        return
    x, v, middle = (body.field(ann.states[name]) for name in ("position", "velocity", "middle"))
    mean = 2.0 * (x - middle) / ann.columns["period"][rows][:, None, None]
    stopped = np.zeros(v.shape[:2], dtype=bool)
    stopped[~np.isin(rows, jammed(ann)), ::5] = True
    left = np.where(stopped[:, :, None], 0.0, v)
    found = before_stop(ann, np.arange(rows.size), left, mean, stopped, 0.5)
    assert np.isnan(found[0]).all()
    assert found[1:] == pytest.approx(v[1:], abs=1e-9 * np.abs(v).max())
    assert (ann.columns["closure_factor"].max() > 1e-3) == bool(body.material.between)
    some = np.arange(0, rows.size, 2)
    sparse = replace(ann, states={name: values[some] for name, values in ann.states.items()})
    seldom = before_stop(sparse, np.arange(some.size), left[some], mean[some], stopped[some], 0.5)
    assert np.array_equal(np.isnan(seldom).any(axis=(1, 2)), stopped[some].any(axis=1))
    gap, index = int(np.flatnonzero(stopped.any(axis=1))[-1]), np.array(ann.columns["index"])
    index[rows[gap] :] += 1
    missed = replace(ann, columns={**ann.columns, "index": index})
    after = before_stop(missed, np.arange(rows.size), left, mean, stopped, 0.5)
    assert np.flatnonzero(np.isnan(after).any(axis=(1, 2))).tolist() == [0, gap]


def test_it_is_exported(honest: list[Recording]) -> None:
    said = recordings_dataset(honest)["jammed"]
    assert said.attrs["units"] == "m/s"
    assert np.array_equal(said.values[0, 1 : 1 + honest[0].steps], honest[0].columns["jammed"], equal_nan=True)
