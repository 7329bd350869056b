"""Taking part in a session from this process: what opens sockets, reads the clock, and moves the copy in time."""

import math
import os
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal, final

from cotouch.errors import TransportError
from cotouch.live import (
    Address,
    ControlPlane,
    Identity,
    ImpairedTransport,
    Invitation,
    Pacer,
    RoutedTransport,
    UdpTransport,
    ZenohControl,
    few_arenas,
    prepare_process,
)
from cotouch.mechanics import Model
from cotouch.session._boards import BoardFolder
from cotouch.session._device_hand import DeviceHand
from cotouch.session._emulate import path_laws
from cotouch.session._file import SessionFile
from cotouch.session._hand import Hand, NoHand, ScriptedHand
from cotouch.session._held import HeldDevice, held_device
from cotouch.session._member import Member
from cotouch.session._messages import Status
from cotouch.session._pace import Pace, pace_numbers
from cotouch.session._replica import Replica
from cotouch.session._tape import Tape
from cotouch.session._told import ToldHand
from cotouch.session._warm import compiles, warm_up
from cotouch.session._ways import RoutedWays
from cotouch.session._window import Window

HandKind = Literal["scripted", "none"]

# The host answers at once, if it is there and reachable; a large mesh takes longer, but comes in pieces [s].
_PATIENCE = 20.0
_FILE_PATIENCE = 120.0
_SERVICE_EVERY = 0.02
_WAIT = 0.02


@final
@dataclass(frozen=True, kw_only=True)
class Taken:
    """How taking part went.

    Attributes:
        name: of this member.
        seat: index of the user; None if it never had one.
        status: the last; None before the first step.
        why: it ended: "time", "ended" (by the host) or "stopped".
        pace: of its steps, as the pacer counted.
        recorded: steps in the recording; None without.
        device: its name, what was said of it, and how its servo kept pace; None without.
    """

    name: str
    seat: int | None
    status: Status | None
    why: str
    pace: Mapping[str, float]
    recorded: int | None
    device: Mapping[str, Any] | None = None


def fetch_session(control: ControlPlane, digest: bytes, folder: Path) -> SessionFile:
    """The session's file and meshes, from whoever has them.

    Args:
        control: the control plane.
        digest: SHA-256 of the description.
        folder: an empty, private one for the meshes.

    Raises:
        TransportError: nobody answers.
        SessionError: what came is no session of this version.
    """
    content = _fetched(control, digest, _PATIENCE)
    files = {name: _fetched(control, wanted, _FILE_PATIENCE) for name, wanted in SessionFile.needed(content).items()}
    return SessionFile.from_content(content, files, folder=folder)


def join(
    invitation: Invitation,
    *,
    name: str,
    hand: HandKind = "scripted",
    device: str | None = None,
    seconds: float | None = None,
    listen: str | None = None,
    record: Path | None = None,
    version: str,
    boards: Path | None = None,
    unsafe: bool = False,
    warn: Callable[[str], None] | None = None,
    say: Callable[[str], None] | None = None,
    stopped: Callable[[], bool] = lambda: False,
) -> Taken:
    """Takes part until time is up, the host ends the session, or it is told to stop.

    Args:
        invitation: to the session.
        name: that others see.
        hand: what moves the copy: what the session's file says for its seat, or nothing.
        device: that moves the copy instead, in the words of `cotouch.haptics.DeviceChoice.read`; None: none.
        seconds: how long, from the first step; None: until the end.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.
        record: file to record into; must not exist.
        version: of this software.
        boards: folder of the boards by which this member is shown and told things on this machine; see `_boards`.
        unsafe: whether it may be told to take less damping than passivity needs.
        warn: is told in a sentence why a device's force is off.
        say: is told in a few words what takes time.
        stopped: whether to stop now.

    Raises:
        SessionError: it may not take part.
        TransportError: the host, the network or this machine refuses.
        DeviceError: the device does not open.
    """
    few_arenas()
    identity = Identity.make(os.urandom)
    tell = say or _nobody
    if device is not None:
        tell("opening the device")
    with held_device(device, warn or _nobody) as held:
        return _join(
            invitation,
            identity,
            held,
            name=name,
            hand=hand,
            seconds=seconds,
            listen=listen,
            record=record,
            version=version,
            boards=boards,
            unsafe=unsafe,
            tell=tell,
            stopped=stopped,
        )


