"""Soak: five members as processes on this machine, over emulated paths, and a fault every few seconds.

Faults are a kill and a return under the same name, a process that stands still for a while, and cut paths: members
talk through a transport that loses everything for a while in the session's own law (`[channel]` bursts). What counts is
that memory stays flat, books balance, and the audit of all recordings, those of killed members too, holds.
"""

import argparse
import os
import signal
import sys
import tempfile
import time
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import psutil

from benchmarks._report import Row, add_write, finish
from cotouch.recording import audit, read_recording
from cotouch.session import MemberProcess, OpenHost, SessionFile, open_host
from cotouch.session._demo import _toml, demo_file

MINUTES = 10.0
RATE = 100
_EVERY = (3.0, 7.0)
_PATIENCE = 300.0
# A path is cut for about 1.5 s, every 40 s or so.
_BURST = {"enter": 0.00025, "leave": 0.007, "loss_good": 0.0, "loss_bad": 1.0}


def session() -> SessionFile:
    """The paper's five users with a hand each, at a rate that leaves the machine to others, over paths that fail."""
    tables = tomllib.loads(demo_file().read_text(encoding="utf-8"))
    tables["steps"]["rate"] = RATE
    tables["channel"] = {"burst": _BURST}
    tables["session"] = {"emulate": True, "window": 4.0}
    for hand in tables["hands"]:
        reach = hand["path"][-1][1]
        hand["path"] = [point for k in range(400) for point in ([6 * k, reach * (k % 2)], [6 * k + 4, reach * (k % 2)])]
        hand.pop("release", None)
    return SessionFile.from_toml(_toml(tables))


