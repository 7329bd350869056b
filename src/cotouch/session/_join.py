"""Joining a session from this process: what opens sockets and fetches what the others have."""

import os
import socket
import time
from collections.abc import Callable, Generator
from contextlib import closing, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from cotouch.control import ControlPlane, Invitation, ZenohControl
from cotouch.errors import TransportError
from cotouch.interrupt import interruptible
from cotouch.members import Participation, ParticipationOutcome, SessionFile, SharedModel, Slot
from cotouch.pacing import few_arenas
from cotouch.recording import NewFile
from cotouch.samples import Identity
from cotouch.session._held import held_device
from cotouch.session._keep import KeptIdentity
from cotouch.session._playing import hand_of, take_part
from cotouch.session._warm import compiles, warm_up

# The host answers at once, if it is there and reachable; a large mesh takes longer, but comes in pieces [s].
_PATIENCE = 20.0
_FILE_PATIENCE = 120.0
_WAIT = 0.02
# Whether anybody listens where the invitation leads is looked at so often, and an answer is waited for so long [s].
_LOOK, _ANSWER = 2.0, 1.0


def fetch_session(control: ControlPlane, invitation: Invitation, folder: Path) -> SessionFile:
    """The session's file and meshes, from any member that has them.

    Args:
        control: the control plane.
        invitation: names them, and where somebody is to be found.
        folder: an empty, private one for the meshes.

    Raises:
        TransportError: nobody answers.
        SessionError: what came is no session of this version.
    """
    content = _fetched(control, invitation, invitation.digest, _PATIENCE)
    files = {
        name: _fetched(control, invitation, wanted, _FILE_PATIENCE)
        for name, wanted in SessionFile.needed(content).items()
    }
    return SessionFile.from_content(content, files, folder=folder)


def join(
    invitation: Invitation,
    part: Participation,
    *,
    warn: Callable[[str], None] | None = None,
    say: Callable[[str], None] | None = None,
    stopped: Callable[[], bool] = lambda: False,
) -> ParticipationOutcome:
    """Takes part until time is up, the host ends the session, or it is told to stop.

    Args:
        invitation: to the session.
        part: how.
        warn: is told in a sentence, at once, why a device's force is off, why nothing is recorded any more, or that
            this member's key cannot be kept.
        say: is told in a few words what takes time.
        stopped: whether to stop now.

    Raises:
        SessionError: it may not take part.
        TransportError: the host, the network or this machine refuses.
        DeviceError: the device does not open.
        RecordingError: the recording cannot be made.
    """
    tell = say or _nobody
    # First of all: whoever wants a recording that cannot be does not take part without it.
    file = None if part.record is None else NewFile(part.record)
    try:
        return _joined(invitation, part, file, warn or _nobody, tell, stopped)
    finally:
        if file is not None and not file.kept:
            file.discard()


def _joined(
    invitation: Invitation,
    part: Participation,
    file: NewFile | None,
    warn: Callable[[str], None],
    tell: Callable[[str], None],
    stopped: Callable[[], bool],
) -> ParticipationOutcome:
    few_arenas()
    if part.device is not None:
        tell("opening the device")
    with held_device(part.device, warn) as held, _identity(invitation, part, warn) as identity:
        tell("joining")
        with closing(ZenohControl(invitation, identity, listen=part.listen or "reachable")) as control:
            with TemporaryDirectory(prefix="cotouch-") as folder:
                tell("fetching the session")
                session = fetch_session(control, invitation, Path(folder))
                replica = interruptible(SharedModel.build)(session)
            for content in (session.content, *session.files.values()):
                control.offer(content)
            if compiles(session, touched=part.mailboxes is not None and replica.body.skin is not None):
                tell("compiling, once on this machine, which takes a minute or two")
            interruptible(warm_up)(
                replica, lambda model: hand_of(part, held.unheld, Slot.of(session, replica, 0, model))
            )
            tell("waiting for a slot")
            return take_part(
                session, replica, control, invitation, part, held, stopped=stopped, warn=warn, say=tell, file=file
            )


def looking_on(invitation: Invitation, listen: str | None) -> closing[ZenohControl]:
    """The control plane of somebody who takes no part, for a `with`.

    Args:
        invitation: to the session.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.

    Raises:
        TransportError: the network or this machine refuses.
    """
    return closing(ZenohControl(invitation, Identity.make(os.urandom), listen=listen or "reachable"))


@contextmanager
def _identity(invitation: Invitation, part: Participation, warn: Callable[[str], None]) -> Generator[Identity]:
    """Who this member is: as before a crash, if that is kept."""
    kept: KeptIdentity | None = None
    if part.identities is not None:
        try:
            kept = KeptIdentity(part.identities, invitation.id, part.name, os.urandom)
        except TransportError as error:
            warn(f"{error}; after a crash, use another name")
    try:
        yield Identity.make(os.urandom) if kept is None else kept.identity
    finally:
        if kept is not None:
            kept.close()


def _abandoned(invitation: Invitation) -> bool:
    """Whether every machine that the invitation names says that nobody listens there; no answer says nothing."""
    for endpoint in invitation.endpoints:
        try:
            socket.create_connection((endpoint.host, endpoint.port), _ANSWER).close()
        except ConnectionRefusedError:
            continue
        except OSError:
            return False
        return False
    return True


def _nobody(text: str) -> None:
    """Hears nothing."""


def _fetched(control: ControlPlane, invitation: Invitation, digest: bytes, patience: float) -> bytes:
    now = time.monotonic()
    end, look = now + patience, now + _LOOK
    while (content := control.fetch(digest)) is None:
        now = time.monotonic()
        if now > look and not control.present():
            look = now + _LOOK
            if _abandoned(invitation):
                where = " and ".join(f"{one.host}:{one.port}" for one in invitation.endpoints)
                raise TransportError(
                    f"nothing is listening at {where}: the session has ended, or its host is not running"
                )
        if now > end:
            who = (
                "no member of the session answered" if not control.present() else "no member has sent the session file"
            )
            raise TransportError(f"{who} within {patience:.0f} s; check that the host is running and can be reached")
        time.sleep(_WAIT)
    return content