def _join(
    invitation: Invitation,
    identity: Identity,
    held: HeldDevice,
    *,
    name: str,
    hand: HandKind,
    seconds: float | None,
    listen: str | None,
    record: Path | None,
    version: str,
    boards: Path | None,
    unsafe: bool,
    tell: Callable[[str], None],
    stopped: Callable[[], bool],
) -> Taken:
    tell("joining")
    control = ZenohControl(invitation, identity, listen=listen or "reachable")
    try:
        with TemporaryDirectory(prefix="cotouch-") as folder:
            tell("fetching the session")
            session = fetch_session(control, invitation.digest, Path(folder))
            replica = Replica.build(session)
        for file in (session.content, *session.files.values()):
            control.offer(file)
        told = boards is not None
        if compiles(session, touched=told and replica.body.skin is not None):
            tell("compiling, once on this machine, which takes a minute or two")
        warm_up(replica, partial(_hand, session, replica, hand, held.unheld, 0, told=told))
        tell("waiting for a seat")
        return _take_part(
            session,
            replica,
            control,
            invitation,
            held,
            name=name,
            hand=hand,
            seconds=seconds,
            listen=listen,
            record=record,
            version=version,
            boards=boards,
            unsafe=unsafe,
            stopped=stopped,
        )
    finally:
        control.close()


def _take_part(
    session: SessionFile,
    replica: Replica,
    control: ZenohControl,
    invitation: Invitation,
    held: HeldDevice,
    *,
    name: str,
    hand: HandKind,
    seconds: float | None,
    listen: str | None,
    record: Path | None,
    version: str,
    boards: Path | None,
    unsafe: bool,
    stopped: Callable[[], bool],
) -> Taken:
    clock = time.monotonic
    own = control.endpoint
    udp = UdpTransport(host=listen or (own.host if own is not None else "0.0.0.0"), clock=clock)  # noqa: S104
    routed = RoutedTransport(
        udp,
        control,
        session=invitation.id,
        secret=invitation.derive(b"samples", 32),
        entropy=os.urandom,
        mirrors=[Address(*endpoint) for endpoint in invitation.endpoints],
    )
    worse = session.options.emulate or boards is not None
    impaired = ImpairedTransport(routed, {}, clock=clock) if worse else None
    key = control.identity.public
    tape = None if record is None else Tape(record, session, replica, name=name, key=key)
    window = None
    if boards is not None:
        window = Window(BoardFolder(boards), name, session, replica, key=key, unsafe=unsafe, recorder=tape)

    def taken(seat: int, model: Model) -> Hand:
        pacer.restart(session.period(seat))
        pace.restart(session.period(seat))
        if impaired is not None and session.options.emulate:
            for other, law in path_laws(session.scenario, seat).items():
                impaired.set(other, law)
        return _hand(session, replica, hand, held, seat, model, window=window, told=window is not None)

    listening = _Listening(impaired)

    def tend(now: float) -> None:
        held.tend(tape, now)
        for change in routed.events():
            if tape is not None:
                tape.event("way", change.time, seat=change.neighbour, reason=change.way.name.lower())
        if window is not None:
            window.service(now, member.seat, impaired)
            if member.copy is not None:
                member.copy.give_damping(window.damping, now)

    pacer = Pacer(session.period(0), cap=session.options.longest_step, clock=clock, idle=listening)
    pace = Pace(session.period(0))
    member = Member(
        session=session,
        replica=replica,
        control=control,
        ways=RoutedWays(routed, impaired),
        host=invitation.host,
        name=name,
        version=version,
        hand=taken,
        entropy=os.urandom,
        secret=invitation.derive(b"links", 32),
        recorder=tape if window is None else window,
        pace=pace.since,
        delays=None if window is None else lambda: window.delays,
    )
    listening.member = member
    try:
        with prepare_process():
            why = _loop(member, pacer, pace, clock, tend, seconds=seconds, stopped=stopped)
        status = member.status(clock())
        member.leave()
        return Taken(
            name=name,
            seat=member.seat,
            status=status,
            why=why,
            pace=pace_numbers(pacer.statistics()),
            recorded=None if tape is None else tape.close(),
            device=held.summary(),
        )
    finally:
        if window is not None:
            window.close()
        if tape is not None:
            tape.close()
        (routed if impaired is None else impaired).close()


