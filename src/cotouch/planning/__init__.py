"""Which links to use, and how stiff to make them: every choice, a proof by bounds, or the best found in time."""

from cotouch.planning._body import modes_of
from cotouch.planning._figures import knee, networks, ranks
from cotouch.planning._plan import Progress, compiles, plan
from cotouch.planning._problem import Objective
from cotouch.planning._result import Choice, Method, Plan, Status, WorstStatus
from cotouch.planning._springs import Tuned, tune_springs
from cotouch.planning._survey import Survey, survey

__all__ = [
    "Choice",
    "Method",
    "Objective",
    "Plan",
    "Progress",
    "Status",
    "Survey",
    "Tuned",
    "WorstStatus",
    "compiles",
    "knee",
    "modes_of",
    "networks",
    "plan",
    "ranks",
    "survey",
    "tune_springs",
]
