"""What these tests take from inside the room."""

from cotouch.mechanics._closed._balance import ABOUT, HAVE, LEAST, MOST, NOISE, ROUGH, is_rounded
from cotouch.mechanics._closed._direction_search import (
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
from cotouch.mechanics._contact import _catch as catching
from cotouch.mechanics._contact._centre import JAMMED
from cotouch.mechanics._contact._over import stretch_tool
from cotouch.mechanics._contact._weigh import EASY, is_closed, next_scale
from cotouch.mechanics._contact_laws._foundation import Foundation
from cotouch.mechanics._contact_laws._law import press
from cotouch.mechanics._cutting._crossing import crosses
from cotouch.mechanics._cutting._cutting_of import EDGES
from cotouch.mechanics._linear._operator import operator_of
from cotouch.mechanics._linear._solve import chebyshev, chebyshev_iterations, conjugate_gradients, invert
from cotouch.mechanics._materials._arrays import gradients_of, lame_of
from cotouch.mechanics._materials._breaking import SOLIDS, principal_stress
from cotouch.mechanics._materials._force import LAWS, evaluate, lean, resist
from cotouch.mechanics._materials._nearest import SWEEPS
from cotouch.mechanics._materials._tetrahedra import SOLIDS as SOLID_LAWS
from cotouch.mechanics._meeting._foot import foot
from cotouch.mechanics._meeting._tool_walls import walls_of
from cotouch.mechanics._meeting._world_points import shortened
from cotouch.mechanics._model._fit import Fit, box_distance, fit_of, place_vertex, refit

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
    "SOLID_LAWS",
    "SWEEPS",
    "WEIGHED",
    "WORSE",
    "Fit",
    "Foundation",
    "Sought",
    "begin_search",
    "box_distance",
    "catching",
    "chebyshev",
    "chebyshev_iterations",
    "combine_kept",
    "conjugate_gradients",
    "crosses",
    "evaluate",
    "fit_of",
    "foot",
    "gradients_of",
    "invert",
    "is_closed",
    "is_rounded",
    "judge_look",
    "lame_of",
    "lean",
    "next_scale",
    "operator_of",
    "place_vertex",
    "press",
    "principal_stress",
    "refit",
    "resist",
    "shortened",
    "stiffer",
    "stretch_tool",
    "walls_of",
]
