"""`pd`: spring and damper to the newest sample; not passive by itself once samples vary or are held."""

from cotouch.laws._end import End
from cotouch.laws._helper import copy
from cotouch.laws._law import Facts, Law, Parameter, Tone, register


def damped_spring(tone: Tone) -> tuple[complex, complex]:
    """`Linear` of a spring and a damper, the first parameter, to what was heard.

    Args:
        tone: at which.
    """
    own = tone.spring / tone.s + tone.parameters[0]
    return own, own * tone.there


def _before(end: End) -> None:
    damping = end.parameters[0]
    copy(end.target, end.sample)
    for i in range(end.push.shape[0]):
        end.push[i] = damping * end.received[0, i]
    end.gains[0], end.gains[1] = end.spring, damping


def _after(end: End) -> None:
    copy(end.sent[0], end.mean)


PD = register(
    Law(
        name="pd",
        before=_before,
        after=_after,
        source="Anderson & Spong 1989, section II",
        parameters=(
            Parameter(
                name="damping", meaning="D, of the damper between the copies [Ns/m]", default=Facts.spring_damping
            ),
        ),
        sends=("v",),
        springs=True,
        linear=damped_spring,
        passive=False,
    )
)
