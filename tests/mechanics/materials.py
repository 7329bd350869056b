"""Small bodies of every material, and a copy of one that moves alone."""

import itertools
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
from tests.mechanics.inside import evaluate, resist

from cotouch.body import Body, body_from_tetrahedra, is_solid_model, lattice, rigid_box, solid_laws
from cotouch.installed import installed_names
from cotouch.kernels import kernel
from cotouch.mechanics import (
    ELASTIC,
    KINETIC,
    LEDGER_COLUMNS,
    Between,
    BodyForce,
    Links,
    Obstacle,
    Plane,
    Ports,
    State,
    closed_settle,
    closed_step,
    model,
)

Float = npt.NDArray[np.float64]
SHAPE, SPACING, YOUNG, POISSON, DENSITY = (4, 3, 3), 0.01, 1e4, 0.3, 1000.0
GRIDS = ("floating", "cells", "spring-network")
FLOATS = {"floating", "rigid"}
for name in installed_names("cotouch.materials"):  # the suite is that of whoever brings a material, too
    is_solid_model(name)
SOLIDS = ("elastic floating", *solid_laws())
EVERY = (*GRIDS, *SOLIDS, "rigid")
# What never meets anything is stepped by the machine code of what does.
FAR = Obstacle(shape=Plane(point=(0.0, 0.0, -1e3)), stiffness=1.0)


def boxes(shape: tuple[int, ...] = SHAPE, spacing: float = SPACING) -> tuple[Float, npt.NDArray[np.int64]]:
    """Points of a grid, and six tetrahedra for each of its cubes."""
    points = np.stack(np.meshgrid(*[np.arange(n) for n in shape], indexing="ij"), axis=-1).reshape(-1, 3)
    index = np.arange(points.shape[0]).reshape(shape)
    found = []
    for corner in itertools.product(*[range(n - 1) for n in shape]):
        for axes in itertools.permutations(range(3)):
            place, nodes = np.array(corner), [index[corner]]
            for axis in axes:
                place[axis] += 1
                nodes.append(index[tuple(place)])
            found.append(nodes)
    return points * spacing, np.array(found)


def made(
    name: str,
    *,
    viscosity: float = 0.0,
    shape: tuple[int, ...] = SHAPE,
    ground: str = "none",
    hold: float = 0.0,
    gravity: tuple[float, float, float] | None = None,
) -> Body:
    """A box of a material."""
    body = _made(name, viscosity, shape, {"ground": ground, "ground_stiffness": hold})
    return body if gravity is None else body.with_gravity(gravity)


def _made(name: str, viscosity: float, shape: tuple[int, ...], common: dict[str, Any]) -> Body:
    if name == "rigid":  # less so than it would be, or no step could follow how it swings
        return rigid_box((np.array(shape) - 1) * SPACING, density=DENSITY, rate=300.0, viscosity=viscosity)
    if name in GRIDS:
        network = name == "spring-network"
        k = YOUNG * SPACING * (0.4 if network else 1.0)
        return lattice(
            shape,
            neighbours=18 if network else 6,
            mass=DENSITY * float(np.prod((np.array(shape) - 1) * SPACING)),
            stiffness=k,
            damping=viscosity * k,
            spacing=SPACING,
            model="springs" if name == "floating" else name,
            frame="floating" if name == "floating" else "fixed",
            **common,
        )
    frame = "floating" if name == "elastic floating" else "fixed"
    return body_from_tetrahedra(
        boxes(shape),
        unit="m",
        young=YOUNG,
        poisson=POISSON,
        density=DENSITY,
        model="elastic" if frame == "floating" else name,
        frame=frame,
        rayleigh_stiffness=viscosity,
        **common,
    )


class Alone:
    """A copy without neighbours, and what holds it but the ground."""

    def __init__(
        self,
        body: Body,
        position: Float | None = None,
        velocity: Float | None = None,
        *,
        copies: int = 1,
        tolerance: float = 1e-13,
        cap: int = 500,
        directions: int | None = None,
        obstacles: Sequence[Obstacle] = (),
        between: Between | None = None,
    ) -> None:
        if not obstacles and between is None and body.material is not None and body.material.model in FLOATS:
            obstacles = [FAR]
        self.body, self.model = body, model(body, copies=copies, obstacles=obstacles, between=between)
        assert self.model.force is not None
        self.force = self.model.force if directions is None else self.model.force._replace(directions=directions)
        rows, still = self.model.operator_rows, np.zeros((body.nodes, 3))
        self.state = State(
            self.model.to_rows(still if position is None else position),
            self.model.to_rows(still if velocity is None else velocity),
            np.zeros((rows, 4)),
            np.zeros((rows, 4)),
            np.zeros(self.model.memory),
        )
        self.work = self.model.workspace(0)
        self.ledger, none = np.zeros(LEDGER_COLUMNS), np.zeros(0)
        self.links = Links(none, np.zeros(0, np.int32), np.zeros(0, np.int64), np.zeros((1, rows, 4)))
        nothing = np.zeros((0, 4))
        self.ports = Ports(np.zeros(0, np.int32), np.zeros((0, rows)), none, none, nothing, nothing, nothing, nothing)
        self.solver = tolerance, cap
        closed_settle(self.model.operator, self.force, self.state, self.work, self.ledger, self.model.lanes)

    def step(self, T: float, damping: float = 0.0) -> Float:
        """Takes a step; returns its ledger."""
        state, lanes, local = self.state, self.model.lanes, np.array([damping])
        args = local, np.zeros(1), T, -1, self.work, self.ledger, np.zeros(0), *self.solver, lanes
        closed_step(self.model.operator, self.force, state, self.links, self.ports, *args)
        return self.ledger

    @property
    def energy(self) -> float:
        """What it holds [J]."""
        return float(self.ledger[KINETIC] + self.ledger[ELASTIC])

    @property
    def position(self) -> Float:
        """Displacement, (n, 3) [m]."""
        return self.model.to_nodes(self.state.position)

    @property
    def velocity(self) -> Float:
        """Velocity, (n, 3) [m/s]."""
        return self.model.to_nodes(self.state.velocity)

    @property
    def mass(self) -> Float:
        """Of each node, (n, 1) [kg]."""
        return self.body.mass.diagonal().reshape(self.body.nodes, -1)[:, :1]

    def rows(self, field: Float) -> Float:
        """A field as kernels want it."""
        return self.model.to_rows(field)


@kernel
def force_between(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]
) -> None:
    """`resist` for tests."""
    resist(force.law, memory, x, ahead, rate, out, lanes)


@kernel
def energy_at(
    force: BodyForce, memory: Float, x: Float, ahead: Float, rate: Float, sweeps: int, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """`evaluate` for tests."""
    return evaluate(force.law, memory, x, ahead, rate, sweeps, lanes)


def bent(body: Body, size: float = 0.1) -> Float:
    """A smooth displacement that bends and stretches."""
    x = body.rest - body.rest.mean(axis=0)
    length = float(np.ptp(x, axis=0).max())
    return size * np.stack([x[:, 0] + x[:, 1] * x[:, 2] / length, x[:, 0] * x[:, 1] / length, x[:, 0] ** 2 / length], 1)


def rotation(axis: npt.ArrayLike, angle: float) -> Float:
    """A rotation matrix."""
    u = np.asarray(axis, dtype=np.float64) / np.linalg.norm(axis)
    cross = np.array([[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]])
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
