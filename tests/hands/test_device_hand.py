"""A device as the hand of a slot: with a tool of the file, one that fits the body, or a node that it holds.

Alone or one in each hand, at the body's scale or another.
"""

import os
import signal
import time
from pathlib import Path

import numpy as np
import psutil
import pytest
from scipy.spatial.transform import Rotation
from tests.hands.led import Led

from cotouch.errors import DeviceError, SessionError
from cotouch.hands import DeviceHand
from cotouch.haptics import CouplingChoice
from cotouch.members import SessionFile, SharedModel, Slot
from cotouch.observers import HAND_MODES, CommandClient, MailboxFolder, view_fields
from cotouch.peer import Peer
from cotouch.recording import audit, read_recording
from cotouch.session import MemberProcess, open_host

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
RIGID = """
[session]
users = 2
[body]
kind = "box"
size = [0.08, 0.05, 0.03]
resolution = 1
mass = 0.2
[between]
damping = 20.0
[steps]
rate = 500
[[tools]]
user = 1
kind = "box"
resolution = 1
size = [0.1, 0.02, 0.02]
mass = 0.05
at = [0.0, 0.0, 0.0405]
[tools.hand]
stiffness = 300
damping = 6
turning_stiffness = 2
"""


def peer_of(session: SessionFile, replica: SharedModel, *links: Led) -> tuple[DeviceHand, Peer]:
    """The first copy, and what devices do to it."""
    model = replica.model(1)
    hand = DeviceHand(Slot.of(session, replica, 0, model), link=links)  # type: ignore[arg-type]
    shape = (replica.body.nodes, replica.body.dimension)
    peer = Peer(
        index=0,
        model=model,
        links={},
        strength=[],
        weight=[],
        local_damping=np.zeros(1),
        extra_damping=np.full(1, 1.0),
        ports=hand.ports,
        position=np.zeros(shape),
        velocity=np.zeros(shape),
        surface=hand.surface,
        tools=hand.tools,
        contact=hand.contact,
    )
    hand.attach(peer.state.position)
    return hand, peer


def led(text: str, towards: list[float], *links: Led) -> tuple[DeviceHand, Peer, Led, float]:
    """Three hundred steps of one copy while devices go somewhere; the most that any leaves unexplained [J]."""
    session = SessionFile.from_toml(text, source="a test")
    links = links or (Led(),)
    link = links[0]
    hand, peer = peer_of(session, SharedModel.build(session), *links)
    start, residual, did = link.place.copy(), 0.0, 0.0
    for k in range(1, 301):
        for one in links:
            one.place = start + min(1.0, k / 100) * np.array(towards)
        hand.before(5e-3 * k, 5e-3)
        before = peer.state.position.copy()
        report = peer.step(5e-3 * k, 5e-3)
        hand.after()
        residual = max(residual, abs(float(report.residual)))
        did += report.supplied + report.drive_work
        if peer.model.body.tools:  # what turns is the hand's
            turns = np.abs(hand.ports.shape.sum(axis=1)) < 1e-9
            moved = hand.ports.shape[turns] @ (peer.state.position - before)
            did -= float((hand.ports.force[turns] * moved).sum())
    # Both ledgers of the proxies' ports are the same: the body's, and the devices', in their own metres and newtons.
    booked = sum(work.place for work in hand.work)
    assert booked == pytest.approx(did, rel=1e-9, abs=1e-12)
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
    assert word.tank >= 0.0
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


@pytest.mark.parametrize("scale", [0.25, 4.0, "fit"])
@pytest.mark.parametrize("text", [POINT, TOOL], ids=["node", "tool"])
def test_with_a_scale_the_body_moves_farther_and_the_device_feels_more(text: str, scale: float | str):
    """Power is the same at both ends: metres by s, newtons by 1/s; energy, and where it settles, go with that."""
    said = f"\n[[session.devices]]\nscale = {scale!r}\n".replace("'", '"')
    # Away from the tool's body, so that the proxy is free to come where the device leads it.
    towards = [0.004, 0.0, 0.0]
    hand, peer, link, residual = led(text + said, towards)
    s = hand._holds[0]._scale
    assert s == scale or (scale == "fit" and 0.3 < s < 2.0)
    place = np.array(link.orders[-1][0]) - np.array([0.01, -0.02, 0.03]) - 0.01 * np.array(towards)  # heard first there
    tools = hand.tools
    moved = peer.model.to_nodes(peer.state.position)[0, 0] if tools is None else tools.place[0, 0] - 0.09
    assert moved == pytest.approx(s * place[0], rel=1e-9)
    # What pulls the proxy is 1/s of the device's spring.
    force = (hand.ports.force[0, 0] if tools is None else tools.drive_force[0, 0]) * s
    gap = link.place[0] - link.orders[-1][0][0]
    assert force == pytest.approx(500.0 * gap, rel=0.02, abs=2e-3)
    if tools is None:  # a spring of 20 N/m holds the point: it is s² times as stiff for the device
        assert place[0] == pytest.approx(0.99 * towards[0] * 500.0 / (500.0 + 20.0 * s * s), rel=0.02)
    assert residual < 1e-12


