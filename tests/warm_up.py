"""Compiles kernels into the cache on disk, a width in each process, before several processes would do so."""

import subprocess
import sys
from pathlib import Path


def warm_up() -> None:
    """Compiles for both widths at once."""
    running = [subprocess.Popen([sys.executable, __file__, axes]) for axes in ("1", "3")]
    for process in running:
        process.wait()


def main(axes: int) -> None:
    """Runs a body of that many axes in every way that compiles something of its own."""
    import numpy as np

    from cotouch.body import lattice
    from cotouch.device import CartesianPlant, DeviceModel, SimulatedDevice, critical_stiffness
    from cotouch.network import Network
    from cotouch.planning import plan
    from cotouch.scenario import Scenario
    from cotouch.simulation import prepare, run_peers, simulate

    scenario = Scenario.make(
        network={"users": ["a", "b"], "spring": [[0, 1], [1, 0]], "delay": [[0, 0.01], [0.01, 0]]},
        body={"kind": "chain", "nodes": 2, "dimension": axes},
        steps={"duration": 0.05, "period": 0.01},
        hands=[{"user": 1, "path": [0.1] * axes}],
    )
    for law in ("spring", "paid"):  # the engine is another where links are not springs
        chosen = scenario.replace(synchronisation={"law": law})
        simulate(chosen)
        run_peers(prepare(chosen))
    sys.path.insert(0, str(Path(__file__).parent.parent))
    from tests.mechanics.pressing import Pressed

    block = lattice((2, 2, 2), ground="all", ground_stiffness=1.0)
    Pressed(block.as_full() if axes == 1 else block).step(1e-3)
    if axes == 3:
        with_tools = scenario.replace(
            body={"kind": "lattice", "shape": [2, 2, 2]},
            hands=[],
            tools=[{"user": 1, "at": [0.0, 0.0, 0.05], "device": {}}],
        )
        simulate(with_tools)
        run_peers(prepare(with_tools))
        # Devices belong to the tools above, and the search for links to the other process: both then take equally long.
        SimulatedDevice(DeviceModel()).advance(0.0)
        critical_stiffness(CartesianPlant(), precision=0.5)
    if axes == 1:
        three = [[0, 1, 1], [1, 0, 1], [1, 1, 0]]
        network = Network(users=["a", "b", "c"], spring=three, delay=0.01 * np.array(three))
        for objective, method in (("consensus", "enumerate"), ("decay", "local"), ("damping", "bound")):
            plan(network, links=2, objective=objective, method=method, starts=2)


if __name__ == "__main__":
    if sys.argv[1:]:
        main(int(sys.argv[1]))
    else:
        warm_up()
