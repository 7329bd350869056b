"""A rigid tool in a device that renders torques: it follows, the hand feels what turns it, and no joule is made."""

import numpy as np
import pytest
from tests.hands.felt import Felt
from tests.hands.led import Led
from tests.hands.test_device_hand import RIGID, TOOL, angle, peer_of

from cotouch.coupling import END
from cotouch.haptics import ARM, Cause, CouplingChoice, Twist
from cotouch.members import SessionFile, SharedModel

T = 2e-3
SESSION = SessionFile.from_toml(RIGID, source="a test")
REPLICA = SharedModel.build(SESSION)
# The tool is held at one end, and its other one is above the block.
LEVER = RIGID.replace("at = [0.0,", "handle = [0.04, 0.0, 0.0]\nat = [0.03,").replace("[0.1,", "[0.08,")


class Turned:
    """A copy with a rigid tool in a device."""

    def __init__(self, link: Felt, text: str = RIGID) -> None:
        self.link = link
        session = SESSION if text == RIGID else SessionFile.from_toml(text, source="a test")
        self.hand, self.peer = peer_of(session, REPLICA if text == RIGID else SharedModel.build(session), link)  # type: ignore[arg-type]
        self.steps, self.work, self.residual, self.excess = 0, 0.0, 0.0, -np.inf

    @property
    def turning(self) -> float:
        """What the coupling has done to the copy where it turned it [J]."""
        (work,) = self.hand.work
        assert work.turning is not None
        return work.turning

    def run(self, seconds: float) -> None:
        ports = self.hand.ports
        turns = np.abs(ports.shape.sum(axis=1)) < 1e-9
        for _ in range(round(seconds / T)):
            self.steps += 1
            self.link.tick()
            self.link.tick()
            self.hand.before(T * self.steps, T)
            before = self.peer.state.position.copy()
            self.residual = max(self.residual, abs(float(self.peer.step(T * self.steps, T).residual)))
            self.hand.after()
            moved = ports.shape[turns] @ (self.peer.state.position - before)
            self.work += float((ports.force[turns] * moved).sum())
            end, wrist = self.link.core.turning, self.link.device.wrist
            if end is not None:
                most = 2.0 * end.end.options.initial_energy + end.seen.bound
                self.excess = max(self.excess, wrist.work + self.turning - most)


def test_a_tool_follows_and_what_turns_it_is_the_couplings():
    """By the copy's own ledger, to rounding; by almost half a turn."""
    run = Turned(Felt(turn=3.0))
    run.run(0.5)
    assert run.work > 1e-5
    # The motors' work by measured orientations is what they really did; so the observer has it, and the account.
    turning, did = run.link.core.turning, run.link.device.wrist.work
    assert did < -1e-3
    assert turning.seen.work == pytest.approx(did, rel=1e-9)
    assert turning.end.number(END.work) == pytest.approx(did, rel=1e-9)
    assert run.turning == pytest.approx(run.work, rel=1e-12, abs=1e-15)
    assert run.residual < 1e-12
    run.run(0.5)
    assert not run.link.reports[-1].causes
    assert run.excess <= 1e-12
    assert angle(run.peer) == pytest.approx(3.0, abs=0.02)


def test_a_lever_on_an_obstacle_is_felt_as_torque():
    """Held at one end and pressed on the block with the other: the hand feels what turns it, force times lever."""
    run = Turned(Felt(sweep=1.0), LEVER)
    run.run(0.6)
    report = run.link.reports[-1]
    force, torque = np.array(report.force), np.array(report.torque)
    assert force[2] > 0.1
    # The block's edge is 30 mm from the handle, its middle 70 mm: upwards there turns the tool about y, our left.
    assert 0.03 < torque[1] / force[2] < 0.07
    assert np.abs(torque[[0, 2]]).max() < 0.2 * torque[1]
    # What is rendered is what turns the tool, but for what moves.
    ports, arms = run.hand.ports, slice(1, 5)
    ways = ports.shape[arms] @ (run.peer.model.body.rest + run.peer.state.position[:, :3])
    turns = np.cross(ways, ports.force[arms, :3]).sum(axis=0)
    assert -turns[1] == pytest.approx(torque[1], rel=0.5)
    assert run.residual < 1e-12


