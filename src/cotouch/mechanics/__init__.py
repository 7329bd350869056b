"""How a body moves, passively: the compiled step and everything it needs."""

from cotouch.mechanics import _matrix3 as matrix3
from cotouch.mechanics._apart import are_apart, move_apart
from cotouch.mechanics._audit import begin_world, follow_world, inner_energy
from cotouch.mechanics._balance_groups import closing_of
from cotouch.mechanics._bounds import beyond, written_here
from cotouch.mechanics._closed import CLOSURE_ALARM, closed_settle, closed_step, slowed
from cotouch.mechanics._contact_conform import conform_contact_law, contact_law_named
from cotouch.mechanics._contact_jammed import jammed_about
from cotouch.mechanics._contact_law import CONTACT_LAWS
from cotouch.mechanics._contact_parts import contact_parts
from cotouch.mechanics._contact_relief import Relief, relief_on
from cotouch.mechanics._contact_step import contact_step
from cotouch.mechanics._contact_stiffening import Stiffening
from cotouch.mechanics._contact_still import press_skin
from cotouch.mechanics._contact_work import Contact, contact_by
from cotouch.mechanics._coupling import (
    checked_virtual_coupling,
    modulate,
    modulation_bound,
    unseen_place,
    virtual_coupling_limit,
)
from cotouch.mechanics._coupling_end import (
    END,
    EndFields,
    EnergyMessage,
    available_energy,
    book_end,
    end_row,
    hear,
    hear_end,
    hold_gap,
    message_of,
    share,
    squared,
)
from cotouch.mechanics._coupling_law import (
    DeviceCoupling,
    HeldForce,
    coupling_at,
    device_couplings,
    register_coupling,
    run_end,
)
from cotouch.mechanics._coupling_pspm import PSPM_COUPLING
from cotouch.mechanics._coupling_virtual import VIRTUAL_COUPLING
from cotouch.mechanics._cutting import Cutting, begin_cut, decide_cuts, expose, hear_cuts, mark_cuts, sever, show_skin
from cotouch.mechanics._cutting_of import cutting_of
from cotouch.mechanics._force import BodyForce
from cotouch.mechanics._kernel import block, inner, kernel, part
from cotouch.mechanics._meeting import Between
from cotouch.mechanics._meeting_force import deepest_between
from cotouch.mechanics._model import Basis, Model, model
from cotouch.mechanics._operator import WEIGHTS, Operator, mixed, multiply, rescaled
from cotouch.mechanics._path import path_place
from cotouch.mechanics._reason import reason
from cotouch.mechanics._rest import REST_DRIFT, REST_FIELDS, place_at_rest, rest_fraction
from cotouch.mechanics._shape import SHAPES, Box, Plane, Plate, Shape, shape_of, shape_table
from cotouch.mechanics._shape_solid import Solid
from cotouch.mechanics._solid import register_solid
from cotouch.mechanics._state import (
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
from cotouch.mechanics._step import settle, step
from cotouch.mechanics._stretch import approach, mixed_stretch, stretches
from cotouch.mechanics._surface import Surface, surface_of
from cotouch.mechanics._toll import checked_toll, encoder_toll, opening_energy
from cotouch.mechanics._tool_bodies import push_of, tell_push, unsettled
from cotouch.mechanics._tools import (
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
from cotouch.mechanics._vector import FOUR, at, load, put, size, splat, store, total, upper, where
from cotouch.mechanics._world import Obstacle, World
from cotouch.mechanics._world_force import deepest_point

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
    "END",
    "EXTRA_LOSS",
    "FOUR",
    "GRASP",
    "ITERATIONS",
    "KINETIC",
    "LEDGER_COLUMNS",
    "LOCAL_LOSS",
    "PROXY",
    "PSPM_COUPLING",
    "REST_DRIFT",
    "REST_FIELDS",
    "SHAPES",
    "SHORTENED",
    "SUPPLIED",
    "TOUCHED",
    "TOUCHING",
    "TOUCH_LEDGER",
    "TOUCH_LOSS",
    "TOUCH_STORED",
    "VIRTUAL_COUPLING",
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
    "DeviceCoupling",
    "EndFields",
    "EnergyMessage",
    "HeldForce",
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
    "at",
    "available_energy",
    "begin_cut",
    "begin_world",
    "beyond",
    "block",
    "book_end",
    "checked_toll",
    "checked_virtual_coupling",
    "closed_settle",
    "closed_step",
    "closing_of",
    "conform_contact_law",
    "contact_by",
    "contact_law_named",
    "contact_parts",
    "contact_step",
    "coupling_at",
    "cutting_of",
    "decide_cuts",
    "deepest_between",
    "deepest_point",
    "device_couplings",
    "encoder_toll",
    "end_row",
    "expose",
    "follow_world",
    "hear",
    "hear_cuts",
    "hear_end",
    "hold_gap",
    "idle_ports",
    "inner",
    "inner_energy",
    "jammed_about",
    "kernel",
    "load",
    "mark_cuts",
    "matrix3",
    "message_of",
    "mixed",
    "mixed_stretch",
    "model",
    "modulate",
    "modulation_bound",
    "move_apart",
    "multiply",
    "opening_energy",
    "own_ports",
    "own_tools",
    "part",
    "path_place",
    "place_at_rest",
    "press_skin",
    "push_of",
    "put",
    "reason",
    "register_coupling",
    "register_solid",
    "relief_on",
    "rescaled",
    "rest_fraction",
    "run_end",
    "settle",
    "sever",
    "shape_of",
    "shape_table",
    "share",
    "show_skin",
    "size",
    "slowed",
    "splat",
    "squared",
    "step",
    "store",
    "stretches",
    "surface_of",
    "tell_push",
    "tools",
    "total",
    "unseen_place",
    "unsettled",
    "upper",
    "virtual_coupling_limit",
    "where",
    "workspace",
    "written_here",
]
