"""What tools feel of a motion of the body that no look has seen."""

from cotouch.arrays import Float
from cotouch.kernels import part
from cotouch.mechanics._contact._grasp import feel_grasp
from cotouch.mechanics._contact._press import read_skin
from cotouch.mechanics._contact._skin import follow
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._linear._state import State
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import GRASP, TOUCHING, Tools


@part
def follow_all(
    surface: Surface,
    touch: ContactWork,
    tools: Tools,
    T: float,
    state: State,
    mean: Float,
    diagonal: Float,
    look: bool,
    lanes: tuple[int, ...],
) -> None:
    """Reads how the skin near all tools moves, and what grasps hold, by the present motion.

    Args:
        surface: the skin.
        touch: scratch of the step, which is written.
        tools: the proxies.
        T: length of the step [s].
        state: of the copy.
        mean: how its rows move [m/s].
        diagonal: of a modal body's system [Ns/m].
        look: whether any tool touches.
        lanes: fixes the width of a row.
    """
    for t in range(tools.mode.shape[0]):
        if look and tools.mode[t] == TOUCHING:
            if follow(surface, touch, tools, t, T, state, mean, lanes):
                read_skin(surface, touch, t)  # friction is stretched by where the last correction leads
        elif tools.mode[t] == GRASP:
            feel_grasp(surface, touch, tools, t, T, state.position, mean, diagonal, False, lanes)
