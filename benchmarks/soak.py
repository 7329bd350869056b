"""Soak: five members as processes on this machine, over emulated paths, and a fault every few seconds.

Faults are a kill and a return under the same name, a process that stands still for a while, and cut paths: members
talk through a transport that loses everything for a while in the session's own law (`[channel]` bursts). What counts is
that memory stays flat, books balance, and the audit of all recordings, those of killed members too, holds.

Memory is judged by those who live all the time, the host and the first member, who is cut off and stopped but never
killed: by the slope over the last two thirds of their lives, with its 95 % interval (`_trend.py`). It grows if all of
that is above zero, it is flat if not and if it ends below 0.1 MB/min, and otherwise the run was too short to say.
Like is compared with like: a connection takes some 0.2 MB while it lasts, and what it leaves is given back to the
system 5 s later. So faults pause every half minute until everybody has been there for some seconds. And some of what is
kept of connections is kept of so many only: TLS tickets (256), the allocator's stock of every thread. A session meets
that number in an hour; here visitors come and go before the time begins (`_visitors.py`). What counts
is anonymous memory, of which a leak is made; pages of code and of other files come in when they are first used, and are
the system's to take back. Both are said. `--leak` lets the host keep so much for every member killed, to see that it
is found.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from array import array
from pathlib import Path
from typing import Any

import numpy as np
import psutil

from benchmarks._report import Row, add_write, finish
from benchmarks._trend import Trend, trend
from cotouch.errors import SessionError
from cotouch.files import read_toml, shipped, toml_text
from cotouch.members import SessionFile
from cotouch.recording import audit, read_recording
from cotouch.session import MemberProcess, OpenHost, open_host

MINUTES = 10.0
RATE = 100
EVERY = 5.0
_KILLS = 0.25
_PATIENCE = 300.0
# What an interval of 95 % may end at and be called flat: 6 MB an hour [B/s].
_FLAT = 0.1e6 / 60.0
# What is noted of a process after the time.
_ANONYMOUS, _ALL = 1, 2
# Faults go on for so long; then there are none until everybody has been there for so long, and memory is looked at, the
# least of so many looks [s, s, 1]. The first so much of the run does not count [1].
_FAULTS, _SETTLED, _LOOKS, _WARM = 30.0, 7.0, 10, 1.0 / 3.0
# Who visits before the time begins, so many at once.
VISITORS, _AT_ONCE = 300, 4
# A path is cut for about 1.5 s, every 40 s or so.
_BURST = {"enter": 0.00025, "leave": 0.007, "loss_good": 0.0, "loss_bad": 1.0}


def session() -> SessionFile:
    """The paper's five users with a hand each, at a rate that leaves the machine to others, over paths that fail."""
    tables = read_toml(shipped("session", "live.toml", SessionError), "session file", SessionError)
    tables["steps"]["rate"] = RATE
    tables["channel"] = {"burst": _BURST}
    tables["session"] = {"emulate": True, "window": 4.0}
    for hand in tables["hands"]:
        reach = hand["path"][-1][1]
        hand["path"] = [point for k in range(400) for point in ([6 * k, reach * (k % 2)], [6 * k + 4, reach * (k % 2)])]
        hand.pop("release", None)
    return SessionFile.from_toml(toml_text(tables))


