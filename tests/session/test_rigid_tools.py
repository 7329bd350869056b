"""Tools that are rigid bodies, live: by the file and by command, beside what is rigid and what yields, and an audit."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.hands.felt import Felt
from tests.hands.led import Led
from tests.session.test_demo_session_api import QuietHost
from tests.session.world import World

from cotouch.errors import SessionError
from cotouch.hands import DeviceHand
from cotouch.members import SessionFile, SharedModel
from cotouch.observers import MailboxFolder, MoveHand, Pointer, mailbox_folder
from cotouch.recording import audit, read_recording
from cotouch.session import DemoSessionApi

TOOL = """
[[tools]]
user = 1
kind = "box"
resolution = 1
size = {size}
mass = 0.05
at = {at}
[tools.hand]
path = {path}
stiffness = 300
damping = 6
turning_stiffness = 2
"""
PUSH = "[[0, 0, 0, 0, 0, 0, 0], [0.2, 0, 0, 0, 0, 0, 0], [0.8, 0, 0.03, 0, 0, 0, 0.5], [9, 0, 0.03, 0, 0, 0, 0.5]]"
RIGID = f"""
[session]
users = 3
spring = 30.0
wait_for_peers = 1.0
[body]
kind = "box"
size = [0.08, 0.05, 0.03]
resolution = 1
mass = 0.2
centre = [0, 0, 0.015]
[between]
damping = 20.0
[world]
gravity = [0, 0, -9.81]
[[world.planes]]
friction = 0.2
damping = 20.0
[steps]
rate = 250
[synchronisation]
law = "spring"
[[hands]]
user = 2
at = [0.04, 0, 0.015]
stiffness = 20
damping = 1
path = [[0, 0, 0, 0], [9, 0, 0, 0]]
{TOOL.format(size="[0.1, 0.02, 0.02]", at="[0.03, -0.0365, 0.015]", path=PUSH)}"""
SOFT = f"""
[session]
users = 2
spring = 30.0
[body]
kind = "lattice"
shape = [4, 4, 3]
spacing = 0.01
model = "cells"
mass = 0.3
stiffness = 200.0
damping = 0.4
ground = "z-"
ground_stiffness = 1e4
[between]
friction = 0.8
damping = 20.0
[steps]
rate = 250
[synchronisation]
law = "spring"
{TOOL.format(size="[0.05, 0.05, 0.02]", at="[0.015, 0.015, 0.0305]", path="[0, 0, 0]")}"""


def heading(world: World, position: np.ndarray) -> float:
    """How a box of four masses is turned about z [degrees]."""
    place = world.replica.body.rest[:4] + position[:4]
    edge = place[0] - place[2] + place[1] - place[3]
    return float(np.degrees(np.arctan2(edge[1], edge[0])))


@pytest.fixture(scope="module")
def turned(tmp_path_factory: pytest.TempPathFactory) -> World:
    world = World(RIGID, folder=tmp_path_factory.mktemp("turned"), tick=2e-3)
    ann, _ = (world.join(name) for name in ("Ann", "Ben"))
    world.until(world.all_coupled, 12.0)
    cleo = world.join("Cleo", moves=False)
    world.until(lambda: len(ann.states()) == 2 and world.all_coupled(), 12.0)
    world.run(0.6)
    world.leave(cleo)
    world.run(0.2)
    for person in (*world.people, *world.gone):
        assert person.session_recorder is not None
        person.session_recorder.close()
    return world


def test_it_turns_everybodys_block_and_is_in_its_users_copy_alone(turned: World) -> None:
    turned.check()
    ann, ben = turned.people
    assert heading(turned, ann.position) > 10.0
    assert heading(turned, ben.position) > 0.5 * heading(turned, ann.position)
    assert np.abs(ben.position[4:]).max() < 1e-9
    assert np.abs(ann.position[4:]).max() > 0.01
    peer = ann.copy.peer
    assert peer is not None
    assert peer.ports.force[:, 1].sum() > 0.1  # it pushes
    for person in turned.people:
        assert person.copy.totals.residual <= 1e-12
        (link,) = person.copy.status(turned.now).links
        apart = np.linalg.norm(ann.position - ben.position, axis=1)
        assert (
            apart[4:].max() > 1.5 * apart[:4].max()
        )  # the tool is where it is not in Ben's copy, which is no difference
        assert link.difference == pytest.approx(apart[:4].max(), rel=0.1)


def test_an_audit_works_out_anew_what_it_did(turned: World) -> None:
    found = [read_recording(path) for path in turned.recordings]
    result = audit(found)
    assert result.holds, result.verdict
    for ledger in result.users:
        assert ledger.worked_out == ledger.steps
    body = found[0].header.body.material
    assert body is not None
    assert [part.tool and part.tool.owner for part in body.body.parts] == [None, 0]
    ann = found[0]
    assert [len(setup.ports or ()) for setup in ann.setups][-1] == 4
    bent = {**ann.columns, "force": ann.columns["force"] * 1.001}  # what holds the tool is worked out, too
    assert not audit([replace(ann, columns=bent), *found[1:]]).holds


def test_a_device_leads_one_and_an_audit_works_out_what_that_did(tmp_path: Path) -> None:
    """Ann pushes the block with the tool in her device and turns it; Ben's device has a ball that presses on it."""
    world = World(RIGID, folder=tmp_path, tick=2e-3)
    pushes, presses = Led(orientation=(0.0, 0.0, 0.0, 1.0)), Led()
    world.devices |= {"Ann": pushes, "Ben": presses}  # type: ignore[dict-item]
    ann, _ = (world.join(name) for name in ("Ann", "Ben"))
    world.until(world.all_coupled, 12.0)
    world.run(0.6)  # nobody waits for Cleo any longer, and balls touch
    start = pushes.place.copy()
    for k in range(1, 51):
        half = 0.005 * k
        pushes.place = start + np.array([0.0, 0.0006 * k, 0.0])
        pushes.orientation = (0.0, 0.0, float(np.sin(half)), float(np.cos(half)))
        presses.place[2] -= 0.0002
        world.run(0.01)
    world.run(0.2)
    world.check()
    assert heading(world, ann.position) > 10.0
    assert presses.orders[-1][0][2] > presses.place[2] + 1e-3  # Ben feels it
    tool = world.replica.body.rest[4:] + ann.position[4:]
    assert tool.mean(axis=0) == pytest.approx([0.03, -0.0365 + 0.03, 0.015], abs=5e-3)
    for person in world.people:
        assert person.copy.totals.residual <= 1e-12
        assert person.session_recorder is not None
        person.session_recorder.close()
    found = [read_recording(path) for path in world.recordings]
    result = audit(found)
    assert result.holds, result.verdict
    assert all(ledger.worked_out == ledger.steps for ledger in result.users)
    assert [len(setup.ports or ()) for setup in found[0].setups][-1] == 5
    for port in (0, 1):  # what leads the handle is worked out, and what turns
        force = found[0].columns["force"].copy()
        force[:, port] *= 1.01
        assert not audit([replace(found[0], columns={**found[0].columns, "force": force}), found[1]]).holds


