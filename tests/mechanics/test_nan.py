import numpy as np
import pytest

from cotouch.body import lattice
from cotouch.scenario import Scenario
from cotouch.simulation import prepare, run_peers


@pytest.mark.parametrize("law", ["spring", "paid"])
def test_nan_shows_in_the_state_instead_of_passing_for_rest(law: str) -> None:
    """A device that delivers NaN must not leave a body that looks healthy."""
    scenario = Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 50], [50, 0]], "delay": [[0, 0.01], [0.01, 0]]},
        body=lattice((3, 2, 2), ground=[0], ground_stiffness=5),
        steps={"duration": 0.05, "period": 0.01},
        hands=[{"user": 1, "kind": "force", "path": [1.0, 0.0, 0.0]}],
        solver={"basis": "nodal"},
        synchronisation={"law": law},
    )
    prepared = prepare(scenario)
    assert prepared.model.basis == "nodal"
    assert np.isfinite(run_peers(prepared).position[0]).all()
    prepared.hands.path_value[0, 0] = np.nan
    broken = run_peers(prepared)
    assert np.isnan(broken.position[0][1]).any()
    assert np.isnan(broken.reports[0][0].residual)
