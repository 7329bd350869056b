"""`rollback`: all move the same body; forces that are not known yet are held, and steps are taken again when they come.

A copy has a state up to which it knows all forces. From there it takes all steps up to now in every step, with the
forces that have come, and the newest of each neighbour for those that have not [Cannon; Bernier 2001]. Every message
repeats all forces that the other may lack.
"""

import numpy as np

from cotouch.compiled import routine, subroutine
from cotouch.laboratory._replicas._replica import AxisRun, ReplicaKind, advance, body_energy


@subroutine
def _pushed(run: AxisRun, force: np.ndarray, i: int, k: int, m: int) -> float:
    """All hands' forces in step m as copy i knows them in step k, its own for m < k [N]."""
    push = 0.0
    for j in range(force.shape[0]):
        if j == i:
            push += force[i, m] if m < k else 0.0
        else:
            known = min(m, run.used[i, j, k])
            push += force[j, known] if known >= 0 else 0.0
    return push


@routine
def _move(run: AxisRun) -> None:
    count, steps = run.mean.shape
    force = np.zeros((count, steps))
    sure = np.zeros(count, np.int64)
    x, v = run.place[:, 0].copy(), run.speed[:, 0].copy()
    run.energy[0] = body_energy(run, run.place[0, 0], run.speed[0, 0])
    for k in range(steps):
        for i in range(count):
            known = k
            for j in range(count):
                if j != i:
                    known = min(known, run.used[i, j, k] + 1)
            while sure[i] < known:
                rate = advance(run, x[i], v[i], 0.0, 0.0, _pushed(run, force, i, k, sure[i]), run.mass, 1.0)
                x[i], v[i] = x[i] + run.T * rate, 2.0 * rate - v[i]
                sure[i] += 1
            here, speed = x[i], v[i]
            for m in range(sure[i], k):
                rate = advance(run, here, speed, 0.0, 0.0, _pushed(run, force, i, k, m), run.mass, 1.0)
                here, speed = here + run.T * rate, 2.0 * rate - speed
            wrong = body_energy(run, here, speed) - body_energy(run, run.place[i, k], run.speed[i, k])
            run.corrected[0] += abs(wrong) / count
            stiffness, damping = run.hand_stiffness[i, k], run.hand_damping[i, k]
            push = run.aim[i, k] + _pushed(run, force, i, k, k)
            rate = advance(run, here, speed, stiffness, damping, push, run.mass, 1.0)
            run.mean[i, k], run.rate[i, k] = here + 0.5 * run.T * rate, rate
            run.place[i, k + 1], run.speed[i, k + 1] = here + run.T * rate, 2.0 * rate - speed
            force[i, k] = run.aim[i, k] - stiffness * run.mean[i, k] - damping * rate
            run.energy[k + 1] += body_energy(run, run.place[i, k + 1], run.speed[i, k + 1]) / count
            run.lost[k] += run.T * run.damping * rate * rate / count


rollback = ReplicaKind(
    name="rollback", move=_move, sends=("f of all steps that may lack",), source="Cannon; Bernier 2001"
)
