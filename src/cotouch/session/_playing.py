"""Taking part: what reads the clock and moves the copy in time."""

import math
import os
import time
from collections.abc import Callable
from typing import final

from cotouch.control import Invitation, ZenohControl, towards
from cotouch.hands import CommandedHand, DeviceHand
from cotouch.mechanics import Model
from cotouch.members import (
    Admission,
    Coordinator,
    Hand,
    Member,
    NoHand,
    Pace,
    Participation,
    ParticipationOutcome,
    ScriptedHand,
    SessionFile,
    SessionRecorder,
    SharedModel,
    Slot,
    pace_numbers,
    path_laws,
)
from cotouch.observers import MailboxFolder, TelemetryPublisher
from cotouch.pacing import Pacer, prepare_process
from cotouch.recording import NewFile
from cotouch.samples import Address, ImpairedTransport, UdpTransport
from cotouch.session._held import HeldDevice
from cotouch.traversal import Place, RoutedTransport
from cotouch.units import user_number

_SERVICE_EVERY = 0.02
_PRIORITY = 10


def take_part(
    session: SessionFile,
    replica: SharedModel,
    control: ZenohControl,
    invitation: Invitation,
    part: Participation,
    held: HeldDevice,
    *,
    stopped: Callable[[], bool],
    warn: Callable[[str], None],
    say: Callable[[str], None],
    file: NewFile | None = None,
) -> ParticipationOutcome:
    """Moves a copy in time until its part is over.

    Args:
        session: as the host describes it.
        replica: the body as built here.
        control: the control plane.
        invitation: to the session.
        part: how to take part.
        held: the device, or none.
        stopped: whether to stop now.
        warn: is told in a sentence, once, that nothing is recorded any more.
        say: is told in a few words what is waited for, and when the copy moves.
        file: to record into.

    Raises:
        SessionError: it may not take part.
        TransportError: the host, the network or this machine refuses.
    """
    clock = time.monotonic
    session_recorder = None if file is None else SessionRecorder(file, session, replica, name=part.name)
    own = control.endpoint
    udp = UdpTransport(host=part.listen or (own.host if own is not None else "0.0.0.0"), clock=clock)  # noqa: S104
    routed = RoutedTransport(
        udp,
        control,
        session=invitation.id,
        secret=invitation.derive(b"samples", 32),
        entropy=os.urandom,
        mirrors=[Address(*endpoint) for endpoint in invitation.endpoints],
        here=None if part.listen else lambda: towards(invitation),
    )
    worse = session.options.emulate or part.mailboxes is not None
    impaired = ImpairedTransport(routed, {}, clock=clock) if worse else None
    transport = routed if impaired is None else impaired
    telemetry = None
    if part.mailboxes is not None:
        mailboxes = MailboxFolder(part.mailboxes)
        telemetry = TelemetryPublisher(
            mailboxes, part.name, session, replica, unsafe=part.unsafe, recorder=session_recorder
        )

    def taken(slot: int, model: Model) -> Hand:
        pacer.restart(session.period(slot))
        pace.restart(session.period(slot))
        if impaired is not None and session.options.emulate:
            for other, law in path_laws(session.scenario, slot).items():
                impaired.set(other, law)
        return hand_of(part, held, Slot.of(session, replica, slot, model), telemetry)

    listening = _Listening(impaired)
    warned: list[str] = []

    said: list[str] = []

    def tell(text: str | None) -> None:
        if text is not None and said[-1:] != [text]:
            said.append(text)
            say(text)

    def every_service(now: float) -> None:
        if member.replica is not None and member.slot is not None:
            tell(f"ready: {part.name} is user {user_number(member.slot)} of {session.slots}, link law {session.law}")
        elif member.waits_because is not None:
            tell(f"waiting, because {member.waits_because}")
        held.service(session_recorder, now)
        if (
            session_recorder is not None and session_recorder.begun
        ):  # ways may be found before the first step; they are kept until then
            for change in routed.events():
                session_recorder.event(
                    "path", change.time, slot=change.neighbour, reason=change.path_state.name.lower()
                )
        if session_recorder is not None and session_recorder.failure is not None and not warned:
            warned.append(session_recorder.failure)
            warn(f"recording to {part.record} has stopped: {session_recorder.failure}; the session continues")
        if telemetry is not None:
            telemetry.service(now, member.slot, impaired)
            if member.replica is not None:
                member.replica.give_damping(telemetry.damping, now)

    def place() -> Place | None:
        routed.poll()  # before there is a slot nobody else reads what the host answers
        return routed.place

    # Whoever decides while the host is gone is told nobody's address: all who come then share one address's slots.
    each = session.options.per_address or -(-session.slots // 2)
    admission = Admission(session, fingerprint=replica.fingerprint, each=each)
    pacer = Pacer(session.period(0), cap=session.options.max_step, clock=clock, idle=listening)
    pace = Pace(session.period(0))
    member = Member(
        session=session,
        replica=replica,
        control=control,
        paths=routed,
        transport=transport,
        host=invitation.host,
        name=part.name,
        version=part.version,
        hand=taken,
        entropy=os.urandom,
        secret=invitation.derive(b"links", 32),
        recorder=session_recorder if telemetry is None else telemetry,
        pace=pace.since,
        delays=None if telemetry is None else lambda: telemetry.delays,
        device=held.notice,
        coordinator=Coordinator(session, admission=admission),
        place=place,
    )
    listening.member = member
    try:
        with prepare_process(real_time=_PRIORITY if part.real_time else None):
            why = _loop(member, pacer, pace, clock, every_service, seconds=part.seconds, stopped=stopped)
        status = member.status(clock())
        member.leave()
        if session_recorder is not None:
            session_recorder.close()
        return ParticipationOutcome(
            name=part.name,
            slot=member.slot,
            status=status,
            why=why,
            pace=pace_numbers(pacer.statistics()),
            recorded=None if session_recorder is None else session_recorder.recorded,
            trouble=None if session_recorder is None else session_recorder.trouble,
            device=held.summary(),
        )
    finally:
        if telemetry is not None:
            telemetry.close()
        if session_recorder is not None:
            session_recorder.close()
        transport.close()


def hand_of(part: Participation, held: HeldDevice, slot: Slot, telemetry: TelemetryPublisher | None = None) -> Hand:
    """What moves the copy.

    Args:
        part: what is wanted.
        held: the device, or none.
        slot: the copy.
        telemetry: shows the hand and passes orders on; None: there is none yet.

    Raises:
        ScenarioError: a hand, tool or device of the file is wrong.
    """
    if held.wanted:
        driven = DeviceHand(slot, link=held.link)
        if telemetry is not None:
            telemetry.holds(driven, slot.index, commanded=False)
        return driven
    if part.mailboxes is not None:
        requests = (lambda: None) if telemetry is None else telemetry.requests
        hand = CommandedHand(slot, scripted=part.hand == "scripted", requests=requests)
        if telemetry is not None:
            telemetry.holds(hand, slot.index, commanded=True)
        return hand
    return NoHand(slot.model) if part.hand == "none" else ScriptedHand(slot)


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
    every_service: Callable[[float], None],
    *,
    seconds: float | None,
    stopped: Callable[[], bool],
) -> str:
    began: float | None = None
    next_service = -float("inf")
    while True:
        now, T, stood = pacer.wait()
        if member.step(now, T) and began is None:
            began = now
            pacer.restart()  # making the copy took longer than a step; nobody waited for one yet
            pace.restart()
        if now >= next_service or member.pending:
            next_service = now + _SERVICE_EVERY
            member.service(now)
            every_service(now)
            if stopped():
                return "stopped"
        pace.stepped(T, stood, clock() - now + pacer.worked)
        if member.ended:
            return "ended"
        if seconds is not None and began is not None and now - began >= seconds:
            return "time"
