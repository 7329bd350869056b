import hashlib
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from tests.simulation.inside import TOOL_UNITS, UNITS, layout

from cotouch.body import chain
from cotouch.errors import OutputError, ScenarioError
from cotouch.network import Network
from cotouch.scenario import Scenario
from cotouch.simulation import dataset, prepare, run_batch, save, simulate, tables

PAIR: dict[str, Any] = {
    "users": ["Ann", "Ben"],
    "spring": [[0, 50], [50, 0]],
    "delay": [[0, 0.03], [0.05, 0]],
}
JITTER = {"jitter": {"scale": 0.02}, "loss": 0.1}


@pytest.fixture(scope="module")
def run() -> xr.Dataset:
    return simulate(
        {
            "network": PAIR,
            "body": {"kind": "chain", "nodes": 3, "dimension": 2, "spacing": 0.5},
            "steps": {"duration": 1.0, "rate": [100, 250]},
            "channel": JITTER,
            "hands": [{"user": 1, "node": 3, "path": [0.1, -0.1]}, {"user": 1, "node": 1, "path": [0.0, 0.2]}],
        }
    )


# Only bodies with a closed step have these.
_CLOSED = ("closure", "closure_factor", "closure_alarms")
_WORLD = ("world_force", "world_loss", "world_stored")
_CUT = ("cut", "cut_by", "cut_elements", "cut_time", "debris_time")


def test_dimensions_and_units(run: xr.Dataset) -> None:
    assert run["position"].dims == ("user", "step", "node", "axis")
    assert run["user"].values.tolist() == ["Ann", "Ben"]
    assert run["node"].values.tolist() == [1, 2, 3]
    assert run["axis"].values.tolist() == ["x", "y"]
    assert run["direction"].values.tolist() == ["1<-2", "2<-1"]
    assert run["link"].values.tolist() == ["1-2"]
    assert set(run.data_vars) == {name for name in UNITS if not name.startswith("rigid_")} - set(TOOL_UNITS) - {
        "frame_position",
        *_CLOSED,
        *_WORLD,
        *_CUT,
        "time",
        "tick_time",
    }
    for name in run.data_vars:
        assert run[name].attrs["units"] == UNITS[str(name)][0]
        assert run[name].attrs["long_name"]


def test_positions_start_at_rest_and_steps_follow_the_clock(run: xr.Dataset) -> None:
    assert run["position"].isel(step=0).values[0].tolist() == [[0.0, 0.0], [0.5, 0.0], [1.0, 0.0]]
    assert run["time"].values[1, :4] == pytest.approx([0, 0.004, 0.008, 0.012])


def test_what_a_slower_user_never_reached_is_missing(run: xr.Dataset) -> None:
    assert run.sizes["step"] == 251
    assert run["position"].sel(user="Ann").isel(step=100).notnull().all()
    assert run["position"].sel(user="Ann").isel(step=101).isnull().all()
    assert run["force"].sel(user="Ann").isel(step=101).isnull().all()
    assert run["position"].sel(user="Ben").notnull().all()
    assert run["age"].sel(direction="1<-2").isel(step=101).isnull()
    assert run.sizes["tick"] == 251


def test_forces_of_a_user_are_the_sum_of_his_hands(run: xr.Dataset) -> None:
    summed = run["hand_force"].sum("hand", skipna=False).values
    assert np.array_equal(run["force"].sel(user="Ann").values, summed, equal_nan=True)
    assert not run["force"].sel(user="Ben").values.any()


def test_energy_identity_holds_from_the_recorded_books(run: xr.Dataset) -> None:
    """Recomputed from the variables of users and links, not from the engine's own sum."""
    last = {"Ann": 100, "Ben": 250}

    def total(name: str) -> float:
        return sum(float(run[name].sel(user=user).isel(step=step)) for user, step in last.items())

    stored = total("kinetic") + total("elastic") + float(run["link_energy"].isel(tick=-1).sum())
    lost = total("body_loss") + total("local_loss") + total("extra_loss")
    delay = sum(
        float(run["delay_work"].sel(direction=name).isel(step=last[user]))
        for name, user in (("1<-2", "Ann"), ("2<-1", "Ben"))
    )
    assert stored == pytest.approx(float(run["stored"][-1]), rel=1e-12)
    assert stored - float(run["stored"][0]) == pytest.approx(total("supplied") - lost + delay, abs=1e-13)
    # A link gives its receivers what its spring loses plus what delay adds.
    links = sum(
        float(run["link_work"].sel(direction=name).isel(step=last[user]))
        for name, user in (("1<-2", "Ann"), ("2<-1", "Ben"))
    )
    assert links == pytest.approx(delay - float(run["link_energy"].isel(tick=-1).sum()), abs=1e-13)


