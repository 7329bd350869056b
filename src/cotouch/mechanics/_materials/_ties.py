"""Springs of no length at the faces along which a body opens: `½ k ‖x_j - x_i‖²`, linear whatever turns."""

from typing import Any

from cotouch.arrays import Float
from cotouch.kernels import at, load, part, store, total
from cotouch.mechanics._materials._memory import is_cut


@part
def pull_ties(law: Any, memory: Float, x: Float, ahead: Float, rate: Float, out: Float, lanes: tuple[int, ...]) -> None:
    """Adds the mean force of all ties between two places, and their damping.

    Args:
        law: whose ties they are; see `CorotatedCells`.
        memory: of the copy.
        x: displacements of the rows, (rows, 4) [m].
        ahead: where the step ends, likewise.
        rate: mean velocity [m/s].
        out: (rows, 4), added to [N].
        lanes: fixes the width of a row.
    """
    for s in range(law.tie.shape[0]):
        if is_cut(memory, law.tie_cut, at(law.tie_face, s)):
            continue
        i, j, k = at(law.tie_start, s), at(law.tie_end, s), at(law.tie, s)
        apart = 0.5 * (load(x, j, lanes) - load(x, i, lanes) + load(ahead, j, lanes) - load(ahead, i, lanes))
        force = k * (apart + law.viscosity * (load(rate, j, lanes) - load(rate, i, lanes)))
        store(out, i, load(out, i, lanes) - force, lanes)
        store(out, j, load(out, j, lanes) + force, lanes)


@part
def weigh_ties(law: Any, memory: Float, ahead: Float, rate: Float, lanes: tuple[int, ...]) -> tuple[float, float]:
    """What all ties hold at a place [J], and the power of their dampers [W]; see `pull_ties`.

    Args:
        law: with ties.
        memory: of the copy, (numbers,).
        ahead: displacements of the rows, (rows, 4) [m].
        rate: mean velocity, likewise [m/s].
        lanes: fixes the width of a row.
    """
    energy, power = 0.0, 0.0
    for s in range(law.tie.shape[0]):
        if is_cut(memory, law.tie_cut, at(law.tie_face, s)):
            continue
        i, j, k = at(law.tie_start, s), at(law.tie_end, s), at(law.tie, s)
        apart, slip = load(ahead, j, lanes) - load(ahead, i, lanes), load(rate, j, lanes) - load(rate, i, lanes)
        energy += 0.5 * k * total(apart * apart)
        power += law.viscosity * k * total(slip * slip)
    return energy, power
