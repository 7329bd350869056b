"""What one root says of a choice: that it is surely no better than another; and where its links pull the root."""

import numpy as np

from cotouch.arrays import Complex, Float, Long
from cotouch.compiled import routine, subroutine
from cotouch.network import arrive, chain_of, none_beyond, on_line, polish, rate_of, slowest, value
from cotouch.planning._task import CONSENSUS, DAMPING, DECAY, DRAG, FEEL, Task, loop_of, weight_of


@routine
def between(task: Task, chosen: Long, best: float, worst: float, guesses: Complex) -> bool:
    """Whether an aperiodic consensus is surely slower than `best` and faster than `worst`, which needs no exact value.

    One root right of `best` settles the first; that no root lies right of `worst` the second.

    Args:
        task: the search.
        chosen: numbers of the pairs that are linked, ascending, (links,).
        best: rate that it must be slower than to count [1/s].
        worst: rate that it must be faster than [1/s].
        guesses: places where the slowest root may be; the first is replaced by what was found, (guesses,) [1/s].
    """
    loop = loop_of(task, chosen, 0, -1)
    start = guesses[:1] if np.isfinite(guesses[0].real) else guesses[:0]
    root, certain, _ = slowest(loop, task.top, start, best)
    if np.isfinite(root.real):
        guesses[0] = root
    if not (certain and best < root.real < worst):
        return False
    return worst >= 0.0 or none_beyond(loop, task.top, worst)


@routine
def hopeless(task: Task, chosen: Long, best: float, pool: Complex) -> bool:
    """Whether links are surely no better than `best`, from one root that Newton reaches from a guess.

    A root right of `best` settles it, whatever others there are. The resting translation does not count.

    Args:
        task: the search.
        chosen: numbers of the pairs linked, ascending.
        best: what to be better than.
        pool: guesses of each mode, tried in turn, real part -inf where there is none, (modes, any number); the one that
            settles it goes first the next time.
    """
    if task.objective in (DAMPING, DRAG):
        return weight_of(task, chosen) >= best
    if task.objective == FEEL:
        return False
    known = np.zeros(1, np.complex128)
    for mode in range(len(task.modes)):
        loop = loop_of(task, chosen, mode, -1)
        chain = chain_of(loop)
        resting = task.objective == CONSENSUS or task.modes[mode, 2] == 0.0
        if task.objective == CONSENSUS:
            scale = 1.0 / max(np.max(loop.to_first), np.max(loop.to_second))
        else:
            scale = rate_of(loop)
        for g in range(pool.shape[1]):
            if not np.isfinite(pool[mode, g].real):
                continue
            root, arrived = arrive(chain, pool[mode, g], scale, np.inf, known, 1 if resting else 0)
            if arrived and root.real >= best and (not resting or np.abs(root) > 1e-9 * scale):
                # What Newton says is held against Newton on the whole determinant, which turns pivots.
                root, arrived = polish(loop, root, scale, known, np.ones(1, np.int64), 1 if resting else 0)
                if arrived and root.real >= best and (not resting or np.abs(root) > 1e-9 * scale):
                    remember(pool, mode, g, root)
                    return True
    return False


@subroutine
def remember(pool: Complex, mode: int, place: int, root: complex) -> None:
    """Puts a root first among the guesses, in the place of one of them.

    Args:
        pool: guesses of each body mode, the newest first, (modes, guesses) [1/s]; changed in place.
        mode: number of the body mode, from 0.
        place: of the guess that is given up, from 0.
        root: that was found [1/s].
    """
    for g in range(place, 0, -1):
        pool[mode, g] = pool[mode, g - 1]
    pool[mode, 0] = root


@routine
def pulls(task: Task, chosen: Long, guesses: Complex, out: Float) -> None:
    """How far each pair, linked as a little more than it is, moves the slowest root to the right, 1/s.

    With `zᵀ G = 0 = G x` at a root s a change of G moves it by `-zᵀ dG x / zᵀ G' x`.

    Args:
        task: the search, not of damping.
        chosen: numbers of the pairs linked, ascending.
        guesses: the slowest root of each mode.
        out: filled, (M,).
    """
    mode = int(np.argmax(guesses.real))
    s = guesses[mode]
    chain = chain_of(loop_of(task, chosen, mode, -1))
    on_line(chain, s.real)
    _, slope = value(chain, s.imag)
    x, z = chain.right, chain.left
    damped = task.objective == DECAY and len(task.sync) == 0
    for e in range(len(task.first)):
        i, j = chain.place[task.first[e]], chain.place[task.second[e]]
        own = task.spring[e] + (s * task.load[e] if damped else 0.0)
        forth, back = np.exp(-s * task.to_first[e]), np.exp(-s * task.to_second[e])
        moved = own * (z[i] * x[i] + z[j] * x[j])
        moved -= task.spring[e] * (forth * z[i] * x[j] + back * z[j] * x[i])
        out[e] = 0.0 if slope == 0.0 else -(moved / slope).real
