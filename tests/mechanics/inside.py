"""What these tests take from inside the room."""

from cotouch.mechanics import _contact_catch as catching
from cotouch.mechanics._angle import angles
from cotouch.mechanics._balance import ABOUT, HAVE, LEAST, MOST, NOISE, ROUGH, is_rounded
from cotouch.mechanics._breaking import SOLIDS, principal_stress
from cotouch.mechanics._contact_centre import JAMMED
from cotouch.mechanics._contact_foundation import Foundation
from cotouch.mechanics._contact_law import press
from cotouch.mechanics._contact_over import stretch_tool
from cotouch.mechanics._contact_weigh import EASY, is_closed, next_scale
from cotouch.mechanics._coupling import credit
from cotouch.mechanics._crossing import crosses
from cotouch.mechanics._cutting_of import EDGES
from cotouch.mechanics._direction_search import (
    BEST,
    FOUND,
    HOPELESS,
    WORSE,
    Sought,
    begin_search,
    combine_kept,
    judge_look,
    stiffer,
)
from cotouch.mechanics._fit import Fit, box_distance, fit_of, place_vertex, refit
from cotouch.mechanics._foot import foot
from cotouch.mechanics._force import LAWS, evaluate, lean, resist
from cotouch.mechanics._kernel import outlined
from cotouch.mechanics._materials import gradients_of, lame_of
from cotouch.mechanics._nearest import SWEEPS
from cotouch.mechanics._operator import operator_of
from cotouch.mechanics._solve import chebyshev, chebyshev_iterations, conjugate_gradients, invert
from cotouch.mechanics._toll import most_toll
from cotouch.mechanics._tool_walls import walls_of
from cotouch.mechanics._vector import WIDTHS, four, root, transposed
from cotouch.mechanics._world_points import shortened

# Places in what was weighed.
WEIGHED = {"have": HAVE, "about": ABOUT, "noise": NOISE, "rough": ROUGH}

__all__ = [
    "BEST",
    "EASY",
    "EDGES",
    "FOUND",
    "HOPELESS",
    "JAMMED",
    "LAWS",
    "LEAST",
    "MOST",
    "SOLIDS",
    "SWEEPS",
    "WEIGHED",
    "WIDTHS",
    "WORSE",
    "Fit",
    "Foundation",
    "Sought",
    "angles",
    "begin_search",
    "box_distance",
    "catching",
    "chebyshev",
    "chebyshev_iterations",
    "combine_kept",
    "conjugate_gradients",
    "credit",
    "crosses",
    "evaluate",
    "fit_of",
    "foot",
    "four",
    "gradients_of",
    "invert",
    "is_closed",
    "is_rounded",
    "judge_look",
    "lame_of",
    "lean",
    "most_toll",
    "next_scale",
    "operator_of",
    "outlined",
    "place_vertex",
    "press",
    "principal_stress",
    "refit",
    "resist",
    "root",
    "shortened",
    "stiffer",
    "stretch_tool",
    "transposed",
    "walls_of",
]
