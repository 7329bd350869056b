"""Joining a session from this process: what opens sockets and fetches what the others have."""

import os
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from cotouch.errors import TransportError
from cotouch.live import ControlPlane, Identity, Invitation, ZenohControl, few_arenas
from cotouch.session._file import SessionFile
from cotouch.session._hand import Seat
from cotouch.session._held import held_device
from cotouch.session._part import Part, Taken
from cotouch.session._playing import hand_of, take_part
from cotouch.session._replica import Replica
from cotouch.session._warm import compiles, warm_up

# The host answers at once, if it is there and reachable; a large mesh takes longer, but comes in pieces [s].
_PATIENCE = 20.0
_FILE_PATIENCE = 120.0
_WAIT = 0.02


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
    part: Part,
    *,
    warn: Callable[[str], None] | None = None,
    say: Callable[[str], None] | None = None,
    stopped: Callable[[], bool] = lambda: False,
) -> Taken:
    """Takes part until time is up, the host ends the session, or it is told to stop.

    Args:
        invitation: to the session.
        part: how.
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
    if part.device is not None:
        tell("opening the device")
    with held_device(part.device, warn or _nobody) as held:
        tell("joining")
        control = ZenohControl(invitation, identity, listen=part.listen or "reachable")
        try:
            with TemporaryDirectory(prefix="cotouch-") as folder:
                tell("fetching the session")
                session = fetch_session(control, invitation.digest, Path(folder))
                replica = Replica.build(session)
            for file in (session.content, *session.files.values()):
                control.offer(file)
            if compiles(session, touched=part.boards is not None and replica.body.skin is not None):
                tell("compiling, once on this machine, which takes a minute or two")
            warm_up(replica, lambda model: hand_of(part, held.unheld, Seat.of(session, replica, 0, model)))
            tell("waiting for a seat")
            return take_part(session, replica, control, invitation, part, held, stopped=stopped)
        finally:
            control.close()


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
