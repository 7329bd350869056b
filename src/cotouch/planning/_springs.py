"""Spring constants that let the closed loop of given links come to rest soonest. **Beyond** the paper."""

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.errors import NetworkError
from cotouch.interrupt import flag, interruptible
from cotouch.network import Network, closed_loop, one_user
from cotouch.planning._deadline import until
from cotouch.planning._modes import modes_table
from cotouch.planning._spring_search import Search

# Default bounds, as shares of the softest and the stiffest spring in use at the start.
_RANGE = 10.0


@final
@dataclass(frozen=True, eq=False)
class Tuned:
    """A network whose springs were tuned.

    Attributes:
        network: with the new springs.
        before: 1/s, rate of the slowest mode at the feasible start; negative when the loop comes to rest.
        after: 1/s, the same with the new springs; never above `before`.
        sync_damping: (N,) Ns/m, the rule's `B_i` with the new springs.
        start_factor: by which all springs were multiplied first, because they broke the limit; 1 where they held it.
        rounds: linear programs in a row from all starts, each with its step taken or refused.
        mode: (3,) mass [kg], damping [Ns/m] and stiffness [N/m] of the object's mode that is slowest at the end.
    """

    network: Network
    before: float
    after: float
    sync_damping: Float
    start_factor: float
    rounds: int
    mode: Float


@final
class TuningInterrupted(KeyboardInterrupt):
    """A tuning was interrupted from the keyboard after it had begun.

    Attributes:
        tuned: with the best springs found so far.
    """

    def __init__(self, tuned: Tuned) -> None:
        super().__init__("the tuning was interrupted")
        self.tuned = tuned


@interruptible
def tune_springs(
    network: Network,
    *,
    damping_limit: float | Sequence[float] | Float,
    mass: npt.ArrayLike = 1.0,
    damping: npt.ArrayLike = 0.0,
    stiffness: npt.ArrayLike = 0.0,
    lowest: float | None = None,
    highest: float | None = None,
    drag_limit: float | None = None,
    rounds: int = 200,
    spread: bool = True,
    seconds: float | None = None,
    clock: Callable[[], float] = time.monotonic,
) -> Tuned:
    """Springs on the links in use that lower the rate of the slowest mode, within a limit on every user's damping.

    The damping is the rule's with the delays as ages, `B_i = sum_j K_ij (d_ij + d_ji)/2`, so the limit is linear in the
    springs and holds at every step. A step counts only if the rightmost root, counted for certain, really moves left:
    the result is never worse than the start. Springs spread evenly over the bounds (in logarithms) are tried as well,
    and the best of them are followed like the start. The result is a local optimum; the same input gives the same
    result.

    Args:
        network: connected; springs without weights. Those that are not linked keep their springs.
        damping_limit: Ns/m above 0, one or (N,). A start that breaks it has all its springs scaled down into it first.
        mass: kg of the whole object, or of each of its modes, the slowest of which counts; above 0.
        damping: Ns/m, likewise, at least 0.
        stiffness: N/m, likewise, at least 0.
        lowest: N/m, the softest spring allowed; None takes a tenth of the softest at the (feasible) start.
        highest: N/m, the stiffest spring allowed; None takes ten times the stiffest at the start.
        drag_limit: Ns/m above the object's own damping, what all users together may feel as they move the object
            steadily (`Choice.drag`); treated like the limit on damping.
        rounds: most linear programs in a row from any start; 0 only makes the start feasible.
        spread: whether to try other starts than the present springs.
        seconds: time budget, after which the best found so far is returned; None for none.
        clock: seconds that only grow.

    Raises:
        NetworkError: not connected, a parameter out of its range, or a limit that the start cannot be scaled into
            within the bounds.
        UnsupportedError: springs with weights, or roots too crowded to count.
        TuningInterrupted: a `KeyboardInterrupt` that holds the best found by then.
    """
    begun, asked = clock(), flag()
    if rounds < 0:
        raise NetworkError(f"rounds is {rounds}; it must be a whole number, at least 0")
    if seconds is not None and not seconds > 0:
        raise NetworkError(f"the time limit (seconds) is {seconds:g}; it must be above 0")
    limit = _limits(network, damping_limit)
    modes = modes_table(mass, damping, stiffness)
    first = modes[0]
    closed_loop(network, float(first[0]), float(first[1]), float(first[2]), None)  # checks the network
    search = Search(network, limit, modes, drag_limit)
    given = search.springs_of(network)
    factor = min(1.0, float(search.room(given)))
    start = given * factor if factor < 1.0 else given
    low, high = _bounds(network, start, lowest, highest, factor)
    search.low, search.high = low, high
    first_decay = search.at(start)
    # Not for one user, nor where nothing dissipates and the translation itself is what is slowest.
    if rounds and network.links and first_decay.root != 0:
        try:
            with until(lambda: seconds is not None and clock() - begun >= seconds):
                for begin in [(first_decay, start), *(search.spread() if spread else [])]:
                    search.improve(begin, rounds)
        except KeyboardInterrupt:  # also where only the time is up
            pass
    decay, springs, mode = search.best
    tuned = Tuned(
        network=search.network_of(springs),
        before=first_decay.rate,
        after=decay.rate,
        sync_damping=decay.sync_damping,
        start_factor=factor,
        rounds=search.rounds,
        mode=mode,
    )
    if asked[0]:
        raise TuningInterrupted(tuned)
    return tuned


