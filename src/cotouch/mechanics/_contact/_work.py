"""What a step with a contact law works on."""

from typing import Any, NamedTuple

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.mechanics._contact._patch import FOUND
from cotouch.mechanics._linear._state import CHANGES
from cotouch.mechanics._model._fit import Fit, fit_of
from cotouch.mechanics._model._model import Model
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import MOST_HELD
from cotouch.passing import by_address

_STACK = 64
# How nearly all nodes of a body must go alike that goes as a whole.
_WHOLE = 1e-9


@by_address
class ContactWork(NamedTuple):
    """Scratch of one step; the tools of a copy are counted from 0.

    Attributes:
        fit: where the skin is at the start of the step.
        stack: boxes still to be looked at, (_STACK,).
        number: triangles near each tool, (tools,).
        near: which, (tools, F).
        span: of fours of these: the first, and between which of its balls those are that may reach them, (F / 4, 3).
        clear: how far the middle of each tool is from all triangles at least, (tools,) [m].
        hits: how many of these the last look found to do something, (tools,).
        hit: which of the near ones, (tools, F).
        load: share of the corners of each near one in the tool's pressure [N], and 1 if it is one, (tools * F, 4).
        total: their sum, (tools,) [N].
        patch: area at rest of the skin within each tool, (tools,) [m²].
        across: force of friction, film and damping on each tool, (tools, 4) [N].
        rate: velocity of the vertices, (V, 4) [m/s].
        vertices: how many belong to those near each tool, (tools,).
        vertex: which, (tools, V).
        read: when a vertex was found to be near last, (V,).
        turn: how often such were looked for, (1,).
        force: on the vertices, (V, 4) [N].
        firm: what resists motion of the vertices, (V,) [Ns/m].
        ward: what presses on each vertex, (V, 4) [N].
        apart: what resists motion of the vertices on all axes besides, (V,) [Ns/m].
        push: on the rows, (rows, width) [N].
        hold: what resists motion of the rows, (rows,) [Ns/m].
        reach: rows that are touched, and after them such as a correction reaches, (rows,).
        many: how many are touched, (1,).
        mark: 1 more than a row's place among them, (rows,).
        stiff: what resists motion of each of them, a matrix of its axes, (3 rows, width) [Ns/m].
        inverse: of its diagonal with the body's own, (rows, width).
        said: what the last solve took contacts and grasps to do, (rows, width) [N].
        missed: what forces did on touched rows beside that, (rows, width) [N].
        along: scratch of a correction, 0 outside of it, (rows, width).
        quick: a bound on the speed of every vertex by the present guess, (1,) [m/s].
        goal: what corrections of this step may leave of work, negative before the first [W]; how much of the last was
            made, and what it missed; at the end how much of its way a step went, where it was held back, (3,).
        given: of a linear body: `v̂ᵀ b` of its system without contacts, and `v̂ᵀ (A v̂ - b)`, (2,) [W].
        own: diagonal of the body's system without contacts, while touched rows have more, (rows,) [Ns/m].
        asked: its right-hand side likewise, (rows, width) [N].
        found: where the last look led, (rows, width) [m/s]; of a modal body what the last look pushed with [N].
        yields: of a modal body: how much of what contacts and grasps do by a guess its answer takes back, on each
            axis, (3,).
        spot: corners and middle, (4, 4) [m].
        met: where four triangles lie in a ball, as `overlap` finds it, (FOUND, 4).
        out: of one triangle, (4, 4).
        drawn: of one that draws a tool, (4, 4).
        mean: mean velocity of the tools, (tools, 4) [m/s].
        drive: of the tools without contact, (tools, 4) [N].
        inertia: likewise, (tools,) [Ns/m].
        pull: force of the contact on the tools, (tools, 4) [N].
        lacks: what a motion that is sought misses of the forces on the tools, (tools, 4) [N].
        kept: as of `Sought`.
        grips: as `grip`, of looks that are kept, (tools, 4) [Ns/m].
        before: the same a look earlier, (tools, 4) [N].
        way: unit vector of the pressure on the tools, and its size [N], (tools, 4).
        grip: what resists motion of the tools along it and across, (tools, 2) [Ns/m].
        skin: how fast the skin moves under the tools, on the mean over their pressure, (tools, 4) [m/s].
        held: of the springs of a grasp: squares of their stretches at the start [m²], these times how fast they grow
            [m²/s], and squares of that [m²/s²], (tools, 3).
        caught: of a tool that would pass the skin: by what it is held, the triangle, whether a look before held it,
            how far a push moves both at most [m/N], whether it goes with what it touches, the gap wanted, the shares of
            the corners, the ball's place on the axis, and the most that it is pushed with [N], (tools, 11).
        aside: unit vector that a caught tool is held along, where it lacked to be a look before [m], and the push then
            [N], (3 tools, 4).
        rubbed: stretch of friction at the end, (tools, 4) [m].
        slips: whether it slips then, (tools,).
        stored: energy in contact and friction, or in a grasp, then, and what draws the tool, (tools,) [J].
        pressed: energy in the pressure on each at the start, and as it was worked out last, (tools, 2) [J].
        well: energy in what draws it, by the last look or then; 0: nothing does, (tools,) [J].
        slow: whether a tool and the skin go so little in a step that their mean force is that in the middle, (tools,).
        seen: how far each tool looked around, (tools,) [m].
        whole: the rows of a body that moves as a whole along each axis, 0 where they cannot, (3, rows, width).
    """

    fit: Fit
    stack: Int
    number: Int
    near: Int
    span: Int
    clear: Float
    hits: Int
    hit: Int
    load: Float
    total: Float
    patch: Float
    across: Float
    rate: Float
    vertices: Int
    vertex: Int
    read: Int
    turn: Int
    force: Float
    firm: Float
    ward: Float
    apart: Float
    push: Float
    hold: Float
    reach: Int
    many: Int
    mark: Int
    stiff: Float
    inverse: Float
    said: Float
    missed: Float
    along: Float
    quick: Float
    goal: Float
    given: Float
    own: Float
    asked: Float
    found: Float
    yields: Float
    spot: Float
    met: Float
    out: Float
    drawn: Float
    mean: Float
    drive: Float
    inertia: Float
    pull: Float
    lacks: Float
    kept: Float
    grips: Float
    before: Float
    way: Float
    grip: Float
    skin: Float
    held: Float
    caught: Float
    aside: Float
    rubbed: Float
    slips: Int
    stored: Float
    pressed: Float
    well: Float
    slow: Int
    seen: Float
    whole: Float


