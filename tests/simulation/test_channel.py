import numpy as np
import pytest
from tests.simulation.inside import draw, resent

from cotouch.scenario import Channel

SEED = (7, 2, 0, 1)
MANY = 200_000


def test_a_clean_channel_only_delays() -> None:
    draws = draw(Channel(), 0.05, 100, seed=SEED)
    assert (draws.first == 0.05).all()
    assert np.isinf(draws.second).all()


def test_what_a_channel_never_does_is_one_number_seen_as_many() -> None:
    """A clean channel draws nothing, and its arrays hold nothing, however many messages there are."""
    draws = draw(Channel(), 0.05, 100, seed=SEED)
    assert all(array.strides == (0,) for array in draws)
    late = draw(Channel.model_validate({"jitter": {"scale": 0.01}}), 0.05, 100, seed=SEED)
    assert late.first.strides != (0,)
    assert late.second.strides == (0,)
    assert resent(Channel(), draws, 0.05, 0.1, seed=SEED) is draws.first


@pytest.mark.parametrize("law", [{"loss": 0.3}, {"duplication": 0.3}, {"burst": {"enter": 0.2, "leave": 0.2}}])
@pytest.mark.parametrize("jitter", [None, {"scale": 0.02}])
def test_first_is_the_earlier_of_the_two(law: dict[str, object], jitter: dict[str, object] | None) -> None:
    draws = draw(Channel.model_validate({**law, "jitter": jitter}), 0.05, 1000, seed=SEED)
    assert np.array_equal(draws.first, np.minimum(draws.latency, draws.second))
    assert np.isfinite(draws.second).any() == ("duplication" in law)
    assert np.isinf(draws.latency).any() == ("duplication" not in law)


def test_same_seed_same_fates_other_seed_others() -> None:
    channel = Channel.model_validate({"jitter": {"scale": 0.01}, "loss": 0.1, "duplication": 0.1})
    a, b = draw(channel, 0.05, 1000, seed=SEED), draw(channel, 0.05, 1000, seed=SEED)
    assert np.array_equal(a.latency, b.latency)
    assert np.array_equal(a.second, b.second)
    assert not np.array_equal(a.latency, draw(channel, 0.05, 1000, seed=(8, 2, 0, 1)).latency)


@pytest.mark.parametrize(
    ("kind", "mean", "top"),
    [("uniform", 0.01, 0.02), ("exponential", 0.02, np.inf), ("normal", 0.02 * np.sqrt(2 / np.pi), np.inf)],
)
def test_jitter_laws(kind: str, mean: float, top: float) -> None:
    extra = draw(Channel.model_validate({"jitter": {"kind": kind, "scale": 0.02}}), 0.1, MANY, seed=SEED).latency - 0.1
    assert extra.min() >= -1e-15
    assert extra.max() <= top
    assert extra.mean() == pytest.approx(mean, rel=0.02)


def test_rates_of_loss_duplication_reordering() -> None:
    channel = Channel(loss=0.2, duplication=0.1, reordering=0.3, reordering_delay=0.5)
    draws = draw(channel, 0.0, MANY, seed=SEED)
    lost = np.isinf(draws.latency)
    assert lost.mean() == pytest.approx(0.2, rel=0.03)
    assert np.isfinite(draws.second).mean() == pytest.approx(0.1, rel=0.03)
    assert (draws.latency[~lost] == 0.5).mean() == pytest.approx(0.3, rel=0.03)


def test_bursts_have_gilbert_elliotts_rate_and_length() -> None:
    channel = Channel.model_validate({"burst": {"enter": 0.02, "leave": 0.25}})
    lost = np.isinf(draw(channel, 0.0, MANY, seed=SEED).latency)
    assert lost.mean() == pytest.approx(0.02 / 0.27, rel=0.06)
    starts = np.flatnonzero(np.diff(lost.astype(int)) == 1)
    assert lost.sum() / starts.size == pytest.approx(1 / 0.25, rel=0.06)


def test_every_sample_arrives_when_lost_ones_are_sent_again() -> None:
    channel = Channel(loss=0.5, resend=0.2)
    draws = draw(channel, 0.05, MANY, seed=SEED)
    latency = resent(channel, draws, 0.05, 0.1, seed=SEED)
    kept = np.isfinite(draws.latency)
    assert np.array_equal(latency[kept], draws.latency[kept])
    tries = np.rint((latency - 0.05) / 0.2)
    assert np.allclose(latency, 0.05 + 0.2 * tries)
    for n in range(4):
        assert (tries == n).mean() == pytest.approx(0.5 ** (n + 1), rel=0.05)
