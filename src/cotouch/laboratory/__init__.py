"""Experiments over many runs: what a hand feels, how an option matters, and which law is best."""

from cotouch.laboratory._compare import compare
from cotouch.laboratory._compare_report import write_report
from cotouch.laboratory._feel_figure import impedance_figure
from cotouch.laboratory._ideal import Ideal, ideal
from cotouch.laboratory._impedance import Others, impedance
from cotouch.laboratory._noticed import broken, mean_cost
from cotouch.laboratory._quality import etvo, hpw_psnr, psnr
from cotouch.laboratory._score import MEASURES, measures_of
from cotouch.laboratory._study import Study
from cotouch.laboratory._sweep import SWEPT, sweep, values_of, varied
from cotouch.laboratory._trials import Found, MadeEnergy, made_energy, searched, touching, trial

__all__ = [
    "MEASURES",
    "SWEPT",
    "Found",
    "Ideal",
    "MadeEnergy",
    "Others",
    "Study",
    "broken",
    "compare",
    "etvo",
    "hpw_psnr",
    "ideal",
    "impedance",
    "impedance_figure",
    "made_energy",
    "mean_cost",
    "measures_of",
    "psnr",
    "searched",
    "sweep",
    "touching",
    "trial",
    "values_of",
    "varied",
    "write_report",
]
