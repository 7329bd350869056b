"""What whoever runs a host can ask of it while it runs: lines on its standard input."""

import os
import select
import sys
from typing import TYPE_CHECKING, final

from cotouch.errors import CotouchError

if TYPE_CHECKING:
    from cotouch.members import Host

_HELP = "expel NAME (for the rest of the session), release NAME (frees the name of a user who has left), who"
_MOST = 4096


@final
class Console:
    """Reads orders as they are typed; never waits, and reads nothing while the process is in the background."""

    def __init__(self, host: "Host", *, descriptor: int | None = None) -> None:
        """Begins to read.

        Args:
            host: of the session.
            descriptor: what is read; None: standard input.
        """
        self._host = host
        self._line = b""
        try:
            self._descriptor = sys.stdin.fileno() if descriptor is None else descriptor
            self._open = True
        except (OSError, ValueError, AttributeError):
            self._descriptor, self._open = -1, False

    def service(self, now: float) -> None:
        """Does what was typed since the last call, and says what came of it on standard error.

        Args:
            now: [s].
        """
        for line in self._read():
            answer = self.do(line)
            if answer:
                sys.stderr.write(f"cotouch: {answer}\n")
                sys.stderr.flush()
                self._host.watch.note(now, answer)

    def do(self, line: str) -> str:
        """Does one order; what came of it, in words."""
        what, _, name = line.strip().partition(" ")
        name = name.strip().strip('"')
        try:
            match what:
                case "":
                    return ""
                case "expel" if name:
                    self._host.coordinator.expel(name)
                    return f"{name} was expelled and cannot come back with this key"
                case "release" if name:
                    self._host.coordinator.release(name)
                    return f'the name "{name}" is free'
                case "who":
                    return ", ".join(f"{e.slot + 1} {e.name}" for e in self._host.roster.members) or "nobody has joined"
                case _:
                    return f'"{line.strip()[:80]}" is not a command; commands are: {_HELP}'
        except CotouchError as error:
            return str(error)

    def _read(self) -> list[str]:
        if not self._open:
            return []
        try:
            if os.isatty(self._descriptor) and os.tcgetpgrp(self._descriptor) != os.getpgrp():
                return []  # else the system would stop this process
            if not select.select([self._descriptor], [], [], 0.0)[0]:
                return []
            read = os.read(self._descriptor, _MOST)
        except (OSError, ValueError):
            self._open = False
            return []
        self._open = bool(read)
        *lines, self._line = (self._line + read).split(b"\n")
        self._line = self._line[-_MOST:]
        return [line.decode(errors="replace") for line in lines]