@pytest.mark.parametrize("text", [POINT, TOOL], ids=["node", "tool"])
def test_the_damper_pulls_towards_the_velocity_of_the_device_in_its_own_metres(text: str):
    session = SessionFile.from_toml(text, source="a test")
    replica = SharedModel.build(session)
    link = Led(said=CouplingChoice(scale=4.0, damping=3.0), rate=(0.02, 0.0, 0.0))
    hand = DeviceHand(Slot.of(session, replica, 0, replica.model(1)), link=[link])  # type: ignore[list-item]
    hand.before(5e-3, 5e-3)
    damping, push = (
        (hand.ports.damping[0], hand.ports.push[0, 0])
        if hand.tools is None
        else (hand.tools.drive_damping[0], hand.tools.push[0, 0])
    )
    assert damping == pytest.approx(3.0 / 16.0)
    assert push == pytest.approx(damping * 4.0 * 0.02)  # the body's velocity is four times the device's


def angle(peer: Peer) -> float:
    """By which the first rigid tool is turned about z [rad]."""
    first = peer.model.body.tools[0].first
    place = (peer.model.body.rest + peer.model.to_nodes(peer.state.position))[first : first + 4]
    edge = place[0] - place[2] + place[1] - place[3]
    return float(np.arctan2(edge[1], edge[0]))


def test_a_rigid_tool_is_led_by_its_handle_and_keeps_its_orientation():
    """Pressed on one end of the block, that is felt at the handle and does not turn it."""
    text = RIGID.replace("at = [0.0,", "handle = [0.04, 0.0, 0.0]\nat = [0.03,").replace("[0.1,", "[0.02,")
    hand, peer, link, residual = led(text, [0.0, 0.0, -0.02])
    assert residual < 1e-12
    assert hand.tools is None
    moved = peer.model.to_nodes(peer.state.position)
    assert moved[4:, 2] == pytest.approx(-0.0198, abs=1e-4)  # heard first on its way
    assert np.array(link.orders[-1][0]) == pytest.approx(link.place, abs=1e-4)
    assert moved[:4, 2].mean() < -1e-3
    assert np.ptp(moved[:4, 2]) > 1e-3  # the block tilts
    shown = {name: np.zeros(shape, kind) for name, (shape, kind) in view_fields(_body(text), users=2, hands=1).items()}
    hand.show(shown)
    assert HAND_MODES[int(shown["mode"][0])] == "pose"
    assert shown["place"][0] == pytest.approx([0.07, 0.0, 0.0405 - 0.0198], abs=1e-4)


def test_a_device_that_says_how_it_is_turned_turns_its_tool():
    """From where it was heard first, also by more than half a turn; one that falls silent leaves it as it is."""
    tilt = (0.6, 0.0, 0.0, 0.8)  # however the device is held when it is heard first
    link = Led(orientation=tilt)
    session = SessionFile.from_toml(RIGID, source="a test")
    replica = SharedModel.build(session)
    hand, peer = peer_of(session, replica, link)
    seen: list[float] = []
    for k in range(1, 401):
        half = 0.01 * min(k - 1, 200)
        upright = (0.0, 0.0, float(np.sin(half)), float(np.cos(half)))
        link.orientation = (
            None if k > 300 else tuple((Rotation.from_quat(upright) * Rotation.from_quat(tilt)).as_quat())
        )
        hand.before(2e-3 * k, 2e-3)
        residual = abs(float(peer.step(2e-3 * k, 2e-3).residual))
        hand.after()
        assert residual < 1e-12
        seen.append(angle(peer))
    turned = np.unwrap(seen)
    assert turned[299] == pytest.approx(4.0, abs=0.02)
    assert turned[-1] == pytest.approx(turned[299], abs=1e-3)
    assert np.abs(np.diff(turned)).max() < 0.03  # nothing leaps where a rotation vector would


