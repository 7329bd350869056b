"""What is known of each law: drag, mass, stiffness, exact accounts, and which ones make energy."""

import tomllib
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.laboratory.costs import DELAY, cost
from tests.laws.scenes import AS_LAW, PASSIVE, law_of, two

from cotouch.laboratory import Study, impedance, made_energy, searched, touching, trial
from cotouch.laws import PAID, TANK, End, Facts, Tone, copy, given_power, laws, register
from cotouch.laws._paid_fields import (
    A2,
    COUNT,
    DONE,
    EACH,
    EVERY,
    KEPT,
    LOG,
    LOGGED,
    M_AGE,
    M_B,
    M_K,
    NEWEST,
    PAST,
    TIME,
    TIMES,
    A,
    V,
    X,
)
from cotouch.laws._paid_heard import between, place_then
from cotouch.laws._paid_other import past, take_over
from cotouch.scenario import Scenario
from cotouch.simulation import judge, prepare, run_batch, simulate, with_law

SPRING = 50.0
EXAMPLES = Path(__file__).parents[2] / "examples"


def moving(law: Any, *, speed: float = 0.1, **options: Any) -> float:
    """Mean force on the hand of user 1 that moves the object freely and evenly, divided by its speed [Ns/m]."""
    run = simulate(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 12.0},
            synchronisation={"mode": "constant", "law": law, **options},
            hands=[{"user": 1, "stiffness": 300, "damping": 10, "path": [[0.0, 0.0], [12.0, 12.0 * speed]]}],
            initial={"velocity": [speed, speed]},
        )
    )
    return float(run["force"].values[0, 4000:, 0].mean()) / speed


@pytest.mark.parametrize(
    ("law", "drag"),
    [
        ("spring", 4 * SPRING * DELAY),
        ("pd", 2 * SPRING * DELAY),
        ("once", 2.326 * SPRING * DELAY),
        ({"kind": "wave"}, 2 * 0.5),
    ],
)
def test_free_motion_costs_the_drag_that_is_known(law: Any, drag: float) -> None:
    assert moving(law) == pytest.approx(drag, rel=0.05)


def test_a_wave_line_has_no_drag_of_its_own() -> None:
    assert abs(moving("wave", damping=0.0)) < 0.01 * 4 * SPRING * DELAY


def test_a_wave_line_adds_the_mass_that_is_known() -> None:
    """A constant force accelerates the object and its line: b (T_ij + T_ji)/2 on top of the mass."""
    impedance = 20.0
    run = simulate(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 4.0},
            synchronisation={"mode": "constant", "law": {"kind": "wave", "impedance": impedance}, "damping": 0.0},
            hands=[{"user": 1, "kind": "force", "path": 1.0}],
        )
    )
    velocity = run["velocity"].values[:, :, 0, 0].mean(axis=0)
    acceleration = np.polyfit(run["time"].values[0, 2000:], velocity[2000:], 1)[0]
    assert 1.0 / acceleration - 1.0 == pytest.approx(impedance * DELAY, rel=0.05)


def test_a_wave_line_at_rest_is_a_spring_of_impedance_over_delay() -> None:
    """Users who pull apart: the line stretches as a spring between them."""
    impedance = 2.0
    run = simulate(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 40.0},
            synchronisation={"mode": "constant", "law": {"kind": "wave", "impedance": impedance}, "damping": 1.0},
            hands=[{"user": 1, "kind": "force", "path": 1.0}, {"user": 2, "kind": "force", "path": -1.0}],
        )
    )
    apart = float(run["position"].values[0, -1, 0, 0] - run["position"].values[1, -1, 0, 0])
    assert apart == pytest.approx(DELAY / impedance, rel=1e-3)


def test_a_filter_makes_a_wave_line_longer_and_the_default_impedance_stiffer() -> None:
    """A line at rest is a spring of b over what it lags one way, and b by default makes that K."""
    b, filtered, period = 2.0, 0.03, 0.001
    run = simulate(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 20.0, "period": period},
            synchronisation={
                "mode": "constant",
                "law": {"kind": "wave", "impedance": b, "filter": filtered},
                "damping": 1.0,
            },
            hands=[{"user": 1, "kind": "force", "path": 1.0}, {"user": 2, "kind": "force", "path": -1.0}],
        )
    )
    facts = Facts(spring=SPRING, age=DELAY, age_back=DELAY, period=period, spread=0.05)
    apart = float(run["position"].values[0, -1, 0, 0] - run["position"].values[1, -1, 0, 0])
    assert apart == pytest.approx(facts.lag(filtered) / b, rel=1e-3)
    impedance, default, *_ = laws()["wave"].values(facts, {})
    assert (impedance / facts.lag(default), default) == (pytest.approx(SPRING), 0.03)