def _limits(network: Network, damping_limit: float | Sequence[float] | Float) -> Float:
    try:
        limit = np.array(damping_limit, dtype=np.float64)
    except (TypeError, ValueError):
        raise NetworkError(
            f"damping_limit is {damping_limit!r}; it must be a number, or one for each user (Ns/m)"
        ) from None
    if limit.ndim and limit.shape != (network.size,):
        raise NetworkError(
            f"damping_limit has shape {limit.shape}; it must be one number or ({network.size},), one for each user"
        )
    if not limit.ndim and not (np.isfinite(limit) and limit > 0):
        raise NetworkError(f"damping_limit is {limit:g} Ns/m; it must be finite and above 0")
    limit = np.broadcast_to(limit, (network.size,)).copy()
    for i in map(int, np.flatnonzero(~(np.isfinite(limit) & (limit > 0)))):
        raise NetworkError(
            f"damping_limit of {one_user(network.users, i)} is {limit[i]:g} Ns/m; it must be finite and above 0"
        )
    return limit


def _bounds(
    network: Network, start: Float, lowest: float | None, highest: float | None, factor: float
) -> tuple[float, float]:
    for name, value in (("lowest", lowest), ("highest", highest)):
        if value is not None and not (math.isfinite(value) and value > 0):
            raise NetworkError(f"{name} is {value:g} N/m; it must be finite and above 0")
    if lowest is not None and highest is not None and lowest > highest:
        raise NetworkError(f"lowest is {lowest:g} N/m and highest is {highest:g} N/m; lowest must not be above highest")
    least, most = (float(start.min()), float(start.max())) if len(start) else (1.0, 1.0)
    scaled = f", scaled by {factor:.3g} into the limit on damping," if factor < 1.0 else ""
    for name, bound, here, out in (("lowest", lowest, least, -1), ("highest", highest, most, 1)):
        if bound is not None and out * (here - bound) > 1e-9 * bound:
            link = network.links[int(np.argmin(start) if out < 0 else np.argmax(start))]
            raise NetworkError(
                f"spring between users {link[0] + 1} and {link[1] + 1}{scaled} is {here:g} N/m, and {name} is "
                f"{bound:g} N/m; start within the bounds or widen them"
            )
    return (least / _RANGE if lowest is None else lowest, most * _RANGE if highest is None else highest)
