"""A session that plays itself on this machine: the paper's five users, each a process of its own."""

import json
import time
import tomllib
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, final

from cotouch.errors import SessionError
from cotouch.interrupt import interruptible
from cotouch.session._commanded_hand import CommandedHand
from cotouch.session._cushion import HALF, cushion, stl
from cotouch.session._demo_session_api import DemoSessionApi
from cotouch.session._file import MOST_USERS, SessionFile
from cotouch.session._hand import Slot
from cotouch.session._mailboxes import mailbox_folder
from cotouch.session._open import open_host
from cotouch.session._shared_model import SharedModel
from cotouch.session._totals import ALARM
from cotouch.session._warm import compiles, shared_with_another_process, warm_up
from cotouch.units import user_number

_FILE = "live.toml"
# Compiling on a machine that never did takes so long, several processes at once [s].
_PATIENCE = 300.0
_POLL = 0.02
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
# The cushion in its lowest modes; its links are a part of the paper's springs at every node, and none of its paths of
# 0.8 s, which would take so much damping that it moved like one in honey.
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
    "modes": 60,
}
_SOFT_FRACTION, _BLOCK_FRACTION = 1.0 / 40.0, 1.0 / 8.0
_SLOW = 0.5
# Five members of 500 Hz leave too little of two cores to a page and its browser [Hz].
_SOFT_RATE = 250
# How fast hands go around, until they let go [Hz].
_ROUND = (0.11, 0.17, 0.13, 0.19, 0.15)
# What `--impair` takes, and where it stands in a session's file.
_IMPAIRMENTS = ("loss", "jitter", "duplication", "reordering")
_HOLD = 0.05
# Hands wait for everybody to be there and coupled, so long and for such a share of the time at most [s].
_GATHER, _GATHER_FRACTION = 15.0, 1.0 / 6.0


def demo_file() -> Path:
    """The session of the paper's five users: beside this package where it is installed, else in `examples/`.

    Raises:
        SessionError: it is in neither place.
    """
    installed = Path(str(files("cotouch.session").joinpath(_FILE)))
    source = Path(__file__).resolve().parents[3] / "examples" / _FILE
    for path in (installed, source):
        if path.is_file():
            return path
    raise SessionError(
        f"{_FILE} is neither beside cotouch.session nor in the examples of the sources; reinstall cotouch"
    )


def demo_session(
    *,
    users: int = 5,
    body: str = "point",
    seconds: float | None = 30.0,
    impair: Sequence[str] = (),
    law: str = "spring",
) -> SessionFile:
    """The session of a demonstration.

    Args:
        users: how many; of more than five, all joined to all by equal springs over equal delays.
        body: "point" (the paper's), "block" (a lattice in three dimensions) or "soft" (a cushion).
        seconds: how long; the hands let go after two thirds of it. None: they never do, and go on moving.
        impair: what the network does besides, each such as "loss=0.1", "jitter=0.02" (s), "duplication=0.05",
            "reordering=0.1".
        law: of all links: "spring" (the paper's), or one that can go live.

    Raises:
        SessionError: one of these cannot be.
        ScenarioError: the law cannot be, or not live.
    """
    tables = tomllib.loads(demo_file().read_text(encoding="utf-8"))
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
        network["links"] = [link for link in network["links"] if max(link) <= users]
    else:
        network["users"] = [f"user {number + 1}" for number in range(users)]
        for name, value in (("spring", _SPRING), ("delay", _DELAY)):
            network[name] = [[value * (i != j) for j in range(users)] for i in range(users)]
        del network["links"]
    hands: list[dict[str, Any]] = [
        {"user": n + 1, "path": [[0, 0], [2, _REACH[n % 5]]], "stiffness": 60.0, "damping": 2.0} for n in range(users)
    ]
    tables["hands"] = hands
    _embody(tables, body)
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
    if law != "spring":
        tables["synchronisation"] = {"law": law}
    with TemporaryDirectory(prefix="cotouch-") as folder:
        if body == "soft":
            Path(folder, _SOFT_FILE).write_bytes(stl(*cushion()))
        return SessionFile.from_toml(_toml(tables), source="the demonstration", folder=Path(folder))


@final
@dataclass(frozen=True, kw_only=True)
class DemoOutcome:
    """How a demonstration went.

    Attributes:
        members: what each process said at its end, by name; None of one that did not come to its end.
        seconds: from when all were there.
        supplied: by all hands [J].
        lost: in all dampers [J].
        linked: work of all links on the copies: what delays added, less what links took [J].
        energy: in the copies at the end [J].
        initial: at the start [J].
        residual: greatest of anybody's steps, of the energy in play.
        apart: greatest difference of linked copies at the end [m].
        missed: share of steps that came late.
        guarded: how often links were guarded after they were coupled first.
        complaints: what went wrong, in sentences; empty if all came out as it should.
        notes: what else is to be known.
        lowered: whether somebody lowered the damping meanwhile, so that nothing is promised of the whole.
    """

    members: dict[str, dict[str, Any] | None]
    seconds: float
    supplied: float
    lost: float
    linked: float
    energy: float
    initial: float
    residual: float
    apart: float
    missed: float
    guarded: int
    complaints: list[str]
    notes: list[str] = field(default_factory=list[str])
    lowered: bool = False


