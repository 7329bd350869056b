"""`spring`: a spring to the newest sample, made passive by local damping [Lee & Huang 2010; the age rule]."""

from cotouch.laws._end import End
from cotouch.laws._helper import copy
from cotouch.laws._law import Law, Tone, register


def _before(end: End) -> None:
    copy(end.target, end.sample)
    end.gains[0] = end.spring


def _after(end: End) -> None:
    pass


def _linear(tone: Tone) -> tuple[complex, complex]:
    return tone.spring / tone.s, tone.spring / tone.s * tone.there


SPRING = register(
    Law(name="spring", before=_before, after=_after, rule=1.0, springs=True, linear=_linear, source="Lee & Huang 2010")
)
