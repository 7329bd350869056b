"""Members of a session as processes on loopback: from a sample to the force it makes, CPU, deadlines, how many.

Raw UDP of the same size goes between two further processes during the same run, where delays are measured.
"""

import contextlib
import json
import math
import os
import resource
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple, final

import numpy as np
import numpy.typing as npt

from benchmarks._report import Row, command
from cotouch.control import Invitation
from cotouch.members import Participation, SessionFile
from cotouch.peer import LinkGuard, LinkState, Peer, Sample
from cotouch.samples import Assembly, Chunk, EmulatedPath, PathLaw, SampleLink, SamplePlane
from cotouch.session import join, open_host

# 44 nodes in three dimensions: one datagram of 1,180 bytes.
BLOCK = """
kind = "lattice"
shape = [11, 2, 2]
mass = 1.0
stiffness = 400.0
damping = 0.4
ground = "x-"
ground_stiffness = 400.0
"""
POINT = "mass = 1.0\n"
BYTES = 1180
SETTLING = 3.0  # after everybody moves, before anything counts [s]
WAN = PathLaw(delay=0.03, jitter=0.02, loss=0.01)  # 40 ms ± 10


Float = npt.NDArray[np.float64]


class Turn(NamedTuple):
    """A step that counts.

    Attributes:
        now: its end [s].
        done: when its state was worked out [s].
        index: of its sample.
        used: index of the sample of each neighbour that it used.
        arrived: when that came, as the kernel stamped it; 0 unknown [s].
    """

    now: float
    done: float
    index: int
    used: list[int]
    arrived: list[float]


class NotThereError(RuntimeError):
    """Somebody did not take part for as long as it counts."""


