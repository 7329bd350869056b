"""A copy of a body that can be stepped from Python, and random ones.

Every test calls `step` through `Copy.step`, with arguments of the same types, so that each width is compiled once.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from hypothesis import strategies as st

from cotouch.body import Body
from cotouch.mechanics import (
    BODY_LOSS,
    CLOSURE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LEDGER_COLUMNS,
    LOCAL_LOSS,
    SUPPLIED,
    Basis,
    Links,
    Model,
    Ports,
    State,
    Workspace,
    closed_settle,
    model,
    own_ports,
    settle,
    step,
)

Array = np.ndarray


@dataclass
class Spring:
    """A spring to a neighbour: `strength * W_weight`, pulling towards `sample` (n, d)."""

    strength: float
    sample: Array
    weight: int = 0


@dataclass
class Port:
    """What holds a node: a spring-damper whose end moves from `start` to `end`, and a push; all (d,)."""

    node: int
    stiffness: float = 0.0
    damping: float = 0.0
    start: Array | float = 0.0
    end: Array | float = 0.0
    push: Array | float = 0.0


@dataclass
class Scene:
    """Everything that determines one step; fields are (n, d), positions relative to the rest shape."""

    body: Body
    position: Array
    velocity: Array
    copies: int = 1
    weights: Sequence[Array] = ()
    springs: list[Spring] = field(default_factory=list)
    ports: list[Port] = field(default_factory=list)
    local_damping: Array = field(default_factory=lambda: np.zeros(1))
    extra_damping: Array = field(default_factory=lambda: np.zeros(1))


class Copy:
    """One user's copy of a body: the arrays that `step` works on.

    With `others` > 0 the links and ports stand in larger arrays, between that many entries of other users on each side,
    whose numbers are NaN and must be neither read nor written.
    """

    def __init__(self, scene: Scene, *, basis: Basis = "nodal", others: int = 0) -> None:
        self.scene = scene
        self.model: Model = model(scene.body, copies=scene.copies, weights=scene.weights, basis=basis)
        op, width = self.model.operator, self.model.width
        rows = self.model.operator_rows
        self.state = State(
            position=self.model.to_rows(scene.position),
            velocity=self.model.to_rows(scene.velocity),
            momentum=np.zeros((rows, width)),
            tension=np.zeros((rows, width)),
            memory=np.zeros(self.model.memory),
        )
        springs = scene.springs
        count = len(springs)
        samples = np.full((count + 2, rows, width), np.nan)  # slots in reverse, then an unused one, then one for x̂
        for index, spring in enumerate(springs):
            samples[count - 1 - index] = self.model.to_rows(spring.sample)
        self.mean_slot = count + 1
        own = slice(others, others + count)
        self.links = Links(
            strength=_padded([spring.strength for spring in springs], others, np.nan)[own],
            weight=_padded([spring.weight for spring in springs], others, 0).astype(np.int32)[own],
            slot=_padded([count - 1 - index for index in range(count)], others, 0).astype(np.int64)[own],
            samples=samples,
        )
        entries = [
            (axis, row, port) for port in scene.ports for axis, row in enumerate(self.model.port_rows(port.node))
        ]
        self.port_of = [(port, axis) for axis, _, port in entries]
        shape = self.model.port_shapes(np.array([row for _, row, _ in entries], dtype=np.int32))
        if shape.shape[0]:
            shape = np.concatenate([np.full((others, rows), np.nan), shape, np.full((others, rows), np.nan)])
        total = len(entries) + 2 * others
        self.all_ports = Ports(
            row=_padded([row for _, row, _ in entries], others, 0).astype(np.int32),
            shape=np.ascontiguousarray(shape),
            stiffness=_padded([port.stiffness for _, _, port in entries], others, np.nan),
            damping=_padded([port.damping for _, _, port in entries], others, np.nan),
            start=np.full((total, width), np.nan),
            end=np.full((total, width), np.nan),
            push=np.full((total, width), np.nan),
            force=np.full((total, width), np.nan),
        )
        self.ports = own_ports(self.all_ports, others, others + len(entries))
        self.hold()
        weights = op.weight.shape[0]
        self.local_damping = _fit(scene.local_damping, weights)
        self.extra_damping = _fit(scene.extra_damping, weights)
        self.work: Workspace = self.model.workspace(len(entries))
        self.ledger = np.full(LEDGER_COLUMNS, np.nan)
        self.ledger[CLOSURE:] = 0.0  # a linear step leaves what only closed ones book
        self.all_link_work = np.full(count + 2 * others, np.nan)
        self.link_work = self.all_link_work[own]
        self.settle()

    def settle(self) -> None:
        op, force, lanes = self.model.operator, self.model.force, self.model.lanes
        if force is None:
            settle(op, self.state, self.ledger, lanes)
        else:
            closed_settle(op, force, self.state, self.work, self.ledger, lanes)

    def hold(self) -> None:
        """Writes start, end and push of the scene's ports into the arrays."""
        for index, (port, axis) in enumerate(self.port_of):
            for name in ("start", "end", "push"):
                value = np.broadcast_to(np.asarray(getattr(port, name), dtype=np.float64), self.scene.body.dimension)
                row = getattr(self.ports, name)[index]
                row[:] = 0.0
                if self.model.full:
                    row[0] = value[axis]
                else:
                    row[: value.size] = value

    def step(self, T: float, *, tolerance: float = 1e-15, cap: int = 10_000, keep_mean: bool = False) -> None:
        step(
            self.model.operator,
            self.state,
            self.links,
            self.ports,
            self.local_damping,
            self.extra_damping,
            float(T),
            self.mean_slot if keep_mean else -1,
            self.work,
            self.ledger,
            self.link_work,
            float(tolerance),
            int(cap),
            self.model.lanes,
        )

    @property
    def position(self) -> Array:
        return self.model.to_nodes(self.state.position)

    @property
    def velocity(self) -> Array:
        return self.model.to_nodes(self.state.velocity)

    @property
    def mean_position(self) -> Array:
        return self.model.to_nodes(self.links.samples[self.mean_slot])

    @property
    def forces(self) -> Array:
        """Mean force of every port of the scene, (ports, d)."""
        raw = self.ports.force
        d = self.scene.body.dimension
        return raw.reshape(-1, d) if self.model.full else raw[:, :d]

    @property
    def links_did(self) -> Array:
        """Work of every spring of the scene [J]."""
        return self.link_work

    @property
    def energy(self) -> float:
        return float(self.ledger[KINETIC] + self.ledger[ELASTIC])

    @property
    def iterations(self) -> int:
        return int(self.ledger[ITERATIONS])

    @property
    def gained(self) -> float:
        """What the ledger says that the last step must have added to the energy [J]."""
        ledger = self.ledger
        lost = ledger[BODY_LOSS] + ledger[LOCAL_LOSS] + ledger[EXTRA_LOSS]
        return float(ledger[SUPPLIED] + self.links_did.sum() - lost)

    @property
    def turned_over(self) -> float:
        """Sum of the sizes of all energies that the last step moved [J]."""
        ledger = self.ledger
        return float(np.abs(ledger[:ITERATIONS]).sum() + np.abs(self.links_did).sum())


