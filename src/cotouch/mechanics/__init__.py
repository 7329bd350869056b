"""How a body moves, passively: the compiled step and what it needs."""

from cotouch.mechanics._coupling import (
    checked_virtual_coupling,
    credit,
    modulate,
    modulation_bound,
    virtual_coupling_limit,
)
from cotouch.mechanics._kernel import block, inner, kernel
from cotouch.mechanics._model import Basis, Model, model
from cotouch.mechanics._operator import WEIGHTS, Operator, mixed, multiply
from cotouch.mechanics._step import (
    BODY_LOSS,
    BOOKS,
    ELASTIC,
    EXTRA_LOSS,
    ITERATIONS,
    KINETIC,
    LOCAL_LOSS,
    SUPPLIED,
    Grips,
    Links,
    State,
    Workspace,
    settle,
    step,
    workspace,
)
from cotouch.mechanics._vector import at, load, put, splat, store, total

__all__ = [
    "BODY_LOSS",
    "BOOKS",
    "ELASTIC",
    "EXTRA_LOSS",
    "ITERATIONS",
    "KINETIC",
    "LOCAL_LOSS",
    "SUPPLIED",
    "WEIGHTS",
    "Basis",
    "Grips",
    "Links",
    "Model",
    "Operator",
    "State",
    "Workspace",
    "at",
    "block",
    "checked_virtual_coupling",
    "credit",
    "inner",
    "kernel",
    "load",
    "mixed",
    "model",
    "modulate",
    "modulation_bound",
    "multiply",
    "put",
    "settle",
    "splat",
    "step",
    "store",
    "total",
    "virtual_coupling_limit",
    "workspace",
]