def test_the_other_tools_of_a_slot_rest_and_who_has_none_gets_a_ball():
    other = RIGID.split("[[tools]]")[1].replace("0.0, 0.0, 0.0405", "0.0, 0.2, 0.0")
    hand, peer, _, residual = led(RIGID + "[[tools]]" + other, [0.0, 0.0, 0.02], Led(said=CouplingChoice(tool=2)))
    assert residual < 1e-12
    moved = peer.model.to_nodes(peer.state.position)
    assert moved[8:, 2] == pytest.approx(0.0198, abs=1e-4)
    assert np.abs(moved[4:8]).max() < 1e-9
    assert len(hand.nodes) == hand.ports.row.size == 10
    hand, peer, _, residual = led(RIGID.replace("user = 1", "user = 2"), [0.0, 0.0, 0.02])
    assert residual < 1e-12
    assert not hand.nodes
    assert hand.tools is not None
    # Above the block, where Ben's tool is not, though it is there in his copy.
    assert hand.tools.place[0, :3] == pytest.approx([0.0, 0.0, 0.0222 + 0.02], abs=2e-4)


def test_a_device_in_each_hand_moves_a_ball_and_a_rigid_tool():
    """By their numbers in the file, whichever kind comes first."""
    ball = "[[tools]]\nuser = 1\nat = [0.0, 0.0, 0.2]\nradius = 0.008\n"
    for text, rigid in ((RIGID + ball, 0), (RIGID.replace("[[tools]]", ball + "[[tools]]", 1), 1)):
        said = [CouplingChoice(), CouplingChoice()]
        said[rigid] = CouplingChoice(scale=2.0)
        hand, peer, _, residual = led(text, [0.0, 0.0, 0.01], *(Led(said=one) for one in said))
        assert residual < 1e-12
        assert hand.tools is not None
        assert hand.tools.place[0, 2] == pytest.approx(0.21, abs=2e-4)
        moved = peer.model.to_nodes(peer.state.position)
        assert moved[4:8, 2] == pytest.approx(0.02, abs=4e-4)
        assert len(hand.nodes) == hand.ports.row.size == 5


def test_a_device_in_each_hand_moves_a_tool_each():
    two = TOOL + "\n[[tools]]\nuser = 1\nat = [0.09, 0.06, 0.02]\nradius = 0.008\n"
    hand, _, _, residual = led(two, [0.0, 0.0, 0.01], Led(), Led(said=CouplingChoice(scale=2.0)))
    assert hand.tools is not None
    first, second = hand.tools.place[:2, :3]
    assert first == pytest.approx([0.09, 0.02, 0.03], abs=2e-4)
    assert second == pytest.approx([0.09, 0.06, 0.04], abs=4e-4)
    assert residual < 1e-12
    shown = {name: np.zeros(shape, kind) for name, (shape, kind) in view_fields(_body(two), users=2, hands=2).items()}
    hand.show(shown)
    assert shown["hands"] == 2
    assert shown["place"][1] == pytest.approx(second, abs=1e-6)
    # Asked for the other way round, the first device moves the second tool.
    hand, *_ = led(two, [0.0, 0.0, 0.01], Led(said=CouplingChoice(tool=2)))
    assert hand.tools is not None
    assert hand.tools.place[0, :3] == pytest.approx([0.09, 0.06, 0.03], abs=2e-4)
    # Without tools in the file there is a ball for each hand, side by side; with [[hands]] a node for each.
    hand, *_ = led(BLOCK, [0.0, 0.0, 0.0], Led(), Led())
    assert hand.tools is not None
    assert hand.tools.place[0, 1] - hand.tools.place[1, 1] > 2.0 * 0.0036
    held = POINT.replace("[body]", '[body]\nkind = "chain"\nnodes = 3\nspacing = 0.1')
    held += "".join(f"[[hands]]\nuser = 1\nnode = {node}\npath = [0.0]\n" for node in (1, 3))
    hand, peer, *_ = led(held, [0.01, 0.0, 0.0], Led(), Led(said=CouplingChoice(scale=2.0)))
    ends = peer.model.to_nodes(peer.state.position)[[0, 2], 0]
    assert hand.nodes == [0, 2]
    assert 1.3 < ends[1] / ends[0] < 2.2


