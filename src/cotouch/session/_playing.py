"""Taking part: what reads the clock and moves the copy in time."""

import math
import os
import time
from collections.abc import Callable
from typing import final

from cotouch.live import (
    Address,
    ImpairedTransport,
    Invitation,
    Pacer,
    RoutedTransport,
    UdpTransport,
    ZenohControl,
    prepare_process,
)
from cotouch.mechanics import Model
from cotouch.session._boards import BoardFolder
from cotouch.session._device_hand import DeviceHand
from cotouch.session._emulate import path_laws
from cotouch.session._file import SessionFile
from cotouch.session._hand import Hand, NoHand, ScriptedHand, Seat
from cotouch.session._held import HeldDevice
from cotouch.session._member import Member
from cotouch.session._pace import Pace, pace_numbers
from cotouch.session._part import Part, Taken
from cotouch.session._replica import Replica
from cotouch.session._tape import Tape
from cotouch.session._told import ToldHand
from cotouch.session._ways import RoutedWays
from cotouch.session._window import Window

_SERVICE_EVERY = 0.02


def take_part(
    session: SessionFile,
    replica: Replica,
    control: ZenohControl,
    invitation: Invitation,
    part: Part,
    held: HeldDevice,
    *,
    stopped: Callable[[], bool],
) -> Taken:
    """Moves a copy in time until its part is over.

    Args:
        session: as the host describes it.
        replica: the body as built here.
        control: the control plane.
        invitation: to the session.
        part: how to take part.
        held: the device, or none.
        stopped: whether to stop now.

    Raises:
        SessionError: it may not take part.
        TransportError: the host, the network or this machine refuses.
    """
    clock = time.monotonic
    own = control.endpoint
    udp = UdpTransport(host=part.listen or (own.host if own is not None else "0.0.0.0"), clock=clock)  # noqa: S104
    routed = RoutedTransport(
        udp,
        control,
        session=invitation.id,
        secret=invitation.derive(b"samples", 32),
        entropy=os.urandom,
        mirrors=[Address(*endpoint) for endpoint in invitation.endpoints],
    )
    worse = session.options.emulate or part.boards is not None
    impaired = ImpairedTransport(routed, {}, clock=clock) if worse else None
    key = control.identity.public
    tape = None if part.record is None else Tape(part.record, session, replica, name=part.name, key=key)
    window = None
    if part.boards is not None:
        boards = BoardFolder(part.boards)
        window = Window(boards, part.name, session, replica, key=key, unsafe=part.unsafe, recorder=tape)

    def taken(seat: int, model: Model) -> Hand:
        pacer.restart(session.period(seat))
        pace.restart(session.period(seat))
        if impaired is not None and session.options.emulate:
            for other, law in path_laws(session.scenario, seat).items():
                impaired.set(other, law)
        return hand_of(part, held, Seat.of(session, replica, seat, model), window)

    listening = _Listening(impaired)

    def tend(now: float) -> None:
        held.tend(tape, now)
        if tape is not None and tape.begun:  # ways may be found before the first step; they are kept until then
            for change in routed.events():
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
        name=part.name,
        version=part.version,
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
            why = _loop(member, pacer, pace, clock, tend, seconds=part.seconds, stopped=stopped)
        status = member.status(clock())
        member.leave()
        return Taken(
            name=part.name,
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


def hand_of(part: Part, held: HeldDevice, seat: Seat, window: Window | None = None) -> Hand:
    """What moves the copy.

    Args:
        part: what is wanted.
        held: the device, or none.
        seat: the copy.
        window: shows the hand and passes orders on; None: there is none yet.

    Raises:
        ScenarioError: a hand, tool or device of the file is wrong.
    """
    if held.wanted:
        driven = DeviceHand(seat, link=held.link)
        if window is not None:
            window.holds(driven, seat.index, told=False)
        return driven
    if part.boards is not None:
        wishes = (lambda: None) if window is None else window.wishes
        hand = ToldHand(seat, scripted=part.hand == "scripted", wishes=wishes)
        if window is not None:
            window.holds(hand, seat.index, told=True)
        return hand
    return NoHand(seat.model) if part.hand == "none" else ScriptedHand(seat)


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