def test_same_seed_same_bytes_other_seed_others(tmp_path: Path) -> None:
    scenario = Scenario.make(
        network=PAIR, channel=JITTER, steps={"duration": 1.0, "period": 0.005}, hands=[{"user": 1, "path": 0.1}]
    )
    digests: list[str] = []
    for name, seed in (("a", 0), ("b", 0), ("c", 1)):
        save(simulate(scenario.replace(seed=seed)), tmp_path / f"{name}.nc")
        digests.append(hashlib.sha256((tmp_path / f"{name}.nc").read_bytes()).hexdigest())
    assert digests[0] == digests[1]
    assert digests[0] != digests[2]


def test_netcdf_round_trip(run: xr.Dataset, tmp_path: Path) -> None:
    save(run, tmp_path / "run.nc")
    again = xr.load_dataset(tmp_path / "run.nc", engine="h5netcdf")
    plain = run.drop_attrs()
    xr.testing.assert_identical(again.drop_attrs(), xr.Dataset(dict(plain.data_vars), plain.coords))
    assert json.loads(again.attrs["scenario"])["network"]["users"] == ["Ann", "Ben"]
    assert again["force"].attrs["units"] == "N"
    assert [path.name for path in tmp_path.iterdir()] == ["run.nc"]


def test_a_result_that_cannot_be_written_is_said(run: xr.Dataset, tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="does not exist; create it first"):
        save(run, tmp_path / "nowhere" / "run.nc")
    for name in ("run.mat", "run.csv", "run"):
        with pytest.raises(OutputError, match=r"must end in \.nc, \.nc4, \.h5 or \.hdf5"):
            save(run, tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_recording_less_keeps_the_same_motion() -> None:
    tables: dict[str, Any] = {
        "network": PAIR,
        "steps": {"duration": 1.0, "period": 0.01},
        "hands": [{"user": 1, "path": 0.1}],
        "channel": JITTER,
    }
    all_steps, some = simulate(tables), simulate({**tables, "record": {"every": 7}})
    assert some.sizes["step"] == 15
    for name in ("position", "supplied", "age", "time", "force"):
        assert np.array_equal(some[name].values, all_steps[name].values[:, ::7], equal_nan=True)
    assert np.array_equal(some["stored"].values, all_steps["stored"].values[::7])
    assert some.attrs["passivity_margin"] == all_steps.attrs["passivity_margin"]


@pytest.mark.parametrize("users", [(1, 2), (2, 1)], ids=["in the order of the users", "in another order"])
@pytest.mark.parametrize("weight", [None, [[1.0, 0.4], [0.4, 2.0]]], ids=["a port a hand", "a port an axis"])
def test_a_hands_force_is_that_of_its_own_spring(users: tuple[int, int], weight: list[list[float]] | None) -> None:
    aims = {1: np.array([0.1, -0.2]), 2: np.array([-0.3, 0.05])}
    run = simulate(
        {
            "network": Network(**PAIR, weight=weight),
            "body": chain(3, dimension=2, spacing=0.5),
            "steps": {"duration": 0.1, "period": 0.01},
            "hands": [{"user": user, "node": 2, "stiffness": 30.0, "path": aims[user].tolist()} for user in users],
        }
    )
    place = run["position"].values[:, :, 1] - [0.5, 0.0]
    for hand, user in enumerate(users):
        middle = 0.5 * (place[user - 1, 1:] + place[user - 1, :-1])
        assert run["hand_force"].values[hand, 1:] == pytest.approx(30.0 * (aims[user] - middle), abs=1e-12)


def test_labelling_leaves_the_record_alone() -> None:
    """The dataset shows the engine's own arrays where it can, so gaps must not be written into them."""
    scenario = Scenario.make(
        network=PAIR, steps={"duration": 0.1, "rate": [100, 250]}, hands=[{"user": 1, "path": 0.1}], channel=JITTER
    )
    prepared = prepare(scenario)
    outcome = run_batch(prepared)
    before = [np.array(part) for part in outcome.record]
    first = dataset(prepared, outcome)
    assert first["supplied"].isnull().any()
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(before, outcome.record, strict=True))
    xr.testing.assert_identical(first, dataset(prepared, outcome))


@pytest.mark.parametrize("frame", ["fixed", "floating"])
def test_a_run_at_rest_has_nothing_to_balance(frame: str) -> None:
    """A share of round-off is no share of anything: this was 0.35, and 1.0 with more users."""
    rest = simulate(
        {
            "network": PAIR,
            "body": {"kind": "lattice", "shape": [3, 3, 3], "frame": frame},
            "steps": {"duration": 0.5},
        }
    )
    assert rest.attrs["energy_in_play"] < 1e-30
    assert rest.attrs["energy_residual"] < 1e-12


