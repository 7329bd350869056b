"""What is asked of the Inverse Service, or told to it, beside the session that holds a device."""

import contextlib
import http.client
import json
import time
from collections.abc import Iterator
from urllib.parse import urlsplit

import numpy as np

from cotouch.drivers._inverse_frame import identities, named, read_frame
from cotouch.drivers._inverse_session import command
from cotouch.drivers._websocket import WebSocket
from cotouch.files import list_of, table_of

SERVICE = "ws://localhost:10001"
WHAT = "the Inverse Service"
# For a service to send its first frame; to answer who else is there [s].
_FIRST, _WHO = 0.5, 0.5
_MOST_BYTES, _MOST_NAMES = 1 << 18, 4


def halt(identity: str | None, *, url: str = SERVICE) -> None:
    """Tells the service zero force from elsewhere; blocks for 50 ms at most and never raises.

    Args:
        identity: `device_id` of the device; None: every Inverse3 that the service knows.
        url: of the service.
    """
    end = time.monotonic() + 0.045
    with contextlib.suppress(Exception):
        link = WebSocket(url, what=WHAT, timeout=0.03)
        try:
            first = link.receive(max(0.0, end - time.monotonic() - 0.01))
            there = identities(read_frame(first)) if first is not None else []
            for number, each in enumerate([identity] if identity is not None else there):
                link.send(command(each, np.zeros(3), first=number == 0))
            link.receive(max(0.0, end - time.monotonic()))
        finally:
            link.close()


def present(url: str = SERVICE) -> list[str]:
    """Identities of the Inverse3 that a service on this machine knows; none if there is no service."""
    with contextlib.suppress(Exception):
        link = WebSocket(url, what=WHAT, timeout=0.2)
        try:
            first = link.receive(_FIRST)
            return identities(read_frame(first)) if first is not None else []
        finally:
            link.close()
    return []


def holders(url: str) -> str:
    """Which sessions the service has, in words: one of them holds a device that is in use.

    Args:
        url: of the service.
    """
    names: list[str] = []
    with contextlib.suppress(Exception):
        at = urlsplit(url)
        asked = http.client.HTTPConnection(at.hostname or "", at.port or 80, timeout=_WHO)
        try:
            asked.request("GET", "/sessions")
            names = list(dict.fromkeys(_profiles(json.loads(asked.getresponse().read(_MOST_BYTES)))))
        finally:
            asked.close()
    if not names:
        return "another program, which has not told the service its name"
    return " or ".join(f'"{name}"' for name in names[:_MOST_NAMES])


def _profiles(said: object) -> Iterator[str]:
    """Names of profiles in a list of sessions, or in an envelope around one."""
    envelope = table_of(said)
    if envelope is not None:
        said = next((envelope[key] for key in ("data", "sessions") if key in envelope), None)
        inner = table_of(said)
        if inner is not None:
            said = inner.get("sessions", list(inner.values()))
    for session in list_of(said) or []:
        name = named(session)
        if name:
            yield name
