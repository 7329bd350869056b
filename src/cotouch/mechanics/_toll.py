"""What an account of energy pays for not knowing a place exactly.

Half a step of the encoder is charged for each change of the force (`modulation_bound`), because the place may be at the
worse end of its step. Each step of a motion changes the force by `(k + b / window) Δ` and back, so that the account
pays a toll for the way, however slowly it is gone, while its damper earns little. Once the account is empty, the spring
has no more than what the last steps brought: it slips, and the force jumps with every step.
"""

MOST_TOLL = 0.15
"""Above this toll a hand that moves slowly empties an account faster than the damper fills it [N]."""
FREE_PATH = 0.15
"""So much way is paid from what an account begins with [m]."""


def encoder_toll(*, stiffness: float, damping: float, window: float, resolution: float) -> float:
    """What an account pays for a way, by its length [N].

    Args:
        stiffness: k, >= 0 [N/m].
        damping: b, >= 0 [Ns/m].
        window: over which velocity is measured, > 0 [s].
        resolution: of the encoder, >= 0 [m].
    """
    return (stiffness + damping / window) * resolution


def opening_energy(toll: float, cap: float) -> float:
    """What an account begins with; counts once in the bound of passivity [J].

    Args:
        toll: see `encoder_toll` [N].
        cap: most that the account keeps [J].
    """
    return min(cap, toll * FREE_PATH)
