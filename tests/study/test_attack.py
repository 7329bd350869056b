"""The worst force profile, found and played."""

from typing import Any

import numpy as np
import pytest
from tests.network.support import five_users, pairs
from tests.study.inside import attack


def test_round_off_does_not_choose_between_a_profile_and_its_opposite(monkeypatch: pytest.MonkeyPatch):
    network = five_users().with_links(pairs("12 23 34 45"))
    one = attack.worst_force(network, period=0.02, corners=3, damping="rule")
    eigh = attack.linalg.eigh

    def opposite(*args: Any, **options: Any) -> Any:
        values, vectors = eigh(*args, **options)
        return values, -vectors

    monkeypatch.setattr(attack.linalg, "eigh", opposite)
    other = attack.worst_force(network, period=0.02, corners=3, damping="rule")
    assert np.array_equal(one.run["position"].values, other.run["position"].values)
    assert one.worked == pytest.approx(one.least, rel=1e-6)
