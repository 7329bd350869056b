"""Members of a session as processes on loopback: from a sample to the force it makes, CPU, deadlines, how many.

Raw UDP of the same size goes between two further processes during the same run, where delays are measured.
"""

import contextlib
import json
import os
import resource
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from benchmarks._report import Row, command
from cotouch.live import Assembly, Invitation, Path, PathLaw
from cotouch.peer import LinkGuard, Peer
from cotouch.session import SessionFile, join, open_host

# 45 nodes in three dimensions: 1,192 bytes on the wire.
BLOCK = """
kind = "lattice"
shape = [5, 3, 3]
mass = 1.0
stiffness = 400.0
damping = 0.4
ground = "x-"
ground_stiffness = 400.0
"""
POINT = "mass = 1.0\n"
BYTES = 1192
SETTLING = 3.0  # after everybody moves, before anything counts [s]
WAN = PathLaw(delay=0.03, jitter=0.02, loss=0.01)  # 40 ms ± 10


class NotThereError(RuntimeError):
    """Somebody did not take part for as long as it counts."""


def session(
    users: int, *, rate: float, body: str, links: Sequence[tuple[int, int]], delay: float = 0.0, more: str = ""
) -> SessionFile:
    """Everybody pulls at a point of the body; equal springs.

    Args:
        users: how many.
        rate: of everybody [1/s].
        body: the table of the body.
        links: numbers of users, from 1.
        delay: that is emulated, if `more` says so [s].
        more: further tables.
    """
    names = json.dumps([f"user {number + 1}" for number in range(users)])
    springs = [[60.0 * (i != j) for j in range(users)] for i in range(users)]
    delays = [[delay * (i != j) for j in range(users)] for i in range(users)]
    axes = 1 if body == POINT else 3
    hands = "".join(
        f"[[hands]]\nuser = {n + 1}\npath = {json.dumps([[0.0] * (axes + 1), [2.0, *[0.01 * (n % 3)] * axes]])}\n"
        f"{'at = [0.0, 0.0, 0.0]' if axes == 3 else ''}\nstiffness = 60.0\ndamping = 2.0\n"
        for n in range(users)
    )
    return SessionFile.from_toml(
        f"[network]\nusers = {names}\nspring = {springs}\ndelay = {delays}\nlinks = {[list(pair) for pair in links]}\n"
        f"[body]\n{body}[steps]\nrate = {rate}\n{more}\n{hands}"
    )


def member() -> None:
    """A process: takes part as its input says, and prints what its steps did and took once all had settled."""
    asked = json.loads(sys.stdin.readline())
    turns: list[tuple[float, float, int, list[int]]] = []
    ages: list[float] = []
    plain, counted = Peer.step, [0.0, 0.0]

    def timed(peer: Peer, now: float, T: float) -> Any:
        report = plain(peer, now, T)
        done = time.monotonic()
        if done >= asked["from"] and done < asked["until"]:
            if not counted[0]:
                counted[:] = done, time.process_time()
            used = [_newest(source) for source in peer._sources]
            turns.append((now, done, report.sample.index, used))
            ages.extend(report.age)
            counted[2:] = done, time.process_time()
        elif done < asked["from"]:
            turns[:] = [(now, done, report.sample.index, [])]
        return report

    Peer.step = timed
    kept = len(os.sched_getaffinity(0))
    taken = join(
        Invitation.decode(asked["invitation"]), name=asked["name"], version="benchmark",
        stopped=lambda: time.monotonic() > asked["until"],
    )  # fmt: skip
    links = [] if taken.status is None else [link.seat for link in taken.status.links]
    states = [] if taken.status is None else [link.state for link in taken.status.links]
    if not turns or len(counted) < 4:
        return
    print(
        json.dumps(
            {
                "turns": turns, "ages": ages, "links": links, "states": states, "cores": kept,
                "cpu": (counted[3] - counted[1]) / (counted[2] - counted[0]), "seat": taken.seat,
                "residual": 1.0 if taken.status is None else taken.status.residual,
                "memory": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss,
            }
        ),
        flush=True,
    )  # fmt: skip


def _newest(link: object) -> int:
    """Index of the sample that a link has just given."""
    source = link.source if isinstance(link, LinkGuard) else link
    return source.newest if isinstance(source, Assembly) else -1


def raw() -> None:
    """A process: takes datagrams of the same size, and prints how long each took, as its input says."""
    asked = json.loads(sys.stdin.readline())
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as inlet:
        inlet.bind(("127.0.0.1", 0))
        inlet.settimeout(0.5)
        print(inlet.getsockname()[1], flush=True)
        times: list[float] = []
        while (now := time.monotonic()) < asked["until"]:
            with contextlib.suppress(TimeoutError):
                sent = float(np.frombuffer(inlet.recv(2000), count=1)[0])
                now = time.monotonic()
                if now >= asked["from"]:
                    times.append(now - sent)
    print(json.dumps(times), flush=True)


