"""The paper's five users, where their file lies, and how this study writes links down."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TypeAlias

import numpy as np

from cotouch.errors import ScenarioError
from cotouch.files import shipped
from cotouch.network import Network, Pair
from cotouch.scenario import Scenario
from cotouch.units import user_number

Progress: TypeAlias = Callable[[int, int, str], None]

_FILE = "five-users.toml"

# Where the copies start when they are let go without hands: apart from each other, all in different places.
START = (0.10, -0.05, 0.06, -0.08, 0.02)


def five_users() -> Path:
    """The scenario file of the paper's five users: beside this package if installed, otherwise in `examples/`.

    Raises:
        ScenarioError: it is in neither place.
    """
    return shipped("study", _FILE, ScenarioError)


def names(links: Iterable[Pair]) -> str:
    """Links as "12 14 23", users numbered from 1."""
    return " ".join(f"{user_number(a)}{user_number(b)}" for a, b in links)


def listed(numbers: Iterable[object]) -> str:
    """Several as "1, 3 and 5"."""
    *words, last = map(str, numbers)
    return f"{', '.join(words)} and {last}" if words else last


def digits(found: float, expected: float, most: int) -> int:
    """To how many digits two numbers agree.

    Args:
        found: the one.
        expected: the other, not 0.
        most: at most.
    """
    gap = abs(found - expected) / abs(expected)
    return int(np.clip(np.floor(-np.log10(max(gap, 1e-300))), 0, most))


def holding(network: Network, *, release: float, duration: float, period: float) -> Scenario:
    """The file's experiment on another choice of links: everyone pulls to a place of their own, then lets go.

    Args:
        network: users and the links in question.
        release: when all let go [s].
        duration: of the run [s].
        period: length of the steps [s].
    """
    base = Scenario.read(five_users())
    hands = [{**hand.model_dump(), "release": release} for hand in base.hands]
    return base.replace(title="", network=network, hands=hands, steps={"duration": duration, "period": period})


def free(
    network: Network,
    *,
    duration: float,
    period: float,
    body: Mapping[str, object] | None = None,
    hands: Sequence[Mapping[str, object]] | None = None,
    start: bool = True,
    **synchronisation: object,
) -> Scenario:
    """Copies that start apart (or together) on a common step, held by nobody unless `hands` says so.

    Args:
        network: users and the links in question.
        duration: of the run [s].
        period: length of the steps [s].
        body: table of the body; None: the file's.
        hands: tables of hands; None: nobody.
        start: whether copies start apart.
        **synchronisation: options of that table.
    """
    rule: dict[str, object] = {"law": "spring", "mode": "constant", "damping": "rule", **synchronisation}
    return Scenario.make(
        network=network,
        body=dict(body or {"kind": "point"}),
        steps={"duration": duration, "period": period},
        synchronisation=rule,
        hands=hands or [],
        initial={"position": list(START)} if start else {},
    )
