"""Packets a second against cost, for every law and deadband: `python -m benchmarks.codec`.

`--draws` of each task, `--deadbands` for fewer of them. Two users at 25 ms, and with one deadband at 25 + exp(10) ms
with 5 % loss; laws with their defaults, the five tasks of the comparison. A run goes message by message, so it takes
minutes.
"""

import argparse
import sys
from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks._report import Row, add_write, finish
from cotouch.laboratory import Study
from cotouch.laboratory._compare import drawn
from cotouch.laboratory._ideal import ideal
from cotouch.laboratory._score import measures_of
from cotouch.simulation import with_hands

DEADBANDS, USUAL = (0.0, 0.05, 0.1, 0.2, 0.27), 0.1
QUANTUM, PERIOD = 1e-5, 2e-3
LAWS: list[Any] = [{"name": "rule", "law": "spring"}, "pd", "once", "wave", "tdpa", "tank", "pspm", "paid"]
NETWORKS: dict[str, dict[str, Any]] = {
    "25 ms": {},
    "25 + exp(10) ms, 5 % loss": {"jitter": {"kind": "exponential", "scale": 0.01}, "loss": 0.05},
}


def run(draws: int, deadbands: Sequence[float] = DEADBANDS) -> list[Row]:
    """Rows of the table.

    Args:
        draws: of each task and channel.
        deadbands: that are tried.
    """
    rows: list[Row] = []
    for name, channel in NETWORKS.items():
        for law in LAWS:
            cells: list[str] = []
            beside: list[str] = []
            for deadband in (None, *(deadbands if not channel else (USUAL,))):
                codec = {} if deadband is None else {"codec": {"deadband": deadband, "quantum": QUANTUM}}
                study = Study.make(
                    laws=[law],
                    networks=[{"name": name, "delay": 0.025, "channel": channel | codec}],
                    duration=4.0,
                    period=PERIOD,
                )
                found = _measures(study, draws)
                what = "all in full" if deadband is None else f"{deadband:g}"
                cells.append(f"{what}: {found['cost']:.2f} at {found['packets']:.0f}/s")
                if deadband in {None, USUAL}:
                    beside.append(
                        f"{what}: {found['bandwidth'] / 1e3:.3g} kB/s, PSNR {found['psnr']:.1f} and HPW-PSNR "
                        f"{found['hpw_psnr']:.1f} dB, ETVO {1e3 * found['late']:.0f} ms and "
                        f"{1e3 * found['off']:.1f} mm, made {found['made']:.1g} J"
                    )
                print(name, law, cells[-1], beside[-1], file=sys.stderr, flush=True)
            label = law if isinstance(law, str) else law["name"]
            rows.append(Row("codec", f"{label}, {name}", "; ".join(cells), "", "; ".join(beside)))
    note = f"deadband: cost at packets a second to a neighbour; quantum {QUANTUM:g}, five tasks, draws: {draws}, 500 Hz"
    return [Row("codec", "two users, laws with their defaults", note), *rows]


def _measures(study: Study, draws: int) -> dict[str, float]:
    """Means over tasks and draws; of what is made, the most."""
    found: list[dict[str, float]] = []
    for draw in range(draws):
        prepared = drawn(study, draw, {})
        for task in study.tasks:
            hands = study.task(task, study.users[0], study.hands[0], draw)
            found.append(measures_of(study.laws[0], with_hands(prepared, hands), ideal(study, hands)))
    result = {name: float(np.mean([one[name] for one in found])) for name in found[0]}
    return result | {"made": max(one["made"] for one in found)}


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.codec", description=__doc__)
    parser.add_argument("--draws", type=int, default=2, help="of each task and channel (2)")
    parser.add_argument("--deadbands", type=float, nargs="+", default=list(DEADBANDS), help="that are tried")
    add_write(parser)
    options = parser.parse_args()
    finish(run(options.draws, options.deadbands), write=options.write)


if __name__ == "__main__":
    main()
