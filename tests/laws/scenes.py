"""Scenes that law tests share: two or more users on one point or chain."""

import dataclasses
from typing import Any

from cotouch.body import chain
from cotouch.installed import installed_names
from cotouch.laws import SPRING, Law, law_named, laws, register
from cotouch.scenario import Scenario

for name in installed_names("cotouch.laws"):  # the suite is that of whoever brings a law, too
    law_named(name)
AS_LAW = register(dataclasses.replace(SPRING, name="spring as law", _parts=[]))
OTHERS = sorted(set(laws()) - {"spring", "spring as law"})
PASSIVE = [name for name in OTHERS if laws()[name].passive]
ROUGH: dict[str, Any] = {
    "jitter": {"kind": "exponential", "scale": 0.01},
    "loss": 0.1,
    "burst": {"enter": 0.02, "leave": 0.3},
    "duplication": 0.1,
    "reordering": 0.1,
    "reordering_delay": 0.02,
}
TRIANGLE: dict[str, Any] = {
    "users": ["a", "b", "c"],
    "spring": [[0, 60, 30], [60, 0, 20], [30, 20, 0]],
    "delay": [[0, 0.03, 0.08], [0.05, 0, 0.02], [0.04, 0.06, 0]],
}


def two(delay: float = 0.025, spring: float = 50.0) -> dict[str, Any]:
    """Two users on a link."""
    return {"users": ["a", "b"], "spring": [[0, spring], [spring, 0]], "delay": [[0, delay], [delay, 0]]}


def rough(law: str | dict[str, Any], *, body: bool = False, mode: str = "freshest") -> Scenario:
    """Three users with steps of their own over a bad network."""
    nodes = 5 if body else 1
    return Scenario.make(
        network=TRIANGLE,
        body=chain(nodes, dimension=2, stiffness=200, damping=0.4) if body else {"mass": 1.0},
        steps={"duration": 1.5, "random": {"low": 0.004, "high": 0.02}},
        synchronisation={"mode": mode, "law": law},
        channel=ROUGH,
        hands=[
            {"user": 1, "node": 1, "stiffness": 80, "damping": 1.0, "path": [0.05] * (1 + body), "frequency": 1.5},
            {"user": 2, "node": nodes, "stiffness": 60, "path": [-0.03] * (1 + body), "release": 1.1},
            {"user": 3, "node": 1, "kind": "force", "path": [0.5] * (1 + body), "begin": 0.2, "release": 0.9},
        ],
        initial={"velocity": [[0.1] * (1 + body)] * 3 if not body else [[[0.1, 0.0]] * nodes] * 3},
    )


def law_of(law: Law | str) -> Law:
    """A law by name."""
    return laws()[law] if isinstance(law, str) else law
