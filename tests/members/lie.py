"""What a member may say that has all keys of its own: any of it, and what is near to some of it."""

import math
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

LAWS = ("true", "place", "swing", "noise", "push", "chase", "drift", "mirror")
INDICES = ("true", "stride", "jump", "back", "last")
ECHOES = ("true", "none", "future", "old", "random")
EPOCHS = ("true", "cycle", "fixed")
# What it says to everybody, or does. "crown": the host dies, and it decides as it likes where it is its turn; "ghost":
# the host dies, and what it said of being there is said again.
TALK = ("rosters", "joins", "statuses", "keys", "garbage", "leave", "files", "budgets", "crown", "ghost")
DEADLY = ("crown", "ghost")
LIMIT = 9.9  # just within what a state may hold [m]
MOST = 2e10


@dataclass(frozen=True)
class Lie:
    """What it says.

    Attributes:
        first: whether it is there before all others.
        since: when it begins to lie [s].
        law: where it says that it is.
        size, rate, lead: of that law [m], [1/s], [s].
        pattern: seed of the direction; 0: everywhere the same.
        faces: whether it says the opposite to every other neighbour.
        stamp, drift: what its stamps are off by [s], and how that grows.
        index: of its steps.
        echo, held: what it says came back, and how long it had it [s].
        age: what it adds to the ages that it found; nan: it says nothing of them [s].
        state: that its guard says; -1 the true one, -2 a random one.
        epoch: of its guard.
        received: whether it says it heard the other's epoch, which it may not have.
        given: what it says it gave, in each step [J].
        starved: what it says; -1: the truth.
        ask, grant: in budgets; nan: the truth [s].
        toggle: whether it says so only every other time.
        burst: datagrams for each that is due.
        silence: share of the time in which it says nothing.
        talk: what it says to everybody, of `TALK`.
        seed: of all chance.
    """

    first: bool = False
    since: float = 1.5
    law: str = "true"
    size: float = 0.1
    rate: float = 1.0
    lead: float = 0.0
    pattern: int = 0
    faces: bool = False
    stamp: float = 0.0
    drift: float = 0.0
    index: str = "true"
    echo: str = "true"
    held: float = 0.0
    age: float = 0.0
    state: int = -1
    epoch: str = "true"
    received: bool = False
    given: float = 0.0
    starved: int = -1
    ask: float = math.nan
    grant: float = math.nan
    toggle: bool = False
    burst: int = 1
    silence: float = 0.0
    talk: tuple[str, ...] = ()
    seed: int = 0


def _wide(rng: np.random.Generator, least: float, most: float, *, signed: bool = True) -> float:
    """Of any size between two."""
    size = float(np.exp(rng.uniform(np.log(least), np.log(most))))
    return size * float(rng.choice([-1.0, 1.0])) if signed else size


def _often(rng: np.random.Generator, value: Any, other: Callable[[], Any], fraction: float = 0.5) -> Any:
    return value if rng.random() < fraction else other()


def _made(rng: np.random.Generator, names: tuple[str, ...]) -> dict[str, Callable[[], Any]]:
    nan = math.nan
    return {
        "first": lambda: bool(rng.random() < 0.3),
        "since": lambda: float(rng.choice([0.0, 1.5])),
        "law": lambda: str(rng.choice(LAWS)),
        "size": lambda: _wide(rng, 1e-3, LIMIT, signed=False),
        "rate": lambda: _wide(rng, 0.1, 50.0),
        "lead": lambda: _wide(rng, 1e-3, 2.0),
        "pattern": lambda: int(rng.integers(0, 4)),
        "faces": lambda: bool(rng.random() < 0.2),
        "stamp": lambda: _often(rng, 0.0, lambda: _wide(rng, 1e-3, 1e9)),
        "drift": lambda: _often(rng, 0.0, lambda: _wide(rng, 1e-3, 1e3), 0.7),
        "index": lambda: _often(rng, "true", lambda: str(rng.choice(INDICES))),
        "echo": lambda: _often(rng, "true", lambda: str(rng.choice(ECHOES))),
        "held": lambda: _often(rng, 0.0, lambda: _wide(rng, 1e-3, 1e9, signed=False), 0.7),
        "age": lambda: _often(rng, 0.0, lambda: float(rng.choice([nan, _wide(rng, 1e-3, MOST)]))),
        "state": lambda: _often(rng, -1, lambda: int(rng.integers(-2, 3))),
        "epoch": lambda: str(rng.choice(EPOCHS)),
        "received": lambda: bool(rng.random() < 0.5),
        "given": lambda: _often(rng, 0.0, lambda: _wide(rng, 1e-6, 1e12, signed=False)),
        "starved": lambda: int(rng.integers(-1, 2)),
        "ask": lambda: _often(rng, nan, lambda: _wide(rng, 1e-3, MOST)),
        "grant": lambda: _often(rng, nan, lambda: _wide(rng, 1e-3, MOST)),
        "toggle": lambda: bool(rng.random() < 0.3),
        "burst": lambda: int(rng.choice([1, 1, 1, 2, 5])),
        "silence": lambda: _often(rng, 0.0, lambda: float(rng.uniform(0.0, 1.0)), 0.7),
        "talk": lambda: tuple(name for name in names if rng.random() < (0.04 if name in DEADLY else 0.15)),
        "seed": lambda: int(rng.integers(0, 1000)),
    }


def random_lie(rng: np.random.Generator, names: tuple[str, ...] = TALK) -> Lie:
    """Any lie."""
    made = _made(rng, names)
    return Lie(**{field.name: made[field.name]() for field in fields(Lie)})


def near(lie: Lie, rng: np.random.Generator, names: tuple[str, ...] = TALK) -> Lie:
    """One that differs in a few things: a little in a size, or wholly."""
    made = _made(rng, names)
    change: dict[str, Any] = {}
    for name in rng.choice([field.name for field in fields(Lie)], int(rng.integers(1, 4)), replace=False):
        value = getattr(lie, name)
        number = isinstance(value, float) and math.isfinite(value) and value != 0.0
        change[name] = value * float(np.exp(rng.normal(0.0, 0.5))) if number and rng.random() < 0.7 else made[name]()
    limits = {"size": LIMIT, "silence": 1.0, "stamp": 9e9, "held": 9e9, "age": MOST, "ask": 2.1e10, "grant": 2.1e10}
    for name, most in limits.items():
        if name in change and abs(change[name]) > most:
            change[name] = math.copysign(most, change[name])
    return replace(lie, **change)
