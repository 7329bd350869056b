"""Users as processes: on this machine's own network, and in five namespaces with the paper's delays and worse."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from tests.live.emulator.star import Star, obstacle
from tests.live.node import keys_as_text
from tests.live.support import agree, agreements, identities, layout, state_of

from cotouch.peer import Sample
from cotouch.samples import Assembly, PathLaw, SampleLink, SamplePlane, UdpTransport

NODE = Path(__file__).with_name("node.py")
# The paper's network [Lee & Huang 2010, section IV]: row i, column j is the delay from j to i [s]; its fastest links.
DELAY = [
    [0, 0.1, 0.8, 0.8, 1.0], [0.05, 0, 0.05, 0.05, 0.8], [0.8, 0.04, 0, 0.05, 0.8], [0.8, 0.04, 0.05, 0, 0.05],
    [1.0, 0.8, 0.8, 0.04, 0],
]  # fmt: skip
LINKS = [(0, 1), (0, 3), (1, 2), (1, 3), (2, 3), (3, 4)]


def configure(
    folder: Path, links: list[tuple[int, int]], at: Callable[[int], tuple[str, int]], seconds: float, period: float
) -> list[Path]:
    """A file for each user, with keys that the users have agreed on; every clock shows another time."""
    users = 1 + max(max(link) for link in links)
    members = identities(users)
    given = [
        {"user": user, "host": at(user)[0], "port": at(user)[1], "rows": 50, "period": period, "seconds": seconds}
        | {"offset": 1000.0 * user - 1.7 * user**2, "epoch": 3, "neighbours": {}}
        for user in range(users)
    ]
    for i, j in links:
        ends = agreements(members[i], members[j], connection=(100 * i + j, 100 * j + i), seed=10 * i + j)
        keys = agree(*ends)
        first = (i, j) if members[i].public < members[j].public else (j, i)
        for user, other, own in zip(first, first[::-1], keys, strict=True):
            given[user]["neighbours"][other] = {"at": at(other), "keys": keys_as_text(own)}
    paths = [folder / f"user{user}.json" for user in range(users)]
    for path, text in zip(paths, given, strict=True):
        path.write_text(json.dumps(text))
    return paths


def finish(running: list[subprocess.Popen[str]], seconds: float) -> list[dict]:
    results = []
    try:
        for process in running:
            assert process.stdout.readline() == "ready\n", process.stderr.read()
        for process in running:
            process.stdin.write("\n")
            process.stdin.flush()
        for process in running:
            out, errors = process.communicate(timeout=seconds + 60)
            assert process.returncode == 0, errors
            results.append(json.loads(out))
    finally:
        for process in running:
            process.kill()
            process.communicate()
    return results


def free_ports(count: int) -> list[int]:
    held = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(count)]
    for one in held:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in held]
    for one in held:
        one.close()
    return ports


def test_five_processes_on_this_machine(tmp_path: Path):
    ports = free_ports(5)
    files = configure(tmp_path, LINKS, lambda user: ("127.0.0.1", ports[user]), 3.0, 0.01)
    command = [sys.executable, str(NODE)]
    pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    running = [subprocess.Popen([*command, str(path)], text=True, **pipes) for path in files]
    for result in finish(running, 3.0):
        assert (result["wrong"], result["strays"], result["unsent"]) == (0, 0, {})
        for link in result["links"].values():
            assert link["complete"]
            assert link["impossible"] == 0
            assert set(link["refused"]) == set()
            assert 0.0 < link["shortest_path"] <= link["worst_sum"]


no_star = obstacle()
needs_star = pytest.mark.skipif(no_star is not None, reason=f"no emulated network: {no_star}")


@pytest.mark.slow
@needs_star
def test_the_papers_network_and_worse(tmp_path: Path):
    """Its delays, and on every path 200 ms of jitter, 30 % loss, duplicates, and half of all packets held back."""
    seconds = 8.0
    with Star(5, seconds=600.0) as star:
        for i in range(5):
            for j in range(5):
                if i != j:
                    bad = PathLaw(delay=DELAY[i][j], jitter=0.2, loss=0.3, duplication=0.1, reordering=0.5, hold=0.05)
                    star.set(j, i, bad)
        files = configure(tmp_path, LINKS, lambda user: (star.address(user), 7000), seconds, 0.01)
        results = finish(
            [star.start(user, [sys.executable, str(NODE), str(path)]) for user, path in enumerate(files)], seconds
        )
    for result in results:
        assert (result["wrong"], result["strays"], result["dropped"]) == (0, 0, {})
        for name, link in result["links"].items():
            i, j = result["user"], int(name)
            path = DELAY[i][j] + DELAY[j][i]
            assert link["complete"]
            assert link["impossible"] == 0
            assert set(link["refused"]) <= {"REPLAYED", "STALE"}
            assert link["opened"] > 50
            assert path <= link["shortest_path"] <= link["worst_sum"]
            assert path <= link["median_sum"] <= link["worst_sum"]
    for i, j in LINKS:  # two ends that know nothing of each other's clocks find the same sum
        one, other = (results[a]["links"][str(b)]["median_sum"] for a, b in ((i, j), (j, i)))
        assert one == pytest.approx(other, rel=0.25)


@needs_star
def test_the_star_keeps_its_laws():
    """Delay, loss and outage as ordered, seen from inside two namespaces."""
    probe = (  # an answer may come after the next question was asked
        "import socket, sys, time\n"
        "s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind((sys.argv[1], 7000)); s.settimeout(0.2)\n"
        "asked = []; got = 0; begin = time.monotonic(); quickest = 9.0\n"
        "while time.monotonic() < begin + 2.0:\n"
        "    asked.append(time.monotonic()); s.sendto(b'%d' % (len(asked) - 1), (sys.argv[2], 7000))\n"
        "    try:\n"
        "        which = int(s.recv(10)); got += 1; quickest = min(quickest, time.monotonic() - asked[which])\n"
        "    except TimeoutError: pass\n"
        "print(got, quickest)\n"
    )
    echo = (
        "import socket, sys\n"
        "s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind((sys.argv[1], 7000)); s.settimeout(20)\n"
        "while True:\n"
        "    data, source = s.recvfrom(10); s.sendto(data, source)\n"
    )
    with Star(2) as star:
        serving = star.start(1, [sys.executable, "-c", echo, star.address(1)])
        try:
            for law, alive in ((PathLaw(delay=0.03), True), (PathLaw(down=True), False), (PathLaw(delay=0.01), True)):
                star.set(0, 1, law)
                out, _ = star.start(0, [sys.executable, "-c", probe, star.address(0), star.address(1)]).communicate(
                    timeout=60
                )
                got, quickest = out.split()
                assert (int(got) > 0) == alive
                assert not alive or float(quickest) >= law.delay
        finally:
            serving.kill()
            serving.communicate()


@needs_star
def test_nothing_is_left_of_a_star_that_was_killed():
    star = Star(3)
    os.kill(star.hub.pid, signal.SIGKILL)
    star.hub.wait(10)
    for _ in range(1200):
        if not any(alive(pid) for pid in star.holders):
            break
        time.sleep(0.05)
    assert not any(alive(pid) for pid in star.holders)
    star.close()


def alive(pid: int) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


class Nat:
    """Stands before one user; forwards both ways, and gets another outside port when it forgets its mapping."""

    def __init__(self, inside: tuple[str, int], outside: tuple[str, int]) -> None:
        self.user, self.other = inside, outside
        self.inner, self.outer = self.open(), self.open()

    def open(self) -> socket.socket:
        made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        made.bind(("127.0.0.1", 0))
        made.setblocking(False)
        return made

    def forward(self) -> None:
        for source, sink, to in ((self.inner, self.outer, self.other), (self.outer, self.inner, self.user)):
            for _ in range(1000):
                try:
                    payload = source.recv(2000)
                except BlockingIOError:
                    break
                sink.sendto(payload, to)

    def forget(self) -> None:
        self.outer.close()
        self.outer = self.open()


def test_samples_go_on_through_a_nat_that_forgets():
    """Real sockets: user 0 is behind the NAT, user 1 never learns where, except from sealed datagrams."""
    shape = layout(4, 3)
    transports = [UdpTransport(), UdpTransport()]
    nat = Nat(tuple(transports[0].address), tuple(transports[1].address))
    made = []
    for user, keys in enumerate(agree(*agreements(*identities()))):
        plane = SamplePlane(transports[user], shape, user=user, epoch=3)
        link = SampleLink(Assembly(shape, sender=1 - user, initial=np.zeros((4, 4))))
        link.seal.install(keys)
        plane.connect(1 - user, link, at=nat.inner.getsockname() if user == 0 else None)
        made.append(plane)
    k = 0
    for _ in range(3):
        nat.forget()
        goal = k + 10
        while min(plane.links[1 - plane.user].assembly.newest for plane in made) < goal:
            k += 1
            assert k < 3000
            for plane in made:
                now = time.monotonic()
                plane.poll(now)
                plane.send(now, Sample(sender=plane.user, index=k, stamp=now, position=state_of(shape, 0)), 0.001)
            nat.forward()
            time.sleep(0.002)
    for end in (*transports, nat.inner, nat.outer):
        end.close()
