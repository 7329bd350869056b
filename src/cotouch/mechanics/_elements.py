"""How contacts and grasps of a step read and load the body: their springs, their directions, their columns."""
# pyright: reportArgumentType=false, reportReturnType=false

import math

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._collide import Contacts
from cotouch.mechanics._columns import Columns
from cotouch.mechanics._grasp import held_place
from cotouch.mechanics._kernel import block, part
from cotouch.mechanics._modal_ports import ModalPorts, correct, factorise_ports
from cotouch.mechanics._small import Small
from cotouch.mechanics._state import Ports
from cotouch.mechanics._surface import FOUR, Fit, Surface, place_vertex
from cotouch.mechanics._tools import MOST_HELD, Tools

Int = npt.NDArray[np.int32]


@part
def hold(
    surface: Surface,
    fit: Fit,
    tools: Tools,
    small: Small,
    T: float,
    position: Float,
    rhs: Float,
    diagonal: Float,
    lanes: tuple[int, ...],
) -> int:
    """Adds the springs of grasps to both sides, the body's and the proxies'; returns how many nodes are held."""
    shape, hold_row, rest, moved = surface.shape, surface.hold_row, surface.rest, fit.place
    first, held, hold_of = tools.first, tools.held, tools.hold
    stiffness, damping, centre, offset = tools.grip_stiffness, tools.grip_damping, tools.place, tools.offset
    grip_gain, inertia, drive = small.grip_gain, small.inertia, small.drive
    rows, wide, modal = position.shape[0], position.shape[1] > 1, shape.shape[0] > 0
    count = 0
    for t in range(first, tools.last):
        p, k = t - first, stiffness[t]
        gain = damping[t] + 0.5 * T * k if held[t] > 0 else 0.0
        grip_gain[p] = gain
        for c in range(max(held[t], 0)):
            h = hold_of[t, c]
            count += 1
            inertia[p] += gain
            if modal:
                place_vertex(surface, fit, h, position, lanes)
            for a in range(3):
                place = held_place(hold_row, rest, moved, h, a, position)
                pull = k * (place - centre[t, a] - offset[t * MOST_HELD + c, a])
                drive[3 * p + a] += pull
                column = a if wide else 0
                if modal:
                    for i in range(rows):
                        rhs[i, column] -= pull * shape[h * rows + i, a]
                else:
                    i = hold_row[h, 0 if wide else a]
                    rhs[i, column] -= pull
                    if a == 0 or not wide:
                        diagonal[i] += gain
    return count


@part
def gather(
    surface_shape: Float,
    held: Int,
    hold_of: Int,
    first: int,
    last: int,
    grip_gain: Float,
    modal_ports: ModalPorts,
    ports: Ports,
    port_gain: Float,
    diagonal: Float,
    wide: bool,
) -> int:
    """Modal: all that acts at single points and so is not diagonal, as ports; returns how many.

    Args:
        surface_shape: shapes of the skin.
        held: of the tools.
        hold_of: likewise.
        first: first tool.
        last: one past the last.
        grip_gain: coefficients of their grasps.
        modal_ports: result.
        ports: what else holds the copy.
        port_gain: its coefficients.
        diagonal: D.
        wide: whether axes are alike.
    """
    shape, gain, other = modal_ports.shape, modal_ports.gain, ports.shape
    rows, before = diagonal.shape[0], ports.first
    q = 0
    for p in range(before, ports.last):
        for i in range(rows):
            shape[q, i] = other[p, i]
        gain[q] = math.sqrt(port_gain[p - before])
        q += 1
    for t in range(first, last):
        for c in range(max(held[t], 0)):
            for a in range(1 if wide else 3):
                for i in range(rows):
                    shape[q, i] = surface_shape[hold_of[t, c] * rows + i, a]
                gain[q] = math.sqrt(grip_gain[t - first])
                q += 1
    factorise_ports(modal_ports, q, diagonal)
    return q


