"""`lockstep`: all move the same body by the same forces, each as late as the latest message was.

How late that is is known beforehand here, so nobody ever waits: the best that it can be. Every message repeats all
forces that the other may lack, so a loss costs as long as it takes for the next message to arrive.
[Bettner & Terrano 2001]
"""

from cotouch.compiled import routine
from cotouch.laboratory._replicas._replica import AxisRun, ReplicaKind, advance, body_energy


@routine
def _move(run: AxisRun) -> None:
    count, steps = run.mean.shape
    late = 1
    for i in range(count):
        for j in range(count):
            for k in range(steps):
                if i != j and k - run.used[i, j, k] > late:
                    late = k - run.used[i, j, k]
    x, v = run.place[0, 0], run.speed[0, 0]
    run.energy[0] = body_energy(run, x, v)
    for k in range(steps):
        push = 0.0
        for j in range(count):
            if k >= late:
                then = k - late
                held = run.hand_stiffness[j, then] * run.mean[j, then]
                push += run.aim[j, then] - held - run.hand_damping[j, then] * run.rate[j, then]
        rate = advance(run, x, v, 0.0, 0.0, push, run.mass, 1.0)
        middle = x + 0.5 * run.T * rate
        x, v = x + run.T * rate, 2.0 * rate - v
        for j in range(count):
            run.mean[j, k], run.rate[j, k] = middle, rate
            run.place[j, k + 1], run.speed[j, k + 1] = x, v
        run.energy[k + 1] = body_energy(run, x, v)
        run.lost[k] = run.T * run.damping * rate * rate


lockstep = ReplicaKind(
    name="lockstep", move=_move, sends=("f of all steps that may lack",), source="Bettner & Terrano 2001"
)
