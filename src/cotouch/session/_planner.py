"""Choosing the links of those who are there, beside everything else that the host does."""

from typing import final

import numpy as np

from cotouch.arrays import Float
from cotouch.errors import CotouchError, SessionError, UnsupportedError
from cotouch.members import SessionFile, delays_of
from cotouch.network import Network, Pair
from cotouch.observers import ChildCall
from cotouch.planning import Objective, Plan, compiles, modes_of, plan, worked

# Time budget of one search, by `worked`; what is found by then counts [s].
_SECONDS = 5.0
# The consensus model works on a grid of this [s].
_TIME_UNIT = 0.001


@final
class LinkPlanner:
    """A `Planner` that works in another process: asked repeatedly, it answers once it has found something."""

    def __init__(self, session: SessionFile) -> None:
        """Prepares to plan.

        Args:
            session: with its objective and number of links.
        """
        self._session = session
        self._work: tuple[list[int], ChildCall[list[Pair]]] | None = None

    def __call__(self, slots: list[int], paths: dict[Pair, float]) -> list[Pair] | None:
        """The links, or None while it is still at work.

        Args:
            slots: who is there.
            paths: times there and back that were measured [s].
        """
        if self._work is None or self._work[0] != slots:
            self.close()
            self._work = (list(slots), ChildCall(_planned, self._session, list(slots), dict(paths)))
        work = self._work[1]
        if not work.done:
            return None
        self._work = None
        try:
            return work.result()
        except SessionError:
            return _given(self._session.scenario.network, slots)

    def close(self) -> None:
        """Ends a search that is going on."""
        if self._work is not None:
            self._work[1].kill()
            self._work = None


def _planned(session: SessionFile, slots: list[int], paths: dict[Pair, float]) -> list[Pair]:
    whole, options = session.scenario.network, session.options
    delay = delays_of(whole, paths)
    there = np.ix_(slots, slots)
    network = Network(
        users=[whole.users[slot] for slot in slots], spring=whole.spring[there], delay=delay[there], links=[]
    )
    modes = _modes(session) if options.objective in ("decay", "drag", "feel") else {}
    try:
        found = _search(network, session.link_count(len(slots)), options.objective, modes)
    except CotouchError:  # springs that cannot join all, say
        return _given(whole, slots)
    return sorted((slots[a], slots[b]) for a, b in found.best.links)


def _given(whole: Network, slots: list[int]) -> list[Pair]:
    """Links of the file among those who are there, which are kept where none can be found."""
    return [(a, b) for a, b in whole.links if a in slots and b in slots]


def notable_links(session: SessionFile) -> dict[str, list[Pair]]:
    """The links that a session starts with, and the best and the worst as many, by its delays; takes its time.

    Args:
        session: with two or more users.

    Returns:
        Pairs of slots, by "start", "best", "worst"; without the last two where nothing was found.
    """
    network = session.scenario.network
    choices = {"start": sorted((int(a), int(b)) for a, b in network.links)}
    modes = _modes(session)
    try:
        found = _search(network, len(choices["start"]), "decay", modes)
    except CotouchError:
        return choices
    return choices | {"best": sorted(found.best.links), "worst": sorted(found.worst.links)}


def _search(network: Network, links: int, objective: Objective, modes: dict[str, Float]) -> Plan:
    if compiles():  # which is not to use up the time
        two = Network(users=["1", "2"], spring=[[0.0, 1.0], [1.0, 0.0]], delay=[[0.0, 0.1], [0.1, 0.0]])
        plan(two, links=1, objective=objective, time_unit=_TIME_UNIT, jobs=1)
    return plan(
        network,
        links=links,
        objective=objective,
        time_unit=_TIME_UNIT,
        rounding="nearest",
        seconds=_SECONDS,
        clock=worked,
        jobs=1,
        top=1,
        mass=modes.get("mass", 1.0),
        damping=modes.get("damping", 0.0),
        stiffness=modes.get("stiffness", 0.0),
    )


def _modes(session: SessionFile) -> dict[str, Float]:
    """The body's modes; of one that has none by itself, or is too large, that of its whole mass moving freely."""
    body = session.scenario.build_body()
    try:
        return modes_of(body)
    except UnsupportedError:
        return {"mass": np.array([body.mass.diagonal().mean()])}
