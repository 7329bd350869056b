"""A star of users in network namespaces: one process that reads every packet and decides what becomes of it.

    unshare --net python hub.py USERS SEED SECONDS

Each user is a namespace with one TUN device, 10.77.0.USER/24 from 1; what goes to 100 and 200 more than that is for the
same user, which may take these addresses instead. A namespace lives as long as a process that does
nothing but read from this one, so when this one ends, however it ends, all of it is gone. Orders come as lines of JSON,
`[from, to, {law}]`, users from 0; the end of the input, or of the time, ends it all.
"""

import contextlib
import fcntl
import heapq
import json
import os
import select
import struct
import subprocess
import sys
import time

import numpy as np

from cotouch.samples import EmulatedPath, PathLaw

TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 0x0001, 0x1000


def run(*command: str) -> None:
    subprocess.run(command, check=True, timeout=20, stdout=subprocess.DEVNULL)


def open_user(user: int) -> tuple[subprocess.Popen[bytes], int]:
    """Process that holds a namespace, and the other end of the device in it."""
    holder = subprocess.Popen(
        ["unshare", "--net", "sh", "-c", "echo; exec cat"], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    )
    holder.stdout.readline()  # the namespace is there
    name = f"user{user}"
    device = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK | os.O_CLOEXEC)
    fcntl.ioctl(device, TUNSETIFF, struct.pack("16sH22x", name.encode(), IFF_TUN | IFF_NO_PI))
    run("ip", "link", "set", name, "netns", str(holder.pid))
    inside = ("nsenter", "-t", str(holder.pid), "-n", "ip")
    run(*inside, "link", "set", "lo", "up")
    run(*inside, "addr", "add", f"10.77.0.{user + 1}/24", "dev", name)
    run(*inside, "link", "set", name, "up", "txqueuelen", "5000")
    return holder, device


def main(users: int, seed: int, seconds: float) -> None:
    opened = [open_user(user) for user in range(users)]
    devices = [device for _, device in opened]
    paths = {
        (i, j): EmulatedPath(PathLaw(), np.random.default_rng([seed, i, j]))
        for i in range(users)
        for j in range(users)
        if i != j
    }
    print(json.dumps([holder.pid for holder, _ in opened]), flush=True)
    waiting: list[tuple[float, int, int, bytes]] = []
    orders, count, end = b"", 0, time.monotonic() + seconds
    while (now := time.monotonic()) < end:
        while waiting and waiting[0][0] <= now:
            _, _, to, packet = heapq.heappop(waiting)
            with contextlib.suppress(OSError):  # its queue is full, or it is going down: a lost packet
                os.write(devices[to], packet)
        wait = min(end, waiting[0][0] if waiting else end) - now
        ready, _, _ = select.select([0, *devices], [], [], max(0.0, wait))
        for source in ready:
            if source == 0:
                read = os.read(0, 65536)
                if not read:
                    return
                *lines, orders = (orders + read).split(b"\n")
                for line in lines:
                    i, j, law = json.loads(line)
                    paths[i, j].law = PathLaw(**law)
                    print("done", flush=True)
                continue
            i = devices.index(source)
            for _ in range(100):
                try:
                    packet = os.read(source, 2048)
                except OSError:
                    break
                # IPv4 within the star; the kernel also tries IPv6 and groups, which nobody here wants.
                if len(packet) < 20 or packet[0] >> 4 != 4 or packet[16:19] != b"\x0a\x4d\x00":
                    continue
                j = packet[19] % 100 - 1
                if (i, j) in paths:
                    for when in paths[i, j].arrivals(time.monotonic(), len(packet)):
                        count += 1
                        heapq.heappush(waiting, (when, count, j, packet))


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3]))