UNEVEN = {"jitter": {"kind": "uniform", "scale": 0.02}, "loss": 0.05}


@pytest.mark.parametrize("rate", [200, 1000])
def test_a_wave_line_has_no_drag_where_samples_come_unevenly(rate: int) -> None:
    """Energy is taken as evenly as waves are; taken as it came, the drag was 1.3 Ns/m, and copies 118 mm apart."""
    run = simulate(
        Scenario.make(
            network=two(0.015, SPRING),
            channel=UNEVEN,
            steps={"rate": rate, "duration": 8.0},
            seed=1,
            synchronisation={"law": "wave"},
            hands=[{"user": 1, "stiffness": 300, "damping": 6.5, "path": [[0.0, 0.0], [8.0, 0.4]]}],
        )
    )
    assert float(run["force"].values[0, 2 * rate :, 0].mean()) / 0.05 == pytest.approx(2 * 0.5, rel=0.03)
    assert float(abs(run["position"].values[0] - run["position"].values[1]).max()) < 0.01
    assert run.attrs["made"] == 0.0


@pytest.mark.parametrize("rate", [200, 1000])
@pytest.mark.parametrize("where", ["evenly", "unevenly"])
def test_a_hand_that_moves_what_nobody_else_holds_feels_no_drag_of_paid(rate: int, where: str) -> None:
    """The free copy comes behind by a share of the age; drawn together without that, 0.11 Ns/m were felt.

    The line beside it took energy as it came, lost the place and pushed the hand on: -0.13 Ns/m.
    """
    run = simulate(
        Scenario.make(
            network=two(0.015 if where == "unevenly" else 0.0225, SPRING),
            channel=UNEVEN if where == "unevenly" else {},
            steps={"rate": rate, "duration": 8.0},
            body={"damping": 1.0},
            seed=1,
            synchronisation={"law": "paid"},
            hands=[{"user": 1, "stiffness": 300, "damping": 6.5, "path": [[0.0, 0.0], [8.0, 0.4]]}],
        )
    )
    assert float(run["force"].values[0, 2 * rate :, 0].mean()) / 0.05 == pytest.approx(1.0, abs=0.04)


@pytest.mark.parametrize("seed", [1, 2])
def test_a_wave_line_held_apart_is_a_spring_where_samples_come_unevenly(seed: int) -> None:
    """It gave way by up to 20 mm/s for each N."""
    run = simulate(
        Scenario.make(
            network=two(0.015, SPRING),
            channel=UNEVEN,
            steps={"rate": 200, "duration": 16.0},
            seed=seed,
            synchronisation={"law": "wave"},
            hands=[{"user": 1, "kind": "force", "path": 5.0}, {"user": 2, "kind": "force", "path": -5.0}],
        )
    )
    apart = run["position"].values[0, :, 0, 0] - run["position"].values[1, :, 0, 0]
    assert apart[1600:].mean() == pytest.approx(5.0 / SPRING, rel=0.1)
    assert abs(apart[2400:].mean() - apart[1600:2400].mean()) < 1e-3 * 4.0


def test_a_wave_line_at_constant_delay_keeps_energy_exactly() -> None:
    """What left the copies is on the lines: no line makes or loses any."""
    prepared = prepare(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 5.0},
            synchronisation={"mode": "constant", "law": "wave", "damping": 0.0},
            initial={"velocity": [0.4, -0.1]},
        )
    )
    outcome = run_batch(prepared)
    assert outcome.ends is not None
    into, out = outcome.ends.scalars[:, 0], outcome.ends.scalars[:, 1]
    line = float((out - into).sum())
    stored, initial = outcome.record.ticks[0, -1], outcome.record.ticks[0, 0]
    assert line > 1e-4
    assert outcome.record.made[1] == pytest.approx(-line, abs=1e-12)
    assert stored + line == pytest.approx(initial, rel=1e-12)
    # What is on a line is what was sent in the last delay, no more: nothing is lost on the way.
    assert prepared.schedule.index_delay is not None


def stiff(law: Any, *, delay: float, hand: float = 300.0, **options: Any) -> dict[str, Any]:
    """Two stiff hands that pull apart."""
    run = simulate(
        Scenario.make(
            network=two(delay, SPRING),
            steps={"duration": 4.0},
            synchronisation={"law": law, **options},
            hands=[
                {"user": 1, "stiffness": hand, "path": 0.05, "begin": 0.1},
                {"user": 2, "stiffness": hand, "path": -0.05},
            ],
        )
    )
    return {**judge(run), "finished": run.attrs["finished"]}


