"""Two users, each behind a NAT of its own, and a public network between the NATs, as namespaces of this kernel.

    unshare --net python yard.py kept|random SECONDS

This process's own namespace is the public one, 203.0.113.1 and .129; the NATs are 203.0.113.2 and .130, the users
behind them 10.1.0.2 and 10.2.0.2. Prints the processes that hold the namespaces: public, both NATs, both users. When
it ends, however it ends, all of it is gone; it ends with its input, or the time.
"""

import json
import os
import select
import subprocess
import sys

PUBLIC = ("203.0.113.1", "203.0.113.129")
OUTSIDE = ("203.0.113.2", "203.0.113.130")


def run(*command: str) -> None:
    subprocess.run(command, check=True, timeout=20, stdout=subprocess.DEVNULL)


def hold() -> subprocess.Popen[bytes]:
    holder = subprocess.Popen(
        ["unshare", "--net", "sh", "-c", "echo; exec cat"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    holder.stdout.readline()  # the namespace is there
    return holder


def inside(holder: subprocess.Popen[bytes], *command: str) -> None:
    run("nsenter", "-t", str(holder.pid), "-n", *command)


def wire(one: tuple[int, str, str], two: tuple[int, str, str]) -> None:
    """A cable between two namespaces: process, name and address of each end."""
    run("ip", "link", "add", "name", "cable0", "type", "veth", "peer", "name", "cable1")
    for end, (pid, name, address) in zip(("cable0", "cable1"), (one, two), strict=True):
        run("ip", "link", "set", end, "netns", str(pid))
        enter = ("nsenter", "-t", str(pid), "-n", "ip")
        run(*enter, "link", "set", end, "name", name)
        run(*enter, "addr", "add", address, "dev", name)
        run(*enter, "link", "set", name, "up")


def main(ports: str, seconds: float) -> None:
    nats, users = [hold(), hold()], [hold(), hold()]
    run("ip", "link", "set", "lo", "up")
    forward = ("sh", "-c", "echo 1 > /proc/sys/net/ipv4/ip_forward")
    run(*forward)
    for k, (nat, user) in enumerate(zip(nats, users, strict=True)):
        wire((os.getpid(), f"public{k}", f"{PUBLIC[k]}/25"), (nat.pid, "wan", f"{OUTSIDE[k]}/25"))
        wire((nat.pid, "lan", f"10.{k + 1}.0.1/24"), (user.pid, "lan", f"10.{k + 1}.0.2/24"))
        for end in (nat, user):
            inside(end, "ip", "link", "set", "lo", "up")
        inside(nat, "ip", "route", "add", "default", "via", PUBLIC[k])
        inside(user, "ip", "route", "add", "default", "via", f"10.{k + 1}.0.1")
        inside(nat, *forward)
        random = ("--random-fully",) if ports == "random" else ()
        inside(nat, "iptables", "-t", "nat", "-A", "POSTROUTING", "-o", "wan", "-j", "MASQUERADE", *random)
        # As routers do. Without it the first ping to arrive is the router's own, and takes the port from its user.
        inside(nat, "iptables", "-A", "INPUT", "-i", "wan", "-j", "DROP")
    print(json.dumps([os.getpid(), *(holder.pid for holder in (*nats, *users))]), flush=True)
    select.select([0], [], [], seconds)


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]))
