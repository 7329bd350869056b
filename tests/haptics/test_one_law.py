"""What a simulated servo and a real one hold is one law; a law of one's own is one file for both."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.device.support import driven
from tests.simulation.test_tools import BLOCK, HOLD, PAIR

from cotouch.coupling import DeviceCoupling, EnergyMessage, device_couplings
from cotouch.device import Coupling, DeviceModel, ServoModel, assemble
from cotouch.haptics import DeviceEnd, EndOptions
from cotouch.simulation import simulate

PAGE = Path(__file__).parents[2] / "docs" / "extending.md"


def compare(law: str) -> float:
    """Forces at a servo under one motion and one proxy; the largest difference, as a share of the largest force."""
    rng, ticks, T = np.random.default_rng(4), 600, 1e-3
    coupling = Coupling(law=law, stiffness=700.0, damping=1.5, initial_energy=5e-3, ages=0.01, most=3.0, latency=1)
    devices, state = assemble([DeviceModel(coupling=coupling, servo=ServoModel(window=0.0))])
    options = EndOptions(stiffness=700.0, damping=1.5, law=law, most=3.0)
    end = DeviceEnd(options, resolution=0.0, lever=1e12)
    steps, wishes = rng.normal(0.0, 3e-4, (ticks, 3)), np.cumsum(rng.normal(0.0, 1e-3, (ticks, 3)), axis=0)
    totals = np.cumsum(rng.choice([0.0, 0.0, 1e-3], ticks))
    simulated = driven(devices, state, T * np.arange(ticks), steps, np.zeros(ticks), wishes, totals).efforts[:, :3]
    place, force, held, short = np.zeros(3), (0.0, 0.0, 0.0), [], 0
    for k in range(ticks):
        place = place + steps[k]
        end.measure(tuple(place), force, T=T)
        held.append(force)
        rate = steps[k] / T if k else np.zeros(3)
        force = end.decide(tuple(wishes[k]), tuple(rate), EnergyMessage(given=totals[k]), T)
        short += end.fraction < 1.0
    assert 0 < short < ticks - 10
    return float(np.abs(simulated - np.array(held)).max() / np.abs(simulated).max())


@pytest.mark.parametrize("law", device_couplings())
def test_a_simulated_servo_holds_what_a_real_one_holds(law: str) -> None:
    assert compare(law) < 1e-9


def test_a_coupling_of_ones_own_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    code = re.search(r'```python title="my_coupling.py"\n(.*?)```', PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert code is not None
    assert len(code[1].splitlines()) < 60
    (tmp_path / "my_coupling.py").write_text(code[1], encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr("cotouch.coupling._law._KNOWN", device_couplings())
    __import__("my_coupling")
    monkeypatch.delitem(sys.modules, "my_coupling")
    law = device_couplings()["slipping"]
    assert isinstance(law, DeviceCoupling)
    assert compare("slipping") < 1e-9
    device = {"coupling": "slipping", "stiffness": 500}
    run = simulate({"network": PAIR, "body": BLOCK, "steps": {"duration": 0.3}, "tools": [{**HOLD, "device": device}]})
    assert run.attrs["energy_residual"] < 1e-10
    assert 0.5 < np.linalg.norm(run["device_force"].values[0], axis=-1).max() < 5.0
    assert run["coupling_excess"].values[0, -1] <= run["coupling_bound"].values[0]
