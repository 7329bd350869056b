"""`server`: the whole body at one user's place, a light proxy at every user's, springs with the rule's damping between.

The place is the user's whose longest way there and back is the shortest. [Buttolo et al. 1997]
"""

import numpy as np

from cotouch.compiled import routine
from cotouch.laboratory._replicas._replica import Replica, Run, advance, body_energy

_LIGHT = 0.05  # [kg]


@routine
def _move(run: Run) -> None:
    count, steps = run.mean.shape
    place, least = 0, np.inf
    for i in range(count):
        longest = 0.0
        for j in range(count):
            longest = max(longest, run.delay[i, j] + run.delay[j, i])
        if longest < least:
            place, least = i, longest
    x, v = run.place[0, 0], run.speed[0, 0]
    centre, total = np.zeros(steps), 0.0
    spring, brake = np.zeros(count), np.zeros(count)
    for j in range(count):
        other = j if j != place else (place + 1) % count
        spring[j] = run.spring[place, other]
        # Who is at the server's place hears of it a step later, which is 1.5 steps old at the end of the next.
        both = run.delay[place, j] + run.delay[j, place] if j != place else 3.0 * run.T
        brake[j] = 0.5 * spring[j] * both
        total += spring[j]
    run.energy[0] = body_energy(run, x, v)
    run.energy[0] += 0.5 * count * _LIGHT * v * v
    for k in range(steps):
        push, braked = 0.0, 0.0
        for j in range(count):
            known = run.used[place, j, k] if j != place else k - 1
            push += spring[j] * (run.mean[j, known] if known >= 0 else run.place[j, 0])
            braked += brake[j]
        rate = advance(run, x, v, total, braked, push, run.mass, 1.0)
        centre[k] = x + 0.5 * run.T * rate
        x, v = x + run.T * rate, 2.0 * rate - v
        run.energy[k + 1] = body_energy(run, x, v)
        run.lost[k] = run.T * run.damping * rate * rate
        for j in range(count):
            known = run.used[j, place, k] if j != place else k - 1
            here, speed = run.place[j, k], run.speed[j, k]
            stiffness, damping = run.hand_stiffness[j, k] + spring[j], run.hand_damping[j, k] + brake[j]
            push = run.aim[j, k] + spring[j] * (centre[known] if known >= 0 else run.place[j, 0])
            rate = advance(run, here, speed, stiffness, damping, push, _LIGHT, 0.0)
            run.mean[j, k], run.rate[j, k] = here + 0.5 * run.T * rate, rate
            run.place[j, k + 1], run.speed[j, k + 1] = here + run.T * rate, 2.0 * rate - speed
            run.energy[k + 1] += 0.5 * _LIGHT * run.speed[j, k + 1] ** 2


server = Replica(name="server", move=_move, sends=("x̂",), source="Buttolo et al. 1997", springs=True)
