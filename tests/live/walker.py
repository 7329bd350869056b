"""A user behind a NAT as a process of its own: finds ways, sends states, and says ten times a second how it goes.

python tests/live/walker.py CONFIG.json        lines of JSON, until its input ends
"""

import json
import os
import select
import sys
import time
from pathlib import Path

import numpy as np
from tests.live.emulator.exchange import TcpControl
from tests.live.node import keys_from_text

from cotouch.peer import Sample
from cotouch.samples import Address, Assembly, Identity, Layout, SampleLink, SamplePlane, UdpTransport
from cotouch.traversal import RoutedTransport

T = 0.01


def main(path: str) -> None:
    given = json.loads(Path(path).read_text())
    user = given["user"]
    control = TcpControl(Identity(bytes.fromhex(given["secret"])), tuple(given["relay"]))
    transport = RoutedTransport(
        UdpTransport(host=given["host"], port=7000),
        control,
        session=b"yard",
        secret=b"secret",
        entropy=os.urandom,
        mirrors=[Address(*mirror) for mirror in given["mirrors"]],
    )
    layout = Layout(rows=4, width=4, axes=3, limit=1e6)
    plane = SamplePlane(transport, layout, user=user)
    for name, neighbour in given["neighbours"].items():
        link = SampleLink(Assembly(layout, sender=int(name), initial=np.zeros((4, 4))))
        link.seal.install(keys_from_text(neighbour["keys"]))
        plane.connect(int(name), link)
        transport.introduce(int(name), bytes.fromhex(neighbour["member"]))
    begin = time.monotonic()
    for k in range(round(given["seconds"] / T)):
        time.sleep(max(0.0, begin + (k + 1) * T - time.monotonic()))
        now = time.monotonic()
        for message in control.poll():
            transport.take(message)
        plane.poll(now)
        plane.stepped(now)
        plane.send(now, Sample(sender=user, index=k, stamp=now, position=np.full((4, 4), 0.5)), T)
        if k % 10 == 0:
            said = {
                "ways": {name: transport.path_state(name).name for name in plane.links},
                "newest": {name: link.assembly.newest for name, link in plane.links.items()},
                "rate": {name: link.rate.rate for name, link in plane.links.items()},
                "events": [[event.path_state.name, event.address] for event in transport.events()],
                "mapped": transport.mapped,
                "direct": transport.direct.received,
                "relayed": transport.relayed.received,
                "probes": transport.probes.sent,
                "dropped": transport.traffic.dropped,
            }
            print(json.dumps(said), flush=True)
            if select.select([0], [], [], 0.0)[0]:
                break
    transport.close()
    control.close()


if __name__ == "__main__":
    main(sys.argv[1])
