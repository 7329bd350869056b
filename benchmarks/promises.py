"""Energy that laws make beyond what they declare: in random scenarios, and with users who are searched for.

`python -m benchmarks.promises` runs each passive law in ten thousand random scenarios and in two thousand of a search;
it goes on where it was interrupted. Springs without damping, which promise nothing, are searched beside them.
"""

import argparse
import sys
from pathlib import Path
from typing import Any

from benchmarks._report import Row, add_write, finish
from cotouch.laboratory import books, searched, trial
from cotouch.laboratory._cells import Store, cells, source_of
from cotouch.laws import laws
from cotouch.simulation import prepare, with_law

# A cell is so many scenarios, and one search of so many evaluations.
_BLOCK, _SEARCH = 250, 500
ACTIVE = "spring without damping"


def passive() -> list[str]:
    """Laws that promise to make no more than their seeds."""
    return [name for name, law in laws().items() if law.passive]


def at_random(cell: dict[str, Any]) -> dict[str, Any]:
    """The worst of each law in a block of scenarios: energy beyond, as share of the run's, and residual, likewise."""
    worst: dict[str, list[float]] = {}
    for number in range(cell["first"], cell["first"] + cell["count"]):
        prepared = prepare(trial(number))
        for law in cell["laws"]:
            found = books(with_law(prepared, law))
            now = [float(not found.kept), found.beyond, found.residual / max(found.play, 1e-9)]
            before = worst.get(law, [0.0, -float("inf"), 0.0])
            worst[law] = [before[0] + now[0], max(before[1], now[1]), max(before[2], now[2])]
    return {"worst": worst}


def by_search(cell: dict[str, Any]) -> dict[str, Any]:
    """One search."""
    options = {"damping": 0.0} if cell["law"] == ACTIVE else {}
    law = "spring" if cell["law"] == ACTIVE else cell["law"]
    found = searched(law, cell["evaluations"], seed=cell["seed"], **options)
    return {"kept": found.kept, "beyond": found.beyond}


def run(out: Path, runs: int, evaluations: int, jobs: int) -> list[Row]:
    """All of it, or what is left of it, and its rows.

    Args:
        out: folder of what is done.
        runs: scenarios of each law.
        evaluations: of the searches of each law.
        jobs: cells at once; -1: one per core.
    """
    names = passive()
    code = {name: source_of(laws()[name].before) for name in names}
    store = Store(out, source_of(trial))

    def progress(done: int, total: int, what: str) -> None:
        print(f"\r{what} {done}/{total} ", end="", file=sys.stderr, flush=True)

    blocks = [
        {"first": first, "count": min(_BLOCK, runs - first), "laws": names, "code": code}
        for first in range(0, runs, _BLOCK)
    ]
    random = cells("random", at_random, blocks, jobs=jobs, store=store, progress=progress)
    asked = [
        {"law": law, "seed": seed, "evaluations": min(_SEARCH, evaluations), "code": code.get(law, "")}
        for law in [*names, ACTIVE]
        for seed in range(max(1, round(evaluations / _SEARCH)))
    ]
    found = cells("searched", by_search, asked, jobs=jobs, store=store, progress=progress)
    rows: list[Row] = []
    for law in names:
        of = [block["worst"][law] for block in random]
        many, most = sum(each[0] for each in of), max(each[1] for each in of)
        left = max(each[2] for each in of)
        what = f"{law}: of {runs:,} random scenarios, made more than its seed"
        beside = f"largest of made − seed {most:.2g} J; residual at most {left:.1g} of the run's energy"
        rows.append(Row("promises", what, f"{many:.0f}", "0", beside))
    for law in [*names, ACTIVE]:
        of = [result for cell, result in zip(asked, found, strict=True) if cell["law"] == law]
        tried = len(of) * min(_SEARCH, evaluations)
        most, kept = max(each["beyond"] for each in of), all(each["kept"] for each in of)
        what = f"{law}: made beyond its seed, the most that {tried:,} searched pairs of users and networks found"
        goal = "" if law == ACTIVE else "0 J"
        rows.append(Row("promises", what, "0 J" if kept else f"{most:.2g} J", goal, f"made − seed {most:.2g} J"))
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.promises", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("promises"), help="folder of what is done")
    parser.add_argument("--runs", type=int, default=10_000, help="random scenarios of each law")
    parser.add_argument("--evaluations", type=int, default=2_000, help="of the searches of each law")
    parser.add_argument("--jobs", type=int, default=-1, help="cells at once; -1: one per core")
    add_write(parser)
    options = parser.parse_args()
    finish(run(options.out, options.runs, options.evaluations, options.jobs), write=options.write)


if __name__ == "__main__":
    main()
