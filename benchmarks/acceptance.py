"""`python -m benchmarks.acceptance`: the balance of bodies beyond small displacements, at full length.

Each material, with a solver that is stopped early and one that is not, in one to three copies over links with delays,
10,000 steps of random lengths; directions that are garbage; and 10,000 random sessions of one to five copies from rest,
with the damping of the rule and without any; a cantilever that is bent far.

What shows each of the twelve things that are asked of bodies beyond small displacements (tests in `tests/`):

1. residuals: `sessions`, `garbage`; `mechanics/test_force.py::test_the_balance_is_exact_however_early_the_solver_stops`
2. passivity: `supply`; `simulation/test_materials.py::test_damping_by_the_rule_makes_it_passive_and_without_it_is_not`
3. order, closure: `mechanics/test_force.py::test_the_motion_converges_to_second_order` (T = 0.5 to 0.125 ms)
4. small motions: `mechanics/test_force.py::test_small_motions_are_those_of_linear_elasticity`
5. turns: `mechanics/test_force.py::test_a_rotation_costs_nothing`, `::test_a_free_turn_keeps_shape_and_momentum`
6. the factor β: `mechanics/test_force.py::test_a_bent_body_hardly_needs_its_closure`, and `benchmarks.materials`
7. gradients: `mechanics/test_force.py::test_the_force_is_the_gradient`, `::test_the_mean_force_does_the_work…`
8. cuts: `mechanics/test_cutting.py`, `simulation/test_cutting.py`, `session/test_cuts.py`, `session/test_real_cut.py`
9. copies in step: `mechanics/test_force.py::test_copies_in_step_are_one_body`
10. contact: `mechanics/test_contact_step.py`, `mechanics/test_contact_material.py`
11. cost: `benchmarks.materials`
12. rigid bodies: `mechanics/test_rigid.py::test_what_tumbles_keeps_energy_and_momentum`
"""

import argparse
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import Any

import numpy as np
from tests.mechanics.materials import EVERY, Alone, bent, boxes, made
from tests.mechanics.statics import bent_beam, elastica

from benchmarks._report import Row, add_write, finish
from cotouch.mechanics import BODY_LOSS, CLOSURE_ALARM
from cotouch.simulation import simulate

_SHORT, _LONG = 5e-4, 5e-3
_CAPS = (1, 2, 3, 200)
_SOLIDS = ("corotated", "st-venant-kirchhoff", "neo-hookean")
# Five energies: springs, cubes, and three of tetrahedra.
ENERGIES = ("spring-network", "cells", *_SOLIDS)


def _table(name: str, folder: Path) -> dict[str, Any]:
    """A block of a material as a scenario's body."""
    if name not in _SOLIDS:
        spacing = {"shape": [3, 3, 2], "spacing": 0.02, "mass": 0.2, "stiffness": 60.0, "damping": 0.03}
        return {"kind": "lattice", "model": name, "neighbours": 18 if name == "spring-network" else 6, **spacing}
    path = folder / "block.msh"
    points, corners = boxes((3, 3, 2), 0.02)
    nodes = "\n".join(f"{k + 1} {x} {y} {z}" for k, (x, y, z) in enumerate(points))
    inside = "\n".join(f"{k + 1} 4 2 1 1 {' '.join(str(n + 1) for n in one)}" for k, one in enumerate(corners))
    path.write_text(
        f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n{nodes}\n$EndNodes\n"
        f"$Elements\n{len(corners)}\n{inside}\n$EndElements\n",
        encoding="utf-8",
    )
    return {
        "file": str(path),
        "unit": "m",
        "model": name,
        "young": 5e3,
        "poisson": 0.3,
        "density": 1e3,
        "rayleigh_stiffness": 5e-4,
    }


def _network(users: int, rng: np.random.Generator, spring: float = 40.0) -> dict[str, Any]:
    stiffness, delay = np.zeros((users, users)), np.zeros((users, users))
    for i in range(users):
        for j in range(i):
            stiffness[i, j] = stiffness[j, i] = spring * rng.uniform(0.5, 1.5)
            delay[i, j], delay[j, i] = rng.uniform(0.005, 0.05, 2)
    return {"users": [f"u{k + 1}" for k in range(users)], "spring": stiffness.tolist(), "delay": delay.tolist()}


