"""Link laws compared: known costs, danger, tuning, what a lying law looks like, and the report."""

import json
import re
import tomllib
from dataclasses import replace
from math import nan
from pathlib import Path
from textwrap import dedent
from typing import Any

import numpy as np
import pytest
from scipy import stats
from tests.laboratory.inside import (
    TASKS,
    HandKind,
    LawTable,
    NetworkTable,
    danger,
    dangerous,
    harmless,
    losing,
    multiples,
    ours,
    spread,
    tune,
)
from tests.laws.scenes import law_of

from cotouch.errors import ScenarioError
from cotouch.laboratory import MEASURES, Study, broken, compare, ideal, mean_cost, measures_of, write_report
from cotouch.laws import End, copy, register
from cotouch.simulation import discrepancy, prepare, simulate

EXAMPLE = Path(__file__).parents[2] / "examples" / "laws.toml"
RIGID, FINE = 1e4, 2e-5


def study(**tables: Any) -> Study:
    return Study.make(
        **{
            "laws": [{"name": "rule", "law": "spring"}, "wave"],
            "networks": [{"name": "near", "delay": 0.005}, {"name": "far", "delay": 0.1, "tuned_on": "near"}],
            "tasks": ["carry", "tug"],
            "draws": 2,
            "duration": 4.0,
            "tuning": {"search": 0, "local": 0},
            **tables,
        }
    )


@pytest.mark.parametrize("task", list(TASKS))
@pytest.mark.parametrize("users", [2, 3])
def test_rigid_links_without_delay_are_the_ideal(task: str, users: int) -> None:
    whole = study(spring=RIGID, period=FINE, networks=[{"name": "none", "delay": 0.0}])
    hands = whole.task(task, users, whole.hands[0], 0)
    bare = LawTable(law="spring", damping=0.0)
    found = measures_of(bare, prepare(whole.scenario(bare, whole.networks[0], users, hands)), ideal(whole, hands))
    assert found["cost"] < 0.2 * (users - 1) ** 1.5
    assert found["place"] < 1e-3
    assert found["made"] == 0.0


def test_measures_are_those_of_a_run_of_its_own() -> None:
    whole = study()
    hands = whole.task("tug", 2, whole.hands[0], 0)
    scenario = whole.scenario(whole.laws[1], whole.networks[1], 2, hands, seed=5)
    found, run = measures_of(whole.laws[1], prepare(scenario), ideal(whole, hands)), simulate(scenario)
    assert found["apart"] == pytest.approx(discrepancy(run)["rms"], rel=1e-9)
    assert found["extracted"] == pytest.approx(float(run.attrs["extracted"]), abs=1e-15)
    force = run["force"].values[:, 1:, 0]
    assert found["rough"] == pytest.approx(np.abs(np.diff(force, axis=1)).max())
    perfect = ideal(whole, hands)
    wrong = np.sqrt(((force - perfect.force[:, :, 0]) ** 2).mean()) / perfect.size
    assert found["force"] == pytest.approx(wrong)
    assert found["cost"] == pytest.approx(found["place"] / 0.01 + found["force"])


def test_a_setting_is_a_multiple_of_what_would_be() -> None:
    whole = study()
    law, network = whole.laws[1], whole.networks[1]
    once, twice = (
        simulate(whole.scenario(law, network, 2, whole.task("tug", 2, whole.hands[0], 0), setting=setting))
        for setting in ({}, {"impedance": 2.0, "spring": 0.5})
    )
    same = whole.scenario(LawTable(law={"kind": "wave", "impedance": "1x"}), network, 2, [])
    assert np.array_equal(simulate(same)["position"], simulate(whole.scenario(law, network, 2, []))["position"])
    # Twice the impedance at half the spring, from which the impedance follows, is the same line.
    assert np.array_equal(once["position"], twice["position"])


def test_springs_without_damping_are_dangerous_at_long_delays_and_with_it_nowhere() -> None:
    cell = {"setting": {}, "delay": [0.001, 0.2]}
    part = study(laws=["spring"], networks=[{"name": "map", "delay": 0.0}]).model_dump(mode="json")
    active = study(laws=[{"name": "P", "law": "spring", "damping": 0.0}]).model_dump(mode="json")["laws"]
    assert danger(cell | {"study": part})["dangerous"] == [False, False]
    found = danger(cell | {"study": part | {"laws": active}})
    assert found["dangerous"] == [False, True]
    assert found["cost"][0] < found["cost"][1]


