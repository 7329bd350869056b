"""A session as real processes, host and each member in a network namespace of its own, and what came of it."""

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Protocol

import numpy as np
from tests.live.emulator.star import ENTER

from cotouch.peer import LinkState
from cotouch.recording import Audit, Recording, audit, read_recording
from cotouch.samples import PathLaw

SPECTATOR = Path(__file__).with_name("spectator.py")
# What any wait is bounded by [s]; what is waited for takes a twentieth of it, and longer on a busy machine. Networks,
# and who watches, live longer than any test and end with it.
LIFE = 900.0
PATIENCE = 180.0
RESIDUAL = 1e-9


class Network(Protocol):
    """Namespaces by number, each held by a process and with an address."""

    holders: list[int]

    def address(self, user: int) -> str: ...


class Stage:
    """Processes of one session: members in the first namespaces, then the host, then a spectator."""

    def __init__(self, network: Network, folder: Path, session: str, names: list[str]) -> None:
        self.network, self.folder, self.names = network, folder, names
        self.seen = folder / "seen.json"
        self.running: list[subprocess.Popen[bytes]] = []
        self.members: dict[str, subprocess.Popen[bytes]] = {}
        self.recordings: dict[str, list[Path]] = {name: [] for name in names}
        (folder / "session.toml").write_text(session)
        at = len(names)
        self.host = self.start(
            at,
            "host",
            "host",
            str(folder / "session.toml"),
            "--listen",
            network.address(at),
            "--port",
            "7000",
            "--json",
        )
        self.invitation = self.wait(lambda: json.loads(self.out("host"))["invitation"], "the host")
        self.start(
            at + 1,
            "spectator",
            self.invitation,
            network.address(at + 1),
            str(self.seen),
            str(LIFE),
            program=[str(SPECTATOR)],
        )

    def start(self, at: int, label: str, *arguments: str, program: list[str] | None = None) -> subprocess.Popen[bytes]:
        enter = [ENTER[0], "-t", str(self.network.holders[at]), *ENTER[1:]]
        command = [*enter, sys.executable, *(program or ["-m", "cotouch"]), *arguments]
        with (self.folder / f"{label}.out").open("wb") as out, (self.folder / f"{label}.err").open("wb") as err:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        self.running.append(process)
        return process

    def join(self, name: str, *options: str) -> None:
        """`cotouch join`, recorded; again under the same name after it was killed."""
        label = f"{name}{len(self.recordings[name])}"
        path = self.folder / f"{label}.mcap"
        self.recordings[name].append(path)
        self.members[name] = self.start(
            self.names.index(name), label, "join", self.invitation, "--name", name, "--record", str(path),
            "--headless", "--json", *options,
        )  # fmt: skip

    def out(self, label: str) -> str:
        return (self.folder / f"{label}.out").read_text()

    def errors(self) -> str:
        return "\n".join(f"{path.name}: {path.read_text()[-2000:]}" for path in self.folder.glob("*.err"))

    def complaint(self, words: str) -> str:
        return f"{words}; seen: {self.seen.exists() and self.seen.read_text()}\n{self.errors()}"

    def wait(self, what: Callable[[], object], words: str | Callable[[], str], patience: float = PATIENCE) -> object:
        """Until something is there and true; words for when it is not may be found only then."""
        end = time.monotonic() + patience
        while True:
            try:
                value = what()
            except (OSError, ValueError, LookupError):
                value = None
            if value:
                return value
            assert time.monotonic() < end, self.complaint(words if isinstance(words, str) else words())
            for name, process in self.members.items():
                assert process.poll() in {None, -9, 0}, f"{name} ended: {self.errors()}"
            time.sleep(0.05)

    def members_seen(self) -> dict[str, dict]:
        return {name: s for name, s in json.loads(self.seen.read_text())["members"].items() if s["age"] < 1.5}

    def coupled(self, *names: str, links: int | None = None) -> Callable[[], bool]:
        """Whether these move, and all ends of their links are coupled."""

        def all_are() -> bool:
            seen = self.members_seen()
            ends = [link["state"] for name in names for link in seen[name]["links"]]
            return (
                all(seen[n]["steps"] for n in names)
                and bool(ends)
                and set(ends) <= {"coupled"}
                and (links is None or len(ends) == 2 * links)
            )

        return all_are

    def budgets(self) -> dict[tuple[str, int], float]:
        """Sum of both budgets of each end of a link that has one, by member and neighbour [s]."""
        return {
            (name, link["slot"]): link["budget"]
            for name, status in self.members_seen().items()
            for link in status["links"]
            if link["budget"] is not None
        }

    def epoch(self) -> int:
        """Number of the roster."""
        return json.loads(self.seen.read_text())["epoch"]

    def guardings(self) -> int:
        """How often ends of links were guarded so far, in all."""
        seen = json.loads(self.seen.read_text())["members"]
        return sum(link["guarded"] for status in seen.values() for link in status["links"])

    def stop(self, name: str) -> dict:
        """Lets a member leave; what it said at its end."""
        process = self.members[name]
        process.terminate()
        return self.said(name)

    def said(self, name: str) -> dict:
        process = self.members[name]
        assert process.wait(20) == 0, self.errors()
        return json.loads(self.out(f"{name}{len(self.recordings[name]) - 1}"))

    def close(self) -> None:
        for process in self.running:
            if process.poll() is None:
                process.kill()
            process.wait(10)


