"""What these tests take from inside the room."""

from cotouch.mechanics import _contact_catch as catching
from cotouch.mechanics._angle import angles
from cotouch.mechanics._breaking import SOLIDS, principal_stress
from cotouch.mechanics._contact_centre import JAMMED
from cotouch.mechanics._contact_over import stretch_tool
from cotouch.mechanics._crossing import crosses
from cotouch.mechanics._cutting_of import EDGES
from cotouch.mechanics._materials import gradients_of, lame_of
from cotouch.mechanics._meeting_near import foot
from cotouch.mechanics._nearest import SWEEPS
from cotouch.mechanics._operator import operator_of
from cotouch.mechanics._solve import chebyshev, chebyshev_iterations, conjugate_gradients, invert
from cotouch.mechanics._surface import Fit, box_distance, fit_of, place_vertex, refit
from cotouch.mechanics._tool_walls import walls_of
from cotouch.mechanics._vector import WIDTHS, four, root, transposed
from cotouch.mechanics._world_points import shortened

__all__ = [
    "EDGES",
    "JAMMED",
    "SOLIDS",
    "SWEEPS",
    "WIDTHS",
    "Fit",
    "angles",
    "box_distance",
    "catching",
    "chebyshev",
    "chebyshev_iterations",
    "conjugate_gradients",
    "crosses",
    "fit_of",
    "foot",
    "four",
    "gradients_of",
    "invert",
    "lame_of",
    "operator_of",
    "place_vertex",
    "principal_stress",
    "refit",
    "root",
    "shortened",
    "stretch_tool",
    "transposed",
    "walls_of",
]