def _start(function: str, asked: dict[str, Any], cores: Sequence[int] | None) -> subprocess.Popen[str]:
    code = f"from benchmarks.members import {function}; {function}()"
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    pin: Callable[[], None] | None = None if cores is None else lambda: os.sched_setaffinity(0, cores)
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, **threads},
        preexec_fn=pin,  # noqa: PLW1509
    )
    assert process.stdin is not None
    process.stdin.write(json.dumps(asked) + "\n")
    process.stdin.close()
    return process


@contextlib.contextmanager
def _ended(processes: list[subprocess.Popen[str]]) -> Iterator[None]:
    try:
        yield
    finally:
        for process in processes:
            if process.poll() is None:
                process.kill()
            process.wait()


def play(
    given: SessionFile, seconds: float, *, start: float, cores: Sequence[int] | None = None, beside: bool = False
) -> tuple[list[dict[str, Any]], np.ndarray]:
    """What every member printed, by seat, and the times of raw datagrams beside them [s].

    Args:
        given: the session.
        seconds: that count.
        start: what starting all processes takes at most [s].
        cores: on which the members run; None: all.
        beside: whether raw datagrams go beside them, 1,000 a second.
    """
    users = given.scenario.network.size
    begin = time.monotonic() + start + SETTLING
    asked = {"from": begin, "until": begin + seconds}
    processes: list[subprocess.Popen[str]] = []
    with open_host(given) as opened, _ended(processes):
        for name in given.scenario.network.users:
            who = {"invitation": opened.invitation.encode(), "name": name}
            processes += [_start("member", {**who, **asked}, cores)]
        seen, times = np.zeros(0), "[]"
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as outlet:
            inlet = _start("raw", asked, None) if beside else None
            if inlet is not None:
                processes.append(inlet)
                assert inlet.stdout is not None
                outlet.connect(("127.0.0.1", int(inlet.stdout.readline())))
            following, service = time.monotonic(), 0.0
            while (now := time.monotonic()) < begin + seconds:
                if now >= service:
                    opened.service(now)
                    service = now + 0.02
                if inlet is not None and now >= begin:
                    following = max(following + 0.001, now - 0.001)
                    time.sleep(max(0.0, following - time.monotonic()))
                    outlet.send(np.array([time.monotonic()]).tobytes() + bytes(BYTES - 8))
                else:
                    time.sleep(0.005)
            if inlet is not None:
                assert inlet.stdout is not None
                times = inlet.stdout.readline()
                seen = np.array(json.loads(times))
        said: list[dict[str, Any]] = []
        for process in processes[:users]:
            opened.service(time.monotonic())
            assert process.stdout is not None
            line = process.stdout.readline()
            if not line:
                raise NotThereError(f"a member of {users} ended without a word")
            said.append(json.loads(line))
    if any(one["seat"] is None or len(one["turns"]) < 10 for one in said):
        raise NotThereError(f"not all of {users} members were there in time; give them longer to start")
    return sorted(said, key=lambda one: one["seat"]), seen


def to_force(said: list[dict[str, Any]]) -> np.ndarray:
    """From the end of the step that made a sample to the force that it first makes at each neighbour [s]."""
    ends = {one["seat"]: {index: now for now, _, index, _ in one["turns"]} for one in said}
    delays: list[float] = []
    for one in said:
        for at, other in enumerate(one["links"]):
            made, last = ends[other], -1
            for _, done, _, used in one["turns"][1:]:
                if used[at] != last and last >= 0 and used[at] in made:
                    delays.append(done - made[used[at]])
                last = used[at]
    return np.array(delays)


def missed(said: list[dict[str, Any]], period: float) -> tuple[float, np.ndarray]:
    """Share of the deadlines that were left out, and the lengths of all steps [s]."""
    steps = np.concatenate([np.diff([now for now, _, _, _ in one["turns"]]) for one in said])
    return float(np.maximum(np.round(steps / period) - 1.0, 0.0).sum() / (steps.sum() / period)), steps


def _figures(values: np.ndarray, scale: float = 1e6) -> str:
    return " / ".join(f"{scale * value:,.0f}" for value in np.percentile(values, (50, 99, 99.9)))


def _load() -> str:
    return f"load of the machine before: {os.getloadavg()[0]:.1f}"


def delay() -> list[Row]:
    load = _load()
    said, seen = play(
        session(2, rate=1000.0, body=BLOCK, links=[(1, 2)]), 20.0, start=25.0, beside=True
    )  # fmt: skip
    delays = to_force(said)
    beside = 1e6 * (float(np.median(delays)) - 0.001)
    over = 1e6 * float(np.median(seen))
    return [
        Row(
            "members", "sample to force at the neighbour, two members, 1.2 kB, 1 kHz, p50 / p99 / p99.9",
            f"{_figures(delays)} µs", "p50 ≤ 1,050 µs",
            f"p50 is one step {beside:+.0f} µs; {len(delays):,} samples; {load}",
        ),
        Row(
            "members", "— raw UDP beside it, p50 / p99 / p99.9", f"{_figures(seen)} µs", "",
            f"{len(seen):,} datagrams; sample to force is {1e6 * float(np.median(delays)) / over:.0f} × as long",
        ),
    ]  # fmt: skip


