"""`broadcast`: all tell all their hands' forces and states; each moves the whole body, drawn to the others' past.

After Cheong et al. 2005 and 2009, reconstructed from their abstracts, not from their equations: the newest forces are
held, and a spring and damper pull each copy by how far it was, at the time of the message, from the copy that sent it.
"""

from cotouch.compiled import routine
from cotouch.laboratory._replicas._replica import AxisRun, ReplicaKind, advance, body_energy

# Of M/(N τ²) and M/(N τ), so that the loops around the delay τ stay calm.
_PULL, _DAMP = 0.04, 0.35


@routine
def _move(run: AxisRun) -> None:
    count, steps = run.mean.shape
    run.energy[0] = body_energy(run, run.place[0, 0], run.speed[0, 0])
    for k in range(steps):
        for i in range(count):
            push = run.aim[i, k]
            for j in range(count):
                known = run.used[i, j, k]
                if j == i or known < 0:
                    continue
                held = run.hand_stiffness[j, known] * run.mean[j, known]
                push += run.aim[j, known] - held - run.hand_damping[j, known] * run.rate[j, known]
                age = max(0.5 * (run.delay[i, j] + run.delay[j, i]), 2.0 * run.T)
                away, slip = run.mean[j, known] - run.mean[i, known], run.rate[j, known] - run.rate[i, known]
                push += run.mass / count * (_PULL * away / age**2 + _DAMP * slip / age)
            here, speed = run.place[i, k], run.speed[i, k]
            rate = advance(run, here, speed, run.hand_stiffness[i, k], run.hand_damping[i, k], push, run.mass, 1.0)
            run.mean[i, k], run.rate[i, k] = here + 0.5 * run.T * rate, rate
            run.place[i, k + 1], run.speed[i, k + 1] = here + run.T * rate, 2.0 * rate - speed
            run.energy[k + 1] += body_energy(run, run.place[i, k + 1], run.speed[i, k + 1]) / count
            run.lost[k] += run.T * run.damping * rate * rate / count


broadcast = ReplicaKind(
    name="broadcast",
    move=_move,
    sends=("f", "x̂", "v̂"),
    numbers=3,
    source="after Cheong et al. 2005, 2009, reconstructed from abstracts",
)
