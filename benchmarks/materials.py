"""`python -m benchmarks.materials`: what a step of each material costs beside the linear one, and how exact it is.

One copy without neighbours on one core; the best and the middle of many steps in a compiled loop. A cube of E = 10 kPa
with spacing 1 cm, bent by a twentieth and turning, steps of 1 ms, dampers of 2e-4 s. Beside it MuJoCo flex on the same
grid with the same stiffness.
"""

import argparse
import contextlib
import os
import tempfile
import time
from typing import Any

import numba
import numpy as np
from tests.mechanics.materials import DENSITY, EVERY, SPACING, YOUNG, Alone, bent, made

from benchmarks._report import Row, add_write, finish
from benchmarks.step import _quiet
from cotouch.mechanics import BETA, ITERATIONS, closed_step

_ROUNDS, _STEPS = 100, 5
_T, _TOLERANCE, _CAP = 1e-3, 1e-6, 500
_GOALS = {
    ("cells", 10): "0.25 ms",
    ("cells", 17): "1.0 ms",
    ("spring-network", 10): "0.4 ms",
    ("corotated", 10): "0.6 ms",
}


@numba.njit(error_model="numpy", nogil=True)
def _run(
    op: Any, force: Any, state: Any, links: Any, ports: Any, work: Any, ledger: Any, factors: Any, lanes: Any
) -> None:
    """A few steps."""
    none, local = np.zeros(0), np.zeros(1)
    for k in range(factors.shape[0]):
        closed_step(op, force, state, links, ports, local, local, _T, -1, work, ledger, none, _TOLERANCE, _CAP, lanes)
        factors[k] = ledger[BETA]


def _material(name: str, side: int) -> Row:
    body = made(name, viscosity=2e-4, shape=(side, side, side))
    turning = np.cross([1.0, 2.0, 1.0], body.rest - body.rest.mean(axis=0))
    copy = Alone(body, bent(body, 0.05), turning, tolerance=_TOLERANCE)
    model = copy.model
    took, factors = np.empty(_ROUNDS), np.empty((_ROUNDS, _STEPS))
    args = model.operator, copy.force, copy.state, copy.links, copy.ports, copy.work, copy.ledger
    _run(*args, factors[0, :1], model.lanes)
    for k in range(_ROUNDS):
        begin = time.perf_counter()
        _run(*args, factors[k], model.lanes)
        took[k] = (time.perf_counter() - begin) / _STEPS
    found = f"{1e3 * np.min(took):.3f} ms best, {1e3 * np.median(took):.3f} ms median"
    exact = f"p99 |β - 1| {np.quantile(factors, 0.99):.1e}"
    note = f"up to {copy.force.directions} looks, {copy.ledger[ITERATIONS]:.0f} iterations, {exact}"
    return Row("materials", f"a step, {name}, {side**3} nodes", found, _GOALS.get((name, side), ""), note)


def _flex(side: int) -> Row:
    """A step of MuJoCo flex, with its own tetrahedra."""
    try:
        import mujoco
    except ImportError:
        return Row("materials", "MuJoCo flex", "not installed")
    mass = DENSITY * ((side - 1) * SPACING) ** 3
    text = f"""
    <mujoco>
      <option timestep="{_T}" gravity="0 0 0" integrator="discrete"><flag contact="disable"/></option>
      <size memory="2G"/>
      <worldbody>
        <flexcomp name="f" type="grid" count="{side} {side} {side}" spacing="{SPACING} {SPACING} {SPACING}" dim="3"
                  mass="{mass}" radius="0.001">
          <elasticity young="{YOUNG}" poisson="0.3" damping="2e-4"/>
          <contact selfcollide="none" contype="0" conaffinity="0"/>
        </flexcomp>
      </worldbody>
    </mujoco>"""
    took = np.empty(30)
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):  # MuJoCo logs into the working directory
        with _quiet():
            model = mujoco.MjModel.from_xml_string(text)
        data = mujoco.MjData(model)
        data.qvel[:] = 0.01 * np.random.default_rng(0).normal(size=data.qvel.size)
        for k in range(took.size):
            begin = time.perf_counter()
            mujoco.mj_step(model, data)
            took[k] = time.perf_counter() - begin
    found = f"{1e3 * np.min(took):.1f} ms best, {1e3 * np.median(took):.1f} ms median"
    return Row("materials", f"MuJoCo {mujoco.__version__} flex, {side**3} nodes, implicit (discrete)", found)


def measure(side: int = 10) -> list[Row]:
    """Time of a step of every material with so many nodes along each edge."""
    rows = [*(_material(name, side) for name in EVERY), _flex(side)]
    if side == 10:
        rows.insert(-1, _material("cells", 17))
    rows.append(Row("materials", "load of the machine, of the last minute", f"{os.getloadavg()[0]:.1f}"))
    return rows


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--side", type=int, default=10)
    add_write(parser)
    options = parser.parse_args()
    finish(measure(options.side), write=options.write)
