"""A device as the hand of a seat: with a tool of the file, one that fits the body, or a node that it holds."""

import os
import signal
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import psutil
import pytest

from cotouch.haptics import Cause, EndOptions, Flag, Report, Word
from cotouch.peer import Peer
from cotouch.recording import audit, read_recording
from cotouch.session import HAND_MODES, MemberProcess, Seat, SessionFile, open_host
from cotouch.session._boards import BoardFolder, view_fields
from cotouch.session._desk import Desk
from cotouch.session._device_hand import DeviceHand
from cotouch.session._replica import Replica

HEAD = """
title = "Two"
[network]
users = ["Ann", "Ben"]
spring = [[0, 50], [50, 0]]
delay = [[0, 0.01], [0.01, 0]]
[steps]
rate = 200
"""
POINT = HEAD + "[body]\nmass = 0.3\nstiffness = 20.0\n"
BLOCK = (
    HEAD
    + """
[body]
kind = "lattice"
shape = [4, 3, 3]
mass = 0.5
stiffness = 200.0
damping = 0.4
spacing = 0.02
ground = "z-"
ground_stiffness = 200.0
"""
)
TOOL = BLOCK + "\n[[tools]]\nuser = 1\nat = [0.09, 0.02, 0.02]\nradius = 0.008\n[tools.hand]\npath = [0.1, 0.0, 0.0]\n"
GRASP = BLOCK + '\n[[tools]]\nuser = 1\nat = [0.06, 0.04, 0.04]\nradius = 0.012\nkind = "grasp"\n'


@dataclass
class Led:
    """A device that goes where it is told, and never lets its energy out."""

    options: EndOptions = field(default_factory=EndOptions)
    place: np.ndarray = field(default_factory=lambda: np.array([0.01, -0.02, 0.03]))
    orders: list = field(default_factory=list)
    given: float = 0.0

    def read(self) -> Report | None:
        self.given += 1e-3  # what a hand that moves puts in
        place = tuple(self.place.tolist())
        nothing = (0.0, 0.0, 0.0)
        word = Word(given=self.given)
        return Report(0.0, 1, place, nothing, nothing, nothing, word, 0.0, 0.0, Cause(0), 0, Flag(0))

    def order(self, place, word, *, enable=True) -> None:
        self.orders.append((place, word))


def led(text: str, towards: list[float]) -> tuple[DeviceHand, Peer, Led, float]:
    """Three hundred steps of one copy while the device goes somewhere; the most that any leaves unexplained [J]."""
    session = SessionFile.from_toml(text, source="a test")
    replica = Replica.build(session)
    model, link = replica.model(1), Led()
    seat = Seat(scenario=replica.scenario, body=replica.body, model=model, index=0, period=5e-3, longest=0.05)
    hand = DeviceHand(seat, link=link)  # type: ignore[arg-type]
    shape = (replica.body.nodes, replica.body.dimension)
    peer = Peer(
        index=0,
        model=model,
        links={},
        strength=[],
        weight=[],
        local_damping=np.zeros(1),
        extra_damping=np.full(1, 1.0),
        grips=hand.grips,
        position=np.zeros(shape),
        velocity=np.zeros(shape),
        surface=hand.surface,
        tools=hand.tools,
    )
    hand.attach(peer.state.position)
    start, residual = link.place.copy(), 0.0
    for k in range(1, 301):
        link.place = start + min(1.0, k / 100) * np.array(towards)
        hand.before(5e-3 * k, 5e-3)
        report = peer.step(5e-3 * k, 5e-3)
        hand.after()
        residual = max(residual, abs(float(report.residual)))
    return hand, peer, link, residual


