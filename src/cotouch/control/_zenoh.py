"""What all that speaks Zenoh here has in common: configuration, opening, closing. Zenoh loads on first use."""

import base64
import contextlib
import json
import threading
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, Protocol

from cotouch.control._certificates import TlsCertificates
from cotouch.control._invitation import Endpoint
from cotouch.errors import TransportError

if TYPE_CHECKING:
    import zenoh

# After which a silent neighbour is gone [s].
LEASE = 1.5
# One chunk of a file and its envelope: what is longer is not put together at all.
_MOST_MESSAGE = 1 << 20
# Opening takes four ways there and back, of up to 2 s each in the paper's network; who was found by gossip is dialled
# only once [ms].
_OPENING = 10_000
# A client can hang at its end; nobody waits longer for it.
_CLOSING = 2.0
# What any call of Zenoh takes, at most [s].
_LAST = 12.0
# How Zenoh says that a port is taken; for how long one is waited for, and how often looked at [s].
_TAKEN = "already in use"
_LEAVING, _LOOK = 3.0, 0.1


class _Ended(Protocol):
    """What ends by `undeclare`, of which Zenoh does not say that it returns nothing."""

    def undeclare(self) -> object: ...


class _Spoken(Protocol):
    """What of a session of Zenoh speaks and ends, likewise."""

    def put(
        self,
        key_expr: str,
        payload: bytes,
        *,
        congestion_control: "zenoh.CongestionControl",
        priority: "zenoh.Priority",
        express: bool,
    ) -> object: ...

    def close(self) -> object: ...


Mode = Literal["peer", "client", "router"]
Priority = Literal["INTERACTIVE_HIGH", "INTERACTIVE_LOW", "DATA_HIGH"]


def configuration(
    mode: Mode,
    certificates: TlsCertificates,
    *,
    listen: Sequence[Endpoint] = (),
    inner: str | None = None,
    connect: Sequence[Endpoint] = (),
    dial: bool = True,
) -> str:
    """Zenoh's configuration for one session.

    Args:
        mode: peers speak with each other, clients through routers.
        certificates: of this member; keys go in by value, so nothing of them is written to disk.
        listen: where it listens; nowhere else.
        inner: address of this machine where it also listens, on any free port, for its gate.
        connect: whom it dials, again and again until there is an answer.
        dial: whether a peer dials those of whom it hears from others.
    """
    pem = {name: base64.b64encode(value).decode() for name, value in certificates._asdict().items()}
    tls = {
        "root_ca_certificate_base64": pem["authority"],
        "listen_certificate_base64": pem["certificate"],
        "listen_private_key_base64": pem["key"],
        "connect_certificate_base64": pem["certificate"],
        "connect_private_key_base64": pem["key"],
        "enable_mtls": True,
        # Certificates say "was invited"; they name no machine.
        "verify_name_on_connect": False,
        "close_link_on_expiration": False,
    }
    # Mutual dialling can split a session, so one of the two dials: the one with the greater id.
    gossip = {
        "enabled": True,
        "autoconnect": {"router": [], "peer": ["peer"] if dial else []},
        "autoconnect_strategy": {"peer": {"to_router": "always", "to_peer": "greater-zid"}},
    }
    made = {
        "mode": mode,
        "listen": {
            "endpoints": [*map(_locator, listen), *([f"tls/{inner}:0"] if inner and listen else [])],
            "exit_on_failure": True,
        },
        "connect": {
            "endpoints": [_locator(endpoint) for endpoint in connect],
            "timeout_ms": {"client": 3000, "peer": -1, "router": -1},
            "exit_on_failure": {"client": True, "peer": False, "router": False},
            "retry": {"period_init_ms": 200, "period_max_ms": 500, "period_increase_factor": 1.5},
        },
        # Who is there is seen by presence; opening need not wait for it.
        "open": {"return_conditions": {"connect_scouted": False}},
        "scouting": {"delay": 0, "multicast": {"enabled": False}, "gossip": gossip},
        # Nobody reads or changes another's configuration, and nothing is loaded that could let them.
        "adminspace": {"enabled": False, "permissions": {"read": False, "write": False}},
        "plugins_loading": {"enabled": False},
        "transport": {
            "shared_memory": {"enabled": False},
            "unicast": {"open_timeout": _OPENING, "accept_timeout": _OPENING},
            "link": {
                "protocols": ["tls"],
                "tls": tls,
                "rx": {"max_message_size": _MOST_MESSAGE},
                "tx": {
                    "lease": round(1000 * LEASE),
                    # A relayed datagram is of use now or never.
                    "queue": {"congestion_control": {"drop": {"wait_before_drop": 0}}},
                },
            },
        },
    }
    return json.dumps(made)


