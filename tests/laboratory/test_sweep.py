"""One scenario with options varied."""

from pathlib import Path
from typing import Any

import pytest
from tests.laws.scenes import two

from cotouch.errors import ScenarioError
from cotouch.laboratory import sweep, values_of, varied
from cotouch.scenario import Scenario
from cotouch.simulation import discrepancy, simulate

BASE = Scenario.make(
    network=two(0.025),
    steps={"duration": 1.0},
    hands=[{"user": 1, "stiffness": 300, "path": 0.1}, {"user": 2, "stiffness": 300}],
)


def test_all_runs_have_one_law_but_where_it_is_varied() -> None:
    """From 0.6 s there and back on another one would be chosen."""
    found = sweep(BASE.replace(synchronisation={}), {"link.delay": [0.01, 0.5]}, jobs=1)
    assert '"law": "paid"' in found.attrs["scenario"]
    assert float(found["damping"].max()) == 0.0


def test_every_combination_is_what_that_scenario_gives() -> None:
    found = sweep(
        BASE, {"link.delay": [0.01, 0.05], "synchronisation.law": ["spring", "wave"], "hands.stiffness": [100]}
    )
    assert dict(found.sizes) == {"link.delay": 2, "synchronisation.law": 2, "hands.stiffness": 1}
    alone = simulate(
        BASE.replace(
            network=two(0.05),
            synchronisation__law="wave",
            hands=[{"user": 1, "stiffness": 100, "path": 0.1}, {"user": 2, "stiffness": 100}],
        )
    )
    there = found.sel({"link.delay": 0.05, "synchronisation.law": "wave"}).squeeze()
    assert float(there["rms"]) == discrepancy(alone)["rms"]
    assert float(there["made"]) == alone.attrs["made"]
    assert float(found["damping"].sel({"synchronisation.law": "wave"}).max()) == 0.5


def test_what_cannot_be_is_said_beside_what_can() -> None:
    found = sweep(BASE, {"synchronisation.law": ["spring", "wvae"]})
    assert str(found["problem"].values[0]) == ""
    assert 'law is "wvae"' in str(found["problem"].values[1])
    with pytest.raises(ScenarioError, match='law is "wvae"'):
        sweep(BASE, {"synchronisation.law": ["wvae"]})


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("0.01:0.03:3", [0.01, 0.02, 0.03]),
        ("1:100:3:log", [1.0, 10.0, 100.0]),
        ("spring,wave", ["spring", "wave"]),
        ("1,2.5", [1, 2.5]),
    ],
)
def test_values_are_read(text: str, values: list[Any]) -> None:
    assert values_of(text) == pytest.approx(values) if isinstance(values[0], float) else values_of(text) == values


@pytest.mark.parametrize("text", ["1:2", "0:1:3:log", "1:2:0", "a:b:3", "1:2:3:lin", "1:2:3:log:4"])
def test_ranges_that_are_none_are_refused(text: str) -> None:
    with pytest.raises(ScenarioError, match="is not a range; write low:high:count"):
        values_of(text)


@pytest.mark.parametrize("option", ["link.colour", "network.users", "nothing", "tools.user", "x.y"])
def test_options_that_are_none_are_refused(option: str) -> None:
    with pytest.raises(ScenarioError, match="cannot be varied; it must be seed, link"):
        varied(BASE, option, 1.0)


def test_the_seed_can_be_varied() -> None:
    loose = BASE.replace(channel={"jitter": {"scale": 0.02}})
    found = sweep(loose, {"seed": [1, 2, 1]})
    one, two_, again = found["rms"].values.tolist()
    assert one == again != two_
    assert float(found["law_initial_energy"][0]) == simulate(loose.replace(seed=1)).attrs["law_initial_energy"]


def test_a_file_that_changed_is_read_anew(tmp_path: Path) -> None:
    trace = tmp_path / "trace.csv"
    rms: list[float] = []
    for latency in (20, 200, 20):
        trace.write_text(f"rtt_ms\n{latency}\n", encoding="utf-8")
        given = BASE.replace(channel={"trace": {"file": str(trace), "column": "rtt_ms", "as": "rtt"}})
        rms.append(float(sweep(given, {"link.spring": [50]}, store=tmp_path / "cells")["rms"][0]))
    assert rms[0] == rms[2] < rms[1]
    assert len(list((tmp_path / "cells").iterdir())) == 2


def test_no_jobs_are_refused() -> None:
    with pytest.raises(ScenarioError, match="jobs is 0; it must be at least 1, or -1"):
        sweep(BASE, {"link.spring": [50]}, jobs=0)
