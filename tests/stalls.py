"""A watch on the machine itself: for how long it kept a process waiting that only wanted to go on.

Force is to be gone within 100 ms, and a test asserts it. On a machine that has more to do than it can, time passes that
no program of ours used; such a test is taken again, but only where this watch, a process of its own, saw as much time
lost meanwhile as the test was late: its own, beyond what it slept and worked; or, while more programs want to run than
there are processors, the share of the time that each of them has to wait; or, on a machine that is lent, what it was
kept from one of its processors, which whoever ran there does not see otherwise.
"""

import subprocess
import sys
import time
from pathlib import Path

# The issue's [s].
WITHIN = 0.1
# Of the watch: it sleeps, works, and writes down what both took beyond what they should [s].
_SLEEP, _WORK, _LEAST = 0.008, 0.002, 0.001
# Of what a machine that stands still takes, as much again, in pieces too short to be seen.
_UNSEEN = 0.05


class Stalled(AssertionError):
    """Force was there too long, and the machine stood still for as long as it was late; the test is taken again."""


class Stalls:
    """The watch.

    Args:
        folder: where it writes down what it saw.
        watching: whether it does; else what is written down there is all there is.
    """

    def __init__(self, folder: Path, *, watching: bool = True) -> None:
        self._log = folder / "stalls"
        if not watching:
            return
        self._process = subprocess.Popen([sys.executable, "-S", __file__, str(self._log)])
        end = time.monotonic() + 60.0
        while not self._log.exists():
            assert time.monotonic() < end
            time.sleep(0.01)

    def lost(self, begin: float, end: float) -> float:
        """Time that the machine kept from it between two moments of the monotonic clock [s]."""
        found = 0.0
        for line in self._log.read_text().splitlines():
            start, stop, lost = map(float, line.split())
            if stop > begin and start < end:
                found += lost * (min(stop, end) - max(start, begin)) / (stop - start)
        return found

    def stood(self, begin: float, at_least: float) -> bool:
        """Whether the machine stood still for so long at a stretch since a moment of the monotonic clock.

        Args:
            begin: when [s].
            at_least: what matters [s].
        """
        time.sleep(0.05)  # the watch writes a little later
        lines = [tuple(map(float, line.split())) for line in self._log.read_text().splitlines()]
        return any(stop > begin and lost >= at_least for _, stop, lost in lines)

    def within(self, began: float, gone: float, limit: float = WITHIN) -> None:
        """Asserts that force was gone in time.

        Args:
            began: when something failed, on the monotonic clock [s].
            gone: how long after that the last force was [s].
            limit: at most that [s].

        Raises:
            Stalled: it was not, because the machine stood still for as long as it was late.
            AssertionError: it was not.
        """
        if gone < limit:
            return
        lost = self.lost(began, began + min(gone, 1.0))
        said = f"force was gone only after {1e3 * gone:.0f} ms; the machine stood still for {1e3 * lost:.0f} ms of them"
        if lost * (1.0 + _UNSEEN) >= gone - limit:
            raise Stalled(said)
        raise AssertionError(said)

    def close(self) -> None:
        self._process.kill()
        self._process.wait()


def stolen(told: str) -> list[float]:
    """For how long each processor was kept from this machine since it started [s].

    Args:
        told: by Linux, in `/proc/stat`.
    """
    lines = [line.split() for line in told.splitlines()]
    return [0.01 * int(line[8]) for line in lines if line[0].startswith("cpu") and line[0] != "cpu"]


def _watch(log: Path) -> None:
    """For two hours at most, or until its parent is gone."""
    import os

    parent, cores = os.getppid(), len(os.sched_getaffinity(0))
    end = time.monotonic() + 7200.0
    stat = Path("/proc/stat")
    with log.open("w", buffering=1) as out:
        kept = stolen(stat.read_text())
        while os.getppid() == parent and time.monotonic() < end:
            start, used = time.monotonic(), time.thread_time()
            time.sleep(_SLEEP)
            while time.thread_time() - used < _WORK:
                pass
            stop = time.monotonic()
            lost = stop - start - _SLEEP - (time.thread_time() - used)
            runnable = int(Path("/proc/loadavg").read_text().split()[3].partition("/")[0])
            lost = max(lost, (1.0 - cores / max(runnable, cores)) * (stop - start))
            before, kept = kept, stolen(stat.read_text())
            away = max((b - a for a, b in zip(before, kept, strict=False)), default=0.0)
            if away > lost:
                start, lost = stop - away, away
            if lost > _LEAST:
                out.write(f"{start} {stop} {lost}\n")


if __name__ == "__main__":
    _watch(Path(sys.argv[1]))