def play(
    session: SessionFile,
    *,
    seconds: float | None,
    each: Callable[[DemoSessionApi, float], None] | None = None,
    stopped: Callable[[], bool] = lambda: False,
    record: Path | None = None,
    beside: Callable[[DemoSessionApi], AbstractContextManager[object]] = nullcontext,
    say: Callable[[str], None] = lambda _: None,
) -> DemoOutcome:
    """Plays a session with one process for each of its users.

    Args:
        session: with scripted hands.
        seconds: how long, from when all are there; None: until it is stopped.
        each: called some fifty times a second, with the stage and the time.
        stopped: whether to end now.
        record: an existing folder for a recording of each user.
        beside: entered with the stage before anybody is there, and left before it closes; a page's server, say.
        say: is told in a few words what takes time.

    Raises:
        TransportError: this machine refuses a port.
        SessionError: somebody could not take part.
        KeyboardInterrupt: it was stopped before all were there; nobody is left.
    """
    with TemporaryDirectory(prefix="cotouch-") as folder:
        if session.files:  # a mesh is read again from where it lies
            session = SessionFile.from_content(session.content, session.files, folder=Path(folder))
        return _played(session, seconds, each, stopped, record, beside, say)


def _played(
    session: SessionFile,
    seconds: float | None,
    each: Callable[[DemoSessionApi, float], None] | None,
    stopped: Callable[[], bool],
    record: Path | None,
    beside: Callable[[DemoSessionApi], AbstractContextManager[object]],
    say: Callable[[str], None],
) -> DemoOutcome:
    say("building the object")
    replica = interruptible(SharedModel.build)(session)
    touched = replica.body.skin is not None
    cold = compiles(session, touched=touched)
    if cold:
        # Here, as somebody waits who wants to know of it. Members would compile once, too: one, while the others wait.
        say("compiling, once on this machine")
        with shared_with_another_process(session) if touched else nullcontext():
            interruptible(warm_up)(replica, lambda model: CommandedHand(Slot.of(session, replica, 0, model)))
    say("starting the members")
    with open_host(session) as opened, mailbox_folder() as mailboxes:
        api = DemoSessionApi(session, opened, replica, mailboxes, record=record, rouse=seconds is None)
        try:
            with beside(api):
                api.start()
                began = _gather(api, each, stopped)
                api.choose_links()
                end = began + (float("inf") if seconds is None else seconds)
                while time.monotonic() < end and not stopped():
                    _turn(api, each)
                opened.host.end()
                took = time.monotonic() - began
                finish = time.monotonic() + 10.0
                while time.monotonic() < finish and any(member.running for member in api.members.values()):
                    _turn(api, None)
                _turn(api, None)  # what they said last
            return _summed(api, took)
        finally:
            api.close()


def all_move(api: DemoSessionApi) -> bool:
    """Whether all members are there and their copies move.

    Args:
        api: of the session.
    """
    seen = api.opened.host.watch.members.values()
    return len(seen) == len(api.members) and all(s.status is not None and s.status.steps for s in seen)


def _gather(
    api: DemoSessionApi, each: Callable[[DemoSessionApi, float], None] | None, stopped: Callable[[], bool]
) -> float:
    """Waits until everybody moves; returns when that was [s].

    Raises:
        KeyboardInterrupt: it was stopped before.
    """
    patience = time.monotonic() + _PATIENCE
    members = api.members
    while True:
        if stopped():
            raise KeyboardInterrupt
        _turn(api, each)
        if api.acted:  # somebody killed one of them meanwhile, say
            break
        if all_move(api):
            break
        for name, member in members.items():
            if not member.running:
                raise SessionError(f"{name} could not take part: {member.complaint() or 'it ended without a word'}")
        if time.monotonic() > patience:
            here = len(api.opened.host.watch.members)
            raise SessionError(f"{here} of {len(members)} users came within {_PATIENCE:.0f} s; try fewer")
    return time.monotonic()


def _turn(api: DemoSessionApi, each: Callable[[DemoSessionApi, float], None] | None) -> None:
    now = time.monotonic()
    api.tick(now)
    if each is not None:
        each(api, now)
    time.sleep(_POLL)