def test_what_turns_a_tool_is_the_couplings_with_a_device_that_renders_torques(tmp_path: Path) -> None:
    """Recordings hold its work to rounding, and an audit works it out."""
    world = World(RIGID, folder=tmp_path, tick=2e-3)
    world.devices |= {"Ann": (turns := Felt(turn=2.0, own=2)), "Ben": Led()}  # type: ignore[dict-item]
    ann, _ = (world.join(name) for name in ("Ann", "Ben"))
    world.until(world.all_coupled, 12.0)
    world.run(0.3)
    world.check()
    assert turns.core.turning is not None
    assert turns.device.wrist is not None
    assert isinstance(ann.hand, DeviceHand)
    (work,) = ann.hand.work
    assert work.turning is not None
    for person in world.people:
        assert person.copy.totals.residual <= 1e-12
        assert person.session_recorder is not None
        person.session_recorder.close()
    found = [read_recording(path) for path in world.recordings]
    assert audit(found).holds
    ours = found[0].columns
    assert work.turning > 1e-3
    assert ours["supplied"].sum() == pytest.approx(work.place + work.turning, rel=1e-12)
    force = ours["force"].copy()
    force[:, 1] *= 1.01
    assert not audit([replace(found[0], columns={**ours, "force": force}), found[1]]).holds


@pytest.fixture
def soft(tmp_path: Path) -> World:
    (tmp_path / "recordings").mkdir()
    world = World(SOFT, tick=2e-3, mailboxes=MailboxFolder(tmp_path))
    for name in world.session.scenario.network.users:
        world.join(name)
    world.until(world.all_coupled, 12.0)
    return world


