"""Cutting: elements are taken away at a step's boundary, and what they held is lost, to the last bit.

Which elements are cut is part of a copy's memory: for each the number of the step after which it was, from 1, and the
user who decided it. A set of cut elements only grows, so copies agree by taking unions, in any order [Shapiro et al.
2011, a grow-only set].
"""
# An array indexed by an element of another is a number to numba and an array to numpy's types.
# pyright: reportArgumentType=false, reportReturnType=false

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.body import FACES, Body, cut_skin
from cotouch.errors import UnsupportedError
from cotouch.mechanics._balance import ENERGY
from cotouch.mechanics._breaking import SOLIDS, principal_stress
from cotouch.mechanics._crossing import crosses
from cotouch.mechanics._force import BodyForce, evaluate
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._materials import gradients_of, lame_of
from cotouch.mechanics._model import Model
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._state import CUT, CUT_COUNT, ELASTIC, State
from cotouch.mechanics._tools import BLADE, Tools
from cotouch.mechanics._vector import at, put

Int = npt.NDArray[np.int32]

# Slower than this a blade creeps under less than what would cut [m/s].
_SLOW = 1e-3

# Edges of an element by its number of corners: pairs that stretch.
_EDGES = {
    2: ((0, 1),),
    4: ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)),
    8: tuple((i, j) for i in range(8) for j in range(i + 1, 8) if (i ^ j).bit_count() == 1),
}


class Cutting(NamedTuple):
    """The elements of a body as something to be cut; scratch besides.

    Attributes:
        first: where the marks of a copy begin in its memory, behind their number: the step after which each element was
            cut, from 1, then the user who decided it, from 1; 0 of those that are whole.
        breaks: whether any element does by itself.
        decides: whether each user's copy cuts by itself, (users,).
        rest: places of the rows at rest, (rows, 4) [m].
        corner: rows of each element's corners, (E, c).
        edge: pairs of corners, (s, 2).
        most: squares of the lengths at which edges break, (E, s) [m²].
        law: which one tetrahedra have for their stress, from 0; negative: none.
        strength: the greatest principal stress that they bear [Pa].
        lame: of them, see `lame_of`.
        gradient: ∇N of their last three corners, (3 E, 4) [1/m].
        toughness: what a blade pays for new area [J/m²].
        area: that an element stands for, (E,) [m²].
        face: triples of corners, seen from outside, (q, 3); none of a spring.
        pointer: of each triangle of the skin into `element`, (F + 1,).
        element: elements that carry it; it is there while all of them are whole.
        beyond: and while this one is cut; negative: none, (F,).
        across: way through an element [m].
        wanted: scratch: the user who has just decided to cut each, from 1; 0: nobody, (E,).
        before: scratch: displacements before the step, (rows, width) [m].
        blade: scratch: places of the tools before it, (tools, 4) [m].
        spot: scratch: an element's corners, then the ends of a blade before and after, (c + 4, 4) [m].
    """

    first: int
    breaks: bool
    decides: Int
    rest: Float
    corner: Int
    edge: Int
    most: Float
    law: int
    strength: float
    lame: Float
    gradient: Float
    toughness: float
    area: Float
    face: Int
    pointer: Int
    element: Int
    beyond: Int
    across: float
    wanted: Int
    before: Float
    blade: Float
    spot: Float


def cutting_of(model: Model, *, tools: int = 0, decides: Sequence[bool] = ()) -> Cutting | None:
    """The elements of a body that can be cut; None where it cannot.

    Args:
        model: the body.
        tools: how many there are in the arrays of tools that kernels get.
        decides: whether each user's copy cuts by itself; by default all do.

    Raises:
        UnsupportedError: a law that is not this package's own.
    """
    material = model.body.material
    if model.cut < 0 or material is None:
        return None
    elements = material.elements
    count = elements.shape[1]
    if count not in _EDGES:
        raise UnsupportedError(f"elements have {count} corners; what can be cut has 2, 4 or 8")
    row = np.arange(model.body.nodes) if model.order is None else np.argsort(model.order)
    rest = np.zeros((model.body.nodes, 4))
    rest[row, :3] = model.body.rest
    edge = np.array(_EDGES[count], dtype=np.int32)
    ends = model.body.rest[elements[:, edge]]
    length = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
    solid = SOLIDS.index(material.model) if material.model in SOLIDS else -1
    limit = np.full(length.shape, float(material.tear))
    if solid < 0:  # k over the length of an edge is the modulus along it
        with np.errstate(divide="ignore"):
            limit = np.minimum(limit, material.strength * length / material.stiffness[:, None])
    faces, nothing = cut_skin(model.body), np.zeros(0, dtype=np.int32)
    return Cutting(
        first=model.cut,
        breaks=bool(min(material.tear, material.strength) < math.inf),
        decides=np.array(decides, dtype=np.int32),
        rest=rest,
        corner=np.ascontiguousarray(row[elements], dtype=np.int32),
        edge=edge,
        most=np.ascontiguousarray((length * (1.0 + limit)) ** 2),
        law=solid,
        strength=float(material.strength),
        lame=np.zeros((0, 3)) if solid < 0 else lame_of(material),
        gradient=np.zeros((0, 4)) if solid < 0 else gradients_of(model.body.rest, elements),
        toughness=float(material.toughness),
        area=_areas(model.body, elements, length),
        face=np.array(FACES[count], dtype=np.int32).reshape(-1, 3),
        pointer=np.zeros(1, dtype=np.int32) if faces is None else faces.pointer.astype(np.int32),
        element=nothing if faces is None else faces.element.astype(np.int32),
        beyond=nothing if faces is None else faces.beyond.astype(np.int32),
        across=math.sqrt(float(_areas(model.body, elements, length).mean())),
        wanted=np.zeros(elements.shape[0], dtype=np.int32),
        before=np.zeros((model.operator_rows, model.width)),
        blade=np.zeros((tools, 4)),
        spot=np.zeros((count + 4, 4)),
    )