def test_a_ring_of_three_is_also_timed_and_mapped_with_two() -> None:
    ring = {"graph": "ring", "users": [3], "laws": ["spring"], "felt": False, "tasks": ["carry"]}
    found = compare(study(**ring, map={"delay": [0.01], "stiffness": [300.0]}), jobs=1)
    assert np.isfinite(found["cost"].isel(hand=0).values).all()
    assert np.isfinite(found["time"].values).all()
    assert found["map_dangerous"].values.tolist() == [[[0.0]]]


def test_what_does_not_come_to_rest_is_seen() -> None:
    """Two who pull apart through an account that is soon empty: copies shivered, and no push told."""
    laws = [{"name": "shivers", "law": {"kind": "paid", "still": 0.0}}, "paid"]
    part = study(laws=laws, hands=[{"stiffness": 1800.0}], tasks=["carry"]).model_dump(mode="json")
    found = [danger({"setting": {}, "delay": [0.1], "study": part | {"laws": [law]}}) for law in part["laws"]]
    assert [one["dangerous"] for one in found] == [[False], [False]]
    assert found[0]["restless"][0] > 5e-3
    assert found[1]["restless"][0] < 1e-3


def test_copies_that_nobody_holds_are_looked_at_by_themselves() -> None:
    # At 5 ms the rule leaves them hardly any damping: it is tight.
    whole = study(networks=[{"name": "near", "delay": 0.025}])
    active, hand = LawTable(name="P", law="spring", damping=0.0), HandKind()
    near = whole.networks[0]
    assert dangerous(whole, active, near, 2, hand, {}, let_go=True)
    assert not dangerous(whole, whole.laws[0], near, 2, hand, {}, let_go=True)
    assert not dangerous(whole, active, near, 2, hand, {})


def test_tuning_finds_nothing_worse_than_what_is_published() -> None:
    tuning = {"search": 6, "local": 3, "draws": 1, "safe": 3}
    part = study(laws=["wave"], networks=[{"name": "near", "delay": 0.025}], tuning=tuning).model_dump(mode="json")
    found = tune({"study": part})
    assert found["cost"]["tuned"] < 0.9 * found["cost"]["published"]
    assert found["settings"]["safe"] == found["settings"]["tuned"]
    assert found["tried"] == 10
    assert set(found["settings"]["tuned"]) == {"spring", "impedance", "filter"}
    assert tune({"study": part}) == found


def test_springs_without_damping_have_no_safe_setting() -> None:
    whole = study(laws=[{"name": "P", "law": "spring", "damping": 0.0}])
    assert not harmless(whole, {}, 20)
    assert harmless(study(laws=["spring"]), {}, 5)


def _pushing(end: End) -> None:
    """A negative spring: it pushes copies apart."""
    for i in range(end.push.shape[0]):
        end.push[i] = 0.2 * end.spring * (end.position[i] - end.sample[i])
    copy(end.target, end.sample)
    end.gains[0] = end.spring
    end.gains[1] = 0.2


def test_results_intervals_danger_and_the_report(tmp_path: Path) -> None:
    register(
        replace(law_of("spring"), name="pushing", before=_pushing, passive=True, rule=0.0, springs=False, _parts=[])
    )
    whole = study(laws=[{"name": "rule", "law": "spring"}, "wave", "pushing"], tasks=["tug", "carry"], ours="rule")
    told: list[str] = []
    found = compare(whole, store=tmp_path / "cells", jobs=2, progress=lambda _n, _of, what: told.append(what))
    assert set(told) == {"score"}
    assert found["cost"].dims == ("law", "tuning", "network", "users", "hand", "task", "draw")
    assert set(MEASURES) <= set(found.data_vars)
    known = found.sel(law="wave", network="far", users=2, tuning="published").isel(hand=0)["cost"].values.mean(axis=0)
    assert mean_cost(found)["wave", "far", 2] == pytest.approx(spread(known))
    # A law that lies about its energy is caught, and named.
    assert float(found["made"].sel(law="pushing").max()) > 0.0
    assert float(found["made"].sel(law=["rule", "wave"]).max()) == 0.0
    assert list(broken(found)) == ["pushing"]
    # Nor does it count among passive laws, however little it costs.
    cheap = found.assign(cost=found["cost"].where(found["law"] != "pushing", 0.0))
    assert ours(cheap, whole.model_copy(update={"ours": None})) == "wave"
    # The rule drags, so somewhere waves cost less for certain.
    cases = losing(found, whole)
    assert cases
    assert {case["rival"] for case in cases} == {"wave"}
    drag = multiples(found, whole, "rule", "far", 2)["drag"]
    assert drag == pytest.approx(4 * 50 * 0.1 / (0.13 * 6.5), rel=0.05)
    again = compare(whole, store=tmp_path / "cells", jobs=1, progress=lambda n, of, _what: told.append(f"{n}/{of}"))
    assert told[-1] == "6/6"
    assert again.drop_vars("time").identical(found.drop_vars("time"))

    text = write_report(found, tmp_path / "report.html").read_text(encoding="utf-8")
    titles = re.findall(r"<h2><span[^>]*>\d+</span> (.*?)</h2>", text)
    assert titles[0] == "Where rule loses"
    assert "laws that promise passivity and made energy: pushing" in text
    assert not re.search(r'(src|href)="(?!#)', text)
    for name in ("wave", "far", "held out", "dangerous"):
        assert name in text
    assert "nan" not in re.sub(r"<[^>]*>", "", text).lower()


