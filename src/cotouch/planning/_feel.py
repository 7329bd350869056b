"""What a hand feels of the object through linked copies, beyond the object itself."""

import numpy as np

from cotouch.arrays import Float
from cotouch.compiled import raised, routine
from cotouch.network import Loop, invert


@routine
def felt(loop: Loop, thing: Float, tones: Float, enough: float) -> float:
    """The largest `|Z_i - Z|` of any user at any tone, Ns/m.

    A hand at the copy of user i feels `Z_i = 1 / (s (G⁻¹)_ii)` while the others let go; of one copy for all it would
    feel `Z = m s + b + k/s`.

    Args:
        loop: of the links.
        thing: mass [kg], damping [Ns/m] and stiffness [N/m] of the object or of its mode, (3,).
        tones: angular frequencies, 1/s; what it comes to at the first of them is known soonest.
        enough: a value that need not be known beyond.
    """
    n = len(loop.mass)
    matrix, inverse = np.empty((n, n), np.complex128), np.empty((n, n), np.complex128)
    worst = 0.0
    for tone in tones:
        if worst > enough or raised(loop.stop):
            break
        s = complex(0.0, tone)
        for i in range(n):
            for j in range(n):
                matrix[i, j] = 0.0
            matrix[i, i] = (loop.mass[i] * s + loop.drag[i]) * s + loop.rigid[i]
        for e in range(len(loop.first)):
            i, j = loop.first[e], loop.second[e]
            matrix[i, j] -= loop.spring[e] * np.exp(-s * loop.to_first[e])
            matrix[j, i] -= loop.spring[e] * np.exp(-s * loop.to_second[e])
        if invert(matrix, inverse) == 0.0:
            return np.inf
        alone = thing[0] * s + thing[1] + thing[2] / s
        for i in range(n):
            worst = max(worst, np.abs(1.0 / (s * inverse[i, i]) - alone))
    return worst
