"""What a member opens at one address: Zenoh's session, its gate, and who introduces. Another address, another line."""

import os
import threading
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, final

from cotouch.control._certificates import make_certificates
from cotouch.control._gate import Gate, inner_endpoint
from cotouch.control._introducer import Introducer
from cotouch.control._invitation import Endpoint, Invitation
from cotouch.control._listening import advertised
from cotouch.control._zenoh import Mode, close_session, configuration, open_session

if TYPE_CHECKING:
    import zenoh


@final
class Line:
    """One way of a member into its session.

    Attributes:
        own: where others find this member; None behind routers.
        session: of Zenoh.
    """

    def __init__(
        self,
        invitation: Invitation,
        at: Sequence[Endpoint],
        *,
        mode: Mode,
        connect: Sequence[Endpoint],
    ) -> None:
        """Opens it.

        Args:
            invitation: to the session.
            at: where it listens.
            mode: a peer, or behind routers a client.
            connect: whom it dials.

        Raises:
            TransportError: the address is taken or not this machine's, or no router answers.
        """
        certificates = make_certificates(invitation, entropy=os.urandom)
        inner = inner_endpoint(os.urandom)
        self.own = advertised(at[0], invitation) if at else None
        self.session = open_session(configuration(mode, certificates, listen=at, inner=inner, connect=connect))
        self._token: zenoh.LivelinessToken | None = None
        self._gate = None if inner is None or not at else Gate(at, inner, certificates)
        self._introducer: Introducer | None = None  # behind routers, the routers introduce
        if self.own is not None:

            def beside(endpoints: Sequence[Endpoint]) -> "zenoh.Session":
                return open_session(configuration("peer", certificates, connect=endpoints, dial=False))

            self._introducer = Introducer(self.own, beside, time.monotonic)

    def show(self, key: str) -> None:
        """Shows others that it is there, until it closes.

        Args:
            key: of this start.
        """
        self._token = self.session.liveliness().declare_token(key)

    def back(self, member: bytes) -> None:
        """This member is connected again."""
        if self._introducer is not None:
            self._introducer.back(member)

    def gone(self, member: bytes, at: Endpoint | None) -> None:
        """This member is no longer connected; it is looked for where it listened.

        Args:
            member: public key.
            at: where it listened.
        """
        if self._introducer is not None and at is not None:
            self._introducer.gone(member, at)

    def close(self, users: Sequence[threading.Thread] = ()) -> None:
        """Leaves; waits a few seconds at most.

        Args:
            users: threads that may be in Zenoh still and end soon.
        """
        users = list(users)
        if self._introducer is not None:
            self._introducer.close()
            users.append(self._introducer.thread)
        close_session(self.session, [user for user in users if user.is_alive()], self._token)
        if self._gate is not None:
            self._gate.close()
