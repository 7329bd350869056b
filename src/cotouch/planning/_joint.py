"""Links and springs chosen together. **Beyond** the paper."""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, final

import numpy as np
import numpy.typing as npt

from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import flag, interruptible
from cotouch.network import Network, Pair
from cotouch.planning._deadline import until
from cotouch.planning._plan import Progress, plan
from cotouch.planning._result import Plan
from cotouch.planning._springs import Tuned, TuningInterrupted, tune_springs

# So many of the best choices have their springs tuned for a while, and the best of them to the end.
FIRST, _FOLLOWED = 20, 2
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


@final
class JointInterrupted(KeyboardInterrupt):
    """Links and springs were being chosen when that was interrupted from the keyboard.

    Attributes:
        joint: with the best found so far.
    """

    def __init__(self, joint: Joint) -> None:
        super().__init__("the choice of links and springs was interrupted")
        self.joint = joint


@interruptible
def plan_springs(
    network: Network,
    *,
    links: int,
    damping_limit: float,
    mass: npt.ArrayLike = 1.0,
    damping: npt.ArrayLike = 0.0,
    stiffness: npt.ArrayLike = 0.0,
    ranked: Plan | None = None,
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
        ranked: a plan by decay with the springs given, if there is one already; its `top` is what is tuned first.
        seconds: time budget, half of it for the links with the springs given if they are not; None for none.
        clock: seconds that only grow.
        progress: as in `plan`.
        **options: of `plan`, which limit the links.

    Raises:
        NetworkError: as in `plan`, or no choice can be brought within the limit.
        JointInterrupted: a `KeyboardInterrupt` that holds the best found by then.
    """
    begun, asked = clock(), flag()
    top = max(FIRST, int(options.pop("top", 1)))
    if ranked is None:
        half = None if seconds is None else 0.5 * seconds
        ranked = plan(
            network,
            links=links,
            objective="decay",
            mass=mass,
            damping=damping,
            stiffness=stiffness,
            top=top,
            seconds=half,
            clock=clock,
            progress=progress,
            **options,
        )
    present = network.spring[network.spring > 0]
    known: dict[tuple[Pair, ...], Tuned] = {}

    def keep(chosen: tuple[Pair, ...], found: Tuned) -> None:
        if chosen not in known or found.after < known[chosen].after:
            known[chosen] = found
        if progress is not None:
            progress(len(known), 0, min(one.after for one in known.values()))

    def tuned(start: Network, rounds: int, *, spread: bool = False) -> bool:
        """Tunes within the same bounds for every choice, from the springs as they are; answers whether it could."""
        try:
            found = tune_springs(
                start,
                damping_limit=damping_limit,
                rounds=rounds,
                spread=spread,
                lowest=float(present.min()) / _RANGE,
                highest=float(present.max()) * _RANGE,
                drag_limit=options.get("drag_limit"),
                mass=mass,
                damping=damping,
                stiffness=stiffness,
            )
        except TuningInterrupted as interrupted:
            keep(start.links, interrupted.tuned)
            raise
        except (NetworkError, UnsupportedError):
            return False
        keep(start.links, found)
        return True

    def ahead() -> list[tuple[Pair, ...]]:
        return sorted(known, key=lambda chosen: (known[chosen].after, chosen))

    def work() -> None:
        for choice in ranked.top:
            tuned(network.with_links(choice.links), _GLANCE)
        for chosen in ahead()[:_FOLLOWED]:
            tuned(network.with_links(chosen), _THOROUGH, spread=True)
        better = bool(known)
        while better:
            better, best = False, ahead()[0]
            # Links that stay keep the springs they have; one that comes begins with its own.
            for other in _swaps(known[best].network, best, needed, barred, options.get("max_degree")):
                if other not in known and tuned(known[best].network.with_links(other), _GLANCE):
                    better = known[other].after < known[best].after
                if better:
                    tuned(known[other].network, _THOROUGH, spread=True)
                    break

    barred = {tuple(sorted(pair)) for pair in options.get("forbid", ())}
    needed = {tuple(sorted(pair)) for pair in options.get("require", ())}
    try:
        with until(lambda: seconds is not None and clock() - begun >= seconds):
            work()
    except KeyboardInterrupt:  # also where only the time is up
        if asked[0] and not known:
            raise
    if not known:  # not even the first was begun, or none can be brought within the limit
        any(tuned(network.with_links(choice.links), 0) for choice in ranked.top)
    if not known:
        raise NetworkError(f"no choice of {links} links can meet damping_limit {damping_limit:g} Ns/m; raise it")
    best, places = ahead()[0], [choice.links for choice in ranked.top]
    joint = Joint(known[best], places.index(best) + 1 if best in places else None, len(known), ranked)
    if asked[0]:
        raise JointInterrupted(joint)
    return joint


def _swaps(
    network: Network, chosen: tuple[Pair, ...], needed: set[Pair], barred: set[Pair], most: int | None
) -> Iterator[tuple[Pair, ...]]:
    """Choices one link away that connect all users, quickest way first."""
    every = network.with_links(None).links
    coming = sorted(
        (pair for pair in every if pair not in chosen and pair not in barred),
        key=lambda pair: network.delay[pair] + network.delay[pair[::-1]],
    )
    for pair in coming:
        for gone in chosen:
            if gone in needed:
                continue
            links = tuple(sorted({*chosen, pair} - {gone}))
            graph = network.with_links(links)
            if graph.is_connected() and (most is None or np.max(graph.adjacency().sum(axis=1)) <= most):
                yield links
