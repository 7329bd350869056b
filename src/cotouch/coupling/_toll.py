"""What an account of energy pays for not knowing a place exactly.

Half a step of the encoder is charged for each change of the force (`modulation_bound`), because the place may be at the
worse end of its step. Each step of a motion changes the force by `(k + b / window) Δ` and back, so that the account
pays a toll for the way, however slowly it is gone, while its damper earns little. Once the account is empty, the spring
has no more than what the last steps brought: it slips, and the force jumps with every step.
"""

from cotouch.errors import DeviceError

# So much way on all axes together is paid from what an account begins with [m].
_FREE_PATH = 0.3
# And at least so much [J], and what springs at both ends need for so much force [N] before a hand has earned it.
_LEAST, _FORCE = 5e-3, 5.0
# A damper pays for the rest of a way at this speed [m/s], but for what it can leave [N]; and the most of all [N].
_SPEED, _LEFT, _MOST = 0.02, 0.02, 0.135


def encoder_toll(*, stiffness: float, damping: float, window: float, resolution: float) -> float:
    """What an account pays for a way, by its length [N].

    Args:
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        window: over which velocity is measured, > 0 [s].
        resolution: of the encoder, >= 0 [m].
    """
    return (stiffness + damping / window) * resolution


def most_toll(damping: float) -> float:
    """Above this toll a hand that moves slowly empties an account sooner than the damper fills it [N].

    Args:
        damping: b, >= 0 [Ns/m].
    """
    return min(_MOST, _SPEED * damping + _LEFT)


def checked_toll(
    *, stiffness: float, damping: float, window: float, resolution: float, lower: bool = False, hint: str = ""
) -> float:
    """A stiffness that an account can pay for with these encoders: the given one, or with `lower` less [N/m].

    Args:
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        window: over which velocity is measured, > 0 [s].
        resolution: of the encoder at the tip, >= 0 [m].
        lower: take the limit where the stiffness exceeds it.
        hint: what else may be done, for the message.

    Raises:
        DeviceError: it cannot.
    """
    most = most_toll(damping)
    if encoder_toll(stiffness=stiffness, damping=damping, window=window, resolution=resolution) <= most:
        return stiffness
    limit = most / resolution - damping / window
    if limit > 0.0 and lower:
        return limit
    if limit > 0.0:
        given = f"stiffness is {stiffness:g} N/m"
        remedy = f"at {damping:g} Ns/m above {limit:g} N/m; lower it{hint}"
    else:
        given = f"damping is {damping:g} Ns/m over {window:g} s"
        remedy = "with any stiffness; lower it, or measure velocity over a longer window"
    raise DeviceError(
        f"the coupling's {given}, but encoders with steps of {resolution:.3g} m empty PSPM's tank {remedy}"
    )


def opening_energy(*, toll: float, stiffness: float, cap: float, force: float = _FORCE) -> float:
    """What the tank of each end begins with; counts once in the bound of passivity [J].

    Without any energy no held force does work that could be saved. A force F is held by a spring at each end, and the
    device's also backs the tick before: `3 · F²/2k` where a hand brings `F²/2k`. So the ends begin with the rest for a
    firm hand; less, and what is felt at rest lags behind what the body does.

    Args:
        toll: see `encoder_toll` [N].
        stiffness: k, >= 0 [N/m].
        cap: most that the account keeps [J].
        force: of a firm hand [N].
    """
    return min(cap, max(_LEAST, toll * _FREE_PATH, 0.5 * force**2 / max(stiffness, 1.0)))
