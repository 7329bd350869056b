"""Which links to use: every choice, a proof by bounds, or the best that can be found in time."""

from cotouch.planning._plan import Progress, plan
from cotouch.planning._problem import Objective
from cotouch.planning._result import Choice, Method, Plan, Status
from cotouch.planning._survey import Survey, survey

__all__ = ["Choice", "Method", "Objective", "Plan", "Progress", "Status", "Survey", "plan", "survey"]
