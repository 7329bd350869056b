"""Members as processes of their own on this machine."""

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from typing import Any, final

from cotouch.control import Invitation
from cotouch.processes import ONE_THREAD, start_child

_PATIENCE = 10.0


@final
class MemberProcess:
    """`cotouch join` in a process of its own, which gets the invitation through its standard input, unseen.

    It leaves the session when this process is gone.
    """

    def __init__(self, invitation: Invitation, options: Sequence[str], *, as_json: bool = False) -> None:
        """Starts it.

        Args:
            invitation: to the session.
            options: of `cotouch join`.
            as_json: whether its output is kept, for `result`.
        """
        command = [sys.executable, "-m", "cotouch", "join", "-", *options, *(["--json"] if as_json else [])]
        # A file, because nobody reads a pipe while the process runs.
        self._out = tempfile.TemporaryFile("w+")  # noqa: SIM115
        self._err = tempfile.TemporaryFile("w+")  # noqa: SIM115
        self._process = start_child(
            command,
            stdin=subprocess.PIPE,
            stdout=self._out,
            stderr=self._err if as_json else None,
            text=True,
            env={**os.environ, **ONE_THREAD},
        )
        assert self._process.stdin is not None
        self._process.stdin.write(invitation.encode() + "\n")
        self._process.stdin.close()

    @property
    def pid(self) -> int:
        """Of the process."""
        return self._process.pid

    @property
    def running(self) -> bool:
        """Whether it still is."""
        return self._process.poll() is None

    def kill(self) -> None:
        """Ends it as a crash does."""
        self._process.kill()
        self._process.wait(_PATIENCE)

    def stop(self) -> int:
        """Asks it to leave, waits for it, and returns its exit code."""
        if self.running:
            self._process.terminate()
        try:
            return self._process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            return self._process.wait(_PATIENCE)

    def result(self) -> dict[str, Any] | None:
        """What it printed at its end; None if that is no result."""
        self._out.seek(0)
        try:
            return json.loads(self._out.read())
        except ValueError:
            return None

    def said(self) -> str:
        """All that it printed so far."""
        self._out.seek(0)
        return self._out.read()

    def complaint(self) -> str:
        """The last line that it wrote to standard error."""
        self._err.seek(0)
        lines = self._err.read().strip().splitlines()
        return lines[-1] if lines else ""

    def close(self) -> None:
        """Ends it, if it runs, and lets go of its output."""
        if self.running:
            self.kill()
        self._out.close()
        self._err.close()
