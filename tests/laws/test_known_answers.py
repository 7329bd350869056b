"""What is known of each law: drag, mass, stiffness, exact accounts, and which ones make energy."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import PASSIVE, law_of, two

from cotouch.laboratory import impedance
from cotouch.laws import PAID, End, Facts, Tone, copy, register
from cotouch.scenario import Scenario
from cotouch.simulation import judge, prepare, simulate
from cotouch.simulation._batch import run_batch

DELAY, SPRING = 0.025, 50.0


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


def random_scenario(law: Any, number: int) -> Scenario:
    """Anything: users, springs, delays, rates, losses, hands, soft and stiff."""
    rng = np.random.default_rng((number, 18))
    users = int(rng.integers(2, 5))
    spring, delay = np.zeros((users, users)), np.zeros((users, users))
    for a in range(users):
        for b in range(a):
            spring[a, b] = spring[b, a] = rng.choice([0.0, 20.0, 100.0]) if b else 50.0
            delay[a, b], delay[b, a] = rng.uniform(0.0, 0.15, size=2)
    return Scenario.make(
        network={"users": [str(i) for i in range(users)], "spring": spring.tolist(), "delay": delay.tolist()},
        body={"mass": float(10 ** rng.uniform(-1, 1)), "stiffness": float(rng.choice([0.0, 30.0]))},
        steps={"duration": 3.0, "random": {"low": 0.001, "high": float(rng.choice([0.001, 0.005, 0.03]))}},
        synchronisation={"law": law},
        channel={
            "jitter": {"kind": "exponential", "scale": float(rng.choice([0.0, 0.01, 0.05]))},
            "loss": float(rng.choice([0.0, 0.1, 0.7])),
            "burst": {"enter": float(rng.choice([0.0, 0.01])), "leave": 0.05},
            "duplication": 0.2,
            "reordering": 0.2,
            "reordering_delay": 0.04,
        },
        hands=[
            {
                "user": i + 1,
                "stiffness": float(10 ** rng.uniform(1, 3.5)),
                "damping": float(rng.choice([0.0, 3.0])),
                "path": float(rng.uniform(-0.1, 0.1)),
                "amplitude": float(rng.choice([0.0, 0.05])),
                "frequency": float(10 ** rng.uniform(-0.5, 1.0)),
                "begin": float(rng.uniform(0.0, 1.0)),
                "release": float(rng.uniform(1.5, 3.0)),
            }
            for i in range(users)
        ],
        initial={"position": rng.uniform(-0.05, 0.05, users).tolist(), "velocity": rng.normal(size=users).tolist()},
        seed=number,
    )


@pytest.mark.parametrize("law", ["spring", *PASSIVE, {"kind": "pspm", "damping": 0.0, "seed": 0.001}])
def test_no_random_scenario_makes_a_passive_law_give_more_than_its_seed(law: Any) -> None:
    for number in range(30):
        prepared = prepare(random_scenario(law, number))
        record = run_batch(prepared).record
        seed = record.links[0].sum() if prepared.law is None else prepared.law.seed
        play = np.abs(record.ticks[:4]).max()
        assert record.made[0] <= seed + 1e-12 * play, (number, record.made, seed)
        assert np.abs(record.ticks[4]).max() <= 1e-11 * play, number


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


class Searched:
    """A user whose hand is searched for: how stiff, how damped, where it pulls to, when it lets go."""

    def __init__(self, law: Any, **options: Any) -> None:
        self.synchronisation = {"law": law, **options}

    def made(self, x: np.ndarray) -> float:
        """Energy that the links made beyond the law's seed [J]."""
        hands = [
            {
                "user": user + 1,
                "stiffness": float(10 ** (1.0 + 2.5 * a)),
                "damping": float(5.0 * b),
                "amplitude": float(0.1 * c),
                "frequency": float(10 ** (-0.5 + 1.5 * d)),
                "phase": float(2 * np.pi * e),
                "release": float(0.5 + 1.5 * f),
            }
            for user, (a, b, c, d, e, f) in enumerate(x[:12].reshape(2, 6))
        ]
        prepared = prepare(
            Scenario.make(
                network=two(0.01 + 0.14 * float(x[12])),
                steps={"duration": 2.0, "period": 0.002},
                synchronisation=self.synchronisation,
                channel={"jitter": {"kind": "exponential", "scale": 0.03 * float(x[13])}, "loss": 0.4 * float(x[13])},
                hands=hands,
            )
        )
        record = run_batch(prepared).record
        seed = record.links[0].sum() if prepared.law is None else prepared.law.seed
        return float(record.made[0] - seed)

    def best(self, evaluations: int) -> float:
        """The most that a search finds."""
        rng = np.random.default_rng(18)
        here = rng.random(14)
        most = self.made(here)
        for number in range(evaluations):
            width = 0.5 * 0.97**number + 0.02
            there = np.clip(here + width * rng.standard_normal(14), 0.0, 1.0)
            if (value := self.made(there)) > most:
                here, most = there, value
        return most


@pytest.mark.parametrize("law", ["spring", *PASSIVE])
def test_searched_users_get_nothing_beyond_the_seed(law: Any) -> None:
    assert Searched(law).best(40) <= 1e-12


def test_searched_users_find_what_an_active_law_makes() -> None:
    assert Searched("spring", damping=0.0).best(40) > 1e-3


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


def test_the_wave_line_of_paid_is_the_same_at_both_ends_of_a_star() -> None:
    """Else copies at rest would agree on places of another scale each."""
    hub, leaf = (Facts(spring=50.0, age=0.02, age_back=0.02, degree=n, degree_back=m) for n, m in ((3, 1), (1, 3)))
    at = [parameter.name for parameter in PAID.parameters].index("line")
    assert PAID.values(hub, {})[at] == PAID.values(leaf, {})[at]