def test_a_law_without_any_run_leaves_a_reason() -> None:
    with pytest.raises(ScenarioError, match=r"none\.csv"):
        compare(study(networks=[{"name": "homes", "delays": str(Path(__file__).with_name("none.csv"))}]))


def test_a_law_that_needs_a_constant_delay_gets_a_buffer() -> None:
    """Of 99 % of what comes, where the network varies."""
    register(replace(law_of("wave"), name="strict", constant_delay=True, _parts=[]))
    loose = {"name": "loose", "delay": 0.02, "channel": {"jitter": {"kind": "exponential", "scale": 0.01}}}
    whole = study(laws=["strict", "wave"], networks=[{"name": "even", "delay": 0.02}, loose])
    found = {
        (law.label, network.name): prepare(whole.scenario(law, network, 2, [])).schedule
        for law in whole.laws
        for network in whole.networks
    }
    assert {place for place, timing in found.items() if timing.mode == "constant"} == {("strict", "loose")}
    buffered = found["strict", "loose"]
    assert 0.0 < buffered.underruns.mean() / buffered.count[0] < 0.011
    assert np.isfinite(compare(whole)["cost"].isel(hand=0)).all()


def test_a_file_that_changed_is_read_anew(tmp_path: Path) -> None:
    """Of networks and tasks: cells that follow from what a file held are computed again, others are not."""
    table, trace = tmp_path / "trips.csv", tmp_path / "trace.csv"
    networks = [
        {"name": "table", "delays": str(table)},
        {"name": "trace", "delay": 0.0, "channel": {"trace": {"file": str(trace), "column": "rtt_ms", "as": "rtt"}}},
    ]
    tuning = {"search": 1, "local": 0, "draws": 1}
    whole = study(laws=["spring"], networks=networks, tasks=["carry"], felt=False, tuning=tuning)
    costs: list[dict[Any, tuple[float, float]]] = []
    for trip, latency in ((20, 20), (200, 20), (200, 200), (20, 20)):
        table.write_text(f",a,b\na,0,{trip}\nb,{trip},0\n", encoding="utf-8")
        trace.write_text(f"rtt_ms\n{latency}\n", encoding="utf-8")
        costs.append(mean_cost(compare(whole, store=tmp_path / "cells")))
    first, second, third, last = costs
    assert second["spring", "table", 2][0] > 1.5 * first["spring", "table", 2][0]
    assert second["spring", "trace", 2] == first["spring", "trace", 2]
    assert third["spring", "trace", 2][0] > 1.5 * first["spring", "trace", 2][0]
    assert last == first
    assert len(list((tmp_path / "cells").glob("tune-*"))) == 4


def test_the_interval_is_students() -> None:
    draws = np.array([1.0, 2.0, 4.0, 3.0])
    mean, half = spread(draws)
    low, high = stats.t.interval(0.95, 3, loc=draws.mean(), scale=stats.sem(draws))
    assert (mean - half, mean + half) == pytest.approx((low, high))
    assert spread(np.array([1.0, np.inf])) == (np.inf, np.inf)