def sessions(steps: int) -> Iterator[Row]:
    """Item 1: several copies on links, with hands, of each energy and with every cap.

    Args:
        steps: of each copy.
    """
    rng, mean = np.random.default_rng(1), 0.5 * (_SHORT + _LONG)
    with TemporaryDirectory() as folder:
        for name in ENERGIES:
            residual = step_residual = factor = 0.0
            margin = -np.inf
            for users in (1, 2, 3):
                for cap in _CAPS:
                    hand = {"node": 1, "stiffness": 40.0, "damping": 0.4, "path": [0.01, 0.0, 0.005]}
                    run = simulate(
                        {
                            "seed": int(rng.integers(1 << 31)),
                            "body": _table(name, Path(folder)),
                            "network": _network(users, rng),
                            "synchronisation": {"law": "spring"},
                            "steps": {"duration": steps * mean, "random": {"low": _SHORT, "high": _LONG}},
                            "solver": {"iterations": cap},
                            "hands": [hand | {"user": 1, "amplitude": [0.0, 0.01, 0.01], "frequency": 0.7}],
                        }
                    )
                    ledger = run["residual"].values
                    play = float(run.attrs["energy_in_play"])
                    residual = max(residual, float(run.attrs["energy_residual"]))
                    step_residual = max(step_residual, float(np.abs(np.diff(ledger)).max()) / play)
                    margin = max(margin, -float(run.attrs["passivity_margin"]) / play)
                    factor = max(factor, float(run["closure_factor"].max()))
            yield Row(
                "acceptance",
                f"1. {name}: {steps:,} steps each, 1–3 copies on links, caps 1, 2, 3, 200; step residual / ledger",
                f"{step_residual:.1e} / {residual:.1e}",
                "≤ 1e-14 / 1e-12",
                f"of the energy in play; V - V₀ - supply at most {margin:.1e} of it; largest |β - 1| {factor:.1e}",
            )


def garbage(steps: int) -> Iterator[Row]:
    """Item 1 with directions from a matrix whose stiffness is garbage, another in every step.

    Args:
        steps: of each material.
    """
    for name in EVERY:
        rng = np.random.default_rng(2)
        body = made(name)
        velocity = np.cross([3.0, 5.0, 2.0], body.rest) + rng.normal(scale=0.03, size=body.rest.shape)
        copy = Alone(body, bent(body), velocity, copies=2, cap=3)
        mix, held = copy.model.operator.mix.copy(), copy.model.operator.stiffness.copy()
        start = copy.energy
        worst = 0.0
        for _ in range(steps):
            wrong = 10.0 ** rng.uniform(-3.0, 3.0)
            copy.model.operator.mix[2] = wrong * mix[2]
            copy.model.operator.stiffness[:] = wrong * held
            before, ledger = copy.energy, copy.step(float(rng.uniform(_SHORT, _LONG)))
            worst = max(worst, abs(copy.energy - before + float(ledger[BODY_LOSS])))
        yield Row(
            "acceptance",
            f"1. {name}: {steps:,} steps, directions from a matrix up to 1,000 times too stiff or too soft",
            f"{worst / start:.1e} / {abs(copy.energy / start - 1.0):.1e}",
            "≤ 1e-13",
            "worst step / after all of them, of the energy; no dampers",
        )