def test_it_is_led_to_a_pose_by_command_and_goes_back_to_its_file(soft: World) -> None:
    """Pressed on a block that yields and turned: its hand is shown, both copies follow, nothing jerks."""
    assert soft.commands is not None
    ann = soft.people[0]
    top = np.array([0.015, 0.015, 0.0305])
    soft.commands.hand("user 1", "pose", to=(0.015, 0.015, 0.0275), turn=(0.0, 0.0, 0.3))
    most = 0.0
    for _ in range(50):
        soft.run(0.02)
        peer = ann.copy.peer
        assert peer is not None
        most = max(most, float(np.abs(peer.ports.force[:4].sum(axis=0)).max()))
    shown = soft.commands.views()[0].hands[0]
    assert shown.mode == "pose"
    assert shown.target == pytest.approx([0.015, 0.015, 0.0275], abs=5e-5)
    assert 0.0005 < top[2] - shown.place[2] < 0.003
    assert shown.force[2] == pytest.approx(300 * (0.0275 - shown.place[2]), rel=0.02)
    assert most < 3.0 * abs(shown.force[2])
    count = soft.replica.body.shared
    corners = [person.position[2] - person.position[count - 1] for person in soft.people]  # of the top, across
    assert corners[0][0] > 2e-4  # turned along
    assert corners[1][0] > 0.2 * corners[0][0]
    soft.commands.hand("user 1", "script")
    soft.run(2.0)
    masses = ann.position[count:] + soft.replica.body.rest[count:]
    assert masses.mean(axis=0) == pytest.approx(top, abs=1e-4)
    assert soft.commands.views()[0].hands[0].mode == "script"
    soft.check()
    assert all(person.copy.totals.residual <= 1e-12 for person in soft.people)


def test_a_pointer_leads_it_until_nothing_is_heard_of_that(soft: World) -> None:
    assert soft.commands is not None
    ann = soft.people[0]
    count = soft.replica.body.shared

    def turned() -> float:
        rest, place = soft.replica.body.rest[count:], soft.replica.body.rest[count:] + ann.position[count:]
        edge, before = (x[0] - x[2] + x[1] - x[3] for x in (place, rest))
        return float(np.arctan2(edge[1], edge[0]) - np.arctan2(before[1], before[0]))

    pointer = Pointer(number=7, mode="pose", node=0, target=(0.015, 0.015, 0.05), turn=(0.0, 0.0, 0.5))
    soft.commands.point("user 1", pointer)
    soft.run(0.5)
    shown = soft.commands.views()[0]
    assert shown.received == 7
    assert shown.hands[0].mode == "pose"
    assert shown.hands[0].place == pytest.approx([0.015, 0.015, 0.05], abs=1e-3)  # sooner than by command
    assert turned() == pytest.approx(0.5, abs=0.01)
    soft.run(0.8)
    assert soft.commands.views()[0].hands[0].mode == "free"
    soft.check()
    assert all(person.copy.totals.residual <= 1e-12 for person in soft.people)


def test_let_go_it_comes_to_rest_and_is_held_by_nothing(soft: World) -> None:
    assert soft.commands is not None
    ann = soft.people[0]
    soft.commands.hand("user 1", "pose", to=(0.015, 0.015, 0.2), turn=(0.0, 0.0, 0.0))
    soft.run(0.4)
    soft.commands.hand("user 1", "free")
    soft.run(1.0)
    before = ann.position[-1, 2]
    soft.run(0.2)
    peer = ann.copy.peer
    assert peer is not None
    assert ann.position[-1, 2] == pytest.approx(before, abs=1e-6)  # it came to rest
    assert 0.01 < before < 0.15
    assert np.abs(peer.ports.force).max() < 1e-4
    soft.commands.hand("user 1", "pose", node=1, to=(0.0, 0.0, 0.0))  # there is no second tool
    soft.run(0.1)
    assert soft.commands.views()[0].hands[0].mode == "free"
    assert np.abs(peer.ports.force).max() < 1e-4


@pytest.fixture
def api() -> Iterator[DemoSessionApi]:
    session = SessionFile.from_toml(SOFT)
    opened: Any = QuietHost()
    with mailbox_folder() as mailboxes:
        made = DemoSessionApi(session, opened, SharedModel.build(session), mailboxes)
        yield made
        made.close()


def test_what_there_is_not_is_one_sentence(api: DemoSessionApi) -> None:
    place, turn = (0.0, 0.0, 0.1), (0.0, 0.0, 0.5)
    api.do(MoveHand(slot=0, mode="pose", to=place, turn=turn))
    with pytest.raises(SessionError, match="this user has no rigid tool with a hand"):
        api.do(MoveHand(slot=1, mode="pose", to=place, turn=turn))
    with pytest.raises(SessionError, match="with pose it must be from 0 to 0"):
        api.do(MoveHand(slot=0, mode="pose", node=1, to=place, turn=turn))
    api.point(0, Pointer(number=1, mode="ball", node=0, target=place))
    pose = Pointer(number=1, mode="pose", node=0, target=place, turn=turn)
    api.point(0, pose)
    with pytest.raises(SessionError, match="this user has no rigid tool with a hand"):
        api.point(1, pose)
    with pytest.raises(SessionError, match=r"the pointer's turn is .*; it must be 3 numbers, each at most 4 rad"):
        api.point(0, replace(pose, turn=(0.0, 5.0, 0.0)))
    with pytest.raises(SessionError, match="it must be from 0 to 47"):
        api.point(0, Pointer(number=1, mode="grab", node=48, target=place))
