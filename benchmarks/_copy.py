"""One user's copy of a body with neighbours and hands, ready to be stepped in a compiled loop."""

from typing import Any, Literal, NamedTuple

import numba
import numpy as np
import numpy.typing as npt

from cotouch import mechanics
from cotouch.body import Body, lattice
from cotouch.mechanics import ITERATIONS, Basis, Links, Model, Ports, State, Workspace, model, step, workspace

Float = npt.NDArray[np.float64]
Ground = Literal["z-", "all"]

PERIOD = 1e-3
TOLERANCE = 1e-6
CAP = 500
STIFF = 1.8  # ω_max T/2 of the lattices, without the links
MASS = 0.5
USERS = 3
_LINKS, _HANDS = 2, 8


class Copy(NamedTuple):
    """What a step needs, and the lengths of the steps to take."""

    model: Model
    state: State
    links: Links
    ports: Ports
    local: Float
    extra: Float
    work: Workspace
    ledger: Float
    link_work: Float
    lengths: Float


def cube(side: int, ground: Ground = "z-", *, rayleigh: bool = False) -> Body:
    """side³ nodes in three dimensions, 6 neighbours each, with dampers, held at one face or all over.

    Args:
        side: nodes along an edge.
        ground: what is held.
        rayleigh: whether it is damped there like between the nodes, so that its modes are its own.
    """
    stiffness = MASS / side**3 * (2.0 * STIFF / PERIOD) ** 2 / 12.0  # ω_max² = 12 k/m
    held = 0.1 * stiffness
    return lattice(
        (side,) * 3,
        mass=MASS,
        stiffness=stiffness,
        damping=stiffness * 2.0**-16,
        ground=ground,
        ground_stiffness=held,
        ground_damping=held * 2.0**-16 if rayleigh else 0.0,
    )


def copy(body: Body, *, steps: int, basis: Basis = "nodal", spring: float | None = None, seed: int = 1) -> Copy:
    """A moving copy between two neighbours, held by hands, with a different T in every step.

    Args:
        body: of the copy.
        steps: how many lengths of steps to draw.
        basis: as for `model`.
        spring: of a link at each node [N/m]; by default 60 N/m shared by all nodes, the hardest case for the solver,
            because links and their damping make the diagonal heavier.
        seed: of the motion and the lengths.
    """
    rng = np.random.default_rng(seed)
    ready = model(body, copies=USERS, basis=basis)
    rows, width = ready.operator_rows, ready.width
    nodes, axes = body.nodes, body.dimension

    def field(scale: float) -> Float:
        return ready.to_rows(rng.normal(size=(nodes, axes), scale=scale))

    strength = np.full(_LINKS, 60.0 / nodes if spring is None else spring)
    held = rng.choice(nodes, min(_HANDS, nodes), replace=False)
    ports = np.concatenate([ready.port_rows(int(node)) for node in held])
    shape = (ports.size, width)
    return Copy(
        model=ready,
        state=State(field(1e-3), field(1e-2), np.zeros((rows, width)), np.zeros((rows, width)), np.zeros(0)),
        links=Links(
            strength,
            np.zeros(_LINKS, np.int32),
            np.arange(_LINKS),
            np.stack([field(1e-3) for _ in range(_LINKS + 1)]),
        ),
        ports=Ports(
            row=ports,
            shape=ready.port_shapes(ports),
            stiffness=np.full(ports.size, 10.0),
            damping=np.full(ports.size, 0.1),
            start=np.zeros(shape),
            end=np.zeros(shape),
            push=np.zeros(shape),
            force=np.zeros(shape),
        ),
        local=np.array([0.05 * strength.sum()]),
        extra=np.zeros(1),
        work=workspace(ready.operator, width, ports.size),
        ledger=np.zeros(mechanics.LEDGER_COLUMNS),
        link_work=np.zeros(_LINKS),
        lengths=rng.uniform(0.8, 1.2, steps) * PERIOD,
    )


@numba.njit(fastmath={"contract"}, error_model="numpy", nogil=True)
def _many(
    op: Any,
    state: Any,
    links: Any,
    ports: Any,
    local: Any,
    extra: Any,
    lengths: Any,
    work: Any,
    ledger: Any,
    link_work: Any,
    tolerance: Any,
    cap: Any,
    lanes: Any,
) -> Any:
    iterations = 0
    for k in range(lengths.shape[0]):
        step(
            op,
            state,
            links,
            ports,
            local,
            extra,
            lengths[k],
            links.slot.shape[0],
            work,
            ledger,
            link_work,
            tolerance,
            cap,
            lanes,
        )
        iterations += int(ledger[ITERATIONS])
    return iterations


def compiled(c: Copy) -> int:
    """All steps in a compiled loop; returns the iterations of the solver."""
    return int(
        _many(
            c.model.operator,
            c.state,
            c.links,
            c.ports,
            c.local,
            c.extra,
            c.lengths,
            c.work,
            c.ledger,
            c.link_work,
            TOLERANCE,
            CAP,
            c.model.lanes,
        )
    )


def called(c: Copy) -> None:
    """All steps by calls from Python."""
    for T in c.lengths:
        step(
            c.model.operator,
            c.state,
            c.links,
            c.ports,
            c.local,
            c.extra,
            float(T),
            c.links.slot.size,
            c.work,
            c.ledger,
            c.link_work,
            TOLERANCE,
            CAP,
            c.model.lanes,
        )
