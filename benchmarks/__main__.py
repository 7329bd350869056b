"""`python -m benchmarks`: all of them, one table."""

import argparse

from rich.console import Console

from benchmarks import (
    attack,
    bodies,
    engine,
    fuzz,
    live,
    materials,
    members,
    page,
    planner,
    record,
    recording,
    scaling,
    servo,
    step,
    touch,
)
from benchmarks._report import Row, add_write, finish


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("--count", type=int, default=record.SHORT, help="random scenarios (10,000 for the record)")
    add_write(parser)
    planner.add_long(parser)
    options = parser.parse_args()
    rows: list[Row] = []
    with Console(stderr=True).status("") as status:
        for name, measure in (
            ("engine", engine.measure),
            ("step", step.measure),
            ("scaling", lambda: scaling.measure(draw=options.write)),
            ("touch", touch.measure),
            ("materials", materials.measure),
            ("bodies", bodies.measure),
            ("planner", lambda: planner.measure(long=options.long)),
            ("live", live.measure),
            ("members", members.measure),
            ("servo", servo.measure),
            ("page", page.measure),
            ("recording", recording.measure),
            ("record", lambda: record.measure(options.count)),
            ("attack", attack.measure),
            ("fuzz", fuzz.measure),
        ):
            status.update(f"{name} ...")
            rows += measure()
    finish(rows, write=options.write)


if __name__ == "__main__":
    main()
