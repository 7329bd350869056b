"""A copy with a hand that can be told, and nothing else."""

from dataclasses import dataclass, field

import numpy as np

from cotouch.hands import CommandedHand
from cotouch.mechanics import model
from cotouch.members import Slot
from cotouch.observers import HandCommand, HandMode
from cotouch.peer import Peer, StepReport
from cotouch.scenario import Scenario

T = 0.002
BODIES: dict[str, str] = {
    "point": "[body]\nmass = 0.5\ndamping = 1.0\nstiffness = 20.0",
    "plane": '[body]\nkind = "lattice"\nshape = [4, 3]\nspacing = 0.05\nmass = 0.5\nstiffness = 80\ndamping = 1\n'
    'ground = "x-"\nground_stiffness = 80.0',
    "modal": '[body]\nkind = "lattice"\nshape = [4, 3]\nspacing = 0.05\nmass = 0.5\nstiffness = 80\ndamping = 1\n'
    'ground = "all"\nground_stiffness = 20.0\n[solver]\nbasis = "modal"',
    "solid": '[body]\nkind = "lattice"\nshape = [4, 3, 3]\nspacing = 0.03\nmass = 0.5\nstiffness = 80\ndamping = 1\n'
    'ground = "x-"\nground_stiffness = 80.0',
}


def scenario(body: str, hands: str = "") -> Scenario:
    network = "[network]\nusers = ['A']\nspring = [[0]]\ndelay = [[0]]"
    text = f"{network}\n{BODIES.get(body, body)}\n[steps]\nrate = 500\n{hands}"
    return Scenario.from_toml(text).placed()


@dataclass
class Held:
    """One copy that is moved step by step."""

    scenario: Scenario
    queue: list[HandCommand] = field(default_factory=list)
    supplied: float = 0.0
    forces: list[np.ndarray] = field(default_factory=list)
    worst: float = 0.0
    play: float = 1e-9

    def __post_init__(self) -> None:
        self.body = self.scenario.build_body()
        self.model = model(self.body, basis=self.scenario.solver.basis)
        self.hand = CommandedHand(
            Slot(scenario=self.scenario, body=self.body, model=self.model, index=0, period=T, longest=0.05),
            requests=lambda: self.queue.pop(0) if self.queue else None,
        )
        still = np.zeros((self.body.nodes, self.body.dimension))
        self.peer = Peer(
            index=0,
            model=self.model,
            links={},
            strength=[],
            weight=[],
            local_damping=np.zeros(1),
            extra_damping=np.zeros(1),
            ports=self.hand.ports,
            position=still,
            velocity=still,
            surface=self.hand.surface,
            tools=self.hand.tools,
            contact=self.hand.contact,
        )
        self.hand.attach(self.peer.state.position)
        self.now = 0.0

    def tell(
        self,
        mode: HandMode,
        node: int = -1,
        target=(0.0, 0.0, 0.0),
        pointer: int = 0,
        *,
        start=None,
        edge=(0.0, 0.0, 0.0),
        **more: float,
    ) -> None:
        request = HandCommand(
            number=1,
            pointer=pointer,
            mode=mode,
            node=node,
            target=tuple(map(float, target)),
            start=tuple(map(float, target if start is None else start)),
            edge=tuple(map(float, edge)),
            **more,
        )
        self.queue.append(request)

    def run(self, seconds: float, length: float = T) -> StepReport:
        report = None
        for _ in range(round(seconds / length)):
            self.now += length
            self.hand.before(self.now, length)
            report = self.peer.step(self.now, length)
            self.hand.after()
            energy = report.kinetic + report.elastic + report.proxy + report.touch_stored
            self.supplied += report.supplied + report.drive_work
            self.play = max(self.play, energy, abs(self.supplied))
            self.worst = max(self.worst, abs(report.residual) / self.play)
            self.forces.append(self.force())
        assert report is not None
        return report

    def force(self) -> np.ndarray:
        """Of all ports and proxies on the copy, by axis."""
        ports, axes = self.hand.ports.force, self.body.dimension
        total = ports[:, :axes].sum(axis=0) if not self.model.full else ports[:, 0].reshape(-1, axes).sum(axis=0)
        tools = self.hand.tools
        return total if tools is None else total - tools.touch_force[:, :axes].sum(axis=0)

    def positions(self) -> np.ndarray:
        return self.model.to_nodes(self.peer.state.position)

    def moved(self, node: int) -> np.ndarray:
        return self.positions()[node]

    def jerk(self) -> float:
        """Greatest change of the force from one step to the next [N]."""
        return float(np.linalg.norm(np.diff(np.array(self.forces), axis=0), axis=1).max())