def _areas(body: Body, elements: Int, length: Float) -> Float:
    """What a cut through each element lays open: a square as long as its edge, or of its volume, (E,) [m²]."""
    if elements.shape[1] == 4:
        edges = body.rest[elements[:, 1:]] - body.rest[elements[:, :1]]
        return (np.abs(np.linalg.det(edges)) / 6.0) ** (2.0 / 3.0)
    return length.mean(axis=1) ** 2


@block
def begin_cut(cutting: Cutting, state: State, tools: Tools | None) -> None:
    """Keeps where a copy and its blades are before a step, and forgets what the last one decided.

    Args:
        cutting: the elements.
        state: of the copy.
        tools: its tools; None: none.
    """
    for e in range(cutting.wanted.shape[0]):
        cutting.wanted[e] = 0
    for i in range(cutting.before.shape[0]):
        for a in range(cutting.before.shape[1]):
            cutting.before[i, a] = state.position[i, a]
    if tools is not None:
        for t in range(tools.first, tools.last):
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
        for t in range(tools.first, tools.last):
            blades += 1 if at(tools.mode, t) == BLADE else 0
    if blades == 0 and not tears:
        return
    for e in range(cutting.wanted.shape[0]):
        if cutting.wanted[e] != 0 or at(memory, cutting.first + e) != 0.0:
            continue
        for c in range(cutting.corner.shape[1]):
            i = cutting.corner[e, c]
            for a in range(3):
                cutting.spot[c, a] = cutting.rest[i, a] + position[i, a]
        if tears and (_strained(cutting, e) or _stressed(cutting, e)):
            cutting.wanted[e] = user
        elif blades > 0:
            if tools is None:
                continue
            for t in range(tools.first, tools.last):
                if at(tools.mode, t) == BLADE and _swept(cutting, e, position, tools, t):
                    cutting.wanted[e] = user
                    tools.debt[t] += cutting.toughness * cutting.area[e]
                    break


@part
def _strained(cutting: Cutting, e: int) -> bool:
    """Whether an edge of an element, whose corners are in `spot`, is too long."""
    spot = cutting.spot
    for s in range(cutting.edge.shape[0]):
        i, j = cutting.edge[s, 0], cutting.edge[s, 1]
        x, y, z = spot[j, 0] - spot[i, 0], spot[j, 1] - spot[i, 1], spot[j, 2] - spot[i, 2]
        if x * x + y * y + z * z > cutting.most[e, s]:
            return True
    return False


@part
def _stressed(cutting: Cutting, e: int) -> bool:
    """Whether the greatest principal stress of a tetrahedron, whose corners are in `spot`, is too much."""
    if cutting.law < 0 or not cutting.strength < math.inf:
        return False
    stress = principal_stress(
        cutting.law, cutting.lame[e, 0], cutting.lame[e, 1], cutting.spot, cutting.gradient, 3 * e
    )
    return stress > cutting.strength


@part
def _swept(cutting: Cutting, e: int, position: Float, tools: Tools, t: int) -> bool:
    """Whether a blade went through an element, whose corners are in `spot`, as that moved with it."""
    spot, corners = cutting.spot, cutting.corner.shape[1]
    for a in range(3):
        moved = 0.0
        for c in range(corners):
            i = cutting.corner[e, c]
            moved += (position[i, a] - cutting.before[i, a]) / corners
        spot[corners, a] = cutting.blade[t, a] + moved
        spot[corners + 1, a] = cutting.blade[t, a] + moved + tools.axis[t, a]
        spot[corners + 2, a] = tools.place[t, a] + tools.axis[t, a]
        spot[corners + 3, a] = tools.place[t, a]
    return crosses(spot, corners, cutting.edge, cutting.face, tools.radius[t])


@block
def sever(
    cutting: Cutting, op: Operator, force: BodyForce, state: State, step: int, ledger: Float, lanes: tuple[int, ...]
) -> int:
    """Takes away the wanted elements; CUT of the ledger gets exactly what they held, and ELASTIC loses it.

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
    ledger[CUT] = 0.0
    count, new = cutting.wanted.shape[0], 0
    memory = state.memory
    for e in range(count):
        if cutting.wanted[e] != 0 and at(memory, cutting.first + e) == 0.0:
            put(memory, cutting.first + e, step + 1.0)
            put(memory, cutting.first + count + e, float(cutting.wanted[e]))
            new += 1
    ledger[CUT_COUNT] = new
    if new == 0:
        return 0
    memory[cutting.first - 1] += new
    # With the rotations as they are; terms that are not below 0 can only make the sum less by going.
    energy, _ = evaluate(force.law, memory, state.position, state.position, state.velocity, 0, lanes)
    held = memory[ENERGY] - energy
    if held > 0.0:
        ledger[CUT] = op.copy_scale * op.firmness * held
        ledger[ELASTIC] -= ledger[CUT]
        memory[ENERGY] = energy
    return new


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
