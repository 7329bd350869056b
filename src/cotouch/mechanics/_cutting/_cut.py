"""Cutting: elements are taken away at a step's boundary, and what they held is lost, to the last bit.

Which elements are cut is part of a copy's memory: for each the number of the step after which it was, from 1, and the
user who decided it. A set of cut elements only grows, so copies agree by taking unions, in any order [Shapiro et al.
2011, a grow-only set].
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math
from typing import NamedTuple

from cotouch.arrays import Float, Int
from cotouch.kernels import at, block, inner, part, put
from cotouch.mechanics._closed._balance import AT_WORLD, ENERGY
from cotouch.mechanics._closed._balance_parts import keep_parts
from cotouch.mechanics._closed._debris import stop_debris
from cotouch.mechanics._cutting._crossing import crosses
from cotouch.mechanics._cutting._matrix import Bonds, loosen
from cotouch.mechanics._linear._operator import Operator
from cotouch.mechanics._linear._state import CUT, CUT_COUNT, ELASTIC, WORLD_STORED, State
from cotouch.mechanics._materials._breaking import principal_stress
from cotouch.mechanics._materials._force import BodyForce, evaluate
from cotouch.mechanics._meeting._world import World
from cotouch.mechanics._meeting._world_cut import keep_depths, meet_anew, show
from cotouch.mechanics._model._tools import BLADE, Tools
from cotouch.passing import by_address

# Slower than this a blade creeps under less than what would cut [m/s].
_SLOW = 1e-3

# Corners of an element of each kind, and nodes that these may be the middles of: two cubes' for a face that opens.
KINDS, WIDEST = (2, 4, 8), 16


@by_address
class Cutting(NamedTuple):
    """The elements of a body as something to be cut; scratch besides.

    Attributes:
        first: where the marks of a copy begin in its memory, behind their number: the step after which each element was
            cut, from 1, then the user who decided it, from 1; 0 of those that are whole.
        breaks: whether any element does by itself.
        decides: whether each user's copy cuts by itself, (users,).
        rest: places of the rows at rest, (rows, 4) [m].
        corner: rows of each element's corners, (E, 16); -1 where it has fewer. Of a face that opens: those of the two
            elements beside it, whose middles are its two corners.
        each: how many rows each corner is the middle of, (E,).
        tied: rows of what is tied at a face: up to four on the one side, then on the other, (E, 8); else -1.
        hold: of a face, stiffness of a tie for the face's area, (E,) [Pa/m].
        kind: of each element, as a place in `KINDS`, (E,).
        edge: pairs of corners, of one kind after the other, (s, 2).
        edges: first of each kind, (kinds + 1,).
        most: squares of the lengths at which edges break, (E, 12) [m²].
        law: which one each tetrahedron has for its stress, from 0; negative: none, (E,).
        strength: the greatest principal stress that they bear [Pa].
        lame: of them, see `lame_of`, (E, 3).
        gradient: ∇N of their last three corners, (3 E, 4) [1/m].
        toughness: what a blade pays for new area [J/m²].
        area: that an element stands for, (E,) [m²].
        face: triples of corners, seen from outside, of one kind after the other, (q, 3); none of a spring.
        faces: first of each kind, (kinds + 1,).
        pointer: of each triangle of the skin into `element`, (F + 1,).
        element: elements that carry it; it is there while all of them are whole.
        beyond: and while this one is cut; negative: none, (F,).
        across: way through an element [m].
        wanted: scratch: the user who has just decided to cut each, from 1; 0: nobody, (E,).
        bonds: what of the operator goes with them.
        before: scratch: displacements before the step, (rows, width) [m].
        blade: scratch: places of the tools before it, (tools, 4) [m].
        spot: scratch: an element's corners, then the ends of a blade before and after, (8 + 4, 4) [m].
    """

    first: int
    breaks: bool
    decides: Int
    rest: Float
    corner: Int
    each: Int
    tied: Int
    hold: Float
    kind: Int
    edge: Int
    edges: Int
    most: Float
    law: Int
    strength: float
    lame: Float
    gradient: Float
    toughness: float
    area: Float
    face: Int
    faces: Int
    pointer: Int
    element: Int
    beyond: Int
    across: float
    wanted: Int
    bonds: Bonds
    before: Float
    blade: Float
    spot: Float


@block
def begin_cut(cutting: Cutting, world: World | None, state: State, tools: Tools | None) -> None:
    """Keeps where a copy and its blades are before a step, and forgets what the last one decided.

    Args:
        cutting: the elements.
        world: what the skin meets, which must know what of it is there; None: nothing.
        state: of the copy.
        tools: its tools; None: none.
    """
    show_skin(cutting, world, state.memory)
    loosen(cutting.bonds, state.memory, cutting.first)
    for e in range(cutting.wanted.shape[0]):
        cutting.wanted[e] = 0
    for i in range(cutting.before.shape[0]):
        for a in range(cutting.before.shape[1]):
            cutting.before[i, a] = state.position[i, a]
    if tools is not None:
        for t in range(tools.mode.shape[0]):
            fast = 0.0
            for a in range(3):
                cutting.blade[t, a] = tools.place[t, a]
                fast += tools.rate[t, a] * tools.rate[t, a]
            if at(tools.mode, t) != BLADE or tools.debt[t] < 0.0:
                tools.debt[t] = 0.0
            # What it cut is paid over the way through an element, by a force that hardly asks how fast that goes.
            tools.drag[t] = tools.debt[t] / (cutting.across * max(math.sqrt(fast), _SLOW))


@block
def hear_cuts(cutting: Cutting, memory: Float, other: Float, sample: int) -> None:
    """Takes over what a neighbour had cut when it told a sample.

    Args:
        cutting: the elements; what is new to this copy is wanted.
        memory: of this copy.
        other: of the neighbour, as it is now.
        sample: number of the step whose sample was heard, from 0.
    """
    count, first = cutting.wanted.shape[0], cutting.first
    for e in range(count):
        step = at(other, first + e)
        if step != 0.0 and step <= sample + 1.0 and at(memory, first + e) == 0.0:
            cutting.wanted[e] = int(at(other, first + count + e))


@block
def decide_cuts(cutting: Cutting, memory: Float, position: Float, tools: Tools | None, user: int, tears: bool) -> None:
    """What a copy itself cuts after a step: elements stretched too far, and those that its blades went through.

    Args:
        cutting: the elements, and where all was before the step; what is new is wanted.
        memory: of the copy.
        position: where it came to, displacements of the rows [m].
        tools: its tools; None: none.
        user: its number, from 1.
        tears: whether elements break.
    """
    tears = tears and cutting.breaks
    if cutting.decides.shape[0] > 0 and cutting.decides[user - 1] == 0:
        return
    blades = 0
    if tools is not None:
        for t in range(tools.mode.shape[0]):
            blades += 1 if at(tools.mode, t) == BLADE else 0
    if blades == 0 and not tears:
        return
    for e in range(cutting.wanted.shape[0]):
        if cutting.wanted[e] != 0 or at(memory, cutting.first + e) != 0.0:
            continue
        each = at(cutting.each, e)
        for c in range(_corners(cutting, e)):
            for a in range(3):
                place = 0.0
                for n in range(c * each, c * each + each):
                    i = cutting.corner[e, n]
                    place += cutting.rest[i, a] + position[i, a]
                cutting.spot[c, a] = place / each
        if tears and (_strained(cutting, e) or _stressed(cutting, e) or _pulled(cutting, e, position)):
            cutting.wanted[e] = user
        elif blades > 0:
            if tools is None:
                continue
            for t in range(tools.mode.shape[0]):
                if at(tools.mode, t) == BLADE and _swept(cutting, e, position, tools, t):
                    cutting.wanted[e] = user
                    tools.debt[t] += cutting.toughness * cutting.area[e]
                    break


@inner
def _corners(cutting: Cutting, e: int) -> int:
    """How many corners an element has."""
    return 2 << at(cutting.kind, e)


@part
def _strained(cutting: Cutting, e: int) -> bool:
    """Whether an edge of an element, whose corners are in `spot`, is too long."""
    spot, first = cutting.spot, at(cutting.edges, at(cutting.kind, e))
    for s in range(at(cutting.edges, at(cutting.kind, e) + 1) - first):
        i, j = cutting.edge[first + s, 0], cutting.edge[first + s, 1]
        x, y, z = spot[j, 0] - spot[i, 0], spot[j, 1] - spot[i, 1], spot[j, 2] - spot[i, 2]
        if x * x + y * y + z * z > cutting.most[e, s]:
            return True
    return False


@part
def _stressed(cutting: Cutting, e: int) -> bool:
    """Whether the greatest principal stress of a tetrahedron, whose corners are in `spot`, is too much."""
    if at(cutting.law, e) < 0 or not cutting.strength < math.inf:
        return False
    stress = principal_stress(
        at(cutting.law, e), cutting.lame[e, 0], cutting.lame[e, 1], cutting.spot, cutting.gradient, 3 * e
    )
    return stress > cutting.strength


@part
def _pulled(cutting: Cutting, e: int, position: Float) -> bool:
    """Whether the ties of a face pull across it by more than it bears."""
    if at(cutting.hold, e) == 0.0 or not cutting.strength < math.inf:
        return False
    spot = cutting.spot
    for c in range(3):
        i, j = at(cutting.tied, (e, c)), at(cutting.tied, (e, 4 + c))
        for a in range(3):
            spot[8 + c, a] = cutting.rest[i, a] + 0.5 * (position[i, a] + position[j, a])
    ux, uy, uz = spot[9, 0] - spot[8, 0], spot[9, 1] - spot[8, 1], spot[9, 2] - spot[8, 2]
    vx, vy, vz = spot[10, 0] - spot[8, 0], spot[10, 1] - spot[8, 1], spot[10, 2] - spot[8, 2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    apart = 0.0
    for c in range(4):
        i, j = at(cutting.tied, (e, c)), at(cutting.tied, (e, 4 + c))
        if i >= 0:
            apart += nx * (position[j, 0] - position[i, 0]) + ny * (position[j, 1] - position[i, 1])
            apart += nz * (position[j, 2] - position[i, 2])
    return at(cutting.hold, e) * apart > cutting.strength * math.sqrt(nx * nx + ny * ny + nz * nz)


@part
def _swept(cutting: Cutting, e: int, position: Float, tools: Tools, t: int) -> bool:
    """Whether a blade went through an element, whose corners are in `spot`, as that moved with it."""
    spot, corners, kind = cutting.spot, _corners(cutting, e), at(cutting.kind, e)
    rows = corners * at(cutting.each, e)
    for a in range(3):
        moved = 0.0
        for c in range(rows):
            i = cutting.corner[e, c]
            moved += (position[i, a] - cutting.before[i, a]) / rows
        spot[corners, a] = cutting.blade[t, a] + moved
        spot[corners + 1, a] = cutting.blade[t, a] + moved + tools.axis[t, a]
        spot[corners + 2, a] = tools.place[t, a] + tools.axis[t, a]
        spot[corners + 3, a] = tools.place[t, a]
    edge = cutting.edge[at(cutting.edges, kind) : at(cutting.edges, kind + 1)]
    face = cutting.face[at(cutting.faces, kind) : at(cutting.faces, kind + 1)]
    # A face opens where the blade goes between the elements beside it.
    return crosses(spot, corners, edge, face, tools.radius[t] if at(cutting.hold, e) == 0.0 else 0.0)


@block
def sever(
    cutting: Cutting, op: Operator, force: BodyForce, state: State, step: int, ledger: Float, lanes: tuple[int, ...]
) -> int:
    """Takes away the wanted elements; CUT of the ledger gets exactly what they held, and ELASTIC loses it.

    Nodes that have lost their last element stop; what they moved with goes from KINETIC to CUT.

    Args:
        cutting: the elements.
        op: the body, as this copy has it.
        force: what resists inside.
        state: of the copy; its memory is changed in place.
        step: number of the step that was just taken, from 0.
        ledger: of that step; changed in place.
        lanes: fixes the width.

    Returns:
        How many were taken away.
    """
    memory, world = state.memory, force.world
    before = at(memory, cutting.first - 1)
    outside = mark_cuts(cutting, world, memory, state.position, step)
    new = int(at(memory, cutting.first - 1) - before)
    ledger[CUT], ledger[CUT_COUNT] = 0.0, new
    if new == 0:
        return 0
    scale = op.copy_scale * op.firmness
    # With the rotations as they are; terms that are not below 0 can only make the sum less by going.
    energy, _ = evaluate(force.law, memory, state.position, state.position, state.velocity, 0, lanes)
    held = memory[ENERGY] - energy
    if held > 0.0:
        ledger[CUT] = scale * held
        memory[ENERGY] = energy
        keep_parts(force.parts, memory)
    held = memory[AT_WORLD] - outside
    if held > 0.0:
        ledger[CUT] += scale * held
        memory[AT_WORLD] = outside
        ledger[WORLD_STORED] = scale * outside
    ledger[ELASTIC] -= ledger[CUT]
    loosen(cutting.bonds, memory, cutting.first)
    stop_debris(op, state, ledger, lanes)
    return new


@block
def mark_cuts(cutting: Cutting, world: World | None, memory: Float, position: Float, step: int) -> float:
    """Marks the wanted elements as cut.

    Args:
        cutting: the elements.
        world: what the skin meets; None: nothing.
        memory: of the copy; changed in place.
        position: where it is, displacements of the rows [m].
        step: number of the step that was just taken, from 0.

    Returns:
        What obstacles and other bodies hold afterwards, of the whole body [J].
    """
    count, new = cutting.wanted.shape[0], 0
    for e in range(count):
        if cutting.wanted[e] != 0 and at(memory, cutting.first + e) == 0.0:
            new += 1
    if new > 0 and world is not None:
        keep_depths(world, memory, position)
    for e in range(count):
        if cutting.wanted[e] != 0 and at(memory, cutting.first + e) == 0.0:
            put(memory, cutting.first + e, step + 1.0)
            put(memory, cutting.first + count + e, float(cutting.wanted[e]))
    memory[cutting.first - 1] += new
    if new > 0 and world is not None:
        show_skin(cutting, world, memory)
        return meet_anew(world, memory, position)
    return 0.0


@block
def show_skin(cutting: Cutting, world: World | None, memory: Float) -> None:
    """Works out which triangles and points of the skin the world and other bodies meet.

    Args:
        cutting: the elements.
        world: what the skin meets; None: nothing.
        memory: of a copy.
    """
    if world is not None:
        many = at(memory, cutting.first - 1)
        if many != 0.0 or world.gone[0] != 0.0:
            expose(cutting, memory, world.hidden)
            show(world)
            world.gone[0] = many


@block
def expose(cutting: Cutting, memory: Float, hidden: Int) -> None:
    """Works out which triangles of a skin are not there.

    Args:
        cutting: what each hangs on.
        memory: of a copy.
        hidden: result: 1 where a triangle is not there, (F,).
    """
    first = cutting.first
    for f in range(cutting.beyond.shape[0]):
        other = at(cutting.beyond, f)
        gone = 1 if other >= 0 and at(memory, first + other) == 0.0 else 0
        for n in range(at(cutting.pointer, f), at(cutting.pointer, f + 1)):
            if at(memory, first + at(cutting.element, n)) != 0.0:
                gone = 1
        put(hidden, f, gone)