def open_session(configured: str) -> "zenoh.Session":
    """Opens a session of Zenoh.

    A port that is taken is waited for a while: whoever had it may have been killed, and its gatekeeper about to end.

    Raises:
        TransportError: a port is taken, an address is not this machine's, or no router answers.
    """
    import zenoh

    end = time.monotonic() + _LEAVING
    while True:
        try:
            return zenoh.open(zenoh.Config.from_json5(configured))
        except zenoh.ZError as error:
            if _TAKEN not in str(error) or time.monotonic() > end:
                raise _explained(error, configured) from error
        time.sleep(_LOOK)


def _explained(error: Exception, configured: str) -> TransportError:
    """Why a session of Zenoh cannot be opened, in a sentence."""
    given = json.loads(configured)
    outer = (name for name in given["listen"]["endpoints"] if not name.endswith(":0"))
    listen = ", ".join(name.removeprefix("tls/") for name in outer)
    connect = ", ".join(name.removeprefix("tls/") for name in given["connect"]["endpoints"])
    text = str(error)
    known = {
        _TAKEN: f"the port of {listen} is taken; choose another",
        "Cannot assign": f"{listen} is not an address of this machine; listen on one that is",
        "Permission denied": f"the port of {listen} is not permitted; choose one of 1024 or above",
        "Unable to connect": f"no router of this session answers at {connect}; check that it runs and is invited",
    }
    return TransportError(
        next((said for sign, said in known.items() if sign in text), f"the control plane cannot open: {text}")
    )


def put(session: _Spoken, key: str, said: bytes, *, priority: Priority, wait: bool = False) -> bool:
    """Says something at once; whether the session took it, which one that closes does not.

    Args:
        session: that carries it.
        key: under which it is said.
        said: what is said.
        priority: among all that this session says.
        wait: for room on the way to who reads slowly; otherwise it is dropped for these.
    """
    import zenoh

    control = zenoh.CongestionControl.BLOCK if wait else zenoh.CongestionControl.DROP
    urgency = getattr(zenoh.Priority, priority)
    try:
        session.put(key, said, congestion_control=control, priority=urgency, express=True)
    except zenoh.ZError:
        return False
    return True


def close_session(
    session: _Spoken,
    users: Sequence[threading.Thread] = (),
    token: _Ended | None = None,
) -> None:
    """Closes a session of Zenoh, and waits for it a little.

    Args:
        session: to be closed.
        users: threads that may be in Zenoh still and end soon; Python does not end before they are out of it.
        token: that says that it is there; None: nothing does.
    """
    import zenoh

    def close() -> None:
        with contextlib.suppress(zenoh.ZError):
            # First: a session that is dialling somebody who does not answer keeps its links for ten seconds more.
            if token is not None:
                token.undeclare()
        with contextlib.suppress(zenoh.ZError):  # it waits for links that are gone, and says so
            session.close()
        for user in users:
            user.join(_LAST)

    # Not a daemon: a thread that comes back from Zenoh while Python ends takes the process down ("FATAL: exception not
    # rethrown"), and Python waits for those that are none. Zenoh gives up after 10 s.
    closing = threading.Thread(target=close, name="cotouch closing")
    closing.start()
    closing.join(_CLOSING)


def _locator(endpoint: Endpoint) -> str:
    return f"tls/{endpoint}"
