"""One step of a copy with its user's tools: body, proxies, contacts and grasps solved together.

Without contacts the body's mean velocity is v̂₀. A contact's force changes it along a few columns of A⁻¹, which turns
the whole step into a small problem among contacts and proxies; its solution is put back into the body. One scale over
body and proxies then makes the step's energy identity exact, however early a solve stopped. What the contacts' forces do
in the step that comes out of it goes to the account of each tool.
"""
# pyright: reportArgumentType=false, reportReturnType=false

import math

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._collide import touching
from cotouch.mechanics._columns import read_column, solve_columns
from cotouch.mechanics._contact import sweep
from cotouch.mechanics._grasp import stretch, take
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._operator import Operator, row_sum
from cotouch.mechanics._solve import divide
from cotouch.mechanics._state import ITERATIONS, SUPPLIED, Grips, Links, State, Workspace
from cotouch.mechanics._step import assemble, book_energies, move, port_work, solve_step
from cotouch.mechanics._surface import FOUR, Surface, place_vertex, refit
from cotouch.mechanics._tools import (
    AWAY,
    DRIVE,
    GRASP,
    PROXY,
    TOUCH,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    Tools,
    TouchWork,
)
from cotouch.mechanics._vector import at, load, splat, store, total

Float = npt.NDArray[np.float64]

# Gaps count as contacts up to this share of a radius, and as far as two steps of the proxy carry it.
_MARGIN = 0.05
# What the energy's two sides may differ by: less than rounding does to the sums themselves.
_NOTICED = 1e-16
# Columns need not be better than this: it is the error of a contact's force, not of the books.
_COLUMN_TOLERANCE = 1e-8