def supply(runs: int) -> Iterator[Row]:
    """Item 2: random sessions from rest, by the rule and without damping.

    Args:
        runs: how many of each.
    """
    rng = np.random.default_rng(3)
    worst, above, most, alarms, took = -np.inf, 0, 0.0, 0, perf_counter()
    for k in range(runs):
        users = int(rng.integers(1, 6))
        table: dict[str, Any] = {"kind": "lattice", "shape": [2, 2, 2], "spacing": 0.02, "mass": 0.1, "stiffness": 40.0}
        # Both laws at equal odds; the second half of the runs is without damping of the body, where links show most.
        name = ("cells", "spring-network")[int(rng.integers(2))]
        table |= {"model": name, "neighbours": 26 if name == "spring-network" else 6, "damping": 0.02 * (k % 2)}
        hands = [
            {
                "user": user + 1,
                "node": int(rng.integers(1, 9)),
                "stiffness": float(rng.uniform(20.0, 200.0)),
                "damping": float(rng.uniform(0.0, 1.0)),
                "path": rng.uniform(-0.02, 0.02, 3).tolist(),
                "amplitude": rng.uniform(0.0, 0.02, 3).tolist(),
                "frequency": float(rng.uniform(0.5, 5.0)),
                "release": float(rng.uniform(0.05, 0.3)),
            }
            for user in range(users)
        ]
        low = float(rng.uniform(5e-4, 2e-3))
        scenario: dict[str, Any] = {
            "seed": int(rng.integers(1 << 31)),
            "body": table,
            "network": _network(users, rng, spring=float(rng.uniform(20.0, 200.0))),
            "channel": {"jitter": {"kind": "exponential", "scale": 0.003}, "loss": float(rng.uniform(0.0, 0.2))},
            "steps": {"duration": 0.4, "random": {"low": low, "high": 3.0 * low}},
            "hands": hands,
        }
        ruled = simulate(scenario | {"synchronisation": {"law": "spring"}})
        worst = max(worst, -float(ruled.attrs["passivity_margin"]) / float(ruled.attrs["energy_in_play"]))
        alarms += int(float(ruled["closure_factor"].max()) > CLOSURE_ALARM)
        if users > 1:
            bare = simulate(scenario | {"synchronisation": {"law": "spring", "damping": 0.0}})
            over = -float(bare.attrs["passivity_margin"]) / float(bare.attrs["energy_in_play"])
            above += int(over > 1e-9)
            most = max(most, over)
    seconds = perf_counter() - took
    yield Row(
        "acceptance",
        f"2. V - V₀ - supply in {runs:,} random sessions of 1–5 copies by the rule, largest",
        f"{worst:.1e}",
        "≤ 0 but for rounding",
        f"of the energy in play; |β - 1| above {CLOSURE_ALARM:g} in {alarms:,} of them; {seconds:.0f} s with the next",
    )
    yield Row(
        "acceptance",
        "2. the same sessions of 2–5 copies with the damping taken away, above 0 in",
        f"{above:,}",
        "> 0",
        f"by up to {most:.2g} of the energy in play",
    )


def statics(steps: int) -> Iterator[Row]:
    """A cantilever bent far, on finer and finer meshes, beside the elastica.

    Args:
        steps: 10,000 or more: the finest mesh as well.
    """
    length, load = 0.1, 3.0
    tip = elastica(load, length).tip
    for model in ("corotated", "st-venant-kirchhoff"):
        found: list[str] = []
        nodes, off = 0, np.inf
        for fine in (2, 4, 8, 12) if steps >= 10_000 else (2, 4):
            place, nodes = bent_beam(model, fine, slender=10, load=load)
            off = float(np.linalg.norm(place - tip) / np.linalg.norm(tip - [length, 0.0]))
            found.append(f"{100.0 * off:.2g} % with {fine}")
        yield Row(
            "acceptance",
            f"a cantilever of {model} bent by 0.6 of its length, tip compared with the elastica",
            f"{100.0 * off:.2g} %",
            "≤ 2 %",
            f"{nodes:,} nodes, P L² / EI = {load:g}; {', '.join(found)} cubes over the thickness",
        )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--steps", type=int, default=10_000)
    parser.add_argument("--runs", type=int, default=10_000)
    parser.add_argument("--only", choices=("sessions", "garbage", "supply", "statics"))
    add_write(parser)
    options = parser.parse_args()
    rows: list[Row] = []
    for part, length in (
        (sessions, options.steps),
        (garbage, options.steps),
        (supply, options.runs),
        (statics, options.steps),
    ):
        if options.only in (None, part.__name__):
            for row in part(length):
                print(row.what, row.value, row.note, flush=True)
                rows.append(row)
    finish(rows, write=options.write)
