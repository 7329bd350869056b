"""`cotouch join --device haply` takes part in a live session, against the stand-in, until the device is unplugged."""

import json
import os
import signal
import time
from collections.abc import Generator
from pathlib import Path

import numpy as np
import pytest
from tests.cli.test_session_commands import Running
from tests.drivers.standin import Fault, Service
from tests.stalls import Stalls

from cotouch.recording import audit, read_recording

SESSION = """
title = "A hand"
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.01], [0.01, 0]]
[body]
kind = "chain"
nodes = 2
spacing = 0.1
dimension = 3
mass = 0.3
damping = 0.5
stiffness = 50.0
ground = [1]
ground_stiffness = 30.0
[steps]
rate = 100
[session]
emulate = true
[[hands]]
user = 1
node = 2
path = [[0, 0, 0, 0], [1, 0.01, 0, 0]]
[[hands]]
user = 2
node = 2
path = [[0, 0, 0, 0], [1, 0.01, 0, 0]]
"""


@pytest.fixture
def running(tmp_path: Path) -> Generator[Running]:
    made = Running(tmp_path)
    yield made
    made.close()


def interrupted(process) -> int:
    os.kill(process.pid, signal.SIGINT)
    return process.wait(60)


def test_an_inverse3_takes_part_until_it_is_unplugged_and_the_others_go_on(
    service: Service, running: Running, tmp_path: Path, stalls: Stalls
):
    (tmp_path / "hand.toml").write_text(SESSION)
    host = running.start("host", "host", tmp_path / "hand.toml", "--json")
    running.until(lambda: running.out("host").endswith("}\n"), "the invitation")
    line = json.loads(running.out("host"))["invitation"]
    device = f"haply:url={service.url},events={service.events}"
    ann_of = ("join", line, "--name", "Ann", "--device", device, "--record", tmp_path / "a.mcap", "--json")
    ann = running.start("Ann", *ann_of)
    ben = running.start(
        "Ben", "join", line, "--name", "Ben", "--device", "none", "--record", tmp_path / "b.mcap", "--json"
    )

    def felt() -> bool:
        assert ann.poll() is None, running.err("Ann")
        return bool(np.linalg.norm(service.board.get("motor")) > 0.1)

    running.until(felt, "force at the device")
    running.until(lambda: service.board.get("sets") > 1000, "a second of it")
    service.board.inject(Fault.UNPLUGGED)  # while its hand goes round
    running.until(lambda: "the device failed" in running.err("Ann"), "the reason, on Ann's screen")
    struck = service.board.get("struck")
    stalls.within(struck, service.board.gone_after(struck))
    time.sleep(1.0)
    assert ann.poll() is None
    assert ben.poll() is None
    assert interrupted(ann) == 0, running.err("Ann")
    assert not np.any(service.board.get("motor"))
    assert interrupted(ben) == 0
    assert interrupted(host) == 0
    said, bens = json.loads(running.out("Ann")), json.loads(running.out("Ben"))
    assert said["device"]["name"] == "Haply Inverse3"
    # The event or the list of devices, whichever comes first.
    assert any("was disconnected" in text or "is gone from" in text for text in said["device"]["said"])
    assert said["device"]["causes"] == ["the device failed or returned no valid numbers"]
    for one in (said, bens):
        assert one["status"]["residual"] < 1e-9
    recordings = [read_recording(tmp_path / f"{name}.mcap") for name in "ab"]
    moved = [np.ptp(recording.states["position"], axis=0).max() for recording in recordings]
    for recording in recordings:  # 100 steps a second, on the clock of the stand-in
        assert (recording.columns["time"] > struck).sum() > 50
    assert moved[1] > 1e-3  # Ben, who touches nothing, is moved by the hand that holds the Inverse3
    found = audit(recordings)
    assert found.holds, found.findings
