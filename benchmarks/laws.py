"""Link laws side by side: the study of `examples/laws.toml`, and the table of docs/laws.md.

`python -m benchmarks.laws --out DIR` runs it, resumes it, and leaves report and results in the folder; `--small` takes
two users, four draws and a short search. `--part star`, `path` or `elastic` is the same study of copies that are linked
so, or of a soft body, on fewer networks with a shorter search. They, and `--passive`, leave out laws and replicas that
promise nothing, and the map.
"""

import argparse
import json
import sys
from collections.abc import Sequence
from os import getloadavg
from pathlib import Path
from time import perf_counter, process_time
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks._report import Row, add_write, finish
from cotouch.files import write_netcdf
from cotouch.laboratory import Study, compare, mean_cost, write_report
from cotouch.laboratory._score import promises
from cotouch.laboratory._study_tables import LawTable

if TYPE_CHECKING:
    import xarray as xr

STUDY = Path(__file__).parents[1] / "examples" / "laws.toml"
SMALL: dict[str, Any] = {
    "users": [2],
    "draws": 4,
    "tuning": {"search": 16, "local": 16, "draws": 1, "safe": 0},
}
# Other studies: the same, but for these. Stars and paths are tuned with as many users as they need to be some.
_BRIEF = {"search": 32, "local": 32, "draws": 1, "only": True, "safe": 0}
_FOUR = {**_BRIEF, "users": 4}
_OTHER: dict[str, Any] = {"draws": 10, "felt": False, "map": None}
PARTS: dict[str, dict[str, Any]] = {
    "full": {},
    "ten": {"users": [2], "tuning": {"search": 64, "local": 64, "draws": 2}, "map": None},
    "star": {**_OTHER, "graph": "star", "users": [4, 8], "tuning": _FOUR},
    "path": {**_OTHER, "graph": "path", "users": [4, 8], "tuning": _FOUR},
    "elastic": {
        **_OTHER,
        "users": [2],
        "body": {"kind": "chain", "nodes": 5, "mass": 0.2, "stiffness": 400.0, "damping": 1.0},
        "tuning": _BRIEF,
    },
}
SECTIONS_OF = {
    "full": "laws",
    "ten": "laws: ten in ten minutes",
    "star": "laws: stars",
    "path": "laws: paths",
    "elastic": "laws: elastic body",
}
_LEFT_OUT = ("5 ms", "25 ms")
# Ten laws on five networks: how long that takes.
_TEN = ("P", "pd", "rule", "once", "wave", "tdpa", "tank", "pspm", "paid", "rollback")
_FIVE = ("5 ms", "25 ms", "100 ms", "25 + exp(10) ms, 5 % loss", "5G from a car")


def study(
    part: str = "full",
    *,
    small: bool = False,
    passive: bool = False,
    users: Sequence[int] = (),
    draws: int | None = None,
) -> Study:
    """A study.

    Args:
        part: which of them.
        small: two users, four draws, a short search.
        passive: only laws that promise to make no energy.
        users: numbers of them, instead of the part's.
        draws: of each task, instead of the study's.
    """
    tables = {**Study.read(STUDY).model_dump(), **PARTS[part], **(SMALL if small else {})}
    if part == "ten":
        tables["laws"] = [law for law in tables["laws"] if LawTable.model_validate(law).label in _TEN]
        tables["networks"] = [network for network in tables["networks"] if network["name"] in _FIVE]
    elif passive or part != "full":
        tables["laws"] = [law for law in tables["laws"] if promises(LawTable.model_validate(law))]
        tables["map"] = None
    if part not in {"full", "ten"}:
        tables["networks"] = [network for network in tables["networks"] if network["name"] not in _LEFT_OUT]
    if users:
        tables["users"] = list(users)
    if draws is not None:
        tables["draws"] = draws
    return Study.make(**tables)


def run(asked: Study, out: Path, jobs: int = -1) -> "xr.Dataset":
    """Runs a study, or takes up what is there, and writes report and results."""

    def progress(done: int, total: int, what: str) -> None:
        print(f"\r{what} {done}/{total} ", end="", file=sys.stderr, flush=True)

    found = compare(asked, store=out / "cells", jobs=jobs, progress=progress)
    write_netcdf(found, out / "results.nc", "result")
    write_report(found, out / "report.html")
    return found


def rows(found: "xr.Dataset", part: str = "full") -> list[Row]:
    """Rows of the table: what ours loses first.

    Args:
        found: what the comparison found.
        part: which study.
    """
    asked, section = json.loads(found.attrs["study"]), SECTIONS_OF[part]
    networks, costs = found["network"].values.tolist(), mean_cost(found)
    stiff = mean_cost(found, hand=found.sizes["hand"] - 1)
    tuning = asked["tuning"]
    note = f"{asked['draws']} draws, {tuning['search']} + {tuning['local']} settings of {tuning['users']} users"
    result = [Row(section, "networks", " / ".join(networks), "", note)]
    result += [row for users in found["users"].values.tolist() for row in _challenge(found, section, users)]
    for users in found["users"].values.tolist():
        for law in found["law"].values.tolist():
            cells = " / ".join(
                _cell(*costs[law, network, users], stiff[law, network, users][0]) for network in networks
            )
            result.append(Row(section, f"{users} users: {law}", cells))
    if "published" in found["tuning"] and asked["felt"]:
        result += [_drag(found, section, users) for users in found["users"].values.tolist()]
    for law in found["law"].values.tolist():
        made = float(found["made"].sel(law=law).max())
        goal = "0 J" if bool(found["promises"].sel(law=law)) else ""
        result.append(
            Row(section, f"{law}: energy made beyond its initial energy, at most", f"{made:.2g} J", goal, "all runs")
        )
    return result


