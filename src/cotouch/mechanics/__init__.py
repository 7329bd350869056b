"""How a body moves, passively: the compiled step and everything it needs."""

from cotouch.mechanics._closed._audit import begin_world, follow_world, inner_energy
from cotouch.mechanics._closed._balance_groups import closing_of
from cotouch.mechanics._closed._step import CLOSURE_ALARM, closed_settle, closed_step, slowed
from cotouch.mechanics._contact._apart import are_apart, move_apart
from cotouch.mechanics._contact._jammed import jammed_about
from cotouch.mechanics._contact._parts import contact_parts
from cotouch.mechanics._contact._step import contact_step
from cotouch.mechanics._contact._still import press_skin
from cotouch.mechanics._contact._work import Contact, contact_by
from cotouch.mechanics._contact_laws._conform import conform_contact_law, contact_law_named
from cotouch.mechanics._contact_laws._law import CONTACT_LAWS
from cotouch.mechanics._contact_laws._stiffening import Stiffening
from cotouch.mechanics._cutting._cut import (
    Cutting,
    begin_cut,
    decide_cuts,
    expose,
    hear_cuts,
    mark_cuts,
    sever,
    show_skin,
)
from cotouch.mechanics._cutting._cutting_of import cutting_of
from cotouch.mechanics._linear._operator import WEIGHTS, Operator, mixed, multiply, rescaled
from cotouch.mechanics._linear._state import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    CUT,
    CUT_COUNT,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LEDGER_COLUMNS,
    LOCAL_LOSS,
    SHORTENED,
    SUPPLIED,
    WORLD_FORCE,
    WORLD_LOSS,
    WORLD_STORED,
    Links,
    Ports,
    State,
    Workspace,
    idle_ports,
    own_ports,
    workspace,
)
from cotouch.mechanics._linear._step import settle, step
from cotouch.mechanics._linear._stretch import approach, mixed_stretch, stretches
from cotouch.mechanics._materials._force import BodyForce
from cotouch.mechanics._materials._solid import register_solid
from cotouch.mechanics._meeting._bodies import Between
from cotouch.mechanics._meeting._force import deepest_between
from cotouch.mechanics._meeting._tool_bodies import tell_push
from cotouch.mechanics._meeting._world import Obstacle, World
from cotouch.mechanics._meeting._world_force import deepest_point
from cotouch.mechanics._model._model import Basis, Model, model
from cotouch.mechanics._model._relief import Relief, relief_on
from cotouch.mechanics._model._surface import Surface, surface_of
from cotouch.mechanics._model._tool_marks import push_of, unsettled
from cotouch.mechanics._model._tools import (
    AWAY,
    BLADE,
    DRIVE,
    GRASP,
    PROXY,
    TOUCH_LEDGER,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    TOUCHING,
    Tools,
    own_tools,
    tools,
)
from cotouch.mechanics._shapes._shape import SHAPES, Box, Plane, Plate, Shape, shape_of, shape_table
from cotouch.mechanics._shapes._solid import Solid

__all__ = [
    "AWAY",
    "BETA",
    "BLADE",
    "BODY_LOSS",
    "CLOSURE",
    "CLOSURE_ALARM",
    "CONTACT_LAWS",
    "CUT",
    "CUT_COUNT",
    "DRIVE",
    "ELASTIC",
    "EXTRA_LOSS",
    "GRASP",
    "ITERATIONS",
    "KINETIC",
    "LEDGER_COLUMNS",
    "LOCAL_LOSS",
    "PROXY",
    "SHAPES",
    "SHORTENED",
    "SUPPLIED",
    "TOUCHED",
    "TOUCHING",
    "TOUCH_LEDGER",
    "TOUCH_LOSS",
    "TOUCH_STORED",
    "WEIGHTS",
    "WORLD_FORCE",
    "WORLD_LOSS",
    "WORLD_STORED",
    "Basis",
    "Between",
    "BodyForce",
    "Box",
    "Contact",
    "Cutting",
    "Links",
    "Model",
    "Obstacle",
    "Operator",
    "Plane",
    "Plate",
    "Ports",
    "Relief",
    "Shape",
    "Solid",
    "State",
    "Stiffening",
    "Surface",
    "Tools",
    "Workspace",
    "World",
    "approach",
    "are_apart",
    "begin_cut",
    "begin_world",
    "closed_settle",
    "closed_step",
    "closing_of",
    "conform_contact_law",
    "contact_by",
    "contact_law_named",
    "contact_parts",
    "contact_step",
    "cutting_of",
    "decide_cuts",
    "deepest_between",
    "deepest_point",
    "expose",
    "follow_world",
    "hear_cuts",
    "idle_ports",
    "inner_energy",
    "jammed_about",
    "mark_cuts",
    "mixed",
    "mixed_stretch",
    "model",
    "move_apart",
    "multiply",
    "own_ports",
    "own_tools",
    "press_skin",
    "push_of",
    "register_solid",
    "relief_on",
    "rescaled",
    "settle",
    "sever",
    "shape_of",
    "shape_table",
    "show_skin",
    "slowed",
    "step",
    "stretches",
    "surface_of",
    "tell_push",
    "tools",
    "unsettled",
    "workspace",
]
