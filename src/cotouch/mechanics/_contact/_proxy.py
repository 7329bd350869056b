"""A proxy by itself: NPMI with the drive that pulls it, `inertia ŵ = drive + contact` [Lee & Huang 2010, proxy]."""
# pyright: reportArgumentType=false, reportReturnType=false

from cotouch.arrays import Float
from cotouch.kernels import part
from cotouch.mechanics._model._tools import BLADE, DRIVE, PROXY, TOUCH_LOSS, Tools

# What a tool pays stops it within a step at most, and does not throw it back: so many times its mass over T at most.
_FIRM = 20.0


@part
def proxy_inertia(tools: Tools, t: int, T: float) -> float:
    """What resists the mean velocity of a tool in a step [Ns/m].

    Args:
        tools: the proxies.
        t: which of them.
        T: length of the step [s].
    """
    own = 2.0 * tools.mass[t] / T + 0.5 * T * tools.drive_stiffness[t] + tools.drive_damping[t]
    return own + _drag(tools, t, T)


@part
def _drag(tools: Tools, t: int, T: float) -> float:
    return min(tools.drag[t], _FIRM * tools.mass[t] / T)


@part
def pay(tools: Tools, t: int, a: int, T: float, w: float, touch_ledger: Float) -> None:
    """What the motion of a tool along an axis pays: of a blade for what it cut, which is lost, else what it owes.

    Args:
        tools: the proxies; `touch_force`, `debt` and `owed` are changed.
        t: which of them.
        a: axis, 0 to 2.
        T: length of the step [s].
        w: mean velocity along it [m/s].
        touch_ledger: TOUCH_LOSS is added to.
    """
    drag = _drag(tools, t, T)
    tools.touch_force[t, a] -= drag * w
    if tools.mode[t] == BLADE:
        tools.debt[t] -= T * drag * w * w
        touch_ledger[TOUCH_LOSS] += T * drag * w * w
    else:
        tools.owed[t] -= T * drag * w * w


@part
def proxy_drive(tools: Tools, t: int, a: int, T: float) -> float:
    """What its drive and its own motion ask for along an axis [N].

    Args:
        tools: the proxies.
        t: which of them.
        a: axis, 0 to 2.
        T: length of the step [s].
    """
    k, b = tools.drive_stiffness[t], tools.drive_damping[t]
    start, end = tools.drive_start[t, a], tools.drive_end[t, a]
    desired = 0.5 * k * (start + end) + (b / T) * (end - start) + tools.push[t, a]
    return (2.0 * tools.mass[t] / T) * tools.rate[t, a] + desired - k * tools.place[t, a]


@part
def book_drive(tools: Tools, t: int, a: int, T: float, w: float, touch_ledger: Float) -> None:
    """Force and work of the drive along an axis, with the mean velocity that came of the step.

    Args:
        tools: the proxies; `drive_force` is written.
        t: which of them.
        a: axis, 0 to 2.
        T: length of the step [s].
        w: mean velocity along it [m/s].
        touch_ledger: DRIVE is added to.
    """
    k, b = tools.drive_stiffness[t], tools.drive_damping[t]
    start, end = tools.drive_start[t, a], tools.drive_end[t, a]
    force = k * (0.5 * (start + end) - tools.place[t, a] - 0.5 * T * w) + b * ((end - start) / T - w) + tools.push[t, a]
    tools.drive_force[t, a] = force
    touch_ledger[DRIVE] += T * force * w


@part
def move_proxy(tools: Tools, t: int, a: int, T: float, w: float, touch_ledger: Float) -> None:
    """New place and velocity along an axis, and what it holds then.

    Args:
        tools: the proxies; `place` and `rate` are changed.
        t: which of them.
        a: axis, 0 to 2.
        T: length of the step [s].
        w: mean velocity along it [m/s].
        touch_ledger: PROXY is added to.
    """
    tools.place[t, a] += T * w
    tools.rate[t, a] = 2.0 * w - tools.rate[t, a]
    touch_ledger[PROXY] += 0.5 * tools.mass[t] * tools.rate[t, a] * tools.rate[t, a]
