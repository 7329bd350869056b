"""Link laws: what one end of a link does in a step. Each is one file; a new one needs a file and `register`."""

# Without it, the first call of a `CompiledHalf` in a process fails.
import numba.experimental.function_type  # noqa: F401  # pyright: ignore[reportUnusedImport, reportMissingTypeStubs]

from cotouch.laws._end import END_WORDS, BoundEnd, CompiledHalf, End, call, hand, handed
from cotouch.laws._helper import brake, copy, feel, given_power, square
from cotouch.laws._law import FORCE, Facts, Law, Linear, Parameter, Tone, law_named, laws, register
from cotouch.laws._once import ONCE
from cotouch.laws._origin_force import OriginForce
from cotouch.laws._paid import PAID
from cotouch.laws._pd import PD
from cotouch.laws._pspm import PSPM
from cotouch.laws._spring import SPRING
from cotouch.laws._tank import TANK
from cotouch.laws._tdpa import TDPA
from cotouch.laws._wave import WAVE

__all__ = [
    "END_WORDS",
    "FORCE",
    "ONCE",
    "PAID",
    "PD",
    "PSPM",
    "SPRING",
    "TANK",
    "TDPA",
    "WAVE",
    "BoundEnd",
    "CompiledHalf",
    "End",
    "Facts",
    "Law",
    "Linear",
    "OriginForce",
    "Parameter",
    "Tone",
    "brake",
    "call",
    "copy",
    "feel",
    "given_power",
    "hand",
    "handed",
    "law_named",
    "laws",
    "register",
    "square",
]
