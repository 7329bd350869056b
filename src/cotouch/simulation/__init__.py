"""Many virtual peers on a virtual network: scenario in, labelled result out."""

from cotouch.simulation._animation import Animation, GripTracks, ToolTracks, UserSeries
from cotouch.simulation._figures import figures, save_figures
from cotouch.simulation._metrics import (
    at_times,
    discrepancy,
    felt,
    force_imbalance,
    hold_window,
    settling_time,
    summary,
)
from cotouch.simulation._peers import PeerRun, run_peers
from cotouch.simulation._prepare import Prepared, prepare
from cotouch.simulation._result import dataset, save, simulate
from cotouch.simulation._schedule import Schedule, schedule
from cotouch.simulation._shown import animation, frame_rate
from cotouch.simulation._understood import save_body_figure, understood

__all__ = [
    "Animation",
    "GripTracks",
    "PeerRun",
    "Prepared",
    "Schedule",
    "ToolTracks",
    "UserSeries",
    "animation",
    "at_times",
    "dataset",
    "discrepancy",
    "felt",
    "figures",
    "force_imbalance",
    "frame_rate",
    "hold_window",
    "prepare",
    "run_peers",
    "save",
    "save_body_figure",
    "save_figures",
    "schedule",
    "settling_time",
    "simulate",
    "summary",
    "understood",
]
