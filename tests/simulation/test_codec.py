"""Runs with a perceptual codec: energy stays what laws promise, whatever it leaves out."""

from typing import Any

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW, PASSIVE, rough, two
from tests.simulation.inside import check_codec

from cotouch import simulate
from cotouch.errors import ScenarioError
from cotouch.laws import PAID, Law, laws
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_batch, run_prepared

CODEC = {"deadband": 0.2, "quantum": 1e-4, "hold": 6}


def drawn(law: str, seed: int, codec: dict[str, Any]) -> Scenario:
    """A random run of three users on a random channel."""
    rng = np.random.default_rng(seed)
    hands = [
        {
            "user": i + 1,
            "kind": "force" if rng.random() < 0.5 else "spring",
            "stiffness": rng.uniform(10, 500),
            "path": [[0.0, 0.0], *([0.2 * k, float(rng.normal(0, 0.1))] for k in range(1, 6))],
            "amplitude": rng.uniform(0, 0.1),
            "frequency": rng.uniform(0.5, 20),
        }
        for i in range(3)
    ]
    channel = {"loss": rng.choice([0.0, 0.1]), "jitter": {"scale": rng.choice([0.0, 0.02])}, "codec": codec}
    return rough(law).replace(seed=seed, steps__duration=0.7, channel=channel, hands=hands)


@pytest.mark.parametrize("law", [AS_LAW.name, "spring", *PASSIVE])
def test_links_make_no_more_than_their_seeds(law: str) -> None:
    unchanged = 0
    for seed in range(2):
        run = simulate(drawn(law, seed, CODEC | {"deadband": (0.1, 0.9)[seed]}))
        assert run.attrs["law_promises"] == 1
        assert run.attrs["made"] <= run.attrs["law_initial_energy"] + 1e-12 * run.attrs["energy_in_play"]
        assert run.attrs["energy_residual"] < 1e-12
        unchanged += run.attrs["unchanged"]
    assert unchanged > 0


def test_the_record_is_that_of_the_batch_engine() -> None:
    """With nothing to leave out, a run message by message is the batch engine's, in all that is kept of it."""
    plain = rough("wave", body=True).replace(record__every=2)
    prepared = prepare(plain)
    batch = run_batch(prepared)
    single = run_prepared(prepare(plain.replace(channel__codec={"deadband": 0.0, "hold": 1})))
    assert single.traffic is not None
    assert not single.traffic.unchanged.any()
    assert np.array_equal(single.position, batch.position)
    assert np.array_equal(single.taken, batch.taken)
    assert single.events == batch.events
    for i, n in enumerate(batch.taken):
        last = n // 2 + 1
        for name in ("position", "velocity"):
            # A modal body's nodes are sums over its modes: BLAS rounds those of one engine, a kernel the other's.
            found, wanted = (getattr(outcome.record, name)[i, :last] for outcome in (single, batch))
            assert found == pytest.approx(wanted, rel=0.0, abs=1e-15)
        for name in ("users", "slots"):
            owners = [i] if name == "users" else np.flatnonzero(prepared.schedule.slots.receiver == i)
            found, wanted = (getattr(outcome.record, name)[:, owners, :last] for outcome in (single, batch))
            assert found == pytest.approx(wanted, abs=1e-12)
        ports = slice(*prepared.hands.first[i : i + 2])
        assert single.record.force[ports, :last] == pytest.approx(batch.record.force[ports, :last], abs=1e-12)
    reached = batch.taken[prepared.schedule.reference] // 2 + 1
    assert single.record.ticks[:, :reached] == pytest.approx(batch.record.ticks[:, :reached], abs=1e-12)
    assert single.record.made == pytest.approx(batch.record.made, abs=1e-12)
    assert single.record.lowest == pytest.approx(batch.record.lowest, abs=1e-12)


def test_it_says_less_and_moves_alike() -> None:
    plain = Scenario.make(
        network=two(),
        synchronisation={"law": "paid"},
        steps={"duration": 1.0, "period": 0.002},
        hands=[{"user": 1, "path": [[0.0, 0.0], [0.5, 0.1]], "stiffness": 300.0, "damping": 6.5}],
    )
    coded = plain.replace(channel__codec={"deadband": 0.1, "quantum": 1e-5})
    whole, less = simulate(plain), simulate(coded)
    assert less.attrs["contents"] + less.attrs["unchanged"] == 1000
    assert less.attrs["contents"] < 540
    numbers = 1 + len(PAID.sends) + len(PAID.sends_scalars)  # of a sample in full, of a point on a line
    assert less.attrs["content_bytes"] < 0.5 * 1000 * 8 * numbers
    apart = np.abs(less["position"].values - whole["position"].values).max()
    assert 0.0 < apart < 0.001