@pytest.mark.parametrize("law", ["spring", {"kind": "pd", "damping": 1.0}])
def test_springs_without_their_damping_are_caught_as_active(law: Any) -> None:
    judged = stiff(law, delay=0.1, damping=0.0)
    assert judged["made_j"] > 0.1
    assert not judged["kept"]
    assert not judged["promised"]


@pytest.mark.parametrize("law", ["spring", *PASSIVE])
def test_passive_laws_keep_their_promise_with_stiff_hands(law: str) -> None:
    judged = stiff(law, delay=0.1, hand=3000.0)
    assert judged["finished"]
    assert judged["promised"]
    assert judged["kept"], judged


def test_no_random_scenario_makes_a_passive_law_give_more_than_its_seed() -> None:
    """`python -m benchmarks.promises` does so in ten thousand."""
    for number in range(20):
        prepared = prepare(trial(number))
        for law in ["spring", *PASSIVE, {"kind": "pspm", "damping": 0.0, "initial_energy": 0.001}]:
            found = made_energy(with_law(prepared, law))
            assert found.kept, (number, law, found)
            assert found.residual <= 1e-11 * found.play, (number, law)


def test_a_run_with_another_law_is_that_of_the_whole_preparation() -> None:
    given = {"kind": "wave", "impedance": "2x"}
    assert made_energy(with_law(prepare(trial(1)), given)) == made_energy(prepare(trial(1, given)))


def _leaking(end: End) -> None:
    """`tank` that books half of what it gives."""
    tank, power = end.scalars, given_power(end)
    tank[0] -= end.T * (0.5 * power if power > 0.0 else power)
    more = max(tank[0] - end.parameters[0], 0.0)
    tank[0] -= more
    tank[1] += more
    copy(end.sent[0], end.mean)
    end.sent_scalars[0] = tank[1]


@pytest.mark.parametrize("broken", [False, True])
def test_a_law_that_leaks_a_little_is_found_at_random_and_by_a_search(broken: bool) -> None:
    register(replace(TANK, name="leaking tank", _parts=[], **({"after": _leaking} if broken else {})))
    kept = [made_energy(prepare(trial(number, "leaking tank"))).kept for number in range(10, 19)]
    assert all(kept) is not broken
    assert searched("leaking tank", 40).kept is not broken