def _challenge(found: "xr.Dataset", section: str, users: int) -> list[Row]:
    """Our law beside the best passive rival and half of the rule's, network by network, with hands and stiff ones."""
    ours, result = json.loads(found.attrs["study"])["ours"], []
    rivals = [law for law in found["law"].values.tolist() if bool(found["promises"].sel(law=law)) and law != ours]
    mean = found["cost"].sel(tuning="tuned", users=users).mean("draw")
    networks = found["network"].values.tolist()
    for hand, name in ((0, "hands"), (found.sizes["hand"] - 1, "stiff hands")):
        tasks = mean.isel(hand=hand)
        cells = tasks.mean("task")
        own, best = cells.sel(law=ours).values, cells.sel(law=rivals).min("law").values
        named = [rivals[int(which)] for which in cells.sel(law=rivals).argmin("law").values]
        half = 0.5 * cells.sel(law="rule").values
        lost = [
            f"{network}: {mine:.2f} (best rival {rival} {other:.2f}, half of the rule's {rule:.2f})"
            for network, mine, rival, other, rule in zip(networks, own, named, best, half, strict=True)
            if not mine <= min(other, rule)
        ]
        single = [
            f"{task} on {network} {float(tasks.sel(law=ours, task=task, network=network)):.2f} ({least:.2f})"
            for network in networks
            for task in found["task"].values.tolist()
            if float(tasks.sel(law=ours, task=task, network=network))
            > (least := float(tasks.sel(law=rivals, task=task, network=network).min()))
        ]
        what = f"{users} users, {name}: cells that {ours} loses"
        result.append(Row(section, what, "; ".join(lost) or "none", "none", f"of {own.size}"))
        beside = " / ".join(f"{other:.2f} {rival}" for other, rival in zip(best, named, strict=True))
        beside = f"best passive rival: {beside}; half of the rule's: {' / '.join(f'{rule:.2f}' for rule in half)}"
        result.append(
            Row(section, f"{users} users, {name}: {ours}", " / ".join(f"{mine:.2f}" for mine in own), "", beside)
        )
        what = f"{users} users, {name}: single tasks that {ours} loses (best passive rival)"
        result.append(Row(section, what, "; ".join(single) or "none"))
    return result


def _drag(found: "xr.Dataset", section: str, users: int) -> Row:
    ours = json.loads(found.attrs["study"])["ours"]
    felt = found["felt_drag"].sel(tuning="published", users=users, network="25 ms")
    own, rule = float(felt.sel(law=ours)), float(felt.sel(law="rule"))
    what = f"{users} users, 25 ms, 50 N/m: drag felt with {ours}, defaults"
    return Row(section, what, f"{own:.3f} Ns/m", "≤ 10 % of the rule's", f"{100 * own / rule:.1f} % of {rule:.2f}")


def _cell(cost: float, half: float, stiff: float) -> str:
    if np.isnan(cost):
        return "–"
    return f"{cost:.2f} ± {half:.2f} ({stiff:.1f})" if np.isfinite(cost) else "dangerous"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.laws", description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="folder for cells, results and report")
    parser.add_argument("--part", choices=list(PARTS), default="full", help="which study")
    parser.add_argument("--small", action="store_true", help="two users, four draws, a short search")
    parser.add_argument("--passive", action="store_true", help="only laws that promise something, and no map")
    parser.add_argument("--users", type=int, nargs="*", default=[], help="numbers of them")
    parser.add_argument("--draws", type=int, help="of each task")
    parser.add_argument("--jobs", type=int, default=-1, help="cells at once; -1: one per core")
    add_write(parser)
    options = parser.parse_args()
    asked = study(options.part, small=options.small, passive=options.passive, users=options.users, draws=options.draws)
    begun, worked = perf_counter(), process_time()
    found = run(asked, options.out, options.jobs)
    result = rows(found, options.part)
    if options.part == "ten":
        took, used = perf_counter() - begun, process_time() - worked
        what = "10 laws × 5 networks × 5 tasks × 20 draws, 129 settings of each law on each network"
        beside = f"CPU time / 2: {used / 120.0:.1f} min; load of the machine at the end {getloadavg()[0]:.1f}"
        result.insert(0, Row(SECTIONS_OF["ten"], what, f"{took / 60.0:.1f} min", "< 10 min on 2 cores", beside))
    finish(result, write=options.write)


if __name__ == "__main__":
    main()
