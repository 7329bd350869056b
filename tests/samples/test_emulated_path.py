"""The emulated path does what its law says, from its seed alone."""

import numpy as np
import pytest
from tests.samples.memory import MemoryNetwork

from cotouch.errors import SessionError
from cotouch.samples import EmulatedPath, ImpairedTransport, PathLaw


def fates(law: PathLaw, count: int = 20_000, seed: int = 0, size: int = 1000, period: float = 0.001):
    path = EmulatedPath(law, np.random.default_rng(seed))
    return [[when - k * period for when in path.arrivals(k * period, size)] for k in range(count)]


def test_a_constant_delay():
    assert all(fate == [pytest.approx(0.05)] for fate in fates(PathLaw(delay=0.05), 100))


def test_frequencies_are_the_laws():
    seen = fates(PathLaw(delay=0.1, jitter=0.2, loss=0.3, duplication=0.2, reordering=0.5, hold=1.0))
    kept = [fate for fate in seen if fate]
    assert len(kept) / len(seen) == pytest.approx(0.7, abs=0.015)
    assert sum(len(fate) == 2 for fate in kept) / len(kept) == pytest.approx(0.2, abs=0.015)
    first = np.array([fate[0] for fate in kept])
    assert np.mean(first >= 1.1) == pytest.approx(0.5, abs=0.02)
    held = np.where(first >= 1.1, first - 1.0, first)
    assert held.min() == pytest.approx(0.1, abs=0.001)
    assert held.max() == pytest.approx(0.3, abs=0.001)


def test_bursts_have_their_length():
    lost = np.array([not fate for fate in fates(PathLaw(enter=0.02, leave=0.1), 50_000)])
    assert lost.mean() == pytest.approx(0.02 / 0.12, abs=0.02)
    runs = np.diff(np.flatnonzero(np.diff(np.r_[0, lost.astype(int), 0])))[::2]
    assert runs.mean() == pytest.approx(10.0, abs=1.0)


def test_a_wire_takes_its_time_and_its_queue_is_finite():
    seen = fates(PathLaw(rate=500_000.0, queue=0.1), 2000)  # twice what it can
    waits = [fate[0] for fate in seen if fate]
    assert seen[0][0] == pytest.approx(0.002)
    assert max(waits) <= 0.1 + 0.002 + 1e-9
    assert np.mean([bool(fate) for fate in seen[-500:]]) == pytest.approx(0.5, abs=0.02)


def test_an_outage():
    assert not any(fates(PathLaw(down=True), 10))


@pytest.mark.parametrize("law", [
    {"loss": 1.5}, {"jitter": -0.1}, {"rate": 0.0}, {"leave": float("nan")}, {"delay": float("nan")},
])  # fmt: skip
def test_a_law_that_cannot_be_is_named(law: dict[str, float]):
    with pytest.raises(SessionError, match=next(iter(law))):
        PathLaw(**law)


def test_fates_do_not_depend_on_other_paths():
    law = PathLaw(jitter=0.5, loss=0.2)
    seen = []
    for others in ((), ("x", "y")):
        network = MemoryNetwork(law=law, seed=3)
        one, two = network.join("one"), network.join("two")
        one.follow(2, "two")
        for other in others:
            network.join(other).follow(2, "two")
            network.carry(other, "one", b"noise")
        for k in range(50):
            one.send(2, bytes([k]))
        network.now = 2.0
        seen.append([(arrival.payload, arrival.time) for arrival in two.poll()])
    assert seen[0] == seen[1]
    assert 25 <= len(seen[0]) < 50


def test_an_address_belongs_to_one():
    network = MemoryNetwork()
    network.join("here")
    with pytest.raises(SessionError, match="'here' is taken"):
        network.join("here")


def test_an_emulated_delay_is_exact_for_whoever_polls_when_something_is_due() -> None:
    network = MemoryNetwork(seed=0)
    far, near = network.join("far"), network.join("near")
    transport = ImpairedTransport(far, {1: PathLaw(delay=0.02, jitter=0.01)}, clock=lambda: network.now, seed=3)
    transport.follow(1, "near")
    assert transport.due == float("inf")
    sent: dict[bytes, float] = {}
    took: list[float] = []

    def until(end: float) -> None:
        while (due := transport.due) <= end:
            network.now = due
            transport.poll()
            took.extend(due - sent[arrival.payload] for arrival in near.poll())
        network.now = end

    for k in range(2000):
        until(0.001 * k)
        payload = k.to_bytes(4, "big")
        sent[payload] = network.now
        assert transport.send(1, payload)
    until(10.0)
    assert transport.due == float("inf")
    path = EmulatedPath(PathLaw(delay=0.02, jitter=0.01), np.random.default_rng([3, 1]))
    exact = [when - 0.001 * k for k in range(2000) for when in path.arrivals(0.001 * k, 4)]
    assert sorted(took) == pytest.approx(sorted(exact), abs=1e-12)
