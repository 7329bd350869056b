"""What a step with a jammed tool took of motion, for whoever records it."""

import numpy as np

from cotouch.arrays import Float
from cotouch.mechanics._contact._centre import JAMMED
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._model._tools import Tools


def jammed_about(touch: ContactWork, tools: Tools, force: BodyForce | None) -> Float | None:
    """About which velocity bodies and tools lost half of their motion at the end of the step that was taken last.

    Args:
        touch: scratch of that step; what it holds is of whichever copy stepped last.
        tools: the proxies.
        force: what resists inside the body; None of a linear one.

    Returns:
        Of each body, then of each tool, (bodies + tools, 3) [m/s], NaN of those that lost none; None if none did.
    """
    if not touch.goal[0] < JAMMED:
        return None
    lost = touch.caught[: tools.mode.size, 4] != 0.0
    held = np.ones(1, dtype=bool) if force is None or force.parts is None else force.parts.held != 0
    return np.where(np.concatenate([held, lost])[:, None], touch.spot[0, :3], np.nan)
