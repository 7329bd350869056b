"""A session of real processes, as people start it by hand: a host, and each user's own `cotouch join`."""

import re
import signal
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

# Longer than anything takes on a busy machine; nothing waits longer than it must [s].
PATIENCE = 120.0
_PAGE = r"http://127\.0\.0\.1:\d+/#token=\S+"

# Held by the ground: a free point that was let go of drifts for as long as the next one takes to join, and beyond some
# place no sample tells of it any more.
SESSION = """
title = "A point for four"

[network]
users = ["Ann", "Ben", "Cleo", "Dan"]
spring = [[0, 60, 60, 60], [60, 0, 60, 60], [60, 60, 0, 60], [60, 60, 60, 0]]
delay = [[0, 0.01, 0.01, 0.01], [0.01, 0, 0.01, 0.01], [0.01, 0.01, 0, 0.01], [0.01, 0.01, 0.01, 0]]

[body]
mass = 1.0
stiffness = 5.0
damping = 3.0

[steps]
rate = 100

[session]
emulate = true
"""


class Party:
    """Processes that were started, and what each of them said; all end with it."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self.running: dict[str, subprocess.Popen[bytes]] = {}

    def said(self, name: str) -> str:
        """All that a process said so far."""
        return (self._folder / f"{name}.log").read_text(encoding="utf-8")

    def start(self, name: str, *options: str) -> None:
        """Starts `cotouch` so."""
        with (self._folder / f"{name}.log").open("wb") as log:
            command = [sys.executable, "-m", "cotouch", *options]
            self.running[name] = subprocess.Popen(command, stdout=log, stderr=log)

    def await_line(self, name: str, pattern: str) -> str:
        """What it says like that."""
        process = self.running[name]
        for _ in range(int(PATIENCE / 0.1)):
            found = re.search(pattern, self.said(name))
            if found:
                return found[0]
            try:
                process.wait(0.1)
            except subprocess.TimeoutExpired:
                continue
            break
        raise AssertionError(f"{name} did not say {pattern}: {self.said(name)}")

    def host(self) -> str:
        """Opens the session; its invitation."""
        path = self._folder / "session.toml"
        path.write_text(SESSION, encoding="utf-8")
        self.start("host", "host", str(path), "--headless")
        return self.await_line("host", r"cotouch:\S+")

    def join(self, name: str, invitation: str, *, device: str = "none") -> str:
        """Takes part with a page; its address."""
        options = ["--name", name, "--device", device, "--page", "--port", "0", "--headless"]
        self.start(name, "join", invitation, *options)
        return self.await_line(name, _PAGE)

    def end(self, name: str, how: signal.Signals = signal.SIGINT) -> int:
        """Interrupts a process and waits for it; its exit code."""
        process = self.running.pop(name)
        process.send_signal(how)
        try:
            return process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            return process.wait()


@contextmanager
def party(folder: Path) -> Generator[Party]:
    """Everything that it starts is over at the end."""
    made = Party(folder)
    try:
        yield made
    finally:
        for name in reversed(list(made.running)):
            made.end(name)
