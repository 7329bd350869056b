"""What an account of energy pays for not knowing a place exactly.

Half a step of the encoder is charged for each change of the force (`modulation_bound`), because the place may be at the
worse end of its step. Each step of a motion changes the force by `(k + b / window) Δ` and back, so that the account
pays a toll for the way, however slowly it is gone, while its damper earns little. Once the account is empty, the spring
has no more than what the last steps brought: it slips, and the force jumps with every step.
"""

# So much way on all axes together is paid from what an account begins with [m].
_FREE_PATH = 0.3
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


def opening_energy(toll: float, cap: float) -> float:
    """What an account begins with; counts once in the bound of passivity [J].

    Args:
        toll: see `encoder_toll` [N].
        cap: most that the account keeps [J].
    """
    return min(cap, toll * _FREE_PATH)