@pytest.mark.parametrize(("damping", "least"), [(0.0, 1.0), (0.25, 0.5), (0.5, 0.163), (1.0, 0.063), (2.0, 0.028)])
def test_once_needs_the_share_of_the_rule_that_is_known(damping: float, least: float) -> None:
    """Exact for two users at constant delay: no tone gives energy to any pair of hands from this share on."""
    angle = np.linspace(1e-4, 60.0, 200_001)
    there = np.exp(-1j * angle)
    for at in (0, angle.size // 2, angle.size - 1):  # the law's own words, at a few tones
        tone = Tone(s=1j * angle[at], spring=1.0, parameters=[damping], there=complex(there[at]), back=1.0 + 0j)
        assert law_of("once").linear is not None
        mine, theirs = law_of("once").linear(tone)  # pyright: ignore[reportOptionalCall]
        assert mine == pytest.approx(1.0 / (1j * angle[at]) + damping)
        assert theirs == pytest.approx(mine * there[at])
    own = 1.0 / (1j * angle) + damping
    needed = max(float(-(own * (1.0 + sign * there)).real.min()) for sign in (-1, 1))
    assert needed == pytest.approx(least, abs=6e-4)


def test_once_has_by_default_the_share_that_it_needs() -> None:
    facts = Facts(spring=50.0, age=0.03, age_back=0.02)
    assert law_of("once").values(facts, {}) == [0.5 * 50.0 * 0.025]
    assert law_of("once").rule == pytest.approx(0.163, abs=5e-4)


@pytest.mark.parametrize(("damping", "promised"), [("0.1x", False), ("1x", True), ("3x", True)])
def test_once_with_a_weaker_damper_promises_nothing(damping: str, promised: bool) -> None:
    """A tuner found 0.7 J with a tenth of the damper: what is left over no longer pays for the spring."""
    judged = stiff({"kind": "once", "damping": damping}, delay=0.1)
    assert judged["promised"] is promised
    assert judged["kept"] or not promised


def _again(end: End) -> None:
    """`once` that uses a velocity as often as it likes."""
    copy(end.target, end.sample)
    for i in range(end.push.shape[0]):
        end.push[i] = end.parameters[0] * end.received[0, i]
    end.gains[0], end.gains[1] = end.spring, end.parameters[0]


@pytest.mark.parametrize("twice", [False, True])
def test_a_velocity_that_is_used_twice_is_caught(twice: bool, tmp_path: Path) -> None:
    """The damper of `once` alone, without local damping: a quick move, and then nothing arrives for three seconds."""
    law = replace(law_of("once"), name="damper", rule=0.0, springs=False, _parts=[])
    register(replace(law, before=_again) if twice else law)
    (tmp_path / "outage.csv").write_text("sent_s,latency_s\n0,0.01\n0.5,0.01\n0.501,3\n3,3\n", encoding="utf-8")
    trace = {"file": str(tmp_path / "outage.csv"), "column": "latency_s", "time": "sent_s", "as": "one-way"}
    run = simulate(
        Scenario.make(
            network=two(0.0, 1e-9),
            steps={"duration": 3.0},
            synchronisation={"law": {"kind": "damper", "damping": 5.0}},
            channel={"trace": trace | {"loop": False}},
            hands=[
                {"user": 1, "stiffness": 3000, "damping": 20, "path": [[0.45, 0.0], [0.55, 0.2], [0.6, 0.2]]},
                {"user": 2, "stiffness": 0, "damping": 5},
            ],
        )
    )
    judged = judge(run)
    assert judged["promised"]
    assert judged["kept"] is not twice
    assert (judged["made_j"] > 1.0) is twice


def test_a_wave_line_is_a_spring_in_series_with_the_hands() -> None:
    """Both hold; what one feels is its own line's stiffness in series with the other's hand."""
    found = impedance(
        Scenario.make(
            network=two(DELAY, SPRING),
            synchronisation={"mode": "constant", "law": {"kind": "wave", "impedance": 2.0}, "damping": 0.0},
            hands=[{"user": 2, "stiffness": 300.0}],
        ),
        1,
        others="holding",
        measured=False,
        frequencies=[0.02, 0.04],
    )
    assert found.attrs["predicted_stiffness"] == pytest.approx(1.0 / (DELAY / 2.0 + 1.0 / 300.0), rel=0.01)


@pytest.mark.parametrize("law", ["spring", *PASSIVE])
def test_searched_users_get_nothing_beyond_the_seed(law: str) -> None:
    """`python -m benchmarks.promises` searches two thousand times."""
    found = searched(law, 25)
    assert found.kept, found


def test_searched_users_find_what_an_active_law_makes() -> None:
    found = searched("spring", 40, damping=0.0)
    assert not found.kept
    assert found.beyond > 1e-3


def test_to_paid_a_hand_whose_aim_moves_is_one_hand() -> None:
    """Two that sway together: x follows the aim and says little of a hand, but it does not change all the time."""
    prepared = prepare(
        Scenario.make(
            network=two(DELAY, SPRING),
            steps={"duration": 3.0},
            synchronisation={"law": "paid"},
            hands=[
                {
                    "user": i + 1,
                    "stiffness": 300.0,
                    "damping": 6.5,
                    "amplitude": 0.08,
                    "frequency": 0.6,
                    "phase": -0.1 * i,
                }
                for i in range(2)
            ],
        )
    )
    ends = run_batch(prepared).ends
    assert ends is not None
    names = PAID.shares_scalars
    assert np.all(ends.shared_scalars[:, names.index("epoch")] < 60.0)


def test_paid_believes_its_guesses_of_hands_as_far_as_they_came_true() -> None:
    """Over a long way, the own hand tells more than a guess where two move an object together, and less in a tug."""
    assert cost("paid", "both", delay=0.2) < 2.5  # 4.4, when all was believed
    assert cost("paid", "both", delay=0.1, graph="star", users=[4]) < 2.0  # 2.9
    assert cost("paid", "tug", delay=0.1) < 4.5


def test_paid_brakes_what_is_fast_and_not_heard_of_yet() -> None:
    """Two that pull apart with stiff hands: copies that had jumped to their own hands had nothing to come back with."""
    stiff_hands: dict[str, Any] = {"delay": 0.15, "hands": [{"stiffness": 1800.0, "damping": 6.5}]}
    calm, not_calm = cost("paid", "tug", **stiff_hands), cost({"kind": "paid", "calm": 0.0}, "tug", **stiff_hands)
    assert calm < 0.75 * not_calm  # 1.8 for 3.1
    carried, before = cost("paid", "carry", **stiff_hands), cost({"kind": "paid", "calm": 0.0}, "carry", **stiff_hands)
    assert carried == before  # what is slow is not braked


CHAIN = {"kind": "chain", "nodes": 5, "mass": 0.2, "stiffness": 400.0, "damping": 1.0}


@pytest.mark.parametrize(
    ("users", "stiffness", "delay", "tables"),
    [
        (2, 1800.0, 0.1, {}),
        (4, 3000.0, 0.02, {"period": 4e-3}),
        (4, 1800.0, 0.05, {"graph": "star"}),
        (4, 1800.0, 0.1, {"body": CHAIN}),
    ],
)
def test_paid_comes_to_rest_where_stiff_hands_hold_still_apart(
    users: int, stiffness: float, delay: float, tables: dict[str, Any]
) -> None:
    """Empty accounts made copies recoil, and what that yielded drove them on: 8 to 90 mm/s for good."""
    tables = {"users": [users], "hands": [{"stiffness": stiffness, "damping": 6.5}], **tables}
    shivers = {"kind": "paid", "still": 0.0}
    moving, before = (cost(law, "hold", delay=delay, measure="restless", **tables) for law in ("paid", shivers))
    assert moving < 1e-3
    assert before > 5e-3
    near, far = (cost(law, "hold", delay=delay, measure="apart", **tables) for law in ("paid", shivers))
    assert near < 1.2 * far


def test_paid_lets_go_of_what_it_held_where_hands_give_way() -> None:
    """Copies that rest with empty accounts follow a hand that no longer presses."""
    assert cost("paid", "press", delay=0.1, users=[4]) < 0.8  # 1.2, when what was exerted went on
    assert cost("paid", "press", delay=0.1, body=CHAIN, seed=77) < 1.9  # 2.4


def test_paid_brakes_what_is_fast_right_after_a_grasp_and_not_later() -> None:
    """Whenever hands grasp; who has held for a while moves as freely as ever."""

    def fastest(calm: float, begin: float) -> float:
        scenario = Scenario.make(
            network=two(0.1, SPRING),
            steps={"duration": 1.6},
            synchronisation={"law": {"kind": "paid", "calm": calm}},
            hands=[
                {
                    "user": 1,
                    "stiffness": 1800.0,
                    "damping": 6.5,
                    "path": [[0.5, 0.0], [0.9, 0.01], [1.4, 0.4]],
                    "begin": begin,
                },
            ],
        )
        return float(np.abs(simulate(scenario)["velocity"].values[0, :, 0, 0]).max())

    assert fastest(80.0, 1.2) < 0.8 * fastest(0.0, 1.2)  # grasps what it is far from
    assert fastest(80.0, 0.5) == fastest(0.0, 0.5)  # moves it as far, a while after it grasped


def test_what_a_hand_of_paid_did_is_nothing_after_it_died_away() -> None:
    """Else numbers shrink for ever, until the processor is slow with them, and no node rests."""

    def kept(duration: float) -> dict[str, float]:
        run = run_batch(
            prepare(
                Scenario.make(
                    network=two(DELAY, SPRING),
                    steps={"duration": duration},
                    synchronisation={"law": "paid"},
                    hands=[
                        {"user": i + 1, "stiffness": 300.0, "damping": 6.5, "path": 0.05 * (-1) ** i, "release": 1.0}
                        for i in range(2)
                    ],
                )
            )
        ).ends
        assert run is not None
        fields = {name: PAID.keeps.index(name) for name in ("alive", "A", "A2", "slope", "P", "Q")}
        return {name: float(np.abs(run.memory[:, at]).max()) for name, at in fields.items()}

    held = kept(0.5)
    assert held["alive"] == 1.0
    assert held["A"] > 1.0
    late = kept(1.2)  # it dies away, and is far from nothing
    assert late["alive"] == 1.0
    assert 0.0 < late["A"] < 1e-3
    assert set(kept(2.0).values()) == {0.0}


def test_to_paid_a_hand_is_where_it_holds() -> None:
    """On a chain, too: hands hold its ends."""
    body: dict[str, Any] = {"kind": "chain", "nodes": 5, "mass": 0.2, "stiffness": 400.0, "damping": 1.0}
    assert cost("paid", "handover", body=body) < 0.5
    assert cost("wave", "handover", body=body) > 2.0


def test_paid_moves_a_soft_body_that_only_another_user_holds() -> None:
    """Braked at every node and moved at one, such a copy stretched and stayed behind: J 6.4."""
    body: dict[str, Any] = {"kind": "chain", "nodes": 5, "mass": 0.2, "stiffness": 400.0, "damping": 1.0}
    assert cost("paid", "handover", delay=0.1, body=body) < 3.0


def test_in_a_star_paid_feels_hands_that_are_two_links_away() -> None:
    star: dict[str, Any] = {"graph": "star", "users": [4]}
    alone = cost({"kind": "paid", "relay": 0.0}, "tug", **star)
    assert cost("paid", "tug", **star) < 0.6 * alone


def test_paid_relays_in_trees_only() -> None:
    def relays(graph: str, users: int) -> bool:
        whole = Study.make(laws=["paid"], networks=[{"name": "there", "delay": DELAY}], graph=graph)
        found = prepare(whole.scenario(whole.laws[0], whole.networks[0], users, [])).law
        assert found is not None
        return bool(found.parameters[:, [p.name for p in PAID.parameters].index("relay")].any())

    assert [relays("star", 4), relays("path", 5), relays("ring", 4), relays("complete", 3)] == [
        True,
        True,
        False,
        False,
    ]
    assert not relays("complete", 2)


@pytest.mark.parametrize(("delay", "told"), [(0.05, 2.0), (0.4, 1.5)])
def test_paid_tells_less_of_other_hands_the_older_they_are(delay: float, told: float) -> None:
    whole = Study.make(laws=["paid"], networks=[{"name": "there", "delay": delay}], graph="path")
    ends = run_batch(prepare(whole.scenario(whole.laws[0], whole.networks[0], 3, [], duration=2.0))).ends
    assert ends is not None
    hands = ends.mail_scalars[..., PAID.sends_scalars.index("hands")]
    assert hands.max() == pytest.approx(told, abs=0.01)  # of the one in the middle; others know of none but theirs


def test_the_wave_line_of_paid_is_the_same_at_both_ends_of_a_star() -> None:
    """Else copies at rest would agree on places of another scale each."""
    hub, leaf = (Facts(spring=50.0, age=0.02, age_back=0.02, degree=n, degree_back=m) for n, m in ((3, 1), (1, 3)))
    at = [parameter.name for parameter in PAID.parameters].index("line")
    assert PAID.values(hub, {})[at] == PAID.values(leaf, {})[at]


BLOCK: dict[str, Any] = {
    "kind": "lattice",
    "shape": [4, 3, 3],
    "mass": 0.3,
    "stiffness": 4000.0,
    "damping": 4.0,
    "spacing": 0.02,
}
# Without it a block has no weight and does not turn, by the engine of every other body that tools touch.
FLOOR: dict[str, Any] = {
    "body": {"frame": "floating"},
    "world": {"gravity": [0.0, 0.0, -9.81], "planes": [{"stiffness": 1e6, "damping": 1.0, "friction": 0.5}]},
}


def _finger(user: int, side: float) -> dict[str, Any]:
    """That presses the block from the left, -1, or the right, 1, and lifts it then."""
    inside = -0.015 * side
    path = [[0, 0, 0, 0], [0.2, inside, 0, 0], [0.6, inside, 0, 0.03], [1.0, inside, 0, 0.03]]
    at = [0.03 + 0.043 * side, 0.02, 0.02]
    more = {"radius": 0.012, "mass": 0.05, "stiffness": 2000.0, "damping": 1.0, "friction": 0.9}
    return {"user": user, "at": at, **more, "hand": {"stiffness": 600.0, "damping": 12.0, "path": path}}


def _swing(scenario: Scenario) -> float:
    """Peak to peak of the sum of what two tools feel who hold an object still between them, in the last fifth [N]."""
    run = simulate(scenario)
    assert run.attrs["made"] <= run.attrs["law_initial_energy"]
    force = run["touch_force"].values.sum(axis=0)
    assert np.abs(run["touch_force"].values[:, -1, 0]).min() > 2.0
    return float(np.ptp(force[-force.shape[0] // 5 :], axis=0).max())


def _squeezed(duration: float) -> dict[str, Any]:
    """Tables of the example: two devices press a block from both sides and hold still."""
    tables = tomllib.loads((EXAMPLES / "squeeze.toml").read_text(encoding="utf-8"))
    tables["synchronisation"] = {"law": "paid"}
    tables["steps"]["duration"] = duration
    for tool in tables["tools"]:
        tool["hand"]["path"] = tool["hand"]["path"][:2]
    return tables


def test_paid_lets_a_squeezed_block_rest() -> None:
    """With half the damping of its material it swung at 35 Hz, by 0.5 N: late forces pushed on what swings."""
    tables = _squeezed(2.0)
    tables["body"]["damping"] = 0.5
    assert _swing(Scenario.make(**tables)) < 0.02


def test_paid_keeps_copies_together_that_are_squeezed_over_a_long_way() -> None:
    """At 40 ms each finger pushed its own copy 13 mm away before it heard of the other, and it stayed there."""
    tables = _squeezed(0.6)
    tables["network"]["delay"] = two(0.04)["delay"]
    run = simulate(Scenario.make(**tables))
    assert float(np.abs(run["touch_force"].values[:, -1, 0]).min()) > 1.0
    middle = run["position"].values[:, -1].mean(axis=1)
    assert float(np.linalg.norm(middle[0] - middle[1])) < 3e-3


def test_paid_lets_another_block_rest_over_a_longer_way() -> None:
    """On which nothing was tuned: it swung by 0.4 N."""
    tools = [_finger(1, -1.0), _finger(2, 1.0)]
    for tool in tools:
        tool["hand"]["path"] = tool["hand"]["path"][:2]
    scenario = Scenario.make(
        network=two(0.012, 10.0),
        body={**BLOCK, **FLOOR["body"], "damping": 1.0},
        world=FLOOR["world"],
        contact={"law": "stiffening"},
        steps={"duration": 1.2, "period": 1e-3},
        synchronisation={"law": "paid"},
        tools=tools,
    )
    assert _swing(scenario) < 0.03


def test_paid_lets_light_nodes_rest_that_hands_hold() -> None:
    """A damper of 2 Ns/m stops half a gram four times over in a step. Felt elsewhere as late as that, it made corners
    swing at metres a second, and hands felt anything but the weight.
    """
    body = {"kind": "lattice", "shape": [4, 4, 2], "neighbours": 6, "mass": 0.016, "stiffness": 500.0, "damping": 0.5}
    hand = {"stiffness": 200.0, "damping": 2.0, "path": [0.0, 0.0, 0.0]}
    run = simulate(
        Scenario.make(
            network=two(0.02, 20.0),
            body={**body, "spacing": 0.02},
            steps={"duration": 1.5, "period": 1e-3},
            synchronisation={"law": "paid"},
            hands=[
                *({**hand, "user": 1 + n // 2, "node": node} for n, node in enumerate((1, 7, 25, 31))),
                {"user": 1, "node": 12, "kind": "force", "path": [[0.0, 0.0, 0.0, 0.0], [0.2, 0.0, 0.0, -0.1]]},
            ],
            record={"nodes": "all"},
        )
    )
    held = run["hand_force"].values[:4, -200:, 2].sum(axis=0)
    np.testing.assert_allclose(held, 0.1, atol=1e-3)
    assert float(np.abs(run["velocity"].values[:, -200:]).max()) < 1e-3


def _lifted(law: str, users: int, where: dict[str, Any]) -> Any:
    """How far the middles of all copies of a block move that two fingers press and lift, one each of two users, or both
    of one.
    """
    scenario = Scenario.make(
        network=two(0.005, 10.0) if users == 2 else {"users": ["all"], "spring": [[0.0]], "delay": [[0.0]]},
        body={**BLOCK, **where.get("body", {})},
        world=where.get("world", {}),
        contact={"law": "stiffening"},
        steps={"duration": 1.0, "period": 1e-3},
        synchronisation={"law": law},
        tools=[_finger(1, -1.0), _finger(users, 1.0)],
    )
    run = simulate(scenario)
    assert law != "paid" or run.attrs["made"] <= run.attrs["law_initial_energy"]
    assert float(abs(run["residual"]).max()) < 1e-9
    middle = run["position"].values.mean(axis=2)
    return middle - middle[:, :1]


@pytest.mark.parametrize(
    ("where", "most", "least"), [({}, 5e-4, 1.5e-3), (FLOOR, 2e-4, 5e-4)], ids=["weightless", "floor"]
)
def test_to_paid_fingers_that_lift_a_block_between_them_are_felt_by_both(
    where: dict[str, Any], most: float, least: float
) -> None:
    """Each copy is held by one finger of its own; what the other one does, and how stiffly, only messages say."""
    ideal = _lifted("paid", 1, where)[0]
    assert ideal[-1, 2] > 0.02
    off = {law: float(np.abs(_lifted(law, 2, where) - ideal).mean()) for law in ("paid", AS_LAW.name)}
    assert off["paid"] < most < least < off[AS_LAW.name]


def test_what_paid_may_make_is_a_copys_whatever_its_body() -> None:
    at = [parameter.name for parameter in PAID.parameters].index("initial_energy")
    seeds = [PAID.values(Facts(spring=1.0, age=0.02, age_back=0.02, degree=2, rows=rows), {})[at] for rows in (1, 400)]
    assert seeds == [0.01, 0.01]


@pytest.mark.parametrize("number", [1, 3, 9, 75, 70092])
def test_paid_makes_no_more_than_its_seed_where_tools_touch(number: int) -> None:
    """On a floor, the first two, and held without weight; `python -m benchmarks.promises` does so in a thousand."""
    run = simulate(touching(number))
    made = run.attrs
    assert float(np.nanmax(np.abs(run["touch_force"].values))) > 0.1
    assert made["finished"]
    assert 0.0 < made["made"] <= made["law_initial_energy"]
    assert float(abs(run["residual"]).max()) < 1e-11 * float(abs(run["supplied_total"]).max())


def test_paid_knows_where_what_swings_was_between_what_it_kept() -> None:
    """At 35 Hz and 4 ms a straight line would be 9 % too low, which pushes on what swings."""
    omega, times = 2.0 * np.pi * 35.0, 0.1 + EVERY * np.arange(KEPT)
    shared = np.zeros((PAST + 2 * KEPT, 1))
    shared[PAST : PAST + KEPT, 0], shared[PAST + KEPT :, 0] = np.sin(omega * times), omega * np.cos(omega * times)
    numbers = np.zeros(TIMES + KEPT)
    numbers[COUNT], numbers[TIME], numbers[TIMES:] = KEPT, times[-1] + 0.5 * EVERY, times
    numbers[NEWEST], shared[X], shared[V] = times[-1], shared[PAST + KEPT - 1], shared[PAST + 2 * KEPT - 1]
    end: Any = SimpleNamespace(T=1.1 * EVERY, shared=shared, shared_scalars=numbers)
    for late in (0.0, 1e-4, EVERY):  # after the newest it goes on straight, whatever the length of the coming step
        x, v = place_then.py_func(end, between.py_func(*past.py_func(end, times[-1] + late)), 0)  # pyright: ignore[reportFunctionMemberAccess]
        assert (x, v) == pytest.approx((shared[X, 0] + late * shared[V, 0], shared[V, 0]))
    for when in (times[0] + 0.0017 * step for step in range(295)):
        x, v = place_then.py_func(end, between.py_func(*past.py_func(end, when)), 0)  # pyright: ignore[reportFunctionMemberAccess]
        assert x == pytest.approx(np.sin(omega * when), abs=0.005)
        assert v == pytest.approx(omega * np.cos(omega * when), abs=0.03 * omega)


@pytest.mark.parametrize("begun", [0.15, 0.222])
def test_paid_knows_what_another_hand_did_to_its_copy_since_it_let_go(begun: float) -> None:
    """A force that rises evenly, on a copy that moves evenly: A and A2 in closed form."""
    speed, rise, k, damping, now = 0.3, 40.0, 200.0, 5.0, 0.3
    times, own = EVERY * np.arange(int(now / EVERY)), np.zeros((PAST + 2 * KEPT, 1))
    numbers, memory, told = np.zeros(TIMES + KEPT), np.zeros((LOG + LOGGED, 1)), np.zeros(M_AGE + 1)
    numbers[COUNT], numbers[TIME], numbers[TIMES : TIMES + times.size] = times.size, now, times
    own[PAST : PAST + times.size, 0] = speed * times
    memory[LOG : LOG + times[::EACH].size, 0], memory[DONE, 0] = 0.5 * rise * times[::EACH] ** 2, 0.5 * rise * now**2
    told[M_K], told[M_B] = k, damping
    end: Any = SimpleNamespace(
        position=np.full(1, speed * now), memory=memory, shared=own, shared_scalars=numbers, received_scalars=told
    )
    assert take_over.py_func(end, begun)  # pyright: ignore[reportFunctionMemberAccess]
    a = np.polyint([rise + k * speed, damping * speed])
    a = np.polysub(a, [np.polyval(a, begun)])
    assert memory[A, 0] == pytest.approx(np.polyval(a, now), rel=1e-3)
    aa = np.polyint(a)
    assert memory[A2, 0] == pytest.approx(np.polyval(aa, now) - np.polyval(aa, begun), rel=5e-3)


@pytest.mark.parametrize("users", [2, 4])
def test_what_all_let_go_of_goes_on_as_it_moved(users: int) -> None:
    """It went on by what hands were held to do for as long as nobody had heard that they let go."""
    near = 0.02
    hands = [
        {
            "user": i + 1,
            "stiffness": 300,
            "damping": 6.5,
            "amplitude": 0.08,
            "frequency": 0.6,
            "phase": 0.3,
            "release": 1.0,
        }
        for i in range(users)
    ]

    def ends(count: int, law: str) -> Any:
        """Places and speeds at the end."""
        links = [[50.0 * (i != j) for j in range(count)] for i in range(count)]
        run = simulate(
            Scenario.make(
                network={
                    "users": [str(i) for i in range(count)],
                    "spring": links,
                    "delay": [[near * (spring > 0.0) for spring in row] for row in links],
                },
                steps={"duration": 2.0},
                synchronisation={"law": law},
                hands=[hand if count > 1 else {**hand, "user": 1} for hand in hands],
            )
        )
        return run["position"].values[:, -1, 0, 0], run["velocity"].values[:, -1, 0, 0]

    place, speed = ends(1, "spring")
    places, speeds = ends(users, "paid")
    assert speeds == pytest.approx(speed[0], abs=5e-3)
    assert places == pytest.approx(place[0], abs=5e-3)
