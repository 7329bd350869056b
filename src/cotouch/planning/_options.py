"""What a plan can be asked for, by name: options that other searches hand on."""

from collections.abc import Iterable, Sequence
from typing import Literal, TypedDict

import numpy.typing as npt

from cotouch.network import Convention, Rounding
from cotouch.planning._problem import Lost, Objective
from cotouch.planning._result import SearchMethod


class ProblemOptions(TypedDict, total=False):
    """What is best, and the limits; as `plan` explains them."""

    objective: Objective
    convention: Convention
    time_unit: float
    rounding: Rounding
    require: Iterable[Sequence[int]]
    forbid: Iterable[Sequence[int]]
    max_degree: int | None
    damping_limit: float | None
    drag_limit: float | None
    lost: Lost
    mass: npt.ArrayLike
    damping: npt.ArrayLike
    stiffness: npt.ArrayLike
    sync_damping: npt.ArrayLike | None


class PlanOptions(ProblemOptions, total=False):
    """Likewise, and how it is searched for."""

    begin: Iterable[Sequence[int]]
    top: int
    method: Literal["auto"] | SearchMethod
    limit: int
    starts: int
    seed: int
    jobs: int
    dask: str | None
