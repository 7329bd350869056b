"""How far those who take part are from each other, as their own machines find it."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import final

import numpy as np

from cotouch.control import Invitation
from cotouch.errors import SessionError
from cotouch.members import SessionFile, SessionWatch, delays_of
from cotouch.network import Network, Pair
from cotouch.session._join import fetch_session, looking_on

_POLL = 0.02


@final
@dataclass(frozen=True, kw_only=True)
class MeasuredNetwork:
    """The network of a session as measured.

    Attributes:
        network: of those who are there: their names, the session's springs, measured delays, the links in force. A
            delay is half of the quickest way there and back [s]: without common clocks only their sum can be known.
        missing: pairs of its users that nobody could measure, because they reach each other by the relay only and are
            not linked; their delay is the one in the session's file.
        emulated: whether the session puts delays of its own on the real ones; they are in what was measured.
    """

    network: Network
    missing: list[Pair]
    emulated: bool

    def toml(self) -> str:
        """As a file for `cotouch plan`, with a comment for each pair that was not measured."""
        network = self.network
        names = ", ".join(_text(name) for name in network.users)
        lines = [
            "# Measured: half of the shortest round trip, in each direction.",
            *(["# The session emulates a network, whose delays are included."] if self.emulated else []),
            "[network]",
            f"users = [{names}]",
            "spring = [ # N/m",
            *(f"  [{', '.join(f'{value:g}' for value in row)}]," for row in network.spring),
            "]",
            "delay = [ # s",
            *(f"  [{', '.join(f'{value:.6f}' if value else '0' for value in row)}]," for row in network.delay),
            "]",
            f"links = [{', '.join(f'[{a + 1}, {b + 1}]' for a, b in network.links)}]",
            *(
                f"# {a + 1} and {b + 1} could not be measured; this is the delay in the session file"
                for a, b in self.missing
            ),
        ]
        return "\n".join(lines) + "\n"


def measured_network(watch: SessionWatch, session: SessionFile) -> MeasuredNetwork:
    """What members have reported about their paths so far.

    Args:
        watch: of the session.
        session: its file.

    Raises:
        SessionError: fewer than two take part.
    """
    there = watch.roster.by_slot()
    if len(there) < 2:
        who = f"only {next(iter(there.values())).name}" if there else "nobody"
        raise SessionError(f"{who} takes part in the session; measuring takes at least two members")
    paths = watch.paths()
    slots, whole = sorted(there), session.scenario.network
    chosen = np.ix_(slots, slots)
    index = {slot: n for n, slot in enumerate(slots)}
    pairs = [(a, b) for a in slots for b in slots if a < b]
    network = Network(
        users=[there[slot].name for slot in slots],
        spring=whole.spring[chosen],
        delay=delays_of(whole, paths)[chosen],
        links=[(index[a], index[b]) for a, b in watch.roster.links if a in index and b in index],
    )
    missing = [(index[a], index[b]) for a, b in pairs if (a, b) not in paths]
    return MeasuredNetwork(network=network, missing=missing, emulated=session.options.emulate)


def measure(
    invitation: Invitation,
    *,
    seconds: float,
    listen: str | None = None,
    stopped: Callable[[], bool] = lambda: False,
) -> MeasuredNetwork:
    """Watches a session without taking part.

    Args:
        invitation: to the session.
        seconds: how long; members look back some 10 to 20 s themselves.
        listen: address in numbers to listen on; None: the one by which this machine reaches the host.
        stopped: whether to end now.

    Raises:
        SessionError: fewer than two take part.
        TransportError: nobody answers, or this machine refuses.
    """
    with looking_on(invitation, listen) as control:
        with TemporaryDirectory(prefix="cotouch-") as folder:
            session = fetch_session(control, invitation, Path(folder))
        watch = SessionWatch(control, host=invitation.host, network=session.scenario.network)
        end = time.monotonic() + seconds
        while time.monotonic() < end and not stopped():
            watch.service(time.monotonic())
            time.sleep(_POLL)
        return measured_network(watch, session)


def _text(name: str) -> str:
    return '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"'
