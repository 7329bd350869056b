"""What `cotouch simulate` says of steps that had to be closed."""

import numpy as np
import xarray as xr
from rich.console import Console
from rich.table import Table

from cotouch.cli._simulate import Closure, _closure, closure_of


def shown(factor: float, alarms: int) -> tuple[Closure | None, str]:
    steps = ("user", "step")
    run = xr.Dataset(
        {
            "closure": (steps, np.array([[0.0, 2e-3, 1e-3], [0.0, 0.0, -4e-3]])),
            "closure_factor": (steps, np.array([[0.0, factor, factor], [0.0, 0.0, 0.0]])),
            "closure_alarms": (steps, np.array([[0.0, alarms, alarms], [0.0, 0.0, 0.0]])),
        }
    )
    figures, console = closure_of(run), Console(width=200)
    grid = Table.grid()
    _closure(figures, grid)
    with console.capture() as text:
        console.print(grid)
    return figures, text.get()


def test_a_large_closure_is_told() -> None:
    figures, text = shown(0.05, 7)
    assert figures == {"work_j": [2e-3, 4e-3], "largest_factor": 0.05, "alarms": 7}
    assert "by at most 5.0e-02; 7 steps by more than 1 %" in text


def test_a_small_one_is_said_without_a_word_more() -> None:
    assert shown(1e-5, 0)[1].strip().endswith("by at most 1.0e-05")


def test_a_linear_body_has_none() -> None:
    assert closure_of(xr.Dataset()) is None