@pytest.mark.parametrize(
    ("text", "links", "said"),
    [
        (TOOL, [{}, {}], "tool 2 of user 1, which has only one tool; give the session's file another"),
        (TOOL, [{"tool": 3}], "tool 3 of user 1, which has only one tool"),
        (POINT, [{}, {}], "what hand 2 of user 1 holds, which has 0; give the session's file another"),
        (BLOCK, [{"tool": 1}, {"tool": 1}], "two devices would move the same tool of user 1"),
        (POINT + '[[session.devices]]\ncoupling = "virtual"\n', [{}], "friction of Force Dimension omega.3 is 0"),
        (RIGID, [{"tool": 2}], "tool 2 of user 1, which has only one tool"),
        (
            RIGID.partition("[tools.hand]")[0],
            [{}],
            r"tool 1 of user 1, which has no \[tools.hand\] whose springs turn it",
        ),
    ],
)
def test_what_a_slot_has_not_is_refused_in_a_sentence(text: str, links: list[dict], said: str):
    with pytest.raises(DeviceError, match=said) as caught:
        led(text, [0.0, 0.0, 0.0], *[Led(said=CouplingChoice(**one)) for one in links])
    assert "\n" not in str(caught.value)


def test_the_files_tables_select_the_coupling_and_whoever_holds_the_device_goes_first():
    tables = """
[[session.devices]]
scale = 2.0
[[session.devices]]
user = 1
coupling = "virtual"
friction = 3.0
coulomb = 0.1
[[session.devices]]
user = 1
tool = 1
scale = "fit"
[[session.devices]]
user = 2
stiffness = 100.0
"""
    *_, link, _ = led(TOOL + tables, [0.0, 0.0, 0.0])
    assert link.below == CouplingChoice(law="virtual", friction=3.0, coulomb=0.1, scale="fit")
    # Another law takes none of the numbers that were meant for that one, but the scale.
    _, _, link, _ = led(TOOL + tables, [0.0, 0.0, 0.0], Led(said=CouplingChoice(law="pspm", stiffness=300.0)))
    assert link.below is not None
    assert link.said.over(link.below) == CouplingChoice(law="pspm", stiffness=300.0, scale="fit")
    # What the file says of the simulated device counts where nothing else is said.
    simulated = TOOL.replace("[tools.hand]", "[tools.device]\nstiffness = 321.0\n[tools.hand]")
    *_, link, _ = led(simulated, [0.0, 0.0, 0.0])
    assert link.below == CouplingChoice(law="pspm", stiffness=321.0)
    *_, link, _ = led(simulated + "[[session.devices]]\nstiffness = 123.0\n", [0.0, 0.0, 0.0])
    assert link.below is not None
    assert link.below.stiffness == 123.0


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ("user = 3", r"session.devices\[1\].user is 3; there are 2 users"),
        ("tool = 1", "tool is 1, but user is not given"),
        ("scale = 0", "scale"),
        ('scale = "big"', "scale"),
        ("friction = 1.0", "friction is given, but with coupling=pspm it has no effect"),
        ('coupling = "stiff"', "coupling"),
    ],
)
def test_a_wrong_table_is_a_sentence(table: str, said: str):
    with pytest.raises(SessionError, match=said) as caught:
        SessionFile.from_toml(POINT + f"[[session.devices]]\n{table}\n", source="a test")
    assert "\n" not in str(caught.value)


def _body(text: str):
    return SharedModel.build(SessionFile.from_toml(text, source="a test")).body


def test_a_hand_without_its_device_does_nothing():
    session = SessionFile.from_toml(BLOCK, source="a test")
    replica = SharedModel.build(session)
    hand = DeviceHand(Slot.of(session, replica, 1, replica.model(1)), link=None)
    hand.before(5e-3, 5e-3)
    hand.after()
    assert hand.tools is not None
    assert not hand.tools.drive_stiffness.any()


@pytest.mark.slow
def test_a_device_takes_part_and_its_death_leaves_the_others_alone(tmp_path: Path):
    """Ann has a device, Ben none; Ann's servo is killed, and both go on; Ann's recording holds."""
    session = SessionFile.from_toml(GRASP, source="a test")  # held: wherever the hand goes round, it pulls
    record = tmp_path / "ann.mcap"
    commands = CommandClient(MailboxFolder(tmp_path), session, ["Ann"])
    with open_host(session) as opened:
        options = ["--name", "Ann", "--headless", "--device", "simulated:cartesian", "--record", str(record)]
        options += ["--mailboxes", str(tmp_path)]
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
            hand = commands.views()[0].hands[0]  # as its page draws it
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
            commands.close()
    assert audit([read_recording(record)]).holds
