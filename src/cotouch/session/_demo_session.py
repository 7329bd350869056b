"""The session that plays itself: the paper's five users or others, a body, hands that move it, and a network."""

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NotRequired, Required, TypedDict, cast

from cotouch.errors import SessionError
from cotouch.files import read_toml, shipped, toml_text
from cotouch.members import MOST_USERS, SessionFile
from cotouch.session._cushion import HALF, cushion, stl

_FILE = "live.toml"
_NUMBERS = ("No", "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight")
_BODIES = ("point", "block", "soft")
# Springs and delays of users beyond the paper's five.
_SPRING, _DELAY = 60.0, 0.05
_REACH = (0.10, -0.05, 0.06, -0.08, 0.02)
_BLOCK = {
    "kind": "lattice",
    "shape": [8, 4, 4],
    "mass": 1.0,
    "stiffness": 60.0,
    "damping": 0.1,
    "spacing": 0.02,
    "ground": "x-",
    "ground_stiffness": 60.0,
}
# The cushion in its lowest modes, so many that what is told of them fits two datagrams. Its links are a part of the
# paper's springs at every node, and none of its paths of 0.8 s, which would take so much damping that it moved like one
# in honey.
_SOFT_FILE = "cushion.stl"
_SOFT = {
    "file": _SOFT_FILE,
    "unit": "m",
    "resolution": 10,
    "model": "elastic",
    "young": 1e4,
    "poisson": 0.35,
    "density": 250.0,
    "rayleigh_mass": 1.0,
    "rayleigh_stiffness": 0.01,
    "ground": {"box": {"low": [-1.0, -1.0, -1.0], "high": [1.0, 1.0, -0.02]}},
    "ground_stiffness": 10.0,
    "modes": 44,
}
_SOFT_FRACTION, _BLOCK_FRACTION = 1.0 / 40.0, 1.0 / 8.0
_SLOW = 0.5
_LONGEST = 0.1  # of a path, with the default law [s]
# So that the point comes to rest when all let go at once: none of its links takes anything of its motion [Ns/m].
_STOPPING = 1.0
# Five members of 500 Hz leave too little of two cores to a page and its browser [Hz].
_SOFT_RATE = 250
# How fast hands go around, until they let go [Hz].
_ROUND = (0.11, 0.17, 0.13, 0.19, 0.15)
# What `--impair` takes, and where it stands in a session's file.
_IMPAIRMENTS = ("loss", "jitter", "duplication", "reordering")
_HOLD = 0.05
# Hands wait for everybody to be there and coupled, so long and for such a share of the time at most [s].
_GATHER, _GATHER_FRACTION = 15.0, 1.0 / 6.0


class _Network(TypedDict):
    users: list[str]
    spring: list[list[float]]
    delay: list[list[float]]
    links: NotRequired[list[list[int]]]


class _Hand(TypedDict, total=False):
    user: int
    at: list[float]
    path: Required[list[list[float]]]
    stiffness: float
    damping: float
    amplitude: float | list[float]
    frequency: float
    release: float


class _Tables(TypedDict):
    """The tables of the session's file that this changes."""

    title: str
    network: _Network
    body: dict[str, object]
    hands: list[_Hand]
    session: dict[str, object]
    steps: NotRequired[dict[str, object]]
    channel: NotRequired[dict[str, object]]


