"""Serves the page of made-up motion: `python -m tests.web.serve --body 1d|chain|2d|bare|3d|big --port 8765`."""

import argparse
import signal
import threading
from pathlib import Path
from typing import cast

from tests.web.fake_session_api import KINDS, FakeSessionApi, Kind

from cotouch.web import PageServer


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--body", choices=KINDS, default="3d")
    options.add_argument("--port", type=int, default=None)
    options.add_argument("--static", type=Path, default=None)
    options.add_argument("--token", default=None)
    asked = options.parse_args()
    stop = threading.Event()
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda *_: stop.set())
    with PageServer(
        FakeSessionApi(cast("Kind", asked.body)), port=asked.port, static=asked.static, token=asked.token
    ) as server:
        print(server.url, flush=True)
        stop.wait()


if __name__ == "__main__":
    main()
