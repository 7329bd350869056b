"""Which link law a scenario has that names none."""

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, cast

from cotouch.scenario._body_tables import FileTable

if TYPE_CHECKING:
    from cotouch.scenario._scenario import Scenario

# The paper's springs, and the law that was measured to cost least of those that are passive.
SPRING, BEST = "spring", "paid"
# From so long there and back on, springs were measured to cost no more where hands are stiff [s].
_FAR = 0.6
# Options of [session] that only guarded springs have.
_GUARDED = ("quantile", "margin", "tank", "initial_energy", "age_limit")
_ENCODING, _EXACT = "encoding", "float64"


def choose_law(scenario: "Scenario") -> str:
    """The law of a scenario that names none: springs where it gives something that only springs can do, or do better.

    Only they take a way to work out the damping, an index (the paper's schedule), or a weight that couples rows. They
    do better where hands are not known to all, because links make neither a tree nor join all, or a tree on a body of
    several nodes; and over long links.

    Args:
        scenario: what is asked for.
    """
    sync, network = scenario.synchronisation, scenario.network
    only_springs = isinstance(sync.damping, str) or "damping_scale" in sync.model_fields_set or sync.mode != "freshest"
    if only_springs or network.weights:
        return SPRING
    complete = len(network.links) == network.size * (network.size - 1) // 2
    far = any(network.delay[a, b] + network.delay[b, a] > _FAR for a, b in network.links)
    if far or not (complete or makes_tree(range(network.size), network.links)):
        return SPRING
    if complete:
        return BEST
    return BEST if not isinstance(scenario.body, FileTable) and scenario.build_body().nodes == 1 else SPRING


def makes_tree(users: Iterable[int], links: Iterable[tuple[int, int]]) -> bool:
    """Whether links join three users or more, and between any two there is one way only.

    Args:
        users: their indices.
        links: pairs of these.
    """
    piece, count = {user: user for user in users}, 0
    for a, b in links:
        first, other = piece[a], piece[b]
        if first == other:
            return False
        piece = {user: first if own == other else own for user, own in piece.items()}
        count += 1
    return len(piece) > 2 and count == len(piece) - 1


def options_of_springs(session: Mapping[str, object]) -> list[str]:
    """Names of what a table [session] gives and only guarded springs have.

    Args:
        session: the table.
    """
    coarse = session.get(_ENCODING, _EXACT) != _EXACT
    return [name for name in _GUARDED if name in session] + [_ENCODING] * coarse


def with_law_of_session(tables: Mapping[str, object], session: object) -> dict[str, object]:
    """Tables of a scenario, with law "spring" if they name none and the session's options are those of springs.

    So a session's file has the same law live and in the simulator.

    Args:
        tables: of the scenario.
        session: the table [session], not checked yet.
    """
    sync = tables.get("synchronisation", {})
    if isinstance(session, Mapping) and isinstance(sync, Mapping) and "law" not in sync:
        given = cast("Mapping[str, object]", session)
        planned = given.get("links") == "plan"  # which seldom links all
        if planned or options_of_springs(given):
            return {**tables, "synchronisation": {**cast("Mapping[str, object]", sync), "law": SPRING}}
    return dict(tables)