def demo_session(
    *,
    users: int = 5,
    body: str = "point",
    seconds: float | None = 30.0,
    impair: Sequence[str] = (),
    law: str | None = None,
) -> SessionFile:
    """The session of a demonstration.

    Args:
        users: how many; of more than five, all joined to all by equal springs over equal delays.
        body: "point" (the paper's), "block" (a lattice in three dimensions) or "soft" (a cushion).
        seconds: how long; the hands let go after two thirds of it. None: they never do, and go on moving.
        impair: what the network does besides, each such as "loss=0.1", "jitter=0.02" (s), "duplication=0.05",
            "reordering=0.1".
        law: of all links: "spring" (the paper's), or one that can go live; None: "paid", with a link between any two
            and the paper's delays up to 0.1 s, which the longer ones take too: it is for people who are all linked.

    Raises:
        SessionError: one of these cannot be.
        ScenarioError: the law cannot be, or not live.
    """
    tables = cast("_Tables", read_toml(shipped("session", _FILE, SessionError), "session file", SessionError))
    if not 1 <= users <= MOST_USERS:
        raise SessionError(f"--users is {users}; it must be from 1 to {MOST_USERS}")
    network = tables["network"]
    if users != len(network["users"]):
        tables["title"] = (
            f"{_NUMBERS[users] if users < len(_NUMBERS) else users} user{'s' if users > 1 else ''}, one object"
        )
    if users <= len(network["users"]):
        network["users"] = network["users"][:users]
        for name in ("spring", "delay"):
            network[name] = [row[:users] for row in network[name][:users]]
        network["links"] = [link for link in network.get("links", []) if max(link) <= users]
    else:
        network["users"] = [f"user {number + 1}" for number in range(users)]
        for name, value in (("spring", _SPRING), ("delay", _DELAY)):
            network[name] = [[value * (i != j) for j in range(users)] for i in range(users)]
        network.pop("links", None)
    hands: list[_Hand] = [
        {"user": n + 1, "path": [[0, 0], [2, _REACH[n % 5]]], "stiffness": 60.0, "damping": 2.0} for n in range(users)
    ]
    tables["hands"] = hands
    _embody(tables, body)
    if law is None:
        network["delay"] = [[min(delay, _LONGEST) for delay in row] for row in network["delay"]]
        network.pop("links", None)
        if body == "point":
            tables["body"]["damping"] = _STOPPING
    for n, hand in enumerate(hands):
        last = hand["path"][-1][1:]
        hand["amplitude"] = last if len(last) > 1 else last[0]
        hand["frequency"] = _ROUND[n % 5]
        if seconds is not None:
            hand["release"] = round(2.0 * seconds / 3.0, 3)
    tables["session"]["wait_for_peers"] = (
        _GATHER if seconds is None else min(_GATHER, round(_GATHER_FRACTION * seconds, 3))
    )
    _impair(tables, impair)
    with TemporaryDirectory(prefix="cotouch-") as folder:
        if body == "soft":
            Path(folder, _SOFT_FILE).write_bytes(stl(*cushion()))
        return SessionFile.from_toml(toml_text(tables), source="the demonstration", folder=Path(folder), law=law)


def _embody(tables: _Tables, body: str) -> None:
    """Puts a body in, and hands where they can hold it."""
    if body == "point":
        return
    if body == "block":
        tables["body"] = dict(_BLOCK)
        _soften(tables, _BLOCK_FRACTION)
        places = [[0.14, 0.02 * (n % 4), 0.02 * (n // 4 % 4)] for n in range(len(tables["hands"]))]
    elif body == "soft":
        _cushion(tables)
        return
    else:
        raise SessionError(f'--body is "{body}"; it must be one of {", ".join(_BODIES)}')
    ways = ((0.0, 0.3, 0.0), (0.0, -0.3, 0.1), (0.2, 0.0, 0.3), (0.0, 0.2, -0.3), (-0.2, 0.0, 0.2))
    for n, (hand, place) in enumerate(zip(tables["hands"], places, strict=True)):
        reach = [0.06 * fraction for fraction in ways[n % 5]]  # so far that a hand feels the others
        hand |= {"at": place, "path": [[0, 0, 0, 0], [2, *reach]], "stiffness": 200.0}


def _cushion(tables: _Tables) -> None:
    """The cushion: held at its corners and in the middle, at shares of its half width."""
    tables["body"] = dict(_SOFT)
    tables["steps"] = {"rate": _SOFT_RATE}
    _soften(tables, _SOFT_FRACTION)
    places = ((0.85, 0.85, 0.0), (-0.85, 0.85, 0.0), (-0.85, -0.85, 0.0), (0.85, -0.85, 0.0), (0.0, 0.0, 0.3))
    ways = ((0.3, 0.3, 0.3), (-0.3, 0.2, 0.4), (-0.2, -0.3, -0.2), (0.3, -0.2, 0.4), (0.0, 0.0, 0.5))
    for n, hand in enumerate(tables["hands"]):
        hand |= {
            "at": [HALF * fraction for fraction in places[n % 5]],
            "path": [[0, 0, 0, 0], [2, *(HALF * fraction for fraction in ways[n % 5])]],
            "stiffness": 150.0,
            "damping": 3.0,
        }


def _soften(tables: _Tables, fraction: float) -> None:
    """Gives every node a share of the paper's springs, and leaves out its slowest path."""
    network = tables["network"]
    network["spring"] = [[fraction * spring for spring in row] for row in network["spring"]]
    if "links" in network:
        network["links"] = [[a, b] for a, b in network["links"] if network["delay"][a - 1][b - 1] < _SLOW]


def _impair(tables: _Tables, impair: Sequence[str]) -> None:
    channel: dict[str, object] = {}
    for one in impair:
        name, _, text = one.partition("=")
        try:
            value = float(text)
        except ValueError:
            value = -1.0
        if name not in _IMPAIRMENTS or not 0.0 <= value <= 1.0:
            raise SessionError(
                f'--impair is "{one}"; it must be NAME=NUMBER: {", ".join(_IMPAIRMENTS)} from 0 to 1 (jitter in s)'
            )
        channel[name] = {"scale": value} if name == "jitter" else value
        if name == "reordering":
            channel["reordering_delay"] = _HOLD
    if channel:
        tables["channel"] = channel
