"""Choosing the links of those who are there, beside everything else that the host does."""

from concurrent.futures import Future, ThreadPoolExecutor
from typing import final

import numpy as np
import numpy.typing as npt

from cotouch.errors import CotouchError, UnsupportedError
from cotouch.network import Network
from cotouch.planning import Objective, Plan, modes_of, plan
from cotouch.session._file import SessionFile
from cotouch.session._links import Pair, delays_of

# Time budget of one search; what is found by then counts [s].
_SECONDS = 5.0
# The consensus model works on a grid of this [s].
_TIME_UNIT = 0.001


@final
class LinkPlanner:
    """A `Planner` that works in a thread: asked again and again, it answers when it has found something."""

    def __init__(self, session: SessionFile) -> None:
        """Prepares to plan.

        Args:
            session: with its objective and number of links.
        """
        self._session = session
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="cotouch planner")
        self._work: tuple[list[int], Future[list[Pair]]] | None = None

    def __call__(self, seats: list[int], paths: dict[Pair, float]) -> list[Pair] | None:
        """The links, or None while it is still at work.

        Args:
            seats: who is there.
            paths: times there and back that were measured [s].
        """
        if self._work is None or self._work[0] != seats:
            self._work = (list(seats), self._pool.submit(self._plan, list(seats), dict(paths)))
        work = self._work[1]
        if not work.done():
            return None
        self._work = None
        return work.result()

    def close(self) -> None:
        """Lets go of the thread; a search that is going on is not waited for."""
        self._pool.shutdown(wait=False, cancel_futures=True)

    def _plan(self, seats: list[int], paths: dict[Pair, float]) -> list[Pair]:
        whole, options = self._session.scenario.network, self._session.options
        delay = delays_of(whole, paths)
        there = np.ix_(seats, seats)
        network = Network(
            users=[whole.users[seat] for seat in seats], spring=whole.spring[there], delay=delay[there], links=[]
        )
        modes = _modes(self._session) if options.objective == "decay" else {}
        try:
            found = _search(network, self._session.link_count(len(seats)), options.objective, modes)
        except CotouchError:  # springs that cannot join all, say: what is given is kept
            return [(a, b) for a, b in whole.links if a in seats and b in seats]
        return sorted((seats[a], seats[b]) for a, b in found.best.links)


def notable_links(session: SessionFile) -> dict[str, list[Pair]]:
    """The links that a session starts with, and the best and the worst as many, by its delays; takes its time.

    Args:
        session: with two or more users.

    Returns:
        Pairs of seats, by "start", "best", "worst"; without the last two where nothing was found.
    """
    network = session.scenario.network
    choices = {"start": sorted((int(a), int(b)) for a, b in network.links)}
    modes = _modes(session)
    try:
        found = _search(network, len(choices["start"]), "decay", modes)
    except CotouchError:
        return choices
    return choices | {"best": sorted(found.best.links), "worst": sorted(found.worst.links)}


def _search(network: Network, links: int, objective: Objective, modes: dict[str, npt.NDArray[np.float64]]) -> Plan:
    return plan(
        network,
        links=links,
        objective=objective,
        time_unit=_TIME_UNIT,
        rounding="nearest",
        seconds=_SECONDS,
        jobs=1,
        top=1,
        mass=modes.get("mass", 1.0),
        damping=modes.get("damping", 0.0),
        stiffness=modes.get("stiffness", 0.0),
    )


def _modes(session: SessionFile) -> dict[str, npt.NDArray[np.float64]]:
    """The body's modes; of one that has none by itself, or is too large, that of its whole mass moving freely."""
    body = session.scenario.build_body()
    try:
        return modes_of(body)
    except UnsupportedError:
        return {"mass": np.array([body.mass.diagonal().mean()])}
