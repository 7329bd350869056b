"""Energy that laws make beyond what they declare: in random scenarios, and with users who are searched for.

`python -m benchmarks.promises` runs each passive law in ten thousand random scenarios of a point, in a thousand of
blocks that tools and devices touch, and in two thousand of a search; it goes on where it was interrupted. Springs
without damping, which promise nothing, are searched beside them. `--first 20000` takes other scenarios, `--laws paid`
that law only.
"""

import argparse
import sys
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks._report import Row, add_write, finish
from cotouch.laboratory import made_energy, searched, touching, trial
from cotouch.laboratory._cells import Store, cells, source_of
from cotouch.laws import laws
from cotouch.simulation import prepare, simulate, with_law

# A cell is so many scenarios, and one search of so many evaluations.
_BLOCK, _TOUCHES, _SEARCH = 250, 50, 500
# Of energy, what is round-off [J].
_ROUND = 1e-12
ACTIVE = "spring without damping"


def passive() -> list[str]:
    """Laws that promise to make no more than their initial energies."""
    return [name for name, law in laws().items() if law.passive]


def at_random(cell: dict[str, Any]) -> dict[str, Any]:
    """The worst of each law in a block of scenarios: energy beyond, as share of the run's, and residual, likewise."""
    worst: dict[str, list[float]] = {}
    for number in range(cell["first"], cell["first"] + cell["count"]):
        prepared = prepare(trial(number))
        for law in cell["laws"]:
            found = made_energy(with_law(prepared, law))
            now = [float(not found.kept), found.beyond, found.residual / max(found.play, 1e-9)]
            before = worst.get(law, [0.0, -float("inf"), 0.0])
            worst[law] = [before[0] + now[0], max(before[1], now[1]), max(before[2], now[2])]
    return {"worst": worst}


def with_tools(cell: dict[str, Any]) -> dict[str, Any]:
    """The worst of each law in a block of scenarios with tools and devices, by links, books and couplings."""
    worst: dict[str, list[float]] = {}
    for number in range(cell["first"], cell["first"] + cell["count"]):
        for law in cell["laws"]:
            run = simulate(touching(number, law))
            made = run.attrs
            play = max(float(np.nanmax(np.abs(run[name].values))) for name in ("supplied_total", "stored"))
            beyond = made["made"] - made["law_initial_energy"] if made["finished"] else float("inf")
            over = 0.0
            if "coupling_excess" in run:
                most = np.fmax.reduce(run["coupling_excess"].values, axis=1) - run["coupling_bound"].values
                over = max(0.0, float(np.nanmax(most)))
            left = float(np.nanmax(np.abs(run["residual"].values))) / max(play, 1e-9)
            left = max(left, float(made.get("device_residual", 0.0)))
            broken = beyond > _ROUND * max(play, 1.0) or over > _ROUND * max(play, 1.0)
            touched = float(np.nanmax(np.abs(run["touch_force"].values))) > 0.1
            before = worst.get(law, [0.0, -float("inf"), 0.0, 0.0])
            worst[law] = [
                before[0] + broken,
                max(before[1], beyond),
                max(before[2], left),
                before[3] + touched,
            ]
    return {"worst": worst}


def by_search(cell: dict[str, Any]) -> dict[str, Any]:
    """One search."""
    options = {"damping": 0.0} if cell["law"] == ACTIVE else {}
    law = "spring" if cell["law"] == ACTIVE else cell["law"]
    found = searched(law, cell["evaluations"], seed=cell["seed"], **options)
    return {"kept": found.kept, "beyond": found.beyond}


def run(out: Path, runs: int, touches: int, evaluations: int, jobs: int, *, names: list[str], first: int) -> list[Row]:
    """All of it, or what is left of it, and its rows.

    Args:
        out: folder of what is done.
        runs: scenarios of each law.
        touches: scenarios of each law with tools and devices.
        evaluations: of the searches of each law.
        jobs: cells at once; -1: one per core.
        names: of laws.
        first: number of the first scenario.
    """
    code = {name: source_of(laws()[name].before) for name in names}
    store = Store(out, source_of(trial))

    def progress(done: int, total: int, what: str) -> None:
        print(f"\r{what} {done}/{total} ", end="", file=sys.stderr, flush=True)

    blocks = [
        {"first": first + done, "count": min(_BLOCK, runs - done), "laws": names, "code": code}
        for done in range(0, runs, _BLOCK)
    ]
    random = cells("random", at_random, blocks, jobs=jobs, store=store, progress=progress)
    blocks = [
        {"first": first + done, "count": min(_TOUCHES, touches - done), "laws": names, "code": code}
        for done in range(0, touches, _TOUCHES)
    ]
    touched = cells("touching", with_tools, blocks, jobs=jobs, store=store, progress=progress)
    asked = [
        {"law": law, "seed": seed, "evaluations": min(_SEARCH, evaluations), "code": code.get(law, "")}
        for law in [*names, ACTIVE]
        for seed in range(-(-evaluations // _SEARCH))
    ]
    found = cells("searched", by_search, asked, jobs=jobs, store=store, progress=progress)
    rows: list[Row] = []
    for law in names if random else []:
        of = [block["worst"][law] for block in random]
        many, most = sum(each[0] for each in of), max(each[1] for each in of)
        left = max(each[2] for each in of)
        what = f"{law}: of {runs:,} random scenarios, made more than its initial energy"
        beside = f"largest of made − initial energy {most:.2g} J; residual at most {left:.1g} of the run's energy"
        rows.append(Row("promises", what, f"{many:.0f}", "0", beside))
    for law in names if touched else []:
        of = [block["worst"][law] for block in touched]
        most, left = max(each[1] for each in of), max(each[2] for each in of)
        what = (
            f"{law}: of {touches:,} random scenarios with tools and devices, more than its initial energy or than "
            "couplings may"
        )
        beside = (
            f"tools touched in {sum(each[3] for each in of):.0f}; largest of made − initial energy {most:.2g} J; "
            f"residual of body and devices at most {left:.1g} of the run's energy"
        )
        rows.append(Row("promises", what, f"{sum(each[0] for each in of):.0f}", "0", beside))
    for law in [*names, ACTIVE] if found else []:
        of = [result for cell, result in zip(asked, found, strict=True) if cell["law"] == law]
        tried = len(of) * min(_SEARCH, evaluations)
        most, kept = max(each["beyond"] for each in of), all(each["kept"] for each in of)
        what = (
            f"{law}: made beyond its initial energy, the most that {tried:,} searched pairs of users and networks found"
        )
        goal = "" if law == ACTIVE else "0 J"
        rows.append(
            Row("promises", what, "0 J" if kept else f"{most:.2g} J", goal, f"made − initial energy {most:.2g} J")
        )
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.promises", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("promises"), help="folder of what is done")
    parser.add_argument("--runs", type=int, default=10_000, help="random scenarios of each law")
    parser.add_argument("--touches", type=int, default=1_000, help="of each law with tools and devices")
    parser.add_argument("--evaluations", type=int, default=2_000, help="of the searches of each law")
    parser.add_argument("--jobs", type=int, default=-1, help="cells at once; -1: one per core")
    parser.add_argument("--laws", nargs="+", default=passive(), choices=passive(), help="instead of all passive ones")
    parser.add_argument("--first", type=int, default=0, help="number of the first scenario")
    add_write(parser)
    options = parser.parse_args()
    rows = run(
        options.out,
        options.runs,
        options.touches,
        options.evaluations,
        options.jobs,
        names=options.laws,
        first=options.first,
    )
    finish(rows, write=options.write)


if __name__ == "__main__":
    main()
