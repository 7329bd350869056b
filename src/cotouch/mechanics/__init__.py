"""How a body moves, passively: the compiled step and what it needs."""

from cotouch.mechanics._closed import CLOSURE_ALARM, closed_settle, closed_step
from cotouch.mechanics._contact_foundation import Foundation
from cotouch.mechanics._contact_law import CONTACT_LAWS, press
from cotouch.mechanics._contact_patch import press_skin
from cotouch.mechanics._contact_step import contact_step
from cotouch.mechanics._contact_stiffening import Stiffening
from cotouch.mechanics._contact_work import Contact, contact_by
from cotouch.mechanics._coupling import (
    checked_virtual_coupling,
    credit,
    modulate,
    modulation_bound,
    unseen_place,
    virtual_coupling_limit,
)
from cotouch.mechanics._force import LAWS, BodyForce, evaluate, resist
from cotouch.mechanics._kernel import block, inner, kernel, part
from cotouch.mechanics._model import Basis, Model, model
from cotouch.mechanics._operator import WEIGHTS, Operator, mixed, multiply, rescaled
from cotouch.mechanics._rest import REST_DRIFT, REST_FIELDS, place_at_rest, rest_fraction
from cotouch.mechanics._state import (
    BETA,
    BODY_LOSS,
    CLOSURE,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LEDGER_COLUMNS,
    LOCAL_LOSS,
    SHORTENED,
    SUPPLIED,
    Links,
    Ports,
    State,
    Workspace,
    workspace,
)
from cotouch.mechanics._step import settle, step
from cotouch.mechanics._stretch import approach, mixed_stretch, stretches
from cotouch.mechanics._surface import Surface, surface_of
from cotouch.mechanics._tools import (
    AWAY,
    DRIVE,
    GRASP,
    MOST_CONTACTS,
    MOST_HELD,
    PROXY,
    TOUCH,
    TOUCH_LEDGER,
    TOUCH_LOSS,
    TOUCH_STORED,
    TOUCHED,
    Tools,
    TouchWork,
    tools,
    touch_work,
)
from cotouch.mechanics._touch import touch_step
from cotouch.mechanics._touch_parts import touch_parts
from cotouch.mechanics._vector import at, load, put, splat, store, total

__all__ = [
    "AWAY",
    "BETA",
    "BODY_LOSS",
    "CLOSURE",
    "CLOSURE_ALARM",
    "CONTACT_LAWS",
    "DRIVE",
    "ELASTIC",
    "EXTRA_LOSS",
    "GRASP",
    "ITERATIONS",
    "KINETIC",
    "LAWS",
    "LEDGER_COLUMNS",
    "LOCAL_LOSS",
    "MOST_CONTACTS",
    "MOST_HELD",
    "PROXY",
    "REST_DRIFT",
    "REST_FIELDS",
    "SHORTENED",
    "SUPPLIED",
    "TOUCH",
    "TOUCHED",
    "TOUCH_LEDGER",
    "TOUCH_LOSS",
    "TOUCH_STORED",
    "WEIGHTS",
    "Basis",
    "BodyForce",
    "Contact",
    "Foundation",
    "Links",
    "Model",
    "Operator",
    "Ports",
    "State",
    "Stiffening",
    "Surface",
    "Tools",
    "TouchWork",
    "Workspace",
    "approach",
    "at",
    "block",
    "checked_virtual_coupling",
    "closed_settle",
    "closed_step",
    "contact_by",
    "contact_step",
    "credit",
    "evaluate",
    "inner",
    "kernel",
    "load",
    "mixed",
    "mixed_stretch",
    "model",
    "modulate",
    "modulation_bound",
    "multiply",
    "part",
    "place_at_rest",
    "press",
    "press_skin",
    "put",
    "rescaled",
    "resist",
    "rest_fraction",
    "settle",
    "splat",
    "step",
    "store",
    "stretches",
    "surface_of",
    "tools",
    "total",
    "touch_parts",
    "touch_step",
    "touch_work",
    "unseen_place",
    "virtual_coupling_limit",
    "workspace",
]
