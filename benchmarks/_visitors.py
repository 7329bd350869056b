"""Visitors of a session's control plane: they connect to everybody, see everybody, and are gone, one after the other.

    python -m benchmarks._visitors COUNT OTHERS        the invitation on its standard input

Each is new: another key, another connection to each member. So a process that is a minute old has seen as many
connections as others in an hour, and what is kept of connections up to some number, such as TLS tickets and the
allocator's stock of every thread, is full.
"""

import os
import sys
import time

from cotouch.control import Invitation, ZenohControl
from cotouch.samples import Identity

# Who was found by gossip is dialled once; a visit does not wait for a connection that does not come [s].
_PATIENCE = 1.0


def main(count: int, others: int) -> None:
    invitation = Invitation.decode(sys.stdin.readline().strip())
    for _ in range(count):
        control = ZenohControl(invitation, Identity.make(os.urandom))
        end = time.monotonic() + _PATIENCE
        while len(control.present()) < others and time.monotonic() < end:
            time.sleep(0.01)
        control.close()


if __name__ == "__main__":
    main(int(sys.argv[1]), int(sys.argv[2]))
