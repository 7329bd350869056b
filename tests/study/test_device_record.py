"""The record of two people with devices: each scenario is its number's alone, and what it looks for would be found."""

import numpy as np
import pytest
from benchmarks import device_record as record


def test_numbers_are_scenarios_without_violations():
    every = [record.examine(number) for number in (1, 2, 3)]
    assert every[2] == record.examine(3)
    assert 0.0 < max(share for found in every for share in found.used) <= 1.0
    for found in every:
        assert found.ticks > 1000
        assert not record.broken(found)
        assert not record.unbalanced(found)


def test_scenarios_vary():
    rngs = [np.random.default_rng((record.SEED, number)) for number in range(60)]
    drawn = [(record.body_of(rng)[0], *record.device_of(rng)[1:]) for rng in rngs]
    assert {kind for kind, *_ in drawn} == {"point", "chain", "block"}
    assert len({spec.name for _, spec, _ in drawn}) == 6
    assert {coupling.law for *_, coupling in drawn} == {None, "virtual"}
    scales = {coupling.scale for *_, coupling in drawn}
    assert {"fit", 1.0} < scales


def test_a_coupling_that_books_nothing_is_found(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("cotouch.haptics._ends.book_end", lambda *_: None)
    assert any(record.broken(record.examine(number)) for number in (1, 2, 3))
