"""How many links: the best choice for each number of them, and where more stop paying."""

import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Unpack, final

import numpy as np

from cotouch.errors import NetworkError
from cotouch.interrupt import interruptible
from cotouch.network import Network
from cotouch.planning._options import PlanOptions
from cotouch.planning._plan import PlanInterrupted, Progress, plan
from cotouch.planning._result import Plan

# The knee is the smallest number of links within so much of the best.
_WITHIN = 0.1


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class LinkCounts:
    """Plans for several numbers of links.

    Attributes:
        plans: of each number that can be, in ascending order.
        best: the plan whose best choice is best of all; of equals the one with the fewest links.
        knee: the plan with the fewest links that comes within 10 % of the best: of the rate, of the largest damping,
            or of the logarithm of a consensus's |eigenvalue|.
    """

    plans: tuple[Plan, ...]
    best: Plan
    knee: Plan

    def numbers(self) -> dict[str, object]:
        """For JSON: the best plan, with what the other numbers of links give."""
        return self.best.numbers() | {
            "knee": len(self.knee.best.links),
            "counts": [
                {
                    "links": len(one.best.links),
                    "value": one.best.value,
                    "largest_damping": float(one.best.damping.max()),
                    "drag": one.best.drag,
                    "status": one.status,
                }
                for one in self.plans
            ],
        }


class CountsInterrupted(PlanInterrupted):
    """Plans for several numbers of links were interrupted from the keyboard after something was found.

    Attributes:
        counts: what there is; of the number under way the best found so far.
    """

    def __init__(self, counts: LinkCounts) -> None:
        super().__init__(counts.best)
        self.counts = counts


@interruptible
def plan_counts(
    network: Network,
    *,
    links: Iterable[int],
    seconds: float | None = None,
    clock: Callable[[], float] = time.monotonic,
    progress: Progress | None = None,
    **options: Unpack[PlanOptions],
) -> LinkCounts:
    """Plans with each of several numbers of links. **Beyond** the paper, which is given one.

    More links bring users together by more ways, but the rule makes each of them cost damping: on the paper's users
    five links come to rest at 5.1 1/s, six at 1.43.

    Args:
        network: as in `plan`.
        links: numbers of links; those that cannot be are left out.
        seconds: time budget of all of them together.
        clock: seconds that only grow.
        progress: as in `plan`.
        **options: of `plan`.

    Raises:
        NetworkError: none of the numbers can be, or as `plan` raises it.
        CountsInterrupted: with what was found by then.
    """
    counts = sorted(set(links))
    if not counts:
        raise NetworkError("no number of links is given; give at least one")
    begun = clock()
    plans: list[Plan] = []
    refused: NetworkError | None = None
    for place, count in enumerate(counts):
        left = None if seconds is None else max((seconds - clock() + begun) / (len(counts) - place), 1e-3)
        try:
            more: PlanOptions = {"begin": plans[-1].best.links if plans else (), **options}
            plans.append(plan(network, links=count, seconds=left, clock=clock, progress=progress, **more))
        except NetworkError as error:
            refused = refused or error
        except PlanInterrupted as interrupted:
            raise CountsInterrupted(_counts([*plans, interrupted.plan])) from None
        except KeyboardInterrupt:
            if not plans:
                raise
            raise CountsInterrupted(_counts(plans)) from None
    if not plans:
        raise refused or NetworkError("no number of links can be")
    return _counts(plans)


def _counts(plans: list[Plan]) -> LinkCounts:
    best = min(plans, key=lambda one: one.best.value)
    return LinkCounts(plans=tuple(plans), best=best, knee=next(one for one in plans if _near(one, best)))


def _near(one: Plan, best: Plan) -> bool:
    """Whether a plan is the best or comes near it."""
    here, there = (float(np.log(p.best.value)) if p.objective == "consensus" else p.best.value for p in (one, best))
    return one is best or here <= there + _WITHIN * abs(there)
