"""Recordings as one dataset: the names and numbers of a simulated run."""

from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from tests.recording.driven import Driven, pulled
from tests.recording.test_audit import recorded_world

from cotouch.body import lattice
from cotouch.errors import OutputError, RecordingError
from cotouch.recording import read_recording, recordings_dataset, save_dataset
from cotouch.scenario import Scenario
from cotouch.simulation import at_times, simulate, tables


def test_it_is_the_dataset_of_the_same_run_in_the_simulator(tmp_path: Path) -> None:
    """Names, dimensions, units and values; metrics that are made for one take the other."""
    scenario = Scenario.make(
        network={"users": ["Ann", "Ben"], "spring": [[0, 60], [60, 0]], "delay": [[0, 0.02], [0.03, 0]]},
        body={"kind": "chain", "nodes": 3, "dimension": 2},
        steps={"duration": 0.5, "period": [0.004, 0.01]},
        synchronisation={"law": "spring"},
        hands=[{"user": 1, "node": 2, "path": [0.1, -0.05]}],
        record={"nodes": "all"},
    )
    recorded = recordings_dataset([read_recording(path) for path in recorded_world(scenario, tmp_path)])
    run = simulate(scenario)
    names = ["time", "period", "position", "velocity", "supplied", "body_loss", "local_loss", "extra_loss", "kinetic"]
    for name in [*names, "elastic", "iterations", "link_work", "age", "force"]:
        assert recorded[name].dims == run[name].dims, name
        assert recorded[name].shape == run[name].shape, name
        assert recorded[name].attrs["units"] == run[name].attrs["units"], name
        first = 1 if np.isnan(recorded[name].values[0, 0]).all() else 0  # energies before the first step are not kept
        assert np.allclose(
            recorded[name].values[:, first:], run[name].values[:, first:], rtol=0, atol=1e-12, equal_nan=True
        ), name
    assert float(run["supplied"].max()) > 1e-3
    assert recorded["direction"].values.tolist() == run["direction"].values.tolist()
    assert recorded["user"].values.tolist() == ["Ann", "Ben"]
    for name in ("time", "tick_time", "receiver", "sender"):
        assert recorded.coords[name].dims == run.coords[name].dims, name
    for name in ("receiver", "sender"):
        assert recorded[name].values.tolist() == run[name].values.tolist()
    assert np.allclose(recorded["tick_time"], run["tick_time"], rtol=0, atol=1e-9)
    assert recorded["slack"].attrs == run["slack"].attrs
    # Both users end a step every 20 ms. What was lost by then, what links did, and what the spring holds say the slack.
    ann, ben = slice(0, None, 5), slice(0, 51, 2)
    lost = run["local_loss"].values[0, ann] + run["local_loss"].values[1, ben]
    done = run["link_work"].values[0, ann] + run["link_work"].values[1, ben]
    apart = run["position"].values[0, ann] - run["position"].values[1, ben]
    spring = 0.5 * 60.0 * (apart**2).sum(axis=(1, 2))
    assert recorded["slack"].values[::5] == pytest.approx(lost - done - spring, abs=1e-12)
    assert float(run["slack"][-1]) > 1e-3
    found = tables(recorded)
    assert len(found["user"]) == 126 + 51
    assert len(found["user_node_axis"]) == (126 + 51) * 3 * 2
    assert found["direction"].groupby(["receiver", "sender"]).size().to_dict() == {
        ("Ann", "Ben"): 126,
        ("Ben", "Ann"): 51,
    }
    times = np.linspace(0.1, 0.4, 7)
    assert np.allclose(at_times(recorded, "position", times), at_times(run, "position", times))


def test_values_of_every_user_at_its_own_steps(tmp_path: Path) -> None:
    driven = Driven(tmp_path, clocks=(5.0, 700.0), hands={0: pulled()}, body=lattice((2, 2, 2)))
    run = recordings_dataset([read_recording(path) for path in driven.run()[::-1]])
    assert run.sizes["step"] == 251
    for user, steps in enumerate((250, 100)):
        own = run.isel(user=user)
        assert np.isfinite(own["time"]).sum() == steps + 1
        assert own["time"].values[: steps + 1] == pytest.approx(driven.periods[user] * np.arange(steps + 1), abs=1e-6)
        places = np.array([driven.model.to_nodes(x) for x, _ in driven.states[user]]) + driven.body.rest
        assert np.allclose(own["position"].values[1 : steps + 1], places, rtol=0, atol=1e-15)
        assert np.allclose(own["position"].values[0], driven.body.rest, rtol=0, atol=1e-15)
        assert own["supplied"].values[steps] == pytest.approx(sum(r.supplied for r in driven.reports[user]))
        assert own["force"].values[7] == pytest.approx(driven.reports[user][6].force[0, :3])
    assert run["age"].sel(direction="1<-2").values[1:251] == pytest.approx([float(r.age[0]) for r in driven.reports[0]])


def test_states_that_are_kept_less_often_have_their_own_dimension(tmp_path: Path) -> None:
    driven = Driven(tmp_path, options={"every": 10})
    run = recordings_dataset([read_recording(path) for path in driven.run()])
    assert run["position"].dims == ("user", "state", "node", "axis")
    assert run["state_time"].values[0, :3] == pytest.approx([0.004, 0.044, 0.084])
    assert "slack" not in run, "without every state nobody knows it"
    assert set(tables(run)) >= {"user", "direction", "user_state_node_axis"}
    assert run["position"].values[0, 2, 0, 0] == driven.states[0][20][0][0, 0]


def test_the_file_is_whole_or_not_there(tmp_path: Path) -> None:
    run = recordings_dataset([read_recording(path) for path in Driven(tmp_path).run()])
    save_dataset(run, tmp_path / "x.nc")
    with xr.open_dataset(tmp_path / "x.nc", engine="h5netcdf") as again:
        for name, values in run.data_vars.items():
            assert np.array_equal(values, again[name], equal_nan=True)
            assert again[name].attrs["units"]
        assert again.attrs["session"] == "table"
    with pytest.raises(OutputError, match="does not exist; create it first"):
        save_dataset(run, tmp_path / "no" / "x.nc")
    with pytest.raises(OutputError, match=r'ends in "\.mat"; its name must end in \.nc, '):
        save_dataset(run, tmp_path / "x.mat")
    assert [path.name for path in tmp_path.iterdir() if path.suffix != ".mcap"] == ["x.nc"]


def test_without_a_neighbours_recording_there_is_no_slack_and_its_name_is_its_number(tmp_path: Path) -> None:
    run = recordings_dataset([read_recording(Driven(tmp_path).run()[0])])
    assert "slack" not in run
    assert run["sender"].values.tolist() == ["user 2"]


def test_two_of_the_same_user_are_refused(tmp_path: Path) -> None:
    one = read_recording(Driven(tmp_path).run()[0])
    with pytest.raises(RecordingError, match="of the same user"):
        recordings_dataset([one, one])