@by_address
class Contact(NamedTuple):
    """How tools touch by a law.

    Attributes:
        law: one of `CONTACT_LAWS`.
        work: scratch.
    """

    law: Any
    work: ContactWork


def contact_by(law: Any, model: Model, surface: Surface, *, tools: int) -> Contact:
    """A law and scratch for steps with at most so many tools of one user.

    Args:
        law: of the contact.
        model: the body.
        surface: its skin.
        tools: of one user.
    """
    faces, vertices, rows = surface.corner.shape[0], surface.rest.shape[0], model.operator_rows
    most = min(rows, np.unique(surface.row).size + 3 * tools * MOST_HELD)  # rows that can be touched at once
    row = lambda: np.zeros((tools, 4))  # noqa: E731
    work = ContactWork(
        fit=fit_of(surface, model),
        stack=np.zeros(_STACK, dtype=np.int32),
        number=np.zeros(tools, dtype=np.int32),
        near=np.zeros((tools, faces), dtype=np.int32),
        span=np.zeros((-(-faces // 4), 3), dtype=np.int32),
        clear=np.zeros(tools),
        hits=np.zeros(tools, dtype=np.int32),
        hit=np.zeros((tools, faces), dtype=np.int32),
        load=np.zeros((tools * faces, 4)),
        total=np.zeros(tools),
        patch=np.zeros(tools),
        across=row(),
        rate=np.zeros((vertices, 4)),
        vertices=np.zeros(tools, dtype=np.int32),
        vertex=np.zeros((tools, vertices), dtype=np.int32),
        read=np.zeros(vertices, dtype=np.int32),
        turn=np.zeros(1, dtype=np.int32),
        force=np.zeros((vertices, 4)),
        firm=np.zeros(vertices),
        ward=np.zeros((vertices, 4)),
        apart=np.zeros(vertices),
        push=np.zeros((rows, model.width)),
        hold=np.zeros(rows),
        reach=np.zeros(rows, dtype=np.int32),
        many=np.zeros(1, dtype=np.int32),
        mark=np.zeros(rows, dtype=np.int32),
        stiff=np.zeros((3 * most, model.width)),
        inverse=np.zeros((most, model.width)),
        said=np.zeros((rows, model.width)),
        missed=np.zeros((rows, model.width)),
        along=np.zeros((rows, model.width)),
        quick=np.zeros(1),
        goal=np.zeros(3),
        given=np.zeros(2),
        own=np.zeros(rows),
        asked=np.zeros((rows, model.width)),
        found=np.zeros((rows, model.width)),
        yields=np.zeros(3),
        spot=np.zeros((4, 4)),
        met=np.zeros((FOUND, 4)),
        out=np.zeros((4, 4)),
        drawn=np.zeros((4, 4)),
        mean=row(),
        drive=row(),
        inertia=np.zeros(tools),
        pull=row(),
        lacks=row(),
        kept=np.zeros(((2 + 2 * CHANGES) * tools, 4)),
        grips=row(),
        before=row(),
        way=row(),
        grip=np.zeros((tools, 2)),
        skin=row(),
        held=np.zeros((tools, 3)),
        caught=np.zeros((tools, 11)),
        aside=np.zeros((3 * tools, 4)),
        rubbed=row(),
        slips=np.zeros(tools, dtype=np.int32),
        stored=np.zeros(tools),
        pressed=np.zeros((tools, 2)),
        well=np.zeros(tools),
        slow=np.zeros(tools, dtype=np.int32),
        seen=np.zeros(tools),
        whole=np.array([_whole(model, axis) for axis in range(3)]),
    )
    return Contact(law, work)


def _whole(model: Model, axis: int) -> Float:
    """The rows of a body that moves along an axis as a whole; 0 where the shapes of a truncated body lack that."""
    field = np.zeros((model.body.nodes, model.body.dimension))
    field[:, axis : axis + 1] = 1.0
    rows = model.to_rows(field)
    return rows if np.allclose(model.to_nodes(rows), field, atol=_WHOLE) else np.zeros_like(rows)
