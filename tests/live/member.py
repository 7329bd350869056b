"""A member as a process of its own: says something every 50 ms, and tells who says the same when it is asked.

python tests/live/member.py CONFIG.json      one line of JSON for every line on its input; ends with its input
"""

import json
import select
import sys
import time
from pathlib import Path

from cotouch.control import Endpoint, Invitation, ZenohControl
from cotouch.samples import Identity


def main(path: str) -> None:
    given = json.loads(Path(path).read_text())
    invitation = Invitation.decode(given["invitation"])
    listen = given.get("listen")
    if listen is not None and ":" in listen:
        listen = Endpoint.parse(listen)
    plane = ZenohControl(invitation, Identity(bytes.fromhex(given["secret"])), listen=listen)
    received: dict[str, float] = {}
    beat = b""
    direct: list[str] = []
    print(json.dumps({"here": plane.identity.public.hex()}), flush=True)
    ends = time.monotonic() + given["seconds"]
    while time.monotonic() < ends:
        plane.send("beat", beat)
        for message in plane.poll():
            if message.direct:
                direct.append(message.body.decode())
            elif message.body == beat:
                received[message.sender.hex()] = time.monotonic()
        if not select.select([sys.stdin], [], [], 0.05)[0]:
            continue
        line = sys.stdin.readline()
        if not line:
            break
        asked = json.loads(line)
        if "beat" in asked:
            beat = asked["beat"].encode()
            received.clear()
        if "to" in asked:
            plane.send("say", asked["say"].encode(), to=bytes.fromhex(asked["to"]))
        now = time.monotonic()
        told = {
            "present": sorted(key.hex() for key in plane.present()),
            "hears": sorted(key for key, then in received.items() if now < then + 0.5),
            "direct": direct,
            "refused": {reason.name: count for reason, count in plane.refused.items()},
            "dropped": plane.dropped,
        }
        print(json.dumps(told), flush=True)
    plane.close()


if __name__ == "__main__":
    main(sys.argv[1])
