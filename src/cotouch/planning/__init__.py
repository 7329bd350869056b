"""Which links to use, and how stiff to make them: by examining every choice, by bounds, or by a search."""

from cotouch.planning._body import modes_of
from cotouch.planning._counts import CountsInterrupted, LinkCounts, plan_counts
from cotouch.planning._deadline import until, worked
from cotouch.planning._early import FirstChoice, first_choice
from cotouch.planning._figures import knee, networks, ranks
from cotouch.planning._joint import FIRST, Joint, JointInterrupted, plan_springs
from cotouch.planning._options import PlanOptions, ProblemOptions
from cotouch.planning._plan import PlanInterrupted, plan
from cotouch.planning._problem import Lost, Objective
from cotouch.planning._ready import compiles
from cotouch.planning._result import Choice, Plan, PlanStatus, SearchMethod, WorstStatus
from cotouch.planning._springs import Tuned, TuningInterrupted, tune_springs
from cotouch.planning._survey import Survey, survey
from cotouch.planning._workers import workers

__all__ = [
    "FIRST",
    "Choice",
    "CountsInterrupted",
    "FirstChoice",
    "Joint",
    "JointInterrupted",
    "LinkCounts",
    "Lost",
    "Objective",
    "Plan",
    "PlanInterrupted",
    "PlanOptions",
    "PlanStatus",
    "ProblemOptions",
    "SearchMethod",
    "Survey",
    "Tuned",
    "TuningInterrupted",
    "WorstStatus",
    "compiles",
    "first_choice",
    "knee",
    "modes_of",
    "networks",
    "plan",
    "plan_counts",
    "plan_springs",
    "ranks",
    "survey",
    "tune_springs",
    "until",
    "worked",
    "workers",
]
