"""Plays a session on this machine, each of its users a process of its own, and says how it went."""

import time
from collections.abc import Callable
from contextlib import AbstractContextManager, closing, nullcontext
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, final

from cotouch.errors import SessionError
from cotouch.hands import CommandedHand
from cotouch.interrupt import interruptible
from cotouch.members import TOTALS_ALARM, SessionFile, SharedModel, Slot
from cotouch.observers import mailbox_folder
from cotouch.session._demo_session_api import DemoSessionApi
from cotouch.session._open import open_host
from cotouch.session._warm import compiles, shared_with_another_process, warm_up
from cotouch.units import user_number

# Compiling on a machine that never did takes so long, several processes at once [s].
_PATIENCE = 300.0
_POLL = 0.02


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
        left: whether somebody took a part of the ledger along, who left or began anew.
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
    left: bool = False


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
    # Here, as somebody waits who wants to know of it. Members would compile once, too: one, while the others wait, and
    # a page would show nobody. What is not cold may still lack what this object needs, so two steps are taken anyway.
    cold = compiles(session, touched=touched)
    say("compiling, once on this machine" if cold else "loading compiled kernels, or compiling those that are missing")
    with shared_with_another_process(session) if touched and cold else nullcontext():
        interruptible(warm_up)(replica, lambda model: CommandedHand(Slot.of(session, replica, 0, model)))
    say("starting the users")
    with (
        open_host(session) as opened,
        mailbox_folder() as mailboxes,
        closing(DemoSessionApi(session, opened, replica, mailboxes, record=record, rouse=seconds is None)) as api,
    ):
        with beside(api):
            api.start()
            began = _gather(api, each, stopped)
            api.choose_links()
            end = began + (float("inf") if seconds is None else seconds)
            while time.monotonic() < end and not stopped():
                _turn(api, each)
            left = opened.host.watch.left  # before all leave
            opened.host.end()
            took = time.monotonic() - began
            finish = time.monotonic() + 10.0
            while time.monotonic() < finish and any(member.running for member in api.members.values()):
                _turn(api, None)
            _turn(api, None)  # what they said last
        return _summed(api, took, left=left)


def all_move(api: DemoSessionApi) -> bool:
    """Whether all members are present and their copies move.

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
        gone = next((name for name, member in members.items() if not member.running), None)
        if gone is not None:
            if stopped():  # Ctrl-C reaches everybody; the members may have ended first
                raise KeyboardInterrupt
            why = members[gone].complaint() or "its process ended without a message"
            raise SessionError(f"{gone} could not take part: {why}")
        if time.monotonic() > patience:
            here = len(api.opened.host.watch.members)
            raise SessionError(f"{here} of {len(members)} users joined within {_PATIENCE:.0f} s; try fewer users")
    return time.monotonic()


def _turn(api: DemoSessionApi, each: Callable[[DemoSessionApi, float], None] | None) -> None:
    now = time.monotonic()
    api.tick(now)
    if each is not None:
        each(api, now)
    time.sleep(_POLL)


def _summed(api: DemoSessionApi, seconds: float, *, left: bool) -> DemoOutcome:
    """What came of it; where somebody changed how it went, who was killed or cut off is nothing to complain about."""
    acted = api.acted
    results = {name: member.result() for name, member in api.members.items()}
    troubles, kept = api.recording_left()
    complaints = [
        f"{name}'s process ended without a result" for name, result in results.items() if result is None and not acted
    ]
    known = [r["status"] for r in results.values() if r is not None and r["status"] is not None]

    def total(name: str) -> float:
        return float(sum(status[name] for status in known))

    supplied, initial, lost = total("supplied"), total("initial"), total("lost")
    had = initial + total("initial_energies") + total("depth")
    residual = max((status["residual"] for status in known), default=0.0)
    links = [link for status in known for link in status["links"]]
    apart = max((link["difference"] for link in links if link["difference"] is not None), default=0.0)
    if supplied + had < -TOTALS_ALARM * max(lost, abs(supplied)) and not acted:
        complaints.append(f"the hands took out {-supplied - had:.3g} J that nobody had put in")
    if residual > TOTALS_ALARM:
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
        left=left or None in results.values(),
    )
