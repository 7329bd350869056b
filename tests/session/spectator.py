"""Watches a session from a namespace of its own, and keeps what it sees in a file, whole at any time.

python tests/session/spectator.py INVITATION ADDRESS FILE SECONDS
"""

import json
import sys
import time
from pathlib import Path

from cotouch.control import Invitation
from cotouch.session import watching


def main(invitation: str, address: str, file: str, seconds: float) -> None:
    path, beside = Path(file), Path(f"{file}.new")
    end = time.monotonic() + seconds
    with watching(Invitation.decode(invitation), listen=address) as watch:
        while time.monotonic() < end:
            now = time.monotonic()
            watch.service(now)
            seen = {
                seen.entry.name: {"age": now - seen.time, **seen.status.model_dump()}
                for seen in watch.members.values()
                if seen.status is not None
            }
            beside.write_text(json.dumps({"members": seen, "ended": watch.ended, "epoch": watch.roster.epoch}))
            beside.replace(path)
            time.sleep(0.1)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3], float(sys.argv[4]))