class Soak:
    """The members, what is done to them, and what is seen of them."""

    def __init__(
        self, opened: OpenHost, names: list[str], folder: Path, seed: int, every: float = EVERY, leak: int = 0
    ) -> None:
        self.opened, self.names, self.folder, self.every = opened, names, folder, every
        self.rng = np.random.default_rng(seed)
        self.members: dict[str, MemberProcess] = {}
        self.files: list[Path] = []
        # Of each process, when and how much. The host's own is measured, too: what keeps this is packed.
        self.memory: dict[int, array[float]] = {}
        # What `leak` keeps; every page is touched.
        self.leak, self._leaked = leak, list[bytes]()
        self.faults = {"killed": 0, "stopped": 0}
        self.residual, self.alarms, self.died = 0.0, 0, 0
        self.began = self.ended = 0.0
        self._whole: float | None = None  # since when everybody is there

    def join(self, name: str) -> None:
        """Starts a member, recorded into a file of its own."""
        path = self.folder / f"{name}{len(self.files)}.mcap"
        self.files.append(path)
        self.members[name] = MemberProcess(
            self.opened.invitation, ["--name", name, "--headless", "--record", str(path)], as_json=True
        )

    def turn(self) -> None:
        """Lets the host hear."""
        now = time.monotonic()
        self.opened.service(now)
        if len(self.opened.control.present()) < len(self.names):
            self._whole = None
        elif self._whole is None:
            self._whole = now
        time.sleep(0.02)

    def look(self) -> None:
        """Ledgers of everybody, once a second."""
        self.died += sum(not member.running for member in self.members.values())
        for status in self.opened.host.watch.last.values():
            self.residual = max(self.residual, status.residual)
            self.alarms = max(self.alarms, status.alarms)

    def weigh(self) -> None:
        """Memory of everybody."""
        seen: dict[int, list[tuple[float, float]]] = {}
        for _ in range(_LOOKS):
            for pid in [os.getpid(), *(member.pid for member in self.members.values() if member.running)]:
                seen.setdefault(pid, []).append(taken(pid))
            for _ in range(5):
                self.turn()
        for pid, looks in seen.items():
            self.memory.setdefault(pid, array("d")).extend((time.monotonic(), *map(min, zip(*looks, strict=True))))

    def fault(self) -> tuple[float, int] | None:
        """Does one; returns when to let whom go on."""
        kills = bool(self.rng.random() < _KILLS)
        name = self.names[int(self.rng.integers(int(kills), len(self.names)))]
        if not self.members[name].running:  # which is counted, and must not end everything
            self.join(name)
            return None
        if kills:
            self.members[name].close()
            self.join(name)
            self.faults["killed"] += 1
            if self.leak:
                self._leaked.append(b"x" * self.leak)
            return None
        os.kill(self.members[name].pid, signal.SIGSTOP)
        self.faults["stopped"] += 1
        return time.monotonic() + self.every * float(self.rng.uniform(0.04, 0.5)), self.members[name].pid

    def run(self, seconds: float, visitors: int = 0) -> None:
        """All of it, from when everybody is there."""
        for name in self.names:
            self.join(name)
        self._gather()
        self.receive(visitors)
        self.began = time.monotonic()
        self.ended = end = self.began + seconds
        looked = following = 0.0
        pause = self.began + _FAULTS
        standing: tuple[float, int] | None = None
        while (now := time.monotonic()) < end:
            self.turn()
            if now > looked + 1.0:
                looked = now
                self.look()
            if standing is not None and now >= standing[0]:
                os.kill(standing[1], signal.SIGCONT)
                standing = None
            if now > pause and standing is None:
                if self._whole is not None and now > self._whole + _SETTLED:
                    self.weigh()
                    pause = time.monotonic() + _FAULTS
            elif standing is None and now > following and now < end - 15.0:
                following = now + self.every * float(self.rng.uniform(0.6, 1.4))
                standing = self.fault()
        self._gather()

    def receive(self, visitors: int) -> None:
        """Lets visitors come and go, some at a time."""
        command = [sys.executable, "-m", "benchmarks._visitors", str(visitors // _AT_ONCE), str(len(self.names) + 1)]
        running = [subprocess.Popen(command, stdin=subprocess.PIPE, text=True) for _ in range(_AT_ONCE)]
        try:
            for one in running:
                assert one.stdin is not None
                one.stdin.write(self.opened.invitation.encode() + "\n")
                one.stdin.close()
            end = time.monotonic() + _PATIENCE
            while any(one.poll() is None for one in running) and time.monotonic() < end:
                self.turn()
            if any(one.poll() != 0 for one in running):
                raise SystemExit(f"not all of {visitors} visitors came and went within {_PATIENCE:.0f} s")
        finally:
            for one in running:
                one.kill()
                one.wait()

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
        """Most that any process took, with pages of files [B]."""
        return max(max(seen[_ALL::3]) for seen in self.memory.values())

    @property
    def grew(self) -> float:
        """Most that a process grew by from a third of its life to its end, of those that lived for 2 minutes [B]."""
        grown = [0.0]
        for seen in self.memory.values():
            if seen[-3] - seen[0] > 120.0:
                sizes = seen[_ANONYMOUS::3]
                grown.append(sizes[-1] - sizes[len(sizes) // 3])
        return max(grown)

    def trends(self, which: int) -> dict[str, Trend]:
        """Slopes of those who live all the time, once they are warm [B/s].

        Args:
            which: of anonymous memory or of all.
        """
        found: dict[str, Trend] = {}
        for who, pid in (("host", os.getpid()), (self.names[0], self.members[self.names[0]].pid)):
            seen = np.array(self.memory.get(pid, ())).reshape(-1, 3)
            last = seen[seen[:, 0] >= self.began + _WARM * (self.ended - self.began)]
            try:
                found[who] = trend(last[:, 0], last[:, which])
            except ValueError:  # it had ended by itself, and was started again
                found[who] = Trend(float("nan"), float("nan"))
        return found


def taken(pid: int) -> tuple[float, float]:
    """Anonymous memory of a process, and all with pages of files [B]."""
    try:  # what is in `status` may be off by the pages that every core counts for itself first
        with Path(f"/proc/{pid}/smaps_rollup").open(encoding="ascii") as file:
            fields = dict(line.split(":", 1) for line in file if ":" in line)
        return float(fields["Anonymous"].split()[0]) * 1024.0, float(fields["Rss"].split()[0]) * 1024.0
    except (OSError, KeyError):
        rss = float(psutil.Process(pid).memory_info().rss)
        return rss, rss


def verdict(found: Trend) -> str:
    """What a slope of memory means [B/s]."""
    return "grows" if found.rises else "flat" if found.most < _FLAT else "not known"


def measure(
    minutes: float = MINUTES,
    seed: int = 0,
    every: float = EVERY,
    *,
    check: bool = True,
    leak: int = 0,
    visitors: int = VISITORS,
) -> list[Row]:
    asked = session()
    with tempfile.TemporaryDirectory() as folder, open_host(asked) as opened:
        soak = Soak(opened, list(asked.scenario.network.users), Path(folder), seed, every, leak)
        try:
            soak.run(60.0 * minutes, visitors)
            slopes, all_slopes = soak.trends(_ANONYMOUS), soak.trends(_ALL)
            results = soak.close()
        finally:
            for member in soak.members.values():
                member.close()
        memory = [
            Row("soak", f"— memory of {who}, slope over the last two thirds of {minutes:g} min", verdict(found), "flat",
                f"{_rate(found)} (95 %); {_rate(all_slopes[who])} with pages of files")
            for who, found in slopes.items()
        ]  # fmt: skip
        memory.append(
            Row("soak", "— most that any process grew by after its first third", f"{soak.grew / 1e6:.1f} MB", "",
                f"of {soak.largest / 1e6:.0f} MB")
        )  # fmt: skip
        # Said at once: reading all recordings takes minutes, and may be interrupted.
        for row in memory:
            sys.stderr.write(f"{row.what}: {row.value}, {row.note}\n")
        ledger = _audited(soak) if check else Row("soak", "— audit of all recordings", "not done", "holds")
    done = sum(one is not None for one in results)
    faults = ", ".join(f"{count} {what}" for what, count in soak.faults.items())
    what = (
        f"{minutes:g} min, 5 members at {RATE} Hz, faults every {0.6 * every:g} to {1.4 * every:g} s for 30 s at a time"
    )
    return [
        Row("soak", what, f"{done} of 5 came to the end", "5 of 5",
            f"{faults}; paths cut about every 40 s each; {visitors} visitors before"),
        Row("soak", "— processes that ended by themselves", str(soak.died), "0"),
        *memory,
        Row("soak", "— energy residual, worst of all steps, of the energy in play", f"{soak.residual:.1e}", "≤ 1e-9",
            f"{soak.alarms} alarms"),
        ledger,
    ]  # fmt: skip


def _rate(found: Trend) -> str:
    return f"{found.slope * 60e-6:+.3f} ± {found.error * 60e-6:.3f} MB/min"


def _audited(soak: Soak) -> Row:
    """Every recording there is, those of killed members too."""
    size = sum(path.stat().st_size for path in soak.files if path.exists()) / 1e6
    recordings, unread = [], 0
    for path in soak.files:
        try:
            recordings.append(read_recording(path))
        except ValueError:
            unread += 1
    result = audit(recordings)
    words = result.findings[0].words if result.findings else "no findings"
    note = (
        f"{len(recordings)} recordings, {unread} of members killed before a step; {size:.0f} MB; "
        f"least of all hands' work {result.margin:.3g} J; {words}"
    )
    return Row("soak", "— audit of all recordings", "holds" if result.holds else "violated", "holds", note)


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.soak", description=__doc__)
    parser.add_argument("--minutes", type=float, default=MINUTES, help="how long")
    parser.add_argument("--every", type=float, default=EVERY, help="a fault so often, on average [s]")
    parser.add_argument("--seed", type=int, default=0, help="of the faults")
    parser.add_argument("--no-audit", dest="audit", action="store_false", help="leaves out reading the recordings")
    parser.add_argument(
        "--leak", type=int, default=0, help="what the host keeps for every member killed, as a test [B]"
    )
    parser.add_argument("--visitors", type=int, default=VISITORS, help="connections that come and go before the time")
    add_write(parser)
    options = parser.parse_args()
    rows = measure(
        options.minutes, options.seed, options.every, check=options.audit, leak=options.leak, visitors=options.visitors
    )
    finish(rows, write=options.write)


if __name__ == "__main__":
    main()
