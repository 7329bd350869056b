"""`pspm`: passive set-position modulation; each end follows as far as its own tank pays [Lee & Huang 2010].

It is what a guarded link does that never couples: see `cotouch.peer.LinkGuard`.
"""

from math import inf

from cotouch.laws._end import End
from cotouch.laws._helper import copy, move_set, square
from cotouch.laws._law import FORCE, Facts, Law, Parameter, register

_TANK, _GIVEN, _CREDITED = range(3)


def _before(end: End) -> None:
    hold, tank = end.memory[0], end.scalars
    if end.step == 0:
        copy(hold, end.position)
        tank[_TANK] = end.parameters[0]
    tank[_TANK] += max(end.received_scalars[0] - tank[_CREDITED], 0.0)
    tank[_CREDITED] = max(tank[_CREDITED], end.received_scalars[0])
    if end.sample_index >= 0:
        spare = max(tank[_TANK], 0.0)
        held, holds = move_set(end, hold, spare, end.parameters[2])
        tank[_TANK] = held + spare - holds
    copy(end.target, hold)
    end.gains[0], end.gains[1] = end.spring, end.parameters[1]


def _after(end: End) -> None:
    tank = end.scalars
    tank[_TANK] += end.T * end.parameters[1] * square(end.weight, end.mean)
    more = max(tank[_TANK] - end.parameters[0], 0.0)
    tank[_TANK] -= more
    tank[_GIVEN] += more
    end.sent_scalars[0] = tank[_GIVEN]


PSPM = register(
    Law(
        name="pspm",
        before=_before,
        after=_after,
        source="Lee & Huang 2010, passive set-position modulation",
        parameters=(
            Parameter(
                name="initial_energy", meaning="energy that the tank starts with, and keeps at most [J]", default=0.05
            ),
            Parameter(name="damping", meaning="damper that fills the tank [Ns/m]", default=Facts.spring_damping),
            Parameter(name=FORCE, meaning="largest force with which a neighbour may pull [N]", default=inf),
        ),
        sends_scalars=("given",),
        keeps=("set",),
        keeps_scalars=("tank", "given", "credited"),
        initial_energy="initial_energy",
        energies=("given",),
    )
)