@block
def elements(
    surface: Surface, tools: Tools, found: Contacts, work: Columns, small: Small, axes: int, lanes: tuple[int, ...]
) -> int:
    """Directions of the contacts' elements, and the columns of the body that contacts and grasps need.

    Where a body yields alike along all axes, a contact or a grasp has one column; else one for each direction.

    Args:
        surface: the skin.
        tools: the proxies.
        found: contacts.
        work: result: `row`, `value`, `entries` or `dense`.
        small: result.
        axes: elements of a contact.
        lanes: fixes the width.

    Returns:
        Number of columns.
    """
    first, held, hold_of = tools.first, tools.held, tools.hold
    shape, hold_row, corner = surface.shape, surface.hold_row, surface.corner
    carried, weight = surface.row, surface.weight
    triangle, barycentric, normal, tool = found.triangle, found.barycentric, found.normal, found.tool
    direction, column, owner, force = small.direction, small.column, small.owner, small.force
    grip_column = small.grip_column
    dense, row, value, entries = work.dense, work.row, work.value, work.entries
    wide, modal, rows = len(lanes) > 1, shape.shape[0] > 0, work.answer.shape[1]
    used = 0
    for c in range(found.number[0]):
        n = c * axes
        for a in range(3):
            direction[n, a] = normal[c, a]
        if axes == 3:
            _tangents(direction, n)
        for j in range(axes):
            force[n + j] = 0.0
            owner[n + j] = tool[c] - first
            if wide and j > 0:
                column[n + j] = used - 1
                continue
            column[n + j] = used
            if modal:
                _dense_column(shape, corner, triangle[c], barycentric, c, direction, n + j, dense, used, rows, wide)
            else:
                entries[used] = _sparse_column(
                    carried, weight, corner, triangle[c], barycentric, c, direction, n + j, row, value, used, wide
                )
            used += 1
    for t in range(first, tools.last):
        grip_column[t - first] = used
        if held[t] <= 0:
            continue
        for a in range(1 if wide else 3):
            if modal:
                for i in range(rows):
                    total = 0.0
                    for c in range(held[t]):
                        total += shape[hold_of[t, c] * rows + i, a]
                    dense[used, i] = total
            else:
                for c in range(held[t]):
                    row[used, c] = hold_row[hold_of[t, c], a]
                    value[used, c] = 1.0
                entries[used] = held[t]
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
def _dense_column(
    shape: Float,
    corner: Int,
    triangle: int,
    barycentric: Float,
    c: int,
    direction: Float,
    element: int,
    dense: Float,
    column: int,
    rows: int,
    wide: bool,
) -> None:
    """A unit force at a contact in a modal basis, along its element's direction unless all axes are alike."""
    for i in range(rows):
        dense[column, i] = 0.0
    for q in range(3):
        part = barycentric[c, q]
        if part == 0.0:
            continue
        v = corner[triangle, q]
        for i in range(rows):
            value = shape[v * rows + i, 0]
            if not wide:
                value = 0.0
                for a in range(3):
                    value += direction[element, a] * shape[v * rows + i, a]
            dense[column, i] += part * value


@part
def _sparse_column(
    carried: Int,
    weight: Float,
    corner: Int,
    triangle: int,
    barycentric: Float,
    c: int,
    direction: Float,
    element: int,
    row: Int,
    value: Float,
    column: int,
    wide: bool,
) -> int:
    """The same in the body's own basis; returns the number of entries."""
    count = 0
    for q in range(3):
        v = corner[triangle, q]
        for k in range(carried.shape[1]):
            part = barycentric[c, q] * weight[v, k]
            if part == 0.0:
                continue
            for a in range(1 if wide else 3):
                row[column, count] = carried[v, k, a]
                value[column, count] = part if wide else part * direction[element, a]
                count += 1
    return count


@part
def modal_columns(dense: Float, answers: Float, modal_ports: ModalPorts, held: int, used: int, diagonal: Float) -> None:
    """`A⁻¹ h_c` where A is diagonal but for ports."""
    for group in range((used + 3) // 4):
        answer = answers[group]
        for i in range(diagonal.shape[0]):
            for lane in range(4):
                c = 4 * group + lane
                answer[i, lane] = dense[c, i] / diagonal[i] if c < used else 0.0
        correct(modal_ports, held, diagonal, answer, FOUR)
