"""What these tests take from inside the room: nothing else here imports its private modules."""

from cotouch.planning import _local as local
from cotouch.planning import _ready as ready
from cotouch.planning import _referral as referral
from cotouch.planning._deadline import aside, in_real_time
from cotouch.planning._enumerate import unrank
from cotouch.planning._flood import Front, flood
from cotouch.planning._hubs import about, central, hubs
from cotouch.planning._judge import between, hopeless, pulls
from cotouch.planning._levels import holds, level_of
from cotouch.planning._problem import make_problem
from cotouch.planning._relaxation import bound_of
from cotouch.planning._spring_search import Search
from cotouch.planning._starts import begun_at, random_choice, side_by_side, start_of
from cotouch.planning._task import admissible, period_of, rate
from cotouch.planning._workers import Cluster

__all__ = [
    "Cluster",
    "Front",
    "Search",
    "about",
    "admissible",
    "aside",
    "begun_at",
    "between",
    "bound_of",
    "central",
    "flood",
    "holds",
    "hopeless",
    "hubs",
    "in_real_time",
    "level_of",
    "local",
    "make_problem",
    "period_of",
    "pulls",
    "random_choice",
    "rate",
    "ready",
    "referral",
    "side_by_side",
    "start_of",
    "unrank",
]
