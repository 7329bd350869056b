"""`owner`: the first user's computer moves the body; to the others it is a moving wall [networked physics in games].

The others push against the newest place that they know of, and their forces act on the body when they arrive.
"""

from cotouch.compiled import routine
from cotouch.laboratory._replicas._replica import AxisRun, ReplicaKind, advance, body_energy


@routine
def _move(run: AxisRun) -> None:
    count, steps = run.mean.shape
    x, v = run.place[0, 0], run.speed[0, 0]
    run.energy[0] = body_energy(run, x, v)
    for k in range(steps):
        push = run.aim[0, k]
        for j in range(1, count):
            known = run.used[0, j, k]
            if known >= 0:
                held = run.hand_stiffness[j, known] * run.mean[j, known]
                push += run.aim[j, known] - held - run.hand_damping[j, known] * run.rate[j, known]
        rate = advance(run, x, v, run.hand_stiffness[0, k], run.hand_damping[0, k], push, run.mass, 1.0)
        run.mean[0, k], run.rate[0, k] = x + 0.5 * run.T * rate, rate
        x, v = x + run.T * rate, 2.0 * rate - v
        run.place[0, k + 1], run.speed[0, k + 1] = x, v
        for j in range(1, count):
            known = run.used[j, 0, k]
            if known < 0:
                run.mean[j, k] = run.place[0, 0]
                run.place[j, k + 1] = run.place[0, 0]
                continue
            run.mean[j, k], run.rate[j, k] = run.mean[0, known], run.rate[0, known]
            run.place[j, k + 1], run.speed[j, k + 1] = run.place[0, known + 1], run.speed[0, known + 1]
        run.energy[k + 1] = body_energy(run, x, v)
        run.lost[k] = run.T * run.damping * rate * rate


owner = ReplicaKind(name="owner", move=_move, sends=("x̂ and v̂, or f",), numbers=2, source="networked physics in games")
