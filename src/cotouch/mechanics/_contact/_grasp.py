"""Taking and letting go: springs between a proxy and the nodes that it holds [Lee & Huang 2010, contact law]."""
# pyright: reportArgumentType=false, reportReturnType=false

import numpy as np

from cotouch.arrays import Float, Int
from cotouch.kernels import at, part
from cotouch.mechanics._closed._debris import is_debris
from cotouch.mechanics._contact._absent import is_held_away
from cotouch.mechanics._contact._near import touched
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._model._fit import Fit, place_vertex
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import MOST_HELD, MOST_HELD_MODAL, Tools


@part
def held_place(hold_row: Int, rest: Float, place: Float, hold: int, axis: int, position: Float) -> float:
    """Displacement of something held along an axis [m]; in a modal basis its vertex must have been placed.

    Args:
        hold_row: of the surface.
        rest: of the surface.
        place: of its fit.
        hold: what is held.
        axis: 0, 1 or 2.
        position: displacement in the model's rows.
    """
    axes = hold_row.shape[1]
    if axes == 0:
        return place[hold, axis] - rest[hold, axis]
    if axes == 1:
        return position[hold_row[hold, 0], axis]
    return position[hold_row[hold, axis], 0]


@part
def held_rate(hold_row: Int, shape: Float, hold: int, axis: int, mean: Float) -> float:
    """Mean velocity of something held along an axis [m/s].

    Args:
        hold_row: rows of each thing that can be held, (holds, axes), or (holds, 0) of a modal body.
        shape: of a modal body: how each row moves each of them, (holds * rows, 4).
        hold: which of them.
        axis: 0 to 2.
        mean: mean velocity of the rows, (rows, width) [m/s].
    """
    axes, rows = hold_row.shape[1], mean.shape[0]
    if axes == 1:
        return mean[hold_row[hold, 0], axis]
    if axes == 3:
        return mean[hold_row[hold, axis], 0]
    column = axis if mean.shape[1] > 1 else 0
    rate = 0.0
    for i in range(rows):
        rate += shape[hold * rows + i, axis] * mean[i, column]
    return rate


@part
def take(
    surface: Surface,
    fit: Fit,
    tools: Tools,
    t: int,
    position: Float,
    memory: Float,
    debris: Int,
    lanes: tuple[int, ...],
) -> None:
    """Takes hold of the nodes within the tool's radius, or of the nearest, with springs that start relaxed.

    Args:
        surface: the skin.
        fit: where the skin is.
        tools: the proxies; `hold`, `offset` and `held` are written.
        t: which of them.
        position: displacements of the rows, (rows, width) [m].
        memory: of the copy, (numbers,).
        debris: as of `Operator`, (rows,) or (0,).
        lanes: fixes the width of a row.
    """
    hold_row, rest, hold_rest, moved = surface.hold_row, surface.rest, surface.hold_rest, fit.place
    hold_of, offset, centre = tools.hold, tools.offset, tools.place
    modal, base = hold_row.shape[1] == 0, t * MOST_HELD
    most = MOST_HELD_MODAL if modal else MOST_HELD
    limit = tools.radius[t] * tools.radius[t]
    count, worst, nearest, near = 0, 0, 0, np.inf
    for h in range(hold_rest.shape[0]):
        if is_held_away(surface, memory, h) or is_debris(debris, hold_row, h):
            continue
        if modal:
            place_vertex(surface, fit, h, position, lanes)
        square = 0.0
        for a in range(3):
            gap = hold_rest[h, a] + held_place(hold_row, rest, moved, h, a, position) - centre[t, a]
            square += gap * gap
        if square < near:
            near, nearest = square, h
        if square <= limit:
            if count < most:
                hold_of[t, count] = h
                offset[base + count, 3] = square  # the distance, until offsets are written
                count += 1
            else:
                worst = 0
                for c in range(1, most):
                    if offset[base + c, 3] > offset[base + worst, 3]:
                        worst = c
                if square < offset[base + worst, 3]:
                    hold_of[t, worst] = h
                    offset[base + worst, 3] = square
    if count == 0 and near < np.inf:
        hold_of[t, 0] = nearest
        count = 1
    tools.held[t] = count
    for c in range(count):
        for a in range(3):
            place = held_place(hold_row, rest, moved, at(hold_of, (t, c)), a, position)
            offset[base + c, a] = place - centre[t, a]
        offset[base + c, 3] = 0.0


@part
def feel_grasp(
    surface: Surface,
    work: ContactWork,
    tools: Tools,
    t: int,
    T: float,
    position: Float,
    mean: Float,
    diagonal: Float,
    gather: bool,
    lanes: tuple[int, ...],
) -> None:
    """What the springs of a grasp do by the present guess of the motion, as `hold_energy` needs it.

    Args:
        surface: the skin.
        work: `held` is written; forces are added to what `push`, `hold`, `pull` and `grip` gather.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
        position: displacement in the model's rows.
        mean: its guessed rate.
        diagonal: of a modal body's system [Ns/m].
        gather: whether to add forces.
        lanes: fixes the width.
    """
    k, b, modal = tools.grip_stiffness[t], tools.grip_damping[t], surface.shape.shape[0] > 0
    hold_row, shape, offset, moved, held = surface.hold_row, surface.shape, tools.offset, work.fit.place, work.held
    wide, rows, gain = mean.shape[1] > 1, mean.shape[0], b + 0.5 * T * k
    for q in range(3):
        held[t, q] = 0.0
    for a in range(4):
        work.pull[t, a] = 0.0
    work.total[t], work.way[t, 3] = 0.0, 0.0
    work.grip[t, 0] = work.grip[t, 1] = tools.held[t] * gain
    for c in range(tools.held[t]):
        h = at(tools.hold, (t, c))
        if modal:
            place_vertex(surface, work.fit, h, position, lanes)
        for a in range(3):
            stretch = held_place(hold_row, surface.rest, moved, h, a, position) - tools.place[t, a]
            stretch -= offset[t * MOST_HELD + c, a]
            rate = held_rate(hold_row, shape, h, a, mean) - work.mean[t, a]
            held[t, 0] += stretch * stretch
            held[t, 1] += stretch * rate
            held[t, 2] += rate * rate
            if not gather:
                continue
            force = k * stretch + gain * rate
            work.pull[t, a] += force
            if not modal:
                i = at(hold_row, (h, 0 if wide else a))
                work.push[i, a if wide else 0] -= force
                if a == 0 or not wide:
                    work.hold[i] += gain
                column = a if wide else 0
                work.stiff[3 * touched(work, i) + column, column] += gain
                continue
            for i in range(rows):
                own = shape[h * rows + i, a]
                work.push[i, a if wide else 0] -= force * own
                if a == 0 or not wide:
                    work.yields[a] += gain * own * own / diagonal[i]


@part
def hold_energy(work: ContactWork, tools: Tools, t: int, time: float, T: float) -> tuple[float, float]:
    """Energy in a grasp that moved for some time, of a step's length T, and what its dampers lost [J].

    Args:
        work: `held` says how its springs move.
        tools: the proxies.
        t: which tool.
        time: for how long, 0 to T [s].
        T: length of the step [s].
    """
    share = time / T
    start, along, square = work.held[t, 0], work.held[t, 1], work.held[t, 2]
    energy = 0.5 * tools.grip_stiffness[t] * max(start + time * (2.0 * along + time * square), 0.0)
    return energy, T * share * share * tools.grip_damping[t] * square
