"""One step of a copy with its user's tools: body, proxies, contacts and grasps solved together.

Without contacts the body's mean velocity is v̂₀. A contact's force changes it along a few columns of A⁻¹, which turns
the whole step into a small problem among contacts and proxies; its solution is put back into the body. One scale over
body and proxies then makes the step's energy identity exact, however early a solve stopped. What the contacts' forces
do in the step that comes out of it goes to the account of each tool.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

from cotouch.arrays import Float
from cotouch.mechanics._collide import Contacts, Hits, touching
from cotouch.mechanics._columns import Columns, solve_columns
from cotouch.mechanics._contact import sweep
from cotouch.mechanics._elements import elements, gather, hold, modal_columns
from cotouch.mechanics._grasp import take
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._modal_ports import correct
from cotouch.mechanics._operator import Operator
from cotouch.mechanics._proxy import proxy_drive, proxy_inertia
from cotouch.mechanics._put_back import put_back
from cotouch.mechanics._settle import settle_contacts, settle_tools
from cotouch.mechanics._small import Small, limit, reduce_step, sound
from cotouch.mechanics._solve import divide
from cotouch.mechanics._state import ITERATIONS, SUPPLIED, Links, Ports, State, Workspace
from cotouch.mechanics._step import assemble, book_energies, move, port_work, solve_step
from cotouch.mechanics._surface import Fit, Surface, refit
from cotouch.mechanics._tools import AWAY, GRASP, TOUCH, TOUCH_LOSS, Tools, TouchWork

# Gaps count as contacts up to this share of a radius, and as far as two steps of the proxy carry it.
_MARGIN = 0.05
# Columns need not be better than this, nor than the solver's own tolerance to the power ¾: what they leave out is a
# share of what a contact's force changes by from step to step, in the body's motion and not in the ledger.
_COLUMN_TOLERANCE = 1e-9


@block
def touch_step(
    op: Operator,
    state: State,
    links: Links,
    ports: Ports,
    surface: Surface,
    tools: Tools,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    work: Workspace,
    touch: TouchWork,
    ledger: Float,
    touch_ledger: Float,
    link_work: Float,
    tolerance: float,
    cap: int,
    lanes: tuple[int, ...],
) -> None:
    """Advances one copy and its tools by T; see `step`, whose arguments these are.

    Args:
        op: the body's matrices.
        state: of the copy; changed in place.
        links: the neighbours' samples.
        ports: what else holds the copy.
        surface: the body's skin.
        tools: the proxies; changed in place.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step, > 0 [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: scratch.
        touch: scratch.
        ledger: result (BOOKS,), as of `step`.
        touch_ledger: result (TOUCH_BOOKS,): see `cotouch.mechanics.TOUCH_LEDGER`.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    for book in range(touch_ledger.shape[0]):
        touch_ledger[book] = 0.0
    fit, found, columns, small, modal_ports = touch.fit, touch.found, touch.columns, touch.small, touch.modal_ports
    position, rhs, mean, diagonal = state.position, work.rhs, work.mean, work.diagonal
    first, last, pushes = tools.first, tools.last, small.force
    wide, modal = len(lanes) > 1, surface.shape.shape[0] > 0
    axes = _meet(surface, fit, touch.hits, found, tools, T, position, touch_ledger, lanes)
    _charge(surface.soft, found, small, tools, T, touch_ledger)
    assemble(op, state, links, ports, local_damping, extra_damping, T, work, lanes)
    _drive(tools, small, T)
    held = hold(surface, fit, tools, small, T, position, rhs, diagonal, lanes)
    contacts = found.number[0]
    used = elements(surface, tools, found, columns, small, axes, lanes) if contacts + held > 0 else 0
    _guess(found, columns, small, tools, axes, rhs, modal)
    port_count = 0
    if modal:
        port_count = gather(
            surface.shape,
            tools.held,
            tools.hold,
            first,
            last,
            small.grip_gain,
            modal_ports,
            ports,
            work.port_gain,
            diagonal,
            wide,
        )
        divide(diagonal, rhs, mean, lanes)
        correct(modal_ports, port_count, diagonal, mean, lanes)
        ledger[ITERATIONS] = 0.0
    else:
        ledger[ITERATIONS] = solve_step(op, ports, work, tolerance, cap, lanes)
    if contacts == 0 and held == 0:
        for i in range(3 * (last - first)):
            small.mean[i] = small.drive[i] / small.inertia[i // 3]
    else:
        families = op.entries.shape[0]
        values = op.entries[0] if families == 1 else work.values
        scale = work.scale[0] if families == 1 else 1.0 if families > 1 else 0.0
        coarse = 0.0
        if modal:
            modal_columns(columns.dense, columns.answer, modal_ports, port_count, used, diagonal)
        else:
            coarse = max(tolerance**0.75, _COLUMN_TOLERANCE)
            solve_columns(op, values, scale, diagonal, columns, used, coarse, cap)
        count = contacts * axes
        reduce_step(columns, small, T, last - first, count, used, mean)
        sweep(
            contacts,
            axes,
            small.depth,
            small.stiffness,
            small.loss,
            small.friction,
            small.free,
            small.compliance,
            pushes,
            small.trail,
        )
        limit(small, count, tools.account, first, last - first, coarse)
        if not sound(small, count, tools.account, first, last - first, 1.0, False):
            for j in range(count):
                pushes[j] = 0.0
        put_back(
            op,
            columns,
            small,
            modal_ports,
            T,
            tools.account,
            first,
            last - first,
            count,
            used,
            port_count,
            values,
            scale,
            diagonal,
            rhs,
            mean,
            modal,
            lanes,
        )
        settle_contacts(tools, small, T, contacts, axes, touch_ledger)
    settle_tools(surface, fit, tools, small.mean, T, position, mean, touch_ledger)
    ledger[SUPPLIED] = port_work(op, state, ports, T, mean, lanes)
    move(op, state, links, T, sample, work, link_work, lanes)
    book_energies(op, state, local_damping, extra_damping, T, work, ledger, lanes)


@part
def _meet(
    surface: Surface,
    fit: Fit,
    hits: Hits,
    found: Contacts,
    tools: Tools,
    T: float,
    position: Float,
    touch_ledger: Float,
    lanes: tuple[int, ...],
) -> int:
    """Finds contacts, takes and lets go.

    Returns:
        Elements of a contact: 3 if any tool that touches has friction, else 1.
    """
    first, last, mode, held = tools.first, tools.last, tools.mode, tools.held
    place, rate, radius, inside = tools.place, tools.rate, tools.radius, tools.inside
    friction, grip_energy, touching_now = tools.friction, tools.grip_energy, tools.touching
    found.number[0] = 0
    axes, near = 1, False
    for t in range(first, last):
        near = near or mode[t] != AWAY
    if near:
        refit(surface, fit, position, lanes)
    for t in range(first, last):
        touching_now[t] = 0
        if mode[t] != GRASP and held[t] >= 0:
            touch_ledger[TOUCH_LOSS] += grip_energy[t]
            grip_energy[t] = 0.0
            held[t] = -1
        if mode[t] == GRASP and held[t] < 0:
            take(surface, fit, tools, t, position, lanes)
        within = False
        if mode[t] == TOUCH:
            speed = 0.0
            for a in range(3):
                speed += rate[t, a] * rate[t, a]
            margin = _MARGIN * radius[t] + 2.0 * T * math.sqrt(speed)
            within = touching(surface, fit, hits, found, t, place, radius[t], margin, inside[t] != 0, position, lanes)
            if friction[t] > 0.0:
                axes = 3
        inside[t] = 1 if within or mode[t] != TOUCH else 0  # where nobody looked, it may be
    return axes


@part
def _charge(soft: Float, found: Contacts, small: Small, tools: Tools, T: float, touch_ledger: Float) -> None:
    """Gives the springs of the contacts no more energy than their tools' accounts hold, and clears the rest."""
    tool, found_depth, count = found.tool, found.depth, found.number[0]
    triangle, barycentric = found.triangle, found.barycentric
    depth, stiffness, loss, friction = small.depth, small.stiffness, small.loss, small.friction
    account, mode, reserve = tools.account, tools.mode, tools.reserve
    own_stiffness, own_loss, own_friction = tools.stiffness, tools.loss, tools.friction
    for c in range(count):
        t = tool[c]
        depth[c] = found_depth[c]
        stiffness[c] = own_stiffness[t]
        if soft.shape[0] > 0:  # in series with what the shapes of a truncated body leave out
            square = 0.0
            for corner in range(3):
                square += barycentric[c, corner] * barycentric[c, corner]
            alone, together = soft[triangle[c], 0], soft[triangle[c], 1]
            stiffness[c] /= 1.0 + (together + (alone - together) * square) * own_stiffness[t]
        loss[c] = own_loss[t] / T
        friction[c] = own_friction[t]
    for t in range(tools.first, tools.last):
        desired = 0.0
        for c in range(count):
            if tool[c] == t and depth[c] > 0.0:
                desired += 0.5 * stiffness[c] * depth[c] * depth[c]
        have = account[t]
        if desired > max(have, 0.0):
            ratio = math.sqrt(max(have, 0.0) / desired)
            for c in range(count):
                if tool[c] == t and depth[c] > 0.0:
                    depth[c] *= ratio
        excess = have - desired - reserve[t]
        if mode[t] != TOUCH:
            excess = have  # nothing to pay for
        if excess > 0.0:
            account[t] = have - excess
            touch_ledger[TOUCH_LOSS] += excess


@part
def _guess(found: Contacts, columns: Columns, small: Small, tools: Tools, axes: int, rhs: Float, modal: bool) -> None:
    """Takes the forces on each tool to be those of the step before, for the solve that does not know them yet.

    Whatever the guess, the forces come out right; a good one leaves little for the columns, whose error then matters
    little, too.
    """
    guess, direction, column, force = small.guess, small.direction, small.column, small.force
    tool, count, before = found.tool, found.number[0], tools.touch_force
    wide = rhs.shape[1] > 1
    for c in range(count):
        t, alike = tool[c], 0
        for other in range(count):
            if tool[other] == t:
                alike += 1
        for n in range(c * axes, c * axes + axes):
            value = 0.0
            for a in range(3):
                value += before[t, a] * direction[n, a] / alike
            if n == c * axes:
                value = max(value, 0.0)
            elif tools.friction[t] == 0.0:
                value = 0.0  # nothing would ever take it away again
            guess[n] = value
            force[n] = value
            h = column[n]
            for a in range(3 if wide else 1):
                pull = value * (direction[n, a] if wide else 1.0)
                if modal:
                    for i in range(rhs.shape[0]):
                        rhs[i, a] -= pull * columns.dense[h, i]
                else:
                    for e in range(columns.entries[h]):
                        rhs[columns.row[h, e], a] -= pull * columns.value[h, e]
    for t in range(tools.first, tools.last):
        for a in range(3):
            before[t, a] = 0.0


@part
def _drive(tools: Tools, small: Small, T: float) -> None:
    """What each proxy does without contacts."""
    for t in range(tools.first, tools.last):
        p = t - tools.first
        small.inertia[p] = proxy_inertia(tools, t, T)
        for a in range(3):
            small.drive[3 * p + a] = proxy_drive(tools, t, a, T)
