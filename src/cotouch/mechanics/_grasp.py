"""Taking and letting go: springs between a proxy and the nodes that it holds [Lee & Huang 2010, contact law]."""
# pyright: reportArgumentType=false, reportReturnType=false

import numpy as np
import numpy.typing as npt

from cotouch.arrays import Float
from cotouch.mechanics._kernel import part
from cotouch.mechanics._surface import Fit, Surface, place_vertex
from cotouch.mechanics._tools import MOST_HELD, MOST_HELD_MODAL, Tools

Int = npt.NDArray[np.int32]


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
    """Mean velocity of something held along an axis [m/s]."""
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
def take(surface: Surface, fit: Fit, tools: Tools, t: int, position: Float, lanes: tuple[int, ...]) -> None:
    """Takes hold of the nodes within the tool's radius, or of the nearest, with springs that start relaxed."""
    hold_row, rest, hold_rest, moved = surface.hold_row, surface.rest, surface.hold_rest, fit.place
    hold_of, offset, centre = tools.hold, tools.offset, tools.place
    modal, base = hold_row.shape[1] == 0, t * MOST_HELD
    most = MOST_HELD_MODAL if modal else MOST_HELD
    limit = tools.radius[t] * tools.radius[t]
    count, worst, nearest, near = 0, 0, 0, np.inf
    for h in range(hold_rest.shape[0]):
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
    if count == 0:
        hold_of[t, 0] = nearest
        count = 1
    tools.held[t] = count
    for c in range(count):
        for a in range(3):
            place = held_place(hold_row, rest, moved, hold_of[t, c], a, position)
            offset[base + c, a] = place - centre[t, a]
        offset[base + c, 3] = 0.0
    tools.grip_energy[t] = 0.0
