"""What hands do in a comparison: tasks, each with draws of its own."""

from collections.abc import Callable
from typing import TypeAlias, TypedDict, Unpack

import numpy as np


class _More(TypedDict, total=False):
    """What a hand does: options of a scenario's hand, on one axis; see `[[hands]]`."""

    path: float | list[list[float]]
    amplitude: float
    frequency: float
    phase: float
    begin: float
    release: float


class TaskHand(_More):
    """A hand of a task: its user from 1, stiffness [N/m], damping [Ns/m], and what it does."""

    user: int
    stiffness: float
    damping: float


Task: TypeAlias = list[TaskHand]
# Hands as a scenario has them.
Hands: TypeAlias = list[dict[str, object]]
# A task, of users, stiffness and damping of hands [N/m, Ns/m], and randomness.
Make: TypeAlias = Callable[[int, float, float, np.random.Generator], Task]

_POINTS = 12


def _reach(begin: float, end: float, start: float, goal: float) -> list[list[float]]:
    """Waypoints of a reach as people make it: least jerk [Flash & Hogan 1985]."""
    share = np.linspace(0.0, 1.0, _POINTS)
    smooth = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    return [
        [float(begin + (end - begin) * s), float(start + (goal - start) * m)]
        for s, m in zip(share, smooth, strict=True)
    ]


def _hand(user: int, stiffness: float, damping: float, **more: Unpack[_More]) -> TaskHand:
    return {"user": user, "stiffness": stiffness, "damping": damping, **more}


def carry(_users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """The first user takes the object there and back, the others look on.

    Args:
        _users: how many there are; it takes one.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    there, late = 0.1 * rng.uniform(0.8, 1.2), rng.uniform(0.1, 0.4)
    route = _reach(late, late + 1.0, 0.0, there) + _reach(late + 2.0, late + 3.0, there, 0.0)
    return [_hand(1, stiffness, damping, path=route)]


def tug(users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """All pull, every second one the other way.

    Args:
        users: how many pull, >= 1.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    pull, rate = 0.05 * rng.uniform(0.8, 1.2), rng.uniform(0.4, 0.8)
    phase = rng.uniform(0.0, 2.0 * np.pi)
    return [
        _hand(i + 1, stiffness, damping, path=pull * (-1) ** i, amplitude=0.03, frequency=rate, phase=phase * (i + 1))
        for i in range(users)
    ]


def both(users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """All move it together, to and fro.

    Args:
        users: how many move it, >= 1.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    swing, rate, late = 0.08 * rng.uniform(0.8, 1.2), rng.uniform(0.4, 0.8), rng.uniform(0.0, 0.05, users)
    return [
        _hand(i + 1, stiffness, damping, amplitude=swing, frequency=rate, phase=-2.0 * np.pi * rate * late[i])
        for i in range(users)
    ]


def handover(_users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """The first brings it to the second, who takes it on.

    Args:
        _users: how many there are; it takes two.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    place, late = 0.15 * rng.uniform(0.8, 1.2), rng.uniform(0.1, 0.3)
    taken, left = late + 1.4, late + 2.0
    return [
        _hand(1, stiffness, damping, path=_reach(late, late + 1.2, 0.0, place), release=left),
        _hand(2, stiffness, damping, path=_reach(left, left + 1.0, place, 2.0 * place), begin=taken),
    ]


def press(users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """The first presses against all others, who hold still, and lets up.

    Args:
        users: how many there are, the one who presses included, >= 1.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    deep, late = 0.06 * rng.uniform(0.8, 1.2), rng.uniform(0.1, 0.3)
    route = _reach(late, late + 0.4, 0.0, deep) + _reach(late + 2.2, late + 2.6, deep, 0.0)
    still = [_hand(i + 1, stiffness, damping) for i in range(1, users)]
    return [_hand(1, stiffness, damping, path=route), *still]


def hold(users: int, stiffness: float, damping: float, rng: np.random.Generator) -> Task:
    """All pull, every second one the other way, and then hold still.

    What copies do at rest shows: links that pay for forces have nothing left where stiff hands disagree.

    Args:
        users: how many hold, >= 1.
        stiffness: of a hand, > 0 [N/m].
        damping: of a hand, >= 0 [Ns/m].
        rng: for lengths, rates and times of the draw.
    """
    places, late = 0.03 * rng.uniform(0.8, 1.2, users), rng.uniform(0.0, 0.2, users)
    return [
        _hand(i + 1, stiffness, damping, path=_reach(late[i], late[i] + 0.3, 0.0, (-1) ** i * places[i]))
        for i in range(users)
    ]


TASKS: dict[str, Make] = {
    "carry": carry,
    "tug": tug,
    "both": both,
    "handover": handover,
    "press": press,
    "hold": hold,
}
# What laws are judged by, unless a study says otherwise.
JUDGED = ("carry", "tug", "both", "handover", "press")