class Soak:
    """The members, what is done to them, and what is seen of them."""

    def __init__(self, opened: OpenHost, names: list[str], folder: Path, seed: int) -> None:
        self.opened, self.names, self.folder = opened, names, folder
        self.rng = np.random.default_rng(seed)
        self.members: dict[str, MemberProcess] = {}
        self.files: list[Path] = []
        self.memory: dict[int, list[tuple[float, int]]] = {}
        self.faults = {"killed": 0, "stopped": 0}
        self.residual, self.alarms, self.died = 0.0, 0, 0

    def join(self, name: str) -> None:
        """Starts a member, recorded into a file of its own."""
        path = self.folder / f"{name}{len(self.files)}.mcap"
        self.files.append(path)
        self.members[name] = MemberProcess(
            self.opened.invitation, ["--name", name, "--headless", "--record", str(path)], as_json=True
        )

    def turn(self) -> None:
        """Lets the host hear."""
        self.opened.service(time.monotonic())
        time.sleep(0.02)

    def look(self) -> None:
        """Memory and books of everybody, once a second."""
        now = time.monotonic()
        for member in self.members.values():
            if not member.running:
                self.died += 1
                continue
            self.memory.setdefault(member.pid, []).append((now, psutil.Process(member.pid).memory_info().rss))
        self.memory.setdefault(0, []).append((now, psutil.Process().memory_info().rss))
        for status in self.opened.host.watch.last.values():
            self.residual = max(self.residual, status.residual)
            self.alarms = max(self.alarms, status.alarms)

    def fault(self) -> tuple[float, int] | None:
        """Does one; returns when to let whom go on."""
        name = self.names[int(self.rng.integers(len(self.names)))]
        if not self.members[name].running:  # which is counted, and must not end everything
            self.join(name)
            return None
        if self.rng.random() < 0.25:
            self.members[name].close()
            self.join(name)
            self.faults["killed"] += 1
            return None
        os.kill(self.members[name].pid, signal.SIGSTOP)
        self.faults["stopped"] += 1
        return time.monotonic() + float(self.rng.uniform(0.2, 2.5)), self.members[name].pid

    def run(self, seconds: float) -> None:
        """All of it, from when everybody is there."""
        for name in self.names:
            self.join(name)
        self._gather()
        end = time.monotonic() + seconds
        looked = following = 0.0
        standing: tuple[float, int] | None = None
        while (now := time.monotonic()) < end:
            self.turn()
            if now > looked + 1.0:
                looked = now
                self.look()
            if standing is not None and now >= standing[0]:
                os.kill(standing[1], signal.SIGCONT)
                standing = None
            if standing is None and now > following and now < end - 15.0:
                following = now + float(self.rng.uniform(*_EVERY))
                standing = self.fault()
        self._gather()

    def _gather(self) -> None:
        end = time.monotonic() + _PATIENCE
        while time.monotonic() < end:
            self.turn()
            seen = self.opened.host.watch.members.values()
            if len(seen) == len(self.names) and all(s.status is not None and s.status.steps for s in seen):
                return
        raise SystemExit(f"not all members came within {_PATIENCE:.0f} s")

    def close(self) -> list[dict[str, Any] | None]:
        """Ends the session; what each member says at its end."""
        self.opened.host.end()
        end = time.monotonic() + 10.0
        while time.monotonic() < end and any(member.running for member in self.members.values()):
            self.turn()
        return [member.result() for member in self.members.values()]

    @property
    def largest(self) -> float:
        """Most that any process took [B]."""
        return float(max(size for seen in self.memory.values() for _, size in seen))

    def growth(self) -> tuple[float, list[float]]:
        """Most that a process grew by from a third of its life to its end [B], and slopes of the longest-lived member.

        The slopes are least squares over the second quarter of its life and over its second half [B/min].
        """
        grew, longest = 0.0, (0.0, 0)
        for pid, seen in self.memory.items():
            life = seen[-1][0] - seen[0][0]
            if life > 60.0:
                grew = max(grew, float(seen[-1][1] - seen[len(seen) // 3][1]))
                longest = max(longest, (life if pid else 0.0, pid))
        seen = np.array(self.memory[longest[1]])
        half = len(seen) // 2
        parts = [seen[half // 2 : half], seen[half:]]
        return grew, [60.0 * float(np.polyfit(part[:, 0] - part[0, 0], part[:, 1], 1)[0]) for part in parts]


def measure(minutes: float = MINUTES, seed: int = 0) -> list[Row]:
    asked = session()
    with tempfile.TemporaryDirectory() as folder, open_host(asked) as opened:
        soak = Soak(opened, list(asked.scenario.network.users), Path(folder), seed)
        try:
            soak.run(60.0 * minutes)
            results = soak.close()
        finally:
            for member in soak.members.values():
                member.close()
        grew, (before, after) = soak.growth()
        # Said at once: reading all recordings takes minutes, and may be interrupted.
        sys.stderr.write(
            f"grew by {grew / 1e6:.1f} MB; longest-lived {before / 1e6:+.2f}, {after / 1e6:+.2f} MB/min; auditing\n"
        )
        size = sum(path.stat().st_size for path in soak.files if path.exists()) / 1e6
        recordings, unread = [], 0
        for path in soak.files:
            try:
                recordings.append(read_recording(path))
            except ValueError:
                unread += 1
        result = audit(recordings)
    done = sum(one is not None for one in results)
    words = result.findings[0].words if result.findings else "no findings"
    faults = ", ".join(f"{count} {what}" for what, count in soak.faults.items())
    what = f"{minutes:g} min, 5 members at {RATE} Hz, faults every 3 to 7 s"
    return [
        Row("soak", what, f"{done} of 5 came to the end", "5 of 5", f"{faults}; paths cut about every 40 s each"),
        Row("soak", "— processes that ended by themselves", str(soak.died), "0"),
        Row("soak", "— memory: most that any process grew by after its first third", f"{grew / 1e6:.1f} MB", "flat",
            f"slope of the longest-lived member: {before / 1e6:+.2f} MB/min in its second quarter, "
            f"{after / 1e6:+.2f} in its second half, of {soak.largest / 1e6:.0f} MB"),
        Row("soak", "— energy residual, worst of all steps, of the energy in play", f"{soak.residual:.1e}", "≤ 1e-9",
            f"{soak.alarms} alarms"),
        Row("soak", "— audit of all recordings", "holds" if result.holds else "violated", "holds",
            f"{len(recordings)} recordings, {unread} of members killed before a step; {size:.0f} MB; "
            f"least of all hands' work {result.margin:.3g} J; " + words),
    ]  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=MINUTES, help="how long")
    parser.add_argument("--seed", type=int, default=0, help="of the faults")
    add_write(parser)
    options = parser.parse_args()
    finish(measure(options.minutes, options.seed), write=options.write)


if __name__ == "__main__":
    main()