@final
class _Listening:
    """What the loop does while it waits: it reads samples, and lets go of what an emulated network held back.

    Attributes:
        member: whose samples.
    """

    def __init__(self, impaired: ImpairedTransport | None) -> None:
        self.member: Member | None = None
        self._impaired = impaired

    def due(self) -> float:
        """When the next datagram leaves the emulated network; inf: there is none [s]."""
        return math.inf if self._impaired is None else self._impaired.due

    def look(self, now: float) -> None:
        """Reads what arrived."""
        if self.member is not None:
            self.member.listen(now)


def _loop(
    member: Member,
    pacer: Pacer,
    pace: Pace,
    clock: Callable[[], float],
    tend: Callable[[float], None],
    *,
    seconds: float | None,
    stopped: Callable[[], bool],
) -> str:
    began: float | None = None
    service = -float("inf")
    while True:
        now, T, stood = pacer.wait()
        if member.step(now, T) and began is None:
            began = now
            pacer.restart()  # making the copy took longer than a step; nobody waited for one yet
            pace.restart()
        if now >= service or member.pending:
            service = now + _SERVICE_EVERY
            member.service(now)
            tend(now)
            if stopped():
                return "stopped"
        pace.stepped(T, stood, clock() - now + pacer.worked)
        if member.ended:
            return "ended"
        if seconds is not None and began is not None and now - began >= seconds:
            return "time"


def _hand(
    session: SessionFile,
    replica: Replica,
    kind: HandKind,
    held: HeldDevice,
    seat: int,
    model: Model,
    *,
    window: Window | None = None,
    told: bool = False,
) -> Hand:
    if held.wanted:
        driven = DeviceHand(
            replica.scenario,
            replica.body,
            model,
            seat=seat,
            period=session.period(seat),
            longest=session.options.longest_step,
            link=held.link,
        )
        if window is not None:
            window.holds(driven, seat, told=False)
        return driven
    if told:
        hand = ToldHand(
            replica.scenario,
            replica.body,
            model,
            seat=seat,
            period=session.period(seat),
            longest=session.options.longest_step,
            scripted=kind == "scripted",
            wishes=(lambda: None) if window is None else window.wishes,
        )
        if window is not None:
            window.holds(hand, seat, told=True)
        return hand
    if kind == "none":
        return NoHand(model)
    return ScriptedHand(
        replica.scenario,
        replica.body,
        model,
        seat=seat,
        period=session.period(seat),
        longest=session.options.longest_step,
    )


def _nobody(text: str) -> None:
    """Hears nothing."""


def _fetched(control: ControlPlane, digest: bytes, patience: float) -> bytes:
    end = time.monotonic() + patience
    while (content := control.fetch(digest)) is None:
        if time.monotonic() > end:
            who = "nobody of the session answers" if not control.present() else "nobody has the session's file"
            raise TransportError(f"{who} within {patience:.0f} s; check that the host runs and can be reached")
        time.sleep(_WAIT)
    return content