@block
def touch_step(
    op: Operator,
    state: State,
    links: Links,
    grips: Grips,
    surface: Surface,
    tools: Tools,
    local_damping: Float,
    extra_damping: Float,
    T: float,
    sample: int,
    work: Workspace,
    touch: TouchWork,
    books: Float,
    touch_books: Float,
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
        grips: what else holds the copy.
        surface: the body's skin.
        tools: the proxies; changed in place.
        local_damping: B_i as coefficients over the weights, (weights,).
        extra_damping: B_e likewise.
        T: length of the step, > 0 [s].
        sample: slot of `links.samples` that receives x̂; negative: none.
        work: scratch.
        touch: scratch.
        books: result (BOOKS,), as of `step`.
        touch_books: result (TOUCH_BOOKS,): see `cotouch.mechanics.TOUCH_BOOKS`.
        link_work: result (links,).
        tolerance: of the solver.
        cap: on its iterations.
        lanes: fixes the width of a row.
    """
    for book in range(touch_books.shape[0]):
        touch_books[book] = 0.0
    axes = _meet(surface, tools, touch, T, state.position, touch_books, lanes)
    assemble(op, state, links, grips, local_damping, extra_damping, T, work, lanes)
    _drive(tools, touch, T)
    modal = surface.shape.shape[0] > 0
    held = _hold(surface, tools, touch, T, state.position, work, modal, lanes)
    if modal:
        ports = _gather(surface, tools, touch, grips, T, work, lanes)
        divide(work.diagonal, work.rhs, work.mean, lanes)
        _correct(touch, ports, work.diagonal, work.mean, lanes)
        books[ITERATIONS] = 0.0
    else:
        ports = 0
        books[ITERATIONS] = solve_step(op, grips, work, tolerance, cap, lanes)
    count = touch.found.count[0]
    first = tools.first
    if count == 0 and held == 0:
        for t in range(tools.first, tools.last):
            for a in range(3):
                touch.mean[3 * (t - first) + a] = touch.drive[3 * (t - first) + a] / touch.inertia[t - first]
    else:
        used = _elements(surface, tools, touch, T, axes, modal, lanes)
        values, scale = op.entries[0] if op.entries.shape[0] == 1 else work.values, _scale(op, work)
        if modal:
            _modal_columns(touch, ports, used, work.diagonal)
        else:
            solve_columns(op, values, scale, work.diagonal, touch.columns, used, max(tolerance, _COLUMN_TOLERANCE), cap)
        _small(tools, touch, T, count * axes, used, work.mean, lanes)
        sweep(
            count,
            axes,
            touch.depth,
            touch.stiffness,
            touch.loss,
            touch.friction,
            touch.free,
            touch.compliance,
            touch.force,
        )
        _back(op, tools, touch, T, count * axes, used, ports, values, scale, work, modal, lanes)
        _settle_contacts(tools, touch, T, count, axes, touch_books, state.position.shape[1] > 1)
    _settle_tools(surface, tools, touch, T, state.position, work.mean, touch_books, lanes)
    books[SUPPLIED] = port_work(op, state, grips, T, work.mean, lanes)
    move(op, state, links, T, sample, work, link_work, lanes)
    book_energies(op, state, local_damping, extra_damping, T, work, books, lanes)


@part
def _scale(op: Operator, work: Workspace) -> float:
    families = op.entries.shape[0]
    return work.scale[0] if families == 1 else 1.0 if families > 1 else 0.0


@part
def _meet(
    surface: Surface,
    tools: Tools,
    touch: TouchWork,
    T: float,
    position: Float,
    touch_books: Float,
    lanes: tuple[int, ...],
) -> int:
    """Finds contacts, takes and lets go, and gives the contacts no more energy than their tools' accounts hold.

    Returns:
        Elements of a contact: 3 if any tool has friction, else 1.
    """
    found = touch.found
    found.count[0] = 0
    axes, near = 1, False
    for t in range(tools.first, tools.last):
        near = near or tools.mode[t] != AWAY
    if near:
        refit(surface, touch.fit, position, lanes)
    for t in range(tools.first, tools.last):
        tools.touching[t] = 0
        for a in range(3):
            tools.touch_force[t, a] = 0.0
        if tools.mode[t] != GRASP and tools.held[t] >= 0:
            touch_books[TOUCH_LOSS] += tools.grip_energy[t]
            tools.grip_energy[t] = 0.0
            tools.held[t] = -1
        if tools.mode[t] == GRASP and tools.held[t] < 0:
            take(surface, touch.fit, tools, t, position, lanes)
        if tools.mode[t] == TOUCH:
            speed = 0.0
            for a in range(3):
                speed += tools.rate[t, a] * tools.rate[t, a]
            margin = _MARGIN * tools.radius[t] + 2.0 * T * math.sqrt(speed)
            within = touching(
                surface,
                touch.fit,
                touch.hits,
                found,
                t,
                tools.place,
                tools.radius[t],
                margin,
                tools.inside[t] != 0,
                position,
                lanes,
            )
            tools.inside[t] = 1 if within else 0
            if tools.friction[t] > 0.0:
                axes = 3
        else:
            tools.inside[t] = 0
    for c in range(found.count[0]):
        t = found.tool[c]
        touch.depth[c] = found.depth[c]
        touch.stiffness[c] = tools.stiffness[t]
        if surface.soft.shape[0] > 0:  # in series with what the shapes of a truncated body leave out
            square = 0.0
            for corner in range(3):
                square += found.share[c, corner] * found.share[c, corner]
            alone, together = surface.soft[found.triangle[c], 0], surface.soft[found.triangle[c], 1]
            soft = together + (alone - together) * square
            touch.stiffness[c] /= 1.0 + soft * tools.stiffness[t]
        touch.loss[c] = tools.loss[t] / T
        touch.friction[c] = tools.friction[t]
    for t in range(tools.first, tools.last):
        wish = 0.0
        for c in range(found.count[0]):
            if found.tool[c] == t and touch.depth[c] > 0.0:
                wish += 0.5 * touch.stiffness[c] * touch.depth[c] * touch.depth[c]
        have = tools.account[t]
        if wish > have:
            ratio = math.sqrt(max(have, 0.0) / wish)
            for c in range(found.count[0]):
                if found.tool[c] == t and touch.depth[c] > 0.0:
                    touch.depth[c] *= ratio
        excess = have - wish - tools.reserve[t]
        if tools.mode[t] != TOUCH:
            excess = have  # nothing to pay for
        if excess > 0.0:
            tools.account[t] = have - excess
            touch_books[TOUCH_LOSS] += excess
    return axes


@part
def _drive(tools: Tools, touch: TouchWork, T: float) -> None:
    """The proxies' own `a ŵ = drive` [Lee & Huang 2010, proxy]."""
    for t in range(tools.first, tools.last):
        p = t - tools.first
        k, b, inertia = tools.drive_stiffness[t], tools.drive_damping[t], 2.0 * tools.mass[t] / T
        touch.inertia[p] = inertia + 0.5 * T * k + b
        for a in range(3):
            start, end = tools.drive_start[t, a], tools.drive_end[t, a]
            wish = 0.5 * k * (start + end) + (b / T) * (end - start) + tools.push[t, a]
            touch.drive[3 * p + a] = inertia * tools.rate[t, a] + wish - k * tools.place[t, a]


@part
def _gain(tools: Tools, t: int, T: float) -> float:
    """Coefficient of a held node's velocity in the force of its spring; 0 where nothing is held."""
    return tools.grip_damping[t] + 0.5 * T * tools.grip_stiffness[t] if tools.held[t] > 0 else 0.0


@part
def _hold(
    surface: Surface,
    tools: Tools,
    touch: TouchWork,
    T: float,
    position: Float,
    work: Workspace,
    modal: bool,
    lanes: tuple[int, ...],
) -> int:
    """Adds the springs of grasps to both sides; returns how many nodes are held."""
    count = 0
    rows, wide = position.shape[0], position.shape[1] > 1
    for t in range(tools.first, tools.last):
        p, gain, k = t - tools.first, _gain(tools, t, T), tools.grip_stiffness[t]
        for c in range(max(tools.held[t], 0)):
            h = tools.hold[t, c]
            count += 1
            touch.inertia[p] += gain
            if modal:
                place_vertex(surface, touch.fit, h, position, lanes)
            for a in range(3):
                pull = k * stretch(surface, touch.fit, tools, t, c, a, position, lanes)
                touch.drive[3 * p + a] += pull
                column = a if wide else 0
                if modal:
                    for i in range(rows):
                        work.rhs[i, column] -= pull * surface.shape[h * rows + i, a]
                else:
                    i = surface.hold_row[h, 0 if wide else a]
                    work.rhs[i, column] -= pull
                    if a == 0 or not wide:
                        work.diagonal[i] += gain
    return count


@part
def _gather(
    surface: Surface,
    tools: Tools,
    touch: TouchWork,
    grips: Grips,
    T: float,
    work: Workspace,
    lanes: tuple[int, ...],
) -> int:
    """Modal: all that acts at single points and so is not diagonal, as ports; factorises `I + √c H D⁻¹ Hᵀ √c`."""
    rows, wide = work.rhs.shape[0], work.rhs.shape[1] > 1
    shape, gain = touch.port_shape, touch.port_gain
    q = 0
    for p in range(grips.first, grips.last):
        for i in range(rows):
            shape[q, i] = grips.shape[p, i]
        gain[q] = math.sqrt(work.port_gain[p - grips.first])
        q += 1
    for t in range(tools.first, tools.last):
        for c in range(max(tools.held[t], 0)):
            for a in range(1 if wide else 3):
                for i in range(rows):
                    shape[q, i] = surface.shape[tools.hold[t, c] * rows + i, a]
                gain[q] = math.sqrt(_gain(tools, t, T))
                q += 1
    factor = touch.port_factor
    for p in range(q):
        for o in range(p + 1):
            product = 0.0
            for i in range(rows):
                product += shape[p, i] * shape[o, i] / work.diagonal[i]
            factor[p, o] = gain[p] * gain[o] * product + (1.0 if o == p else 0.0)
    _factorise(factor, q)
    return q


@part
def _factorise(matrix: Float, size: int) -> None:
    """Cholesky factor in the lower triangle, in place."""
    for p in range(size):
        for q in range(p + 1):
            entry = matrix[p, q]
            for k in range(q):
                entry -= matrix[p, k] * matrix[q, k]
            matrix[p, q] = math.sqrt(entry) if p == q else entry / matrix[q, q]


@part
def _correct(touch: TouchWork, ports: int, diagonal: Float, field: Float, lanes: tuple[int, ...]) -> None:
    """Turns `D⁻¹ b` into `(D + Hᵀ c H)⁻¹ b` (Woodbury)."""
    rows, factor, reading = field.shape[0], touch.port_factor, touch.port_reading
    for p in range(ports):
        value = splat(0.0, lanes)
        for i in range(rows):
            value = value + touch.port_shape[p, i] * load(field, i, lanes)
        value = touch.port_gain[p] * value
        for k in range(p):
            value = value - factor[p, k] * load(reading, k, lanes)
        store(reading, p, (1.0 / factor[p, p]) * value, lanes)
    for back in range(ports):
        p = ports - 1 - back
        value = load(reading, p, lanes)
        for k in range(p + 1, ports):
            value = value - factor[k, p] * load(reading, k, lanes)
        store(reading, p, (1.0 / factor[p, p]) * value, lanes)
    if ports > 0:
        for i in range(rows):
            push = splat(0.0, lanes)
            for p in range(ports):
                push = push + (touch.port_gain[p] * touch.port_shape[p, i]) * load(reading, p, lanes)
            store(field, i, load(field, i, lanes) - (1.0 / diagonal[i]) * push, lanes)


@part
def _elements(
    surface: Surface,
    tools: Tools,
    touch: TouchWork,
    T: float,
    axes: int,
    modal: bool,
    lanes: tuple[int, ...],
) -> int:
    """Directions of the contacts' elements, and the columns of the body that contacts and grasps need.

    Where a body yields alike along all axes, a contact or a grasp has one column; else one for each direction.

    Returns:
        Number of columns.
    """
    found, work = touch.found, touch.columns
    wide = len(lanes) > 1
    used = 0
    for c in range(found.count[0]):
        n = c * axes
        for a in range(3):
            touch.direction[n, a] = found.normal[c, a]
        if axes == 3:
            _tangents(touch.direction, n)
        for j in range(axes):
            touch.force[n + j] = 0.0
            touch.column[n + j] = used
            if wide and j > 0:
                touch.column[n + j] = used - 1
                continue
            _contact_column(surface, touch, c, n + j, used, wide, modal)
            used += 1
    rows = work.answer.shape[1]
    for t in range(tools.first, tools.last):
        touch.grip_column[t - tools.first] = used
        if tools.held[t] <= 0:
            continue
        for a in range(1 if wide else 3):
            if modal:
                for i in range(rows):
                    value = 0.0
                    for c in range(tools.held[t]):
                        value += surface.shape[tools.hold[t, c] * rows + i, a]
                    work.dense[used, i] = value
            else:
                for c in range(tools.held[t]):
                    work.row[used, c] = surface.hold_row[tools.hold[t, c], a]
                    work.value[used, c] = 1.0
                work.entries[used] = tools.held[t]
            used += 1
    return used


@part
def _tangents(direction: Float, n: int) -> None:
    """Two unit vectors across a normal [Duff et al. 2017]."""
    x, y, z = direction[n, 0], direction[n, 1], direction[n, 2]
    sign = 1.0 if z >= 0.0 else -1.0
    a = -1.0 / (sign + z)
    b = x * y * a
    direction[n + 1, 0], direction[n + 1, 1], direction[n + 1, 2] = 1.0 + sign * x * x * a, sign * b, -sign * x
    direction[n + 2, 0], direction[n + 2, 1], direction[n + 2, 2] = b, sign + y * y * a, -y


@part
def _contact_column(
    surface: Surface, touch: TouchWork, c: int, element: int, column: int, wide: bool, modal: bool
) -> None:
    """A unit force at a contact, along its element's direction unless all axes are alike."""
    work, found = touch.columns, touch.found
    rows = work.answer.shape[1]
    triangle = found.triangle[c]
    if modal:
        for i in range(rows):
            work.dense[column, i] = 0.0
    count = 0
    for corner in range(3):
        share = found.share[c, corner]
        if share == 0.0:
            continue
        v = surface.corner[triangle, corner]
        if modal:
            for i in range(rows):
                value = surface.shape[v * rows + i, 0]
                if not wide:
                    value = 0.0
                    for a in range(3):
                        value += touch.direction[element, a] * surface.shape[v * rows + i, a]
                work.dense[column, i] += share * value
        else:
            for k in range(surface.row.shape[1]):
                if surface.weight[v, k] == 0.0:
                    continue
                for a in range(1 if wide else 3):
                    value = share * surface.weight[v, k]
                    if not wide:
                        value *= touch.direction[element, a]
                    work.row[column, count] = surface.row[v, k, a]
                    work.value[column, count] = value
                    count += 1
    work.entries[column] = count


@part
def _modal_columns(touch: TouchWork, ports: int, used: int, diagonal: Float) -> None:
    """`A⁻¹ h_c` where A is diagonal but for ports."""
    work = touch.columns
    for group in range((used + 3) // 4):
        answer = work.answer[group]
        for i in range(diagonal.shape[0]):
            for lane in range(4):
                c = 4 * group + lane
                answer[i, lane] = work.dense[c, i] / diagonal[i] if c < used else 0.0
        _correct(touch, ports, diagonal, answer, FOUR)


@part
def _small(
    tools: Tools,
    touch: TouchWork,
    T: float,
    elements: int,
    used: int,
    mean: Float,
    lanes: tuple[int, ...],
) -> None:
    """The problem among contacts: motion without them, and the matrix R by which their forces take it away."""
    work, first, wide = touch.columns, tools.first, len(lanes) > 1
    size = 3 * (tools.last - first)
    yielding, reading, direction = touch.yielding, touch.reading, touch.direction
    for c in range(used):
        for o in range(c + 1):
            value = read_column(work, c, work.answer[o // 4], o % 4)
            yielding[c, o] = value
            yielding[o, c] = value
        for a in range(3 if wide else 1):
            reading[c, a] = read_column(work, c, mean, a)
    for i in range(size):
        for j in range(size):
            touch.proxies[i, j] = 0.0
    for t in range(first, tools.last):
        p, gain, g = t - first, _gain(tools, t, T), touch.grip_column[t - first]
        for a in range(3):
            row = 3 * p + a
            touch.proxies[row, row] = touch.inertia[p]
            touch.mean[row] = touch.drive[row]
            for j in range(elements):
                own = touch.found.tool[touch_contact(j, elements, touch.found.count[0])] == t
                touch.lever[row, j] = direction[j, a] if own else 0.0
            if gain > 0.0:
                column = g if wide else g + a
                touch.mean[row] += gain * (reading[g, a] if wide else reading[column, 0])
                for j in range(elements):
                    share = direction[j, a] if wide else 1.0
                    touch.lever[row, j] -= gain * share * yielding[column, touch.column[j]]
        if gain > 0.0:
            for s in range(first, t + 1):
                q, other, h = s - first, _gain(tools, s, T), touch.grip_column[s - first]
                if other > 0.0:
                    for a in range(3):
                        for b in range(3):
                            if not wide:
                                touch.proxies[3 * p + a, 3 * q + b] -= gain * other * yielding[g + a, h + b]
                            elif a == b:
                                touch.proxies[3 * p + a, 3 * q + b] -= gain * other * yielding[g, h]
    _factorise(touch.proxies, size)
    _substitute(touch.proxies, size, touch.mean)
    for j in range(elements):
        for i in range(size):
            touch.solved[i, j] = touch.lever[i, j]
        _substitute_column(touch.proxies, size, touch.solved, j)
    for j in range(elements):
        free = 0.0
        for a in range(3 if wide else 1):
            free += (direction[j, a] if wide else 1.0) * reading[touch.column[j], a]
        for i in range(size):
            free -= touch.lever[i, j] * touch.mean[i]
        touch.free[j] = T * free
        for k in range(j + 1):
            share = 1.0
            if wide:
                share = 0.0
                for a in range(3):
                    share += direction[j, a] * direction[k, a]
            value = share * yielding[touch.column[j], touch.column[k]]
            for i in range(size):
                value += touch.lever[i, j] * touch.solved[i, k]
            touch.compliance[j, k] = T * value
            touch.compliance[k, j] = T * value


@part
def touch_contact(element: int, elements: int, count: int) -> int:
    """Contact of an element."""
    return element // (elements // count)


@part
def _substitute(factor: Float, size: int, values: Float) -> None:
    """Solves with a Cholesky factor, in place."""
    for i in range(size):
        for k in range(i):
            values[i] -= factor[i, k] * values[k]
        values[i] /= factor[i, i]
    for back in range(size):
        i = size - 1 - back
        for k in range(i + 1, size):
            values[i] -= factor[k, i] * values[k]
        values[i] /= factor[i, i]


@part
def _substitute_column(factor: Float, size: int, values: Float, j: int) -> None:
    """The same for a column of a matrix."""
    for i in range(size):
        for k in range(i):
            values[i, j] -= factor[i, k] * values[k, j]
        values[i, j] /= factor[i, i]
    for back in range(size):
        i = size - 1 - back
        for k in range(i + 1, size):
            values[i, j] -= factor[k, i] * values[k, j]
        values[i, j] /= factor[i, i]


@part
def _back(
    op: Operator,
    tools: Tools,
    touch: TouchWork,
    T: float,
    elements: int,
    used: int,
    ports: int,
    values: Float,
    scale: float,
    work: Workspace,
    modal: bool,
    lanes: tuple[int, ...],
) -> None:
    """Puts forces into body and proxies, and scales both so that the step's work is what its energy changes by."""
    first, wide, mean = tools.first, len(lanes) > 1, work.mean
    rows, width, size = mean.shape[0], 3 if wide else 1, 3 * (tools.last - first)
    columns = touch.columns
    for i in range(size):
        for j in range(elements):
            touch.mean[i] += touch.solved[i, j] * touch.force[j]
    for c in range(used):
        for a in range(3):
            touch.load[c, a] = 0.0
    for j in range(elements):
        for a in range(width):
            touch.load[touch.column[j], a] -= (touch.direction[j, a] if wide else 1.0) * touch.force[j]
    for t in range(first, tools.last):
        p, gain, g = t - first, _gain(tools, t, T), touch.grip_column[t - first]
        if gain > 0.0:
            for a in range(3):
                if wide:
                    touch.load[g, a] = gain * touch.mean[3 * p + a]
                else:
                    touch.load[g + a, 0] = gain * touch.mean[3 * p + a]
    base = splat(0.0, lanes)  # v̂₀ᵀ b, which is v̂₀ᵀ A v̂₀
    for i in range(rows):
        base = base + load(mean, i, lanes) * load(work.rhs, i, lanes)
    supplied = total(base)
    used_up = supplied
    if modal:
        extra, form = _add_modal(touch, used, ports, work, lanes)
    else:
        extra, form = _add_nodal(op, touch, used, values, scale, work, lanes)
    supplied += extra
    used_up += form
    for c in range(used):
        for a in range(width):
            touch.reading[c, a] = read_column(columns, c, mean, a)
            # Forces of contacts are given; those of grasps are springs, and belong to the form.
            if c < touch.grip_column[0]:
                supplied += touch.load[c, a] * touch.reading[c, a]
    for j in range(elements):
        t = touch.found.tool[touch_contact(j, elements, touch.found.count[0])]
        for a in range(3):
            supplied += touch.force[j] * touch.direction[j, a] * touch.mean[3 * (t - first) + a]
    for t in range(first, tools.last):
        p, gain, g = t - first, _gain(tools, t, T), touch.grip_column[t - first]
        for a in range(3):
            w = touch.mean[3 * p + a]
            supplied += w * touch.drive[3 * p + a]
            used_up += w * w * touch.inertia[p]
            if gain > 0.0:
                v = touch.reading[g, a] if wide else touch.reading[g + a, 0]
                used_up -= 2.0 * gain * w * v
    if used_up > 0.0 and abs(supplied - used_up) > _NOTICED * supplied:
        factor = max(supplied, 0.0) / used_up
        for i in range(rows):
            store(mean, i, factor * load(mean, i, lanes), lanes)
        for i in range(size):
            touch.mean[i] *= factor
        for c in range(used):
            for a in range(width):
                touch.reading[c, a] *= factor


@part
def _settle_contacts(
    tools: Tools, touch: TouchWork, T: float, count: int, axes: int, touch_books: Float, wide: bool
) -> None:
    """What the contacts' forces did in the step that came of them: to the body, and to the accounts."""
    for c in range(count):
        t = touch.found.tool[c]
        if touch.force[c * axes] > 0.0:
            tools.touching[t] += 1
        for j in range(c * axes, c * axes + axes):
            force, body, proxy = touch.force[j], 0.0, 0.0
            for a in range(3):
                direction = touch.direction[j, a]
                proxy += direction * touch.mean[3 * (t - tools.first) + a]
                tools.touch_force[t, a] += force * direction
                if wide:
                    body += direction * touch.reading[touch.column[j], a]
            if not wide:
                body = touch.reading[touch.column[j], 0]
            touch_books[TOUCHED] -= T * force * body
            tools.account[t] += T * force * (body - proxy)


@part
def _settle_tools(
    surface: Surface,
    tools: Tools,
    touch: TouchWork,
    T: float,
    position: Float,
    mean: Float,
    touch_books: Float,
    lanes: tuple[int, ...],
) -> None:
    """Forces, work and energies of drives and grasps; new places and velocities."""
    for t in range(tools.first, tools.last):
        p, k, b = t - tools.first, tools.drive_stiffness[t], tools.drive_damping[t]
        kb, bb = tools.grip_stiffness[t], tools.grip_damping[t]
        square = 0.0
        tools.drive_force[t, 3] = 0.0
        if tools.held[t] > 0:
            tools.grip_energy[t] = 0.0
            tools.touching[t] = tools.held[t]
        for a in range(3):
            w = touch.mean[3 * p + a]
            start, end = tools.drive_start[t, a], tools.drive_end[t, a]
            force = k * (0.5 * (start + end) - tools.place[t, a] - 0.5 * T * w) + b * ((end - start) / T - w)
            force += tools.push[t, a]
            tools.drive_force[t, a] = force
            touch_books[DRIVE] += T * force * w
            for c in range(max(tools.held[t], 0)):
                before = stretch(surface, touch.fit, tools, t, c, a, position, lanes)
                v = _held_rate(surface, tools.hold[t, c], a, mean)
                pull = kb * (before + 0.5 * T * (v - w)) + bb * (v - w)  # on the proxy
                after = before + T * (v - w)
                tools.touch_force[t, a] += pull
                tools.grip_energy[t] += 0.5 * kb * after * after
                touch_books[TOUCHED] -= T * pull * v
                touch_books[TOUCH_LOSS] += T * bb * (v - w) * (v - w)
        for a in range(3):
            w = touch.mean[3 * p + a]
            tools.place[t, a] += T * w
            tools.rate[t, a] = 2.0 * w - tools.rate[t, a]
            square += tools.rate[t, a] * tools.rate[t, a]
        touch_books[PROXY] += 0.5 * tools.mass[t] * square
        touch_books[TOUCH_STORED] += tools.account[t] + tools.grip_energy[t]


@part
def _held_rate(surface: Surface, hold: int, axis: int, mean: Float) -> float:
    """Mean velocity of something held along an axis [m/s]."""
    axes, rows = surface.hold_row.shape[1], mean.shape[0]
    if axes == 1:
        return mean[surface.hold_row[hold, 0], axis]
    if axes == 3:
        return mean[surface.hold_row[hold, axis], 0]
    column = axis if mean.shape[1] > 1 else 0
    rate = 0.0
    for i in range(rows):
        rate += surface.shape[hold * rows + i, axis] * mean[i, column]
    return rate


@part
def _add_nodal(
    op: Operator, touch: TouchWork, used: int, values: Float, scale: float, work: Workspace, lanes: tuple[int, ...]
) -> tuple[float, float]:
    """Adds `y = Σ A⁻¹ h_c load_c` to v̂, where the columns reach.

    Returns:
        `yᵀ b` and `yᵀ A (2 v̂ + y)`: what v̂ᵀ b and v̂ᵀ A v̂ grow by.
    """
    columns, mean = touch.columns, work.mean
    y = columns.direction  # zero everywhere, and again when this is done
    reached, width = columns.size[0], 3 if len(lanes) > 1 else 1
    for place in range(reached):
        i = at(columns.reach, place)
        step = splat(0.0, FOUR)
        for c in range(used):
            entry = ((c // 4) * mean.shape[0] + i) * 4 + c % 4
            step = step + at(columns.answer, entry) * load(touch.load, c, FOUR)
        store(y, i, step, FOUR)
    gain, form = splat(0.0, FOUR), splat(0.0, FOUR)
    for place in range(reached):
        i = at(columns.reach, place)
        own = load(y, i, FOUR)
        gain = gain + own * load(work.rhs, i, lanes)
        # Twice what v̂ has and once what y has; in a field of one column y has only its first lane.
        image = 2.0 * (at(work.diagonal, i) * load(mean, i, lanes) + scale * row_sum(op, values, i, mean, lanes))
        form = form + own * (at(work.diagonal, i) * own + scale * row_sum(op, values, i, y, FOUR) + image)
    for place in range(reached):
        i = at(columns.reach, place)
        for a in range(width):
            mean[i, a] += y[i, a]
    for place in range(reached):
        store(y, at(columns.reach, place), splat(0.0, FOUR), FOUR)
    return total(gain), total(form)


@part
def _add_modal(touch: TouchWork, used: int, ports: int, work: Workspace, lanes: tuple[int, ...]) -> tuple[float, float]:
    """The same where A is diagonal but for ports."""
    columns, mean = touch.columns, work.mean
    rows, width = mean.shape[0], 3 if len(lanes) > 1 else 1
    gain = form = 0.0
    for p in range(ports):
        reading = splat(0.0, lanes)
        for i in range(rows):
            reading = reading + touch.port_shape[p, i] * load(mean, i, lanes)
        form -= touch.port_gain[p] * touch.port_gain[p] * total(reading * reading)
    for i in range(rows):
        for a in range(width):
            y = 0.0
            for c in range(used):
                y += columns.answer[c // 4, i, c % 4] * touch.load[c, a]
            gain += y * work.rhs[i, a]
            form += work.diagonal[i] * y * (2.0 * mean[i, a] + y)
            mean[i, a] += y
    for p in range(ports):
        reading = splat(0.0, lanes)
        for i in range(rows):
            reading = reading + touch.port_shape[p, i] * load(mean, i, lanes)
        form += touch.port_gain[p] * touch.port_gain[p] * total(reading * reading)
    return gain, form
