"""Link laws side by side: the study of `examples/laws.toml`, and the table of docs/laws.md.

`python -m benchmarks.laws --out DIR` runs it, resumes it, and leaves report and results in the folder; `--small` takes
two users, four draws and a short search.
"""

import argparse
import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks._report import Row, add_write, finish
from cotouch.files import write_netcdf
from cotouch.laboratory import Study, compare, mean_cost, write_report

if TYPE_CHECKING:
    import xarray as xr

STUDY = Path(__file__).parents[1] / "examples" / "laws.toml"
SMALL: dict[str, Any] = {
    "users": [2],
    "draws": 4,
    "tuning": {"search": 16, "local": 16, "draws": 1, "safe": 0},
}
# What the one-axis prototype had for two users, by law and network; none found where a dash is.
PROTOTYPE = {
    "P": ("1.43", "2.90", "4.92", "3.03"),
    "pd": ("1.12", "2.10", "3.08", "2.20"),
    "rule": ("1.54", "2.67", "3.59", "3.20"),
    "once": ("1.13", "2.12", "3.08", "2.91"),
    "wave": ("0.19", "0.82", "2.69", "2.24"),
    "tdpa": ("–", "2.35", "3.98", "2.31"),
    "tank": ("1.06", "2.09", "3.08", "2.18"),
    "paid": ("0.01", "0.11", "1.18", "0.19"),
}


def study(*, small: bool) -> Study:
    """The study, or its small form."""
    whole = Study.read(STUDY)
    return Study.make(**{**whole.model_dump(), **SMALL}) if small else whole


def run(out: Path, *, small: bool) -> "xr.Dataset":
    """Runs the study, or takes up what is there, and writes report and results."""

    def progress(done: int, total: int, what: str) -> None:
        print(f"\r{what} {done}/{total} ", end="", file=sys.stderr, flush=True)

    found = compare(study(small=small), store=out / "cells", progress=progress)
    write_netcdf(found, out / "results.nc", "result")
    write_report(found, out / "report.html")
    return found


def rows(found: "xr.Dataset") -> list[Row]:
    """Rows of the table."""
    asked = json.loads(found.attrs["study"])
    networks, costs = found["network"].values.tolist(), mean_cost(found)
    stiff = mean_cost(found, hand=found.sizes["hand"] - 1)
    tuning = asked["tuning"]
    note = f"{asked['draws']} draws, {tuning['search']} + {tuning['local']} settings; J, 95 %; in brackets stiff hands"
    result = [Row("laws", "networks", " / ".join(networks), "", note)]
    for users in found["users"].values.tolist():
        for law in found["law"].values.tolist():
            cells = " / ".join(
                _cell(*costs[law, network, users], stiff[law, network, users][0]) for network in networks
            )
            known = PROTOTYPE.get(law) if users == 2 else None
            beside = "" if known is None else f"prototype: {' / '.join(known)}"
            result.append(Row("laws", f"{users} users: {law}", cells, "", beside))
    result += _challenge(found)
    for law in found["law"].values.tolist():
        made = float(found["made"].sel(law=law).max())
        goal = "0 J" if bool(found["promises"].sel(law=law)) else ""
        what = f"{law}: energy made beyond its seed, at most"
        result.append(Row("laws", what, f"{made:.2g} J", goal, "published, tuned and stiff hands"))
    return result


def _challenge(found: "xr.Dataset") -> list[Row]:
    """Our law beside the best passive rival and the rule, with hands and stiff ones; which single tasks it loses."""
    ours, result = json.loads(found.attrs["study"])["ours"], []
    passive = [law for law in found["law"].values.tolist() if bool(found["promises"].sel(law=law)) and law != ours]
    mean = found["cost"].sel(tuning="tuned").mean("draw")
    for users in found["users"].values.tolist():
        for hand, name in ((0, "hands"), (found.sizes["hand"] - 1, "stiff hands")):
            tasks = mean.sel(users=users).isel(hand=hand)
            cells, own = tasks.sel(law=passive).mean("task"), tasks.sel(law=ours).mean("task")
            won = int((own <= cells.min("law")).sum())
            half = int((own <= 0.5 * cells.sel(law="rule")).sum())
            lost = [
                f"{task} on {network} {float(tasks.sel(law=ours, task=task, network=network)):.2f} ({best:.2f})"
                for network in found["network"].values.tolist()
                for task in found["task"].values.tolist()
                if float(tasks.sel(law=ours, task=task, network=network))
                > (best := float(tasks.sel(law=passive, task=task, network=network).min()))
            ]
            tasks_lost = ", ".join(lost) or "none"
            beside = f"at most half of the rule's on {half}; of single tasks it loses (best rival): {tasks_lost}"
            what = f"{users} users, {name}: networks on which {ours} costs least of all passive laws"
            result.append(Row("laws", what, f"{won} of {own.size}", "all", beside))
        felt = found["felt_drag"].sel(tuning="published", users=users, network="25 ms")
        own, rule = float(felt.sel(law=ours)), float(felt.sel(law="rule"))
        what = f"{users} users, 25 ms, 50 N/m: drag felt with {ours}, defaults"
        result.append(
            Row("laws", what, f"{own:.3f} Ns/m", "≤ 10 % of the rule's", f"{100 * own / rule:.1f} % of {rule:.2f}")
        )
    return result


def _cell(cost: float, half: float, stiff: float) -> str:
    if np.isnan(cost):
        return "–"
    return f"{cost:.2f} ± {half:.2f} ({stiff:.1f})" if np.isfinite(cost) else "dangerous"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.laws", description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="folder for cells, results and report")
    parser.add_argument("--small", action="store_true", help="two users, four draws, a short search")
    add_write(parser)
    options = parser.parse_args()
    finish(rows(run(options.out, small=options.small)), write=options.write)


if __name__ == "__main__":
    main()
