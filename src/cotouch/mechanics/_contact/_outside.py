"""A contact whose energy was changed from outside must not cost more than it holds: it acts softer until it lets go.

A radius that grew, or a body that takes another share, would raise an energy that nobody paid for.
"""
# pyright: reportArgumentType=false, reportReturnType=false

from typing import Any

from cotouch.kernels import inner, part
from cotouch.mechanics._contact._press import feel_tool, press_tool, pressing
from cotouch.mechanics._contact._work import ContactWork
from cotouch.mechanics._model._surface import Surface
from cotouch.mechanics._model._tools import TOUCHING, Tools

_NOTHING = 1e-17  # of the energy in a depth of a tool's radius, it is out of the skin
# A change of energy by so little was not made from outside: what a step left to the next, or foretold; and by so little
# that what a look sums, which suffices for forces, may not tell it.
_LEFT, _TOLD = 1e-6, 3e-5


@part
def begin_tool(law: Any, surface: Surface, touch: ContactWork, tools: Tools, t: int, linear: bool) -> None:
    """Lets a tool touch that is out of the skin; makes one softer whose energy was changed from outside.

    Args:
        law: of the contact.
        surface: the skin.
        touch: what is near; `pressed` gets what the contact holds.
        tools: the proxies.
        t: which of them.
        linear: whether that may be left to the first look, as far as it can tell.
    """
    share, square = tools.share[t], 0.0
    for a in range(3):
        square += tools.stretch[t, a] * tools.stretch[t, a]
    have = max(tools.stored[t] + tools.owed[t] - tools.well[t] - 0.5 * tools.stiffness[t] * square, 0.0)
    touch.pressed[t, 0] = have
    if linear and _tells(surface, touch, tools, t):
        return
    if share == 0.0:  # what does nothing is not out of the skin for that
        tools.share[t] = 1.0
    pressed = press_tool(law, surface, touch, tools, t, 0.0, 0.0, True)
    if pressed <= _NOTHING * tools.share[t] * tools.stiffness[t] * tools.radius[t] * tools.radius[t]:
        tools.inside[t], tools.share[t] = 0, 1.0
    elif tools.inside[t] == 0 and share == 0.0:
        tools.share[t] = 0.0
    elif tools.inside[t] == 0 and pressed > (1.0 + _LEFT) * have:
        tools.share[t] *= have / pressed


@inner
def _tells(surface: Surface, touch: ContactWork, tools: Tools, t: int) -> bool:
    """Whether a first look at a tool tells if its energy was changed."""
    return tools.inside[t] == 0 and tools.share[t] == 1.0 and touch.slow[t] != 0 and surface.soft.shape[0] == 0


@part
def feel_first(law: Any, surface: Surface, touch: ContactWork, tools: Tools, t: int, T: float) -> None:
    """`feel_tool` in a first look, which tells as well whether the energy was changed from outside.

    Straight back from the middle of the step leads to what the energy was at its start, as far as it is straight.
    Less than that is found where no motion closes the balance.

    Args:
        law: of the contact.
        surface: the skin.
        touch: what is near.
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
    """
    tells = _tells(surface, touch, tools, t)
    middle = feel_tool(law, surface, touch, tools, t, T)
    if not tells:
        return
    square = 0.0
    for a in range(3):
        square += touch.mean[t, a] ** 2 + touch.skin[t, a] ** 2
    start = middle + 0.5 * T * pressing(touch, t) - T * touch.grip[t, 0] * square
    if start > (1.0 + _TOLD) * touch.pressed[t, 0] and soften(law, surface, touch, tools, t):
        feel_tool(law, surface, touch, tools, t, T)


@part
def soften(law: Any, surface: Surface, touch: ContactWork, tools: Tools, t: int) -> bool:
    """Makes a tool so soft that its contact costs no more than it holds; returns whether it was not.

    Args:
        law: of the contact.
        surface: the skin.
        touch: what is near; `pressed` says what the contact holds.
        tools: the proxies.
        t: which of them.
    """
    pressed = press_tool(law, surface, touch, tools, t, 0.0, 0.0, True)
    if pressed <= (1.0 + _LEFT) * touch.pressed[t, 0]:
        return False
    tools.share[t] *= touch.pressed[t, 0] / pressed
    return True


@part
def soften_all(law: Any, surface: Surface, touch: ContactWork, tools: Tools) -> None:
    """As `soften`, of all tools that are outside.

    Args:
        law: of the contact.
        surface: the skin.
        touch: what is near, and scratch.
        tools: the proxies.
    """
    for t in range(tools.mode.shape[0]):
        if tools.mode[t] == TOUCHING and tools.inside[t] == 0:
            soften(law, surface, touch, tools, t)
