"""Taking and letting go: springs between a proxy and the nodes that it holds [Lee & Huang 2010, contact law]."""
# pyright: reportArgumentType=false, reportReturnType=false

import numpy as np
import numpy.typing as npt

from cotouch.mechanics._kernel import part
from cotouch.mechanics._surface import Fit, Surface, place_vertex
from cotouch.mechanics._tools import MOST_HELD, MOST_HELD_MODAL, Tools

Float = npt.NDArray[np.float64]


@part
def held_place(
    surface: Surface, fit: Fit, hold: int, axis: int, position: Float, lanes: tuple[int, ...]
) -> float:
    """Displacement of something held along an axis [m]; in a modal basis its vertex must have been placed."""
    axes = surface.hold_row.shape[1]
    if axes == 0:
        return fit.place[hold, axis] - surface.rest[hold, axis]
    if axes == 1:
        return position[surface.hold_row[hold, 0], axis]
    return position[surface.hold_row[hold, axis], 0]


@part
def take(
    surface: Surface, fit: Fit, tools: Tools, t: int, position: Float, lanes: tuple[int, ...]
) -> None:
    """Takes hold of the nodes within the tool's radius, or of the nearest, with springs that start relaxed."""
    modal = surface.hold_row.shape[1] == 0
    most = MOST_HELD_MODAL if modal else MOST_HELD
    limit = tools.radius[t] * tools.radius[t]
    count, worst, nearest, near = 0, 0, 0, np.inf
    for h in range(surface.hold_rest.shape[0]):
        if modal:
            place_vertex(surface, fit, h, position, lanes)
        square = 0.0
        for a in range(3):
            gap = surface.hold_rest[h, a] + held_place(surface, fit, h, a, position, lanes) - tools.place[t, a]
            square += gap * gap
        if square < near:
            near, nearest = square, h
        if square <= limit:
            if count < most:
                tools.hold[t, count] = h
                tools.offset[t * MOST_HELD + count, 3] = square  # the distance, until offsets are written
                count += 1
            else:
                worst = 0
                for c in range(1, most):
                    if tools.offset[t * MOST_HELD + c, 3] > tools.offset[t * MOST_HELD + worst, 3]:
                        worst = c
                if square < tools.offset[t * MOST_HELD + worst, 3]:
                    tools.hold[t, worst] = h
                    tools.offset[t * MOST_HELD + worst, 3] = square
    if count == 0:
        tools.hold[t, 0] = nearest
        count = 1
    tools.held[t] = count
    for c in range(count):
        for a in range(3):
            place = held_place(surface, fit, tools.hold[t, c], a, position, lanes)
            tools.offset[t * MOST_HELD + c, a] = place - tools.place[t, a]
        tools.offset[t * MOST_HELD + c, 3] = 0.0
    tools.grip_energy[t] = 0.0


@part
def stretch(
    surface: Surface, fit: Fit, tools: Tools, t: int, c: int, axis: int, position: Float, lanes: tuple[int, ...]
) -> float:
    """Stretch of one spring of a grasp along an axis [m]."""
    place = held_place(surface, fit, tools.hold[t, c], axis, position, lanes)
    return place - tools.place[t, axis] - tools.offset[t * MOST_HELD + c, axis]
