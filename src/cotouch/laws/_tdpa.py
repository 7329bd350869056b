"""`tdpa`: position to one end, force to the other, each port as far as the other's energy pays.

The end of the user with the lower number has the spring; a step of its set position may give no more energy than the
other end has taken in. The other end gets the spring's force, with a damper that bounds its work in the coming step by
what the spring's end has taken in: instead of an observer that finds out a step too late.
[Hannaford & Ryu 2002; Ryu, Artigas & Preusche 2010]
"""

from math import inf, sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import brake, copy, given_power, move_set, square
from cotouch.laws._law import FORCE, Law, Parameter, register


def _before(end: End) -> None:
    energy, hold = end.scalars, end.memory[0]  # E_in, E_out; the set position
    most = max(end.received_scalars[0] + end.parameters[0] - energy[1], 0.0)
    force = end.parameters[3]
    if end.side == 1:
        for i in range(end.push.shape[0]):
            end.push[i] = -end.received[0, i]
        size = sqrt(square(end.weight, end.push))
        if size > force:
            for i in range(end.push.shape[0]):
                end.push[i] *= force / size
        brake(end, most, end.parameters[1], end.parameters[2])
        return
    if end.step == 0:
        copy(hold, end.position)
    if end.sample_index >= 0:
        held, holds = move_set(end, hold, most, force)
        step = holds - held
        energy[0] += max(-step, 0.0)
        energy[1] += max(step, 0.0)
    copy(end.target, hold)
    end.gains[0] = end.spring


def _after(end: End) -> None:
    energy = end.scalars
    if end.side == 1:
        work = end.T * given_power(end)
        energy[0] += max(-work, 0.0)
        energy[1] += max(work, 0.0)
    for i in range(end.mean.shape[0]):
        middle = end.position[i] - 0.5 * end.T * end.mean[i]
        end.sent[0, i] = end.spring * (end.memory[0, i] - middle) if end.side == 0 else 0.0
    end.sent_scalars[0] = energy[0]


TDPA = register(
    Law(
        name="tdpa",
        before=_before,
        after=_after,
        source="Hannaford & Ryu 2002; Ryu, Artigas & Preusche 2010",
        parameters=(
            Parameter(
                name="initial_energy",
                meaning="energy that an end may give before it has received any [J]",
                default=0.05,
            ),
            Parameter(name="damping", meaning="β₀, always on at the end that receives the force [Ns/m]", default=1.0),
            Parameter(name="most", meaning="greatest damper there [Ns/m]", default=100.0),
            Parameter(name=FORCE, meaning="largest force with which a neighbour may push or pull [N]", default=inf),
        ),
        sends=("F",),
        sends_scalars=("E_in",),
        keeps=("set",),
        keeps_scalars=("E_in", "E_out"),
        initial_energy="initial_energy",
        energies=("E_in",),
    )
)
