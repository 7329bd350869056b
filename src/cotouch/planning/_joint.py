"""Links and springs chosen together. **Beyond** the paper."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, final

import numpy as np
import numpy.typing as npt

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import interruptible
from cotouch.network import Network, Pair
from cotouch.planning._plan import Progress, plan
from cotouch.planning._result import Plan
from cotouch.planning._springs import Tuned, tune_springs

# So many of the best choices have their springs tuned for a while, and the best of them to the end.
_FIRST, _FOLLOWED = 20, 2
# Linear programs in a row for the one and the other.
_GLANCE, _THOROUGH = 8, 60
# Bounds of all springs, as a share of the softest and the stiffest that is given.
_RANGE = 10.0


@final
@dataclass(frozen=True, eq=False)
class Joint:
    """Links and springs chosen together.

    Attributes:
        tuned: the best choice with its springs.
        rank: its place among the choices with the springs given, from 1; None if it came from a swap.
        tried: how many choices had their springs tuned.
        plan: the choices with the springs given.
    """

    tuned: Tuned
    rank: int | None
    tried: int
    plan: Plan


@interruptible
def plan_springs(
    network: Network,
    *,
    links: int,
    damping_limit: float,
    mass: npt.ArrayLike = 1.0,
    damping: npt.ArrayLike = 0.0,
    stiffness: npt.ArrayLike = 0.0,
    seconds: float | None = None,
    clock: Callable[[], float] = time.monotonic,
    progress: Progress | None = None,
    **options: Any,
) -> Joint:
    """Finds the links, and springs on them, that come to rest soonest within a limit on every user's damping.

    Which links are best depends on their springs, so the first of a ranking with the springs given need not be the
    first once they are tuned. The best twenty are tuned for a while, the best of these to the end; then links of the
    best are swapped for others as long as that helps. The result is the best found; nothing is proved of the rest.

    Args:
        network: as in `plan`; its springs are where tuning starts, and their bounds are as in `tune_springs`.
        links: how many.
        damping_limit: Ns/m, of every user.
        mass: as in `plan`.
        damping: likewise.
        stiffness: likewise.
        seconds: time budget, half of it for the links with the springs given; None for none.
        clock: seconds that only grow.
        progress: as in `plan`.
        **options: of `plan`, which limit the links.

    Raises:
        NetworkError: as in `plan`, or no choice can be brought within the limit.
    """
    begun = clock()
    body = {"mass": mass, "damping": damping, "stiffness": stiffness}
    ranked = plan(
        network,
        links=links,
        objective="decay",
        top=max(_FIRST, int(options.pop("top", 1))),
        seconds=None if seconds is None else 0.5 * seconds,
        clock=clock,
        progress=progress,
        **body,
        **options,
    )
    least, most = _springs(network)
    known: dict[tuple[Pair, ...], Tuned] = {}

    def late() -> bool:
        return bool(known) and seconds is not None and clock() - begun >= seconds

    def tuned(start: Network, *, thorough: bool) -> Tuned | None:
        """Tuned within the same bounds for every choice; thoroughly, or for a while from the springs as they are."""
        try:
            found = tune_springs(
                start,
                damping_limit=damping_limit,
                rounds=_THOROUGH if thorough else _GLANCE,
                spread=thorough,
                lowest=least / _RANGE,
                highest=most * _RANGE,
                **body,
            )
        except (NetworkError, UnsupportedError):
            return None
        if start.links not in known or found.after < known[start.links].after:
            known[start.links] = found
        if progress is not None:
            progress(len(known), 0, min(one.after for one in known.values()))
        return found

    def ahead() -> list[tuple[Pair, ...]]:
        return sorted(known, key=lambda chosen: (known[chosen].after, chosen))

    for thorough, choices in ((False, [choice.links for choice in ranked.top]), (True, None)):
        for chosen in ahead()[:_FOLLOWED] if choices is None else choices:
            if late():
                break
            tuned(network.with_links(chosen), thorough=thorough)
    if not known:
        raise NetworkError(
            f"no choice of {links} links can be brought within damping_limit {damping_limit:g} Ns/m; raise it"
        )
    barred = {tuple(sorted(pair)) for pair in options.get("forbid", ())}
    needed = {tuple(sorted(pair)) for pair in options.get("require", ())}
    best, better = ahead()[0], True
    while better and not late():
        better = False
        # Links that stay keep the springs they have; one that comes begins with its own.
        for other in _swaps(known[best].network, best, needed, barred, options.get("max_degree")):
            if late():
                break
            if other not in known and tuned(known[best].network.with_links(other), thorough=False) is not None:
                better = known[other].after < known[best].after
            if better:
                tuned(known[other].network, thorough=True)
                best = other
                break
    places = [choice.links for choice in ranked.top]
    return Joint(known[best], places.index(best) + 1 if best in places else None, len(known), ranked)


def _springs(network: Network) -> tuple[float, float]:
    present = network.spring[network.spring > 0]
    return float(present.min()), float(present.max())


def _swaps(
    network: Network, chosen: tuple[Pair, ...], needed: set[Any], barred: set[Any], most: int | None
) -> list[tuple[Pair, ...]]:
    """Choices one link away that connect all users, quickest way first."""
    every = network.with_links(None).links
    coming = sorted(
        (pair for pair in every if pair not in chosen and pair not in barred),
        key=lambda pair: network.delay[pair] + network.delay[pair[::-1]],
    )
    result: list[tuple[Pair, ...]] = []
    for pair in coming:
        for gone in chosen:
            if gone in needed:
                continue
            links = tuple(sorted({*chosen, pair} - {gone}))
            graph = network.with_links(links)
            if graph.is_connected() and (most is None or np.max(graph.adjacency().sum(axis=1)) <= most):
                result.append(links)
    return result