def session(
    users: int,
    *,
    rate: float | list[float],
    body: str,
    links: Sequence[tuple[int, int]],
    delay: float = 0.0,
    more: str = "",
) -> SessionFile:
    """Everybody pulls at a point of the body; equal springs.

    Args:
        users: how many.
        rate: of everybody, or of each [1/s].
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
        f"[body]\n{body}[steps]\nrate = {rate}\n{more}\n{hands}",
        law="spring",
    )


def member() -> None:
    """A process: takes part as its input says, and prints what its steps did and took while it counted.

    Prints "there" once all its links are coupled; then its input says from when to when it counts.
    """
    asked = json.loads(sys.stdin.readline())
    window = {"from": math.inf, "until": asked["limit"]}
    threading.Thread(target=lambda: window.update(json.loads(sys.stdin.readline() or "{}")), daemon=True).start()
    turns: list[Turn] = []
    ages: list[float] = []
    came: dict[int, tuple[int, float]] = {}
    move, tell, note = Peer.move, SamplePlane.send, SampleLink.note
    counted, links, there = [0.0, 0.0], list[int](), False

    def moved(peer: Peer, now: float, T: float) -> Sample:
        nonlocal there
        sample = move(peer, now, T)
        done = time.monotonic()
        if window["from"] <= done < window["until"]:
            if not counted[0]:
                counted[:] = done, time.process_time()
            used = [_newest(source) for source in peer._joined.sources]
            arrived = [came.get(other, (-1, 0.0)) for other in peer.neighbours]
            stamps = [time if index == at else 0.0 for at, (index, time) in zip(used, arrived, strict=True)]
            links[:] = peer.neighbours
            turns.append(Turn(now, done, sample.index, used, stamps))
            assert peer._moved is not None
            ages.extend(peer._moved[1])
            counted[2:] = done, time.process_time()
        elif not there and len(peer.neighbours) == asked["links"]:
            there = all(
                source.state == LinkState.COUPLED for source in peer._joined.sources if isinstance(source, LinkGuard)
            )
            if there:
                print("there", flush=True)
        return sample

    def noted(link: SampleLink, chunk: Chunk, arrived: float, now: float) -> None:
        came[chunk.heading.sender] = chunk.heading.step, arrived
        note(link, chunk, arrived, now)

    sent: list[tuple[int, float]] = []

    def commanded(plane: SamplePlane, now: float, sample: Sample, T: float) -> Any:
        out = tell(plane, now, sample, T)
        if turns:
            sent.append((sample.index, time.monotonic()))
        return out

    Peer.move, SamplePlane.send, SampleLink.note = moved, commanded, noted
    taken = join(
        Invitation.decode(asked["invitation"]), Participation(name=asked["name"], version="benchmark"),
        stopped=lambda: time.monotonic() > window["until"],
    )  # fmt: skip
    if not turns or len(counted) < 4:
        return
    print(
        json.dumps(
            {
                "turns": turns, "ages": ages, "links": links, "sent": sent,
                "cpu": (counted[3] - counted[1]) / (counted[2] - counted[0]), "slot": taken.slot,
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
        window, times = json.loads(sys.stdin.readline() or '{"until": 0.0}'), list[float]()
        while (now := time.monotonic()) < min(window["until"], asked["limit"]):
            with contextlib.suppress(TimeoutError):
                sent = float(np.frombuffer(inlet.recv(2000), count=1)[0])
                now = time.monotonic()
                if now >= window["from"]:
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
    _say(process, asked)
    return process


def _say(process: subprocess.Popen[str], what: dict[str, Any]) -> None:
    assert process.stdin is not None
    with contextlib.suppress(BrokenPipeError):  # who is gone is missed where its answer is read
        process.stdin.write(json.dumps(what) + "\n")
        process.stdin.flush()


@final
class _Heard:
    """Lines of a process, read by a thread of their own."""

    def __init__(self, process: subprocess.Popen[str]) -> None:
        assert process.stdout is not None
        self.lines: list[str] = []
        self._thread = threading.Thread(
            target=self.lines.extend, args=(iter(process.stdout.readline, ""),), daemon=True
        )
        self._thread.start()

    def ended(self, patience: float) -> list[str]:
        """All of them, once the process has ended its output."""
        self._thread.join(patience)
        return self.lines


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
    given: SessionFile, seconds: float, *, patience: float, cores: Sequence[int] | None = None, beside: bool = False
) -> tuple[list[dict[str, Any]], np.ndarray]:
    """What every member printed, by slot, and the times of raw datagrams beside them [s].

    Args:
        given: the session.
        seconds: that count, from `SETTLING` after all links of all members are coupled.
        patience: until then, at most [s].
        cores: on which the members run; None: all.
        beside: whether raw datagrams go beside them, 1,000 a second.

    Raises:
        NotThereError: not all of them came, or one ended early.
    """
    names, network = given.scenario.network.users, given.scenario.network
    began = time.monotonic()
    limit = began + patience + SETTLING + seconds
    processes: list[subprocess.Popen[str]] = []
    with open_host(given) as opened, _ended(processes), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as outlet:
        for number, name in enumerate(names):
            links = sum(number in pair for pair in network.links)
            who = {"invitation": opened.invitation.encode(), "name": name, "links": links, "limit": limit}
            processes += [_start("member", who, cores)]
        received = [_Heard(process) for process in processes]
        inlet = _start("raw", {"limit": limit + 5.0}, None) if beside else None
        if inlet is not None:
            processes.append(inlet)
            assert inlet.stdout is not None
            outlet.connect(("127.0.0.1", int(inlet.stdout.readline())))
        while there := [number for number, one in enumerate(received) if not one.lines]:
            now = time.monotonic()
            gone = [names[number] for number in there if processes[number].poll() is not None]
            if gone or now > began + patience:
                why = f"{gone[0]} ended" if gone else f"after {patience:.0f} s"
                raise NotThereError(f"{len(names) - len(there)} of {len(names)} had all links coupled: {why}")
            opened.service(now)
            time.sleep(0.02)
        begin = time.monotonic() + SETTLING
        for process in processes:
            _say(process, {"from": begin, "until": begin + seconds})
        following, service = begin, 0.0
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
        seen = np.zeros(0) if inlet is None or inlet.stdout is None else np.array(json.loads(inlet.stdout.readline()))
        answers = [one.ended(20.0)[1:] for one in received]
    if silent := [name for name, lines in zip(names, answers, strict=True) if not lines]:
        raise NotThereError(f"{silent[0]} ended without a word")
    said = [json.loads(lines[0]) | {"turns": []} | _turns(lines[0]) for lines in answers]
    return sorted(said, key=lambda one: one["slot"]), seen


def _turns(line: str) -> dict[str, Any]:
    return {"turns": [Turn(*turn) for turn in json.loads(line)["turns"]]}


@final
class Parts(NamedTuple):
    """Where the time from a sample to its first force at a neighbour went, of many samples [s].

    Attributes:
        total: from the end of the sender's step, whose state it is, to the end of the solver in the neighbour's step.
        compute: from the end of the sender's step until its state is worked out: the loop's lateness, reading, hands
            and the solver.
        carry: from there until the kernel stamps the datagram's arrival: writing, sealing, sending.
        wait: from there until the neighbour's next step ends and can begin to be worked out; 0 where it has ended.
        use: the rest: reading what is left, hands, the solver.
    """

    total: Float
    compute: Float
    carry: Float
    wait: Float
    use: Float


def to_force(said: list[dict[str, Any]]) -> Parts:
    """Of every sample that makes a force at a neighbour, the first time."""
    made = {one["slot"]: {turn.index: turn for turn in one["turns"]} for one in said}
    parts: list[tuple[float, ...]] = []
    for one in said:
        for at, other in enumerate(one["links"]):
            source, last = made[other], -1
            for turn in one["turns"][1:]:
                index, arrived = turn.used[at], turn.arrived[at]
                if index != last and last >= 0 and index in source and arrived:
                    sender = source[index]
                    wait = max(turn.now - arrived, 0.0)
                    whole, compute, carry = turn.done - sender.now, sender.done - sender.now, arrived - sender.done
                    parts.append((whole, compute, carry, wait, whole - compute - carry - wait))
                last = index
    return Parts(*np.array(parts).T)


def missed(said: list[dict[str, Any]], period: float) -> tuple[float, np.ndarray]:
    """Share of the deadlines that were left out, and the lengths of all steps [s]."""
    steps = np.concatenate([np.diff([turn.now for turn in one["turns"]]) for one in said])
    return float(np.maximum(np.round(steps / period) - 1.0, 0.0).sum() / (steps.sum() / period)), steps


def _figures(values: np.ndarray, scale: float = 1e6) -> str:
    return " / ".join(f"{scale * value:,.0f}" for value in np.percentile(values, (50, 99, 99.9)))


def _load() -> str:
    return f"load of the machine before: {os.getloadavg()[0]:.1f}"


def delay() -> list[Row]:
    """Two members at 1000 and 997 Hz: within a third of a second their steps meet in every phase."""
    load = _load()
    given = session(2, rate=[1000.0, 997.0], body=BLOCK, links=[(1, 2)])
    said, seen = play(given, 20.0, patience=60.0, beside=True)
    parts = to_force(said)
    middle = {name: 1e6 * float(np.median(times)) for name, times in parts._asdict().items()}
    over = 1e6 * float(np.median(seen))
    rest = parts.total - parts.wait
    sending = [[done - turn.done for turn, (index, done) in _beside(one) if index == turn.index] for one in said]
    return [
        Row(
            "members",
            "sample to force at the neighbour, two members, 1.2 kB, 1 kHz, all phases, p50 / p99 / p99.9",
            f"{_figures(parts.total)} µs", "p50 ≤ 1,050 µs",
            "from the end of the step whose state it is to the neighbour's solver having its first force of it; "
            f"{parts.total.size:,} samples; {load}",
        ),
        Row(
            "members", "— waiting for the neighbour's next step, p50 / p99 / p99.9", f"{_figures(parts.wait)} µs", "",
            "half a step in the median, for nobody sets the phase of two loops: 1000 and 997 Hz go through all",
        ),
        Row(
            "members", "— all the rest, p50 / p99 / p99.9", f"{_figures(rest)} µs", "≤ 50 µs if all phases counted",
            f"medians: sender's step {middle['compute']:.0f} µs, writing, sealing and the kernel's way "
            f"{middle['carry']:.0f} µs (the call returns after {1e6 * np.median(np.concatenate(sending)):.0f} µs), "
            f"neighbour's step {middle['use']:.0f} µs",
        ),
        Row(
            "members", "— raw UDP for comparison, p50 / p99 / p99.9", f"{_figures(seen)} µs", "",
            f"{seen.size:,} datagrams; to a process that waits for nothing else; sample to force is "
            f"{middle['total'] / over:.0f} × as long",
        ),
    ]  # fmt: skip


def _beside(one: dict[str, Any]) -> Iterator[tuple[Turn, tuple[int, float]]]:
    """Turns with when their sample was handed over."""
    sent = {index: (index, done) for index, done in one["sent"]}
    return ((turn, sent.get(turn.index, (-1, 0.0))) for turn in one["turns"])


def cpu() -> list[Row]:
    rows: list[Row] = []
    links = [(i, j) for i in range(1, 5) for j in range(i + 1, 5)]
    for name, body in (("point", POINT), ("44 nodes, 1.2 kB", BLOCK)):
        load = _load()
        said, _ = play(session(4, rate=1000.0, body=body, links=links), 10.0, patience=60.0)
        fraction = np.median([one["cpu"] for one in said])
        work = np.concatenate([[turn.done - turn.now for turn in one["turns"]] for one in said])
        left, _ = missed(said, 0.001)
        rows.append(
            Row(
                "members", f"CPU of a member, 1 kHz, 3 neighbours, {name}", f"{100.0 * fraction:.0f} % of a core", "",
                "all threads, and 10 to 20 % looking for samples until the deadline; from there to the new state p50 "
                f"{1e6 * np.median(work):.0f} µs; {100.0 * left:.2f} % of deadlines missed by four on "
                f"{os.cpu_count()} cores; {load}",
            )
        )  # fmt: skip
    return rows


def deadlines() -> list[Row]:
    load = _load()
    links = [(1, 2), (1, 4), (2, 3), (2, 4), (3, 4), (4, 5)]
    said, _ = play(session(5, rate=500.0, body=POINT, links=links), 20.0, patience=90.0, cores=(0, 1))
    left, steps = missed(said, 0.002)
    return [
        Row(
            "members", "missed deadlines, 500 Hz, 5 members on 2 cores", f"{100.0 * left:.2f} %", "",
            f"steps p50 / p99 / p99.9 {_figures(steps)} µs, longest {1e3 * steps.max():.1f} ms; each takes "
            f"{100.0 * np.median([one['cpu'] for one in said]):.0f} % of a core; {load}",
        )
    ]  # fmt: skip


def how_many(tried: Sequence[int] = (8, 16, 24, 32)) -> list[Row]:
    found, notes, load, limited = 0, list[str](), _load(), f"a session has {tried[-1]} at most"
    for users in tried:
        links = [(i, i % users + 1) for i in range(1, users + 1)]
        try:
            said, _ = play(session(users, rate=100.0, body=POINT, links=links), 8.0, patience=30.0 + 3.0 * users)
        except NotThereError as error:
            limited = f"{users}: {error}"
            break
        left, _ = missed(said, 0.01)
        busy = sum(one["cpu"] for one in said)
        memory = sum(one["memory"] for one in said) / 2**20
        notes.append(f"{users}: {100.0 * left:.2f} % missed, {busy:.1f} cores, {memory:.1f} GB")
        if left > 0.01:
            limited = f"with {users} more than 1 % of deadlines are missed"
            break
        found = users
    return [
        Row(
            "members", f"members that {os.cpu_count()} cores sustain at 100 Hz, 2 neighbours each, ≤ 1 % missed",
            f"{'≥ ' if found == tried[-1] else ''}{found}", "",
            f"of {', '.join(map(str, tried))}; {'; '.join(notes)}; limit: {limited}; {load}",
        )
    ]  # fmt: skip


def own_age(law: PathLaw, rate: float, seconds: float) -> float:
    """Median age of the newest datagram that came over a path, looked at in every phase of its sending [s]."""
    path = EmulatedPath(law, np.random.default_rng(1))
    came = sorted((when, k / rate) for k in range(round(seconds * rate)) for when in path.arrivals(k / rate, BYTES))
    newest, at, ages = -1.0, 0, []
    for k in range(round(rate), round(seconds * rate)):
        now = k / rate / 0.997
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
    given = session(2, rate=[1000.0, 997.0], body=BLOCK, links=[(1, 2)], delay=WAN.delay, more=more)
    said, _ = play(given, 20.0, patience=60.0)
    ages = np.concatenate([one["ages"] for one in said])
    path, found = own_age(WAN, 1000.0, 60.0), float(np.median(ages))
    return [
        Row(
            "members", "age of a sample where it is used, path of 40 ms ± 10, 1 % loss, 1 kHz, p50 / p99 / p99.9",
            f"{_figures(ages, 1e3)} ms", "p50 within 5 % of the path's",
            f"p50 {1e3 * found:.2f} ms, the path's own {1e3 * path:.2f} ms, so {100.0 * (found / path - 1.0):+.1f} %; "
            "1000 and 997 Hz, one datagram each; the sender holds them back; half a step of it, "
            f"{100.0 * 0.0005 / path:.1f} %, is that samples are stamped mid-step; {load}",
        )
    ]  # fmt: skip


def measure() -> list[Row]:
    return [*delay(), *cpu(), *deadlines(), *wide(), *how_many()]


if __name__ == "__main__":
    command(measure, __doc__)
