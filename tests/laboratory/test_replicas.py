"""Replicas that are no link law: what is known of each, and what their books say."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.laboratory.inside import (
    REPLICAS,
    HandKind,
    LawTable,
    Moved,
    NetworkTable,
    dangerous,
    drawn,
    replicate,
    score,
    tunable,
    tune,
)
from tests.laws.scenes import PASSIVE, law_of

from cotouch.errors import ScenarioError
from cotouch.laboratory import Study, ideal, measures_of
from cotouch.laws import register
from cotouch.simulation import prepare, run_batch, with_hands


def study(**tables: Any) -> Study:
    return Study.make(
        **{
            "laws": [{"replica": "rollback"}],
            "networks": [{"name": "near", "delay": 0.025}],
            "tasks": ["tug"],
            "draws": 2,
            "duration": 4.0,
            "tuning": {"search": 0, "local": 0},
            **tables,
        }
    )


def costs(name: str, delay: float, *, period: float = 1e-3, **tables: Any) -> dict[str, float]:
    whole = study(laws=[{"replica": name}], networks=[{"name": "there", "delay": delay}], period=period, **tables)
    hands = whole.task("tug", 2, whole.hands[0], 0)
    return measures_of(whole.laws[0], with_hands(drawn(whole, 0, {}), hands), ideal(whole, hands))


@pytest.mark.parametrize("name", ["rollback", "owner", "lockstep", "broadcast"])
def test_without_delay_and_with_ever_shorter_steps_replicas_are_the_ideal(name: str) -> None:
    coarse, fine = costs(name, 0.0), costs(name, 0.0, period=1e-4)
    assert fine["cost"] < 0.01
    assert fine["cost"] < 0.2 * coarse["cost"]
    assert fine["made"] < 0.2 * coarse["made"]


def test_rollback_is_near_the_ideal_until_it_is_dangerous() -> None:
    """What the prototype had: 0.01 at 25 ms, and no stable run with hands of 300 N/m at 100 ms."""
    whole, hand, rollback = study(), HandKind(), LawTable(replica="rollback")
    assert costs("rollback", 0.025)["cost"] < 0.1
    assert not dangerous(whole, rollback, whole.networks[0], 2, hand, {})
    assert dangerous(whole, rollback, NetworkTable(name="far", delay=0.1), 2, hand, {})


@pytest.mark.parametrize("stiffness", [100.0, 300.0])
def test_lockstep_is_unstable_beyond_the_delay_at_which_its_loop_crosses(stiffness: float) -> None:
    """One hand: M s² + (b s + k) e^(-sD) crosses the axis where atan(b ω/k) = ω D."""
    damping, whole, lockstep = 6.5, study(), LawTable(replica="lockstep")
    omega = np.sqrt(0.5 * (damping**2 + np.sqrt(damping**4 + 4.0 * stiffness**2)))
    crossing = np.arctan(damping * omega / stiffness) / omega
    held = [{"user": 1, "stiffness": stiffness, "damping": damping}]
    speeds: list[float] = []
    for factor in (0.9, 1.1):
        network = NetworkTable(name="there", delay=factor * crossing)
        scenario = whole.scenario(
            lockstep, network, 2, whole.placed(held, 2), duration=6.0, initial={"velocity": [0.1, 0.1]}
        )
        speed = np.abs(replicate(REPLICAS["lockstep"], prepare(scenario)).velocity[0, :, 0, 0])
        speeds.append(float(speed[4500:].max() / speed[:1500].max()))
    assert speeds[0] < 0.7
    assert speeds[1] > 1.5


def run_of(name: str, hands: list[dict[str, Any]], *, delay: float = 0.025, **tables: Any) -> Moved:
    whole = study(networks=[{"name": "there", "delay": delay}], **tables)
    scenario = whole.scenario(LawTable(replica=name), whole.networks[0], 2, whole.placed(hands, 2))
    return replicate(REPLICAS[name], prepare(scenario))


def test_a_server_makes_no_energy_and_an_owner_does() -> None:
    """A remote hand's force acts on the body later than on the hand, so the owner's body gets what nobody gave."""
    hands = [{"user": i + 1, "stiffness": 300.0, "damping": 6.5, "path": 0.05 * (-1) ** i} for i in range(2)]
    assert run_of("server", hands).made < 1e-12
    assert run_of("owner", hands, delay=0.005).made > 1e-3


def served(law: Any, hands: list[dict[str, Any]], *, delay: float = 0.2, loss: float = 0.0) -> Moved:
    """What a server with a law on its spokes does."""
    channel = {"loss": loss, "jitter": {"kind": "exponential", "scale": 0.1 * loss}}
    whole = study(
        laws=[{"replica": "server", "law": law}], networks=[{"name": "t", "delay": delay, "channel": channel}]
    )
    scenario = whole.scenario(whole.laws[0], whole.networks[0], 2, whole.placed(hands, 2))
    return replicate(REPLICAS["server"], prepare(scenario))


@pytest.mark.parametrize("law", ["spring", *PASSIVE])
def test_a_server_with_a_passive_law_on_its_spokes_makes_no_energy(law: str) -> None:
    hands = [{"user": i + 1, "stiffness": 1500.0, "path": 0.05 * (-1) ** i, "release": 3.0} for i in range(2)]
    run = served(law, hands, loss=0.1)
    assert run.finite
    assert run.made < 1e-12


def test_a_server_with_bare_springs_on_its_spokes_makes_energy() -> None:
    register(replace(law_of("spring"), name="bare", rule=0.0, passive=False, _parts=[]))
    hands = [{"user": i + 1, "stiffness": 300.0, "path": 0.05 * (-1) ** i} for i in range(2)]
    assert served("bare", hands).made > 0.1
    assert served("spring", hands).made < 1e-12


@pytest.mark.parametrize(
    ("law", "stiffness", "nearer"),
    [("spring", 50.0, 50.0), ({"kind": "wave", "impedance": 2.0, "initial_energy": 0.01}, 2.0 / 0.025, 2.0 / 1.5e-3)],
)
def test_two_who_pull_at_a_server_feel_its_spokes_one_after_the_other(
    law: Any, stiffness: float, nearer: float
) -> None:
    """The nearer spoke has nearly no delay, so a wave line there is nearly rigid."""
    hands = [{"user": i + 1, "kind": "force", "path": 0.1 * (-1) ** i} for i in range(2)]
    run = served(law, hands, delay=0.025)
    apart = float(run.place[0, -1, 0, 0] - run.place[1, -1, 0, 0])
    assert apart == pytest.approx(0.1 / stiffness + 0.1 / nearer, rel=0.05)


def test_a_servers_law_is_tuned_with_its_spokes() -> None:
    whole = study(laws=[{"replica": "server", "law": "wave"}, {"replica": "server"}, {"replica": "owner"}])
    assert [law.label for law in whole.laws] == ["server, wave", "server", "owner"]
    assert [tunable(law) for law in whole.laws] == [["spring", "impedance", "filter"], ["spring"], []]


def test_the_owner_alone_moves_the_body_as_if_there_were_nobody_else() -> None:
    """Its books close to round-off, and its motion is that of one copy in the batch engine."""
    whole = study()
    hands = [{"user": 1, "path": 0.1, "amplitude": 0.02, "frequency": 1.0, "release": 3.0}]
    run, wanted = run_of("owner", hands), ideal(whole, whole.placed(hands, 2))
    assert np.allclose(run.place[0], wanted.place, rtol=0.0, atol=1e-14)
    assert np.allclose(run.force, wanted.force, rtol=0.0, atol=1e-11)
    assert run.made < 1e-12
    # A moving wall, as old as the samples are; a message that arrives at an instant may count at it or at the next.
    step = np.abs(np.diff(run.place[0], axis=0)).max()
    assert np.abs(run.place[1, 100:] - run.place[0, 75:-25]).max() <= 1.01 * step


def test_what_overwrites_nothing_corrects_nothing() -> None:
    hands = [{"user": i + 1, "stiffness": 300.0, "path": 0.05 * (-1) ** i} for i in range(2)]
    assert run_of("rollback", hands).corrected > 1e-3
    assert {
        name: run_of(name, hands).corrected for name in ("server", "owner", "lockstep", "broadcast")
    } == dict.fromkeys(("server", "owner", "lockstep", "broadcast"), 0.0)


def test_replicas_take_part_in_a_study() -> None:
    whole = study(laws=[{"replica": "owner"}])
    part = whole.model_dump(mode="json")
    found = score({"study": part, "setting": {}})
    assert found["problem"] == ""
    assert found["dangerous"] == [True, True]
    tuned = tune({"study": {**part, "tuning": {"search": 4, "local": 4, "draws": 1, "safe": 1}}})
    assert tuned["tried"] == 1
    assert tuned["settings"] == {"published": {}, "tuned": None, "safe": None}


@pytest.mark.parametrize(
    ("tables", "words"),
    [
        ({"graph": "path"}, 'take graph "complete"'),
        ({"body": {"kind": "chain", "nodes": 3}}, "moves only a point"),
        ({"networks": [{"name": "c", "delay": 0.01, "mode": "constant"}]}, 'mode "freshest"'),
    ],
)
def test_what_replicas_cannot_do_is_one_sentence(tables: dict[str, Any], words: str) -> None:
    whole = study(users=[3], **tables)
    with pytest.raises(ScenarioError, match=words):
        replicate(REPLICAS["owner"], drawn(whole, 0, {}))


@pytest.mark.parametrize(
    ("law", "words"),
    [
        ({"replica": "oner"}, "it must be one of server, owner, lockstep, rollback, broadcast"),
        ({"replica": "owner", "law": "wave"}, 'has no links, so it takes no law; "server" does'),
        ({"replica": "server", "law": "wvae"}, 'law is "wvae"; it must be one of'),
        ({"replica": "server", "law": {"kind": "wave", "width": 1.0}}, "law.width is not a parameter"),
        ({"replica": "owner", "damping": 1.0}, "no damping"),
    ],
)
def test_a_wrong_entry_is_one_sentence(law: dict[str, Any], words: str) -> None:
    with pytest.raises(ScenarioError, match=words):
        study(laws=[law])


def test_hands_can_be_changed_in_a_prepared_run() -> None:
    """To the bit what the whole preparation makes of them."""
    whole = study(laws=["wave"])
    hands = whole.task("tug", 2, whole.hands[0], 0)
    network = whole.networks[0]
    wanted = run_batch(prepare(whole.scenario(whole.laws[0], network, 2, hands)))
    found = run_batch(with_hands(prepare(whole.scenario(whole.laws[0], network, 2, [])), hands))
    assert np.array_equal(found.record.position, wanted.record.position)
    assert np.array_equal(found.record.force, wanted.record.force)
    with pytest.raises(ScenarioError, match="stiffness is 'x'"):
        with_hands(prepare(whole.scenario(whole.laws[0], network, 2, [])), [{"user": 1, "stiffness": "x"}])
