"""Every law in both worlds: the batch engine and single peers call the same two functions."""

import numpy as np
import pytest
from tests.laws.scenes import AS_LAW, OTHERS, rough

from cotouch.simulation import prepare, run_batch, run_peers


@pytest.mark.parametrize("body", [False, True])
@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_spring_as_a_law_is_the_spring_to_the_bit(mode: str, body: bool) -> None:
    built_in, law = (run_batch(prepare(rough(name, mode=mode, body=body))) for name in ("spring", AS_LAW.name))
    assert np.array_equal(built_in.position, law.position)
    for i, n in enumerate(built_in.taken):
        assert np.array_equal(built_in.record.position[i, : n + 1], law.record.position[i, : n + 1])
        assert np.array_equal(built_in.record.users[:, i, : n + 1], law.record.users[:, i, : n + 1])
    assert np.array_equal(built_in.record.made, law.record.made)


@pytest.mark.parametrize("law", [AS_LAW.name, *OTHERS])
@pytest.mark.parametrize("body", [False, True])
def test_peers_move_as_the_batch_does(law: str, body: bool) -> None:
    prepared = prepare(rough(law, body=body))
    batch, peers = run_batch(prepared), run_peers(prepared)
    for i, n in enumerate(prepared.schedule.count):
        assert peers.position[i].shape[0] == n + 1
        assert np.array_equal(peers.position[i][-1], batch.position[i])
        worst = max(abs(report.residual) for report in peers.reports[i])
        assert worst <= 1e-12 * max(1.0, *(report.kinetic + report.elastic for report in peers.reports[i]))


@pytest.mark.parametrize("law", [AS_LAW.name, *OTHERS])
@pytest.mark.parametrize("mode", ["constant", "self-paced", "freshest"])
def test_books_balance_whatever_a_law_does(law: str, mode: str) -> None:
    outcome = run_batch(prepare(rough(law, mode=mode, body=True)))
    ticks = outcome.record.ticks
    assert np.abs(ticks[4]).max() <= 1e-12 * np.abs(ticks[:4]).max()