def test_names_and_times_are_coordinates(run: xr.Dataset) -> None:
    assert {"time", "tick_time", "receiver", "sender", "one", "other", "hand_user"} <= set(run.coords)
    assert run["receiver"].sel(direction="1<-2").item() == "Ann"
    assert run["sender"].sel(direction="1<-2").item() == "Ben"
    assert (run["one"].values.tolist(), run["other"].values.tolist()) == (["Ann"], ["Ben"])
    assert run["hand_user"].values.tolist() == ["Ann", "Ann"]
    assert run["supplied"].coords["time"].dims == ("user", "step")


def test_a_data_frame_of_the_whole_run_is_refused_in_a_sentence_that_names_the_tables(run: xr.Dataset) -> None:
    with pytest.raises(ScenarioError, match=r"would cross user with .* rows; take cotouch\.tables\(run\)") as caught:
        run.to_dataframe()
    assert "\n" not in str(caught.value)
    with pytest.raises(ScenarioError, match=r"would cross"):
        run.isel(hand=slice(0)).to_dataframe()  # of nobody's hands, which would leave no row at all
    few = run[["kinetic", "elastic"]].to_dataframe()
    assert len(few) == run["kinetic"].size
    assert run["link_work"].to_dataframe().shape[0] == run["link_work"].size


def test_tables_have_a_row_for_each_step_that_was_taken(run: xr.Dataset) -> None:
    found = tables(run)
    taken = np.isfinite(run["time"].values).sum(axis=1)
    assert taken.tolist() == [101, 251]
    assert found["user"].groupby("user").size().to_dict() == {"Ann": 101, "Ben": 251}
    assert len(found["user_node_axis"]) == (101 + 251) * 3 * 2
    assert found["direction"].groupby(["receiver", "sender"]).size().to_dict() == {
        ("Ann", "Ben"): 101,
        ("Ben", "Ann"): 251,
    }
    assert len(found["hand_axis"]) == 2 * 101 * 2
    assert len(found["tick"]) == run.sizes["tick"]
    ben = found["user"].query("user == 'Ben' and step == 250")
    assert ben["supplied"].item() == run["supplied"].values[1, 250]
    assert ben["time"].item() == run["time"].values[1, 250]
    every = {name for table in found.values() for name in table.columns}
    assert {str(name) for name in run.data_vars} <= every


def test_the_slack_of_inequality_7() -> None:
    """From rest (7) says: supplied >= stored + what all other dampers took; the slack is what damping B can spare."""
    asked: dict[str, Any] = {
        "network": PAIR,
        "body": {"stiffness": 5.0, "damping": 0.3},
        "steps": {"duration": 2.0},
        "synchronisation": {"law": "spring", "extra_damping": 0.1},
        "hands": [{"user": 1, "path": 0.1}],
    }
    run = simulate(asked)
    others = (run["body_loss"] + run["extra_loss"]).sum("user").values
    # Both users step together, so their own ledgers are of the same instants as the ticks.
    slack = run["supplied_total"].values - (run["stored"].values - run["stored"].values[0]) - others
    assert run["slack"].values == pytest.approx(slack, abs=1e-12)
    assert run["slack"].values[0] == 0.0
    assert run["slack"].values.min() >= -1e-12
    assert run["slack"].values[-1] > 1e-3
    loose = simulate({**asked, "synchronisation": {"damping_scale": 0.0}})
    assert loose["slack"].values[-1] < -1e-3, "without damping the delays put in energy"


def test_forces_that_overflowed_or_were_never_written_are_labelled_without_a_warning() -> None:
    hands = [{"user": 1, "path": 0.1}, {"user": 1, "path": 0.2}]
    ready = prepare(Scenario.make(network=PAIR, body={}, steps={"duration": 0.1, "rate": 100}, hands=hands))
    outcome = run_batch(ready)
    outcome.record.force[0], outcome.record.force[1] = np.inf, -np.inf
    assert np.isnan(dataset(ready, outcome)["force"].sel(user="Ann").values).any()


def test_columns_of_the_engines_ledgers_are_called_as_what_is_in_them():
    user, tool, closed = layout.USER_LEDGER[:-1], layout.TOOL_LEDGER, (*layout.CLOSED_LEDGER, *layout.WORLD_LEDGER)
    ledgers = {"USER": user, "TOOL": (*user, *tool), "CLOSED": closed[:6], "SLOT": layout.SLOT_LEDGER}
    for kind, names in (ledgers | {"TICK": layout.TICK_LEDGER}).items():
        for column, name in enumerate(names):
            if kind != "TOOL" or name in tool:
                assert getattr(layout, f"{kind}_{name.upper()}") == column
