"""A router of one session, over Eclipse Zenoh with mutual TLS."""

import os
from collections.abc import Sequence
from typing import final

from cotouch.control._certificates import make_certificates
from cotouch.control._gate import Gate, inner_endpoint
from cotouch.control._invitation import Endpoint, Invitation, checked
from cotouch.control._zenoh import close_session, configuration, open_session


@final
class ControlRouter:
    """Connects members of a session that cannot reach each other: carries their messages, but cannot change them.

    It is invited like a member, and reads what passes.
    """

    def __init__(
        self,
        invitation: Invitation,
        *,
        listen: Sequence[Endpoint],
    ) -> None:
        """Opens it.

        Args:
            invitation: to the session.
            listen: where members find it.

        Raises:
            TransportError: a port is taken, or an address is not this machine's.
        """
        certificates = make_certificates(invitation, entropy=os.urandom)
        at = [checked(endpoint) for endpoint in listen]
        inner = inner_endpoint(os.urandom)
        self._session = open_session(configuration("router", certificates, listen=at, inner=inner))
        self._gate = None if inner is None or not at else Gate(at, inner, certificates)

    def close(self) -> None:
        """Ends it."""
        close_session(self._session)
        if self._gate is not None:
            self._gate.close()