@pytest.mark.parametrize(
    ("text", "towards", "moved"),
    [
        (POINT, [0.02, 0.0, 0.0], 0),
        (TOOL, [-0.04, 0.0, 0.0], 0),
        (GRASP, [0.0, 0.01, 0.02], 2),
        (BLOCK, [0.0, 0.0, -0.03], 2),
    ],
    ids=["node", "tool", "grasp", "default"],
)
def test_the_proxy_follows_the_device_and_moves_the_copy(text: str, towards: list[float], moved: int):
    hand, peer, link, residual = led(text, towards)
    place, word = link.orders[-1]
    went = np.array(place) - np.array([0.01, -0.02, 0.03])
    axes = peer.model.body.dimension
    # It went the way of the device, as far as the body lets it, and is told to the device in its own frame.
    assert 0.2 < went[moved] / towards[moved] < 1.05
    assert np.array(link.orders[0][0]) == pytest.approx([0.01, -0.02, 0.03], abs=1e-3)
    displaced = np.abs(peer.model.to_nodes(peer.state.position)).max(axis=0)
    assert displaced[min(moved, axes - 1)] > 1e-4
    assert residual < 1e-12
    assert word.purse >= 0.0
    assert (hand.tools is None) == (axes == 1)
    # The page shows it: where the device is, what it holds or pushes with, and what pulls that.
    shown = {
        name: np.zeros(shape, kind) for name, (shape, kind) in view_fields(peer.model.body, users=2, hands=1).items()
    }
    hand.show(shown)
    assert shown["hands"] == 1
    assert HAND_MODES[int(shown["mode"][0])] == ("hold" if axes == 1 else "ball")
    assert (shown["node"][0] >= 0) == (axes == 1)
    assert (shown["radius"][0] > 0.0) == (axes == 3)
    drawn = shown["target"][0] - shown["place"][0]
    led_by = np.array(link.place) - place
    assert drawn[:axes] == pytest.approx(led_by[:axes], abs=2e-4)
    assert float(shown["force"][0] @ drawn) > 0.0


def test_a_hand_without_its_device_does_nothing():
    session = SessionFile.from_toml(BLOCK, source="a test")
    replica = Replica.build(session)
    hand = DeviceHand(Seat.of(session, replica, 1, replica.model(1)), link=None)
    hand.before(5e-3, 5e-3)
    hand.after()
    assert hand.tools is not None
    assert not hand.tools.drive_stiffness.any()


@pytest.mark.slow
def test_a_device_takes_part_and_its_death_leaves_the_others_alone(tmp_path: Path):
    """Ann has a device, Ben none; Ann's servo is killed, and both go on; Ann's recording holds."""
    session = SessionFile.from_toml(BLOCK, source="a test")
    record = tmp_path / "ann.mcap"
    desk = Desk(BoardFolder(tmp_path), session, ["Ann"])
    with open_host(session) as opened:
        options = ["--name", "Ann", "--headless", "--device", "simulated:cartesian", "--record", str(record)]
        options += ["--boards", str(tmp_path)]
        members = {
            "Ann": MemberProcess(opened.invitation, options, as_json=True),
            "Ben": MemberProcess(opened.invitation, ["--name", "Ben", "--headless", "--device", "none"], as_json=True),
        }

        def status(name: str):
            seen = [member for member in opened.host.watch.members.values() if member.entry.name == name]
            return seen[0].status if seen else None

        def until(done, what: str) -> None:
            end = time.monotonic() + 200.0
            while not done():
                assert time.monotonic() < end, (what, [member.complaint() for member in members.values()])
                assert all(member.running for member in members.values())
                opened.service(time.monotonic())
                time.sleep(0.02)

        try:
            until(lambda: all((s := status(n)) is not None and s.steps for n in members), "both move")
            until(lambda: (s := status("Ann")) is not None and s.force > 0.1, "Ann pushes")
            until(lambda: (s := status("Ben")) is not None and any(abs(x) > 1e-5 for x in s.position), "Ben feels it")
            hand = desk.views()[0].hands[0]  # as its page draws it
            assert hand.mode == "ball"
            assert np.linalg.norm(hand.target - hand.place) > 0.0
            assert hand.radius > 0.0
            children = psutil.Process(members["Ann"].pid).children(recursive=True)
            servo = next(child for child in children if child.cmdline()[2].startswith("from cotouch.haptics._servo"))
            os.kill(servo.pid, signal.SIGKILL)
            steps = {name: status(name).steps for name in members}
            until(lambda: all(status(name).steps > steps[name] + 100 for name in members), "both go on")
            opened.host.end()
            end = time.monotonic() + 30.0
            while time.monotonic() < end and any(member.running for member in members.values()):
                opened.service(time.monotonic())
                time.sleep(0.02)
            ann = members["Ann"].result()
            assert ann is not None
            assert any("the device's servo" in text for text in ann["device"]["said"]), ann["device"]
            assert ann["status"]["residual"] < 1e-9
            assert not [child for child in children if child.is_running() and child.status() != psutil.STATUS_ZOMBIE]
        finally:
            for member in members.values():
                member.close()
            desk.close()
    assert audit([read_recording(record)]).holds