def cpu() -> list[Row]:
    rows: list[Row] = []
    links = [(i, j) for i in range(1, 5) for j in range(i + 1, 5)]
    for name, body in (("point", POINT), ("45 nodes, 1.2 kB", BLOCK)):
        load = _load()
        said, _ = play(session(4, rate=1000.0, body=body, links=links), 10.0, start=28.0)
        share = np.median([one["cpu"] for one in said])
        work = np.concatenate([[done - now for now, done, _, _ in one["turns"]] for one in said])
        left, _ = missed(said, 0.001)
        rows.append(
            Row(
                "members", f"CPU of a member, 1 kHz, 3 neighbours, {name}", f"{100.0 * share:.0f} % of a core", "",
                "all threads, and up to 10 % waiting for deadlines; reading and stepping p50 "
                f"{1e6 * np.median(work):.0f} µs; {100.0 * left:.2f} % of deadlines missed by four on "
                f"{os.cpu_count()} cores; {load}",
            )
        )  # fmt: skip
    return rows


def deadlines() -> list[Row]:
    load = _load()
    links = [(1, 2), (1, 4), (2, 3), (2, 4), (3, 4), (4, 5)]
    said, _ = play(session(5, rate=500.0, body=POINT, links=links), 20.0, start=35.0, cores=(0, 1))
    left, steps = missed(said, 0.002)
    return [
        Row(
            "members", "missed deadlines, 500 Hz, 5 members on 2 cores", f"{100.0 * left:.2f} %", "",
            f"steps p50 / p99 / p99.9 {_figures(steps)} µs, longest {1e3 * steps.max():.1f} ms; each takes "
            f"{100.0 * np.median([one['cpu'] for one in said]):.0f} % of a core; {load}",
        )
    ]  # fmt: skip


def how_many(tried: Sequence[int] = (16, 24, 32)) -> list[Row]:
    found, notes, load = 0, list[str](), _load()
    for users in tried:
        links = [(i, i % users + 1) for i in range(1, users + 1)]
        try:
            said, _ = play(session(users, rate=100.0, body=POINT, links=links), 8.0, start=20.0 + 2.0 * users)
        except NotThereError:
            notes.append(f"{users}: not all there after {20 + 2 * users} s")
            break
        left, _ = missed(said, 0.01)
        busy = sum(one["cpu"] for one in said)
        notes.append(f"{users}: {100.0 * left:.2f} % missed, {busy:.1f} cores")
        if left > 0.01:
            break
        found = users
    return [
        Row(
            "members", f"members that {os.cpu_count()} cores hold at 100 Hz, 2 neighbours each, ≤ 1 % missed",
            f"{'≥ ' if found == tried[-1] else ''}{found}", "", f"{'; '.join(notes)}; a session has 32 at most; {load}",
        )
    ]  # fmt: skip


def own_age(law: PathLaw, rate: float, seconds: float) -> float:
    """Median age of the newest datagram that came over a path, looked at as often as they are sent [s]."""
    path = Path(law, np.random.default_rng(1))
    came = sorted((when, k / rate) for k in range(round(seconds * rate)) for when in path.arrivals(k / rate, BYTES))
    newest, at, ages = -1.0, 0, []
    for k in range(round(rate), round(seconds * rate)):
        now = (k + 0.5) / rate
        while at < len(came) and came[at][0] <= now:
            newest, at = max(newest, came[at][1]), at + 1
        ages.append(now - newest)
    return float(np.median(ages))


def wide() -> list[Row]:
    load = _load()
    more = (
        f'[channel]\nloss = {WAN.loss}\njitter = {{ kind = "uniform", scale = {WAN.jitter} }}\n'
        "[session]\nemulate = true\n"
    )
    said, _ = play(session(2, rate=1000.0, body=BLOCK, links=[(1, 2)], delay=WAN.delay, more=more), 20.0, start=28.0)
    ages = np.concatenate([one["ages"] for one in said])
    path, found = own_age(WAN, 1000.0, 60.0), float(np.median(ages))
    return [
        Row(
            "members", "age of a sample where it is used, path of 40 ms ± 10, 1 % loss, 1 kHz, p50 / p99 / p99.9",
            f"{_figures(ages, 1e3)} ms", "p50 within 5 % of the path's",
            f"p50 {1e3 * found:.2f} ms, the path's own {1e3 * path:.2f} ms, so {100.0 * (found / path - 1.0):+.1f} %; "
            f"emulated by the sender; {load}",
        )
    ]  # fmt: skip


def measure() -> list[Row]:
    return [*delay(), *cpu(), *deadlines(), *wide(), *how_many()]


if __name__ == "__main__":
    command(measure, __doc__)