def test_draws_are_the_same_for_all_laws_and_other_ones_for_tuning() -> None:
    whole = study()
    network, hand = whole.networks[0], whole.hands[0]
    assert whole.task("both", 2, hand, 1) == whole.task("both", 2, hand, 1)
    assert whole.task("both", 2, hand, 1) != whole.task("both", 2, hand, -1)
    seeds = {whole.channel_seed(network, draw) for draw in range(-5, 20)}
    assert len(seeds) == 25
    assert whole.channel_seed(whole.networks[1], 0) != whole.channel_seed(network, 0)


def test_the_example_is_the_table_of_the_documents() -> None:
    found = Study.read(EXAMPLE)
    assert found.users == [2, 4, 8]
    assert found.draws == 20
    assert {law.kind for law in found.laws} >= {"spring", "pd", "once", "wave", "tdpa", "tank", "pspm", "paid"}
    assert all(file.is_file() for file in found.files())
    for network in found.networks:
        for users in found.users:
            joined = found.joined(network, users, 1.0)
            assert joined.size == users
            assert len(joined.links) == users * (users - 1) // 2
    assert found.ours == "paid"


def test_the_study_in_the_documents_can_be_run() -> None:
    text = (EXAMPLE.parents[1] / "docs" / "laws.md").read_text(encoding="utf-8")
    block = re.search(r'(?:^    .*\n|\n)*^    title = "Two laws"\n(?:^    .*\n|\n)*', text, re.MULTILINE)
    assert block is not None
    found = Study.make(**tomllib.loads(dedent(block[0])))
    assert [law.label for law in found.laws] == ["wave", "bare springs"]
    assert found.map is not None
    for name in ("laws", "networks", "users", "tasks", "hands", "draws", "[tuning]", "[map]"):
        assert f"`{name}`" in text


@pytest.mark.parametrize(
    ("tables", "message"),
    [
        ({"laws": ["wvae"]}, 'law is "wvae"; it must be one of'),
        ({"laws": ["wave", "wave"]}, 'laws holds "wave" twice'),
        (
            {"laws": [{"kind": "wave", "impedance": "two"}]},
            'law.impedance is "two"; it must be a number, or a multiple',
        ),
        ({"tasks": ["juggle"]}, 'tasks holds "juggle"; it must be one of carry, tug'),
        ({"ours": "paid"}, 'ours is "paid", which is not one of the laws'),
        ({"networks": [{"name": "a"}]}, 'network "a" needs either delay or delays'),
        ({"networks": [{"name": "a", "delay": 0.1, "tuned_on": "b"}]}, 'is tuned_on "b", which is not one of'),
        ({"draws": 1}, "draws is 1"),
        ({"users": [1]}, r"users\[1\] is 1"),
        ({"colour": 1}, "colour is not an option"),
        ({"duration": 1.0}, "duration is 1.0"),
        ({"period": 0.1}, "period is 0.1 s; in a run of 4 s it must be at most 0.04 s"),
        ({"laws": [{"name": "a"}]}, r"laws\[1\]: an entry of laws needs either law or replica"),
        ({"map": {"delay": [0.1, nan], "stiffness": [1.0]}}, r"map.delay\[2\] is nan; it must be a finite number"),
        ({"networks": [{"name": "a", "delay": 0.1, "pick": ["b"]}]}, 'network "a" has pick, which picks users of'),
    ],
)
def test_what_is_wrong_with_a_study_is_one_sentence(tables: dict[str, Any], message: str) -> None:
    with pytest.raises(ScenarioError, match=message) as caught:
        study(**tables)
    assert "\n" not in str(caught.value)


def test_too_few_users_in_a_table_are_named() -> None:
    network = NetworkTable(
        name="homes", delays=str(EXAMPLE.parent / "networks" / "seattle-20-median.csv"), pick=["s1", "s6"]
    )
    with pytest.raises(ScenarioError, match='network "homes" has 2 users; 4 are required'):
        study().joined(network, 4, 1.0)


def test_replicas_have_no_codec() -> None:
    coded = {"name": "coded", "delay": 0.02, "channel": {"codec": {"deadband": 0.1}}}
    with pytest.raises(
        ScenarioError, match='owner, coded: network "coded" has a codec, but replica "owner" says all in'
    ):
        compare(study(laws=[{"replica": "owner"}], networks=[coded]))


def test_settings_and_costs_survive_the_file() -> None:
    """What the report reads back is the study that was run."""
    whole = study()
    assert Study.make(**json.loads(whole.model_dump_json())) == whole
