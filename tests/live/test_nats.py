"""Two users behind NATs of this kernel: iptables masquerades, namespaces hold them, a process relays."""

import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from tests.conftest import IMPORTS
from tests.live.emulator import exchange as exchange_module
from tests.live.emulator.star import BECOME, ENTER
from tests.live.emulator.yard import OUTSIDE, PUBLIC
from tests.live.node import keys_as_text
from tests.live.support import agree, agreements, identities

YARD = Path(__file__).with_name("emulator") / "yard.py"
WALKER = Path(__file__).with_name("walker.py")
ROOT = Path(__file__).parents[2]
HOST, RELAY = (PUBLIC[0], 7000), (PUBLIC[0], 7001)
# What each wait is bounded by; what is waited for takes a tenth of it.
PATIENCE = 40.0


def obstacle() -> str | None:
    """Why there can be no NATs here; None if there can."""
    missing = [tool for tool in ("unshare", "nsenter", "ip", "iptables") if shutil.which(tool) is None]
    if missing:
        return f"{', '.join(missing)} not installed (util-linux, iproute2, iptables)"
    try_it = (
        "iptables -t nat -A POSTROUTING -j MASQUERADE --random-fully && ip link add name try0 type veth peer name try1"
    )
    tried = subprocess.run([*BECOME, "sh", "-c", try_it], capture_output=True, text=True, timeout=20, check=False)
    if tried.returncode != 0:
        return f"namespaces with NATs are not permitted: {tried.stderr.strip()}"
    return None


no_nats = obstacle()
pytestmark = [pytest.mark.slow, pytest.mark.skipif(no_nats is not None, reason=f"no NATs here: {no_nats}")]


class Yard:
    """The running network, and what each user said last."""

    def __init__(self, holders: list[int]) -> None:
        self.public, *self.nats = holders[:3]
        self.users = holders[3:]
        self.running: list[subprocess.Popen[str]] = []

    def start(self, holder: int, *command: str) -> subprocess.Popen[str]:
        enter = [ENTER[0], "-t", str(holder), *ENTER[1:]]
        started = subprocess.Popen(
            [*enter, *command], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            env={**os.environ, "PYTHONPATH": IMPORTS},
        )  # fmt: skip
        self.running.append(started)
        return started

    def order(self, holder: int, command: str) -> None:
        """A command in a namespace, waited for."""
        assert self.start(holder, "sh", "-ec", command).wait(20) == 0

    def close(self) -> None:
        for process in self.running:
            process.kill()
            process.communicate()


@contextmanager
def yard(ports: str) -> Iterator[Yard]:
    keeper = subprocess.Popen(
        [*BECOME, sys.executable, str(YARD), ports, "900"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    ready = keeper.stdout.readline()
    made = Yard(json.loads(ready)) if ready else None
    try:
        assert made is not None, "the network did not start"
        yield made
    finally:
        if made is not None:
            made.close()
        keeper.communicate("end", timeout=20)


def users(running: Yard, folder: Path) -> list[subprocess.Popen[str]]:
    """Host, relay and both users, started; returns the users."""
    members = identities(3)
    ends = agree(*agreements(*members[:2]))
    first = (0, 1) if members[0].public < members[1].public else (1, 0)
    keys = dict(zip(first, ends, strict=True))
    for user in range(3):
        given = {"user": user, "secret": members[user].secret.hex(), "relay": RELAY, "seconds": 140.0}
        given |= {"host": HOST[0], "mirrors": [], "neighbours": {}}
        if user < 2:
            other = {"member": members[1 - user].public.hex(), "keys": keys_as_text(keys[user])}
            given |= {"host": "0.0.0.0", "mirrors": [HOST], "neighbours": {1 - user: other}}
        (folder / f"user{user}.json").write_text(json.dumps(given))
    relay = running.start(running.public, sys.executable, exchange_module.__file__, RELAY[0], str(RELAY[1]))
    assert relay.stdout.readline() == "ready\n"
    started = [
        running.start(holder, sys.executable, str(WALKER), str(folder / f"user{user}.json"))
        for user, holder in ((2, running.public), (0, running.users[0]), (1, running.users[1]))
    ]
    return started[1:]


def until(walkers: list[subprocess.Popen[str]], what: Callable[[dict], bool]) -> list[dict]:
    """What each says first that fits; lines before it are let pass."""
    out, end = [], time.monotonic() + PATIENCE
    for walker in walkers:
        while True:
            said = json.loads(walker.stdout.readline())
            if what(said):
                out.append(said)
                break
            assert time.monotonic() < end, said
    return out


def by(path_state: str) -> Callable[[dict], bool]:
    return lambda said: set(said["ways"].values()) == {path_state}


def newer(than: list[dict], by: str) -> Callable[[dict], bool]:
    """More samples were taken, and by this way."""
    least = max(next(iter(said["newest"].values())) for said in than)
    most = max(said[by] for said in than)
    return lambda said: min(said["newest"].values()) > least + 20 and said[by] > most + 20


def test_ports_are_kept(tmp_path: Path):
    """Punched; the NAT forgets and gives another port; the path between the NATs is cut and comes back."""
    with yard("kept") as running:
        walkers = users(running, tmp_path)
        said = until(walkers, by("DIRECT"))
        said = until(walkers, newer(said, "direct"))
        assert {tuple(one["mapped"][0]) for one in said} == {(host, 7000) for host in OUTSIDE}

        # Masquerading forgets what went through a device that goes down.
        running.order(
            running.nats[0],
            "iptables -t nat -I POSTROUTING -o wan -p udp -j MASQUERADE --to-ports 51000;"
            f"ip link set wan down; ip link set wan up; ip route replace default via {PUBLIC[0]}",
        )
        said = until(walkers[:1], lambda one: one["mapped"] == [[OUTSIDE[0], 51000]])
        said = until(walkers, by("DIRECT"))
        said = until(walkers, newer(said, "direct"))

        running.order(running.public, "iptables -A FORWARD -p udp -j DROP")
        said = until(walkers, lambda one: "DIRECT" not in one["ways"].values())
        said = until(walkers, newer(said, "relayed"))
        assert {rate <= 100.0 for one in said for rate in one["rate"].values()} == {True}
        running.order(running.public, "iptables -F FORWARD")
        said = until(walkers, by("DIRECT"))
        until(walkers, newer(said, "direct"))


def test_ports_are_random(tmp_path: Path):
    """Each destination sees another port, so nobody can be told which: relayed."""
    with yard("random") as running:
        walkers = users(running, tmp_path)
        said = until(walkers, by("RELAYED"))
        said = until(walkers, newer(said, "relayed"))
        assert all(one["mapped"][0][1] != 7000 for one in said)
        assert [one["direct"] for one in said] == [0, 0]
