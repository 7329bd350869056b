"""Opening a session from this process, and watching one."""

import json
import os
import time
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import final

from cotouch.errors import SessionError, TransportError
from cotouch.live import (
    Endpoint,
    Identity,
    Invitation,
    RoutedTransport,
    UdpTransport,
    ZenohControl,
    few_arenas,
    free_port,
)
from cotouch.session._file import SessionFile
from cotouch.session._host import Host
from cotouch.session._planner import LinkPlanner
from cotouch.session._watch import Watch

_MOST_TITLE = 40


@final
@dataclass(frozen=True, eq=False)
class OpenHost:
    """A host that runs in this process.

    Attributes:
        invitation: to the session.
        host: decides who takes part.
        control: the control plane.
    """

    invitation: Invitation
    host: Host
    control: ZenohControl
    _mirror: RoutedTransport

    def service(self, now: float) -> None:
        """Hears, decides, says; to be called some fifty times a second.

        Args:
            now: on the monotonic clock [s].
        """
        self._mirror.poll()  # tells members how they are seen from here
        self.host.service(now)


@contextmanager
def open_host(
    session: SessionFile, *, listen: str = "127.0.0.1", port: int | None = None, keep: Path | None = None
) -> Generator[OpenHost]:
    """Opens a session.

    Args:
        session: what is asked for.
        listen: address in numbers that members reach this machine by.
        port: of TCP and UDP; None: a free one.
        keep: file with the session's keys, made if it is not there; with it a host that was ended or crashed goes on
            with the same invitation. Whoever reads it can be the host.

    Raises:
        SessionError: the address is none, or the file is of another session.
        TransportError: the port is taken.
    """
    few_arenas()
    identity, invitation = _kept(keep, session) if keep is not None and keep.exists() else (None, None)
    resumed = identity is not None
    if identity is None or invitation is None:
        identity = Identity.make(os.urandom)
        invitation = Invitation.make(
            session=(session.scenario.title or "cotouch session")[:_MOST_TITLE],
            digest=session.digest,
            host=identity.public,
            endpoints=(Endpoint(listen, port if port is not None else free_port(listen)),),
            entropy=os.urandom,
        )
        if keep is not None:
            _keep(keep, identity, invitation)
    at = invitation.endpoints[0]
    planner = LinkPlanner(session) if session.options.links == "plan" else None
    control = ZenohControl(invitation, identity)
    try:
        mirror = RoutedTransport(
            UdpTransport(host=at.host, port=at.port),
            control,
            session=invitation.id,
            secret=invitation.derive(b"samples", 32),
            entropy=os.urandom,
        )
        try:
            host = Host(session, control, planner=planner, resumed=resumed)
            yield OpenHost(invitation, host, control, mirror)
        finally:
            mirror.close()
    finally:
        if planner is not None:
            planner.close()
        control.close()


@contextmanager
def watching(invitation: Invitation, *, listen: str | None = None) -> Generator[Watch]:
    """Sees a session without taking part.

    Args:
        invitation: to the session.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.

    Raises:
        TransportError: the network or this machine refuses.
    """
    control = ZenohControl(invitation, Identity.make(os.urandom), listen=listen or "reachable")
    try:
        yield Watch(control, host=invitation.host)
    finally:
        control.close()


def _keep(path: Path, identity: Identity, invitation: Invitation) -> None:
    """Writes the keys for their owner alone, whole or not at all."""
    text = json.dumps({"identity": identity.secret.hex(), "invitation": invitation.encode()})
    beside = path.with_name(f".{path.name}.{os.getpid()}.{time.monotonic_ns()}")
    try:
        with os.fdopen(os.open(beside, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
            file.write(text)
        beside.replace(path)
    except OSError as error:
        beside.unlink(missing_ok=True)
        raise TransportError(f"the keys cannot be kept in {path}: {error.strerror}") from error


def _kept(path: Path, session: SessionFile) -> tuple[Identity, Invitation]:
    try:
        kept = json.loads(path.read_text(encoding="utf-8"))
        identity = Identity(bytes.fromhex(kept["identity"]))
        invitation = Invitation.decode(kept["invitation"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise SessionError(f"{path} does not hold the keys of a session; name a file that is not there yet") from error
    if invitation.digest != session.digest or invitation.host != identity.public:
        raise SessionError(f"{path} holds the keys of another session; name a file that is not there yet")
    return identity, invitation