@contextmanager
def api(network: Network, folder: Path, session: str, names: list[str]) -> Iterator[Stage]:
    made = None
    try:
        made = Stage.__new__(Stage)
        made.running = []
        made.__init__(network, folder, session, names)
        yield made
    finally:
        if made is not None:
            made.close()


def audited(api: Stage) -> tuple[Audit, list[Recording]]:
    recordings = [read_recording(path) for paths in api.recordings.values() for path in paths]
    return audit(recordings), recordings


def judged(played: Stage, said: dict[str, dict], force: float) -> list[Recording]:
    """What holds after every session; returns the recordings."""
    seen = json.loads(played.seen.read_text())["members"]
    for status in [*seen.values(), *(one["status"] for one in said.values())]:
        assert status["residual"] <= RESIDUAL
        assert status["alarms"] == 0
    result, recordings = audited(played)
    assert result.holds, result.verdict
    assert max(abs(ledger.residual) for ledger in result.users) <= RESIDUAL * result.in_play
    assert max(worst_force(recording) for recording in recordings) <= force * (1.0 + 1e-9)
    assert all((recording.columns["link_state"] == LinkState.COUPLED).any() for recording in recordings)
    return recordings


def everywhere(receiver_delay: Callable[[int, int], PathLaw], star: object, users: range) -> None:
    """A law for each direction between these users."""
    for i in users:
        for j in users:
            if i != j:
                star.set(j, i, receiver_delay(i, j))  # type: ignore[attr-defined]


def apart(recordings: list[Recording], times: np.ndarray) -> np.ndarray:
    """Greatest distance of two copies at each time (of the monotonic clock); of those that were there then."""
    places = np.full((len(recordings), times.size), np.nan)
    for k, recording in enumerate(recordings):
        end, x = recording.columns["time"][recording.states["state_row"]], recording.states["position"][:, 0, 0]
        there = (times >= end[0]) & (times <= end[-1])
        places[k, there] = np.interp(times[there], end, x)
    return np.nanmax(places, axis=0) - np.nanmin(places, axis=0)


def calmest(recordings: list[Recording], begin: float, end: float, *, span: float = 0.3) -> float:
    """The least that copies were apart at most, in some stretch of this length."""
    step = 0.01
    distance = apart(recordings, np.arange(begin, end, step))
    width = round(span / step)
    return float(min(distance[k : k + width].max() for k in range(distance.size - width)))


def worst_force(recording: Recording) -> float:
    """Of any link's spring in any step, from what it holds [N]."""
    worst = 0.0
    for setup, span in recording.setup_rows():
        for user, strength in zip(setup.neighbours, setup.strength, strict=True):
            potential = recording.columns["potential"][span, recording.neighbours.index(user)]
            worst = max(worst, float(np.sqrt(2.0 * strength * max(0.0, float(np.nanmax(potential, initial=0.0))))))
    return worst
