"""Commands in processes that need not load what a server has loaded already: starting one takes no seconds."""

import multiprocessing
import os
import runpy
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

SERVER = multiprocessing.get_context("forkserver")
# Nothing of it starts a thread, which no fork would have.
SERVER.set_forkserver_preload(["tests.cli.forked", "cotouch.cli", "cotouch.session", "cotouch.web", "rich.live"])


def _ran(arguments: Sequence[str], files: Sequence[Path]) -> None:
    """What the installed `cotouch` does, with these files as its input, output and complaints."""
    for number, (path, flags) in enumerate(zip(files, (os.O_RDONLY, os.O_WRONLY, os.O_WRONLY), strict=True)):
        opened = os.open(path, flags)
        os.dup2(opened, number)
        os.close(opened)
    sys.stdin = open(0, closefd=False)  # noqa: SIM115  multiprocessing closed it
    sys.argv = ["cotouch", *arguments]
    runpy.run_module("cotouch", run_name="__main__")


class Forked:
    """One of them; as `subprocess.Popen`."""

    def __init__(self, arguments: Sequence[str], files: Sequence[Path]) -> None:
        self._process = SERVER.Process(target=_ran, args=(arguments, files))
        self._process.start()
        assert self._process.pid is not None
        self.pid: int = self._process.pid

    def poll(self) -> int | None:
        return self._process.exitcode

    def wait(self, timeout: float | None = None) -> int:
        self._process.join(timeout)
        if self._process.exitcode is None:
            raise subprocess.TimeoutExpired("cotouch", timeout or 0.0)
        return self._process.exitcode

    def kill(self) -> None:
        self._process.kill()
