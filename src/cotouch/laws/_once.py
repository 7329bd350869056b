"""`once`: spring and damper, where each velocity of the neighbour is used once.

The damper is passive alone, whatever the network does: a velocity is used at most once, and then it brings no more than
`½D T_j‖ṽ‖²`, which its sender's own end has dissipated. What it leaves over pays for most of the spring, so the local
damping is a small share of the rule's.
"""

from collections.abc import Sequence
from math import sqrt

from cotouch.laws._end import End
from cotouch.laws._helper import copy
from cotouch.laws._law import Facts, Law, Parameter, register
from cotouch.laws._pd import damped_spring


def _before(end: End) -> None:
    damping = end.parameters[0]
    copy(end.target, end.sample)
    fraction = 0.0
    if end.new:
        T = end.received_scalars[0]
        fraction = damping * (sqrt(T / end.T) if end.T > T else 1.0)
    for i in range(end.push.shape[0]):
        end.push[i] = fraction * end.received[0, i]
    end.gains[0], end.gains[1] = end.spring, damping


def _after(end: End) -> None:
    copy(end.sent[0], end.mean)
    end.sent_scalars[0] = end.T


def _damping(facts: Facts) -> float:
    return 0.5 * facts.spring_damping()


def _holds(facts: Facts, parameters: Sequence[float]) -> bool:
    """A weaker damper would need a larger share of the rule."""
    return parameters[0] >= _damping(facts) * (1.0 - 1e-9)


ONCE = register(
    Law(
        name="once",
        before=_before,
        after=_after,
        source="docs/laws.md",
        parameters=(Parameter(name="damping", meaning="D, of the damper between the copies [Ns/m]", default=_damping),),
        sends=("v",),
        sends_scalars=("T",),
        length="T",
        springs=True,
        linear=damped_spring,
        holds=_holds,
        rule=0.163,  # the least for two users at constant delay and this D; enough under jitter, loss and outages
    )
)
