"""What a copy's ledger adds up to."""

from dataclasses import fields
from typing import Any

import numpy as np
from tests.members.inside import Totals

from cotouch.peer import StepReport


def test_the_ledger_of_what_falls_is_judged_by_its_motion() -> None:
    """Weight gives just what motion has: of nothing in all, any rounding would be much."""
    nothing: dict[str, Any] = dict.fromkeys((field.name for field in fields(StepReport)), 0.0)
    nothing |= {"link_work": np.zeros(0), "age": np.zeros(0)}
    totals = Totals()
    for n in range(1, 4):
        totals.add(StepReport(**nothing | {"kinetic": 2.0 * n, "elastic": -2.0 * n, "residual": 1e-16 * n}), (), 1e-3)
    assert totals.residual <= 1e-16
    assert totals.alarms == 0