def _padded(values: Sequence[Any], others: int, filler: float) -> Array:
    return np.array([filler] * others + list(values) + [filler] * others, dtype=np.float64)


def _fit(coefficients: Array, weights: int) -> Array:
    result = np.zeros(weights)
    result[: len(coefficients)] = coefficients
    return result


def semidefinite(rng: np.random.Generator, size: int, *, rank: int | None = None) -> Array:
    """A random symmetric positive semidefinite matrix with entries around 1."""
    half = rng.normal(size=(size, size if rank is None else rank))
    return half @ half.T / max(half.shape[1], 1)


def random_scene(
    seed: int,
    *,
    nodes: int,
    dimension: int,
    full: bool,
    copies: int = 1,
    coupled_mass: bool = True,
    weights: Sequence[str] = (),
    springs: int = 0,
    ports: int = 0,
    damped: bool = True,
) -> Scene:
    """A scene of random numbers; magnitudes of matrices differ by up to 10⁶.

    Args:
        seed: of the numbers.
        nodes: n.
        dimension: d.
        full: matrices are nd x nd rather than n x n.
        copies: N.
        coupled_mass: M has entries off its diagonal.
        weights: kind of each link weight: "node" (n x n), "axes" (d x d) or "full" (nd x nd).
        springs: number of links, with weights in turn.
        ports: number of ports: spring, damper, both, push alone, in turn.
        damped: the body, and the copy locally, have damping.
    """
    rng = np.random.default_rng(seed)
    size = nodes * dimension if full else nodes

    def scale() -> float:
        return float(10.0 ** rng.uniform(-3, 3))

    mass = semidefinite(rng, size) if coupled_mass else np.zeros((size, size))
    body = Body(
        mass=scale() * (mass + np.diag(rng.uniform(0.1, 1.0, size))),
        rest=rng.normal(size=(nodes, dimension)),
        damping_int=scale() * semidefinite(rng, size, rank=max(size - 1, 0)) * damped,
        damping_ext=scale() * np.diag(rng.integers(0, 2, size) * 1.0) * damped,
        stiffness_int=scale() * semidefinite(rng, size, rank=max(size - 1, 0)),
        stiffness_ext=scale() * np.diag(rng.integers(0, 2, size) * 1.0),
    )
    sizes = {"node": nodes, "axes": dimension, "full": nodes * dimension}
    matrices = [semidefinite(rng, sizes[kind]) + 0.2 * np.eye(sizes[kind]) for kind in weights]

    def somewhere() -> Array:
        return rng.normal(size=(nodes, dimension))

    def coefficients() -> Array:
        return rng.uniform(0.0, 3.0, 1 + len(weights)) * damped

    return Scene(
        body=body,
        position=somewhere(),
        velocity=somewhere(),
        copies=copies,
        weights=matrices,
        springs=[
            Spring(strength=scale(), sample=somewhere(), weight=index % (1 + len(weights))) for index in range(springs)
        ],
        ports=[
            Port(
                node=int(rng.integers(nodes)),
                stiffness=scale() * (index % 4 in {0, 2}),
                damping=scale() * (index % 4 in {1, 2}),
                start=rng.normal(size=dimension),
                end=rng.normal(size=dimension),
                push=rng.normal(size=dimension),
            )
            for index in range(ports)
        ],
        local_damping=coefficients(),
        extra_damping=coefficients(),
    )


@st.composite
def scenes(draw: st.DrawFn, *, springs: int = 3, ports: int = 3, damped: bool | None = None) -> Scene:
    """Random scenes of every form, up to 6 nodes."""
    nodes, dimension = draw(st.integers(1, 6)), draw(st.integers(1, 3))
    kinds = ["node"] if dimension == 1 else ["full"] if nodes == dimension else ["node", "axes", "full"]
    return random_scene(
        draw(st.integers(0, 10**6)),
        nodes=nodes,
        dimension=dimension,
        full=draw(st.booleans()),
        copies=draw(st.integers(1, 5)),
        coupled_mass=draw(st.booleans()),
        weights=draw(st.lists(st.sampled_from(kinds), max_size=2)),
        springs=draw(st.integers(0, springs)),
        ports=draw(st.integers(0, ports)),
        damped=draw(st.booleans()) if damped is None else damped,
    )


# Step lengths from a tenth of a millisecond to a second, every decade alike.
periods = st.floats(-4.0, 0.0).map(lambda exponent: 10.0**exponent)
