"""What replicas that are no link law have in common: hands and messages as numbers, and the books of a run.

A replica moves whole copies of the body by the hands' forces, so it is told apart from a link law by what it books: no
force of a link, but a body that has more or less energy than the hands gave it. That is what it *made*.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple, final

import numpy as np

from cotouch.arrays import Float, Int, Long
from cotouch.compiled import routine, subroutine
from cotouch.errors import ScenarioError
from cotouch.interaction import Hands, grip
from cotouch.laws import Law, law_named
from cotouch.mechanics import Ports, idle_ports
from cotouch.simulation import Prepared


class AxisRun(NamedTuple):
    """A run on one axis, for the kernels; copies are 0 to N - 1, steps 0 to S - 1.

    Attributes:
        mass: of the whole body [kg].
        damping: [Ns/m].
        stiffness: to where it rests [N/m].
        T: length of a step [s].
        used: newest step of copy j that copy i knows in each step, (N, N, S); -1: none.
        delay: from copy j to i, steps' ages included, (N, N) [s].
        spring: of the links, (N, N) [N/m].
        hand_stiffness: of what holds each copy, (N, S) [N/m].
        hand_damping: (N, S) [Ns/m].
        aim: force of the hands were the copy at rest in 0, (N, S) [N].
        mean: result, x̂ of the copies as they were shown, (N, S) [m].
        rate: result, v̂ likewise, (N, S) [m/s].
        place: result, x after each step, (N, S + 1); the first is given [m].
        speed: result, v after each step, (N, S + 1); the first is given [m/s].
        energy: result, of the body, of all copies in the mean, (S + 1,) [J].
        lost: result, in its own damping in each step, likewise, (S,) [J].
        corrected: result, energy of the states that were overwritten, (1,) [J].
    """

    mass: float
    damping: float
    stiffness: float
    T: float
    used: Int
    delay: Float
    spring: Float
    hand_stiffness: Float
    hand_damping: Float
    aim: Float
    mean: Float
    rate: Float
    place: Float
    speed: Float
    energy: Float
    lost: Float
    corrected: Float


@final
@dataclass(frozen=True, kw_only=True)
class ReplicaKind:
    """A kind of replica.

    Attributes:
        name: in a study.
        move: the whole run, compiled.
        join: of one whose copies a link law joins, runs it with the law and the parameters that it is given, and says
            what all ends may make [J].
        sends: what a message holds.
        numbers: how many of each axis that are, if none was lost.
        source: where it is published.
    """

    name: str
    move: Callable[..., None]
    sends: tuple[str, ...]
    source: str
    numbers: int = 1
    join: Callable[[AxisRun, Law, Mapping[str, float | str]], float] | None = None


@final
@dataclass(frozen=True, kw_only=True, eq=False)
class Moved:
    """What a replica did.

    Attributes:
        place: of all users, (users, steps + 1, 1, axes) [m].
        velocity: likewise [m/s].
        force: of each hand, (hands, steps, axes) [N].
        made: most energy that the body had beyond what hands gave it [J].
        extracted: most that hands got out beyond what there was [J].
        corrected: energy of the states that were overwritten [J].
        finite: whether the motion stayed in floating point.
        said: samples that a user said in full to a neighbour, and bytes without headers, in the mean over directions of
            links; None: all of them in full.
    """

    place: Float
    velocity: Float
    force: Float
    made: float
    extracted: float
    corrected: float
    finite: bool
    said: tuple[float, float] | None = None


@subroutine
def advance(
    run: AxisRun, x: float, v: float, stiffness: float, damping: float, push: float, mass: float, own: float
) -> float:
    """Mean velocity of the step of a body that moves by `m a + (B + b) v̂ + (K + k) x̂ = push`, by one step of NPMI.

    Args:
        run: of which the length of the step and K count.
        x: before it [m].
        v: before it [m/s].
        stiffness: k, of what holds it [N/m].
        damping: b [Ns/m].
        push: of the rest, at rest in 0 [N].
        mass: m [kg].
        own: 1.0 with the body's own B and K, 0.0 without.
    """
    held = own * run.stiffness + stiffness
    inertia = 2.0 * mass / run.T
    return (inertia * v - held * x + push) / (inertia + own * run.damping + damping + 0.5 * run.T * held)


@subroutine
def body_energy(run: AxisRun, x: float, v: float) -> float:
    """Of the body [J].

    Args:
        run: of which mass and stiffness count.
        x: displacement [m].
        v: velocity [m/s].
    """
    return 0.5 * run.mass * v * v + 0.5 * run.stiffness * x * x


def replicate(kind: ReplicaKind, prepared: Prepared) -> Moved:
    """Runs a prepared scenario with replicas instead of links.

    Args:
        kind: of replica.
        prepared: of a point, all users linked with all and stepping together.

    Raises:
        ScenarioError: it is something else.
    """
    timing, body, network = prepared.schedule, prepared.body, prepared.scenario.network
    users, steps = timing.count.size, int(timing.count.min())
    if body.nodes != 1 or body.mass.shape != (1, 1) or prepared.touching is not None:
        raise ScenarioError(f'replica "{kind.name}" moves only a point held by hands; for other bodies, use a link law')
    if (timing.length != timing.length.flat[0]).any() or timing.mode != "freshest":
        raise ScenarioError(f'replica "{kind.name}" needs steps of one length for all, and mode "freshest"')
    if len(network.links) != users * (users - 1) // 2:
        raise ScenarioError(f'replica "{kind.name}" needs every user linked with every other; take graph "complete"')
    used = np.full((users, users, steps), -1, dtype=np.int32)
    used[timing.slots.receiver, timing.slots.sender] = timing.used[:, :steps]
    stiffness, damping, aim = _holding(prepared, steps)
    owner = np.repeat(np.arange(users), np.diff(prepared.hands.first))
    width = aim.shape[-1]
    place, speed = np.zeros((users, steps + 1, width)), np.zeros((users, steps + 1, width))
    mean, rate = np.zeros((users, steps, width)), np.zeros((users, steps, width))
    energy, lost, corrected, seed = np.zeros(steps + 1), np.zeros(steps), 0.0, 0.0

    def summed(values: Float) -> Float:
        result = np.zeros((users, steps))
        np.add.at(result, owner, values)
        return result

    scalar = [float(matrix.sum()) for matrix in (body.mass, body.damping, body.stiffness)]
    for axis in range(body.dimension):
        run = AxisRun(
            *scalar,
            T=float(timing.length.flat[0]),
            used=used,
            delay=timing.budget(1.0),
            spring=np.ascontiguousarray(network.spring, dtype=np.float64),
            hand_stiffness=summed(stiffness),
            hand_damping=summed(damping),
            aim=summed(aim[..., axis]),
            mean=np.zeros((users, steps)),
            rate=np.zeros((users, steps)),
            place=np.full((users, steps + 1), prepared.position[:, 0, axis].mean()),
            speed=np.full((users, steps + 1), prepared.velocity[:, 0, axis].mean()),
            energy=np.zeros(steps + 1),
            lost=np.zeros(steps),
            corrected=np.zeros(1),
        )
        if kind.join is None:
            kind.move(run)
        else:
            name, given = prepared.scenario.law
            seed += kind.join(run, law_named(name), given)
        place[..., axis], speed[..., axis], mean[..., axis], rate[..., axis] = run.place, run.speed, run.mean, run.rate
        energy, lost, corrected = energy + run.energy, lost + run.lost, corrected + float(run.corrected[0])
    force = np.zeros((len(prepared.ports), steps, width))
    supplied = np.zeros(steps)
    for hand, (port, *_) in enumerate(prepared.ports):
        i = owner[port]
        force[hand] = aim[port] - stiffness[port][:, None] * mean[i] - damping[port][:, None] * rate[i]
        supplied += (force[hand] * np.diff(place[i], axis=0)).sum(axis=1)
    made = energy[1:] - energy[0] + np.cumsum(lost) - np.cumsum(supplied)
    finite = bool(np.isfinite(place).all() and np.isfinite(made).all() and np.abs(energy).max() < 1e100)
    return Moved(
        place=place[:, :, None],
        velocity=speed[:, :, None],
        force=force,
        made=max(float(made.max()) - seed, 0.0),
        extracted=max(0.0, -float(energy[0] + np.cumsum(supplied).min())),
        corrected=corrected,
        finite=finite,
    )


def _holding(prepared: Prepared, steps: int) -> tuple[Float, Float, Float]:
    """Stiffness and damping of each port in each step, (ports, steps), and its force at rest in 0, (.., width)."""
    ports, timing = prepared.hands.row.size, prepared.schedule
    users, width = timing.count.size, prepared.model.width
    held = idle_ports(prepared.hands.row, prepared.hands.shape, width)
    result = np.zeros((ports, steps)), np.zeros((ports, steps)), np.zeros((ports, steps, width))
    _gripped(
        prepared.hands,
        held,
        prepared.hands.path_first[:-1].copy(),
        np.repeat(np.arange(users), np.diff(prepared.hands.first)).astype(np.int64),
        timing.end,
        timing.length,
        *result,
        prepared.model.lanes,
    )
    return result


@routine
def _gripped(
    hands: Hands,
    held: Ports,
    cursor: Int,
    owner: Long,
    end: Float,
    length: Float,
    stiffness: Float,
    damping: Float,
    aim: Float,
    lanes: tuple[int, ...],
) -> None:
    for p in range(stiffness.shape[0]):
        for k in range(stiffness.shape[1]):
            T = length[owner[p], k]
            grip(hands, held, cursor, p, end[owner[p], k], T, lanes)
            stiffness[p, k], damping[p, k] = held.stiffness[p], held.damping[p]
            for axis in range(aim.shape[2]):
                middle = 0.5 * (held.start[p, axis] + held.end[p, axis])
                pace = (held.end[p, axis] - held.start[p, axis]) / T
                aim[p, k, axis] = held.push[p, axis] + stiffness[p, k] * middle + damping[p, k] * pace
