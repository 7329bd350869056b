"""A member that lies with all keys of its own: a search for what harms the honest ones most, in a virtual session.

`python -m benchmarks.attack --count 2100 --workers 2 --write`. Half of the lies are random, half near the worst so far.
"""

import argparse
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor

import numpy as np
from tests.members.attack import ALLOWANCE, BURST, FORCE, GOALS, POWER, SECONDS, SEED, TANK, Search

from benchmarks._report import Row, add_write, finish

SHORT = 60
_WORDS = {
    "gain": ("energy that honest copies and hands gained, worst, of what they may", "≤ 1"),
    "work": ("work of the liar's link on an honest copy, worst, of what the power limit allows", "≤ 1"),
    "received": ("energy believed that the liar says it gave, worst, of what the power limit allows", "≤ 1"),
    "credit": ("what tanks were credited, worst, of what the damping took", "≤ 1"),
    "damping": ("damping of an honest copy, worst, of what the limit of its budgets gives", "≤ 1"),
    "apart": ("time in which the two honest ones were not coupled, worst", ""),
    "speed": ("speed of a node of an honest copy, worst", ""),
}


def measure(count: int = SHORT, seed: int = 1, workers: int = 1) -> list[Row]:
    """Tries so many lies.

    Args:
        count: how many.
        seed: of the first search.
        workers: processes, each with a search of its own.
    """
    fraction = -(-count // workers)
    if workers == 1:
        return rows([searched(seed, fraction)])
    with ProcessPoolExecutor(workers) as pool:
        return rows(list(pool.map(searched, range(seed, seed + workers), [fraction] * workers)))


def searched(seed: int, count: int) -> Search:
    """A search of so many lies."""
    search = Search(np.random.default_rng(seed))
    for _ in search.run(count):
        pass
    return search


def rows(searches: Sequence[Search]) -> list[Row]:
    """What the searches found."""
    broken = [text for search in searches for _, outcome in search.broken for text in outcome.broken]
    limits = (
        f"initial energy {SEED} J, allowance {ALLOWANCE} J, tank {TANK} J, {POWER} W and {BURST} J at once, "
        f"{FORCE:.0f} N; {SECONDS} s each"
    )
    made = [
        ("lies tried", f"{sum(search.tried for search in searches):,}", "", limits),
        (
            "lies that did what may not be",
            f"{sum(len(search.broken) for search in searches):,}",
            "0",
            "; ".join(broken)[:300],
        ),
        ("of these: crashed somebody", str(sum("crashed" in text for text in broken)), "0", ""),
        ("of these: took a slot", str(sum("place" in text for text in broken)), "0", ""),
    ]
    for goal in GOALS:
        value, lie = max((search.best[goal][0] for search in searches), key=lambda entry: entry[0])
        words, bound = _WORDS[goal]
        shown = {"apart": f"{100.0 * value:.0f} %", "speed": f"{value:.2f} m/s"}.get(goal, f"{value:.2f}")
        made.append((words, shown, bound, f"says it is at: {lie.law}; talk: {', '.join(lie.talk) or 'none'}"))
    return [Row("attack", *row) for row in made]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=SHORT, help="lies (2,100 for the record)")
    parser.add_argument("--seed", type=int, default=1, help="of the search")
    parser.add_argument("--workers", type=int, default=1, help="processes")
    add_write(parser)
    options = parser.parse_args()
    finish(measure(options.count, options.seed, options.workers), write=options.write)


if __name__ == "__main__":
    main()