def test_a_hand_that_moves_slowly_feels_no_drag_of_its_own_from_rounding() -> None:
    """Energies were told in steps of the quantum, too: a wave line waited for them, and added 0.2 Ns/m."""
    plain = Scenario.make(
        network=two(),
        synchronisation={"law": "paid"},
        steps={"duration": 9.0, "period": 0.005},
        channel={"jitter": {"kind": "uniform", "scale": 0.02}, "loss": 0.05},
        hands=[{"user": 1, "path": [[0.0, 0.0], [10.0, 0.5]], "stiffness": 300.0, "damping": 6.5}],
    )

    def felt(scenario: Scenario) -> float:
        run = simulate(scenario)
        place, supplied = run["position"].values[0, :, 0, 0], run["supplied"].values[0]
        late = 500  # of 1800 steps, the first bring the object to its speed
        return float((supplied[-1] - supplied[late]) / (place[-1] - place[late]) / 0.05)

    coded = plain.replace(channel__codec={"deadband": 0.1, "quantum": 1e-5, "hold": 4})
    assert felt(coded) == pytest.approx(felt(plain), abs=0.06)


def test_springs_say_less_with_a_larger_deadband() -> None:
    """A large error emptied the account, and then all was said in full as long as that error might be in use."""
    plain = Scenario.make(
        network=two(0.05),
        synchronisation={"law": "spring"},
        steps={"duration": 2.0, "period": 0.002},
        hands=[
            {"user": i, "path": x, "stiffness": 300.0, "damping": 6.5, "amplitude": 0.03, "frequency": 0.6}
            for i, x in ((1, 0.05), (2, -0.05))
        ],
    )
    little, much = (simulate(plain.replace(channel__codec={"deadband": one})).attrs["contents"] for one in (0.05, 0.2))
    assert much < 0.9 * little


def test_rule_damping_grows_by_the_age_of_the_codec_and_by_what_losses_may_cost() -> None:
    plain = Scenario.make(network=two(), synchronisation={"law": "spring"}, steps={"duration": 0.5, "period": 0.001})
    coded = plain.replace(channel__codec={"age": 0.004})
    more = prepare(coded).local_damping - prepare(plain).local_damping
    assert more[:, 0] == pytest.approx(50.0 * 0.004)
    lossy = plain.replace(channel={"loss": 0.1})
    more = prepare(lossy.replace(channel__codec={})).local_damping - prepare(lossy).local_damping
    assert (more[:, 0] > 50.0 * 0.02).all()


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"channel__codec": {"deadband": 1.0}}, "channel.codec.deadband is 1.0"),
        ({"channel__codec": {"hold": 255}}, "channel.codec.hold is 255"),
        ({"channel__codec": {"quantum": -1.0}}, "channel.codec.quantum is -1.0"),
        ({"channel__codec": {"age": 0.0}}, "channel.codec.age is 0.0"),
        ({"channel__codec": {"deadbands": 0.1}}, "channel.codec.deadbands is not an option"),
        (
            {"channel__codec": {}, "synchronisation__mode": "constant"},
            'synchronisation.mode is "constant", which needs',
        ),
        ({"channel__codec": {}, "record__frames": 30.0}, "given with record.frames"),
    ],
)
def test_what_it_cannot_serve_is_refused_in_a_sentence(change: dict[str, Any], sentence: str) -> None:
    scenario = Scenario.make(network=two(), synchronisation={"law": "wave"}, steps={"duration": 0.1})
    with pytest.raises(ScenarioError) as caught:
        prepare(scenario.replace(**change))
    assert sentence in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_law_that_does_not_say_by_which_numbers_it_pays_is_refused() -> None:
    prepared = prepare(
        Scenario.make(network=two(), synchronisation={"law": "pd"}, steps={"duration": 0.1}, channel={"codec": {}})
    )
    law = Law(name="not paying", before=laws()["pd"].before, after=laws()["pd"].after, sends=("v",))
    with pytest.raises(ScenarioError, match='law "not paying" does not say in which numbers'):
        check_codec(prepared.scenario, prepared.model, law, prepared.topology.weight)


def test_the_batch_engine_refuses_it() -> None:
    with pytest.raises(ScenarioError, match="use run_prepared"):
        run_batch(prepare(Scenario.make(network=two(), steps={"duration": 0.1}, channel={"codec": {}})))
