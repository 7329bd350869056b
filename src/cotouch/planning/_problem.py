"""What a plan is asked for, checked once: one sentence for each thing that cannot be."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, TypeAlias, final, get_args

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float, Long
from cotouch.errors import NetworkError, UnsupportedError
from cotouch.interrupt import flag, heeding
from cotouch.network import (
    Convention,
    Network,
    Pair,
    Rounding,
    consensus_lags,
    link_damping,
    mixing,
    one_user,
    rightmost_root,
)
from cotouch.planning._modes import modes_table, own_drag
from cotouch.planning._task import CONSENSUS, DAMPING, DECAY, DRAG, FEEL, LOST_LINK, LOST_USER, NOTHING, Task
from cotouch.units import user_number

Objective: TypeAlias = Literal["consensus", "decay", "damping", "drag", "feel"]

Lost: TypeAlias = Literal["nothing", "link", "user"]

# Sums that differ by this share of a limit only in their order keep to it.
_ROUND_OFF = 1e-12
# Fourth powers of what follows from springs must be finite.
_STIFFEST = 1e30
# Delays longer than this are questioned [s].
_LONG = 5.0
_CODE = {"consensus": CONSENSUS, "decay": DECAY, "damping": DAMPING, "drag": DRAG, "feel": FEEL}
# Tones at which a hand feels the object [Hz]: what hands do, and what drag, mass and stiffness are read from.
_TONES = np.geomspace(0.2, 2.0, 6)
_LOST = {"nothing": NOTHING, "link": LOST_LINK, "user": LOST_USER}


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """A checked search.

    Attributes:
        network: users, springs, delays; every pair that may be linked is.
        objective: what is to be small.
        links: links of each choice.
        convention: of the consensus.
        time_unit: of the consensus, s.
        stride: time units of the grid that the consensus is worked out on, the factor that all lags share.
        rounding: of the consensus.
        task: the same for the kernels.
    """

    network: Network
    objective: Objective
    links: int
    convention: Convention
    time_unit: float
    rounding: Rounding
    task: Task
    stride: int = 1

    @property
    def choices(self) -> int:
        """How many choices of links there are, connected or not."""
        return math.comb(len(self.task.free), self.task.pick)

    def pairs(self, chosen: Long) -> tuple[Pair, ...]:
        """Users that a choice links."""
        return tuple(self.network.links[int(e)] for e in chosen)

    def reference(self, chosen: Long) -> float | None:
        """Consensus or decay of one choice as `rate` gives it, slowly; None if it cannot be told for certain either."""
        network, task = self.network.with_links(self.pairs(chosen)), self.task
        try:
            with heeding(task.stop):
                if self.objective == "consensus":
                    grid = self.time_unit * self.stride
                    found = mixing(network, time_unit=grid, convention=self.convention, rounding=self.rounding).value
                    return math.log(found) / grid if found > 0 else -math.inf
                return max(
                    rightmost_root(left, mass=m, damping=b, stiffness=k, sync_damping=sync).rate
                    for left, sync in self.left_by(network)
                    for m, b, k in task.modes.tolist()
                )
        except (UnsupportedError, KeyboardInterrupt):  # the latter would end one thread of many; who shares work looks
            return None

    def left_by(self, network: Network) -> Iterator[tuple[Network, Float | None]]:
        """The network, and what any loss leaves of it, with the synchronisation damping given."""
        sync = self.task.sync if self.task.sync.size else None
        yield network, sync
        if self.task.lost == LOST_LINK:
            for gone in network.links:
                yield network.with_links([link for link in network.links if link != gone]), sync
        if self.task.lost == LOST_USER:
            for user in range(network.size):
                rest = np.delete(np.arange(network.size), user)
                there = np.ix_(rest, rest)
                links = [(a - (a > user), b - (b > user)) for a, b in network.links if user not in (a, b)]
                yield (
                    Network(
                        users=[network.users[i] for i in rest],
                        spring=network.spring[there],
                        delay=network.delay[there],
                        links=links,
                    ),
                    None if sync is None else sync[rest],
                )


def make_problem(
    network: Network,
    *,
    links: int,
    objective: Objective = "consensus",
    convention: Convention = "equation",
    time_unit: float = 0.01,
    rounding: Rounding = "exact",
    require: Iterable[Sequence[int]] = (),
    forbid: Iterable[Sequence[int]] = (),
    max_degree: int | None = None,
    damping_limit: float | None = None,
    drag_limit: float | None = None,
    lost: Lost = "nothing",
    mass: npt.ArrayLike = 1.0,
    damping: npt.ArrayLike = 0.0,
    stiffness: npt.ArrayLike = 0.0,
    sync_damping: npt.ArrayLike | None = None,
) -> Problem:
    """Checks what `plan` is given, which explains the arguments.

    Args:
        network: as for `plan`, like all that follow.
        links: how many.
        objective: what is best.
        convention: of consensus.
        time_unit: of consensus, > 0 [s].
        rounding: of delays to time units.
        require: pairs that must be linked, users from 0.
        forbid: pairs that may not be.
        max_degree: most links of a user; None: any.
        damping_limit: most of any B_i of the rule [Ns/m]; None: any.
        drag_limit: most of all users' drag together [Ns/m]; None: any.
        lost: what may be lost: the objective is then the worst with any one of them gone.
        mass: of the body's modes, a number or one for each, > 0 [kg].
        damping: likewise, >= 0 [Ns/m].
        stiffness: likewise, >= 0 [N/m].
        sync_damping: of each user [Ns/m]; None: as the rule says.

    Raises:
        NetworkError: something asked for is impossible or contradicts another.
        UnsupportedError: decay or feel with springs that have weights.
    """
    if objective not in get_args(Objective):
        raise NetworkError(f'objective is "{objective}"; it must be "consensus", "decay", "damping", "drag" or "feel"')
    if network.size < 2:
        raise NetworkError("the network has 1 user; a plan needs at least 2")
    every = network.with_links(None)
    if lost not in get_args(Lost):
        raise NetworkError(f'lost is "{lost}"; it must be "nothing", "link" or "user"')
    if lost != "nothing" and objective == "consensus":
        raise NetworkError(f'lost is "{lost}" but objective is "consensus"; choose another objective')
    least = {"nothing": 2, "link": 3, "user": 4}[lost]
    if network.size < least:
        raise NetworkError(f'lost is "{lost}" but the network has {network.size} users; it takes at least {least}')
    for name, value in (("damping_limit", damping_limit), ("drag_limit", drag_limit)):
        if value is not None and not value > 0:
            raise NetworkError(f"{name} is {value:g} Ns/m; it must be above 0")
    sync = _sync(sync_damping, network.size)
    if sync.size and damping_limit is not None and sync.max() > damping_limit:
        raise NetworkError(
            f"sync_damping holds {sync.max():g} Ns/m but damping_limit is {damping_limit:g} Ns/m; lower one or "
            "raise the other"
        )
    needed, barred = (
        _pairs(network, name, pairs, spring)
        for name, pairs, spring in (("require", require, True), ("forbid", forbid, False))
    )
    for a, b in sorted(needed & barred):
        raise NetworkError(
            f"the link {_name(network, a, b)} is both in require and in forbid; remove it from one of them"
        )
    allowed = every.with_links([link for link in every.links if link not in barred])
    most = _most_degree(max_degree, allowed.size)
    _check_counts(allowed, links, needed, most, bool(barred))
    if objective in ("decay", "feel") and any(network.weight_of[i, j] >= 0 for i, j in allowed.links):
        raise UnsupportedError(
            f"springs have weights; the {objective} of one body mode needs scalar springs; use those of the mode"
        )
    heaviest = max(allowed.links, key=lambda link: allowed.spring[link])
    if allowed.spring[heaviest] > _STIFFEST:
        raise NetworkError(
            f"the spring {_name(network, *heaviest)} is {allowed.spring[heaviest]:g} N/m, with which the planner's "
            f"numbers overflow; it must be at most {_STIFFEST:g} N/m"
        )
    lags, stride = np.zeros((network.size, network.size), dtype=np.int64), 1
    if objective == "consensus":
        lags = consensus_lags(allowed, time_unit=time_unit, convention=convention, rounding=rounding)
        shared = int(np.gcd.reduce(lags[lags > 0]))
        # With a factor in all lags the model falls apart into as many that never meet. One of them says it all.
        stride = shared if convention == "equation" else 1
    return Problem(
        network=allowed,
        objective=objective,
        links=links,
        convention=convention,
        time_unit=time_unit,
        rounding=rounding,
        task=_task(
            allowed,
            objective,
            lags // stride,
            time_unit * stride,
            needed,
            links - len(needed),
            most,
            modes_table(mass, damping, stiffness),
            sync,
            limit=math.inf if damping_limit is None or sync.size else damping_limit * (1.0 + _ROUND_OFF),
            drag=math.inf if drag_limit is None else drag_limit * (1.0 + _ROUND_OFF),
            lost=_LOST[lost],
        ),
        stride=stride,
    )


def _task(
    network: Network,
    objective: Objective,
    lags: Long,
    time_unit: float,
    needed: set[Pair],
    pick: int,
    most: int,
    modes: Float,
    sync: Float,
    *,
    limit: float,
    drag: float,
    lost: int,
) -> Task:
    first, second = (np.array([link[end] for link in network.links], dtype=np.int64) for end in (0, 1))
    spring = np.ascontiguousarray(network.spring[first, second])
    delay = network.delay
    within: Float = (lags * time_unit if objective == "consensus" else delay).astype(np.float64)
    required = np.array([link in needed for link in network.links], dtype=np.bool_)
    return Task(
        size=network.size,
        objective=_CODE[objective],
        first=first,
        second=second,
        spring=spring,
        to_first=np.ascontiguousarray(within[first, second]),
        to_second=np.ascontiguousarray(within[second, first]),
        lag_first=np.ascontiguousarray(lags[first, second]),
        lag_second=np.ascontiguousarray(lags[second, first]),
        load=link_damping(spring, delay[first, second] + delay[second, first]),
        require=np.flatnonzero(required),
        free=np.flatnonzero(~required),
        pick=pick,
        most=most,
        modes=modes,
        own_drag=own_drag(modes),
        sync=sync,
        limit=limit,
        drag=drag,
        lost=lost,
        top=math.pi / time_unit if objective == "consensus" else math.inf,
        tones=2.0 * np.pi * _TONES,
        stop=flag(),
    )


def questions(problem: Problem) -> tuple[str, ...]:
    """What looks like a mistake."""
    network, notes = problem.network, ()
    if problem.stride > 1:
        notes = (
            f"All delays are multiples of {problem.stride} time units: the consensus is worked out on a grid of "
            f"{problem.stride * problem.time_unit:g} s, for on the finer one it would never mix.",
        )
    worst = max(((float(network.delay[pair]), pair) for a, b in network.links for pair in ((a, b), (b, a))))
    if worst[0] <= _LONG:
        return notes
    seconds, (i, j) = worst
    return (
        *notes,
        f"The delay from {one_user(network.users, j)} to {one_user(network.users, i)} is {seconds:g} s; delays are in "
        "seconds: is it right?",
    )


def impossible(problem: Problem) -> NetworkError:
    """That no choice keeps to the limits."""
    task = problem.task
    limits = ["require", "forbid", "max_degree"]
    limits += ["damping_limit"] * math.isfinite(task.limit) + ["drag_limit"] * math.isfinite(task.drag)
    limits += ["lost"] * (task.lost != NOTHING)
    return NetworkError(
        f"no choice of {problem.links} links connects all {task.size} users within {', '.join(limits[:-1])} and "
        f"{limits[-1]}; relax one of them"
    )


def _name(network: Network, a: int, b: int) -> str:
    return f"{network.users[a]}-{network.users[b]}"


def _pairs(network: Network, option: str, pairs: Iterable[Sequence[int]], spring: bool) -> set[Pair]:
    result: set[Pair] = set()
    for pair in pairs:
        a, b = sorted(int(end) for end in pair) if len(pair) == 2 else (-1, -1)
        if not 0 <= a < b < network.size:
            shown = "-".join(str(user_number(int(end))) for end in pair)
            raise NetworkError(
                f"{option} holds {shown}; a link is a pair of different users, numbered 1 to {network.size}"
            )
        if spring and network.spring[a, b] <= 0:
            raise NetworkError(
                f"{option} holds {_name(network, a, b)}, whose spring is 0 N/m; give the pair a spring above 0"
            )
        result.add((a, b))
    return result


def _most_degree(max_degree: int | None, size: int) -> int:
    if max_degree is None:
        return size - 1
    least = 1 if size == 2 else 2
    if max_degree < least:
        raise NetworkError(f"max_degree is {max_degree}; to connect {size} users it must be at least {least}")
    return min(max_degree, size - 1)


def _check_counts(network: Network, links: int, needed: set[Pair], most: int, barred: bool) -> None:
    possible, least = len(network.links), network.size - 1
    if not network.is_connected():
        cause = "spring and forbid leave" if barred else "spring leaves"
        remedy = "forbid fewer links" if barred else "give more pairs a spring above 0"
        raise NetworkError(f"{cause} the users in separate groups, whichever links are chosen; {remedy}")
    if not least <= links <= possible:
        raise NetworkError(
            f"links is {links}; to connect {network.size} users with {possible} possible links it must be "
            f"{least} to {possible}"
        )
    if len(needed) > links:
        raise NetworkError(f"require holds {len(needed)} links but links is {links}; ask for at least {len(needed)}")
    degree = np.zeros(network.size, dtype=np.int64)
    for a, b in needed:
        degree[[a, b]] += 1
    for i in map(int, np.flatnonzero(degree > most)):
        raise NetworkError(
            f"require gives {one_user(network.users, i)} {degree[i]} links but max_degree is {most}; it must be at "
            f"least {degree[i]}"
        )
    if 2 * links > network.size * most:
        raise NetworkError(
            f"links is {links}; with max_degree {most} the {network.size} users have at most {network.size * most // 2}"
        )


def _sync(sync_damping: npt.ArrayLike | None, size: int) -> Float:
    if sync_damping is None:
        return np.zeros(0)
    array = np.array(sync_damping, dtype=np.float64)
    if array.shape != (size,):
        raise NetworkError(f"sync_damping has shape {array.shape}; it must be ({size},), one for each user")
    if not np.all(np.isfinite(array) & (array >= 0)):
        raise NetworkError("sync_damping has an entry that is not finite or below 0; each must be at least 0 Ns/m")
    return array
