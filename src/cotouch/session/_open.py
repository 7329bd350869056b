"""Opening a session from this process, and watching one."""

import os
from collections.abc import Generator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import final

from cotouch.control import Endpoint, Invitation, ZenohControl, free_port
from cotouch.errors import SessionError
from cotouch.members import Admission, Host, SessionFile, SessionWatch, SharedModel, addresses_of
from cotouch.pacing import few_arenas
from cotouch.samples import Identity, UdpTransport
from cotouch.session._join import looking_on
from cotouch.session._keep import KeptHost, keep_host, kept_host
from cotouch.session._planner import LinkPlanner
from cotouch.traversal import Addresses, RoutedTransport

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
    _fingerprint: Future[list[float]]

    def service(self, now: float) -> None:
        """Hears, decides, says; to be called some fifty times a second.

        Args:
            now: on the monotonic clock [s].

        Raises:
            InputError: the body of the session cannot be built.
        """
        admission = self.host.coordinator.admission
        if admission.fingerprint is None and self._fingerprint.done():
            admission.fingerprint = self._fingerprint.result()
        self._mirror.poll()  # tells members how they are seen from here
        self.host.service(now)


@contextmanager
def open_host(
    session: SessionFile, *, listen: str = "127.0.0.1", port: int | None = None, key_file: Path | None = None
) -> Generator[OpenHost]:
    """Opens a session.

    Args:
        session: what is asked for.
        listen: address in numbers that members reach this machine by.
        port: of TCP and UDP; None: a free one.
        key_file: file with the session's keys and its last roster, made if it is not there; with it a host that was
            ended or crashed goes on with the same invitation and the same people. Whoever reads it can be the host.

    Raises:
        SessionError: the address is none, or the file is of another session.
        TransportError: the port is taken.
        OutputError: the keys cannot be kept.
    """
    few_arenas()
    kept = (
        kept_host(key_file, session) if key_file is not None and key_file.exists() else _new_host(session, listen, port)
    )
    if key_file is not None and kept.decision is None:
        keep_host(key_file, kept)
    identity, invitation = kept.identity, kept.invitation
    at = invitation.endpoints[0]
    with ExitStack() as stack:
        control = stack.enter_context(closing(ZenohControl(invitation, identity)))
        planner = stack.enter_context(closing(LinkPlanner(session))) if session.options.links == "plan" else None
        addresses = Addresses(os.urandom)
        mirror = RoutedTransport(
            UdpTransport(host=at.host, port=at.port),
            control,
            session=invitation.id,
            secret=invitation.derive(b"samples", 32),
            entropy=os.urandom,
            addresses=addresses,
        )
        stack.callback(mirror.close)
        each = session.options.per_address or -(-session.slots // 2)
        admission = Admission(session, fingerprint=None, each=each, where=addresses_of(addresses, {at.host}))
        host = Host(
            session,
            control,
            planner=planner,
            admission=admission,
            kept=kept.decision,
            keep=None if key_file is None else lambda decision: keep_host(key_file, kept._replace(decision=decision)),
        )
        # Worked out beside: a large mesh takes a while, as it does for those who join.
        beside = ThreadPoolExecutor(1, thread_name_prefix="cotouch body")
        stack.callback(beside.shutdown, wait=False, cancel_futures=True)
        yield OpenHost(invitation, host, control, mirror, beside.submit(_fingerprint, session))


def _new_host(session: SessionFile, listen: str, port: int | None) -> KeptHost:
    if listen in {"0.0.0.0", "::"}:  # noqa: S104 - compared, not bound
        raise SessionError(
            f"{listen} stands for all addresses of this machine, which no invitation can name; give the one at which "
            "others reach it"
        )
    identity = Identity.make(os.urandom)
    invitation = Invitation.make(
        session=(session.scenario.title or "cotouch session")[:_MOST_TITLE],
        digest=session.digest,
        host=identity.public,
        endpoints=(Endpoint(listen, port if port is not None else free_port(listen)),),
        entropy=os.urandom,
    )
    return KeptHost(identity, invitation, None)


def _fingerprint(session: SessionFile) -> list[float]:
    """Of what travels, not of what lies on this machine's disk by now."""
    with TemporaryDirectory(prefix="cotouch-") as folder:
        return SharedModel.build(
            SessionFile.from_content(session.content, session.files, folder=Path(folder))
        ).fingerprint


@contextmanager
def watching(invitation: Invitation, *, listen: str | None = None) -> Generator[SessionWatch]:
    """Observes a session without taking part.

    Args:
        invitation: to the session.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.

    Raises:
        TransportError: the network or this machine refuses.
    """
    with looking_on(invitation, listen) as control:
        yield SessionWatch(control, host=invitation.host)