def test_it_is_as_stiff_about_every_axis_and_pushed_by_what_it_is_told():
    hand, peer = peer_of(SESSION, REPLICA, Felt())
    tool, ports, arms = hand._holds[0].grasped, hand.ports, slice(1, 5)
    rng = np.random.default_rng(5)
    for _ in range(20):
        axis = rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        angle, push = rng.uniform(0.0, 1.5), rng.normal(size=3)
        tool.twist(Twist(0.7, 0.0, tuple(angle * axis), tuple(push)))
        ways = ports.shape[arms] @ (peer.model.body.rest + peer.state.position[:, :3])
        pulls = ports.stiffness[arms, None] * (ports.end[arms, :3] - ports.shape[arms] @ peer.state.position[:, :3])
        torque, pushed = (np.cross(ways, one).sum(axis=0) for one in (pulls, ports.push[arms, :3]))
        assert torque == pytest.approx(0.7 * np.sin(angle) * axis, abs=1e-12)
        assert pushed == pytest.approx(push, abs=1e-12)
        # No more energy than the account takes it for, and no force on the handle.
        assert 0.5 * (pulls**2).sum() / ports.stiffness[1] <= 0.5 * 0.7 * angle**2 + 1e-15
        assert pulls.sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-12)


@pytest.mark.parametrize("seed", range(6))
def test_turning_is_passive_whatever_mailboxes_and_hands_do(seed: int):
    rng = np.random.default_rng(seed)
    said = CouplingChoice(
        turning_stiffness=float(rng.choice([0.1, 0.5, 1.0])), turning_damping=float(rng.choice([3e-3, 0.01, 0.05]))
    )
    link = Felt(
        turn=float(rng.uniform(0.0, 3.0)),
        hand=bool(rng.random() < 0.7),
        said=said,
        late=int(rng.integers(0, 20)),
        loss=float(rng.uniform(0.0, 0.6)),
        seed=seed,
    )
    run = Turned(link)
    link.device.wrist.spin = tuple(rng.uniform(-8.0, 8.0, 3).tolist())  # flung
    run.run(0.4)
    assert run.excess <= 1e-9
    assert max(report.excess for report in link.reports) <= 0.0
    assert run.residual < 1e-12
    assert not any(report.causes & (Cause.FAULT | Cause.ACTIVE) for report in link.reports)
    assert max(np.linalg.norm(report.torque) for report in link.reports) <= 0.1 * (1 + 1e-12)
    # About changing axes, too, what is booked is what the motors did, but for what a tick may hide.
    turning = link.core.turning
    assert link.device.wrist.work == pytest.approx(turning.seen.work, rel=1e-3, abs=1e-6)


def test_the_sessions_file_may_say_how_stiff_turning_is():
    """For devices that render torques; what its holder says goes first, whatever the law of places."""
    text = RIGID + "[[session.devices]]\nturning_stiffness = 0.3\nturning_damping = 0.004\ncoupling = 'pspm'\n"
    session = SessionFile.from_toml(text, source="a test")
    link = Felt(said=CouplingChoice(turning_damping=0.006))
    peer_of(session, REPLICA, link)  # type: ignore[arg-type]
    assert link.turning is not None
    assert (ARM**2 * link.turning.stiffness, ARM**2 * link.turning.damping) == pytest.approx((0.3, 0.006))
    plain = Led()  # which renders none, and is not concerned
    peer_of(session, REPLICA, plain)
    other = CouplingChoice(law="virtual").over(CouplingChoice(law="pspm", stiffness=3.0, turning_stiffness=0.3))
    assert (other.stiffness, other.turning_stiffness) == (None, 0.3)


def test_a_ball_is_not_turned_and_feels_no_torque():
    link = Felt()
    session = SessionFile.from_toml(TOOL, source="a test")
    replica = SharedModel.build(session)
    hand, peer = peer_of(session, replica, link)  # type: ignore[arg-type]
    for k in range(1, 50):
        link.tick()
        hand.before(T * k, T)
        peer.step(T * k, T)
        hand.after()
    assert link.core.turning is None
    assert not any(any(report.torque) for report in link.reports)


def test_a_device_without_torque_turns_a_tool_by_the_files_springs():
    hand, _ = peer_of(SESSION, REPLICA, Led(orientation=(0.0, 0.0, 0.0, 1.0)))
    assert [work.turning for work in hand.work] == [None]
    hand.before(T, T)
    assert hand.ports.stiffness[1] == pytest.approx(0.25 * 300)
