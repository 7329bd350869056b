"""Starts a star of namespaces (`hub.py`), gives it orders and runs programs in it; says why where it cannot."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path

from cotouch.samples import PathLaw

HUB = Path(__file__).with_name("hub.py")
# Another user's rights end at its own namespaces, which is all that is needed, where the kernel allows them.
ROOT = os.geteuid() == 0
BECOME = ["unshare", "--net"] if ROOT else ["unshare", "--user", "--map-root-user", "--net"]
ENTER = ["nsenter", "--net"] if ROOT else ["nsenter", "--user", "--preserve-credentials", "--net"]


def obstacle() -> str | None:
    """Why there can be no star here; None if there can."""
    missing = [tool for tool in ("unshare", "nsenter", "ip") if shutil.which(tool) is None]
    if missing:
        return f"{', '.join(missing)} not installed (util-linux, iproute2)"
    if not os.access("/dev/net/tun", os.R_OK | os.W_OK):
        return "/dev/net/tun is not there or not ours"
    for command in (["ip", "tuntap", "add", "dev", "try0", "mode", "tun"], [sys.executable, "-c", ""]):
        tried = subprocess.run([*BECOME, *command], capture_output=True, text=True, timeout=20, check=False)
        if tried.returncode != 0:
            return f"network namespaces are not permitted: {tried.stderr.strip()}"
    return None


class Star:
    """Users 0, 1, ... in namespaces, every pair joined by a path in each direction; close it, or use it in `with`."""

    def __init__(self, users: int, *, seed: int = 0, seconds: float = 120.0) -> None:
        self.hub = subprocess.Popen(
            [*BECOME, sys.executable, str(HUB), str(users), str(seed), str(seconds)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        ready = self.hub.stdout.readline()
        if not ready:
            self.close()
            raise OSError("the hub did not start")
        self.holders: list[int] = json.loads(ready)

    def set(self, sender: int, receiver: int, law: PathLaw) -> None:
        """Changes one direction, from the next packet on."""
        given = {name: value for name, value in asdict(law).items() if value != float("inf")}
        self.hub.stdin.write(json.dumps([sender, receiver, given]) + "\n")
        self.hub.stdin.flush()
        assert self.hub.stdout.readline() == "done\n"

    def address(self, user: int, *, moved: bool = False) -> str:
        return f"10.77.0.{user + 1 + 100 * moved}"

    def order(self, user: int, *commands: str) -> None:
        """`ip` with these arguments in the user's namespace, where its device is called DEV; one after the other."""
        enter = [ENTER[0], "-t", str(self.holders[user]), *ENTER[1:], "ip"]
        for command in commands:
            subprocess.run([*enter, *command.replace("DEV", f"user{user}").split()], check=True, timeout=20)

    def move(self, user: int) -> None:
        """From now on the user has another address, and not the one that it had."""
        old, new = self.address(user), self.address(user, moved=True)
        self.order(user, f"addr del {old}/24 dev DEV", f"addr add {new}/24 dev DEV")

    def start(self, user: int, command: Sequence[str]) -> subprocess.Popen[str]:
        """A program as this user, on its own network."""
        enter = [ENTER[0], "-t", str(self.holders[user]), *ENTER[1:]]
        pipes = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
        return subprocess.Popen([*enter, *command], text=True, **pipes)

    def close(self) -> None:
        self.hub.stdin.close()
        try:
            self.hub.wait(10)
        except subprocess.TimeoutExpired:
            self.hub.kill()
            self.hub.wait(10)
        self.hub.stdout.close()

    def __enter__(self) -> "Star":
        return self

    def __exit__(self, *error: object) -> None:
        self.close()
