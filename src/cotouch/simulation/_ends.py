"""The ends of all links in the batch engine, where a law says what a link does."""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

from typing import NamedTuple

import numpy as np

from cotouch.arrays import Int, Long
from cotouch.kernels import at, inner, put
from cotouch.laws import CompiledHalf, End, feel, hand, handed
from cotouch.mechanics import BodyForce, Contact, Ports, tell_push
from cotouch.passing import by_address
from cotouch.simulation._layout import Float, Timing, Topology


@by_address
class Ends(NamedTuple):
    """What the law's functions see of every slot, and what the step makes of it. Fields are flat, (size,).

    Attributes:
        before: of the law.
        after: of the law.
        copies: N.
        feels: whether the law reads the hands' forces.
        reverse: the slot of the other direction of each slot's link, (slots,).
        parameters: of each slot, (slots, parameters).
        weight: diagonal of each slot's weight, (slots, size).
        used: index of the sample that each slot used last, (slots,).
        steps: taken by each user, (users,).
        position: of all users, the engine's own memory, (users, size) [m].
        velocity: likewise [m/s].
        mean: likewise, of the step just taken, (size,) [m/s].
        samples: likewise, (samples, size) [m].
        hand: force of the hands in the step before, (users, size), or (users, 0) [N].
        touch: likewise of their tools [N].
        mail: messages to each slot, by the sender's step, (slots, ring + 1, fields, size); the last is the empty one.
        mail_scalars: (slots, ring + 1, scalars).
        memory: (slots, fields, size).
        scalars: (slots, scalars).
        shared: (users, fields, size).
        shared_scalars: (users, scalars).
        first: where y of the first slot is in `samples`.
        slot: where y of each slot is, (slots,).
        push: c, (slots, size), the memory of `push_rows`.
        push_rows: (slots, rows, width).
        gains: k and b as the law said, (slots, 2).
        stiffness: k, (slots,) [N/m].
        brake: b, (slots,) [Ns/m].
        words: every slot's end in the step being taken, as the law reads it, (slots, words).
    """

    before: CompiledHalf
    after: CompiledHalf
    copies: int
    feels: bool
    reverse: Int
    parameters: Float
    weight: Float
    used: Int
    steps: Int
    position: Float
    velocity: Float
    mean: Float
    samples: Float
    hand: Float
    touch: Float
    mail: Float
    mail_scalars: Float
    memory: Float
    scalars: Float
    shared: Float
    shared_scalars: Float
    first: int
    slot: Long
    push: Float
    push_rows: Float
    gains: Float
    stiffness: Float
    brake: Float
    words: Long


@inner
def ask(ends: Ends, topology: Topology, timing: Timing, where: Long, i: int, k: int, T: float) -> bool:
    """Lets the law say what the links of user i do in step k; False if it says what no link can be.

    Args:
        ends: of all links.
        topology: who is linked to whom.
        timing: the schedule.
        where: slot of each link's end.
        i: the user.
        k: the step.
        T: length of the step [s].
    """
    for s in range(at(topology.first, i), at(topology.first, i + 1)):
        index = at(timing.used, (s, k))
        new = index > at(ends.used, s)
        hand(_end(ends, topology, timing, where, s, i, k, T, new), ends.words[s])
        ends.before(handed(ends.words[s]))
        stiffness, brake = at(ends.gains, (s, 0)), at(ends.gains, (s, 1))
        if not (0.0 <= stiffness < np.inf and 0.0 <= brake < np.inf):
            return False
        put(ends.stiffness, s, stiffness)
        put(ends.brake, s, brake)
    return True


@inner
def tell(
    ends: Ends,
    topology: Topology,
    timing: Timing,
    ports: Ports,
    contact: Contact | None,
    force: BodyForce | None,
    scale: float,
    i: int,
    k: int,
) -> None:
    """Lets the law say what the neighbours of user i are told after its step k.

    Args:
        ends: of all links.
        topology: who is linked to whom.
        timing: the schedule.
        ports: where forces act.
        contact: by which tools touch, with what they did in the step; None: they don't.
        force: inside the body; tools that are bodies are there.
        scale: share of its forces that a copy has.
        i: the user.
        k: the step.
    """
    for s in range(at(topology.first, i), at(topology.first, i + 1)):
        ends.after(handed(ends.words[s]))
        put(ends.used, s, at(timing.used, (s, k)))
    put(ends.steps, i, at(ends.steps, i) + 1)
    if ends.feels and at(topology.first, i) < at(topology.first, i + 1):
        weight = ends.weight[at(topology.first, i)]
        feel(ends.hand[i], ports, weight)
        if contact is not None:
            copy_rows(ends.touch[i], contact.work.push)
        if force is not None:
            tell_push(force.world, scale, weight, contact is None, ends.touch[i])


@inner
def copy_rows(target: Float, rows: Float) -> None:
    """Rows one after the other.

    Args:
        target: written, (size,).
        rows: read, (rows, width).
    """
    width = rows.shape[1]
    for i in range(rows.shape[0]):
        for axis in range(width):
            put(target, i * width + axis, at(rows, (i, axis)))


@inner
def _end(
    ends: Ends,
    topology: Topology,
    timing: Timing,
    where: Long,
    s: int,
    i: int,
    k: int,
    T: float,
    new: bool,
) -> End:
    peer, back, ring = at(topology.peer, s), at(ends.reverse, s), timing.ring
    index = at(timing.used, (s, k))
    stamp = 0.0
    letter = ring
    if index >= 0:
        stamp = at(timing.end, (peer, index)) - 0.5 * at(timing.length, (peer, index))
        letter = index & (ring - 1)
    out = k & (ring - 1)
    return End(
        T,
        at(timing.end, (i, k)) - stamp,
        index,
        new,
        at(ends.steps, i),
        0 if i < peer else 1,
        s == at(topology.first, i),
        s + 1 == at(topology.first, i + 1),
        ends.copies,
        ends.push_rows.shape[2],
        at(topology.strength, s),
        ends.parameters[s],
        ends.weight[s],
        ends.position[i],
        ends.velocity[i],
        ends.mean,
        ends.samples[at(where, s)],
        ends.hand[i],
        ends.touch[i],
        ends.mail[s, letter],
        ends.mail_scalars[s, letter],
        ends.memory[s],
        ends.scalars[s],
        ends.shared[i],
        ends.shared_scalars[i],
        ends.samples[ends.first + s],
        ends.push[s],
        ends.gains[s],
        ends.mail[back, out],
        ends.mail_scalars[back, out],
    )
