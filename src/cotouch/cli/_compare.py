"""`cotouch compare`."""

import json
from pathlib import Path

import numpy as np
from rich.console import Console

from cotouch.cli._output import counting, literal, new_table, number, print_json, print_written
from cotouch.files import beside, folder, write_netcdf
from cotouch.laboratory import Study, broken, compare, mean_cost, write_report

# In the folder of a comparison, and of a sweep.
RESULTS, CELLS, _REPORT = "results.nc", "cells", "report.html"


def run(path: Path, *, out: Path, dask: str | None, jobs: int, as_json: bool) -> None:
    """Compares the laws of a study, writes results and report, and prints the table.

    Args:
        path: of the study.
        out: folder to write into; results of cells in it are not computed again.
        dask: address of a Dask scheduler; None: this machine computes.
        jobs: cells at once; -1: one per core.
        as_json: whether to print one JSON object and nothing else on standard output.
    """
    study = Study.read(path)
    beside(folder(out), [RESULTS, _REPORT], (path, *study.files()))
    with counting("Compiling the kernels", _DOING, quiet=as_json) as progress:
        found = compare(study, store=out / CELLS, jobs=jobs, dask=dask, progress=progress)
    write_netcdf(found, out / RESULTS, "result")
    files = [out / RESULTS, write_report(found, out / _REPORT)]
    costs = mean_cost(found)
    laws, networks = found["law"].values.tolist(), found["network"].values.tolist()
    if as_json:
        table = [
            {"law": law, "network": network, "users": users, "cost": cost, "half_interval": half}
            for (law, network, users), (cost, half) in costs.items()
        ]
        problems = json.loads(found.attrs["problems"])
        told = {"title": study.title, "costs": table, "problems": problems, "broken_promises_j": broken(found)}
        print_json({**told, "files": [str(file) for file in files]})
        return

    console = Console()
    for users in found["users"].values.tolist():
        shown = new_table("law", *map(literal, networks), title=f"cost with {users} users")
        for law in laws:
            shown.add_row(literal(law), *(_cell(*costs[law, network, users]) for network in networks))
        console.print(shown)
    for law, energy in broken(found).items():
        told = f"  – {law} promises to be passive, but made {number(energy, 'J', digits=3)} beyond its initial energy"
        console.print(told, style="red", highlight=False, markup=False, soft_wrap=True)
    for problem in json.loads(found.attrs["problems"]):
        console.print(f"  – {problem}", style="yellow", highlight=False, markup=False, soft_wrap=True)
    print_written(console, files)


_DOING = {"tune": "Tuning the laws", "score": "Running tasks", "map": "Searching for unsafe cases"}


def _cell(cost: float, half: float) -> str:
    if np.isnan(cost):
        return "–"
    return "[red]dangerous[/red]" if np.isinf(cost) else f"{number(cost, digits=3)} ± {number(half, digits=1)}"
