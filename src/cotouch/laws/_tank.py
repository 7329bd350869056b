"""`tank`: any wished force, here spring and damper, paid from a tank that a damper fills.

The force is held with a damper that bounds its work in the coming step by what the tank holds, so the tank is never
below zero. What is above its level goes to the other end. [Franken, Stramigioli, Misra, Secchi & Macchelli 2011]
"""

from math import inf, sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import brake, copy, given_power, square
from cotouch.laws._law import FORCE, Facts, Law, Parameter, register

_TANK, _GIVEN, _CREDITED = range(3)


def _before(end: End) -> None:
    level, damping, recharge, most = end.parameters[0], end.parameters[1], end.parameters[2], end.parameters[3]
    tank = end.scalars
    if end.step == 0:
        tank[_TANK] = level
    tank[_TANK] += max(end.received_scalars[0] - tank[_CREDITED], 0.0)
    tank[_CREDITED] = max(tank[_CREDITED], end.received_scalars[0])
    for i in range(end.push.shape[0]):
        pull = end.spring * (end.sample[i] - end.position[i]) + damping * (end.received[0, i] - end.velocity[i])
        end.push[i] = pull if end.sample_index >= 0 else 0.0
    size, force = sqrt(square(end.weight, end.push)), end.parameters[4]
    if size > force:
        for i in range(end.push.shape[0]):
            end.push[i] *= force / size
    short = max(1.0 - tank[_TANK] / level, 0.0)
    brake(end, max(tank[_TANK], 0.0), recharge * short, max(most, recharge))


def _after(end: End) -> None:
    level, tank = end.parameters[0], end.scalars
    tank[_TANK] -= end.T * given_power(end)
    more = max(tank[_TANK] - level, 0.0)
    tank[_TANK] -= more
    tank[_GIVEN] += more
    copy(end.sent[0], end.mean)
    end.sent_scalars[0] = tank[_GIVEN]


TANK = register(
    Law(
        name="tank",
        before=_before,
        after=_after,
        source="Franken et al. 2011",
        parameters=(
            Parameter(
                name="initial_energy",
                meaning="energy that the tank starts with, and its level [J]",
                default=0.05,
                least=1e-9,
            ),
            Parameter(name="damping", meaning="D of the desired force [Ns/m]", default=Facts.spring_damping),
            Parameter(name="recharge", meaning="damper that fills an empty tank [Ns/m]", default=10.0),
            Parameter(name="most", meaning="greatest damper [Ns/m]", default=100.0),
            Parameter(name=FORCE, meaning="largest force with which a neighbour may push [N]", default=inf),
        ),
        sends=("v",),
        sends_scalars=("given",),
        keeps_scalars=("tank", "given", "credited"),
        initial_energy="initial_energy",
        energies=("given",),
    )
)
