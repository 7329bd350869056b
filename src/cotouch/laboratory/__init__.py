"""Questions asked of many runs: what a hand feels, what happens where an option varies, and which law is best."""

from cotouch.laboratory._cells import Progress
from cotouch.laboratory._compare import compare
from cotouch.laboratory._compare_report import write_report
from cotouch.laboratory._feel_figure import impedance_figure
from cotouch.laboratory._impedance import Others, impedance
from cotouch.laboratory._noticed import mean_cost
from cotouch.laboratory._score import MEASURES
from cotouch.laboratory._study import Study
from cotouch.laboratory._sweep import FIGURES, sweep, values_of, varied
from cotouch.laboratory._trials import Books, Found, books, searched, touching, trial

__all__ = [
    "FIGURES",
    "MEASURES",
    "Books",
    "Found",
    "Others",
    "Progress",
    "Study",
    "books",
    "compare",
    "impedance",
    "impedance_figure",
    "mean_cost",
    "searched",
    "sweep",
    "touching",
    "trial",
    "values_of",
    "varied",
    "write_report",
]