def _summed(api: DemoSessionApi, seconds: float) -> DemoOutcome:
    """What came of it; where somebody changed how it went, who was killed or cut off is nothing to complain about."""
    acted = api.acted
    results = {name: member.result() for name, member in api.members.items()}
    troubles, kept = api.recording_left()
    complaints = [f"{name} ended without a result" for name, result in results.items() if result is None and not acted]
    known = [r["status"] for r in results.values() if r is not None and r["status"] is not None]

    def total(name: str) -> float:
        return float(sum(status[name] for status in known))

    supplied, initial, lost = total("supplied"), total("initial"), total("lost")
    had = initial + total("initial_energies")
    residual = max((status["residual"] for status in known), default=0.0)
    links = [link for status in known for link in status["links"]]
    apart = max((link["difference"] for link in links if link["difference"] is not None), default=0.0)
    if supplied + had < -ALARM * max(lost, abs(supplied)) and not acted:
        complaints.append(f"the hands got out {-supplied - had:.3g} J that nobody put in")
    if residual > ALARM:
        complaints.append(f"the energy ledger is off by {residual:.1e} of the energy in play")
    # One that is ready has caught up, and waits for as long as its budgets.
    loose = sorted(
        {
            (min(status["slot"], link["slot"]), max(status["slot"], link["slot"]))
            for status in known
            for link in status["links"]
            if link["state"] not in {"coupled", "ready"}
        }
    )
    if loose and not acted:
        pairs = ", ".join(f"{user_number(a)}-{user_number(b)}" for a, b in loose)
        complaints.append(
            f"at the end {'this link was' if len(loose) == 1 else 'these links were'} not coupled: {pairs}"
        )
    for name, result in results.items():
        if result is not None and result["recording_trouble"]:
            complaints.append(f"the recording of {name} {result['recording_trouble']}")
    steps = total("steps")
    return DemoOutcome(
        members=results,
        seconds=seconds,
        supplied=supplied,
        lost=lost,
        linked=total("linked"),
        energy=total("energy"),
        initial=initial,
        residual=residual,
        apart=apart,
        missed=total("missed") / steps if steps else 0.0,
        guarded=sum(link["guarded"] for link in links),
        complaints=complaints + troubles,
        notes=[] if kept is None else [kept],
        lowered=api.lowered,
    )


def _embody(tables: dict[str, Any], body: str) -> None:
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
        raise SessionError(f'--body is "{body}"; it must be {" or ".join(_BODIES)}')
    ways = ((0.0, 0.3, 0.0), (0.0, -0.3, 0.1), (0.2, 0.0, 0.3), (0.0, 0.2, -0.3), (-0.2, 0.0, 0.2))
    for n, (hand, place) in enumerate(zip(tables["hands"], places, strict=True)):
        reach = [0.06 * fraction for fraction in ways[n % 5]]  # so far that a hand feels the others
        hand |= {"at": place, "path": [[0, 0, 0, 0], [2, *reach]], "stiffness": 200.0}


def _cushion(tables: dict[str, Any]) -> None:
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


def _soften(tables: dict[str, Any], fraction: float) -> None:
    """Gives every node a share of the paper's springs, and leaves out its slowest path."""
    network = tables["network"]
    network["spring"] = [[fraction * spring for spring in row] for row in network["spring"]]
    if "links" in network:
        network["links"] = [[a, b] for a, b in network["links"] if network["delay"][a - 1][b - 1] < _SLOW]


def _impair(tables: dict[str, Any], impair: Sequence[str]) -> None:
    channel: dict[str, Any] = {}
    for one in impair:
        name, _, text = one.partition("=")
        try:
            value = float(text)
        except ValueError:
            value = -1.0
        if name not in _IMPAIRMENTS or not 0.0 <= value <= 1.0:
            raise SessionError(
                f'--impair is "{one}"; it must be {", ".join(_IMPAIRMENTS)}, "=", and a number from 0 to 1 (jitter: s)'
            )
        channel[name] = {"scale": value} if name == "jitter" else value
        if name == "reordering":
            channel["reordering_delay"] = _HOLD
    if channel:
        tables["channel"] = channel


def _toml(tables: dict[str, Any]) -> str:
    """Tables of numbers, texts, lists and one level of tables; JSON's values are TOML's, but for tables in tables."""
    lines: list[str] = []

    def value(entry: Any) -> str:
        if isinstance(entry, dict):
            return "{" + ", ".join(f"{name} = {value(inner)}" for name, inner in entry.items()) + "}"
        return json.dumps(entry)

    def table(header: str, entries: dict[str, Any]) -> None:
        lines.extend(["", header, *(f"{name} = {value(entry)}" for name, entry in entries.items())])

    for name, entry in tables.items():
        if not isinstance(entry, dict | list):
            lines.append(f"{name} = {value(entry)}")
    for name, entry in tables.items():
        if isinstance(entry, dict):
            table(f"[{name}]", entry)
        elif isinstance(entry, list):
            for one in entry:
                table(f"[[{name}]]", one)
    return "\n".join(lines) + "\n"
