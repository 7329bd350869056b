"""A user as a process of its own: sends a state that tells its step, and checks what it holds of the others.

    python tests/live/node.py CONFIG.json        one line of JSON at the end

Its clock is off by whatever the configuration says, as clocks of different machines are.
"""

import json
import sys
import time
from pathlib import Path

import numpy as np

from cotouch.peer import Sample
from cotouch.samples import Assembly, DirectionKeys, Layout, LinkKeys, SampleLink, SamplePlane, SendRate, UdpTransport


def state_at(step: int, user: int, rows: int) -> np.ndarray:
    """What a user sends in a step; nobody else sends the same, nor it twice."""
    out = np.zeros((rows, 4))
    out[:, :3] = (step + 0.1 * user) + 1e-6 * np.arange(3 * rows).reshape(rows, 3)
    return out


def keys_as_text(keys: LinkKeys) -> dict[str, object]:
    sides = {
        name: [side.connection, side.key.hex(), side.iv.hex()]
        for name, side in (("sending", keys.sending), ("receiving", keys.receiving))
    }
    return {"epoch": keys.epoch, "wait": keys.wait, **sides}


def keys_from_text(text: dict[str, object]) -> LinkKeys:
    sides = {
        name: DirectionKeys(text[name][0], *map(bytes.fromhex, text[name][1:])) for name in ("sending", "receiving")
    }
    return LinkKeys(epoch=text["epoch"], wait=text["wait"], **sides)


def main(path: str) -> None:
    given = json.loads(Path(path).read_text())
    user, rows, T, offset = given["user"], given["rows"], given["period"], given["offset"]

    def clock() -> float:
        return time.monotonic() + offset

    transport = UdpTransport(host=given["host"], port=given["port"], clock=clock)
    layout = Layout(rows=rows, width=4, axes=3, limit=1e6)
    plane = SamplePlane(transport, layout, user=user, epoch=given["epoch"])
    for name, neighbour in given["neighbours"].items():
        j = int(name)
        link = SampleLink(Assembly(layout, sender=j, initial=np.zeros((rows, 4))), rate=SendRate(highest=1.0 / T))
        link.seal.install(keys_from_text(neighbour["keys"]))
        plane.connect(j, link, at=tuple(neighbour["at"]))
    print("ready", flush=True)
    sys.stdin.readline()  # all begin together, however long each took to load
    wrong, useful, begin = 0, 0, clock()
    for k in range(round(given["seconds"] / T)):
        time.sleep(max(0.0, begin + (k + 1) * T - clock()))
        now = clock()
        useful += plane.poll(now)
        plane.stepped(now)
        for j, link in plane.links.items():
            for at, step in enumerate(link.assembly.indices):
                span = layout.span(at)
                if step >= 0 and not np.array_equal(link.assembly.state[span], state_at(step, j, rows)[span]):
                    wrong += 1
        plane.send(now, Sample(sender=user, index=k, stamp=now - 0.5 * T, position=state_at(k, user, rows)), T)
    transport.close()
    print(
        json.dumps(
            {
                "user": user,
                "wrong": wrong,
                "useful": useful,
                "unsent": transport.traffic.unsent,
                "dropped": transport.traffic.dropped,
                "strays": sum(plane.refused.values()),
                "links": {
                    str(j): {
                        "newest": link.assembly.newest,
                        "complete": link.assembly.complete,
                        "opened": link.seal.received[1],
                        "refused": {reason.name: count for reason, count in link.refused.items()},
                        "worst_sum": link.ages.worst_sum,
                        "median_sum": link.ages.sum_quantile(0.5),
                        "shortest_path": link.ages.shortest_path,
                        "impossible": link.ages.impossible,
                        "rate": link.rate.rate,
                        "own_loss": link.rate.own_loss,
                    }
                    for j, link in plane.links.items()
                },
            }
        )
    )


if __name__ == "__main__":
    main(sys.argv[1])
